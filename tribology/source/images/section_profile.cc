// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/section_profile.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace squeal::tribology
{
  namespace
  {
    constexpr int    least_step     = 12;  // grey levels between layer and bulk
    constexpr double face_smoothing = 1.5; // pixels
    // Strata above the material: pixels, deviations, shares of the pixels.
    constexpr int    blurred_edge = 6, strip_end = 10;
    constexpr int    dark_edge = 3; // pixels under the face
    constexpr double apart = 4., most_of_stratum = 0.8;
    // Resin is darker than so much of the bulk, and seen in most columns.
    constexpr double brightest_resin = 0.35, few_columns = 0.1;

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



    /** Row in each column where @p smooth first exceeds @p threshold, 0 where it
     * never does; a median over neighbours. */
    std::vector<double>
    rows_below(const cv::Mat1f &smooth, const double threshold)
    {
      cv::Mat1f rows(1, smooth.cols, 0.F);
      for (int x = 0; x < smooth.cols; ++x)
        {
          int y = 0;
          while (y < smooth.rows && cvRound(smooth(y, x)) <= threshold)
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



    double
    otsu_threshold(const cv::Mat &values)
    {
      cv::Mat bytes, above;
      values.convertTo(bytes, CV_8U);
      return cv::threshold(
        bytes, above, 0, 255, cv::THRESH_BINARY | cv::THRESH_OTSU);
    }



    /** The share of the values above a threshold. */
    double
    share_above(const std::vector<float> &values, const double threshold)
    {
      double n = 0.;
      for (const float v : values)
        n += v > threshold;
      return values.empty() ? 0. : n / double(values.size());
    }



    /** Of the pixels above a surface: all but its blurred edge, those next to
     * it, and those at the upper edge of the picture. */
    struct Strip
    {
      std::vector<float> all, lower, upper;

      Strip(const cv::Mat1f &smooth, const std::vector<double> &surface)
      {
        for (int x = 0; x < smooth.cols; ++x)
          for (int y = 0; y < int(surface[x]) - blurred_edge; ++y)
            {
              all.push_back(smooth(y, x));
              if (y < strip_end)
                upper.push_back(smooth(y, x));
              if (y >= int(surface[x]) - blurred_edge - strip_end)
                lower.push_back(smooth(y, x));
            }
      }

      double
      mean() const
      {
        return all.empty() ? 0. : cv::mean(cv::Mat(all))[0];
      }

      /** The brightness between two strata of which the lower one is brighter;
       * nothing where there is one. */
      std::optional<double>
      between_strata() const
      {
        if (all.empty())
          return {};
        const double threshold = otsu_threshold(cv::Mat(all));
        double       n[2] = {}, sum[2] = {}, squares[2] = {};
        for (const float v : all)
          {
            const int k = v > threshold;
            n[k] += 1.;
            sum[k] += v;
            squares[k] += double(v) * v;
          }
        if (n[0] == 0. || n[1] == 0.)
          return {};
        const double step   = sum[1] / n[1] - sum[0] / n[0];
        const double within = (squares[0] - sum[0] * sum[0] / n[0] +
                               squares[1] - sum[1] * sum[1] / n[1]) /
                              (n[0] + n[1]);
        if (step < least_step || step * step < apart * apart * within ||
            share_above(lower, threshold) < most_of_stratum ||
            share_above(upper, threshold) > 1. - most_of_stratum)
          return {};
        return threshold;
      }
    };



    /** Row below the resin in each column, by Otsu's threshold. A dark layer
     * under darker resin is below that threshold, too. */
    std::vector<double>
    find_surface(const cv::Mat1f &smooth)
    {
      const std::vector<double> surface =
        rows_below(smooth, otsu_threshold(smooth));
      const auto between = Strip(smooth, surface).between_strata();
      return between ? rows_below(smooth, *between) : surface;
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



  namespace
  {
    double
    share_of_zeros(const std::vector<double> &values)
    {
      return double(std::count(values.begin(), values.end(), 0.)) /
             double(values.size());
    }



    /** Of the specimen in a column with the face at @p surface. */
    int
    first_row(const double surface)
    {
      return int(std::ceil(surface));
    }



    std::string
    per_cent(const double share)
    {
      return rounded_text(100. * share, 2) + " %";
    }



    std::vector<std::string>
    doubts_of(const SectionProfile &p, const cv::Mat1f &smooth, double bulk)
    {
      std::vector<std::string> doubts;
      const double             no_resin = share_of_zeros(p.surface);
      if (no_resin > few_columns)
        doubts.push_back(
          "no dark resin is seen above the face in " + per_cent(no_resin) +
          " of the columns: depths are those below the upper edge of the "
          "picture there, and bright resin would be taken for the layer; cut "
          "the picture at the face, or blacken the resin");
      const Strip  strip(smooth, p.surface);
      const double none = share_of_zeros(p.layer);
      if (no_resin < 1. - few_columns && p.layer_median > 0. &&
          strip.mean() > brightest_resin * bulk)
        doubts.push_back("what is taken for resin has " +
                         per_cent(strip.mean() / bulk) +
                         " of the brightness of the material and may belong to "
                         "it: blacken the resin");
      if (p.layer_median == 0.)
        doubts.push_back(
          "no layer is found in " + per_cent(none) +
          " of the columns; if the dark strip at the top is a layer and no "
          "resin, neither the layer nor the depths are right, and the strip is "
          "in no figure: take a picture with resin above the layer, or blacken "
          "the resin");
      else if (p.layer_10 == 0.)
        doubts.push_back("no layer is found in " + per_cent(none) +
                         " of the columns: look whether it is missing there or "
                         "as bright as the bulk");
      return doubts;
    }
  } // namespace



  SectionProfile
  profile_section(const cv::Mat    &grey,
                  const cv::Mat    &centre_line,
                  const double      band,
                  const SeenPixels &seen)
  {
    cv::Mat smooth;
    cv::GaussianBlur(grey, smooth, cv::Size(), face_smoothing);
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
    result.doubts       = doubts_of(result, smooth, bulk);

    // Each pixel belongs to the band that its upper edge lies in.
    const int n_bands = int(std::ceil(grey.rows / band));
    result.crack_length.assign(n_bands, 0.);
    result.band_area.assign(n_bands, 0.);
    result.band_depth.assign(n_bands, 0.);
    const cv::Mat lengths = pixel_lengths(centre_line);
    for (int x = 0; x < grey.cols; ++x)
      for (int y = first_row(result.surface[x]); y < grey.rows; ++y)
        {
          if (!seen.empty() && seen.at<uchar>(y, x) == 0)
            continue;
          const double depth = y - result.surface[x];
          const int    b     = int(depth / band);
          result.band_area[b] += 1.;
          result.band_depth[b] += depth + 0.5;
          result.crack_length[b] += lengths.at<float>(y, x);
        }
    for (int b = 0; b < n_bands; ++b)
      result.band_depth[b] /= std::max(1., result.band_area[b]);
    return result;
  }



  SectionView
  below_face(const cv::Mat &grey, const SeenPixels &seen)
  {
    cv::Mat smooth;
    cv::GaussianBlur(grey, smooth, cv::Size(), face_smoothing);
    const std::vector<double> surface = find_surface(smooth);
    SectionView               specimen;
    specimen.seen  = cv::Mat::zeros(grey.size(), CV_8U);
    cv::Mat inside = specimen.seen.clone();
    for (int x = 0; x < grey.cols; ++x)
      {
        const int face = first_row(surface[x]);
        // Where the picture begins below the face there is no blurred edge.
        const int sharp = face == 0 ? 0 : std::min(grey.rows, face + dark_edge);
        specimen.seen(cv::Range(face, grey.rows), cv::Range(x, x + 1))
          .setTo(255);
        inside(cv::Range(sharp, grey.rows), cv::Range(x, x + 1)).setTo(255);
      }
    if (!seen.empty())
      {
        specimen.seen &= seen;
        inside &= seen;
      }
    if (cv::countNonZero(inside) == 0)
      return {};
    specimen.grey = mirrored_beyond(grey, inside);
    return specimen;
  }
} // namespace squeal::tribology
