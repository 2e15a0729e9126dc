// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/sparse_matrix.h>
#include <squeal/contact/elimination.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/index_set.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

namespace squeal
{
  namespace
  {
    using SmallSparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

    void
    append(const SmallSparse &matrix, const bool lower_only, Triplets &out)
    {
      for (int i = 0; i < matrix.outerSize(); ++i)
        for (SmallSparse::InnerIterator it(matrix, i); it; ++it)
          if (!lower_only || it.row() >= it.col())
            out.add(it.row(), it.col(), it.value());
    }

    SmallSparse
    as_sparse(const Functionals &functionals, const unsigned int n_columns)
    {
      std::vector<Eigen::Triplet<double>> entries;
      for (unsigned int r = 0; r < functionals.n_rows(); ++r)
        for (const auto &[column, weight] : functionals.rows()[r])
          entries.emplace_back(r, column, weight);
      SmallSparse result(functionals.n_rows(), n_columns);
      result.setFromTriplets(entries.begin(), entries.end());
      return result;
    }
  } // namespace



  Elimination::Elimination(std::shared_ptr<const RowSpace> full_rows,
                           DependentUnknowns               d)
    : full(std::move(full_rows))
    , dependent(std::move(d))
    , new_number(full->n_global(), 0)
  {
    for (std::size_t k = 0; k < dependent.rows.size(); ++k)
      {
        AssertThrow(new_number[dependent.rows[k]] == 0,
                    dealii::ExcInternalError());
        new_number[dependent.rows[k]] = -1 - static_cast<int>(k);
      }
    const unsigned int first_full = full->first_owned();
    const unsigned int end_full   = first_full + full->n_owned();
    int                next       = 0;
    unsigned int       first = 0, end = 0;
    for (unsigned int row = 0; row < new_number.size(); ++row)
      {
        if (row == first_full)
          first = next;
        if (new_number[row] == 0)
          new_number[row] = next++;
        if (row + 1 == end_full)
          end = next;
      }
    std::set<unsigned int> touched;
    for (unsigned int l = 0; l < full->n_local(); ++l)
      if (const int row = new_number[full->global(l)]; row >= 0)
        touched.insert(row);
    dealii::IndexSet owned(next), relevant(next);
    owned.add_range(first, end);
    relevant.add_indices(touched.begin(), touched.end());
    reduced = std::make_shared<RowSpace>(owned, relevant, full->communicator());

    std::vector<Functionals::Row> rows;
    for (const auto &combination : dependent.combinations)
      {
        rows.emplace_back();
        for (const auto &[row, weight] : combination)
          {
            AssertThrow(new_number[row] >= 0, dealii::ExcInternalError());
            rows.back().emplace_back(new_number[row], weight);
          }
      }
    combinations = std::make_shared<Functionals>(reduced, std::move(rows));
  }



  std::shared_ptr<const RowSpace>
  Elimination::full_space() const
  {
    return full;
  }

  std::shared_ptr<const RowSpace>
  Elimination::reduced_space() const
  {
    return reduced;
  }

  unsigned int
  Elimination::n_dependent() const
  {
    return dependent.rows.size();
  }



  Block
  Elimination::expanded(const Block           &v,
                        const Eigen::MatrixXd &of_dependent) const
  {
    Block     u(full->n_owned(), v.cols());
    const int first = static_cast<int>(full->first_owned());
    for (Eigen::Index c = 0; c < v.cols(); ++c)
      {
        const double *next = v.col(c).data();
        for (Eigen::Index i = 0; i < u.rows(); ++i)
          {
            const int number = new_number[first + i];
            u(i, c) = number >= 0 ? *next++ : of_dependent(-1 - number, c);
          }
      }
    return u;
  }

  Block
  Elimination::expand(const Block &v) const
  {
    return expanded(v, combinations->apply(v));
  }

  Block
  Elimination::expand_absolute(const Block &v) const
  {
    return expanded(v.cwiseAbs(), combinations->apply_absolute(v));
  }

  Block
  Elimination::independent_rows(const Block &f) const
  {
    Block     result(reduced->n_owned(), f.cols());
    const int first = static_cast<int>(full->first_owned());
    for (Eigen::Index c = 0; c < f.cols(); ++c)
      {
        double *next = result.col(c).data();
        for (Eigen::Index i = 0; i < f.rows(); ++i)
          if (new_number[first + i] >= 0)
            *next++ = f(i, c);
      }
    return result;
  }

