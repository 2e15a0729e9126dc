// SPDX-License-Identifier: LGPL-2.1-or-later

// Modes of another run, with other signs and other members of a plane of one
// frequency, are turned into those of a saved state, and those of other bodies
// are not.

#include "pressed_brake.h"
#include "worst.h"

#include <squeal/transient/saved_modes.h>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** The motions of another run: every second one with the other sign, those of
   * one frequency as other ones of their plane, all with some rounding. */
  ReductionBasis
  of_another_run(const ReductionBasis &basis, unsigned int &n_planes)
  {
    ReductionBasis other = basis;
    for (Eigen::Index k = 0; k + 1 < other.shapes.cols(); ++k)
      {
        const double of   = basis.omega_squared[k],
                     next = basis.omega_squared[k + 1];
        if (k + 1 < basis.n_modes && std::abs(next - of) < 1e-7 * next)
          {
            Eigen::Matrix2d turn;
            turn << std::cos(.7), -std::sin(.7), std::sin(.7), std::cos(.7);
            for (Block *shapes : {&other.shapes, &other.mass_shapes})
              shapes->middleCols(k, 2) = Block(shapes->middleCols(k, 2) * turn);
            ++n_planes;
            ++k;
          }
        else if (k % 2 == 0)
          {
            other.shapes.col(k) *= -1.;
            other.mass_shapes.col(k) *= -1.;
          }
      }
    for (Eigen::Index k = 0; k < other.shapes.cols(); ++k)
      other.omega_squared[k] *= 1. + 1e-10 * std::cos(double(k));
    return other;
  }

  double
  difference(const Block &a, const Block &b)
  {
    Worst worst;
    for (Eigen::Index k = 0; k < a.cols(); ++k)
      worst.add((a.col(k) - b.col(k)).norm() / b.col(k).norm());
    return worst.largest();
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double interface_cut_off : {0., 60e3})
    {
      const Reduced         r(pressed_brake(.3), 12e3, interface_cut_off);
      const ReductionBasis &basis = r.basis;
      const std::string     name =
        interface_cut_off > 0. ? " with Ritz vectors" : "";
      const SavedModes saved =
        SavedModes::from_numbers(
          saved_modes(basis, *r.pencil.space()).numbers())
          .value();
      unsigned int   n_planes = 0;
      ReductionBasis other    = of_another_run(basis, n_planes);
      check(n_planes > 2, "the disc has planes of one frequency" + name);
      check(difference(other.shapes, basis.shapes) > .5,
            "another run has other modes" + name);
      check(saved_modes(other, *r.pencil.space()).checksum() !=
              saved.checksum(),
            "which the checksum tells" + name);
      check(turn_into(other, saved, r.pencil), "they are turned" + name);
      check(difference(other.shapes, basis.shapes) < 1e-9 &&
              difference(other.mass_shapes, basis.mass_shapes) < 1e-9,
            "into the saved ones" + name);
      check(other.omega_squared == basis.omega_squared,
            "with their frequencies" + name);

      SceneParameters heavier = pressed_brake(.3);
      heavier.bodies.back().density *= 1.01;
      Reduced     h(heavier, 12e3, interface_cut_off);
      const Block before = h.basis.shapes;
      check(!turn_into(h.basis, saved, h.pencil) && h.basis.shapes == before,
            "those of other bodies are left as they are" + name);
    }
}
