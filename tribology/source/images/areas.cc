// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/area_evidence.h>
#include <squeal/tribology/images/areas.h>
#include <squeal/tribology/images/brightness_levels.h>

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
    constexpr double rough_pit         = 1.5; // of the bulk's
    constexpr double half_depth        = 0.5;
    constexpr int    depth_rounds      = 3;   // the last changes areas by 0.5 %
    constexpr double least_thickness   = 3.;  // pixels, radius
    constexpr double rim_smoothing     = 1.;  // pixels, to see a step at a rim
    constexpr double outline_error     = 0.7; // pixels
    constexpr double unsettled_error   = 0.3; // of the area of dark places
    // That the darker of two levels is what came off, where it has more of the
    // area: pits in a surface look as plateaus above one.
    constexpr double level_odds = 0.5;
    // By how much, of itself, the contrast that makes a plateau is not known.
    constexpr double limit_error = 0.5;

    bool
    is_seen(const SeenPixels &seen, const int y, const int x)
    {
      return seen.empty() || seen.at<uchar>(y, x) != 0;
    }



    /** Of the values where something is @p seen. */
    double
    median_of(const cv::Mat1f &values, const SeenPixels &seen)
    {
      std::vector<float> sample;
      for (int y = 0; y < values.rows; y += 2)
        for (int x = y / 2 % 2; x < values.cols; x += 2)
          if (is_seen(seen, y, x))
            sample.push_back(values(y, x));
      if (sample.empty())
        return 0.;
      const auto middle = sample.begin() + sample.size() / 2;
      std::nth_element(sample.begin(), middle, sample.end());
      return *middle;
    }



    /** Least squares with Tukey's weights. */
    template <std::size_t n>
    cv::Mat1d
    robust_fit(const std::vector<std::array<double, n>> &rows,
               const std::vector<double>                &values)
    {
      cv::Mat1d           c = cv::Mat1d::zeros(int(n), 1);
      std::vector<double> weights(values.size(), 1.), sizes(values.size());
      for (int iteration = 0; iteration < 15; ++iteration)
        {
          cv::Mat1d normal = cv::Mat1d::eye(int(n), int(n)) * 1e-9;
          cv::Mat1d right  = cv::Mat1d::zeros(int(n), 1);
          for (std::size_t i = 0; i < values.size(); ++i)
            for (std::size_t a = 0; a < n; ++a)
              {
                right(a) += weights[i] * rows[i][a] * values[i];
                for (std::size_t b = 0; b < n; ++b)
                  normal(a, b) += weights[i] * rows[i][a] * rows[i][b];
              }
          cv::solve(normal, right, c, cv::DECOMP_SVD);
          std::vector<double> residuals(values);
          for (std::size_t i = 0; i < values.size(); ++i)
            {
              for (std::size_t a = 0; a < n; ++a)
                residuals[i] -= c(a) * rows[i][a];
              sizes[i] = std::abs(residuals[i]);
            }
          const auto middle = sizes.begin() + sizes.size() / 2;
          std::nth_element(sizes.begin(), middle, sizes.end());
          const double scale = std::max(1e-5, 4. * 1.4826 * *middle);
          for (std::size_t i = 0; i < residuals.size(); ++i)
            {
              const double u = residuals[i] / scale;
              weights[i]     = u * u < 1. ? (1. - u * u) * (1. - u * u) : 0.;
            }
        }
      return c;
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



  namespace
  {
    /** Moves the edge of each part to half of its depth: the threshold that
     * finds it lies far out on the blurred edge of a deep pit. The depth is the
     * mean within that edge, the slope outside would make it less. */
    void
    sharpen_edges(cv::Mat &mask, const cv::Mat1f &depth)
    {
      cv::Mat1i           labels;
      const int           n = cv::connectedComponents(mask, labels, 8);
      std::vector<double> level(n, 0.);
      for (int round = 0; round < depth_rounds; ++round)
        {
          std::vector<double> sum(n, 0.), area(n, 0.);
          for (int y = 0; y < labels.rows; ++y)
            for (int x = 0; x < labels.cols; ++x)
              if (depth(y, x) >= level[labels(y, x)])
                {
                  sum[labels(y, x)] += depth(y, x);
                  area[labels(y, x)] += 1.;
                }
          for (int l = 0; l < n; ++l)
            level[l] = half_depth * sum[l] / std::max(1., area[l]);
        }
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          if (depth(y, x) < level[labels(y, x)])
            mask.at<uchar>(y, x) = 0;
      const int r = int(least_thickness);
      cv::morphologyEx(mask,
                       mask,
                       cv::MORPH_CLOSE,
                       cv::getStructuringElement(
                         cv::MORPH_ELLIPSE, cv::Size(2 * r + 1, 2 * r + 1)));
      std::vector<std::vector<cv::Point>> outlines;
      cv::findContours(
        mask, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
      cv::drawContours(mask, outlines, -1, 255, cv::FILLED);
    }



    /** Parts of @p mask whose mean of @p rough is above @p least. */
    cv::Mat
    rough_parts(const cv::Mat &mask, const cv::Mat1f &rough, const double least)
    {
      cv::Mat1i           labels;
      const int           n = cv::connectedComponents(mask, labels, 8);
      std::vector<double> sum(n, 0.), area(n, 0.);
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          {
            sum[labels(y, x)] += rough(y, x);
            area[labels(y, x)] += 1.;
          }
      cv::Mat result = cv::Mat::zeros(mask.size(), CV_8U);
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          {
            const int l = labels(y, x);
            if (l > 0 && sum[l] > least * area[l])
              result.at<uchar>(y, x) = 255;
          }
      return result;
    }



    /** Deviation, pixels: of the outlines, of dark places that may be areas all
     * the same (shading is wrong in all of them at once), of a bulk that may be
     * one, of what the border cuts, and of areas too small to be looked for. */
    double
    exfoliation_error(const AreaMap      &map,
                      const double        cut_off,
                      const AreaSettings &settings,
                      const SeenPixels   &seen)
    {
      const double bulk =
        map.bulk_is_darker
          ? map.darker_share * n_seen(seen, map.exfoliation.size())
          : 0.;
      return std::sqrt(
        std::pow(outline_error * outline_length(map.exfoliation, seen), 2) +
        level_odds * std::pow(bulk, 2) +
        std::pow(unsettled_error * cv::countNonZero(map.unsettled), 2) +
        std::pow(cut_off, 2) + std::pow(settings.smallest_area, 2));
    }
  } // namespace



  cv::Mat
  flatten_illumination(const cv::Mat &grey, const SeenPixels &seen)
  {
    constexpr int n_terms = 5;
    // With fewer differences of cells nothing tells a shading.
    constexpr std::size_t least_differences = 10 * n_terms;
    using Terms                             = std::array<double, n_terms>;
    const auto terms = [&](const double x, const double y) {
      const double u = 2. * x / grey.cols - 1., v = 2. * y / grey.rows - 1.;
      return Terms{u, v, u * u, u * v, v * v};
    };
    // Differences of neighbouring cells: an area of other brightness disturbs
    // those across its edge only.
    const int step = std::max(2, std::min(grey.rows, grey.cols) / 80);
    cv::Mat   cells;
    cv::resize(
      grey,
      cells,
      cv::Size(std::max(2, grey.cols / step), std::max(2, grey.rows / step)),
      0.,
      0.,
      cv::INTER_AREA);
    cv::max(cells, 1., cells);
    cv::log(cells, cells);
    cv::Mat1f shown(cells.size(), 255.F);
    if (!seen.empty())
      {
        cv::Mat share;
        seen.convertTo(share, CV_32F);
        cv::resize(share, shown, cells.size(), 0., 0., cv::INTER_AREA);
      }
    std::vector<Terms>  rows;
    std::vector<double> values;
    const double        sx = double(grey.cols) / cells.cols,
                 sy        = double(grey.rows) / cells.rows;
    for (int y = 0; y < cells.rows; ++y)
      for (int x = 0; x < cells.cols; ++x)
        for (const cv::Point &d : {cv::Point(1, 0), cv::Point(0, 1)})
          if (x + d.x < cells.cols && y + d.y < cells.rows &&
              shown(y, x) > 254.F && shown(y + d.y, x + d.x) > 254.F)
            {
              const Terms a = terms(sx * x, sy * y);
              Terms       b = terms(sx * (x + d.x), sy * (y + d.y));
              for (int k = 0; k < n_terms; ++k)
                b[k] -= a[k];
              rows.push_back(b);
              values.push_back(cells.at<float>(y + d.y, x + d.x) -
                               cells.at<float>(y, x));
            }
    const cv::Mat1d c = values.size() < least_differences
                          ? cv::Mat1d(cv::Mat1d::zeros(n_terms, 1))
                          : robust_fit(rows, values);
    cv::Mat         flat(grey.size(), CV_32F);
    for (int y = 0; y < grey.rows; ++y)
      for (int x = 0; x < grey.cols; ++x)
        {
          const Terms t   = terms(x, y);
          double      sum = 0.;
          for (int k = 0; k < n_terms; ++k)
            sum += c(k) * t[k];
          flat.at<float>(y, x) = float(grey.at<float>(y, x) * std::exp(-sum));
        }
    const double top  = 255.;
    const double bulk = levels_of(cv::Mat(flat * (1. / top)), seen).bulk * top;
    return flat * (1. / std::max(1., bulk)) - 1.;
  }



  AreaMap
  find_areas(const cv::Mat      &grey,
             const cv::Mat      &cracks,
             const AreaSettings &settings,
             const SeenPixels   &seen)
  {
    cv::Mat flat = flatten_illumination(grey, seen);
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
    const BrightnessLevels levels = levels_of(smooth, seen);
    const double           bulk   = levels.bulk;
    const cv::Mat          rough  = local_roughness(flat);
    const double           usual  = median_of(rough, seen);

    const double apart  = deviations_needed * levels.deviation;
    const double dark   = std::max(settings.dark_contrast, apart);
    const double bright = std::max(settings.bright_contrast, apart);
    AreaMap      map;
    map.exfoliation = clean(smooth < bulk - inner_share * dark,
                            smooth < bulk - dark,
                            settings.smallest_area);
    sharpen_edges(map.exfoliation, bulk - smooth);
    cv::Mat1f fine;
    cv::GaussianBlur(flat,
                     fine,
                     cv::Size(),
                     rim_smoothing,
                     rim_smoothing,
                     cv::BORDER_REFLECT_101);
    keep_seen(map.exfoliation, seen);
    const AreasWithoutRim left = take_without_rim(
      map.exfoliation, fine - bulk, line, settings.dark_contrast, seen);
    map.unsettled = left.taken;
    if (have_rim_between(levels, smooth, fine, settings.dark_contrast, seen))
      {
        map.darker_share   = levels.darker_share;
        map.bulk_is_darker = levels.bulk_is_darker();
      }
    map.rough          = rough_parts(map.exfoliation, rough, rough_pit * usual);
    const cv::Mat even = rough < plateau_roughness * usual;
    const auto    plateau_from = [&](const double least) {
      cv::Mat plateau = clean((smooth > bulk + inner_share * least) & even,
                              (smooth > bulk + least) & even,
                              settings.smallest_area);
      keep_seen(plateau, seen);
      return plateau;
    };
    map.plateau = plateau_from(bright);
    map.exfoliation_error =
      exfoliation_error(map, left.cut_off, settings, seen);
    // Without a rim a bright place may be light as well as a plateau.
    map.plateau_error = std::max<double>(
      cv::countNonZero(map.plateau),
      0.5 *
        std::abs(cv::countNonZero(plateau_from((1. - limit_error) * bright)) -
                 cv::countNonZero(plateau_from((1. + limit_error) * bright))));
    return map;
  }



  std::vector<double>
  part_areas(const cv::Mat &mask, const cv::Mat1d &pixel_areas)
  {
    cv::Mat1i labels, stats;
    cv::Mat   centroids;
    const int n =
      cv::connectedComponentsWithStats(mask, labels, stats, centroids, 8);
    std::vector<double> areas;
    for (int i = 1; i < n; ++i)
      areas.push_back(pixel_areas.empty() ? stats(i, cv::CC_STAT_AREA) : 0.);
    if (!pixel_areas.empty())
      for (int y = 0; y < labels.rows; ++y)
        for (int x = 0; x < labels.cols; ++x)
          if (labels(y, x) > 0)
            areas[labels(y, x) - 1] += pixel_areas(y, x);
    std::sort(areas.rbegin(), areas.rend());
    return areas;
  }
} // namespace squeal::tribology