  Block
  Elimination::restrict_forces(const Block &f) const
  {
    return independent_rows(f) +
           combinations->apply_transposed(dependent_rows(f));
  }

  Block
  Elimination::restrict_absolute(const Block &f) const
  {
    return independent_rows(f.cwiseAbs()) +
           combinations->apply_transposed_absolute(
             dependent_rows(f.cwiseAbs()));
  }

  Eigen::MatrixXd
  Elimination::dependent_rows(const Block &f) const
  {
    Eigen::MatrixXd g = Eigen::MatrixXd::Zero(dependent.rows.size(), f.cols());
    for (std::size_t k = 0; k < dependent.rows.size(); ++k)
      if (const unsigned int i = dependent.rows[k] - full->first_owned();
          dependent.rows[k] >= full->first_owned() && i < full->n_owned())
        g.row(k) = f.row(i);
    full->sum(g);
    return g;
  }



  std::shared_ptr<const Functionals>
  Elimination::reduce(const Functionals &functionals) const
  {
    std::vector<Functionals::Row> rows;
    for (const auto &row : functionals.rows())
      {
        std::map<unsigned int, double> sum;
        for (const auto &[column, weight] : row)
          if (const int number = new_number[column]; number >= 0)
            sum[number] += weight;
          else
            for (const auto &[c, w] : combinations->rows()[-1 - number])
              sum[c] += weight * w;
        rows.emplace_back(sum.begin(), sum.end());
      }
    return std::make_shared<Functionals>(reduced, std::move(rows));
  }



  void
  Elimination::reduce_entries(const Triplets &entries,
                              const bool      lower_only,
                              Triplets       &out) const
  {
    const int n = reduced->n_global(), n_s = n_dependent();
    std::vector<Eigen::Triplet<double>> s_n, n_s_entries, s_s;
    for (std::size_t k = 0; k < entries.rows.size(); ++k)
      {
        const int    i = new_number[entries.rows[k]];
        const int    j = new_number[entries.columns[k]];
        const double a = entries.values[k];
        if (i >= 0 && j >= 0)
          {
            if (!lower_only || i >= j)
              out.add(i, j, a);
          }
        else if (i < 0 && j >= 0)
          s_n.emplace_back(-1 - i, j, a);
        else if (i >= 0)
          n_s_entries.emplace_back(i, -1 - j, a);
        else
          s_s.emplace_back(-1 - i, -1 - j, a);
      }
    const SmallSparse P = as_sparse(*combinations, n);
    SmallSparse       A_sn(n_s, n), A_ns(n, n_s), A_ss(n_s, n_s);
    A_sn.setFromTriplets(s_n.begin(), s_n.end());
    A_ns.setFromTriplets(n_s_entries.begin(), n_s_entries.end());
    A_ss.setFromTriplets(s_s.begin(), s_s.end());
    const SmallSparse Pt = P.transpose();
    append(SmallSparse(Pt * A_sn), lower_only, out);
    append(SmallSparse(A_ns * P), lower_only, out);
    append(SmallSparse(Pt * SmallSparse(A_ss * P)), lower_only, out);
  }



  namespace
  {
    /** This rank's entries of the rows of @p matrix that @p wanted flags. */
    Triplets
    entries_of_rows(const LinearOperator    &matrix,
                    const std::vector<bool> &wanted)
    {
      Triplets entries;
      if (const auto *sparse = dynamic_cast<const SparseMatrix *>(&matrix))
        sparse->append_rows_to(entries, wanted);
      else
        matrix.append_to(entries, 1., false);
      return entries;
    }

    /** An entry of N A, to be sent to other ranks. */
    struct ForceEntry
    {
      int    force, column;
      double value;
    };

    /** Those of all ranks, in the order of the ranks. */
    std::vector<ForceEntry>
    gather(const std::vector<ForceEntry> &own, const RowSpace &space)
    {
      std::vector<int> sizes(space.n_ranks()), starts(space.n_ranks());
      const int        size = static_cast<int>(own.size() * sizeof(ForceEntry));
      MPI_Allgather(
        &size, 1, MPI_INT, sizes.data(), 1, MPI_INT, space.communicator());
      std::partial_sum(sizes.begin(), sizes.end() - 1, starts.begin() + 1);
      std::vector<ForceEntry> all((starts.back() + sizes.back()) /
                                  sizeof(ForceEntry));
      MPI_Allgatherv(own.data(),
                     size,
                     MPI_BYTE,
                     all.data(),
                     sizes.data(),
                     starts.data(),
                     MPI_BYTE,
                     space.communicator());
      return all;
    }
  } // namespace



