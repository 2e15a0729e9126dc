// SPDX-License-Identifier: LGPL-2.1-or-later
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
    constexpr double half_length        = 3.;  // of a line, in its deviations
    constexpr double flank_distance     = 2.;  // in deviations
    constexpr double second_width       = 1.5; // of a level, over the first
    constexpr float  mean_flank    = 0.2F;     // weight beside the lesser flank
    constexpr float  heaviest_tail = 3.F;      // 90th percentile over median
    constexpr double noise_block   = 64.;      // pixels of the finest level
    // Of the noise of the median block.
    constexpr float quietest_block = 0.3F, loudest_block = 3.F;


    /** Spread of |values| by block from their 90th percentile, which is 1.645
     * deviations of a normal distribution and follows heavy tails, but not
     * those that cracks themselves make; interpolated. A block never counts as
     * much quieter than the others, nor as much louder: a dense network of
     * cracks would pass for noise. */
    cv::Mat
    local_noise(const cv::Mat &values, const double block)
    {
      const int          nx = std::max(1, cvRound(values.cols / block));
      const int          ny = std::max(1, cvRound(values.rows / block));
      cv::Mat1f          grid(ny, nx);
      std::vector<float> sample;
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
          {
            sample.clear();
            const int x1 = (i + 1) * values.cols / nx;
            const int y1 = (j + 1) * values.rows / ny;
            for (int y = j * values.rows / ny; y < y1; y += 2)
              {
                const float *row = values.ptr<float>(y);
                for (int x = i * values.cols / nx + (y / 2) % 2; x < x1; x += 2)
                  sample.push_back(std::abs(row[x]));
              }
            if (sample.empty())
              continue;
            const auto nth    = sample.begin() + (9 * sample.size()) / 10;
            const auto middle = sample.begin() + sample.size() / 2;
            std::nth_element(sample.begin(), middle, sample.end());
            std::nth_element(middle, nth, sample.end());
            grid(j, i) =
              std::min(*nth / 1.645F, heaviest_tail * *middle / 0.6745F);
          }
      std::vector<float> all(grid.begin(), grid.end());
      std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
      // Below a thousandth of a grey level there is only rounding.
      const float usual = all[all.size() / 2];
      cv::max(grid, std::max(quietest_block * usual, 1e-3F), grid);
      cv::min(grid, std::max(loudest_block * usual, 1e-3F), grid);
      cv::GaussianBlur(
        grid, grid, cv::Size(3, 3), 0., 0., cv::BORDER_REPLICATE);
      cv::Mat noise;
      cv::resize(grid, noise, values.size(), 0., 0., cv::INTER_LINEAR);
      return noise;
    }



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
        largest = values.clone();
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
        , block(block)
        , flank(flank_distance * deviation)
        , step(std::max(1., deviation))
        , n_taps(2 * cvRound(half_length * deviation / step) + 1)
        , margin(int(std::ceil(flank)) + 1)
        , wide(margin + int(std::ceil(half_length * deviation)) + 2)
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

      /** Contrast over noise, limited, as stored in OrientedContrast; before
       * that the larger of it and what is there goes to @p unlimited. */
      cv::Mat
      contrast(const double angle, cv::Mat &unlimited)
      {
        average(angle);
        const int nx = cvRound(-flank * std::sin(angle));
        const int ny = cvRound(flank * std::cos(angle));
        mixed.create(size, CV_32F);
        mean.create(size, CV_32F);
        for (int y = 0; y < size.height; ++y)
          {
            const float *c  = line.ptr<float>(y + margin) + margin;
            const float *a  = line.ptr<float>(y + margin + ny) + margin + nx;
            const float *b  = line.ptr<float>(y + margin - ny) + margin - nx;
            float       *m  = mixed.ptr<float>(y);
            float       *mm = mean.ptr<float>(y);
            for (int x = 0; x < size.width; ++x)
              {
                const float both  = 0.5F * (a[x] + b[x]) - c[x];
                const float least = std::min(a[x], b[x]) - c[x];
                mm[x]             = both;
                m[x] = mean_flank * both + (1.F - mean_flank) * least;
              }
          }
        constexpr auto lowest  = float(OrientedContrast::least);
        constexpr auto highest = float(OrientedContrast::most);
        const cv::Mat  noise   = local_noise(mean, block);
        if (unlimited.empty())
          unlimited = cv::Mat(size, CV_32F, cv::Scalar(-1e9));
        for (int y = 0; y < size.height; ++y)
          {
            float       *m = mixed.ptr<float>(y), *u = unlimited.ptr<float>(y);
            const float *n = noise.ptr<float>(y);
            for (int x = 0; x < size.width; ++x)
              m[x] /= n[x];
            silence_border(m, y, std::abs(nx), std::abs(ny));
            for (int x = 0; x < size.width; ++x)
              {
                u[x] = std::max(u[x], m[x]);
                m[x] = std::min(std::max(m[x], lowest), highest);
              }
          }
        cv::Mat stored;
        mixed.convertTo(stored, CV_16S, OrientedContrast::per_unit);
        return stored;
      }

    private:
      /** Average over a line centred at each pixel, with the margin. */
      void
      average(const double angle)
      {
        const int      border = wide - margin;
        const cv::Size inner(padded.cols - 2 * border,
                             padded.rows - 2 * border);
        line.create(inner, CV_32F);
        std::vector<cv::Point> taps;
        const float            share = 1.F / n_taps;
        for (int i = 0; i < n_taps; ++i)
          {
            const double u = (i - 0.5 * (n_taps - 1)) * step;
            taps.emplace_back(border + cvRound(u * std::cos(angle)),
                              border + cvRound(u * std::sin(angle)));
          }
        for (int y = 0; y < inner.height; ++y)
          {
            float *row = line.ptr<float>(y);
            std::fill(row, row + inner.width, 0.F);
            for (const cv::Point &tap : taps)
              {
                const float *value = padded.ptr<float>(y + tap.y) + tap.x;
                for (int x = 0; x < inner.width; ++x)
                  row[x] += share * value[x];
              }
          }
      }



      /** No evidence in row @p y where a flank would lie outside. */
      void
      silence_border(float *row, const int y, const int nx, const int ny) const
      {
        const bool is_border = y < ny || y >= size.height - ny;
        const int  w = is_border ? size.width : std::min(nx, size.width);
        for (int x = 0; x < w; ++x)
          {
            row[x]       = std::min(row[x], 0.F);
            float &other = row[size.width - 1 - x];
            other        = std::min(other, 0.F);
          }
      }

      cv::Size size;
      double   block, flank, step;
      int      n_taps, margin, wide;
      cv::Mat  padded;
      cv::Mat  line, mixed, mean; // of one direction, kept for the next
    };



    /** The better of two widths. */
    OrientedContrast
    contrast_of_level(const cv::Mat &level,
                      const double   narrowest,
                      const double   block,
                      cv::Mat       &unlimited)
    {
      LineFilter narrow(level, narrowest, block),
        wide(level, second_width * narrowest, block);
      OrientedContrast contrast;
      for (int t = 0; t < n_ridge_directions; ++t)
        {
          const double angle = CV_PI * t / n_ridge_directions;
          cv::max(narrow.contrast(angle, unlimited),
                  wide.contrast(angle, unlimited),
                  contrast.planes[t]);
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
