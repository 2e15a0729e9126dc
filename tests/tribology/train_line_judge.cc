// SPDX-License-Identifier: LGPL-2.1-or-later

// Fits the trees of LineJudge to images with masks as they are and through
// other cameras, to made specimens and to drawn scenes of straight cracks and
// grooves. No test: arguments are the folders of the two sets of images
// (SQUEAL_CRACK_IMAGES, SQUEAL_CRACK_IMAGES_2) and the table to write,
//
//   train_line_judge FOLDER FOLDER_2
//   tribology/source/images/line_judge_table.cc
//
// With the word "leave-out" instead of a table nothing is written, but each
// specimen is scored with a judge that has not seen it.
#include <squeal/tribology/images/segmentation.h>
#include <squeal/tribology/images/statistics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <set>

#include "tribology/fit_trees.h"
#include "tribology/lessons.h"
#include "tribology/line_score.h"

using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr int n_threads     = 2;
  constexpr int n_trees       = 200;
  constexpr int n_inner_folds = 5;
  constexpr int n_folds       = 8; // of specimens that are no tiles

  using Specimens = std::set<std::string>;

  /** The lines of all lessons but those of some specimens. */
  template <int n>
  BoostedTrees
  fit(const Lessons &lessons, const Specimens &without)
  {
    TreeData data;
    data.n_features = n;
    double total    = 0.;
    for (const auto &lesson : lessons)
      if (without.count(lesson->specimen) == 0)
        for (std::size_t i = 0; i < lesson->weights.size(); ++i)
          if (lesson->weights[i] > 0.)
            {
              const auto &f = lesson->lines.features[i];
              data.features.insert(
                data.features.end(), f.begin(), f.begin() + n);
              data.is_true.push_back(lesson->is_crack[i]);
              data.weights.push_back(float(lesson->weights[i]));
              total += lesson->weights[i];
            }
    for (float &w : data.weights)
      w *= float(double(data.weights.size()) / total);
    return TreeFit(data).fit(n_trees);
  }



  std::array<double, n_all_features>
  typical_crack(const Lessons &lessons, const Specimens &without)
  {
    std::array<double, n_all_features> mean{};
    double                             total = 0.;
    for (const auto &lesson : lessons)
      if (without.count(lesson->specimen) == 0)
        for (std::size_t i = 0; i < lesson->weights.size(); ++i)
          if (lesson->is_crack[i])
            {
              for (int k = 0; k < n_all_features; ++k)
                mean[k] += lesson->weights[i] * lesson->lines.features[i][k];
              total += lesson->weights[i];
            }
    for (double &m : mean)
      m /= total;
    return mean;
  }



  /** Fits both judgements. What the second one learns from is what the first
   * says of specimens that it has not seen, as it will be in use. */
  LineJudge
  learn(const Lessons &lessons, const Specimens &without = {})
  {
    Specimens seen;
    for (const auto &lesson : lessons)
      if (without.count(lesson->specimen) == 0)
        seen.insert(lesson->specimen);
    std::vector<Specimens> folds(n_inner_folds);
    int                    k = 0;
    for (const std::string &specimen : seen)
      folds[k++ % n_inner_folds].insert(specimen);
    for (const Specimens &fold : folds)
      {
        Specimens unseen = without;
        unseen.insert(fold.begin(), fold.end());
        const BoostedTrees trees = fit<n_own_features>(lessons, unseen);
        for (const auto &lesson : lessons)
          if (fold.count(lesson->specimen) != 0)
            lesson->lines.add_context(lesson->lines.odds_alone(trees));
      }
    LineJudge judge;
    judge.alone      = fit<n_own_features>(lessons, without);
    judge.in_context = fit<n_all_features>(lessons, without);
    judge.typical    = typical_crack(lessons, without);
    return judge;
  }



  void
  write(std::ostream &out, const BoostedTrees &trees)
  {
    out << trees.offset << '\n';
    for (const BoostedTrees::Tree &tree : trees.trees)
      {
        for (const int f : tree.feature)
          out << f << ' ';
        for (const float cut : tree.cut)
          out << cut << ' ';
        for (const int leaf : tree.leaf)
          out << leaf << ' ';
        out << '\n';
      }
  }



  void
  write_table(const LineJudge &judge, const std::string &file)
  {
    std::ofstream out(file);
    out.precision(4);
    out << "// SPDX-License-Identifier: LGPL-2.1-or-later\n\n"
           "// Version 3, written by tests/tribology/train_line_judge.cc from "
           "the images, made\n// specimens and drawn scenes of "
           "doc/studies/images.md. Of each judgement: log odds\n// without any "
           "tree; of each tree the features, the cuts and the leaves.\n"
           "#include <squeal/tribology/images/line_judge.h>\n\n"
           "namespace squeal::tribology\n{\n  namespace\n  {\n"
           "    constexpr const char *by_itself = R\"(\n";
    write(out, judge.alone);
    out << ")\";\n    constexpr const char *among_lines = R\"(\n";
    write(out, judge.in_context);
    out << ")\";\n    constexpr const char *cracks = R\"(\n";
    for (const double value : judge.typical)
      out << value << '\n';
    out << ")\";\n  } // namespace\n\n\n\n  const LineJudge &\n"
           "  LineJudge::standard()\n  {\n"
           "    static const LineJudge judge(by_itself, among_lines, cracks);\n"
           "    return judge;\n  }\n} // namespace squeal::tribology\n";
  }



  /** Tiles by themselves, the others in folds. */
  std::vector<Specimens>
  folds_of(const Lessons &lessons)
  {
    Specimens all;
    for (const auto &lesson : lessons)
      if (!lesson->specimen.empty())
        all.insert(lesson->specimen);
    std::vector<Specimens> folds(n_folds);
    int                    k = 0;
    for (const std::string &specimen : all)
      if (specimen.rfind("tile", 0) == 0)
        folds.push_back({specimen});
      else
        folds[k++ % n_folds].insert(specimen);
    return folds;
  }



  double
  mean(const std::vector<double> &values)
  {
    double sum = 0.;
    for (const double v : values)
      sum += v;
    return sum / double(values.size());
  }



  /** How sure a judge is of lines that it has not seen, and how often it is
   * right. */
  struct Reliability
  {
    static constexpr int lowest = -8, highest = 8;

    std::array<double, highest - lowest + 1> pixels{}, good{}, odds{};

    void
    add(const Lesson &lesson)
    {
      for (std::size_t i = 0; i < lesson.weights.size(); ++i)
        if (lesson.weights[i] > 0.)
          {
            const double x = lesson.lines.log_odds[i];
            const double n = double(lesson.lines.cores[i].size());
            const int    k =
              std::clamp(int(std::floor(x)), lowest, highest) - lowest;
            pixels[k] += n;
            odds[k] += n * x;
            good[k] += lesson.is_crack[i] ? n : 0.;
          }
    }

    void
    print() const
    {
      for (std::size_t k = 0; k < pixels.size(); ++k)
        if (pixels[k] > 0.)
          std::printf("log odds %5.2f: %8.0f px, %.4f true, log odds %5.2f\n",
                      odds[k] / pixels[k],
                      pixels[k],
                      good[k] / pixels[k],
                      std::log((good[k] + 1.) / (pixels[k] - good[k] + 1.)));
    }
  };



  /** Scores an image by a judge; prints its length beside the true one. */
  double
  score(const Lesson &lesson, const LineJudge &judge)
  {
    const Segmentation    found = segment(lesson.grey, {}, judge);
    const ImageStatistics s     = measure(found, 1., {});
    const LineScore       score =
      score_lines(found.cracks.centre_line, lesson.mask, 2.);
    std::printf("%-24s P %.3f R %.3f F1 %.3f, %d px, stated %.1f +- %.1f\n",
                lesson.name.c_str(),
                score.precision,
                score.recall,
                score.f1(),
                cv::countNonZero(found.cracks.centre_line),
                1e3 * s.crack_length,
                1e3 * s.crack_length_error);
    std::fflush(stdout);
    return score.f1();
  }



  void
  leave_out(const Lessons &lessons, const std::size_t n_first)
  {
    std::map<std::string, std::vector<double>> groups;
    Reliability                                reliability;
    for (const Specimens &fold : folds_of(lessons))
      {
        const LineJudge judge = learn(lessons, fold);
        for (std::size_t i = 0; i < lessons.size(); ++i)
          if (fold.count(lessons[i]->specimen) != 0 && lessons[i]->is_original)
            {
              Lesson &lesson = *lessons[i];
              lesson.lines.judge(judge);
              reliability.add(lesson);
              const double      f1  = score(lesson, judge);
              const std::string set = i < n_first ? "first set" : "second set";
              const std::string group =
                lesson.name.substr(0, lesson.name.find('_'));
              if (group != "mtfree")
                for (const std::string &name : {set, set + ", " + group})
                  groups[name].push_back(f1);
            }
      }
    for (const auto &[name, values] : groups)
      std::printf("mean of %-18s %.3f\n", name.c_str(), mean(values));
    reliability.print();
  }
} // namespace



int
main(int argc, char **argv)
{
  cv::setNumThreads(n_threads);
  if (argc != 4)
    {
      std::cerr << "give the folders of both sets and a table to write\n";
      return 1;
    }
  Lessons lessons;
  add_images(lessons, argv[1]);
  const std::size_t n_first = lessons.size();
  add_images(lessons, argv[2]);
  add_made(lessons);
  cv::setNumThreads(1);
  const std::string what = argv[3];
  if (what == "leave-out")
    leave_out(lessons, n_first);
  else
    write_table(learn(lessons), what);
  return 0;
}
