// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_tribology_cut_frames_h
#define squeal_tests_tribology_cut_frames_h

#include <squeal/tribology/images/micrograph.h>

#include <string>
#include <vector>

namespace squeal::testing
{
  /** Frames of one picture, named a0, a1, ..., by their corners there; stage
   * positions are @p stage times as far away in x and y. */
  inline std::vector<tribology::Micrograph>
  frames_of(const cv::Mat                &grey,
            const cv::Size               &size,
            const std::vector<cv::Point> &corners,
            const cv::Point2d            &stage)
  {
    std::vector<tribology::Micrograph> frames;
    for (const cv::Point &corner : corners)
      {
        tribology::Micrograph m;
        m.path       = "a" + std::to_string(frames.size());
        m.grey       = grey(cv::Rect(corner, size)).clone();
        m.frame      = {{0, 0}, size};
        m.pixel_size = 2.;
        m.metadata.stage =
          cv::Point2d(2. * stage.x * corner.x, 2. * stage.y * corner.y);
        frames.push_back(m);
      }
    return frames;
  }
} // namespace squeal::testing

#endif
