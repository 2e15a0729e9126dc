// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/crack_depth.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr double assumed_mean  = 0.57;  // depth, mean over an image
    constexpr double assumed_error = 0.175; // of that, relative
    constexpr double spread        = 0.23;  // of depths in an image, relative
    // How probable it is that the assumption does not hold for an image. All
    // widths of the same missing light are then as likely.
    constexpr double another = 0.5;
    // b^2 but for the optics and the bends that show: pixel 1/12, smoothing and
    // interpolation of profiles 1/3 + 1/6, what a smoothed centre line hides of
    // the bends (0.3 pixels)^2.
    constexpr double straight_blur  = 0.673; // pixels^2
    constexpr double focus_error    = 0.20;  // of b in focus, relative
    constexpr double peak_error     = 0.03;  // texture and noise
    constexpr double smallest_depth = 0.06, largest_depth = 0.95;
    // Depths of which probabilities are taken, and dips of a crack.
    constexpr int         n_depths  = 48;
    constexpr std::size_t some_dips = 200;

    // Nodes of Gauss and Hermite for the logarithm of the blur, in deviations.
    constexpr int n_blurs = 5, likeliest = 2;
    constexpr std::array<double, n_blurs>
      blur_nodes   = {{-2.857, -1.356, 0., 1.356, 2.857}},
      blur_weights = {{0.01126, 0.22208, 0.53333, 0.22208, 0.01126}};

    template <typename T>
    auto
    square(const T &x)
    {
      return x * x;
    }



    /** Logarithms of the probability of the peak of @p dip where @p expected
     * ones are true, but for a constant. */
    Eigen::ArrayXXd
    fit_of_peak(const Dip &dip, const Eigen::ArrayXXd &expected)
    {
      return -0.5 * square((expected - dip.peak) / peak_error);
    }

    /** The same for each column with the depth that fits best: peaks grow with
     * the depth, so that between those of the first and of the last row some
     * depth has any. */
    Eigen::ArrayXd
    best_fit_of_peak(const Dip &dip, const Eigen::ArrayXXd &expected)
    {
      const Eigen::ArrayXXd nearest =
        expected.topRows(1).max(dip.peak).min(expected.bottomRows(1));
      return fit_of_peak(dip, nearest).row(0).transpose();
    }



    /** Logarithms from the smallest to the largest depth. */
    Eigen::ArrayXd
    logarithms_of_depths()
    {
      return Eigen::ArrayXd::LinSpaced(
        n_depths, std::log(smallest_depth), std::log(largest_depth));
    }



    /** Probabilities of the @p depths (logarithms, columns) of cracks in images
     * of which the means are the same ones (rows). */
    Eigen::MatrixXd
    scatter_of(const Eigen::ArrayXd &depths)
    {
      Eigen::MatrixXd scatter(n_depths, n_depths);
      for (int i = 0; i < n_depths; ++i)
        {
          const Eigen::ArrayXd p =
            (-0.5 * square((depths - depths[i]) / spread)).exp();
          scatter.row(i) = p / p.sum();
        }
      return scatter;
    }



    /** Probabilities of the means of images (rows) for each blur (columns), and
     * for each once more where the assumption does not hold. */
    Eigen::ArrayXXd
    assumed_means(const Eigen::ArrayXd &depths)
    {
      const Eigen::ArrayXd near =
        (-0.5 * square((depths - std::log(assumed_mean)) / assumed_error))
          .exp();
      const Eigen::ArrayXd any = (-depths).exp();
      Eigen::ArrayXXd      result(n_depths, 2 * n_blurs);
      for (int k = 0; k < n_blurs; ++k)
        {
          result.col(k) = blur_weights[k] * (1. - another) / near.sum() * near;
          result.col(n_blurs + k) = blur_weights[k] * another / any.sum() * any;
        }
      return result;
    }



    /** Probabilities of the means of images, from their @p logarithms: those of
     * each blur, with the assumption and without it, have the sum that its
     * logarithm in @p of_blurs says. */
    Eigen::ArrayXXd
    shares_of(const Eigen::ArrayXXd &logarithms, const Eigen::ArrayXd &of_blurs)
    {
      Eigen::ArrayXXd result(n_depths, 2 * n_blurs);
      for (int k = 0; k < n_blurs; ++k)
        {
          const auto with        = logarithms.col(k),
                     less        = logarithms.col(n_blurs + k);
          const double most      = std::max(with.maxCoeff(), less.maxCoeff());
          const Eigen::ArrayXd a = (with - most).exp(), b = (less - most).exp();
          const double share      = std::exp(of_blurs[k]) / (a.sum() + b.sum());
          result.col(k)           = share * a;
          result.col(n_blurs + k) = share * b;
        }
      return result / result.sum();
    }



    /** The depth (logarithm) below which half of the @p shares lie. */
    double
    median_of(const Eigen::ArrayXd &depths, const Eigen::ArrayXd &shares)
    {
      const double half  = 0.5 * shares.sum();
      double       below = 0.;
      int          i     = 0;
      while (i + 1 < n_depths && below + shares[i] < half)
        below += shares[i++];
      // A share belongs to the half steps on both sides.
      const double step = depths[1] - depths[0];
      return depths[i] + step * ((half - below) / shares[i] - 0.5);
    }
  } // namespace



  Eigen::ArrayXXd
  CrackDepth::peaks(const Dip &dip) const
  {
    Eigen::ArrayXXd      result(n_depths, n_blurs);
    const Eigen::ArrayXd depth_of = depths.exp();
    for (int k = 0; k < n_blurs; ++k)
      {
        const double b = blur * std::exp(blur_error * blur_nodes[k]);
        for (int i = 0; i < n_depths; ++i)
          result(i, k) = depth_of[i] * std::erf(dip.deficit / depth_of[i] /
                                                (2. * std::sqrt(2.) * b));
      }
    return result;
  }



  CrackDepth::CrackDepth(const std::vector<std::vector<Dip>> &cracks,
                         const double                         bends,
                         const OpticalBlur                   &optics)
    : blur(std::sqrt(straight_blur + bends + square(optics.value)))
    , blur_error(optics.is_measured ? optics.error * square(optics.value / blur)
                                    : focus_error)
    , depths(logarithms_of_depths())
    , scatter(scatter_of(depths))
  {
    Eigen::ArrayXXd logarithms = assumed_means(depths).log();
    Eigen::ArrayXd  of_blurs(n_blurs);
    for (int k = 0; k < n_blurs; ++k)
      of_blurs[k] = std::log(blur_weights[k]);
    for (const std::vector<Dip> &crack : cracks)
      {
        // Each crack has one vote: its pixels are wrong together.
        Eigen::ArrayXXd   vote    = Eigen::ArrayXXd::Zero(n_depths, n_blurs);
        Eigen::ArrayXd    best    = Eigen::ArrayXd::Zero(n_blurs);
        double            weights = 0.;
        const std::size_t step    = 1 + crack.size() / some_dips;
        for (std::size_t i = 0; i < crack.size(); i += step)
          {
            const Eigen::ArrayXXd expected = peaks(crack[i]);
            vote += crack[i].deficit * fit_of_peak(crack[i], expected);
            best += crack[i].deficit * best_fit_of_peak(crack[i], expected);
            weights += crack[i].deficit;
          }
        if (weights <= 0.)
          continue;
        vote /= weights;
        of_blurs += best / weights;
        const Eigen::ArrayXXd seen =
          (vote.rowwise() - vote.colwise().maxCoeff()).exp();
        const Eigen::ArrayXXd of_means =
          (scatter * seen.matrix()).array().log();
        logarithms.leftCols(n_blurs) += of_means;
        logarithms.rightCols(n_blurs) += of_means;
      }
    const Eigen::ArrayXXd shares = shares_of(logarithms, of_blurs);
    means  = shares.leftCols(n_blurs) + shares.rightCols(n_blurs);
    before = scatter.transpose() * means.matrix();
    const Eigen::VectorXd holds = shares.col(likeliest),
                          other = shares.col(n_blurs + likeliest);
    likely = scatter.transpose() * (holds.sum() < other.sum() ? other : holds);
  }



  CrackDepth::Width
  CrackDepth::width(const Dip &dip) const
  {
    const Eigen::ArrayXXd logarithms = fit_of_peak(dip, peaks(dip));
    const Eigen::ArrayXXd seen  = (logarithms - logarithms.maxCoeff()).exp();
    const Eigen::ArrayXd  usual = logarithms.col(likeliest);
    Width                 result;
    result.value =
      dip.deficit /
      std::exp(median_of(depths, likely * (usual - usual.maxCoeff()).exp()));
    // How wide the crack is for each depth, less the value: its mean square,
    // and that of its means over the cracks of an image, which are common.
    const Eigen::ArrayXd  off    = dip.deficit * (-depths).exp() - result.value;
    const Eigen::ArrayXXd shares = before * seen,
                          part   = (scatter * seen.matrix()).array(),
                          sum =
                            (scatter * (seen.colwise() * off).matrix()).array();
    const double all = (shares.colwise() * square(off)).sum(),
                 common =
                   (means * (part > 0.).select(square(sum) / part, 0.)).sum(),
                 total = shares.sum();
    result.common      = std::sqrt(common / total);
    result.own         = std::sqrt(std::max(0., (all - common) / total));
    return result;
  }
} // namespace squeal::tribology
