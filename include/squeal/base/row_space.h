// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_row_space_h
#define squeal_base_row_space_h

#include <Eigen/Core>
#include <mpi.h>

#include <memory>
#include <vector>

namespace dealii
{
  class IndexSet;
  namespace Utilities
  {
    namespace MPI
    {
      class Partitioner;
    }
  } // namespace Utilities
} // namespace dealii

namespace squeal
{
  /** A block of vectors: this rank's owned rows x number of vectors. */
  using Block        = Eigen::MatrixXd;
  using ComplexBlock = Eigen::MatrixXcd;

  /**
   * The unknowns of a system and how they are spread over the ranks: each rank
   * owns one contiguous range of global rows and knows some ghost rows of
   * others. Blocks hold owned rows only; local blocks hold the owned rows
   * followed by the ghost rows.
   */
  class RowSpace
  {
  public:
    /** All rows on every rank of a serial communicator (lumped and imported
     * systems). */
    explicit RowSpace(const unsigned int n_rows);

    /** Distributed rows: @p owned contiguous and one-to-one over the ranks,
     * @p relevant the rows that cells of this rank touch. */
    RowSpace(const dealii::IndexSet &owned,
             const dealii::IndexSet &relevant,
             const MPI_Comm          communicator);
    ~RowSpace();

    MPI_Comm     communicator() const;
    unsigned int rank() const;
    unsigned int n_ranks() const;
    unsigned int n_global() const;
    unsigned int n_owned() const;
    /** Owned plus ghost rows. */
    unsigned int n_local() const;
    /** Global number of this rank's first owned row. */
    unsigned int first_owned() const;
    /** Local number of a global row that is owned or ghost here. */
    unsigned int local(const unsigned int global) const;
    unsigned int global(const unsigned int local) const;

    /** True where this rank has every row: nothing to exchange. */
    bool is_whole() const;

    /** Owned rows and the current values of the ghost rows. */
    Eigen::MatrixXd gather(const Block &owned) const;

    /** Adds the ghost rows of @p local to their owners and returns the owned
     * rows. */
    Block scatter_add(Eigen::MatrixXd local) const;

    /** X^T Y summed over the ranks: (columns of X) x (columns of Y). */
    Eigen::MatrixXd  dot(const Block &X, const Block &Y) const;
    Eigen::MatrixXcd dot(const ComplexBlock &X, const ComplexBlock &Y) const;

    /** Euclidean norm of every column. */
    Eigen::VectorXd norms(const Block &X) const;
    Eigen::VectorXd norms(const ComplexBlock &X) const;

    /** Sums @p small over the ranks in place. */
    void sum(Eigen::MatrixXd &small) const;

    /** All rows on rank 0 (empty elsewhere), and back. */
    Eigen::MatrixXd to_root(const Block &owned) const;
    Block from_root(Eigen::MatrixXd all, const unsigned int n_columns) const;

  private:
    MPI_Comm                                                   comm;
    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner;
    std::vector<int> rows_of_rank, first_of_rank;
  };
} // namespace squeal

#endif