  std::shared_ptr<const Functionals>
  Elimination::forces_of(const Functionals    &normal,
                         const LinearOperator &matrix,
                         const bool            absolute) const
  {
    const auto sized = [&](const double a) {
      return absolute ? std::abs(a) : a;
    };
    std::unordered_map<unsigned int, Functionals::Row> force_of_row;
    std::vector<bool>                                  wanted(full->n_global());
    for (unsigned int k = 0; k < normal.n_rows(); ++k)
      for (const auto &[row, weight] : normal.rows()[k])
        {
          force_of_row[row].emplace_back(k, sized(weight));
          wanted[row] = true;
        }
    const Triplets          entries = entries_of_rows(matrix, wanted);
    std::vector<ForceEntry> own;
    for (std::size_t e = 0; e < entries.rows.size(); ++e)
      if (wanted[entries.rows[e]])
        for (const auto &[k, weight] : force_of_row[entries.rows[e]])
          own.push_back({static_cast<int>(k),
                         entries.columns[e],
                         weight * sized(entries.values[e])});
    std::vector<std::map<unsigned int, double>> sums(normal.n_rows());
    for (const ForceEntry &e : gather(own, *full))
      if (const int j = new_number[e.column]; j >= 0)
        sums[e.force][j] += e.value;
      else
        for (const auto &[c, w] : combinations->rows()[-1 - j])
          sums[e.force][c] += e.value * sized(w);
    std::vector<Functionals::Row> rows;
    for (const auto &sum : sums)
      rows.emplace_back(sum.begin(), sum.end());
    return std::make_shared<Functionals>(reduced, std::move(rows));
  }



  EliminatedOperator::EliminatedOperator(
    std::shared_ptr<const LinearOperator> m,
    std::shared_ptr<const Elimination>    e)
    : matrix(std::move(m))
    , elimination(std::move(e))
  {
  }

  const LinearOperator &
  EliminatedOperator::inner() const
  {
    return *matrix;
  }

  const VectorMap &
  EliminatedOperator::map() const
  {
    return *elimination;
  }

  Block
  EliminatedOperator::multiply(const Block &X) const
  {
    return elimination->restrict_forces(
      matrix->multiply(elimination->expand(X)));
  }

  Block
  EliminatedOperator::multiply_transposed(const Block &X) const
  {
    return elimination->restrict_forces(
      matrix->multiply_transposed(elimination->expand(X)));
  }

  Block
  EliminatedOperator::multiply_absolute(const Block &X) const
  {
    return elimination->restrict_absolute(
      matrix->multiply_absolute(elimination->expand_absolute(X)));
  }

  bool
  EliminatedOperator::is_symmetric() const
  {
    return matrix->is_symmetric();
  }

  void
  EliminatedOperator::append_to(Triplets    &triplets,
                                const double factor,
                                const bool   lower_only) const
  {
    Triplets full;
    matrix->append_to(full, factor, false);
    elimination->reduce_entries(full, lower_only, triplets);
  }



  MultiplierFriction::MultiplierFriction(
    const LinearOperator              &matrix,
    const Elimination                 &elimination,
    std::shared_ptr<const Functionals> tangential,
    const Functionals                 &normal)
    : left(std::move(tangential))
    , right(elimination.forces_of(normal, matrix, false))
    , right_absolute(elimination.forces_of(normal, matrix, true))
  {
    AssertDimension(left->n_rows(), right->n_rows());
  }

  const Functionals &
  MultiplierFriction::left_rows() const
  {
    return *left;
  }

  Eigen::MatrixXd
  MultiplierFriction::forces(const Block &X) const
  {
    return right->apply(X);
  }

  Block
  MultiplierFriction::transposed_forces(const Eigen::MatrixXd &g) const
  {
    return right->apply_transposed(g);
  }

  Block
  MultiplierFriction::multiply_absolute(const Block &X) const
  {
    return left->apply_transposed_absolute(right_absolute->apply_absolute(X));
  }

  bool
  MultiplierFriction::is_symmetric() const
  {
    return false;
  }

  void
  MultiplierFriction::append_to(Triplets    &triplets,
                                const double factor,
                                const bool) const
  {
    // The rows are those of all ranks.
    if (left->space().rank() != 0)
      return;
    const unsigned int n  = left->space().n_global();
    const SmallSparse  Lt = as_sparse(*left, n).transpose();
    append(SmallSparse(factor * SmallSparse(Lt * as_sparse(*right, n))),
           false,
           triplets);
  }
} // namespace squeal
