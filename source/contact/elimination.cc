// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/elimination.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/index_set.h>

#include <algorithm>
#include <map>
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
    Block        u(full->n_owned(), v.cols());
    Eigen::Index next = 0;
    for (unsigned int i = 0; i < full->n_owned(); ++i)
      {
        const int number = new_number[full->first_owned() + i];
        if (number >= 0)
          u.row(i) = v.row(next++);
        else
          u.row(i) = of_dependent.row(-1 - number);
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
    Block        result(reduced->n_owned(), f.cols());
    Eigen::Index next = 0;
    for (unsigned int i = 0; i < full->n_owned(); ++i)
      if (new_number[full->first_owned() + i] >= 0)
        result.row(next++) = f.row(i);
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



  void
  Elimination::friction_entries(const Triplets    &entries,
                                const Functionals &left,
                                const Functionals &normal,
                                Triplets          &out) const
  {
    const int n = reduced->n_global(), n_forces = normal.n_rows();
    std::unordered_map<unsigned int, Functionals::Row> force_of_row;
    for (int k = 0; k < n_forces; ++k)
      for (const auto &[row, weight] : normal.rows()[k])
        force_of_row[row].emplace_back(k, weight);
    std::vector<Eigen::Triplet<double>> independent, on_dependent;
    for (std::size_t e = 0; e < entries.rows.size(); ++e)
      if (const auto it = force_of_row.find(entries.rows[e]);
          it != force_of_row.end())
        for (const auto &[k, weight] : it->second)
          {
            const int    j     = new_number[entries.columns[e]];
            const double value = weight * entries.values[e];
            if (j >= 0)
              independent.emplace_back(k, j, value);
            else
              on_dependent.emplace_back(k, -1 - j, value);
          }
    SmallSparse N_n(n_forces, n), N_s(n_forces, n_dependent());
    N_n.setFromTriplets(independent.begin(), independent.end());
    N_s.setFromTriplets(on_dependent.begin(), on_dependent.end());
    const SmallSparse G  = N_n + SmallSparse(N_s * as_sparse(*combinations, n));
    const SmallSparse Lt = as_sparse(left, n).transpose();
    append(SmallSparse(Lt * G), false, out);
  }



  EliminatedOperator::EliminatedOperator(
    std::shared_ptr<const LinearOperator> m,
    std::shared_ptr<const Elimination>    e)
    : matrix(std::move(m))
    , elimination(std::move(e))
  {
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
    std::shared_ptr<const LinearOperator> m,
    std::shared_ptr<const Elimination>    e,
    std::shared_ptr<const Functionals>    tangential,
    std::shared_ptr<const Functionals>    n)
    : matrix(std::move(m))
    , elimination(std::move(e))
    , left(std::move(tangential))
    , normal(std::move(n))
  {
    AssertDimension(left->n_rows(), normal->n_rows());
  }

  const Functionals &
  MultiplierFriction::left_rows() const
  {
    return *left;
  }

  Eigen::MatrixXd
  MultiplierFriction::forces(const Block &X) const
  {
    return normal->apply(matrix->multiply(elimination->expand(X)));
  }

  Block
  MultiplierFriction::transposed_forces(const Eigen::MatrixXd &g) const
  {
    return elimination->restrict_forces(
      matrix->multiply_transposed(normal->apply_transposed(g)));
  }

  Block
  MultiplierFriction::multiply_absolute(const Block &X) const
  {
    return left->apply_transposed_absolute(normal->apply_absolute(
      matrix->multiply_absolute(elimination->expand_absolute(X))));
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
    Triplets full;
    matrix->append_to(full, factor, false);
    elimination->friction_entries(full, *left, *normal, triplets);
  }
} // namespace squeal
