// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/areas.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr double deviations_needed = 3.;
    constexpr double smoothing         = 2.;  // pixels
    constexpr double inner_share       = 0.7; // of the threshold, for edges
    constexpr int    roughness_window  = 9;   // pixels
    constexpr double plateau_roughness = 1.3; // of the bulk's
    constexpr double least_thickness   = 3.;  // pixels, radius

    double
    median_of(const cv::Mat1f &values)
    {
      std::vector<float> sample;
      for (int y = 0; y < values.rows; y += 2)
        for (int x = y / 2 % 2; x < values.cols; x += 2)
          sample.push_back(values(y, x));
      const auto middle = sample.begin() + sample.size() / 2;
      std::nth_element(sample.begin(), middle, sample.end());
      return *middle;
    }



    /** Most frequent value and the deviation of the peak around it, from its
     * width at six tenths of its height. */
    std::pair<double, double>
    main_peak(const cv::Mat1f &values)
    {
      constexpr int    n     = 400;
      constexpr double range = 1.; // -1 .. 1
      cv::Mat1f        counts(1, n, 0.F);
      for (const float v : values)
        {
          const int i = int((v + range) / (2. * range) * n);
          if (i >= 0 && i < n)
            counts(0, i) += 1.F;
        }
      cv::GaussianBlur(counts, counts, cv::Size(0, 0), 1.5, 0.1);
      const int top =
        int(std::max_element(counts.begin(), counts.end()) - counts.begin());
      const float level = 0.6065F * counts(0, top);
      int         left = top, right = top;
      while (left > 0 && counts(0, left) > level)
        --left;
      while (right < n - 1 && counts(0, right) > level)
        ++right;
      const double width = 2. * range / n;
      // A second peak close by widens one side only.
      const double deviation = std::max(1, std::min(top - left, right - top));
      return {(top + 0.5) * width - range, deviation * width};
    }



    cv::Mat
    local_roughness(const cv::Mat &flat)
    {
      const cv::Size window(roughness_window, roughness_window);
      cv::Mat        mean, square;
      cv::blur(flat, mean, window, {-1, -1}, cv::BORDER_REFLECT_101);
      cv::sqrBoxFilter(
        flat, square, CV_32F, window, {-1, -1}, true, cv::BORDER_REFLECT_101);
      square -= mean.mul(mean);
      cv::max(square, 0., square);
      cv::sqrt(square, square);
      return square;
    }



    /** Parts of @p weak that touch @p strong, without thin and small ones,
     * holes closed. */
    cv::Mat
    clean(const cv::Mat &weak, const cv::Mat &strong, const double smallest)
    {
      const int     r    = int(least_thickness);
      const cv::Mat disc = cv::getStructuringElement(
        cv::MORPH_ELLIPSE, cv::Size(2 * r + 1, 2 * r + 1));
      cv::Mat open;
      cv::morphologyEx(weak, open, cv::MORPH_CLOSE, disc);
      cv::morphologyEx(open, open, cv::MORPH_OPEN, disc);
      cv::Mat1i labels, stats;
      cv::Mat   centroids;
      const int n =
        cv::connectedComponentsWithStats(open, labels, stats, centroids, 8);
      std::vector<int> n_strong(n, 0);
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          if (strong.at<uchar>(y, x) != 0)
            ++n_strong[labels(y, x)];
      cv::Mat result = cv::Mat::zeros(weak.size(), CV_8U);
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          {
            const int l = labels(y, x);
            if (l > 0 && stats(l, cv::CC_STAT_AREA) >= smallest &&
                n_strong[l] >= 0.2 * stats(l, cv::CC_STAT_AREA))
              result.at<uchar>(y, x) = 255;
          }
      return result;
    }
  } // namespace



  cv::Mat
  flatten_illumination(const cv::Mat &grey)
  {
    constexpr int n_terms = 6;
    const auto    terms   = [&](const int x, const int y) {
      const double u = 2. * x / grey.cols - 1., v = 2. * y / grey.rows - 1.;
      return std::array<double, n_terms>{1., u, v, u * u, u * v, v * v};
    };
    const int step = std::max(1, std::min(grey.rows, grey.cols) / 100);
    cv::Mat   smooth;
    cv::blur(grey, smooth, cv::Size(step, step));
    std::vector<std::array<double, n_terms>> rows;
    std::vector<double>                      values;
    for (int y = step / 2; y < grey.rows; y += step)
      for (int x = step / 2; x < grey.cols; x += step)
        {
          rows.push_back(terms(x, y));
          values.push_back(std::log(std::max(1.F, smooth.at<float>(y, x))));
        }
    cv::Mat1d           coefficients = cv::Mat1d::zeros(n_terms, 1);
    std::vector<double> weights(values.size(), 1.);
    for (int iteration = 0; iteration < 12; ++iteration)
      {
        cv::Mat1d normal = cv::Mat1d::zeros(n_terms, n_terms);
        cv::Mat1d right  = cv::Mat1d::zeros(n_terms, 1);
        for (std::size_t i = 0; i < values.size(); ++i)
          for (int a = 0; a < n_terms; ++a)
            {
              right(a) += weights[i] * rows[i][a] * values[i];
              for (int b = 0; b < n_terms; ++b)
                normal(a, b) += weights[i] * rows[i][a] * rows[i][b];
            }
        cv::solve(normal, right, coefficients, cv::DECOMP_SVD);
        std::vector<double> residuals(values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
          {
            residuals[i] = values[i];
            for (int a = 0; a < n_terms; ++a)
              residuals[i] -= coefficients(a) * rows[i][a];
          }
        std::vector<double> sizes;
        for (const double r : residuals)
          sizes.push_back(std::abs(r));
        const auto middle = sizes.begin() + sizes.size() / 2;
        std::nth_element(sizes.begin(), middle, sizes.end());
        const double scale = std::max(1e-4, 3. * 1.4826 * *middle);
        for (std::size_t i = 0; i < residuals.size(); ++i)
          {
            const double u = residuals[i] / scale;
            weights[i]     = u * u < 1. ? (1. - u * u) * (1. - u * u) : 0.;
          }
      }
    cv::Mat flat(grey.size(), CV_32F);
    for (int y = 0; y < grey.rows; ++y)
      for (int x = 0; x < grey.cols; ++x)
        {
          const auto t   = terms(x, y);
          double     sum = 0.;
          for (int a = 0; a < n_terms; ++a)
            sum += coefficients(a) * t[a];
          flat.at<float>(y, x) =
            float(grey.at<float>(y, x) / std::exp(sum) - 1.);
        }
    return flat;
  }



  AreaMap
  find_areas(const cv::Mat      &grey,
             const cv::Mat      &cracks,
             const AreaSettings &settings)
  {
    cv::Mat flat = flatten_illumination(grey);
    // Cracks are filled from their surroundings by normalised smoothing.
    cv::Mat line;
    cv::dilate(cracks, line, cv::Mat());
    flat.setTo(0., line);
    cv::Mat weight(flat.size(), CV_32F, cv::Scalar(1.));
    weight.setTo(1e-3, line);
    cv::Mat smooth, norm;
    cv::GaussianBlur(
      flat, smooth, cv::Size(), smoothing, smoothing, cv::BORDER_REFLECT_101);
    cv::GaussianBlur(
      weight, norm, cv::Size(), smoothing, smoothing, cv::BORDER_REFLECT_101);
    cv::divide(smooth, norm, smooth);
    const auto [bulk, deviation] = main_peak(smooth);
    const cv::Mat rough          = local_roughness(flat);
    const double  usual          = median_of(rough);

    const double dark =
      std::max(settings.dark_contrast, deviations_needed * deviation);
    const double bright =
      std::max(settings.bright_contrast, deviations_needed * deviation);
    AreaMap map;
    map.exfoliation    = clean(smooth < bulk - inner_share * dark,
                            smooth < bulk - dark,
                            settings.smallest_area);
    const cv::Mat even = rough < plateau_roughness * usual;
    map.plateau        = clean((smooth > bulk + inner_share * bright) & even,
                        (smooth > bulk + bright) & even,
                        settings.smallest_area);
    return map;
  }



  std::vector<double>
  part_areas(const cv::Mat &mask)
  {
    cv::Mat1i labels, stats;
    cv::Mat   centroids;
    const int n =
      cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8);
    std::vector<double> areas;
    for (int i = 1; i < n; ++i)
      areas.push_back(stats(i, cv::CC_STAT_AREA));
    std::sort(areas.rbegin(), areas.rend());
    return areas;
  }
} // namespace squeal::tribology
