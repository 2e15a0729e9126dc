// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/line_position.h>
#include <squeal/tribology/images/scan_rows.h>
#include <squeal/tribology/images/segmentation.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace squeal::tribology
{
  namespace
  {
    constexpr int   exfoliation_rim   = 4;   // pixels
    constexpr int   shortest_rest     = 15;  // pixels of a crack that was cut
    constexpr int   longest_line_spur = 6;   // pixels
    constexpr float longest_shape     = 3.F; // length over thickness
    // Share of an area beside no crack, and what counts as beside.
    constexpr double least_free = 0.3;
    constexpr double beside     = 4.5; // pixels
    // Between a crack and an area, over the crack's other side.
    constexpr float least_gap = 0.3F;
    // A dark place that may be a wide crack: length over thickness, and the
    // part of it that may lie on the border or on a crack that is found.
    constexpr double least_slenderness = 6.;
    constexpr double most_known        = 0.3;

    /** Removes areas along which a crack runs and that are long for their
     * thickness, or that lie beside cracks for the most part: they are the
     * shoulders of the crack, or where it forks. */
    void
    leave_shoulders(cv::Mat &areas, const cv::Mat &centre_line)
    {
      cv::Mat1i labels, stats;
      cv::Mat   centroids;
      const int n =
        cv::connectedComponentsWithStats(areas, labels, stats, centroids, 8);
      cv::Mat1f depth;
      cv::distanceTransform(areas, depth, cv::DIST_L2, 3);
      cv::Mat1f distance;
      cv::distanceTransform(~centre_line, distance, cv::DIST_L2, 5);
      std::vector<float> radius(n, 0.F);
      std::vector<int>   n_free(n, 0);
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          {
            const int l = labels(y, x);
            radius[l]   = std::max(radius[l], depth(y, x));
            n_free[l] += distance(y, x) > beside;
          }
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
            const int   l    = labels(y, x);
            const float r    = radius[l];
            const int   area = stats(l, cv::CC_STAT_AREA);
            if (l > 0 && is_crossed[l] &&
                (area > longest_shape * 4.F * r * r ||
                 n_free[l] < least_free * area))
              areas.at<uchar>(y, x) = 0;
          }
    }



    /** Whether there is a gap between a pixel of a line and one of an area: a
     * place brighter than the line, by a share of what its other side is. */
    bool
    is_apart(const cv::Mat1f &smooth, const cv::Point &p, const cv::Point &area)
    {
      const cv::Point2d d        = area - p;
      const double      distance = cv::norm(d);
      if (distance < 2.)
        return false;
      const auto at = [&](const double t) {
        const cv::Point2d q = cv::Point2d(p) + d * (t / distance);
        return smooth(std::clamp(cvRound(q.y), 0, smooth.rows - 1),
                      std::clamp(cvRound(q.x), 0, smooth.cols - 1));
      };
      float gap = at(1.), other_side = at(-1.);
      for (double t = 1.; t < distance; t += 0.5)
        gap = std::max(gap, at(t));
      for (double t = 1.; t <= exfoliation_rim; t += 0.5)
        other_side = std::max(other_side, at(-t));
      return gap - at(0.) > least_gap * (other_side - at(0.));
    }



    /** Takes out what lies in @p areas or on their rims, and returns it. A line
     * on a rim gets brighter away from the area only, a crack beside it on both
     * sides. */
    PixelPath
    cut(cv::Mat &centre_line, const cv::Mat &areas, const cv::Mat &grey)
    {
      if (cv::countNonZero(areas) == 0)
        return {};
      const NearestPixels nearest(areas);
      cv::Mat1f           smooth;
      cv::GaussianBlur(grey, smooth, cv::Size(), 0.7);
      PixelPath pixels, taken;
      cv::findNonZero(centre_line, pixels);
      for (const cv::Point &p : pixels)
        if (nearest.distance(p) <= exfoliation_rim + 0.5 &&
            !is_apart(smooth, p, nearest.place(p)))
          taken.push_back(p);
      if (taken.empty())
        return taken;
      for (const cv::Point &p : taken)
        centre_line.at<uchar>(p) = 0;
      for (const LinePiece &piece : line_pieces(centre_line))
        if (int(piece.pixels.size()) < shortest_rest)
          for (const cv::Point &p : piece.pixels)
            centre_line.at<uchar>(p) = 0;
      remove_spurs(centre_line, longest_line_spur);
      return taken;
    }
    /** Places of @p dark, of which nothing but their brightness is known, that
     * are as slender as a crack and may be one that is too wide for the finder
     * of lines. Those along the border or along @p line are the edge of the
     * specimen and the shoulders of cracks. */
    std::vector<ExcludedLine>
    slender_places(const cv::Mat    &dark,
                   const cv::Mat    &line,
                   const SeenPixels &seen)
    {
      std::vector<ExcludedLine> bands;
      if (cv::countNonZero(dark) == 0)
        return bands;
      cv::Mat known;
      cv::dilate(line, known, cv::Mat(), {-1, -1}, exfoliation_rim);
      cv::Mat border = cv::Mat::zeros(dark.size(), CV_8U);
      if (!seen.empty())
        cv::dilate(~seen, border, cv::Mat());
      cv::rectangle(border, cv::Rect({0, 0}, dark.size()), 255);
      cv::Mat1f depth;
      cv::distanceTransform(dark, depth, cv::DIST_L2, 5);
      cv::Mat1i labels, stats;
      cv::Mat   centroids;
      const int n =
        cv::connectedComponentsWithStats(dark, labels, stats, centroids, 8);
      for (int l = 1; l < n; ++l)
        {
          const cv::Rect box(stats(l, cv::CC_STAT_LEFT),
                             stats(l, cv::CC_STAT_TOP),
                             stats(l, cv::CC_STAT_WIDTH),
                             stats(l, cv::CC_STAT_HEIGHT));
          const cv::Mat  part = labels(box) == l;
          double         radius;
          cv::minMaxLoc(depth(box), nullptr, &radius, nullptr, nullptr, part);
          const double area   = stats(l, cv::CC_STAT_AREA),
                       length = area / (2. * radius);
          if (length < least_slenderness * 2. * radius ||
              cv::countNonZero(part & known(box)) > most_known * area ||
              cv::countNonZero(part & border(box)) > most_known * length)
            continue;
          cv::Mat axis = thin(part);
          remove_spurs(axis, longest_line_spur, cv::Mat1f(depth(box)));
          PixelPath pixels;
          cv::findNonZero(axis, pixels);
          if (pixels.empty())
            continue;
          for (cv::Point &p : pixels)
            p += box.tl();
          bands.push_back(
            {pixels, 0.5, Exclusion::wide, area / length_of_pixels(pixels)});
        }
      return bands;
    }



    /** Lists the dark bands of @p result, with even odds of being cracks. All
     * of an image are likely to be of one kind. */
    void
    add_bands(Segmentation &result, const cv::Mat &line)
    {
      double length = 0.;
      for (const ExcludedLine &band :
           slender_places(result.areas.unsettled, line, result.seen))
        {
          length += length_of_pixels(band.pixels);
          result.excluded.push_back(band);
        }
      FinderDoubt &doubt = result.cracks.doubt;
      doubt.unsettled    = std::hypot(doubt.unsettled, std::sqrt(0.5) * length);
    }
  } // namespace



  Segmentation
  segment(const cv::Mat              &picture,
          const SegmentationSettings &settings,
          const LineJudge            &judge,
          const SeenPixels           &seen)
  {
    const ScanRows   rows  = without_scan_rows(picture);
    const cv::Mat    grey  = mirrored_beyond(rows.grey, seen);
    const CrackLines found = find_cracks(grey, settings.n_octaves, judge, seen);
    cv::Mat          line  = found.centre_line;
    const double     widest = width_of_octaves(settings.n_octaves);
    Segmentation     result;
    result.seen   = seen;
    result.cracks = measure_cracks(grey, line, found.ridges, widest);
    result.areas  = find_areas(grey, result.cracks.area, settings.areas, seen);
    leave_shoulders(result.areas.exfoliation, line);
    result.areas.rough &= result.areas.exfoliation;
    const PixelPath rims   = cut(line, result.areas.rough, grey);
    cv::Mat         middle = move_to_middle(grey, line);
    keep_seen(middle, seen);
    result.cracks = measure_cracks(grey, middle, found.ridges, widest);
    keep_seen(result.cracks.area, seen);
    result.cracks.doubt = found.doubt;
    // A crack may be covered there, or there are two.
    result.cracks.doubt.invented += result.cracks.bridged;
    result.excluded = found.excluded;
    for (const PixelPath &row : rows.pieces)
      if (seen.empty() || seen.at<uchar>(row[row.size() / 2]) != 0)
        {
          if (rows.are_filled)
            result.excluded.push_back({row, 0., Exclusion::scan});
          else
            {
              result.rows_like_scan.push_back(row);
              result.cracks.doubt.invented += double(row.size());
            }
        }
    add_bands(result, line);
    if (!rims.empty())
      {
        cv::Mat taken = cv::Mat::zeros(grey.size(), CV_8U);
        for (const cv::Point &p : rims)
          taken.at<uchar>(p) = 255;
        for (const LinePiece &piece : line_pieces(taken))
          result.excluded.push_back({piece.pixels, 0.5, Exclusion::rim});
      }
    return result;
  }
} // namespace squeal::tribology
