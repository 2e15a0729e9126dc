// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/fatigue/accumulation.h>

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace squeal::tribology
{
  void
  MansonHalford::add(const double n, const double damage)
  {
    if (n == 0. || damage == 0.)
      return;
    if (!std::isfinite(damage))
      {
        breaks = true;
        return;
      }
    Level &level = levels[int(std::floor(levels_per_e * std::log(damage)))];
    level.n += n;
    level.damage += n * damage;
  }



  double
  MansonHalford::share() const
  {
    if (breaks)
      return std::numeric_limits<double>::infinity();
    if (levels.empty())
      return 0.;
    Eigen::ArrayXd weights(levels.size()), rates(levels.size());
    Eigen::Index   i = 0;
    for (const auto &[number, level] : levels)
      {
        const double damage = level.damage / level.n;
        rates[i]            = std::pow(damage, 0.4);
        weights[i++]        = level.n * std::pow(damage, 0.6);
      }
    // The integrand has its poles at least pi from the axis, in units of the
    // largest rate: eight points on a piece of two units leave rounding.
    const dealii::QGauss<1> gauss(8);
    const double            piece = 2. / rates.maxCoeff();
    double                  life  = 0.;
    for (double from = 0.;; from += piece)
      {
        for (unsigned int q = 0; q < gauss.size(); ++q)
          life += piece * gauss.weight(q) /
                  (weights * (rates * (from + piece * gauss.point(q)[0])).exp())
                    .sum();
        const Eigen::ArrayXd terms = weights * (rates * (from + piece)).exp();
        // The slope only grows: this is the most that the rest can be.
        const double rest = 1. / (terms * rates).sum();
        if (rest < std::numeric_limits<double>::epsilon() * life)
          return 1. / life;
      }
  }
} // namespace squeal::tribology
