// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/path_evidence.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace squeal::tribology
{
  namespace
  {
    constexpr int    n_directions   = OrientedContrast::n_directions;
    constexpr int    n_headings     = 2 * n_directions;
    constexpr int    n_steps        = 6; // samples in each half
    constexpr int    step           = 3; // pixels
    constexpr double turn_cost      = 0.5;
    constexpr int    own_weight     = 6; // of the pixel, for sharp crests
    constexpr int    lowest         = std::numeric_limits<int>::lowest();
    constexpr int    direction_bits = 4;
    static_assert(1 << direction_bits == n_directions);
    constexpr int halo          = n_steps * step + 1; // pixels
    constexpr int fewest_inside = 3;   // samples of a half that count
    constexpr int columns       = 128; // of a band: its sums fit a cache
    constexpr int ring          = 8;   // rows of sums: a step back and ahead
    static_assert(ring > 2 * step);

    using Headings = std::array<cv::Point, n_headings>;

    /** One step along each heading, pixels. */
    Headings
    steps_along()
    {
      Headings steps;
      for (int h = 0; h < n_headings; ++h)
        {
          const double a = CV_PI * h / n_directions;
          steps[h] = {cvRound(step * std::cos(a)), cvRound(step * std::sin(a))};
        }
      return steps;
    }



    /** A band of columns of the image. Its rows go through all steps one after
     * the other: sums of a step need those of the step before in the rows about
     * them alone, so that a few rows of each are kept. */
    class Band
    {
    public:
      Band(const OrientedContrast &contrast, const int begin, const int end)
        : begin(begin)
        , width(end - begin)
        , size(contrast.planes[0].size())
        , stride(width + 2 * halo)
        , sums(std::size_t(n_steps * n_headings * ring) * stride)
      {
        const int left  = std::max(begin - halo, 0),
                  right = std::min(end + halo, size.width);
        for (int t = 0; t < n_directions; ++t)
          // Nothing is known outside of the image.
          cv::copyMakeBorder(contrast.planes[t].colRange(left, right),
                             local[t],
                             halo,
                             halo,
                             left - (begin - halo),
                             end + halo - right,
                             cv::BORDER_CONSTANT,
                             cv::Scalar(0));
      }

      void
      run(PathEvidence &evidence)
      {
        const int n_rows = size.height + 2 * halo;
        for (int newest = 0; newest < n_rows; ++newest)
          for (int k = 1; k <= n_steps; ++k)
            {
              // What lies farther out than the remaining steps does not matter.
              const int row = newest - k * step, border = k * step;
              if (row < border || row >= n_rows - border)
                continue;
              if (k < n_steps)
                advance<true>(k, row);
              else
                advance<false>(k, row);
              const int y = row - halo;
              if (k == n_steps && y >= 0 && y < size.height)
                {
                  complete_halves(y);
                  collect_row(y, evidence);
                }
            }
      }

    private:
      /** Sums of step @p k along @p heading in @p row, with the halo. */
      std::int16_t *
      sums_of(const int k, const int heading, const int row)
      {
        const int which = ((k - 1) * n_headings + heading) * ring + row % ring;
        return sums.data() + std::size_t(which) * stride;
      }

      const std::int16_t *
      local_row(const int direction, const int row) const
      {
        return local[direction].ptr<std::int16_t>(row);
      }

      /** One more sample in front of each heading in @p row: the best sum that
       * starts one step along it or, at a cost, along a neighbour. With
       * @p has_own the pixel itself is added, as the next step needs it. */
      template <bool has_own>
      void
      advance(const int k, const int row)
      {
        const auto cost = std::int16_t(turn_cost * OrientedContrast::per_unit);
        const auto one_step_along = [&](const int heading) {
          const cv::Point     d = along[heading];
          const std::int16_t *from =
            k == 1 ? local_row(heading % n_directions, row + d.y)
                   : sums_of(k - 1, heading, row + d.y);
          return from + d.x;
        };
        const int border = k * step;
        for (int h = 0; h < n_headings; ++h)
          {
            const std::int16_t *on = one_step_along(h);
            const std::int16_t *left =
              one_step_along((h + n_headings - 1) % n_headings);
            const std::int16_t *right = one_step_along((h + 1) % n_headings);
            const std::int16_t *own   = local_row(h % n_directions, row);
            std::int16_t       *out   = sums_of(k, h, row);
            for (int x = border; x < stride - border; ++x)
              {
                const auto turn =
                  std::int16_t(std::max(left[x], right[x]) - cost);
                const auto best = std::max(on[x], turn);
                out[x]          = has_own ? std::int16_t(best + own[x]) : best;
              }
          }
      }

      /** Samples of a straight half path from a pixel that lie inside of the
       * image. */
      int
      samples_inside(const cv::Point &p, const int heading) const
      {
        const cv::Rect  image({0, 0}, size);
        const cv::Point d = along[heading];
        int             n = 0;
        while (n < n_steps && image.contains(p + (n + 1) * d))
          ++n;
        return n;
      }

      /** Half paths that leave the image count by what they are inside; of
       * those with hardly anything inside nothing is known, and the other half
       * speaks for both. */
      void
      complete_halves(const int y)
      {
        const int      reach = n_steps * step;
        const cv::Rect centre(
          reach, reach, size.width - 2 * reach, size.height - 2 * reach);
        for (int x = 0; x < width; ++x)
          {
            const cv::Point p(begin + x, y);
            if (centre.contains(p))
              {
                x = centre.br().x - begin - 1;
                continue;
              }
            for (int h = 0; h < n_directions; ++h)
              {
                const int     other = h + n_directions;
                std::int16_t &a     = sums_of(n_steps, h, y + halo)[x + halo];
                std::int16_t &b  = sums_of(n_steps, other, y + halo)[x + halo];
                const int     na = samples_inside(p, h);
                const int     nb = samples_inside(p, other);
                // Twice the sum of a half path fits into 16 bits.
                if (na >= fewest_inside)
                  a = std::int16_t(a * n_steps / na);
                if (nb >= fewest_inside)
                  b = std::int16_t(b * n_steps / nb);
                if (na < fewest_inside)
                  a = b;
                if (nb < fewest_inside)
                  b = a;
              }
          }
      }

      /** The best of all directions in one row. A path is worth the mean of its
       * halves and of twice the weaker one; sums are twice that, whole numbers
       * that several pixels are compared by at once. Those for sharp crests
       * carry their direction in the last digits, so that one comparison
       * decides on both; of equals the first direction wins. */
      void
      collect_row(const int y, PathEvidence &evidence)
      {
        const int                row = y + halo;
        std::array<int, columns> mean, sharp;
        mean.fill(lowest);
        sharp.fill(lowest);
        for (int t = 0; t < n_directions; ++t)
          {
            const std::int16_t *r = local_row(t, row) + halo;
            const std::int16_t *a = sums_of(n_steps, t, row) + halo;
            const std::int16_t *b =
              sums_of(n_steps, t + n_directions, row) + halo;
            for (int x = 0; x < width; ++x)
              {
                const int halves = a[x] + b[x] + 2 * std::min(a[x], b[x]);
                const int value  = 2 * own_weight * r[x] + halves;
                sharp[x]         = std::max(
                  value * n_directions + (n_directions - 1 - t), sharp[x]);
                mean[x] = std::max(2 * r[x] + halves, mean[x]);
              }
          }
        constexpr float unit        = 1.F / OrientedContrast::per_unit;
        constexpr float scale       = 0.5F * unit / (2 * n_steps + 1);
        constexpr float sharp_scale = 0.5F * unit / (2 * n_steps + own_weight);
        float          *means       = evidence.mean.ptr<float>(y) + begin;
        float          *sharps      = evidence.sharp.ptr<float>(y) + begin;
        for (int x = 0; x < width; ++x)
          {
            means[x] = scale * float(mean[x]);
            // Negative values are rounded down too.
            sharps[x] = sharp_scale * float(sharp[x] >> direction_bits);
          }
        float *own       = evidence.local.ptr<float>(y) + begin;
        uchar *direction = evidence.direction.ptr<uchar>(y) + begin;
        for (int x = 0; x < width; ++x)
          {
            const int t  = n_directions - 1 - (sharp[x] & (n_directions - 1));
            direction[x] = uchar(t);
            own[x]       = unit * float(local_row(t, row)[halo + x]);
          }
      }

      const Headings                    along = steps_along();
      int                               begin, width;
      cv::Size                          size;
      int                               stride;
      std::array<cv::Mat, n_directions> local;
      std::vector<std::int16_t>         sums; // of step, heading, row of a ring
    };
  } // namespace



  PathEvidence
  integrate_paths(const OrientedContrast &contrast)
  {
    const cv::Size size = contrast.planes[0].size();
    PathEvidence   evidence;
    evidence.mean.create(size, CV_32F);
    evidence.local.create(size, CV_32F);
    evidence.sharp.create(size, CV_32F);
    evidence.direction = cv::Mat::zeros(size, CV_8U);
    for (int x = 0; x < size.width; x += columns)
      Band(contrast, x, std::min(x + columns, size.width)).run(evidence);
    return evidence;
  }
} // namespace squeal::tribology
