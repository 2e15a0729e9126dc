// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/path_evidence.h>
#include <squeal/tribology/images/ridge_filter.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <tuple>
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
    constexpr float       mean_flank = 0.2F;   // weight beside the lesser flank
    constexpr float       heaviest_tail = 3.F; // 90th percentile over median
    constexpr int         strip         = 32;  // rows, fits a cache
    constexpr double      noise_block   = 64.; // pixels of the finest level
    // Of the noise of the median block.
    constexpr float quietest_block = 0.3F, loudest_block = 3.F;


    /** Bits of |values|, which are in the order of the sizes. */
    using Sizes = std::vector<std::int32_t>;



    float
    size_of_bits(const std::int32_t bits)
    {
      float size;
      std::memcpy(&size, &bits, sizeof size);
      return size;
    }



    /** Appends the size of every second value to @p sizes. */
    void
    append_sizes(const float *values, const int n_values, Sizes &sizes)
    {
      const std::size_t before = sizes.size();
      sizes.resize(before + std::size_t(n_values + 1) / 2);
      std::int32_t *size = sizes.data() + before;
      for (int x = 0; x < n_values; x += 2)
        {
          const float value = std::abs(values[x]);
          std::memcpy(size++, &value, sizeof value);
        }
    }



    /** That of rank @p nth, counted from zero, below @p upper, which at least
     * so many do not exceed. Halving what it can be counts all sizes for every
     * bit, many at once, which takes less time than to sort them in part. */
    std::int32_t
    size_of_rank(const Sizes &sizes, const int nth, std::int32_t upper)
    {
      std::int32_t lower = 0;
      while (lower < upper)
        {
          const std::int32_t middle  = lower + (upper - lower) / 2;
          int                n_up_to = 0;
          for (const std::int32_t size : sizes)
            n_up_to += size <= middle ? 1 : 0;
          if (n_up_to > nth)
            upper = middle;
          else
            lower = middle + 1;
        }
      return lower;
    }



    /** From the 90th percentile, at most by a heavy tail above the median. */
    float
    spread(const Sizes &sizes)
    {
      const auto largest = *std::max_element(sizes.begin(), sizes.end());
      const auto tail =
        size_of_rank(sizes, int(9 * sizes.size() / 10), largest);
      const int   half       = int(sizes.size() / 2);
      const float by_tail    = size_of_bits(tail) / 1.645F;
      const auto  limited_by = [](const std::int32_t median) {
        return heaviest_tail * size_of_bits(median) / 0.6745F;
      };
      // Mostly the median does not limit anything, which one count tells.
      int n_that_limit = 0;
      for (const std::int32_t size : sizes)
        n_that_limit += limited_by(size) < by_tail ? 1 : 0;
      return n_that_limit <= half ? by_tail
                                  : limited_by(size_of_rank(sizes, half, tail));
    }



    /** Noise by row of blocks, to interpolate between where it is needed: an
     * image of it would take longer to write and read than to compute. */
    struct NoiseRows
    {
      cv::Mat grid; // CV_32F, a row for each row of blocks
      int     n_rows = 0;

      /** The next rows of blocks beside row @p y of the image, and the share of
       * the second. */
      std::tuple<const float *, const float *, float>
      beside(const int y) const
      {
        const auto place =
          float((y + 0.5) / (double(n_rows) / grid.rows) - 0.5);
        const int row = cvFloor(place);
        return {grid.ptr<float>(std::max(row, 0)),
                grid.ptr<float>(std::min(row + 1, grid.rows - 1)),
                place - float(row)};
      }
    };



    /** Spread of |values| by block from their 90th percentile, which is 1.645
     * deviations of a normal distribution and follows heavy tails, but not
     * those that cracks themselves make; interpolated. A block never counts as
     * much quieter than the others, nor as much louder: a dense network of
     * cracks would pass for noise. */
    NoiseRows
    local_noise(const cv::Mat &values, const double block)
    {
      const int nx = std::max(1, cvRound(values.cols / block));
      const int ny = std::max(1, cvRound(values.rows / block));
      cv::Mat1f grid(ny, nx);
      Sizes     sizes;
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
          {
            sizes.clear();
            const int x1 = (i + 1) * values.cols / nx;
            const int y1 = (j + 1) * values.rows / ny;
            for (int y = j * values.rows / ny; y < y1; y += 2)
              {
                const int x = i * values.cols / nx + (y / 2) % 2;
                append_sizes(values.ptr<float>(y) + x, x1 - x, sizes);
              }
            if (!sizes.empty())
              grid(j, i) = spread(sizes);
          }
      std::vector<float> all(grid.begin(), grid.end());
      std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
      // Below a thousandth of a grey level there is only rounding.
      const float usual = all[all.size() / 2];
      cv::max(grid, std::max(quietest_block * usual, 1e-3F), grid);
      cv::min(grid, std::max(loudest_block * usual, 1e-3F), grid);
      cv::GaussianBlur(
        grid, grid, cv::Size(3, 3), 0., 0., cv::BORDER_REPLICATE);
      NoiseRows noise;
      noise.n_rows = values.rows;
      cv::resize(
        grid, noise.grid, cv::Size(values.cols, ny), 0., 0., cv::INTER_LINEAR);
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

      /** Contrast over noise, limited, as stored in OrientedContrast, goes to
       * @p largest where that is empty or less; before the limits to
       * @p unlimited. */
      void
      contrast(const double angle, cv::Mat &largest, cv::Mat &unlimited)
      {
        const int nx = cvRound(-flank * std::sin(angle));
        const int ny = cvRound(flank * std::cos(angle));
        mixed.create(size, CV_32F);
        mean.create(size, CV_32F);
        const bool is_first = largest.empty();
        if (is_first)
          largest.create(size, CV_16S);
        const std::vector<cv::Point> taps = taps_along(angle);
        for (int y = 0; y < size.height; y += strip)
          compare_strip(y, std::min(y + strip, size.height), taps, nx, ny);
        constexpr auto  lowest  = float(OrientedContrast::least);
        constexpr auto  highest = float(OrientedContrast::most);
        const NoiseRows noise   = local_noise(mean, block);
        cv::Mat         limited(1, size.width, CV_32F), stored;
        for (int y = 0; y < size.height; ++y)
          {
            float *m = mixed.ptr<float>(y), *u = unlimited.ptr<float>(y);
            float *l                          = limited.ptr<float>();
            const auto [before, after, share] = noise.beside(y);
            for (int x = 0; x < size.width; ++x)
              m[x] /= before[x] * (1.F - share) + after[x] * share;
            silence_border(m, y, std::abs(nx), std::abs(ny));
            for (int x = 0; x < size.width; ++x)
              {
                u[x] = std::max(u[x], m[x]);
                l[x] = std::min(std::max(m[x], lowest), highest);
              }
            cv::Mat row = largest.row(y);
            limited.convertTo(
              is_first ? row : stored, CV_16S, OrientedContrast::per_unit);
            if (!is_first)
              cv::max(row, stored, row);
          }
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



      /** Rows @p begin to @p end of the means and weighted means over both
       * flanks. A strip of averages stays in the cache. */
      void
      compare_strip(const int                     begin,
                    const int                     end,
                    const std::vector<cv::Point> &taps,
                    const int                     nx,
                    const int                     ny)
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
            float       *mm  = mean.ptr<float>(y);
            for (int x = 0; x < size.width; ++x)
              {
                const float both  = 0.5F * (a[x] + b[x]) - c[x];
                const float least = std::min(a[x], b[x]) - c[x];
                mm[x]             = both;
                m[x] = mean_flank * both + (1.F - mean_flank) * least;
              }
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
      unlimited = cv::Mat(level.size(), CV_32F, cv::Scalar(-1e9));
      OrientedContrast contrast;
      for (int t = 0; t < n_ridge_directions; ++t)
        {
          const double angle = CV_PI * t / n_ridge_directions;
          narrow.contrast(angle, contrast.planes[t], unlimited);
          wide.contrast(angle, contrast.planes[t], unlimited);
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
