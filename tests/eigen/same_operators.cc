// SPDX-License-Identifier: LGPL-2.1-or-later

// Whether two pencils are the same but for rounding is judged row by row: a
// spring that is stiffer by many orders of magnitude than the contact hides no
// change of the contact.

#include "check.h"

#include <squeal/base/sparse_matrix.h>
#include <squeal/eigen/same_operators.h>

#include <deal.II/base/mpi.h>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  enum class Role
  {
    mass,
    damping,
    stiffness
  };

  constexpr unsigned int n = 6;

  /** A chain of springs of 1 N/m and an end of @p stiff N/m; one diagonal
   * entry of the matrix of @p role, far from that end, is @p factor times its
   * own. */
  Pencil
  chain(const double stiff, const Role role, const double factor)
  {
    AffineSystem system;
    system.space = std::make_shared<const RowSpace>(n);
    for (const Role part : {Role::mass, Role::damping, Role::stiffness})
      {
        Triplets entries;
        for (unsigned int i = 0; i < n; ++i)
          {
            double diagonal = part == Role::stiffness ? 2. : 1.;
            if (i == 0 && part == Role::stiffness)
              diagonal += stiff;
            if (i == n - 2 && part == role)
              diagonal *= factor;
            entries.add(i, i, diagonal);
            if (i > 0 && part == Role::stiffness)
              entries.add(i, i - 1, -1.);
          }
        AffineTerm term;
        term.matrix =
          std::make_shared<const SparseMatrix>(system.space, entries);
        term.coefficients = [part](const SceneParameters &) {
          TermCoefficients c;
          c.mass      = part == Role::mass;
          c.damping   = part == Role::damping;
          c.stiffness = part == Role::stiffness;
          return c;
        };
        system.terms.push_back(term);
      }
    return Pencil::unmerged(system, {});
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const double stiff : {0., 1e13, 1e20})
    for (const Role role : {Role::mass, Role::damping, Role::stiffness})
      {
        const Pencil      own  = chain(stiff, role, 1.);
        const std::string what = " of the matrix " +
                                 std::to_string(static_cast<int>(role)) +
                                 " beside " + std::to_string(stiff) + " N/m";
        for (auto *const same : {same_operators, same_symmetric_operators})
          {
            check(same(own, chain(stiff, role, 1. + 1e-14)),
                  "rounding" + what + " is no difference");
            check(!same(own, chain(stiff, role, 1.001)),
                  "a thousandth" + what + " is one");
          }
      }
  // Of the stiff row itself, what is rounding for it.
  check(same_operators(chain(1e20, Role::mass, 1.),
                       chain(1e20 * (1. + 1e-13), Role::mass, 1.)),
        "a stiff row has rounding of its own size");
}
