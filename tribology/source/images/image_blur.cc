// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/image_blur.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal::tribology
{
  namespace
  {
    // Gaussians by which curvatures and edges are smoothed, pixels.
    constexpr double fine_scale = 1., coarse_scale = 2.;
    // Deviations of a peak and of the logarithm of a ratio of curvatures.
    constexpr double peak_deviation = 0.03, ratio_deviation = 0.1;
    // Of pixels, and of profiles beside (smoothing and interpolation, pixels^2;
    // what a smoothed line hides of its bends).
    constexpr double pixel_blur = 1. / 12., profile_blur = 0.5,
                     hidden_bends = 0.09;
    constexpr double sharpest = 0.5, softest = 5.; // optics, pixels
    constexpr double shallowest = 0.06, deepest = 0.95;
    constexpr int    n_candidates = 60, n_trial_depths = 96;
    // A blur above which an image is out of focus, how much less likely focus
    // has to be (logarithm), and the relative deviation of a blur at least.
    constexpr double out_of_focus = 1.1, focus_unlikely = 0.5,
                     least_blur_error = 0.06;
    // Edges: over the deviation of their noise, the strongest of them, the
    // share of pixels that must be edges, and which of them are sharpest.
    constexpr float  clear_edge     = 8.F;
    constexpr double strongest_part = 0.95, least_edges = 2e-4,
                     sharpest_part = 0.1;

    /** Value @p i of @p n, evenly in the logarithm. */
    double
    geometric(const double first, const double last, const int i, const int n)
    {
      return first * std::pow(last / first, double(i) / (n - 1));
    }



    /** Logarithms of the probability of a shape: over all depths, and with the
     * one that fits best. */
    struct LogLikelihood
    {
      double sum = 0., best = 0.;
    };

    /** Of a crack under optics that blur by @p blur. */
    LogLikelihood
    log_likelihood(const ProfileShape &crack,
                   const double        blur,
                   const double        bends)
    {
      const double optics = blur * blur + pixel_blur + hidden_bends + bends,
                   b      = std::sqrt(optics + profile_blur),
                   fine   = optics + fine_scale * fine_scale,
                   coarse = optics + coarse_scale * coarse_scale;
      double sum = 0., best = 0.;
      for (int i = 0; i < n_trial_depths; ++i)
        {
          const double depth =
                         geometric(shallowest, deepest, i, n_trial_depths),
                       width = crack.dip.deficit / depth,
                       peak =
                         depth * std::erf(width / (2. * std::sqrt(2.) * b)),
                       ratio = 1.5 * std::log(coarse / fine) -
                               width * width / 8. * (1. / fine - 1. / coarse);
          const double off_peak  = (peak - crack.dip.peak) / peak_deviation,
                       off_ratio = (ratio - std::log(crack.curvature_ratio)) /
                                   ratio_deviation;
          const double p =
            std::exp(-0.5 * (off_peak * off_peak + off_ratio * off_ratio));
          sum += p;
          best = std::max(best, p);
        }
      constexpr double least = std::numeric_limits<double>::min();
      return {std::log(sum + least), std::log(best + least)};
    }



    /** Across a line of direction @p angle at pixel @p p: the largest second
     * derivative within a pixel of it, and the place. */
    struct Curvatures
    {
      cv::Mat1f xx, yy, xy;

      Curvatures(const cv::Mat &grey, const double scale)
      {
        cv::Mat smooth;
        cv::GaussianBlur(grey, smooth, cv::Size(), scale);
        const auto of = [&smooth](const int dx, const int dy) {
          // Differences as they are: their own blur is the same at both scales.
          const cv::Mat1f second = (cv::Mat1f(1, 3) << 1.F, -2.F, 1.F),
                          whole  = (cv::Mat1f(1, 1) << 1.F),
                          first  = (cv::Mat1f(1, 3) << -0.5F, 0.F, 0.5F);
          const auto kernel      = [&](const int n) {
            return n == 2 ? second : n == 1 ? first : whole;
          };
          cv::Mat1f result;
          cv::sepFilter2D(smooth, result, CV_32F, kernel(dx), kernel(dy));
          return result;
        };
        xx = of(2, 0);
        yy = of(0, 2);
        xy = of(1, 1);
      }

      double
      across(const cv::Point &p, const double angle) const
      {
        const double nx = -std::sin(angle), ny = std::cos(angle);
        return nx * nx * xx(p) + ny * ny * yy(p) + 2. * nx * ny * xy(p);
      }
    };



    /** Deviation of white noise, by second differences along both axes, which
     * no edge and no shading passes. */
    double
    white_noise(const cv::Mat &grey)
    {
      const cv::Mat1f second = (cv::Mat1f(1, 3) << 1.F, -2.F, 1.F);
      cv::Mat1f       differences;
      cv::sepFilter2D(grey, differences, CV_32F, second, second);
      std::vector<float> sizes;
      for (int y = 0; y < grey.rows; y += 2)
        for (int x = 0; x < grey.cols; ++x)
          sizes.push_back(std::abs(differences(y, x)));
      const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
      std::nth_element(sizes.begin(), middle, sizes.end());
      return *middle / 0.6745 / 6.;
    }



    struct Slopes
    {
      cv::Mat1f x, y;

      Slopes(const cv::Mat &grey, const double scale)
      {
        cv::Mat smooth;
        cv::GaussianBlur(grey, smooth, cv::Size(), scale);
        const cv::Mat1f first = (cv::Mat1f(1, 3) << -0.5F, 0.F, 0.5F),
                        whole = (cv::Mat1f(1, 1) << 1.F);
        cv::sepFilter2D(smooth, x, CV_32F, first, whole);
        cv::sepFilter2D(smooth, y, CV_32F, whole, first);
      }

      float
      size(const int row, const int column) const
      {
        return std::hypot(x(row, column), y(row, column));
      }
    };



    /** An edge: its slope, and that of the image smoothed more, along it. */
    struct Edge
    {
      float fine = 0.F, coarse = 0.F;
    };

    /** Pixels that are steeper than both neighbours up and down the slope. */
    std::vector<Edge>
    edges_of(const cv::Mat &grey)
    {
      const Slopes      fine(grey, fine_scale), coarse(grey, coarse_scale);
      std::vector<Edge> edges;
      const float       least =
        clear_edge * float(white_noise(grey)) /
        float(std::sqrt(8. * CV_PI) * fine_scale * fine_scale);
      for (int y = 4; y + 4 < grey.rows; ++y)
        for (int x = 4; x + 4 < grey.cols; ++x)
          {
            const float size = fine.size(y, x);
            if (size <= least)
              continue;
            const float ux = fine.x(y, x) / size, uy = fine.y(y, x) / size;
            const int   dx = cvRound(ux), dy = cvRound(uy);
            if (size >= fine.size(y + dy, x + dx) &&
                size >= fine.size(y - dy, x - dx))
              edges.push_back(
                {size, coarse.x(y, x) * ux + coarse.y(y, x) * uy});
          }
      return edges;
    }
  } // namespace



  ProfileShape
  shape_of_crack(const cv::Mat                &grey,
                 const std::vector<cv::Point> &pixels,
                 const cv::Mat                &direction,
                 const std::vector<Dip>       &dips)
  {
    constexpr int  margin = 8; // pixels, for the wider Gaussian
    const cv::Rect tight  = cv::boundingRect(pixels);
    const cv::Rect box    = cv::Rect(tight.x - margin,
                                  tight.y - margin,
                                  tight.width + 2 * margin,
                                  tight.height + 2 * margin) &
                         cv::Rect({0, 0}, grey.size());
    const Curvatures fine(grey(box), fine_scale),
      coarse(grey(box), coarse_scale);
    ProfileShape shape;
    double       sum_fine = 0., sum_coarse = 0.;
    for (std::size_t i = 0; i < pixels.size(); ++i)
      {
        const cv::Point p = pixels[i] - box.tl();
        const double    a = direction.at<float>(pixels[i]);
        sum_fine += fine.across(p, a);
        sum_coarse += coarse.across(p, a);
        shape.dip.deficit += dips[i].deficit / double(pixels.size());
        shape.dip.peak += dips[i].peak / double(pixels.size());
      }
    if (sum_fine > 0. && sum_coarse > 0.)
      shape.curvature_ratio = sum_fine / sum_coarse;
    return shape;
  }



  OpticalBlur
  blur_of_cracks(const std::vector<ProfileShape> &cracks, const double bends)
  {
    // A crack of which little is seen fits many depths with the blur of focus
    // as with another one: whether it is in focus is asked of the best depth.
    std::vector<double> logarithms(n_candidates, 0.), best(n_candidates, 0.);
    bool                tells = false;
    OpticalBlur         blur;
    double              in_focus = 0.;
    for (const ProfileShape &crack : cracks)
      {
        if (crack.curvature_ratio <= 0. || crack.dip.peak < shallowest)
          continue;
        tells = true;
        in_focus += log_likelihood(crack, blur.value, bends).best;
        for (int k = 0; k < n_candidates; ++k)
          {
            const LogLikelihood own = log_likelihood(
              crack, geometric(sharpest, softest, k, n_candidates), bends);
            logarithms[k] += own.sum;
            best[k] += own.best;
          }
      }
    if (!tells)
      return blur;
    const double most = *std::max_element(logarithms.begin(), logarithms.end());
    double       weight = 0., mean = 0., square = 0.;
    for (int k = 0; k < n_candidates; ++k)
      {
        const double p = std::exp(logarithms[k] - most),
                     x =
                       std::log(geometric(sharpest, softest, k, n_candidates));
        weight += p;
        mean += p * x;
        square += p * x * x;
      }
    mean /= weight;
    if (std::exp(mean) < out_of_focus ||
        in_focus > *std::max_element(best.begin(), best.end()) - focus_unlikely)
      return blur;
    blur.value = std::exp(mean);
    blur.error = std::max(
      least_blur_error, std::sqrt(std::max(0., square / weight - mean * mean)));
    blur.is_measured = true;
    return blur;
  }



  double
  sharpest_edges(const cv::Mat &grey)
  {
    std::vector<Edge> edges = edges_of(grey);
    if (double(edges.size()) < least_edges * double(grey.total()))
      return std::numeric_limits<double>::infinity();
    const auto first =
      edges.begin() + std::ptrdiff_t(strongest_part * double(edges.size()));
    std::nth_element(
      edges.begin(), first, edges.end(), [](const Edge &a, const Edge &b) {
        return a.fine < b.fine;
      });
    std::vector<double> variances;
    for (auto edge = first; edge != edges.end(); ++edge)
      {
        // A step of variance v has the slope 1 / sqrt(v + s^2) at scale s.
        const double ratio = std::clamp(
          double(edge->fine) / std::max(1e-9F, edge->coarse), 1.0001, 50.);
        variances.push_back((coarse_scale * coarse_scale -
                             ratio * ratio * fine_scale * fine_scale) /
                            (ratio * ratio - 1.));
      }
    const auto nth = variances.begin() +
                     std::ptrdiff_t(sharpest_part * double(variances.size()));
    std::nth_element(variances.begin(), nth, variances.end());
    return *nth;
  }
} // namespace squeal::tribology
