// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/line_position.h>
#include <squeal/tribology/images/segmentation.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <vector>

namespace squeal::tribology
{
  namespace
  {
    constexpr int   exfoliation_rim = 4;   // pixels
    constexpr int   shortest_rest   = 15;  // pixels of a crack that was cut
    constexpr int   longest_spur    = 6;   // pixels
    constexpr float longest_shape   = 3.F; // length over thickness

    /** Removes areas along which a crack runs and that are long for their
     * thickness: they are the shoulders of the crack. */
    void
    leave_shoulders(cv::Mat &areas, const cv::Mat &centre_line)
    {
      cv::Mat1i labels, stats;
      cv::Mat   centroids;
      const int n =
        cv::connectedComponentsWithStats(areas, labels, stats, centroids, 8);
      cv::Mat1f depth;
      cv::distanceTransform(areas, depth, cv::DIST_L2, 3);
      std::vector<float> radius(n, 0.F);
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          radius[labels(y, x)] = std::max(radius[labels(y, x)], depth(y, x));
      cv::Mat wide;
      cv::dilate(centre_line, wide, cv::Mat(), {-1, -1}, exfoliation_rim);
      std::vector<char> is_crossed(n, 0);
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          if (wide.at<uchar>(y, x) != 0)
            is_crossed[labels(y, x)] = 1;
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          {
            const int   l = labels(y, x);
            const float r = radius[l];
            if (l > 0 && is_crossed[l] &&
                stats(l, cv::CC_STAT_AREA) > longest_shape * 4.F * r * r)
              areas.at<uchar>(y, x) = 0;
          }
    }



    /** Takes out what lies in @p areas. */
    void
    cut(cv::Mat &centre_line, const cv::Mat &areas)
    {
      cv::Mat wide;
      cv::dilate(areas,
                 wide,
                 cv::getStructuringElement(
                   cv::MORPH_ELLIPSE,
                   cv::Size(2 * exfoliation_rim + 1, 2 * exfoliation_rim + 1)));
      if (cv::countNonZero(centre_line & wide) == 0)
        return;
      centre_line.setTo(0, wide);
      for (const LinePiece &piece : line_pieces(centre_line))
        if (int(piece.pixels.size()) < shortest_rest)
          for (const cv::Point &p : piece.pixels)
            centre_line.at<uchar>(p) = 0;
      remove_spurs(centre_line, longest_spur);
    }
  } // namespace



  Segmentation
  segment(const cv::Mat &grey, const SegmentationSettings &settings)
  {
    const RidgeField ridges = filter_ridges(grey, settings.n_octaves);
    cv::Mat          line   = find_centre_lines(grey, ridges);
    Segmentation     result;
    result.cracks = measure_cracks(grey, line, ridges);
    result.areas  = find_areas(grey, result.cracks.area, settings.areas);
    leave_shoulders(result.areas.exfoliation, line);
    result.areas.rough &= result.areas.exfoliation;
    cut(line, result.areas.rough);
    result.cracks = measure_cracks(grey, move_to_middle(grey, line), ridges);
    return result;
  }
} // namespace squeal::tribology
