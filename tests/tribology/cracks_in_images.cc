// SPDX-License-Identifier: LGPL-2.1-or-later

// Centre lines of cracks and areas against hand-drawn masks in images that are
// not part of the repository. Arguments: the folder of the images and "first"
// or "second", the set that it holds; exit code 77 when it is not there. Prints
// the tables of doc/studies/images.md.
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/statistics.h>

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <vector>

#include "check.h"
#include "tribology/line_score.h"

using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  namespace fs = std::filesystem;

  /** What a set reaches at least. */
  struct Bounds
  {
    double                        all = 0.; /**< mean F1 */
    std::map<std::string, double> groups;   /**< mean F1 of each */
  };

  const std::map<std::string, Bounds> bounds = {
    {"first", {0.84, {{"cfd", 0.81}, {"mt", 0.88}, {"uav", 0.81}}}},
    {"second", {0.83, {{"cfd", 0.89}, {"mt", 0.87}, {"uav", 0.78}}}}};

  /** Length in pixels outside of @p ignored. */
  double
  length_of(const cv::Mat &line, const cv::Mat &ignored)
  {
    cv::Mat seen = line.clone();
    seen.setTo(0, ignored);
    return cv::sum(pixel_lengths(seen))[0];
  }



  double
  mean(const std::vector<double> &values)
  {
    double sum = 0.;
    for (const double v : values)
      sum += v;
    return sum / double(values.size());
  }



  double
  median(std::vector<double> values)
  {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
  }



  std::vector<cv::String>
  images_in(const fs::path &folder)
  {
    std::vector<cv::String> files;
    cv::glob((folder / "images" / "*.jpg").string(), files);
    return files;
  }



  struct Group
  {
    std::vector<double> f1, is_covered, relative_errors;
  };

  /** Scores each image with cracks and the length that is stated for it. */
  void
  check_cracks(const fs::path &data, const Bounds &least)
  {
    std::map<std::string, Group> groups;
    std::vector<double>          all;
    std::printf("%-22s %9s %7s %6s %6s %7s %15s\n",
                "image",
                "precision",
                "recall",
                "F1",
                "F1 5px",
                "length",
                "stated");
    for (const std::string &file : images_in(data / "cracks"))
      {
        const std::string stem = fs::path(file).stem();
        const cv::Mat     mask =
          cv::imread((data / "cracks" / "masks" / (stem + ".png")).string(),
                     cv::IMREAD_GRAYSCALE);
        const Segmentation    segmentation = segment(read_grey(file));
        const cv::Mat        &found        = segmentation.cracks.centre_line;
        const cv::Mat         ignored      = (mask > 100) & (mask < 200);
        const ImageStatistics s            = measure(segmentation, 1., {});
        const double          error        = 1e3 * s.crack_length_error;
        const double          stated       = 1e3 * s.crack_length;
        const double          seen         = length_of(found, ignored);
        const double          truth =
          length_of(squeal::tribology::thin(mask >= 200), ignored);
        const LineScore score = score_lines(found, mask, 2.);
        std::printf("%-22s %9.3f %7.3f %6.3f %6.3f %7.1f %7.1f +- %5.1f\n",
                    stem.c_str(),
                    score.precision,
                    score.recall,
                    score.f1(),
                    score_lines(found, mask, 5.).f1(),
                    truth,
                    seen,
                    error);
        check(error > 0., "the length of " + stem + " has an error");
        all.push_back(score.f1());
        Group &group = groups[stem.substr(0, stem.find('_'))];
        group.f1.push_back(score.f1());
        group.is_covered.push_back(std::abs(seen - truth) <= 2. * error);
        if (stated > 0.)
          group.relative_errors.push_back(error / stated);
      }
    for (const auto &[name, group] : groups)
      std::printf("mean of %-6s %.3f, %.0f %% of lengths within two deviations,"
                  " median error %.1f %% where cracks are found (%zu of %zu)\n",
                  name.c_str(),
                  mean(group.f1),
                  100. * mean(group.is_covered),
                  100. * median(group.relative_errors),
                  group.relative_errors.size(),
                  group.f1.size());
    std::printf("mean of all    %.3f\n", mean(all));
    std::fflush(stdout);
    check(mean(all) >= least.all, "mean F1 at 2 px of all images");
    for (const auto &[name, group] : groups)
      {
        check(mean(group.f1) >= least.groups.at(name), "mean F1 of " + name);
        check(mean(group.is_covered) >= 0.85,
              "85 % of lengths of " + name + " within two deviations");
        check(median(group.relative_errors) <= 0.30,
              "median error of lengths of " + name + " at most 30 %");
      }
    for (std::size_t i = 0; i < all.size(); ++i)
      {
        std::vector<double> others = all;
        others.erase(others.begin() + std::ptrdiff_t(i));
        check(mean(others) >= 0.60,
              "no one image decides: without " + std::to_string(i));
      }
  }



  /** Nothing is invented on surfaces without cracks. */
  void
  check_no_cracks(const fs::path &data)
  {
    double length = 0., megapixels = 0.;
    for (const std::string &file : images_in(data / "negatives"))
      {
        const cv::Mat grey = read_grey(file);
        const int     n    = cv::countNonZero(segment(grey).cracks.centre_line);
        std::printf(
          "no crack: %-22s %d px\n", fs::path(file).stem().c_str(), n);
        check(n <= 30, "at most 30 px of false length in " + file);
        length += n;
        megapixels += 1e-6 * double(grey.total());
      }
    check(length < 30., "less than 30 px of false length in all of them");
    check(megapixels > 0. && length <= 10. * megapixels,
          "at most 10 px of false length a megapixel");
  }



  /** Areas whose image holds no evidence are not stated with a small error. */
  void
  check_areas(const fs::path &data)
  {
    std::vector<double> is_covered, plateau_is_covered;
    for (const char *kind : {"patches", "negatives"})
      for (const std::string &file : images_in(data / kind))
        {
          const std::string stem = fs::path(file).stem();
          const fs::path    path = data / kind / "masks" / (stem + ".png");
          const cv::Mat     grey = read_grey(file);
          const cv::Mat     truth =
            fs::exists(path)
                  ? cv::Mat(cv::imread(path.string(), cv::IMREAD_GRAYSCALE) >= 200)
                  : cv::Mat(cv::Mat::zeros(grey.size(), CV_8U));
          const Segmentation    found = segment(grey);
          const ImageStatistics s     = measure(found, 1., {});
          const double share = cv::countNonZero(truth) / double(truth.total());
          std::printf(
            "%-28s defect %5.2f %%, stated %5.2f +- %5.2f %%%s, "
            "dark without a rim %5.2f %%, plateaus %5.2f +- %5.2f %%, "
            "Dice %.2f\n",
            stem.c_str(),
            100. * share,
            100. * s.exfoliation_fraction,
            100. * s.exfoliation_fraction_error,
            s.shows_exfoliations() ? "" : " (none shown)",
            100. * s.unsettled_fraction,
            100. * s.plateau_fraction,
            100. * s.plateau_fraction_error,
            dice(found.areas.exfoliation, truth));
          is_covered.push_back(std::abs(share - s.exfoliation_fraction) <=
                               2. * s.exfoliation_fraction_error);
          // Neither tiles nor their defects are contact plateaus.
          plateau_is_covered.push_back(s.plateau_fraction <=
                                       2. * s.plateau_fraction_error);
        }
    std::printf("%.0f %% of %zu areas within two deviations\n",
                100. * mean(is_covered),
                is_covered.size());
    std::fflush(stdout);
    check(mean(is_covered) >= 0.80, "areas lie within two deviations");
    check(mean(plateau_is_covered) >= 1.,
          "no plateau is certain where there are none");
  }
} // namespace



int
main(int argc, char **argv)
{
  cv::setNumThreads(1);
  const fs::path    data = argc > 1 ? argv[1] : "";
  const std::string set  = argc > 2 ? argv[2] : "first";
  if (!fs::is_directory(data / "cracks" / "images"))
    {
      std::cout << "skipped: no images in '" << data.string() << "'\n";
      return 77;
    }
  check_cracks(data, bounds.at(set));
  check_no_cracks(data);
  check_areas(data);
  return 0;
}
