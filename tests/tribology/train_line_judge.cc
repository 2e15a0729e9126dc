// SPDX-License-Identifier: LGPL-2.1-or-later

// Fits the numbers of LineJudge to images with masks as they are and through
// other cameras, to made specimens and to drawn scenes of straight cracks and
// grooves. No test: arguments are the
// folder of the images (SQUEAL_CRACK_IMAGES) and the table to write,
//
//   train_line_judge FOLDER tribology/source/images/line_judge_table.cc
//
// With the word "leave-one-out" instead of a table nothing is written, but each
// specimen is scored with a judge that has not seen it.
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/segmentation.h>
#include <squeal/tribology/images/specimen.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <set>

#include "tribology/camera_views.h"
#include "tribology/line_score.h"
#include "tribology/straight_scenes.h"

using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr double narrow_filters = 0.7;
  constexpr double on_crack       = 3.;   // pixels from the true line
  constexpr double ridge_penalty  = 3.;   // of the squares of the weights
  constexpr double rest           = 0.02; // of all lines, beside true ones
  constexpr int    shortest       = 4;    // pixels, of a line that teaches
  constexpr double made_weight    = 0.5;  // of an image that is made

  /** An image to learn from. */
  struct Lesson
  {
    Lesson(const std::string &name,
           const std::string &specimen,
           const cv::Mat     &grey,
           const cv::Mat     &mask,
           const double       weight,
           const double       scale = 1.)
      : name(name)
      , specimen(specimen)
      , grey(grey)
      , mask(mask)
      , ridges(filter_ridges(grey, 2, narrow_filters))
      , lines(grey, ridges, LineJudge())
    {
      cv::Mat1f     distance(grey.size(), 1e3F);
      const cv::Mat line = thin(mask >= 200);
      if (cv::countNonZero(line) > 0)
        cv::distanceTransform(~line, distance, cv::DIST_L2, 5);
      double all = 0., good = 0.;
      for (const PixelPath &core : lines.cores)
        {
          double near = 0., ignored = 0.;
          for (const cv::Point &p : core)
            {
              const uchar m = mask.at<uchar>(p);
              near += distance(p) <= scale * on_crack;
              ignored += m > 100 && m < 200;
            }
          const double n = double(core.size());
          is_crack.push_back(2. * near > n);
          weights.push_back(
            int(core.size()) < shortest || 2. * ignored > n ? 0. : n);
          all += n;
          good += is_crack.back() ? n : 0.;
        }
      for (double &w : weights)
        w *= weight / (good + rest * all);
    }

    std::string         name, specimen;
    cv::Mat             grey, mask;
    RidgeField          ridges;
    JudgedLines         lines;
    std::vector<char>   is_crack;
    std::vector<double> weights;
  };
  using Lessons = std::vector<std::unique_ptr<Lesson>>;



  /** Logistic regression by Newton's method, squares of weights penalised. */
  template <int n>
  LogOdds<n>
  fit(const Lessons &lessons, const std::set<std::string> &without)
  {
    LogOdds<n> odds;
    double     total = 0.;
    const auto each  = [&](const auto &action) {
      for (const auto &lesson : lessons)
        if (without.count(lesson->specimen) == 0)
          for (std::size_t i = 0; i < lesson->weights.size(); ++i)
            if (lesson->weights[i] > 0.)
              action(lesson->lines.features[i],
                     bool(lesson->is_crack[i]),
                     lesson->weights[i]);
    };
    int count = 0;
    each([&](const auto &f, bool, const double w) {
      for (int k = 0; k < n; ++k)
        odds.mean[k] += w * f[k];
      total += w;
      ++count;
    });
    for (double &m : odds.mean)
      m /= total;
    each([&](const auto &f, bool, const double w) {
      for (int k = 0; k < n; ++k)
        odds.deviation[k] += w / total * std::pow(f[k] - odds.mean[k], 2);
    });
    for (double &d : odds.deviation)
      d = std::sqrt(d) + 1e-9;
    for (int iteration = 0; iteration < 12; ++iteration)
      {
        cv::Mat1d normal = cv::Mat1d::eye(n + 1, n + 1) * ridge_penalty;
        normal(n, n)     = 1e-9;
        cv::Mat1d right(n + 1, 1, 0.);
        for (int k = 0; k < n; ++k)
          right(k) = -ridge_penalty * odds.weight[k];
        each([&](const auto &f, const bool is_crack, const double w0) {
          double u[n + 1], sum = odds.offset;
          u[n] = 1.;
          for (int k = 0; k < n; ++k)
            {
              u[k] =
                std::clamp((f[k] - odds.mean[k]) / odds.deviation[k], -3., 3.);
              sum += odds.weight[k] * u[k];
            }
          // As if there were as many observations as lines.
          const double w = w0 * count / total;
          const double p = 1. / (1. + std::exp(-sum));
          for (int a = 0; a <= n; ++a)
            {
              right(a) += w * u[a] * (is_crack - p);
              for (int b = 0; b <= a; ++b)
                normal(a, b) += w * p * (1. - p) * u[a] * u[b];
            }
        });
        cv::completeSymm(normal, true);
        cv::Mat1d step;
        cv::solve(normal, right, step, cv::DECOMP_CHOLESKY);
        for (int k = 0; k < n; ++k)
          odds.weight[k] += step(k);
        odds.offset += step(n);
      }
    return odds;
  }



  LineJudge
  learn(const Lessons &lessons, const std::set<std::string> &without = {})
  {
    LineJudge judge;
    judge.in_context.deviation.fill(1.);
    judge.alone = fit<n_line_features>(lessons, without);
    for (const auto &lesson : lessons)
      lesson->lines.judge(lesson->ridges, judge);
    judge.in_context = fit<n_all_features>(lessons, without);
    return judge;
  }



  /** Images of one object have one name. */
  std::string
  specimen_of(const std::string &stem)
  {
    // The light on a tile changes, its number is about the same.
    static const std::map<std::string, std::string> tiles = {
      {"mt_exp5_num_265695", "mt_exp1_num_265613"},
      {"mt_exp4_num_116553", "mt_exp2_num_116527"},
      {"mt_exp5_num_3247", "mt_exp2_num_3211"}};
    const auto found = tiles.find(stem);
    if (found != tiles.end())
      return found->second;
    // Pieces of one photograph differ by a letter.
    return stem.rfind("uav_", 0) == 0 && !std::isdigit(stem.back())
             ? stem.substr(0, stem.size() - 1)
             : stem;
  }



  /** An image, which has no name, and through other cameras: what is a crack
   * does not depend on them. */
  std::vector<CameraView>
  views_of(const cv::Mat &grey, const cv::Mat &mask)
  {
    return {{"", grey, mask, 1.},
            scaled_view(grey, mask, 0.5),
            scaled_view(grey, mask, 2.),
            gamma_view(grey, mask, 0.7),
            gamma_view(grey, mask, 1.4),
            jpeg_view(grey, mask, 50),
            quarter_turn_view(grey, mask),
            noisy_view(grey, mask, 4., 77)};
  }



  void
  add_images(Lessons &lessons, const std::filesystem::path &folder)
  {
    for (const char *kind : {"cracks", "negatives"})
      {
        std::vector<cv::String> files;
        cv::glob((folder / kind / "images" / "*.jpg").string(), files);
        for (const std::string &file : files)
          {
            const std::string stem = std::filesystem::path(file).stem();
            const cv::Mat     grey = read_grey(file);
            cv::Mat           mask =
              cv::imread((folder / kind / "masks" / (stem + ".png")).string(),
                         cv::IMREAD_GRAYSCALE);
            if (mask.empty())
              mask = cv::Mat::zeros(grey.size(), CV_8U);
            const std::vector<CameraView> views = views_of(grey, mask);
            for (const CameraView &v : views)
              lessons.push_back(std::make_unique<Lesson>(
                v.name.empty() ? stem : stem + " " + v.name,
                specimen_of(stem),
                v.grey,
                v.mask,
                1. / double(views.size()),
                v.scale < 1. ? 0.75 : v.scale));
          }
      }
  }



  void
  add_made(Lessons &lessons)
  {
    unsigned int seed = 900000;
    for (const double pixel_size : {1., 1., 1., 2., 2., 0.5, 0.5, 0.5})
      {
        SpecimenSettings settings;
        settings.seed       = seed++;
        settings.pixel_size = pixel_size;
        settings.data_bar   = false;
        if (pixel_size < 1.)
          {
            settings.width  = 512.;
            settings.height = 384.;
          }
        const Specimen made = make_specimen(settings);
        cv::Mat        grey;
        made.image.convertTo(grey, CV_32F);
        lessons.push_back(std::make_unique<Lesson>(
          "made", "made", grey, made.cracks, made_weight));
      }
    for (unsigned int i = 0; i < 8; ++i)
      {
        const StraightScene scene = straight_scene(900100 + i, i % 2 == 1);
        lessons.push_back(std::make_unique<Lesson>(
          "straight", "straight", scene.grey, scene.cracks, made_weight));
      }
  }



  template <int n>
  void
  write(std::ostream &out, const std::string &name, const LogOdds<n> &odds)
  {
    const auto list = [&](const std::array<double, n> &values) {
      out << "{{";
      for (int k = 0; k < n; ++k)
        {
          char text[32];
          std::snprintf(text, sizeof text, "%.6g", values[k]);
          out << (k == 0 ? "" : ", ") << text;
        }
      out << "}}";
    };
    out << "    constexpr LogOdds<" << n << "> " << name << " = {"
        << odds.offset << ",\n";
    list(odds.mean);
    out << ",\n";
    list(odds.deviation);
    out << ",\n";
    list(odds.weight);
    out << "};\n";
  }



  void
  write_table(const LineJudge &judge, const std::string &file)
  {
    std::ofstream out(file);
    out
      << "// SPDX-License-Identifier: LGPL-2.1-or-later\n\n"
         "// Version 2, written by tests/tribology/train_line_judge.cc from "
         "the images, made\n// specimens and drawn scenes of "
         "doc/studies/images.md: offset; means, deviations and\n// weights in "
         "the order of LineFeature and ContextFeature. clang-format after "
         "it.\n#include <squeal/tribology/images/line_judge.h>\n\n"
         "namespace squeal::tribology\n{\n  namespace\n  {\n";
    write(out, "by_itself", judge.alone);
    write(out, "among_lines", judge.in_context);
    out << "  } // namespace\n\n\n\n  const LineJudge &\n"
           "  LineJudge::standard()\n  {\n"
           "    static const LineJudge judge{by_itself, among_lines};\n"
           "    return judge;\n  }\n} // namespace squeal::tribology\n";
  }



  /** No view through another camera. */
  bool
  is_original(const Lesson &lesson)
  {
    return lesson.name.find(' ') == std::string::npos;
  }



  void
  leave_one_out(const Lessons &lessons)
  {
    std::set<std::string> specimens;
    for (const auto &lesson : lessons)
      if (lesson->name != "made" && lesson->name != "straight")
        specimens.insert(lesson->specimen);
    std::map<std::string, std::vector<double>> groups;
    for (const std::string &specimen : specimens)
      {
        const LineJudge judge = learn(lessons, {specimen});
        for (const auto &lesson : lessons)
          if (lesson->specimen == specimen && is_original(*lesson))
            {
              const cv::Mat line =
                segment(lesson->grey, {}, judge).cracks.centre_line;
              const double      f1 = score_lines(line, lesson->mask, 2.).f1();
              const std::string group = specimen.substr(0, specimen.find('_'));
              std::printf("%-22s F1 %.3f, %d px\n",
                          lesson->name.c_str(),
                          f1,
                          cv::countNonZero(line));
              groups[group].push_back(f1);
              if (group != "mtfree")
                groups["all"].push_back(f1);
            }
      }
    for (const auto &[name, values] : groups)
      {
        double sum = 0.;
        for (const double v : values)
          sum += v;
        std::printf("mean of %-6s %.3f\n", name.c_str(), sum / values.size());
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  cv::setNumThreads(1);
  if (argc != 3)
    {
      std::cerr << "give the folder of the images and a table to write\n";
      return 1;
    }
  Lessons lessons;
  add_images(lessons, argv[1]);
  add_made(lessons);
  const std::string what = argv[2];
  if (what == "leave-one-out")
    leave_one_out(lessons);
  else
    write_table(learn(lessons), what);
  return 0;
}
