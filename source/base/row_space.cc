// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/row_space.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/index_set.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/base/partitioner.templates.h>

namespace squeal
{
  namespace
  {
    dealii::IndexSet
    all_rows(const unsigned int n)
    {
      return dealii::complete_index_set(n);
    }

    void
    sum_in_place(double *data, const std::size_t n, const MPI_Comm comm)
    {
      int n_ranks;
      MPI_Comm_size(comm, &n_ranks);
      if (n_ranks > 1 && n > 0)
        MPI_Allreduce(
          MPI_IN_PLACE, data, static_cast<int>(n), MPI_DOUBLE, MPI_SUM, comm);
    }
  } // namespace



  RowSpace::RowSpace(const unsigned int n_rows)
    : RowSpace(all_rows(n_rows), all_rows(n_rows), MPI_COMM_SELF)
  {
  }



  RowSpace::RowSpace(const dealii::IndexSet &owned,
                     const dealii::IndexSet &relevant,
                     const MPI_Comm          communicator)
    : comm(communicator)
    , partitioner(
        std::make_shared<dealii::Utilities::MPI::Partitioner>(owned,
                                                              relevant,
                                                              communicator))
  {
    int n;
    MPI_Comm_size(comm, &n);
    rows_of_rank.resize(n);
    first_of_rank.resize(n, 0);
    int mine = static_cast<int>(n_owned());
    MPI_Allgather(&mine, 1, MPI_INT, rows_of_rank.data(), 1, MPI_INT, comm);
    for (int r = 1; r < n; ++r)
      first_of_rank[r] = first_of_rank[r - 1] + rows_of_rank[r - 1];
  }

  RowSpace::~RowSpace() = default;



  MPI_Comm
  RowSpace::communicator() const
  {
    return comm;
  }

  unsigned int
  RowSpace::rank() const
  {
    return partitioner->this_mpi_process();
  }

  unsigned int
  RowSpace::n_ranks() const
  {
    return partitioner->n_mpi_processes();
  }

  unsigned int
  RowSpace::n_global() const
  {
    return partitioner->size();
  }

  unsigned int
  RowSpace::n_owned() const
  {
    return partitioner->locally_owned_size();
  }

  unsigned int
  RowSpace::n_local() const
  {
    return partitioner->locally_owned_size() + partitioner->n_ghost_indices();
  }

  unsigned int
  RowSpace::first_owned() const
  {
    return partitioner->local_range().first;
  }

  unsigned int
  RowSpace::local(const unsigned int global) const
  {
    return partitioner->global_to_local(global);
  }

  unsigned int
  RowSpace::global(const unsigned int local) const
  {
    return partitioner->local_to_global(local);
  }



  bool
  RowSpace::is_whole() const
  {
    return partitioner->n_ghost_indices() == 0 && n_ranks() == 1;
  }

  Eigen::MatrixXd
  RowSpace::gather(const Block &owned) const
  {
    if (is_whole())
      return owned;
    Eigen::MatrixXd     all(n_local(), owned.cols());
    std::vector<double> buffer(partitioner->n_import_indices());
    all.topRows(n_owned()) = owned;
    for (int j = 0; j < owned.cols(); ++j)
      {
        double                  *column = all.col(j).data();
        std::vector<MPI_Request> requests;
        partitioner->export_to_ghosted_array_start(
          0,
          dealii::ArrayView<const double>(column, n_owned()),
          dealii::ArrayView<double>(buffer.data(), buffer.size()),
          dealii::ArrayView<double>(column + n_owned(),
                                    partitioner->n_ghost_indices()),
          requests);
        partitioner->export_to_ghosted_array_finish(
          dealii::ArrayView<double>(column + n_owned(),
                                    partitioner->n_ghost_indices()),
          requests);
      }
    return all;
  }



  Block
  RowSpace::scatter_add(Eigen::MatrixXd all) const
  {
    if (is_whole())
      return all;
    std::vector<double> buffer(partitioner->n_import_indices());
    for (int j = 0; j < all.cols(); ++j)
      {
        double                         *column = all.col(j).data();
        std::vector<MPI_Request>        requests;
        const dealii::ArrayView<double> ghosts(column + n_owned(),
                                               partitioner->n_ghost_indices());
        partitioner->import_from_ghosted_array_start(
          dealii::VectorOperation::add,
          0,
          ghosts,
          dealii::ArrayView<double>(buffer.data(), buffer.size()),
          requests);
        partitioner->import_from_ghosted_array_finish(
          dealii::VectorOperation::add,
          dealii::ArrayView<const double>(buffer.data(), buffer.size()),
          dealii::ArrayView<double>(column, n_owned()),
          ghosts,
          requests);
      }
    return all.topRows(n_owned());
  }



  Eigen::MatrixXd
  RowSpace::dot(const Block &X, const Block &Y) const
  {
    Eigen::MatrixXd result = X.transpose() * Y;
    sum(result);
    return result;
  }

  Eigen::MatrixXcd
  RowSpace::dot(const ComplexBlock &X, const ComplexBlock &Y) const
  {
    Eigen::MatrixXcd result = X.transpose() * Y;
    sum_in_place(reinterpret_cast<double *>(result.data()),
                 2 * static_cast<std::size_t>(result.size()),
                 comm);
    return result;
  }

  Eigen::VectorXd
  RowSpace::norms(const Block &X) const
  {
    Eigen::VectorXd squares = X.colwise().squaredNorm();
    sum_in_place(squares.data(), squares.size(), comm);
    return squares.cwiseSqrt();
  }

  Eigen::VectorXd
  RowSpace::norms(const ComplexBlock &X) const
  {
    Eigen::VectorXd squares = X.colwise().squaredNorm();
    sum_in_place(squares.data(), squares.size(), comm);
    return squares.cwiseSqrt();
  }

  void
  RowSpace::sum(Eigen::MatrixXd &small) const
  {
    sum_in_place(small.data(), small.size(), comm);
  }



  Eigen::MatrixXd
  RowSpace::to_root(const Block &owned) const
  {
    if (n_ranks() == 1)
      return owned;
    Eigen::MatrixXd all;
    if (rank() == 0)
      all.resize(n_global(), owned.cols());
    for (int j = 0; j < owned.cols(); ++j)
      MPI_Gatherv(owned.col(j).data(),
                  rows_of_rank[rank()],
                  MPI_DOUBLE,
                  rank() == 0 ? all.col(j).data() : nullptr,
                  rows_of_rank.data(),
                  first_of_rank.data(),
                  MPI_DOUBLE,
                  0,
                  comm);
    return all;
  }

  Block
  RowSpace::from_root(Eigen::MatrixXd all, const unsigned int n_columns) const
  {
    if (n_ranks() == 1)
      return all;
    Block owned(n_owned(), n_columns);
    for (unsigned int j = 0; j < n_columns; ++j)
      MPI_Scatterv(rank() == 0 ? all.col(j).data() : nullptr,
                   rows_of_rank.data(),
                   first_of_rank.data(),
                   MPI_DOUBLE,
                   owned.col(j).data(),
                   rows_of_rank[rank()],
                   MPI_DOUBLE,
                   0,
                   comm);
    return owned;
  }
} // namespace squeal
