// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_frame_overlap_h
#define squeal_tribology_images_frame_overlap_h

#include <opencv2/core.hpp>

#include <optional>

namespace squeal::tribology
{
  /** Edge of the smallest overlap that frames are aligned by, px. */
  constexpr int least_overlap = 48;

  /** What @p moving, whose corner lies at @p shift, shares with @p fixed, in
   * the pixels of that. */
  cv::Rect shared_part(const cv::Mat     &fixed,
                       const cv::Mat     &moving,
                       const cv::Point2d &shift);

  /** Whether frames can be aligned by that overlap. */
  bool is_wide_enough(const cv::Rect &overlap);

  /** Whether there is more in a part of a picture than noise and shading. */
  bool shows_anything(const cv::Mat &part);

  /**
   * By how many standard deviations the correlation of two parts of one size as
   * they lie on each other is above that of any other shift of one of them
   * (in Fisher's z, without shading; parts are continued periodically). At
   * most 0 where another shift fits better, which a place by chance hardly ever
   * leads: the scale is what these very pixels correlate by chance. 0 where the
   * parts are too small or show nothing.
   */
  double lead_over_other_shifts(const cv::Mat &fixed, const cv::Mat &moving);

  /**
   * Shift (pixels) that takes @p moving onto @p fixed by maximising their
   * correlation from @p start on; nothing when it does not converge, when the
   * correlation stays below 0.3, when another shift fits about as well, so that
   * the frames need not show the same, or when the overlap is too small.
   */
  std::optional<cv::Point2d> refine_shift(const cv::Mat     &fixed,
                                          const cv::Mat     &moving,
                                          const cv::Point2d &start);
} // namespace squeal::tribology

#endif
