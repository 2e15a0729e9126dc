// SPDX-License-Identifier: LGPL-2.1-or-later

// Multiaxial criteria against their closed forms, in phase and out of phase.
#include <squeal/base/exceptions.h>
#include <squeal/tribology/criteria/critical_plane.h>
#include <squeal/tribology/criteria/enclosing_ball.h>

#include <random>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  using C = SubsurfaceParameters::Criterion;

  MaterialLimits
  steel()
  {
    MaterialLimits m;
    m.axial          = 300.;
    m.torsion        = 190.;
    m.repeated       = 250.;
    m.yield          = 350.;
    m.tensile        = 300.;
    m.compressive    = 900.;
    m.youngs_modulus = 2e5;
    return m;
  }

  /** One period; the extremes are among the samples. */
  template <typename Load>
  StressHistory
  period(const Load &load)
  {
    StressHistory history;
    for (unsigned int i = 0; i < 64; ++i)
      history.push_back(load(2. * M_PI * i / 64.));
    return history;
  }

  CriterionValue
  evaluate(const C c, const StressHistory &h, const MaterialLimits &m = steel())
  {
    return evaluate_criterion(c, h, m);
  }

  /** Printed with six decimals; the plane search is good to 1e-9. */
  void
  is(const double got, const double printed, const std::string &name)
  {
    check(std::abs(got - printed) <= 5.1e-7,
          name + ": " + std::to_string(got) + ", reference " +
            std::to_string(printed));
  }

  void
  factors()
  {
    const MaterialLimits m = steel();
    check_close(m.dang_van_a(), .4, 1e-12, "Dang Van a");
    check(std::abs(m.findley_k() - .27668579) < 5.1e-9, "Findley k");
    check(std::abs(m.findley_f() - 197.13862220) < 5.1e-9, "Findley f");
    check(std::abs(m.crossland_a() - .16794919) < 5.1e-9, "Crossland a");
    check(std::abs(m.sines_a() - .54794919) < 5.1e-9, "Sines a");
  }

  void
  limits_are_met()
  {
    const StressHistory axial   = period([](const double t) {
      return Stress{{300. * std::sin(t), 0, 0, 0, 0, 0}};
    });
    const StressHistory torsion = period([](const double t) {
      return Stress{{0, 0, 0, 190. * std::sin(t), 0, 0}};
    });
    for (const auto &[c, name] : {std::pair{C::dang_van, "Dang Van"},
                                  {C::crossland, "Crossland"},
                                  {C::findley, "Findley"}})
      {
        check_close(evaluate(c, axial).utilisation(),
                    1.,
                    1e-9,
                    std::string(name) + ": 1 at the axial limit");
        check_close(evaluate(c, torsion).utilisation(),
                    1.,
                    1e-9,
                    std::string(name) + ": 1 at the torsion limit");
      }
    check_close(evaluate(C::sines, torsion).utilisation(), 1., 1e-9, "Sines");
    check_close(
      evaluate(C::sines, period([](const double t) {
                 return Stress{{250. * (1. + std::sin(t)), 0, 0, 0, 0, 0}};
               }))
        .utilisation(),
      1.,
      1e-9,
      "Sines: 1 at the repeated limit");
    check_close(evaluate(C::swt, axial).utilisation(),
                1.,
                1e-9,
                "SWT: 1 at the axial limit");
    check_close(evaluate(C::fatemi_socie, torsion).utilisation(),
                1.,
                1e-9,
                "Fatemi-Socie: 1 at the torsion limit");
    MaterialLimits no_k = steel();
    no_k.fatemi_socie_k = 0.;
    check_close(evaluate(C::fatemi_socie, torsion, no_k).value,
                190. * 2.6 / 2e5,
                1e-9,
                "Fatemi-Socie without k: the shear strain amplitude");
    // Under 500 MPa from all sides every plane is pressed all the time.
    StressHistory pressed = torsion;
    for (Stress &stress : pressed)
      for (const int i : {0, 1, 2})
        stress[i] -= 500.;
    check_close(evaluate(C::fatemi_socie, pressed).value,
                190. * 2.6 / 2e5,
                1e-9,
                "Fatemi-Socie: pressure takes nothing off the shear strain");
    check_close(evaluate(C::rankine, axial).value, 300., 1e-9, "Rankine");
    check_close(evaluate(C::rankine, torsion).value,
                190.,
                1e-9,
                "Rankine: torsion pulls too");
    for (const double s : {300., -900.})
      check_close(
        evaluate(C::drucker_prager, {{{s, 0, 0, 0, 0, 0}}}).utilisation(),
        1.,
        1e-9,
        "Drucker-Prager: 1 at " + std::to_string(s));
    const CriterionValue findley = evaluate(C::findley, axial);
    const double angle = std::acos(std::abs(findley.normal[0])) * 180. / M_PI;
    check(std::abs(angle - 37.2670) <= 5.1e-5,
          "Findley: normal " + std::to_string(angle) + " degrees off the axis");
    check_close(std::tan(2. * angle * M_PI / 180.) * steel().findley_k(),
                1.,
                1e-5,
                "tan 2 theta = 1/k");
  }

  void
  combined_loads()
  {
    const StressHistory in_phase = period([](const double t) {
      return Stress{{200. * std::sin(t), 0, 0, 100. * std::sin(t), 0, 0}};
    });
    is(evaluate(C::findley, in_phase).value, 174.403375, "Findley in phase");
    is(evaluate(C::dang_van, in_phase).value, 168.088023, "Dang Van in phase");
    is(
      evaluate(C::crossland, in_phase).value, 163.949136, "Crossland in phase");
    is(evaluate(C::findley, period([](const double t) {
                  return Stress{{100. + 200. * std::sin(t), 0, 0, 0, 0, 0}};
                }))
         .value,
       149.773307,
       "Findley with a mean");
    is(
      sqrt_j2_amplitude(period([](const double t) {
        return Stress{
          {200. * std::sin(t), 0, 0, 200. / std::sqrt(3.) * std::cos(t), 0, 0}};
      })),
      115.470054,
      "sqrt(J2) amplitude of a path with constant J2");
  }

  /** A criterion does not care how the frame is turned. */
  void
  turned_frames()
  {
    std::mt19937_64                  generator(3);
    std::normal_distribution<double> normal;
    StressHistory                    history, turned;
    const double                     c = std::cos(.7), s = std::sin(.7);
    for (unsigned int i = 0; i < 40; ++i)
      {
        Stress a;
        for (double &x : a)
          x = 100. * normal(generator);
        history.push_back(a);
        // about z
        turned.push_back({{c * c * a[0] + s * s * a[1] - 2. * c * s * a[3],
                           s * s * a[0] + c * c * a[1] + 2. * c * s * a[3],
                           a[2],
                           c * s * (a[0] - a[1]) + (c * c - s * s) * a[3],
                           s * a[5] + c * a[4],
                           c * a[5] - s * a[4]}});
      }
    for (const C criterion : {C::dang_van,
                              C::crossland,
                              C::findley,
                              C::sines,
                              C::swt,
                              C::fatemi_socie,
                              C::rankine,
                              C::drucker_prager})
      check_close(evaluate(criterion, turned).value,
                  evaluate(criterion, history).value,
                  1e-6,
                  "turned frame, criterion " + std::to_string(int(criterion)));
  }

  void
  balls()
  {
    std::mt19937_64                  generator(9);
    std::normal_distribution<double> normal;
    for (unsigned int n : {1u, 2u, 3u, 7u, 50u, 400u})
      {
        std::vector<Point5> points(n);
        for (Point5 &p : points)
          for (unsigned int i = 0; i < 5; ++i)
            p(i) = normal(generator);
        const Ball5 ball = smallest_enclosing_ball(points);
        Worst       largest;
        for (const Point5 &p : points)
          largest.add((p - ball.centre).norm());
        check_close(largest.largest(),
                    ball.radius,
                    1e-9,
                    "a ball holds its " + std::to_string(n) + " points",
                    1e-9);
        // smallest: no small step of the centre brings all points nearer
        for (unsigned int k = 0; k < 50; ++k)
          {
            Point5 step;
            for (unsigned int i = 0; i < 5; ++i)
              step(i) = 1e-4 * normal(generator);
            Worst other;
            for (const Point5 &p : points)
              other.add((p - ball.centre - step).norm());
            if (!(other.largest() >= ball.radius))
              check(false, "a smaller ball is found");
          }
      }
    // the circle as the ball in a plane
    std::vector<double> x, y;
    std::vector<Point5> flat;
    for (unsigned int i = 0; i < 100; ++i)
      {
        x.push_back(normal(generator));
        y.push_back(2. * normal(generator));
        flat.push_back(Point5::Zero());
        flat.back()(1) = x.back();
        flat.back()(3) = y.back();
      }
    check_close(smallest_enclosing_circle(x, y),
                smallest_enclosing_ball(flat).radius,
                1e-9,
                "the circle is the ball in a plane");
    check(smallest_enclosing_circle({0., 1., 2.}, {0., 1., 2.}) ==
            std::sqrt(2.),
          "points on a line");
  }

  /** A maximum over time or planes would drop it. */
  void
  not_finite_is_refused()
  {
    for (const C criterion : {C::dang_van,
                              C::crossland,
                              C::sines,
                              C::findley,
                              C::swt,
                              C::fatemi_socie,
                              C::drucker_prager,
                              C::rankine})
      for (const double bad : {std::nan(""), 1. / 0.})
        {
          StressHistory history(8, Stress{{1., 2., 3., 0., 0., 0.}});
          history[3][0] = bad;
          check_throws<ComputationError>(
            [&] { evaluate_criterion(criterion, history, steel(), 10.); },
            "is not finite",
            "a stress that is not finite is refused");
        }
  }

  /** Findley's value in one plane, from its definition. */
  double
  findley_in_plane(const StressHistory &history,
                   const double         inclination,
                   const double         azimuth)
  {
    const double ct = std::cos(inclination), st = std::sin(inclination),
                 cp = std::cos(azimuth), sp = std::sin(azimuth);
    const Eigen::Vector3d n(st * cp, st * sp, ct), a(ct * cp, ct * sp, -st),
      b(-sp, cp, 0.);
    std::vector<double> x, y;
    double              normal = -1e300;
    for (const Stress &s : history)
      {
        Eigen::Matrix3d t;
        t << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
        const Eigen::Vector3d traction = t * n;
        if (!(traction.dot(n) <= normal))
          normal = traction.dot(n);
        x.push_back(traction.dot(a));
        y.push_back(traction.dot(b));
      }
    return smallest_enclosing_circle(x, y) + steel().findley_k() * normal;
  }

  /** No plane is worse than the one that is found: paths of all six stresses
   * with up to three harmonics have many maxima of similar height. */
  void
  no_plane_is_worse()
  {
    std::mt19937_64                        generator(2);
    std::uniform_real_distribution<double> number(-100., 100.);
    Worst                                  lowest;
    for (unsigned int k = 0; k < 8; ++k)
      {
        double waves[6][7];
        for (auto &component : waves)
          for (double &v : component)
            v = number(generator);
        const StressHistory history = period([&](const double t) {
          Stress s;
          for (unsigned int c = 0; c < 6; ++c)
            {
              s[c] = waves[c][6];
              for (unsigned int h = 0; h < 3; ++h)
                s[c] += (waves[c][2 * h] * std::cos((h + 1) * t) +
                         waves[c][2 * h + 1] * std::sin((h + 1) * t)) /
                        (h + 1.);
            }
          return s;
        });
        Worst               of_grid;
        const double        step = M_PI / 180.;
        for (double t = 0.; t < M_PI / 2.; t += step)
          for (double p = 0.; p < 2. * M_PI;
               p += step / std::max(.02, std::sin(t)))
            of_grid.add(findley_in_plane(history, t, p));
        const CriterionValue found = evaluate(C::findley, history);
        lowest.add(found.value / of_grid.largest(),
                   "path " + std::to_string(k));
        // what is said to be reached is reached in that plane
        const auto &n = found.normal;
        check_close(
          findley_in_plane(history, std::acos(n[2]), std::atan2(n[1], n[0])),
          found.value,
          1e-9,
          "Findley's value is that of its plane");
      }
    check_above(lowest, 1., "no plane of a grid of 1 degree is worse");
  }

  /** A plane that dips with the sliding is another one than that which dips
   * against it: turned about z its normal turns by the same angle, mirrored in
   * x to the other side. */
  void
  planes_turn_with_the_stresses()
  {
    std::mt19937_64                  generator(9);
    std::normal_distribution<double> normal(0., 100.);
    Worst                            turned_by, mirrored_to;
    unsigned int                     n_beyond = 0;
    for (unsigned int k = 0; k < 12; ++k)
      {
        StressHistory history(6), turned(6), mirrored(6);
        const double  angle = 30. * k + 7., c = std::cos(angle * M_PI / 180.),
                     s = std::sin(angle * M_PI / 180.);
        for (unsigned int i = 0; i < 6; ++i)
          {
            Stress &x = history[i];
            for (double &component : x)
              component = normal(generator);
            turned[i]   = {{c * c * x[0] + s * s * x[1] - 2. * s * c * x[3],
                            s * s * x[0] + c * c * x[1] + 2. * s * c * x[3],
                            x[2],
                            s * c * (x[0] - x[1]) + (c * c - s * s) * x[3],
                            c * x[4] + s * x[5],
                            c * x[5] - s * x[4]}};
            mirrored[i] = {{x[0], x[1], x[2], -x[3], x[4], -x[5]}};
          }
        const CriterionValue a = evaluate(C::findley, history),
                             b = evaluate(C::findley, turned),
                             m = evaluate(C::findley, mirrored);
        if (a.inclination() > 89.)
          continue;
        n_beyond += std::abs(a.azimuth()) > 90.;
        const std::string path = "path " + std::to_string(k);
        turned_by.add(
          std::abs(std::remainder(b.azimuth() - a.azimuth() - angle, 360.)),
          path);
        mirrored_to.add(
          std::abs(std::remainder(180. - a.azimuth() - m.azimuth(), 360.)),
          path);
      }
    check(turned_by.largest() <= 1e-2, "planes turn with the stresses");
    check(mirrored_to.largest() <= 1e-2,
          "planes are mirrored with the stresses");
    check(n_beyond > 0, "some point against +x");
  }

  /** A criterion that is 0 in all planes has no critical one. */
  void
  pressed_has_no_plane()
  {
    const StressHistory pressed = period([](const double t) {
      return Stress{{-5., -5., -20. - std::cos(t), 0., 0., 0.}};
    });
    check(!evaluate(C::swt, pressed).has_plane(), "no plane is pulled");
    check(evaluate(C::findley, pressed).has_plane(), "some plane is sheared");
  }

  /** A grid of planes four times finer finds nothing better: where two maxima
   * of similar height compete the coarse grid alone cannot tell which is the
   * higher one. */
  void
  grid_does_not_matter()
  {
    std::mt19937_64                  generator(5);
    std::normal_distribution<double> normal(0., 100.);
    Worst                            lowest;
    for (unsigned int k = 0; k < 400; ++k)
      {
        StressHistory history(10);
        for (Stress &s : history)
          for (double &component : s)
            component = normal(generator);
        lowest.add(
          evaluate_criterion(C::findley, history, steel(), 5.).value /
            evaluate_criterion(C::findley, history, steel(), 1.25).value,
          "path " + std::to_string(k));
      }
    check_above(lowest, 1. - 1e-9, "planes 5 degrees apart do, of 400 paths");
  }
} // namespace



int
main()
{
  not_finite_is_refused();
  factors();
  limits_are_met();
  combined_loads();
  turned_frames();
  balls();
  no_plane_is_worse();
  planes_turn_with_the_stresses();
  pressed_has_no_plane();
  grid_does_not_matter();
}
