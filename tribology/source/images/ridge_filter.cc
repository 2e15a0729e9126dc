// SPDX-License-Identifier: LGPL-2.1-or-later
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
    constexpr int    n_directions   = RidgeField::n_directions;
    constexpr double half_length    = 6.;   // of a line, in its deviations
    constexpr double flank_distance = 2.;   // in deviations
    constexpr float  mean_flank     = 0.2F; // weight beside the lesser flank
    constexpr float  lesser_half    = 0.8F; // weight beside the mean half
    constexpr float  bend_cost      = 0.1F;
    constexpr double noise_block    = 64.; // pixels of the finest level

    /** Spread of |values| by block from their 90th percentile, which is 1.645
     * deviations of a normal distribution and follows heavy tails, then
     * interpolated. A block never counts as much quieter than the others. */
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
            const auto nth = sample.begin() + (9 * sample.size()) / 10;
            std::nth_element(sample.begin(), nth, sample.end());
            grid(j, i) = *nth / 1.645F;
          }
      std::vector<float> all(grid.begin(), grid.end());
      std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
      // Below a thousandth of a grey level there is only rounding.
      const float least = std::max(0.3F * all[all.size() / 2], 1e-3F);
      cv::max(grid, least, grid);
      cv::GaussianBlur(
        grid, grid, cv::Size(3, 3), 0., 0., cv::BORDER_REPLICATE);
      cv::Mat noise;
      cv::resize(grid, noise, values.size(), 0., 0., cv::INTER_LINEAR);
      return noise;
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
        , n_taps(cvRound(half_length * deviation / step) + 1)
        , margin(int(std::ceil(half_length * deviation)) + 2)
        , wide(2 * margin + int(std::ceil(flank)) + 4)
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

      /** Writes the best line of each pixel. */
      void
      run(cv::Mat &strength, cv::Mat &direction)
      {
        for (int t = 0; t < n_directions; ++t)
          contrasts[t] = contrast(CV_PI * t / n_directions);
        strength.create(size, CV_32F);
        strength.setTo(-1e9);
        direction = cv::Mat::zeros(size, CV_8U);
        for (int t = 0; t < n_directions; ++t)
          for (int bend = -1; bend <= 1; ++bend)
            join(t, bend, strength, direction);
      }

    private:
      /** Average over a half line centred at each pixel, on the padded size
       * less @p border. */
      cv::Mat
      average(const double angle, const int border) const
      {
        const cv::Size             inner(padded.cols - 2 * border,
                             padded.rows - 2 * border);
        cv::Mat                    sum(inner, CV_32F);
        std::vector<const float *> taps(n_taps);
        for (int y = 0; y < inner.height; ++y)
          {
            for (int i = 0; i < n_taps; ++i)
              {
                const double u = (i - 0.5 * (n_taps - 1)) * step;
                taps[i] =
                  padded.ptr<float>(y + border + cvRound(u * std::sin(angle))) +
                  border + cvRound(u * std::cos(angle));
              }
            float *row = sum.ptr<float>(y);
            std::fill(row, row + inner.width, 0.F);
            for (int i = 0; i < n_taps; ++i)
              for (int x = 0; x < inner.width; ++x)
                row[x] += taps[i][x];
          }
        return sum * (1. / n_taps);
      }



      /** Normalised contrast with a margin for the half lines. */
      cv::Mat
      contrast(const double angle) const
      {
        const int      border = margin;
        const cv::Mat  line   = average(angle, border);
        const int      nx     = cvRound(-flank * std::sin(angle));
        const int      ny     = cvRound(flank * std::cos(angle));
        const int      inset  = wide - border - margin;
        const cv::Size outer(size.width + 2 * margin, size.height + 2 * margin);
        cv::Mat        mixed(outer, CV_32F), mean(outer, CV_32F);
        for (int y = 0; y < outer.height; ++y)
          {
            const float *c  = line.ptr<float>(y + inset) + inset;
            const float *a  = line.ptr<float>(y + inset + ny) + inset + nx;
            const float *b  = line.ptr<float>(y + inset - ny) + inset - nx;
            float       *m  = mixed.ptr<float>(y);
            float       *mm = mean.ptr<float>(y);
            for (int x = 0; x < outer.width; ++x)
              {
                const float both  = 0.5F * (a[x] + b[x]) - c[x];
                const float least = std::min(a[x], b[x]) - c[x];
                mm[x]             = both;
                m[x] = mean_flank * both + (1.F - mean_flank) * least;
              }
          }
        cv::Mat noise =
          local_noise(mean(cv::Rect({margin, margin}, size)), block);
        cv::copyMakeBorder(
          noise, noise, margin, margin, margin, margin, cv::BORDER_REPLICATE);
        cv::divide(mixed, noise, mixed);
        silence_border(mixed, std::abs(nx), std::abs(ny));
        return mixed;
      }



      /** No evidence where a flank would lie outside. */
      void
      silence_border(cv::Mat &values, const int nx, const int ny) const
      {
        const auto quiet = [&](const cv::Rect &r) {
          cv::Mat part = values(r);
          cv::min(part, 0., part);
        };
        const int w = std::min(nx, size.width), h = std::min(ny, size.height);
        if (w > 0)
          {
            quiet({margin, 0, w, values.rows});
            quiet({margin + size.width - w, 0, w, values.rows});
          }
        if (h > 0)
          {
            quiet({0, margin, values.cols, h});
            quiet({0, margin + size.height - h, values.cols, h});
          }
      }



      /** Two half lines that meet at the pixel, the second turned by @p bend
       * steps. */
      void
      join(const int t, const int bend, cv::Mat &strength, cv::Mat &direction)
      {
        const double reach = 0.5 * (n_taps - 1) * step;
        const int    other = (t + bend + n_directions) % n_directions;
        // Past the end of the half circle the direction names turn round.
        const int    sign = other == t + bend ? -1 : 1;
        const double a    = CV_PI * t / n_directions;
        const double b    = CV_PI * other / n_directions;
        const int    ax   = cvRound(reach * std::cos(a)),
                  ay      = cvRound(reach * std::sin(a)),
                  bx      = cvRound(sign * reach * std::cos(b)),
                  by      = cvRound(sign * reach * std::sin(b));
        const float factor =
          std::sqrt(2.F) * (1.F - bend_cost * std::abs(bend));
        for (int y = 0; y < size.height; ++y)
          {
            const float *p =
              contrasts[t].ptr<float>(y + margin + ay) + margin + ax;
            const float *q =
              contrasts[other].ptr<float>(y + margin + by) + margin + bx;
            float *s = strength.ptr<float>(y);
            uchar *d = direction.ptr<uchar>(y);
            for (int x = 0; x < size.width; ++x)
              {
                const float z =
                  factor * (lesser_half * std::min(p[x], q[x]) +
                            (1.F - lesser_half) * 0.5F * (p[x] + q[x]));
                d[x] = z > s[x] ? uchar(t) : d[x];
                s[x] = std::max(z, s[x]);
              }
          }
      }

      cv::Size                          size;
      double                            block, flank, step;
      int                               n_taps, margin, wide;
      cv::Mat                           padded;
      std::array<cv::Mat, n_directions> contrasts;
    };



    void
    keep_better(RidgeField    &best,
                const cv::Mat &strength,
                const cv::Mat &direction)
    {
      const cv::Mat better = strength > best.strength;
      strength.copyTo(best.strength, better);
      direction.copyTo(best.direction, better);
    }
  } // namespace



  double
  RidgeField::angle(const cv::Point &p) const
  {
    return CV_PI * direction.at<uchar>(p) / n_directions;
  }



  bool
  RidgeField::is_crest(const cv::Point &p) const
  {
    const double    a = angle(p);
    const cv::Point across(cvRound(-std::sin(a)), cvRound(std::cos(a)));
    const cv::Rect  inside({0, 0}, strength.size());
    const float     z  = strength.at<float>(p);
    const auto      at = [&](const cv::Point &q) {
      return inside.contains(q) ? strength.at<float>(q) : -1e9F;
    };
    return z >= at(p + across) && z > at(p - across);
  }



  RidgeField
  filter_ridges(const cv::Mat &grey, const int n_octaves)
  {
    RidgeField best;
    best.strength  = cv::Mat(grey.size(), CV_32F, cv::Scalar(-1e9));
    best.direction = cv::Mat::zeros(grey.size(), CV_8U);
    cv::Mat level  = grey;
    double  factor = 1.;
    for (int octave = 0; octave < n_octaves; ++octave)
      {
        for (const double deviation : {1., 1.5})
          {
            cv::Mat strength, direction;
            LineFilter(level, deviation, std::max(16., noise_block / factor))
              .run(strength, direction);
            if (octave > 0)
              {
                cv::resize(
                  strength, strength, grey.size(), 0., 0., cv::INTER_LINEAR);
                cv::resize(
                  direction, direction, grey.size(), 0., 0., cv::INTER_NEAREST);
              }
            keep_better(best, strength, direction);
          }
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
    return best;
  }
} // namespace squeal::tribology
