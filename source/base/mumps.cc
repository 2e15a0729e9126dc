// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/available_memory.h>
#include <squeal/base/memory.h>
#include <squeal/base/mumps.h>
#include <squeal/base/number_text.h>
#include <squeal/base/scratch_directory.h>

#include <dmumps_c.h>
#include <zmumps_c.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace squeal
{
  namespace
  {
    /** The two C interfaces behind one set of names. */
    template <typename Number>
    struct Interface;

    template <>
    struct Interface<double>
    {
      using Structure = DMUMPS_STRUC_C;
      using Scalar    = double;
      static void
      call(Structure &s)
      {
        dmumps_c(&s);
      }
    };

    template <>
    struct Interface<std::complex<double>>
    {
      using Structure = ZMUMPS_STRUC_C;
      using Scalar    = ZMUMPS_COMPLEX;
      static void
      call(Structure &s)
      {
        zmumps_c(&s);
      }
    };

    std::string
    gigabytes(const double bytes)
    {
      return rounded_text(bytes / 1e9, 2) + " GB";
    }

    constexpr int job_initialize = -1, job_terminate = -2, job_analyze = 1,
                  job_factorize = 2, job_solve = 3;
  } // namespace



  template <typename Number>
  struct MumpsFactorization<Number>::Implementation
  {
    std::shared_ptr<const RowSpace>               space;
    mutable typename Interface<Number>::Structure mumps{};
    std::vector<int>                              rows, columns;
    std::vector<Number>                           values;
    FactorStorage                                 storage;
    std::unique_ptr<ScratchDirectory>             scratch; /**< on disk */

    int &
    icntl(const int i) const
    {
      return mumps.icntl[i - 1];
    }

    /** Bytes by the analysis, of the rank that needs most. */
    double
    estimate(const FactorPlace place) const
    {
      return 1e6 * mumps.infog[place == FactorPlace::memory ? 15 : 25];
    }

    void require_finite() const;
    void choose_place();
    void put_on_disk();
    void factorize();

    bool
    is_distributed() const
    {
      return icntl(18) == 3;
    }

    void
    set_values()
    {
      auto *data =
        reinterpret_cast<typename Interface<Number>::Scalar *>(values.data());
      (is_distributed() ? mumps.a_loc : mumps.a) = data;
    }

    void
    call(const int job) const
    {
      mumps.job = job;
      Interface<Number>::call(mumps);
    }

    /** Runs analysis or factorisation; enlarges the workspace where MUMPS asks
     * for more (errors -8, -9, -17, -20). */
    void
    run(const int job) const
    {
      for (int attempt = 0; attempt < 5; ++attempt)
        {
          call(job);
          const int error = mumps.infog[0];
          if (error >= 0)
            return;
          if (error == -8 || error == -9 || error == -17 || error == -20)
            {
              icntl(14) *= 2;
              continue;
            }
          if (error == -10)
            throw ComputationError(
              "the matrix is numerically singular: a body without support, or "
              "a shift on an eigenvalue");
          if (error == -5 || error == -7 || error == -13 || error == -19)
            throw NotEnoughMemory(
              "the factors need more memory than there is" +
              (job == job_analyze
                 ? std::string()
                 : " (" + gigabytes(estimate(FactorPlace::memory)) + ")") +
              ": use a coarser mesh, a lower degree or more ranks");
          break;
        }
      throw ComputationError(
        "MUMPS failed with INFOG(1) = " + std::to_string(mumps.infog[0]) +
        ", INFOG(2) = " + std::to_string(mumps.infog[1]));
    }

    Matrix solve(const Matrix &b, const bool transposed) const;
  };



  template <typename Number>
  MumpsFactorization<Number>::MumpsFactorization(
    std::shared_ptr<const RowSpace> space,
    const Symmetry                  symmetry,
    const FactorStorage            &storage)
    : impl(std::make_unique<Implementation>())
  {
    auto &m        = impl->mumps;
    impl->space    = std::move(space);
    impl->storage  = storage;
    m.comm_fortran = MPI_Comm_c2f(impl->space->communicator());
    m.par          = 1;
    m.sym          = symmetry == Symmetry::symmetric ? 2 : 0;
    impl->call(job_initialize);
    impl->icntl(1) = impl->icntl(2) = impl->icntl(3) = -1;
    impl->icntl(4)                                   = 0;
    impl->icntl(7)                                   = 5; // METIS
    // No ScaLAPACK root: it would hide pivots from the inertia count.
    impl->icntl(13) = 1;
    impl->icntl(14) = 15; // per cent of spare memory; more where it runs out
    // Entries distributed over the ranks; on one rank the analysis of a matrix
    // in one place is twice as fast.
    impl->icntl(18) = impl->space->n_ranks() > 1 ? 3 : 0;
    impl->icntl(10) = 0;
  }

  template <typename Number>
  MumpsFactorization<Number>::~MumpsFactorization()
  {
    impl->call(job_terminate);
  }



  namespace
  {
    /** True where rows come in threes, the displacements of a node: nearly all
     * of rows 3 k, 3 k + 1 and 3 k + 2 (from 0) have as many entries. */
    bool
    has_node_blocks(const std::vector<int> &rows,
                    const std::vector<int> &columns,
                    const int               n)
    {
      if (n % 3 != 0)
        return false;
      std::vector<int> degree(n, 0);
      for (std::size_t k = 0; k < rows.size(); ++k)
        {
          ++degree[rows[k] - 1];
          ++degree[columns[k] - 1];
        }
      int n_alike = 0;
      for (int i = 0; i < n; i += 3)
        if (degree[i] == degree[i + 1] && degree[i] == degree[i + 2])
          ++n_alike;
      return n_alike > 0.9 * (n / 3);
    }
  } // namespace



  namespace
  {
    /** Bytes that every rank may still take: those of a machine are shared by
     * the ranks on it. The same on all ranks. */
    double
    available_on_every_rank(const MPI_Comm comm)
    {
      return_freed_memory();
      MPI_Comm on_machine;
      MPI_Comm_split_type(
        comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &on_machine);
      int n_on_machine = 1;
      MPI_Comm_size(on_machine, &n_on_machine);
      MPI_Comm_free(&on_machine);
      double bytes = available_memory() / n_on_machine;
      MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_DOUBLE, MPI_MIN, comm);
      return bytes;
    }
  } // namespace



  template <typename Number>
  void
  MumpsFactorization<Number>::Implementation::put_on_disk()
  {
    scratch = std::make_unique<ScratchDirectory>(storage.directory);
    if (scratch->path().size() >= sizeof(mumps.ooc_tmpdir))
      throw InputError("the name of the folder '" + scratch->path() +
                       "' is too long for the files of the factors");
    std::strcpy(mumps.ooc_tmpdir, scratch->path().c_str());
    icntl(22) = 1;
  }

  template <typename Number>
  void
  MumpsFactorization<Number>::Implementation::choose_place()
  {
    using Place                  = FactorStorage::Place;
    const bool        has_folder = !storage.directory.empty();
    const std::string what       = storage.reserve > 0.
                                     ? "the factors and what stands beside them need "
                                     : "the factors need ";
    const double      in_memory  = estimate(FactorPlace::memory),
                 on_disk         = estimate(FactorPlace::disk),
                 available = available_on_every_rank(space->communicator());
    if (storage.place == Place::disk ||
        (storage.place == Place::automatic && has_folder &&
         !(in_memory + storage.reserve <= available)))
      {
        if (!(on_disk + storage.reserve <= available))
          throw NotEnoughMemory(
            what + gigabytes(on_disk + storage.reserve) +
            " a rank even when they are kept on disk, of which " +
            gigabytes(available) +
            " are free: use a coarser mesh, a lower degree or more ranks");
        put_on_disk();
      }
    else if (!(in_memory + storage.reserve <= available))
      throw NotEnoughMemory(
        what + gigabytes(in_memory + storage.reserve) + " a rank, of which " +
        gigabytes(available) + " are free: " +
        (has_folder ? "set Eigenvalues/Linear solver = out of "
                      "core (factors of " +
                        gigabytes(on_disk) + "), "
                    : "") +
        "use a coarser mesh, a lower degree or more ranks");
  }



  /** Values so far below the largest number that neither sums of duplicates nor
   * scaling overflow. */
  constexpr double largest_value = 1e300;

  /** MUMPS ends the program where numbers are not finite. Throws InputError on
   * all ranks. */
  template <typename Number>
  void
  MumpsFactorization<Number>::Implementation::require_finite() const
  {
    Eigen::MatrixXd n_too_large = Eigen::MatrixXd::Zero(1, 1);
    for (const Number &value : values)
      n_too_large(0, 0) += !(std::abs(value) < largest_value);
    space->sum(n_too_large);
    if (n_too_large(0, 0) > 0.)
      throw InputError(
        "the matrix to factorise holds numbers beyond 1e300, too large to "
        "compute with: lower the masses and stiffnesses of Scene or "
        "Eigenvalues/Highest frequency");
  }



  template <typename Number>
  void
  MumpsFactorization<Number>::Implementation::factorize()
  {
    // What is free may be in pieces that are too small.
    try
      {
        run(job_factorize);
      }
    catch (const NotEnoughMemory &)
      {
        if (storage.place != FactorStorage::Place::automatic ||
            storage.directory.empty() || scratch)
          throw;
        put_on_disk();
        run(job_factorize);
      }
  }



  template <typename Number>
  void
  MumpsFactorization<Number>::factorize(std::vector<int>    rows,
                                        std::vector<int>    columns,
                                        std::vector<Number> values,
                                        const bool          keep_pattern)
  {
    impl->rows    = std::move(rows);
    impl->columns = std::move(columns);
    impl->values  = std::move(values);
    impl->require_finite();
    for (auto &i : impl->rows)
      ++i;
    for (auto &j : impl->columns)
      ++j;
    auto &m = impl->mumps;
    m.n     = static_cast<int>(impl->space->n_global());
    if (impl->is_distributed())
      {
        m.nnz_loc = static_cast<MUMPS_INT8>(impl->values.size());
        m.irn_loc = impl->rows.data();
        m.jcn_loc = impl->columns.data();
      }
    else
      {
        m.nnz = static_cast<MUMPS_INT8>(impl->values.size());
        m.irn = impl->rows.data();
        m.jcn = impl->columns.data();
      }
    impl->set_values();
    if (m.sym == 2 && !impl->is_distributed() &&
        has_node_blocks(impl->rows, impl->columns, m.n))
      {
        // The graph of the nodes is ordered, nine times smaller than that of
        // the unknowns. Scaling by the diagonal, which the shift makes small
        // here and there, would delay pivots and fill the factor by a third.
        impl->icntl(15) = -3;
        impl->icntl(6)  = 0;
        impl->icntl(12) = 1;
        impl->icntl(8)  = 7;
      }
    impl->run(job_analyze);
    impl->choose_place();
    impl->factorize();
    std::vector<Number>().swap(impl->values);
    if (!keep_pattern)
      {
        std::vector<int>().swap(impl->rows);
        std::vector<int>().swap(impl->columns);
      }
  }

  template <typename Number>
  void
  MumpsFactorization<Number>::refactorize(std::vector<Number> values)
  {
    impl->values = std::move(values);
    impl->require_finite();
    impl->set_values();
    impl->run(job_factorize);
    std::vector<Number>().swap(impl->values);
  }



  namespace
  {
    Eigen::MatrixXd
    to_root(const RowSpace &space, const Eigen::MatrixXd &b)
    {
      return space.to_root(b);
    }

    Eigen::MatrixXcd
    to_root(const RowSpace &space, const Eigen::MatrixXcd &b)
    {
      const Eigen::MatrixXd re = space.to_root(Block(b.real()));
      const Eigen::MatrixXd im = space.to_root(Block(b.imag()));
      Eigen::MatrixXcd      all(re.rows(), re.cols());
      all.real() = re;
      all.imag() = im;
      return all;
    }

    Eigen::MatrixXd
    from_root(const RowSpace &space, Eigen::MatrixXd x, const int n)
    {
      return space.from_root(std::move(x), n);
    }

    Eigen::MatrixXcd
    from_root(const RowSpace &space, Eigen::MatrixXcd x, const int n)
    {
      Eigen::MatrixXcd result(space.n_owned(), n);
      result.real() = space.from_root(Eigen::MatrixXd(x.real()), n);
      result.imag() = space.from_root(Eigen::MatrixXd(x.imag()), n);
      return result;
    }
  } // namespace



  template <typename Number>
  typename MumpsFactorization<Number>::Matrix
  MumpsFactorization<Number>::Implementation::solve(const Matrix &b,
                                                    const bool transposed) const
  {
    if (b.cols() == 0)
      return b;
    Matrix    all = to_root(*space, b);
    const int n   = static_cast<int>(b.cols());
    mumps.rhs =
      reinterpret_cast<typename Interface<Number>::Scalar *>(all.data());
    mumps.nrhs = n;
    mumps.lrhs = mumps.n;
    icntl(9)   = transposed ? 0 : 1;
    icntl(27)  = n < 64 ? n : 64;
    run(job_solve);
    return from_root(*space, std::move(all), n);
  }

  template <typename Number>
  typename MumpsFactorization<Number>::Matrix
  MumpsFactorization<Number>::solve(const Matrix &b) const
  {
    return impl->solve(b, false);
  }

  template <typename Number>
  typename MumpsFactorization<Number>::Matrix
  MumpsFactorization<Number>::solve_transposed(const Matrix &b) const
  {
    return impl->solve(b, true);
  }

  template <typename Number>
  unsigned int
  MumpsFactorization<Number>::n_negative_pivots() const
  {
    return static_cast<unsigned int>(impl->mumps.infog[11]);
  }

  template <typename Number>
  double
  MumpsFactorization<Number>::n_factor_entries() const
  {
    const int n = impl->mumps.infog[28];
    return n < 0 ? -1e6 * n : n;
  }

  template <typename Number>
  FactorPlace
  MumpsFactorization<Number>::place() const
  {
    return impl->scratch ? FactorPlace::disk : FactorPlace::memory;
  }

  template <typename Number>
  double
  MumpsFactorization<Number>::needed_memory() const
  {
    return impl->estimate(FactorPlace::memory);
  }

  template class MumpsFactorization<double>;
  template class MumpsFactorization<std::complex<double>>;
} // namespace squeal
