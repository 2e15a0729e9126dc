// SPDX-License-Identifier: LGPL-2.1-or-later

// Stress under a half-space's face from patches of uniform traction, against
// Hertz and sliding line contact; the error falls with the patches.
#include <squeal/tribology/subsurface/half_space.h>

#include <array>
#include <vector>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  /** Mean of sqrt(1 - x^2) between two places. */
  double
  mean_of_circle(const double a, const double b)
  {
    const auto integral = [](const double x) {
      return .5 * (x * std::sqrt(std::max(0., 1. - x * x)) +
                   std::asin(std::min(1., std::max(-1., x))));
    };
    return (integral(b) - integral(a)) / (b - a);
  }

  /** xx, zz, xz under a sliding Hertz line contact, q = mu p along +x. */
  Eigen::Vector3d
  line_contact(const double mu, const unsigned int n, const double x, double z)
  {
    Eigen::Vector3d s = Eigen::Vector3d::Zero();
    for (unsigned int i = 0; i < n; ++i)
      {
        const double a = -1. + 2. * i / n, b = -1. + 2. * (i + 1) / n;
        const double p = mean_of_circle(a, b);
        s += strip_influence(a, b, x, z) * Eigen::Vector2d(mu * p, p);
      }
    return s;
  }

  double
  shear(const Eigen::Vector3d &s)
  {
    return std::hypot(.5 * (s(0) - s(1)), s(2));
  }

  struct Maximum
  {
    double value, x, z;
  };

  /** Largest in-plane shear below @p z_min, by compass search. */
  Maximum
  largest_shear(const double       mu,
                const unsigned int n,
                const double       z_min,
                double             x,
                double             z)
  {
    double best = shear(line_contact(mu, n, x, z));
    for (double h = .05; h > 1e-5; h *= .5)
      for (bool moved = true; moved;)
        {
          moved = false;
          for (const auto &[dx, dz] : {std::pair{h, 0.},
                                       {-h, 0.},
                                       {0., h},
                                       {0., -h},
                                       {h, -h},
                                       {-h, h}})
            if (z + dz >= z_min)
              if (const double v = shear(line_contact(mu, n, x + dx, z + dz));
                  v > best)
                {
                  best = v;
                  x += dx;
                  z += dz;
                  moved = true;
                }
        }
    return {best, x, z};
  }

  void
  tensors_of_line_contact()
  {
    struct Point
    {
      double x, z, xx, zz, xz;
    };
    const std::array<Point, 3> points{
      {{.3, .5, -.416357433765, -.884842074438, -.239002990555},
       {-.8, .2, -.028611172963, -.471654991849, .031608830156},
       {1.2, .4, -.536, -.184, -.272}}};
    double before = 0.;
    for (const unsigned int n : {25u, 100u, 400u, 1600u})
      {
        Worst error;
        for (const Point &p : points)
          {
            // the third one is printed to three digits
            if (p.x == 1.2)
              continue;
            const Eigen::Vector3d s = line_contact(.4, n, p.x, p.z);
            error.add(std::abs(s(0) - p.xx));
            error.add(std::abs(s(1) - p.zz));
            error.add(std::abs(s(2) - p.xz));
          }
        const double order =
          before > 0. ? std::log(before / error.largest()) / std::log(4.) : 0.;
        std::cout << n << " strips: error " << error.largest() << ", order "
                  << order << "\n";
        if (before > 0.)
          check(order > 1.4,
                "the error falls with order " + std::to_string(order));
        before = error.largest();
      }
    check(before < 1e-6, "1600 strips: " + std::to_string(before));
    const Eigen::Vector3d s = line_contact(.4, 1600, 1.2, .4);
    std::cout << s.transpose() << "\n";
    check(std::abs(s(0) + .536) < 5.1e-4 && std::abs(s(1) + .184) < 5.1e-4 &&
            std::abs(s(2) + .272) < 5.1e-4,
          "outside the contact");
  }

  void
  maxima_of_line_contact()
  {
    const unsigned int n = 1000;
    const Maximum      m = largest_shear(0., n, 1e-3, .1, .5);
    check(std::abs(m.value - .3002831) < 1e-6 && std::abs(m.x) < 1e-2 &&
            std::abs(m.z - .7861514) < 1e-3,
          "Hertz line: " + std::to_string(m.value) + " at " +
            std::to_string(m.z));
    struct Row
    {
      double mu, value, x, z;
    };
    for (const Row &r : {Row{.2, .318989, .625, .601},
                         Row{.3, .344881, .864, .380},
                         Row{.35, .364095, .954, .233}})
      {
        const Maximum found = largest_shear(r.mu, n, 1e-3, r.x - .1, r.z + .1);
        check(
          std::abs(found.value - r.value) < 2e-6 &&
            std::abs(found.x - r.x) < 2e-3 && std::abs(found.z - r.z) < 2e-3,
          "mu " + std::to_string(r.mu) + ": " + std::to_string(found.value) +
            " at " + std::to_string(found.x) + ", " + std::to_string(found.z));
      }
    // at the surface the shear is mu p0 all over the contact
    for (const double mu : {.37, .38})
      for (const double x : {-.7, 0., .4})
        check_close(shear(line_contact(mu, n, x + 1. / n, 1e-7)),
                    mu,
                    2e-3,
                    "shear at the surface for mu " + std::to_string(mu));
    const Maximum below = largest_shear(.37, n, 1e-3, .95, .2);
    check(below.value > .37 + 1e-4 && below.z > .02,
          "mu = 0.37: the maximum lies below the surface, " +
            std::to_string(below.value) + " at depth " +
            std::to_string(below.z));
    Worst deep;
    for (double x = .7; x < 1.1; x += .01)
      for (double z = .03; z < .5; z += .01)
        deep.add(shear(line_contact(.38, n, x, z)));
    check(deep.largest() < .38,
          "mu = 0.38: at the surface; below 0.03 a it is " +
            std::to_string(deep.largest()));
    // tension behind the contact
    check_close(line_contact(.5, 4000, -1. - 1e-6, 1e-9)(0),
                1.,
                3e-2,
                "tension 2 mu p0 at the trailing edge");
  }

  /** Mean of sqrt(1 - r^2) over a square: 8 x 8 points where the rim cuts. */
  double
  mean_of_sphere(const double x, const double y, const double h)
  {
    const unsigned int m   = 16;
    double             sum = 0.;
    for (unsigned int i = 0; i < m; ++i)
      for (unsigned int j = 0; j < m; ++j)
        {
          const double a = x + h * ((i + .5) / m - .5);
          const double b = y + h * ((j + .5) / m - .5);
          sum += std::sqrt(std::max(0., 1. - a * a - b * b));
        }
    return sum / (m * m);
  }

  void
  point_contact()
  {
    struct Row
    {
      double nu, value, z;
    };
    for (const Row &r : {Row{.3, .31002, .48086},
                         Row{.25, .32168, .46431},
                         Row{.4, .28761, .51417}})
      {
        double before = 0.;
        for (const unsigned int n : {16u, 32u, 64u})
          {
            const double h  = 2. / n;
            const auto   at = [&](const double z) {
              PatchInfluence s = PatchInfluence::Zero();
              for (unsigned int i = 0; i < n; ++i)
                for (unsigned int j = 0; j < n; ++j)
                  {
                    const double x = -1. + (i + .5) * h, y = -1. + (j + .5) * h;
                    s += mean_of_sphere(x, y, h) *
                         patch_influence(
                           {x - .5 * h, x + .5 * h, y - .5 * h, y + .5 * h},
                           0.,
                           0.,
                           z,
                           r.nu);
                  }
              return .5 * (s(0, 2) - s(2, 2));
            };
            // in closed form: Johnson (1985), eq. 3.45
            const auto exact = [&](const double z) {
              const double p =
                -(1. + r.nu) * (1. - z * std::atan(1. / z)) + .5 / (1. + z * z);
              return .5 * (p + 1. / (1. + z * z));
            };
            Worst error;
            for (const double z : {.2, .48086, 1.})
              error.add(std::abs(at(z) - exact(z)));
            std::cout << "nu " << r.nu << ", " << n << " x " << n
                      << " patches: error " << error.largest() << "\n";
            if (before > 0.)
              check(error.largest() < .45 * before,
                    "order " +
                      std::to_string(std::log2(before / error.largest())));
            before = error.largest();
            if (n == 64)
              {
                check(error.largest() < 1e-4, "64 x 64 patches: 1e-4");
                check(std::abs(at(r.z) - r.value) < 1e-4 &&
                        at(r.z) > at(r.z - .02) && at(r.z) > at(r.z + .02),
                      "Hertz point: " + std::to_string(at(r.z)) + " at " +
                        std::to_string(r.z));
              }
          }
      }
  }

  /** One patch against the sum of many small ones, and Cauchy's equations. */
  void
  equilibrium()
  {
    const Patch  patch{-.5, .7, -.3, .4};
    const double x = .31, y = -.17, z = .23, h = 1e-4, nu = .3;
    const auto   at = [&](const double a, const double b, const double c) {
      return patch_influence(patch, a, b, c, nu);
    };
    const PatchInfluence dx = (at(x + h, y, z) - at(x - h, y, z)) / (2. * h);
    const PatchInfluence dy = (at(x, y + h, z) - at(x, y - h, z)) / (2. * h);
    const PatchInfluence dz = (at(x, y, z + h) - at(x, y, z - h)) / (2. * h);
    for (unsigned int load = 0; load < 3; ++load)
      {
        const double fx = dx(0, load) + dy(3, load) + dz(5, load);
        const double fy = dx(3, load) + dy(1, load) + dz(4, load);
        const double fz = dx(5, load) + dy(4, load) + dz(2, load);
        check(std::abs(fx) + std::abs(fy) + std::abs(fz) < 1e-6,
              "load " + std::to_string(load) + " is in equilibrium");
      }
    // tractions at the face: inside (t_x, t_y, -p) = -(xz, yz), zz
    const PatchInfluence face = at(.1, .1, 1e-9);
    check_close(face(5, 0), -1., 1e-6, "shear xz under a traction x");
    check_close(face(4, 1), -1., 1e-6, "shear yz under a traction y");
    check_close(face(2, 2), -1., 1e-6, "stress zz under a pressure");
    const PatchInfluence out = at(1.1, .1, 1e-9);
    check(std::abs(out(5, 0)) + std::abs(out(4, 1)) + std::abs(out(2, 2)) <
            1e-6,
          "a free face beside the patch");
    // strain compatibility is tested by the sum of halves and by turning
    const PatchInfluence halves =
      patch_influence({-.5, .1, -.3, .4}, x, y, z, nu) +
      patch_influence({.1, .7, -.3, .4}, x, y, z, nu);
    check((halves - at(x, y, z)).norm() < 1e-12, "a patch is its two halves");
    const PatchInfluence turned =
      patch_influence({-.3, .4, -.7, .5}, y, -x, z, nu);
    const PatchInfluence s = at(x, y, z);
    // axes x' = y, y' = -x: traction x is -y', stress xx is y'y'
    check(std::abs(s(0, 0) + turned(1, 1)) + std::abs(s(2, 0) + turned(2, 1)) +
              std::abs(s(5, 0) - turned(4, 1)) +
              std::abs(s(3, 2) + turned(3, 2)) +
              std::abs(s(0, 1) - turned(1, 0)) <
            1e-12,
          "tractions along x and y are one another's image");
    // far away a patch is a strip in plane strain
    const PatchInfluence long_patch =
      patch_influence({-.5, .7, -1e8, 1e8}, x, 0., z, nu);
    const StripInfluence strip = strip_influence(-.5, .7, x, z);
    for (const auto &[row, in_strip] : {std::pair{0, 0}, {2, 1}, {5, 2}})
      check(std::abs(long_patch(row, 2) - strip(in_strip, 1)) < 1e-7 &&
              std::abs(long_patch(row, 0) - strip(in_strip, 0)) < 1e-7,
            "a long patch is a strip, component " + std::to_string(row));
    check_close(
      long_patch(1, 2), nu * (strip(0, 1) + strip(1, 1)), 1e-6, "plane strain");
    check(is_near_edge(2.9e-4, 1e-4) && !is_near_edge(3.1e-4, 1e-4),
          "cells within three depths of an edge are flagged");
  }
} // namespace



int
main()
{
  equilibrium();
  tensors_of_line_contact();
  maxima_of_line_contact();
  point_contact();
}
