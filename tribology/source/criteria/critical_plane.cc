// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/criteria/critical_plane.h>
#include <squeal/tribology/criteria/enclosing_ball.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    using Vector = std::array<double, 3>;

    Vector
    direction(const double inclination, const double azimuth)
    {
      return {{std::sin(inclination) * std::cos(azimuth),
               std::sin(inclination) * std::sin(azimuth),
               std::cos(inclination)}};
    }



    /** u . S v as the product with the six components of S. */
    Stress
    projection(const Vector &u, const Vector &v)
    {
      return {{u[0] * v[0],
               u[1] * v[1],
               u[2] * v[2],
               u[0] * v[1] + u[1] * v[0],
               u[1] * v[2] + u[2] * v[1],
               u[0] * v[2] + u[2] * v[0]}};
    }



    double
    product(const Stress &a, const Stress &b)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < 6; ++i)
        sum += a[i] * b[i];
      return sum;
    }



    /** Evaluates planes; keeps its work space. */
    class Planes
    {
    public:
      Planes(const StressHistory  &history,
             const MaterialLimits &limits,
             const PlaneCriterion &criterion)
        : history(history)
        , limits(limits)
        , criterion(criterion)
        , x(history.size())
        , y(history.size())
      {
      }



      /** The criterion in a plane, or something below @p best if it cannot
       * exceed that. */
      double
      value(const double inclination, const double azimuth, const double best)
      {
        const Vector n = direction(inclination, azimuth);
        const Vector a = direction(inclination + M_PI / 2., azimuth);
        const Vector b{{-std::sin(azimuth), std::cos(azimuth), 0.}};
        const Stress on_n = projection(n, n), on_a = projection(a, n),
                     on_b = projection(b, n);
        double largest = -1e300, smallest_strain = 1e300,
               largest_strain = -1e300;
        const double nu       = limits.poisson_ratio;
        for (std::size_t i = 0; i < history.size(); ++i)
          {
            const Stress &s      = history[i];
            const double  normal = product(on_n, s);
            const double  strain =
              (1. + nu) * normal - nu * (s[0] + s[1] + s[2]);
            x[i]            = product(on_a, s);
            y[i]            = product(on_b, s);
            largest         = std::max(largest, normal);
            smallest_strain = std::min(smallest_strain, strain);
            largest_strain  = std::max(largest_strain, strain);
          }
        PlaneLoad load;
        load.normal_maximum = largest;
        load.normal_amplitude =
          .5 * (largest_strain - smallest_strain) / limits.youngs_modulus;
        const auto [x_min, x_max] = std::minmax_element(x.begin(), x.end());
        const auto [y_min, y_max] = std::minmax_element(y.begin(), y.end());
        load.shear_amplitude =
          .5 * std::hypot(*x_max - *x_min, *y_max - *y_min);
        const double bound = criterion(load);
        if (bound <= best)
          return bound - std::abs(bound) * 1e-15 - 1e-300;
        load.shear_amplitude = smallest_enclosing_circle(x, y);
        return criterion(load);
      }

    private:
      const StressHistory  &history;
      const MaterialLimits &limits;
      const PlaneCriterion &criterion;
      std::vector<double>   x, y;
    };
  } // namespace



  CriterionValue
  search_planes(const StressHistory  &history,
                const MaterialLimits &limits,
                const PlaneCriterion &criterion,
                const double          step_in_degrees)
  {
    Planes             planes(history, limits, criterion);
    const double       step = step_in_degrees * M_PI / 180.;
    const unsigned int n =
      static_cast<unsigned int>(std::ceil(M_PI / 2. / step));
    double best = -1e300, inclination = 0., azimuth = 0.;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double       t = M_PI / 2. * i / n;
        const unsigned int m =
          std::max(1., std::ceil(2. * M_PI * std::sin(t) / step));
        for (unsigned int j = 0; j < m; ++j)
          {
            const double p = 2. * M_PI * j / m;
            const double v = planes.value(t, p, best);
            if (v > best)
              {
                best        = v;
                inclination = t;
                azimuth     = p;
              }
          }
      }
    for (double h = step; h > 1e-7; h *= .5)
      for (bool moved = true; moved;)
        {
          moved = false;
          // steps of equal length on the sphere
          const double across = h / std::max(std::sin(inclination), 1e-3);
          for (const auto &[dt, dp] :
               {std::pair{h, 0.}, {-h, 0.}, {0., across}, {0., -across}})
            {
              const double v =
                planes.value(inclination + dt, azimuth + dp, best);
              if (v > best)
                {
                  best = v;
                  inclination += dt;
                  azimuth += dp;
                  moved = true;
                }
            }
        }
    CriterionValue result;
    result.value  = best;
    result.normal = direction(inclination, azimuth);
    if (result.normal[2] < 0.)
      for (double &component : result.normal)
        component = -component;
    return result;
  }
} // namespace squeal::tribology
