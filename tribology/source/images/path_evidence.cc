// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/path_evidence.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace squeal::tribology
{
  namespace
  {
    constexpr int    n_directions  = OrientedContrast::n_directions;
    constexpr int    n_headings    = 2 * n_directions;
    constexpr int    n_steps       = 6; // samples in each half
    constexpr int    step          = 3; // pixels
    constexpr double turn_cost     = 0.5;
    constexpr int    own_weight    = 6; // of the pixel, for sharp crests
    constexpr int    lowest        = -1'000'000'000;
    constexpr int    halo          = n_steps * step + 1; // pixels
    constexpr int    fewest_inside = 3;   // samples of a half that count
    constexpr int    tile          = 160; // pixels, fits a cache

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



    /** The part of the image around one tile. */
    class Tile
    {
    public:
      Tile(const OrientedContrast &contrast, const cv::Rect &inside)
        : inside(inside)
        , size(contrast.planes[0].size())
      {
        const cv::Rect window = cv::Rect(inside.x - halo,
                                         inside.y - halo,
                                         inside.width + 2 * halo,
                                         inside.height + 2 * halo) &
                                cv::Rect({0, 0}, size);
        const int top  = halo - (inside.y - window.y),
                  left = halo - (inside.x - window.x);
        const int rows = inside.height + 2 * halo,
                  cols = inside.width + 2 * halo;
        for (int t = 0; t < n_directions; ++t)
          // Nothing is known outside of the image.
          cv::copyMakeBorder(contrast.planes[t](window),
                             local[t],
                             top,
                             rows - window.height - top,
                             left,
                             cols - window.width - left,
                             cv::BORDER_CONSTANT,
                             cv::Scalar(0));
        for (int h = 0; h < n_headings; ++h)
          {
            ahead[h] = cv::Mat::zeros(rows, cols, CV_16S);
            farther[h].create(rows, cols, CV_16S);
          }
      }

      void
      run(PathEvidence &evidence)
      {
        for (int k = 1; k <= n_steps; ++k)
          advance(k);
        complete_halves();
        for (int y = 0; y < inside.height; ++y)
          collect_row(y, evidence);
      }

    private:
      /** The best of all directions in one row. A path is worth the mean of its
       * halves and of twice the weaker one; sums are twice that, whole numbers
       * that several pixels are compared by at once. */
      void
      collect_row(const int y, PathEvidence &evidence) const
      {
        const int        n = inside.width;
        std::vector<int> mean(n, lowest), sharp(n, lowest), own(n),
          direction(n);
        for (int t = 0; t < n_directions; ++t)
          {
            const auto row = [&](const cv::Mat &m) {
              return m.ptr<std::int16_t>(y + halo) + halo;
            };
            const std::int16_t *r = row(local[t]), *a = row(ahead[t]),
                               *b = row(ahead[t + n_directions]);
            for (int x = 0; x < n; ++x)
              {
                const int  halves    = a[x] + b[x] + 2 * std::min(a[x], b[x]);
                const int  value     = 2 * own_weight * r[x] + halves;
                const bool is_better = value > sharp[x];
                direction[x]         = is_better ? t : direction[x];
                own[x]               = is_better ? r[x] : own[x];
                sharp[x]             = std::max(value, sharp[x]);
                mean[x]              = std::max(2 * r[x] + halves, mean[x]);
              }
          }
        constexpr float unit        = 1.F / OrientedContrast::per_unit;
        constexpr float scale       = 0.5F * unit / (2 * n_steps + 1);
        constexpr float sharp_scale = 0.5F * unit / (2 * n_steps + own_weight);
        for (int x = 0; x < n; ++x)
          {
            const cv::Point p               = inside.tl() + cv::Point(x, y);
            evidence.mean.at<float>(p)      = scale * float(mean[x]);
            evidence.direction.at<uchar>(p) = uchar(direction[x]);
            evidence.local.at<float>(p)     = unit * float(own[x]);
            evidence.sharp.at<float>(p)     = sharp_scale * float(sharp[x]);
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
      complete_halves()
      {
        const int      reach = n_steps * step;
        const cv::Rect centre(
          reach, reach, size.width - 2 * reach, size.height - 2 * reach);
        for (int y = 0; y < inside.height; ++y)
          for (int x = 0; x < inside.width; ++x)
            {
              const cv::Point p = inside.tl() + cv::Point(x, y);
              if (centre.contains(p))
                continue;
              for (int h = 0; h < n_directions; ++h)
                {
                  auto &a = ahead[h].at<std::int16_t>(y + halo, x + halo);
                  auto &b = ahead[h + n_directions].at<std::int16_t>(y + halo,
                                                                     x + halo);
                  const int na = samples_inside(p, h);
                  const int nb = samples_inside(p, h + n_directions);
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

      /** One more sample in front of each heading: of the pixel there, and of
       * what lies ahead of it along this heading or, at a cost, a neighbour. */
      void
      advance(const int k)
      {
        const auto cost = std::int16_t(turn_cost * OrientedContrast::per_unit);
        // What lies farther out than the remaining steps does not matter.
        const int border = k * step;
        for (int h = 0; h < n_headings; ++h)
          {
            const int left  = (h + n_headings - 1) % n_headings,
                      right = (h + 1) % n_headings;
            for (int y = border; y < ahead[h].rows - border; ++y)
              {
                const auto [s, s_on] = sample_and_rest(y, h);
                const auto [a, a_on] = sample_and_rest(y, left);
                const auto [b, b_on] = sample_and_rest(y, right);
                std::int16_t *out    = farther[h].ptr<std::int16_t>(y);
                for (int x = border; x < ahead[h].cols - border; ++x)
                  {
                    const auto on = std::int16_t(s[x] + s_on[x]);
                    const auto turn =
                      std::int16_t(std::max(std::int16_t(a[x] + a_on[x]),
                                            std::int16_t(b[x] + b_on[x])) -
                                   cost);
                    out[x] = std::max(on, turn);
                  }
              }
          }
        ahead.swap(farther);
      }

      /** Rows of contrasts one step from row @p y along @p heading, and of the
       * sums ahead of there. */
      std::pair<const std::int16_t *, const std::int16_t *>
      sample_and_rest(const int y, const int heading) const
      {
        const cv::Point d = along[heading];
        return {local[heading % n_directions].ptr<std::int16_t>(y + d.y) + d.x,
                ahead[heading].ptr<std::int16_t>(y + d.y) + d.x};
      }

      const Headings                    along = steps_along();
      cv::Rect                          inside;
      cv::Size                          size;
      std::array<cv::Mat, n_directions> local;
      std::array<cv::Mat, n_headings>   ahead, farther;
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
    for (int y = 0; y < size.height; y += tile)
      for (int x = 0; x < size.width; x += tile)
        Tile(contrast, cv::Rect(x, y, tile, tile) & cv::Rect({0, 0}, size))
          .run(evidence);
    return evidence;
  }
} // namespace squeal::tribology
