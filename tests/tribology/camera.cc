// SPDX-License-Identifier: LGPL-2.1-or-later

// Cracks through other cameras: F1 of the images of the argument against that
// of their views. Exit code 77 when they are not there. Prints the table of
// doc/studies/images.md; the bounds are what is reached, not what is asked.
#include "tribology/camera_views.h"

#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/segmentation.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>

#include "check.h"
#include "tribology/line_score.h"

using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  namespace fs = std::filesystem;

  /** Against the mask in the pixels that it was drawn in. */
  double
  score(const CameraView &view, const cv::Mat &mask)
  {
    cv::Mat line = segment(view.grey).cracks.centre_line;
    if (view.scale == 1.)
      return score_lines(line, view.mask, 2.).f1();
    if (view.scale < 1.)
      cv::resize(line, line, mask.size(), 0., 0., cv::INTER_NEAREST);
    else
      {
        cv::Mat share;
        line.convertTo(share, CV_32F);
        cv::resize(share, share, mask.size(), 0., 0., cv::INTER_AREA);
        line = share > 0.;
      }
    return score_lines(line, mask, 2.).f1();
  }



  /** The grey values in 16 bits, written and read again. */
  CameraView
  deep_view(const cv::Mat &grey, const cv::Mat &mask)
  {
    cv::Mat deep;
    grey.convertTo(deep, CV_16U, 257.);
    cv::imwrite("deep.png", deep);
    return {"16 bit", read_grey("deep.png"), mask.clone()};
  }



  /** Changes of F1 against the image as it is. */
  struct Change
  {
    std::vector<double> all;

    double
    mean() const
    {
      double sum = 0.;
      for (const double c : all)
        sum += c;
      return sum / double(all.size());
    }

    double
    worst() const
    {
      double largest = 0.;
      for (const double c : all)
        if (!(std::abs(c) <= std::abs(largest)))
          largest = c;
      return largest;
    }

    int
    n_beyond(const double limit) const
    {
      int n = 0;
      for (const double c : all)
        n += !(std::abs(c) <= limit);
      return n;
    }
  };
} // namespace



int
main(int argc, char **argv)
{
  cv::setNumThreads(1);
  const fs::path data = argc > 1 ? argv[1] : "";
  if (!fs::is_directory(data / "cracks" / "images"))
    {
      std::cout << "skipped: no images in '" << data.string() << "'\n";
      return 77;
    }
  std::vector<cv::String> files;
  cv::glob((data / "cracks" / "images" / "*.jpg").string(), files);
  std::map<std::string, Change> changes;
  for (const std::string &file : files)
    {
      const std::string stem = fs::path(file).stem();
      const cv::Mat     grey = read_grey(file);
      const cv::Mat     mask =
        cv::imread((data / "cracks" / "masks" / (stem + ".png")).string(),
                   cv::IMREAD_GRAYSCALE);
      const double as_it_is = score({"", grey, mask}, mask);
      std::printf("%-22s %.3f:", stem.c_str(), as_it_is);
      for (const CameraView &view : {deep_view(grey, mask),
                                     scaled_view(grey, mask, 0.5),
                                     scaled_view(grey, mask, 2.),
                                     jpeg_view(grey, mask, 80),
                                     gamma_view(grey, mask, 0.8),
                                     gamma_view(grey, mask, 1.25),
                                     quarter_turn_view(grey, mask),
                                     turned_view(grey, mask, 20.),
                                     noisy_view(grey, mask, 3., 7)})
        {
          const double f1 = score(view, mask);
          std::printf(" %.3f", f1);
          changes[view.name].all.push_back(f1 - as_it_is);
        }
      std::printf("\n");
      std::fflush(stdout);
    }
  for (const auto &[name, change] : changes)
    std::printf("%-22s mean %+.3f, worst %+.3f, %d of %zu beyond 0.15\n",
                name.c_str(),
                change.mean(),
                change.worst(),
                change.n_beyond(0.15),
                change.all.size());
  std::fflush(stdout);
  const std::map<std::string, double> most = {{"16 bit", 0.001},
                                              {"JPEG of quality 80", 0.03},
                                              {"gamma 1.25", 0.03},
                                              {"gamma 0.80", 0.03},
                                              {"noise of 3 levels", 0.03},
                                              {"turned by 90 degrees", 0.04},
                                              {"turned by 20 degrees", 0.15},
                                              {"double resolution", 0.06},
                                              {"half resolution", 0.13}};
  for (const auto &[name, change] : changes)
    check(std::abs(change.mean()) <= most.at(name),
          "mean F1 moves no more than it did: " + name);
  return 0;
}
