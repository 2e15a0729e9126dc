// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/filter_noise.h>
#include <squeal/tribology/images/path_evidence.h>
#include <squeal/tribology/images/ridge_filter.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace squeal::tribology
{
  namespace
  {
    constexpr int    n_ridge_directions = RidgeField::n_directions;
    constexpr double half_length        = 3.; // of a line, in its deviations
    // Samples are at least a deviation apart.
    constexpr std::size_t most_taps      = 2 * std::size_t(half_length) + 1;
    constexpr double      flank_distance = 2.;  // in deviations
    constexpr double      second_width   = 1.5; // of a level, over the first
    constexpr float       mean_flank  = 0.2F; // weight beside the lesser flank
    constexpr int         strip       = 32;   // rows, fits a cache
    constexpr double      noise_block = 64.;  // pixels of the finest level


    cv::Mat
    enlarged(const cv::Mat &values, const cv::Size &size)
    {
      cv::Mat result;
      cv::resize(values, result, size, 0., 0., cv::INTER_LINEAR);
      return result;
    }



    /** The larger of what is there, if anything, and of @p values of the same
     * or half the size. */
    void
    keep_larger(cv::Mat &largest, const cv::Mat &values)
    {
      if (largest.empty())
        largest = values;
      else
        cv::max(largest,
                values.size() == largest.size()
                  ? values
                  : enlarged(values, largest.size()),
                largest);
    }



    /** Filters of one width; lengths in pixels of the given image. */
    class LineFilter
    {
    public:
      LineFilter(const cv::Mat &grey,
                 const double   deviation,
                 const double   block)
        : size(grey.size())
        , flank(flank_distance * deviation)
        , step(std::max(1., deviation))
        , n_taps(2 * cvRound(half_length * deviation / step) + 1)
        , margin(int(std::ceil(flank)) + 1)
        , wide(margin + int(std::ceil(half_length * deviation)) + 2)
        , mean(size.width)
        , answers(size, block)
      {
        cv::Mat smooth;
        cv::GaussianBlur(grey,
                         smooth,
                         cv::Size(),
                         deviation,
                         deviation,
                         cv::BORDER_REFLECT_101);
        cv::copyMakeBorder(
          smooth, padded, wide, wide, wide, wide, cv::BORDER_REFLECT_101);
      }

      /** Compares lines along @p angle with their flanks. */
      void
      compare(const double angle)
      {
        nx = cvRound(-flank * std::sin(angle));
        ny = cvRound(flank * std::cos(angle));
        mixed.create(size, CV_32F);
        const std::vector<cv::Point> taps = taps_along(angle);
        for (int y = 0; y < size.height; y += strip)
          compare_strip(y, std::min(y + strip, size.height), taps);
        noise = answers.finish();
      }

      /** Contrast over noise in row @p y, for the angle that was compared. */
      void
      contrast(const int y, float *values) const
      {
        const float *m                    = mixed.ptr<float>(y);
        const auto [before, after, share] = noise.beside(y);
        for (int x = 0; x < size.width; ++x)
          values[x] = m[x] / (before[x] * (1.F - share) + after[x] * share);
        silence_border(values, y);
      }

    private:
      /** Places that are averaged for the first pixel of a row of lines. */
      std::vector<cv::Point>
      taps_along(const double angle) const
      {
        const int              border = wide - margin;
        std::vector<cv::Point> taps;
        for (int i = 0; i < n_taps; ++i)
          {
            const double u = (i - 0.5 * (n_taps - 1)) * step;
            taps.emplace_back(border + cvRound(u * std::cos(angle)),
                              border + cvRound(u * std::sin(angle)));
          }
        return taps;
      }



      /** Rows @p begin to @p end of the weighted means over both flanks, and
       * the noise of the means. A strip of averages stays in the cache. */
      void
      compare_strip(const int                     begin,
                    const int                     end,
                    const std::vector<cv::Point> &taps)
      {
        line.create(strip + 2 * margin, size.width + 2 * margin, CV_32F);
        for (int y = 0; y < end - begin + 2 * margin; ++y)
          average_row<most_taps>(taps, begin + y, line.ptr<float>(y));
        for (int y = begin; y < end; ++y)
          {
            const int    row = y - begin + margin;
            const float *c   = line.ptr<float>(row) + margin;
            const float *a   = line.ptr<float>(row + ny) + margin + nx;
            const float *b   = line.ptr<float>(row - ny) + margin - nx;
            float       *m   = mixed.ptr<float>(y);
            for (int x = 0; x < size.width; ++x)
              {
                const float both  = 0.5F * (a[x] + b[x]) - c[x];
                const float least = std::min(a[x], b[x]) - c[x];
                mean[x]           = both;
                m[x] = mean_flank * both + (1.F - mean_flank) * least;
              }
            answers.add_row(mean.data());
          }
      }



      /** Averages over a line centred at each pixel of a row, with the margin.
       * A number of taps that is known when this is compiled takes half the
       * time. */
      template <std::size_t n>
      void
      average_row(const std::vector<cv::Point> &taps,
                  const int                     y,
                  float                        *averages) const
      {
        if constexpr (n > 1)
          if (taps.size() != n)
            return average_row<n - 2>(taps, y, averages);
        std::array<const float *, n> values;
        for (std::size_t i = 0; i < n; ++i)
          values[i] = padded.ptr<float>(y + taps[i].y) + taps[i].x;
        constexpr float share = 1.F / n;
        for (int x = 0; x < line.cols; ++x)
          {
            float sum = 0.F;
            for (const float *value : values)
              sum += share * value[x];
            averages[x] = sum;
          }
      }



      /** No evidence in row @p y where a flank would lie outside. */
      void
      silence_border(float *row, const int y) const
      {
        const bool is_border =
          y < std::abs(ny) || y >= size.height - std::abs(ny);
        const int w =
          is_border ? size.width : std::min(std::abs(nx), size.width);
        for (int x = 0; x < w; ++x)
          {
            row[x]       = std::min(row[x], 0.F);
            float &other = row[size.width - 1 - x];
            other        = std::min(other, 0.F);
          }
      }

      cv::Size size;
      double   flank, step;
      int      n_taps, margin, wide;
      int      nx = 0, ny = 0; // of a flank
      cv::Mat  padded;
      // Of one direction, kept for the next.
      cv::Mat            line, mixed;
      std::vector<float> mean; // of a row
      FilterNoise        answers;
      NoiseRows          noise;
    };



    /** The better of two widths, as stored in OrientedContrast, goes to
     * @p plane, and before the limits to @p unlimited where that is less. */
    void
    keep_better(const LineFilter &narrow,
                const LineFilter &wide,
                cv::Mat          &plane,
                cv::Mat          &unlimited)
    {
      constexpr auto     lowest  = float(OrientedContrast::least);
      constexpr auto     highest = float(OrientedContrast::most);
      std::vector<float> other(unlimited.cols);
      cv::Mat            better(1, unlimited.cols, CV_32F);
      plane.create(unlimited.size(), CV_16S);
      for (int y = 0; y < unlimited.rows; ++y)
        {
          float *b = better.ptr<float>(), *u = unlimited.ptr<float>(y);
          narrow.contrast(y, b);
          wide.contrast(y, other.data());
          for (int x = 0; x < unlimited.cols; ++x)
            {
              const float value = std::max(b[x], other[x]);
              u[x]              = std::max(u[x], value);
              b[x]              = std::min(std::max(value, lowest), highest);
            }
          cv::Mat row = plane.row(y);
          better.convertTo(row, CV_16S, OrientedContrast::per_unit);
        }
    }



    OrientedContrast
    contrast_of_level(const cv::Mat &level,
                      const double   narrowest,
                      const double   block,
                      cv::Mat       &unlimited)
    {
      LineFilter narrow(level, narrowest, block),
        wide(level, second_width * narrowest, block);
      unlimited = cv::Mat(level.size(), CV_32F, cv::Scalar(-1e9));
      OrientedContrast contrast;
      for (int t = 0; t < n_ridge_directions; ++t)
        {
          const double angle = CV_PI * t / n_ridge_directions;
          narrow.compare(angle);
          wide.compare(angle);
          keep_better(narrow, wide, contrast.planes[t], unlimited);
        }
      return contrast;
    }



    /** No evidence where nothing is seen. */
    void
    silence_unseen(OrientedContrast &contrast,
                   cv::Mat          &unlimited,
                   const SeenPixels &seen)
    {
      if (seen.empty())
        return;
      cv::Mat unseen;
      cv::resize(~seen, unseen, unlimited.size(), 0., 0., cv::INTER_NEAREST);
      for (cv::Mat &plane : contrast.planes)
        cv::Mat(cv::min(plane, 0.)).copyTo(plane, unseen);
      cv::Mat(cv::min(unlimited, 0.)).copyTo(unlimited, unseen);
    }
  } // namespace



  double
  RidgeField::angle(const cv::Point &p) const
  {
    return CV_PI * direction.at<uchar>(p) / n_ridge_directions;
  }



  cv::Point
  RidgeField::across(const cv::Point &p, const double distance) const
  {
    static const auto normals = [] {
      std::array<cv::Point2d, n_ridge_directions> table;
      for (int t = 0; t < n_ridge_directions; ++t)
        table[t] = {-std::sin(CV_PI * t / n_ridge_directions),
                    std::cos(CV_PI * t / n_ridge_directions)};
      return table;
    }();
    const cv::Point2d &n = normals[direction.at<uchar>(p)];
    return {cvRound(distance * n.x), cvRound(distance * n.y)};
  }



  bool
  RidgeField::is_crest(const cv::Point &p) const
  {
    const cv::Point across = this->across(p, 1.);
    const cv::Rect  inside({0, 0}, strength.size());
    const float     z  = sharp.at<float>(p);
    const auto      at = [&](const cv::Point &q) {
      return inside.contains(q) ? sharp.at<float>(q) : -1e9F;
    };
    return z >= at(p + across) && z > at(p - across);
  }



  RidgeField
  filter_ridges(const cv::Mat    &grey,
                const int         n_octaves,
                const double      narrowest,
                const SeenPixels &seen)
  {
    OrientedContrast contrast;
    cv::Mat          level  = grey, unlimited, coarse;
    double           factor = 1.;
    for (int octave = 0; octave < n_octaves; ++octave)
      {
        cv::Mat          found_unlimited;
        OrientedContrast found =
          contrast_of_level(level,
                            narrowest,
                            std::max(16., noise_block / factor),
                            found_unlimited);
        silence_unseen(found, found_unlimited, seen);
        for (int t = 0; t < n_ridge_directions; ++t)
          keep_larger(contrast.planes[t], found.planes[t]);
        keep_larger(unlimited, found_unlimited);
        if (octave == 1)
          coarse = enlarged(integrate_paths(found).mean, grey.size());
        if (std::min(level.rows, level.cols) < 80)
          break;
        cv::Mat half;
        cv::resize(level,
                   half,
                   cv::Size((level.cols + 1) / 2, (level.rows + 1) / 2),
                   0.,
                   0.,
                   cv::INTER_AREA);
        level = half;
        factor *= 2.;
      }
    PathEvidence evidence = integrate_paths(contrast);
    if (coarse.empty())
      coarse = evidence.mean;
    return {evidence.mean,
            evidence.sharp,
            evidence.local,
            evidence.direction,
            unlimited,
            coarse,
            flank_distance * narrowest};
  }
} // namespace squeal::tribology
