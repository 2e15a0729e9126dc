// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/brightness_levels.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace squeal::tribology
{
  namespace
  {
    constexpr int    n_bins      = 1000;
    constexpr double first_value = -1., bin_width = 0.005;
    // Of the pixels: a level with less is that of a few bright places.
    constexpr double level_share = 0.05;
    // Count in the valley over that of the lower peak.
    constexpr float deepest = 0.5F;
    // The brightness on both sides of an outline, pixels from it.
    constexpr float side_begin = 2.F, side_end = 4.5F;
    // Step at the outlines over the difference of the levels.
    constexpr double level_step = 0.65;

    bool
    shows(const SeenPixels &seen, const int y, const int x)
    {
      return seen.empty() || seen.at<uchar>(y, x) != 0;
    }



    double
    middle_of(const int bin)
    {
      return (bin + 0.5) * bin_width + first_value;
    }



    /** 1 x n_bins, smoothed. */
    cv::Mat1f
    histogram(const cv::Mat1f &values, const SeenPixels &seen)
    {
      cv::Mat1f counts(1, n_bins, 0.F);
      for (int y = 0; y < values.rows; ++y)
        for (int x = 0; x < values.cols; ++x)
          {
            const double i = (values(y, x) - first_value) / bin_width;
            if (i >= 0. && i < n_bins && shows(seen, y, x))
              counts(0, int(i)) += 1.F;
          }
      cv::GaussianBlur(counts, counts, cv::Size(0, 0), 1.5, 0.1);
      return counts;
    }



    /** Deviation of the peak at @p top. */
    double
    width_of(const cv::Mat1f &counts, const int top)
    {
      const float level = 0.6065F * counts(0, top);
      int         left = top, right = top;
      while (left > 0 && counts(0, left) > level)
        --left;
      while (right < n_bins - 1 && counts(0, right) > level)
        ++right;
      // A second peak close by widens one side only.
      return std::max(1, std::min(top - left, right - top)) * bin_width;
    }
  } // namespace



  BrightnessLevels
  levels_of(const cv::Mat1f &values, const SeenPixels &seen)
  {
    const cv::Mat1f counts = histogram(values, seen);
    const int       top =
      int(std::max_element(counts.begin(), counts.end()) - counts.begin());
    int second = top, valley = top;
    for (int i = top + 1, lowest_yet = top; i < n_bins; ++i)
      {
        if (counts(0, i) < counts(0, lowest_yet))
          lowest_yet = i;
        if (counts(0, lowest_yet) < deepest * counts(0, i) &&
            (second == top || counts(0, i) > counts(0, second)))
          {
            second = i;
            valley = lowest_yet;
          }
      }
    const double all    = cv::sum(counts)[0],
                 darker = cv::sum(counts.colRange(0, valley))[0];
    BrightnessLevels result;
    int              bulk = top;
    if (second > top && all - darker >= level_share * all)
      {
        result.darker       = middle_of(top);
        result.brighter     = middle_of(second);
        result.darker_share = darker / all;
        if (darker < 0.5 * all)
          bulk = second;
      }
    result.bulk      = middle_of(bulk);
    result.deviation = width_of(counts, bulk);
    return result;
  }



  bool
  have_rim_between(const BrightnessLevels &levels,
                   const cv::Mat1f        &smooth,
                   const cv::Mat1f        &fine,
                   const double            least_contrast,
                   const SeenPixels       &seen)
  {
    const double difference = levels.brighter - levels.darker;
    if (!levels.are_two() ||
        difference < least_contrast * (1. + levels.brighter))
      return false;
    const cv::Mat bright = smooth > 0.5 * (levels.darker + levels.brighter);
    cv::Mat1f     to_dark, to_bright;
    cv::distanceTransform(bright, to_dark, cv::DIST_L2, 5);
    cv::distanceTransform(~bright, to_bright, cv::DIST_L2, 5);
    const auto is_beside = [](const float d) {
      return d >= side_begin && d < side_end;
    };
    double sum[2] = {0., 0.}, n[2] = {0., 0.};
    for (int y = 0; y < fine.rows; ++y)
      for (int x = 0; x < fine.cols; ++x)
        if (shows(seen, y, x))
          for (const int side : {0, 1})
            if (is_beside(side == 0 ? to_bright(y, x) : to_dark(y, x)))
              {
                sum[side] += fine(y, x);
                n[side] += 1.;
              }
    return n[0] > 0. && n[1] > 0. &&
           sum[1] / n[1] - sum[0] / n[0] >= level_step * difference;
  }
} // namespace squeal::tribology
