// SPDX-License-Identifier: LGPL-2.1-or-later

// Stress in a block from half-space kernels and their correction by finite
// elements: exact states, free sides, equilibrium, and no correction where the
// block is large.
#include <squeal/tribology/subsurface/pad_block.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  using Stress = Eigen::Matrix<double, 6, 3>;

  const Patch face{-1., 1., -1., 1.};
  const Patch patch{.6, 1., -.2, .4}; // at its rim

  /** Thickness 2. */
  PadBlock
  block(const double nu, const double finest, const double coarsest)
  {
    return {face, 2., nu, finest, coarsest};
  }

  /** Half-space and correction for tractions on a rectangle, cut into patches
   * that are small against the block. */
  std::vector<Stress>
  total(const PadBlock                &b,
        const Patch                   &loaded,
        const std::vector<BlockPoint> &points)
  {
    constexpr unsigned int n = 4;
    const double           w = (loaded.x_max - loaded.x_min) / n;
    const double           h = (loaded.y_max - loaded.y_min) / n;
    std::vector<Patch>     patches;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        patches.push_back({loaded.x_min + i * w,
                           loaded.x_min + (i + 1) * w,
                           loaded.y_min + j * h,
                           loaded.y_min + (j + 1) * h});
    const Eigen::MatrixXd correction = block_correction(b, patches, points);
    std::vector<Stress>   result;
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        result.push_back(patch_influence(
          loaded, points[i][0], points[i][1], points[i][2], b.poisson_ratio));
        for (std::size_t k = 0; k < patches.size(); ++k)
          result.back() += correction.block<6, 3>(6 * i, 3 * k);
      }
    return result;
  }



  /** The displacement kernel belongs to the stress kernel. */
  void
  displacement_kernel()
  {
    const double nu = .3, x = .8, y = -.6, z = 2.5, h = 1e-4;
    const auto   u = [&](const double dx, const double dy, const double dz) {
      return patch_displacement(patch, x + dx, y + dy, z + dz, nu);
    };
    const Eigen::Matrix3d dx = (u(h, 0., 0.) - u(-h, 0., 0.)) / (2. * h);
    const Eigen::Matrix3d dy = (u(0., h, 0.) - u(0., -h, 0.)) / (2. * h);
    const Eigen::Matrix3d dz = (u(0., 0., h) - u(0., 0., -h)) / (2. * h);
    const Stress          s  = patch_influence(patch, x, y, z, nu);
    Worst                 error;
    for (int load = 0; load < 3; ++load)
      {
        const double lame =
          2. * nu / (1. - 2. * nu) * (dx(0, load) + dy(1, load) + dz(2, load));
        Eigen::Matrix<double, 6, 1> t;
        t << lame + 2. * dx(0, load), lame + 2. * dy(1, load),
          lame + 2. * dz(2, load), dx(1, load) + dy(0, load),
          dy(2, load) + dz(1, load), dx(2, load) + dz(0, load);
        error.add((t - s.col(load)).norm());
      }
    std::printf("displacement kernel: %.1e\n", error.largest());
    check(error.largest() < 1e-6,
          "displacements and stresses of a patch agree");
  }



  Eigen::Matrix<double, 6, 1>
  column_state()
  {
    Eigen::Matrix<double, 6, 1> s = Eigen::Matrix<double, 6, 1>::Zero();
    s[2]                          = -1.;
    return s;
  }

  std::vector<BlockPoint>
  points_at(const double depth, const std::vector<double> &places)
  {
    std::vector<BlockPoint> points;
    for (const double x : places)
      for (const double y : places)
        points.push_back({{x, y, depth}});
    return points;
  }



  /** A column under uniform pressure that does not bulge: -p and nothing else
   * at every depth, where a half-space has neither. */
  void
  column()
  {
    double before = 0.;
    for (const double h : {.4, .2, .1})
      {
        std::vector<BlockPoint> points;
        for (const double z : {1e-4, .2, .4, 1.7})
          for (const double place : {0., .35, .6, 1.})
            {
              points.push_back({{place, -.55, z}});
              points.push_back({{-.6, place, z}});
              points.push_back({{1., place, z}});
            }
        Worst      inside;
        Worst      rim;
        const auto stress = total(block(0., h, 5. * h), face, points);
        for (std::size_t i = 0; i < points.size(); ++i)
          {
            const auto &[x, y, z] = points[i];
            const bool   at_side  = std::max(std::abs(x), std::abs(y)) == 1.;
            const double error    = (stress[i].col(2) - column_state())
                                   .cwiseAbs()
                                   .maxCoeff<Eigen::PropagateNaN>();
            if (!at_side)
              inside.add(error);
            else if (z > 1.9 * h)
              rim.add(error);
          }
        std::printf("column, finest cell %.3f: inside %.1e, at the sides and "
                    "edges from two cells down %.1e\n",
                    h,
                    inside.largest(),
                    rim.largest());
        std::fflush(stdout);
        if (before > 0.)
          check(inside.largest() < .6 * before,
                "order " +
                  std::to_string(std::log2(before / inside.largest())));
        before = inside.largest();
        check(rim.largest() < 5e-3, "nor do the sides carry anything else");
      }
    check(before < 3e-3, "a column carries -p everywhere");
    Worst kernels;
    for (const auto &p : points_at(.4, {-.55, 0., .35, .6}))
      kernels.add(
        (patch_influence(face, p[0], p[1], p[2], 0.).col(2) - column_state())
          .cwiseAbs()
          .maxCoeff<Eigen::PropagateNaN>());
    std::printf("without the correction %.2f\n", kernels.largest());
    check(kernels.largest() > .15, "a half-space is no column");
  }



  /** Force and moment in a cross-section, over those of one patch, minus
   * what they should be. */
  double
  imbalance(const PadBlock &b)
  {
    const double area =
      (patch.x_max - patch.x_min) * (patch.y_max - patch.y_min);
    const double        x = .5 * (patch.x_max + patch.x_min);
    const double        y = .5 * (patch.y_max + patch.y_min);
    const double        z = .3;
    const unsigned int  n = 40;
    std::vector<double> places;
    for (unsigned int i = 0; i < n; ++i)
      places.push_back(-1. + 2. * (i + .5) / n);
    const auto                  points = points_at(z, places);
    const auto                  s      = total(b, patch, points);
    Eigen::Matrix<double, 6, 3> sum    = Eigen::Matrix<double, 6, 3>::Zero();
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const double             da = 4. / (n * n) / area;
        const double             u = points[i][0], v = points[i][1];
        const Eigen::RowVector3d fx = da * s[i].row(5), fy = da * s[i].row(4),
                                 fz = da * s[i].row(2);
        sum.row(0) += fx;
        sum.row(1) += fy;
        sum.row(2) += fz;
        sum.row(3) += v * fz - z * fy;
        sum.row(4) += z * fx - u * fz;
        sum.row(5) += u * fy - v * fx;
      }
    // turned round: what the part above does to the part below
    Eigen::Matrix<double, 6, 3> wanted = Eigen::Matrix<double, 6, 3>::Zero();
    wanted.topRows<3>()                = -Eigen::Matrix3d::Identity();
    wanted(5, 0)                       = y;
    wanted(5, 1)                       = -x;
    wanted(3, 2)                       = -y;
    wanted(4, 2)                       = x;
    return (sum - wanted).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  }

  void
  equilibrium()
  {
    const double coarse = imbalance(block(.3, .2, .8));
    const double fine   = imbalance(block(.3, .1, .4));
    std::printf(
      "forces and moments of a cross-section: %.1e, %.1e\n", coarse, fine);
    std::fflush(stdout);
    check(fine < .7 * coarse && fine < 5e-3,
          "force and moment of a patch go through the block");
  }



  /** Tractions at a side beside the patch, from two cells down. */
  void
  free_side()
  {
    double before = 0.;
    for (const double h : {.4, .2, .1})
      {
        Worst                         error;
        Worst                         kernels;
        const std::vector<BlockPoint> points = {
          {{1., .1, .4}}, {{1., -.35, .4}}, {{1., .5, .6}}};
        const auto s = total(block(.3, h, .5), patch, points);
        for (std::size_t i = 0; i < points.size(); ++i)
          for (const int component : {0, 3, 5})
            {
              error.add(
                s[i].row(component).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
              kernels.add(patch_influence(
                            patch, points[i][0], points[i][1], points[i][2], .3)
                            .row(component)
                            .cwiseAbs()
                            .maxCoeff<Eigen::PropagateNaN>());
            }
        std::printf("side, finest cell %.3f: %.1e, of the kernels %.2f\n",
                    h,
                    error.largest(),
                    kernels.largest());
        if (before > 0.)
          check(error.largest() < .7 * before, "it falls");
        before = error.largest();
      }
    check(before < 5e-3, "the side beside a loaded patch is free");
  }



  /** Hertz contact of radius 1 in the middle of large blocks: the kernels
   * reach 1e-4, and the correction goes to 0 with the size. */
  void
  small_contact()
  {
    double before = 0.;
    for (const double size : {10., 20., 40.})
      {
        const PadBlock b{
          {-size, size, -size, size}, 2. * size, .3, .2 * size, .5 * size};
        const Patch             contact{-1., 1., -1., 1.};
        std::vector<BlockPoint> points;
        for (const double z : {1e-3, .48, 2.})
          for (const double place : {0., .5})
            points.push_back({{place, .5, z}});
        const double largest = block_correction(b, {contact}, points)
                                 .cwiseAbs()
                                 .maxCoeff<Eigen::PropagateNaN>();
        std::printf(
          "block %.0f times the contact: correction %.1e\n", size, largest);
        if (before > 0.)
          check(largest < .35 * before,
                "order " + std::to_string(std::log2(before / largest)));
        before = largest;
      }
    check(before < 1e-3, "Hertz contact is left alone in a large block");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  displacement_kernel();
  column();
  equilibrium();
  free_side();
  small_contact();
}
