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



    /** A plane and the criterion in it. */
    struct Candidate
    {
      double value, inclination, azimuth;

      /** Cosine of the angle between the two planes. */
      double
      likeness(const Candidate &other) const
      {
        const Vector a = direction(inclination, azimuth),
                     b = direction(other.inclination, other.azimuth);
        return std::abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
      }
    };



    /** Planes @p step apart over the half sphere that are within @p margin of
     * the best one, the best first. */
    std::vector<Candidate>
    good_planes(Planes &planes, const double step, const double margin)
    {
      const unsigned int n =
        static_cast<unsigned int>(std::ceil(M_PI / 2. / step));
      double                 best = -1e300;
      std::vector<Candidate> found;
      const auto             limit = [&best, margin]() {
        return best - margin * std::abs(best);
      };
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double       t = M_PI / 2. * i / n;
          const unsigned int m =
            std::max(1., std::ceil(2. * M_PI * std::sin(t) / step));
          for (unsigned int j = 0; j < m; ++j)
            {
              const double p = 2. * M_PI * j / m;
              const double v =
                planes.value(t, p, found.empty() ? best : limit());
              best = std::max(best, v);
              if (found.empty() || v > limit())
                found.push_back({v, t, p});
            }
        }
      found.erase(
        std::remove_if(found.begin(),
                       found.end(),
                       [&](const Candidate &c) { return c.value < limit(); }),
        found.end());
      std::sort(
        found.begin(), found.end(), [](const Candidate &a, const Candidate &b) {
          return a.value > b.value;
        });
      return found;
    }



    /** Compass search in sixteen directions, steps of equal length on the
     * sphere, down to 1e-7 rad: a ridge, where another sample becomes the
     * largest, may lead in any of them. */
    Candidate
    polished(Planes &planes, Candidate plane, const double step)
    {
      for (double h = step; h > 1e-7; h *= .5)
        for (bool moved = true; moved;)
          {
            moved = false;
            const double across =
              h / std::max(std::sin(plane.inclination), 1e-3);
            const Candidate from = plane;
            for (unsigned int k = 0; k < 16; ++k)
              {
                const double t = from.inclination + h * std::cos(M_PI * k / 8.);
                const double p =
                  from.azimuth + across * std::sin(M_PI * k / 8.);
                const double v = planes.value(t, p, plane.value);
                if (v > plane.value)
                  {
                    plane = {v, t, p};
                    moved = true;
                  }
              }
          }
      return plane;
    }
  } // namespace



  CriterionValue
  search_planes(const StressHistory  &history,
                const MaterialLimits &limits,
                const PlaneCriterion &criterion,
                const double          step_in_degrees)
  {
    constexpr std::size_t n_polished = 16;
    Planes                planes(history, limits, criterion);
    const double          step = step_in_degrees * M_PI / 180.;
    // The nearest plane of the grid is up to 0.7 steps away from a maximum;
    // with the curvature of stresses, a few, it is lower by that part.
    const double           margin = std::min(.7, 3. * step * step);
    std::vector<Candidate> starts;
    for (const Candidate &plane : good_planes(planes, step, margin))
      if (starts.size() < n_polished &&
          std::none_of(starts.begin(), starts.end(), [&](const Candidate &c) {
            return plane.likeness(c) > std::cos(1.6 * step);
          }))
        starts.push_back(plane);
    Candidate best = starts.at(0);
    for (const Candidate &start : starts)
      {
        const Candidate plane = polished(planes, start, .5 * step);
        if (plane.value > best.value)
          best = plane;
      }
    CriterionValue result;
    result.value  = best.value;
    result.normal = direction(best.inclination, best.azimuth);
    if (result.normal[2] < 0.)
      for (double &component : result.normal)
        component = -component;
    return result;
  }
} // namespace squeal::tribology
