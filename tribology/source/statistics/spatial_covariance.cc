// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/spatial_covariance.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace squeal::tribology
{
  namespace
  {
    /** Members farther than this below the best, as logarithms of the
     * likelihood, weigh less than 1e-4 and are left out. */
    constexpr double far_below = 9.2;

    /** A search goes on from members that are not farther below the best than
     * this, which keeps it out of local maxima. */
    constexpr double reach = 12.;

    /** Flat likelihoods, as of white maps, need no more than these. */
    constexpr std::size_t most_members = 300, most_fits = 64;

    /** Coefficients of principal axes that are kept for later maps. */
    constexpr std::size_t most_coefficients = 40000000;

    /** Parts of the variance that are uncorrelated: none, or those. */
    constexpr double own_parts[] = {0., .1, .03, .3, .6};

    /** One member, its overall variance chosen by the likelihood. */
    struct Scaled
    {
      double likelihood = 0.; /**< log */
      double scale      = 0.; /**< variance */
    };

    /** Spectrum of a member with an uncorrelated part. */
    Eigen::ArrayXd
    with_own(const Eigen::VectorXd &spectrum, const double own)
    {
      return (1. - own) * spectrum.array() + own;
    }

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
      start                         = scale;
      const Eigen::ArrayXd variance = scale * shape + floor,
                           resolved = scale * shape / variance;
      // Not Eigen's log(): its vector form makes the compiler warn.
      double sum = 0.;
      for (Eigen::Index i = 0; i < energy.size(); ++i)
        sum += std::log(variance[i]) + energy[i] / variance[i];
      return Scaled{-.5 * sum - .5 * std::log(resolved.square().sum()), scale};
    }
  } // namespace



  SpatialCovariance::SpatialCovariance(const std::vector<CellPlace> &places,
                                       const Eigen::MatrixXd        &covariates)
    : places(places)
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
  }



  std::size_t
  SpatialCovariance::form_of(const CovarianceMember &member)
  {
    const auto [place, is_new] = known.try_emplace(member, forms.size());
    if (is_new)
      {
        const Eigen::MatrixXd left =
          kept.transpose() * correlations(places, member) * kept;
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(left);
        Form                                                 form;
        form.axes     = solver.eigenvectors().transpose();
        form.spectrum = solver.eigenvalues().cwiseMax(0.);
        form.spectrum /= form.spectrum.mean();
        forms.push_back(std::move(form));
      }
    return place->second;
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



  /** Likelihoods of members for one map, and the best of all. */
  class SpatialCovariance::Search
  {
  public:
    Search(SpatialCovariance &covariance, const Eigen::VectorXd &left)
      : covariance(covariance)
      , left(left)
      , mean(left.squaredNorm() / left.size())
    {
    }

    void
    run()
    {
      for (const CovarianceMember &member : first_members())
        look_at(member);
      while (!front.empty() && front.front().first > best - reach &&
             seen.size() < most_members)
        {
          std::pop_heap(front.begin(), front.end());
          const CovarianceMember member = front.back().second;
          front.pop_back();
          for (const CovarianceMember &other : neighbours(member))
            look_at(other);
        }
    }

    /** The members that matter, the likeliest first. */
    std::vector<Fit>
    fits()
    {
      std::stable_sort(
        found.begin(), found.end(), [](const Found &a, const Found &b) {
          return a.likelihood > b.likelihood;
        });
      std::vector<Fit> result;
      double           sum = 0.;
      for (const Found &f : found)
        {
          if (result.size() == most_fits || !(f.likelihood > best - far_below))
            break;
          const Eigen::VectorXd part =
            f.scale *
            with_own(covariance.forms[f.form].spectrum, f.own).matrix();
          Fit fit;
          fit.form     = f.form;
          fit.weight   = std::exp(f.likelihood - best);
          fit.variance = part.array() + resolution * mean;
          fit.resolved = part.cwiseQuotient(fit.variance);
          sum += fit.weight;
          result.push_back(std::move(fit));
        }
      for (Fit &fit : result)
        fit.weight /= sum;
      return result;
    }

  private:
    struct Found
    {
      std::size_t form = 0;
      double      own = 0., likelihood = 0., scale = 0.;
    };

    void
    look_at(const CovarianceMember &member)
    {
      if (!seen.insert(member).second)
        return;
      const std::size_t     form     = covariance.form_of(member);
      const Eigen::VectorXd spectrum = covariance.forms[form].spectrum;
      const Eigen::ArrayXd  squares =
        (covariance.forms[form].axes * left).array().square();
      double scale = mean, highest = -1e300;
      for (const double own : own_parts)
        {
          // without likeness the uncorrelated part is all there is; and where
          // neither no such part nor a tenth comes near, no other does
          if ((member.is_white() && own > 0.) ||
              (own == .03 && highest < best - 30.))
            break;
          const auto result =
            scaled(squares, with_own(spectrum, own), resolution * mean, scale);
          if (!result)
            continue;
          highest = std::max(highest, result->likelihood);
          best    = std::max(best, result->likelihood);
          found.push_back({form, own, result->likelihood, result->scale});
        }
      front.push_back({highest, member});
      std::push_heap(front.begin(), front.end());
    }

    SpatialCovariance                               &covariance;
    const Eigen::VectorXd                           &left;
    double                                           mean = 0., best = -1e300;
    std::set<CovarianceMember>                       seen;
    std::vector<Found>                               found;
    std::vector<std::pair<double, CovarianceMember>> front; /**< a heap */
  };



  std::vector<SpatialCovariance::Fit>
  SpatialCovariance::fit(const Eigen::VectorXd &map)
  {
    if (forms.size() * kept.cols() * kept.cols() > most_coefficients)
      {
        forms.clear();
        known.clear();
      }
    const Eigen::VectorXd left = residual(map);
    // a map that is what the covariates say, but for rounding, leaves nothing
    if (left.size() == 0 || !(left.squaredNorm() / left.size() >
                              1e-20 * map.squaredNorm() / map.size()))
      return {};
    Search search(*this, left);
    search.run();
    return search.fits();
  }
} // namespace squeal::tribology
