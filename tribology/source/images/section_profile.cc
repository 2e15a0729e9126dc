// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/section_profile.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr int least_step = 12; // grey levels between layer and bulk

    double
    quantile(std::vector<double> values, const double q)
    {
      if (values.empty())
        return 0.;
      const auto nth =
        values.begin() + std::ptrdiff_t(q * double(values.size() - 1));
      std::nth_element(values.begin(), nth, values.end());
      return *nth;
    }



    /** Row below the resin in each column: Otsu's threshold, the lowest dark
     * run from the top, a median over neighbours. */
    std::vector<double>
    find_surface(const cv::Mat &smooth)
    {
      cv::Mat bytes, material;
      smooth.convertTo(bytes, CV_8U);
      cv::threshold(
        bytes, material, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
      cv::Mat1f rows(1, smooth.cols, 0.F);
      for (int x = 0; x < smooth.cols; ++x)
        {
          int y = 0;
          while (y < smooth.rows && material.at<uchar>(y, x) == 0)
            ++y;
          rows(0, x) = y < smooth.rows ? float(y) : 0.F;
        }
      std::vector<double> surface(smooth.cols);
      for (int x = 0; x < smooth.cols; ++x)
        {
          std::vector<double> near;
          for (int i = std::max(0, x - 7);
               i <= std::min(smooth.cols - 1, x + 7);
               ++i)
            near.push_back(rows(0, i));
          surface[x] = quantile(near, 0.5);
        }
      return surface;
    }



    /** Mean over columns at each depth below the face. */
    std::vector<double>
    depth_profile(const cv::Mat             &smooth,
                  const std::vector<double> &surface,
                  const int                  x0,
                  const int                  x1)
    {
      std::vector<double> sum(smooth.rows, 0.), n(smooth.rows, 0.);
      for (int x = x0; x < x1; ++x)
        for (int y = cvRound(surface[x]); y < smooth.rows; ++y)
          {
            sum[y - cvRound(surface[x])] += smooth.at<float>(y, x);
            n[y - cvRound(surface[x])] += 1.;
          }
      std::size_t length = 0;
      while (length < sum.size() && n[length] >= 0.5 * (x1 - x0))
        {
          sum[length] /= n[length];
          ++length;
        }
      sum.resize(length);
      return sum;
    }



    double
    mean_of(const std::vector<double> &v, std::size_t a, std::size_t b)
    {
      b          = std::min(b, v.size());
      double sum = 0.;
      for (std::size_t i = a; i < b; ++i)
        sum += v[i];
      return b > a ? sum / double(b - a) : 0.;
    }
  } // namespace



  SectionProfile
  profile_section(const cv::Mat &grey,
                  const cv::Mat &centre_line,
                  const double   band)
  {
    cv::Mat smooth;
    cv::GaussianBlur(grey, smooth, cv::Size(), 1.5);
    SectionProfile result;
    result.surface = find_surface(smooth);

    const auto   whole = depth_profile(smooth, result.surface, 0, grey.cols);
    const double bulk  = mean_of(whole, whole.size() / 2, whole.size());
    result.layer.assign(grey.cols, 0.);
    constexpr int half_window = 4;
    for (int x = 0; x < grey.cols; ++x)
      {
        const auto column =
          depth_profile(smooth,
                        result.surface,
                        std::max(0, x - half_window),
                        std::min(grey.cols, x + half_window + 1));
        const double top = mean_of(column, 4, 10);
        if (std::abs(top - bulk) < least_step)
          continue;
        std::size_t y = 4;
        while (y + 4 < column.size() &&
               (mean_of(column, y, y + 4) - bulk) * (top - bulk) >
                 0.5 * (top - bulk) * (top - bulk))
          ++y;
        result.layer[x] = double(y) + 1.5;
      }
    result.layer_median = quantile(result.layer, 0.5);
    result.layer_10     = quantile(result.layer, 0.1);
    result.layer_90     = quantile(result.layer, 0.9);

    const int n_bands = std::max(1, int(grey.rows / band));
    result.crack_length.assign(n_bands, 0.);
    result.band_area.assign(n_bands, 0.);
    const cv::Mat lengths = pixel_lengths(centre_line);
    for (int x = 0; x < grey.cols; ++x)
      for (int y = int(std::ceil(result.surface[x])); y < grey.rows; ++y)
        {
          const int b = int((y - result.surface[x]) / band);
          if (b >= n_bands)
            break;
          result.band_area[b] += 1.;
          result.crack_length[b] += lengths.at<float>(y, x);
        }
    return result;
  }
} // namespace squeal::tribology
