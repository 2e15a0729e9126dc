// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_mumps_h
#define squeal_base_mumps_h

#include <squeal/base/exceptions.h>
#include <squeal/base/row_space.h>

#include <complex>
#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /** Where the factors of a matrix are kept. */
  enum class FactorPlace
  {
    memory,
    disk
  };

  /** What a factorisation may take. */
  struct FactorStorage
  {
    enum class Place
    {
      automatic, /**< on disk only where the memory is too small */
      memory,
      disk
    };
    Place place = Place::automatic;
    /** An existing directory for the files of factors on disk; empty: there is
     * none, and the factors stay in memory. */
    std::string directory = {};
    /** Bytes of this rank that others will need beside the factors. */
    double reserve = 0.;
  };

  /** Factors that do not fit; the text says how large they are. */
  class NotEnoughMemory : public ComputationError
  {
  public:
    using ComputationError::ComputationError;
  };

  /**
   * A sparse direct factorisation by MUMPS, distributed over the ranks of a
   * row space: LDL^T of a real symmetric matrix with its inertia, or LU of a
   * real or complex general one.
   *
   * Entries are given in global numbering, each rank its own, duplicates
   * summed; of a symmetric matrix the lower triangle. A matrix of the same
   * pattern can be factorised again without a new analysis.
   */
  template <typename Number>
  class MumpsFactorization
  {
  public:
    using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
    enum class Symmetry
    {
      general,
      symmetric
    };

    MumpsFactorization(std::shared_ptr<const RowSpace> space,
                       const Symmetry                  symmetry,
                       const FactorStorage            &storage = {});
    ~MumpsFactorization();
    MumpsFactorization(const MumpsFactorization &)            = delete;
    MumpsFactorization &operator=(const MumpsFactorization &) = delete;

    /** Analyses, compares what the factors need with the memory that there is,
     * and factorises. Throws NotEnoughMemory before any work where it does not
     * suffice, ComputationError when the matrix is numerically singular. With
     * @p keep_pattern the rows and columns stay in memory for refactorize(). */
    void factorize(std::vector<int>    rows,
                   std::vector<int>    columns,
                   std::vector<Number> values,
                   const bool          keep_pattern = false);

    /** Factorises new values of the pattern given before, in that order. */
    void refactorize(std::vector<Number> values);

    /** Solves for all columns at once; blocks hold this rank's owned rows. */
    Matrix solve(const Matrix &right_hand_sides) const;

    /** Solves with the transposed matrix (general matrices). */
    Matrix solve_transposed(const Matrix &right_hand_sides) const;

    /** Number of negative eigenvalues of a real symmetric matrix, by
     * Sylvester's law of inertia. */
    unsigned int n_negative_pivots() const;

    /** Entries of the factors over all ranks. */
    double n_factor_entries() const;

    /** Where the factors are. */
    FactorPlace place() const;

    /** Bytes that a rank was estimated to need for factors in memory, of the
     * rank that needs most; they hold 15 % of spare room. */
    double needed_memory() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> impl;
  };
} // namespace squeal

#endif
