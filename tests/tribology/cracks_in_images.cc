// SPDX-License-Identifier: LGPL-2.1-or-later

// Centre lines of cracks against hand-drawn masks in images that are not part
// of the repository: argument 1 is their directory; exit code 77 when it is
// not there. Prints the table of doc/verification.md.
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/statistics.h>

#include <opencv2/imgcodecs.hpp>

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
} // namespace



int
main(int argc, char **argv)
{
  namespace fs = std::filesystem;
  cv::setNumThreads(1);
  const fs::path data = argc > 1 ? argv[1] : "";
  if (!fs::is_directory(data / "cracks" / "images"))
    {
      std::cout << "skipped: no images in '" << data.string() << "'\n";
      return 77;
    }
  std::vector<cv::String> files;
  cv::glob((data / "cracks" / "images" / "*.jpg").string(), files);
  std::vector<double>                        all;
  std::map<std::string, std::vector<double>> groups, covered;
  std::printf(
    "%-22s %9s %7s %6s %6s\n", "image", "precision", "recall", "F1", "F1 5px");
  for (const std::string &file : files)
    {
      const std::string stem = fs::path(file).stem();
      const cv::Mat     mask =
        cv::imread((data / "cracks" / "masks" / (stem + ".png")).string(),
                   cv::IMREAD_GRAYSCALE);
      const Segmentation segmentation = segment(read_grey(file));
      const cv::Mat     &found        = segmentation.cracks.centre_line;
      const cv::Mat      ignored      = (mask > 100) & (mask < 200);
      const double       error =
        1e3 * measure(segmentation, 1., 0.).crack_length_error;
      const double off =
        length_of(found, ignored) -
        length_of(squeal::tribology::thin(mask >= 200), ignored);
      check(error > 0., "the length of " + stem + " has an error");
      const LineScore s = score_lines(found, mask, 2.);
      std::printf("%-22s %9.3f %7.3f %6.3f %6.3f\n",
                  stem.c_str(),
                  s.precision,
                  s.recall,
                  s.f1(),
                  score_lines(found, mask, 5.).f1());
      all.push_back(s.f1());
      const std::string group = stem.substr(0, stem.find('_'));
      groups[group].push_back(s.f1());
      covered[group].push_back(std::abs(off) <= 2. * error ? 1. : 0.);
    }
  for (const auto &[name, values] : groups)
    std::printf("mean of %-6s %.3f, %.0f %% of lengths within two deviations\n",
                name.c_str(),
                mean(values),
                100. * mean(covered[name]));
  std::printf("mean of all    %.3f\n", mean(all));

  double false_length = 0.;
  cv::glob((data / "negatives" / "images" / "*.jpg").string(), files);
  for (const std::string &file : files)
    {
      const int n =
        cv::countNonZero(segment(read_grey(file)).cracks.centre_line);
      std::printf("no crack: %-22s %d px\n", fs::path(file).stem().c_str(), n);
      false_length += n;
    }
  std::fflush(stdout);

  check(mean(all) >= 0.84, "mean F1 at 2 px is at least 0.84");
  check(groups.count("cfd") == 0 || mean(groups["cfd"]) >= 0.86,
        "mean F1 of cracks in asphalt is at least 0.86");
  for (const auto &[name, values] : groups)
    {
      check(mean(values) >= 0.78, "mean F1 of " + name + " at least 0.78");
      check(mean(covered[name]) >= 0.8,
            "four fifths of lengths of " + name + " within two deviations");
    }
  check(false_length < 30., "less than 30 px in images without cracks");
  for (std::size_t i = 0; i < all.size(); ++i)
    {
      std::vector<double> others = all;
      others.erase(others.begin() + std::ptrdiff_t(i));
      check(mean(others) >= 0.60,
            "no one image decides: without " + std::to_string(i));
    }
  return 0;
}
