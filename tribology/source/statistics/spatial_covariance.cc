// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/spatial_covariance.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <optional>

namespace squeal::tribology
{
  namespace
  {
    enum class Kind
    {
      normal,
      exponential,
      matern
    };

    /** Correlation at a distance over the length. */
    double
    correlation(const Kind kind, const double d)
    {
      switch (kind)
        {
        case Kind::normal:
          return std::exp(-d * d);
        case Kind::exponential:
          return std::exp(-d);
        case Kind::matern:
          return (1. + std::sqrt(3.) * d) * std::exp(-std::sqrt(3.) * d);
        }
      return 0.;
    }



    Eigen::MatrixXd
    correlations(const std::vector<CellPlace> &places,
                 const Kind                    kind,
                 const double                  length,
                 const double                  ratio)
    {
      const Eigen::Index n = places.size();
      Eigen::MatrixXd    r(n, n);
      const double       along = std::sqrt(ratio) / length,
                   across      = 1. / (std::sqrt(ratio) * length);
      for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j <= i; ++j)
          r(i, j) = r(j, i) =
            correlation(kind,
                        std::hypot((places[i][0] - places[j][0]) * along,
                                   (places[i][1] - places[j][1]) * across));
      return r;
    }



    /** One member, its overall variance chosen by the likelihood. */
    struct Scaled
    {
      double          likelihood = 0.; /**< log */
      Eigen::VectorXd variance, resolved;
    };

    /** Fisher's scoring on the logarithm of the variance. @p squares are those
     * of the coefficients, @p floor the variance of the resolution, @p start
     * the variance to begin with and, later, the one found. */
    std::optional<Scaled>
    scaled(const Eigen::ArrayXd &squares,
           const Eigen::ArrayXd &shape,
           const double          floor,
           double               &start)
    {
      const Eigen::ArrayXd energy = squares + floor;
      double               scale  = start;
      for (unsigned int i = 0; i < 60; ++i)
        {
          const Eigen::ArrayXd inverse = (scale * shape + floor).inverse();
          const Eigen::ArrayXd part    = scale * shape * inverse;
          const double         step =
            std::min(2.,
                     std::max(-2.,
                              (part * (energy * inverse - 1.)).sum() /
                                part.square().sum()));
          scale *= std::exp(step);
          if (!(scale > 1e-6 * floor))
            return {};
          if (std::abs(step) < 1e-3)
            break;
        }
      start = scale;
      Scaled result;
      result.variance = scale * shape + floor;
      result.resolved = (scale * shape) / result.variance.array();
      // Not Eigen's log(): its vector form makes the compiler warn.
      double sum = 0.;
      for (Eigen::Index i = 0; i < energy.size(); ++i)
        sum += std::log(result.variance[i]) + energy[i] / result.variance[i];
      result.likelihood =
        -.5 * sum - .5 * std::log(result.resolved.squaredNorm());
      return result;
    }
  } // namespace



  SpatialCovariance::SpatialCovariance(const std::vector<CellPlace> &places,
                                       const Eigen::MatrixXd        &covariates)
  {
    const Eigen::Index n      = places.size();
    Eigen::MatrixXd    scaled = covariates;
    // a column that is 0 on these cells, as an edge that no image shows, stays
    for (Eigen::Index c = 0; c < scaled.cols(); ++c)
      scaled.col(c).normalize();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
    qr.setThreshold(1e-6);
    const Eigen::Index n_kept = n - qr.rank();
    Eigen::MatrixXd    last   = Eigen::MatrixXd::Zero(n, n_kept);
    last.bottomRows(n_kept).setIdentity();
    kept = qr.householderQ() * last;
    if (n_kept == 0)
      return;
    add(Eigen::MatrixXd::Identity(n, n));
    for (const Kind kind : {Kind::normal, Kind::exponential, Kind::matern})
      for (const double ratio : {.4, .63, 1., 1.6, 2.5})
        for (double length = .7; length < 20.; length *= 1.3)
          add(correlations(places, kind, length, ratio));
  }



  void
  SpatialCovariance::add(const Eigen::MatrixXd &correlation)
  {
    const Eigen::MatrixXd left = kept.transpose() * correlation * kept;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(left);
    Form                                                 form;
    form.axes     = solver.eigenvectors().transpose();
    form.spectrum = solver.eigenvalues().cwiseMax(0.);
    form.spectrum /= form.spectrum.mean();
    forms.push_back(std::move(form));
  }



  Eigen::Index
  SpatialCovariance::n_free() const
  {
    return kept.cols();
  }



  Eigen::VectorXd
  SpatialCovariance::residual(const Eigen::VectorXd &map) const
  {
    return kept.transpose() * map;
  }



  const Eigen::MatrixXd &
  SpatialCovariance::axes(const std::size_t form) const
  {
    return forms[form].axes;
  }



  Eigen::VectorXd
  SpatialCovariance::on_cells(const std::size_t      form,
                              const Eigen::VectorXd &along_axes) const
  {
    return kept * (forms[form].axes.transpose() * along_axes);
  }



  std::vector<SpatialCovariance::Fit>
  SpatialCovariance::fit(const Eigen::VectorXd &map) const
  {
    const Eigen::VectorXd left = residual(map);
    const double mean = left.size() > 0 ? left.squaredNorm() / left.size() : 0.;
    std::vector<Fit> fits;
    // a map that is what the covariates say, but for rounding, leaves nothing
    if (!(mean > 1e-20 * map.squaredNorm() / map.size()))
      return fits;
    double best = -1e300;
    for (std::size_t form = 0; form < forms.size(); ++form)
      {
        const Eigen::ArrayXd squares =
          (forms[form].axes * left).array().square();
        double scale = mean, highest = -1e300;
        for (const double own : {0., .1, .03, .3, .6})
          {
            // without likeness the uncorrelated part is all there is; and where
            // neither no such part nor a tenth comes near, no other does
            if ((form == 0 && own > 0.) || (own == .03 && highest < best - 30.))
              break;
            const auto member =
              scaled(squares,
                     (1. - own) * forms[form].spectrum.array() + own,
                     resolution * mean,
                     scale);
            if (!member)
              continue;
            highest = std::max(highest, member->likelihood);
            best    = std::max(best, member->likelihood);
            if (member->likelihood > best - 9.2)
              fits.push_back(
                {form, member->likelihood, member->variance, member->resolved});
          }
      }
    double sum = 0.;
    fits.erase(
      std::remove_if(fits.begin(),
                     fits.end(),
                     [best](const Fit &f) { return f.weight < best - 9.2; }),
      fits.end());
    for (Fit &f : fits)
      sum += f.weight = std::exp(f.weight - best);
    for (Fit &f : fits)
      f.weight /= sum;
    return fits;
  }
} // namespace squeal::tribology
