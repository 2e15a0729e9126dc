// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/seen_pixels.h>

#include <opencv2/imgproc.hpp>

#include <vector>

namespace squeal::tribology
{
  namespace
  {
    // Cracks and pits may be black, too: they are narrower or end before the
    // edge of the image.
    constexpr int    border_block       = 9;     // pixels
    constexpr double least_border_share = 0.005; // of the image
    // Sharp corners are no blocks; interpolation darkens one pixel beside.
    constexpr int border_corner = 15, border_blur = 1; // pixels

    cv::Mat
    square(const int reach)
    {
      const int n = 2 * reach + 1;
      return cv::Mat(n, n, CV_8U, cv::Scalar(1));
    }



    /** The connected parts of @p mask that reach its edge. */
    cv::Mat
    parts_at_edge(const cv::Mat &mask)
    {
      cv::Mat1i         labels;
      const int         n = cv::connectedComponents(mask, labels, 8);
      std::vector<char> reaches(n, 0);
      for (int x = 0; x < labels.cols; ++x)
        reaches[labels(0, x)] = reaches[labels(labels.rows - 1, x)] = 1;
      for (int y = 0; y < labels.rows; ++y)
        reaches[labels(y, 0)] = reaches[labels(y, labels.cols - 1)] = 1;
      reaches[0]     = 0;
      cv::Mat result = cv::Mat::zeros(mask.size(), CV_8U);
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          if (reaches[labels(y, x)] != 0)
            result.at<uchar>(y, x) = 255;
      return result;
    }
  } // namespace



  int
  n_seen(const SeenPixels &seen, const cv::Size &size)
  {
    return seen.empty() ? size.area() : cv::countNonZero(seen);
  }



  SeenPixels
  both_seen(const SeenPixels &a, const SeenPixels &b)
  {
    if (a.empty() || b.empty())
      return a.empty() ? b : a;
    return a & b;
  }



  void
  keep_seen(cv::Mat &mask, const SeenPixels &seen)
  {
    if (!seen.empty() && !mask.empty())
      mask.setTo(0, ~seen);
  }



  SeenPixels
  inside_black_border(const cv::Mat &grey)
  {
    const cv::Mat black = grey == 0.F;
    cv::Mat       border;
    cv::morphologyEx(
      black, border, cv::MORPH_OPEN, square((border_block - 1) / 2));
    border = parts_at_edge(border);
    if (cv::countNonZero(border) < least_border_share * double(border.total()))
      return {};
    cv::Mat corners;
    cv::dilate(border, corners, square(border_corner));
    border |= corners & black;
    cv::dilate(border, border, square(border_blur));
    return ~border;
  }



  cv::Mat
  mirrored_beyond(const cv::Mat &grey, const SeenPixels &seen)
  {
    if (seen.empty())
      return grey;
    cv::Mat             result = grey.clone();
    const NearestPixels nearest(seen);
    const cv::Rect      inside({0, 0}, grey.size());
    for (int y = 0; y < grey.rows; ++y)
      for (int x = 0; x < grey.cols; ++x)
        {
          const cv::Point p(x, y);
          if (seen.at<uchar>(p) != 0)
            continue;
          const cv::Point edge = nearest.place(p);
          // Where there is nothing as far behind the edge: nearer to it.
          cv::Point from = edge;
          for (double share = 1.; share > 0.05; share *= 0.5)
            {
              const cv::Point q(edge.x + cvRound(share * (edge.x - x)),
                                edge.y + cvRound(share * (edge.y - y)));
              if (!inside.contains(q) || seen.at<uchar>(q) == 0)
                continue;
              from = q;
              break;
            }
          result.at<float>(p) = grey.at<float>(from);
        }
    return result;
  }
} // namespace squeal::tribology
