// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/available_memory.h>
#include <squeal/base/memory.h>
#include <squeal/base/number_text.h>
#include <squeal/model/linear_solver.h>

#include <mpi.h>

namespace squeal
{
  namespace
  {
    using LinearSolver = EigenParameters::LinearSolver;

    /** Vectors of all unknowns that an analysis has at a time beside the factor
     * where products are not kept: the basis and a round of enrichment. */
    constexpr double vectors_beside_factor = 600.;

    /** The same where the products of the basis are kept, too. */
    constexpr double vectors_with_products = 1400.;

    /** The same as a multiple of the vectors that a basis starts with; a basis
     * grows to between three and four times its start. With products: three
     * times the basis and a round of enrichment. */
    constexpr double growth_with_products = 16.;

    double
    bytes_of(const RowSpace &space, const double n_vectors)
    {
      return 8. * space.n_owned() * n_vectors;
    }
  } // namespace



  FactorStorage
  factor_storage(const Parameters &parameters, const RowSpace &space)
  {
    FactorStorage storage;
    const auto    choice = parameters.eigen.linear_solver;
    storage.place =
      choice == LinearSolver::direct        ? FactorStorage::Place::memory
      : choice == LinearSolver::out_of_core ? FactorStorage::Place::disk
                                            : FactorStorage::Place::automatic;
    storage.directory = parameters.output.directory;
    storage.reserve =
      bytes_of(space,
               choice == LinearSolver::direct ? vectors_with_products
                                              : vectors_beside_factor);
    return storage;
  }



  BasisProducts
  basis_products(const Parameters  &parameters,
                 const RowSpace    &space,
                 const Eigen::Index n_start)
  {
    switch (parameters.eigen.linear_solver)
      {
      case LinearSolver::direct:
        return BasisProducts::kept;
      case LinearSolver::out_of_core:
        return BasisProducts::computed_anew;
      case LinearSolver::automatic:
        break;
      }
    return_freed_memory();
    int is_enough =
      bytes_of(space, growth_with_products * n_start) * space.n_ranks() <=
      available_memory();
    MPI_Allreduce(
      MPI_IN_PLACE, &is_enough, 1, MPI_INT, MPI_MIN, space.communicator());
    return is_enough ? BasisProducts::kept : BasisProducts::computed_anew;
  }



  std::string
  linear_solver_text(const ShiftedInverse &inverse)
  {
    const std::string size = rounded_text(inverse.needed_memory() / 1e9, 2);
    return inverse.place() == FactorPlace::memory
             ? "factors in memory, " + size + " GB"
             : "factors on disk, " + size + " GB in memory";
  }
} // namespace squeal
