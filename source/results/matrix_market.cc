// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/results/matrix_market.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <numeric>
#include <ostream>

namespace squeal
{
  namespace
  {
    /** Entries of a matrix whose values may be complex; duplicates add up. */
    struct Entries
    {
      Triplets            real;
      std::vector<double> imaginary; /**< empty for a real matrix */
    };

    bool
    is_complex(const std::vector<MatrixTerm> &terms)
    {
      return std::any_of(terms.begin(), terms.end(), [](const auto &term) {
        return term.factor.imag() != 0.;
      });
    }

    bool
    is_symmetric(const std::vector<MatrixTerm> &terms)
    {
      return std::all_of(terms.begin(), terms.end(), [](const auto &term) {
        return term.factor == 0. || term.matrix->is_symmetric();
      });
    }

    /** This rank's entries; of a symmetric matrix its lower triangle. */
    Entries
    entries_of(const std::vector<MatrixTerm> &terms)
    {
      Entries    entries;
      const bool complex_values = is_complex(terms);
      const bool lower_only     = is_symmetric(terms);
      for (const MatrixTerm &term : terms)
        {
          if (term.factor == 0.)
            continue;
          std::vector<double> &values = entries.real.values;
          const std::size_t    first  = values.size();
          term.matrix->append_to(entries.real, 1., lower_only);
          if (complex_values)
            for (std::size_t k = first; k < values.size(); ++k)
              entries.imaginary.push_back(term.factor.imag() * values[k]);
          for (std::size_t k = first; k < values.size(); ++k)
            values[k] *= term.factor.real();
        }
      return entries;
    }

    /** Replaces @p values by those of all ranks, one rank after the other, on
     * rank 0 and by nothing elsewhere. */
    template <typename Number>
    void
    gather(std::vector<Number> &values,
           const MPI_Datatype   type,
           const RowSpace      &space)
    {
      const bool       receives = space.rank() == 0;
      const int        n_mine   = static_cast<int>(values.size());
      std::vector<int> counts(space.n_ranks()), offsets(space.n_ranks(), 0);
      MPI_Gather(&n_mine,
                 1,
                 MPI_INT,
                 counts.data(),
                 1,
                 MPI_INT,
                 0,
                 space.communicator());
      if (receives)
        std::partial_sum(counts.begin(), counts.end() - 1, offsets.begin() + 1);
      std::vector<Number> all(receives ? offsets.back() + counts.back() : 0);
      MPI_Gatherv(values.data(),
                  n_mine,
                  type,
                  all.data(),
                  counts.data(),
                  offsets.data(),
                  type,
                  0,
                  space.communicator());
      values = std::move(all);
    }

    void
    gather(Entries &entries, const RowSpace &space)
    {
      if (space.n_ranks() == 1)
        return;
      long long n = entries.real.values.size();
      MPI_Allreduce(
        MPI_IN_PLACE, &n, 1, MPI_LONG_LONG, MPI_SUM, space.communicator());
      if (n > std::numeric_limits<int>::max())
        throw InputError("Output/Export matrices: " + std::to_string(n) +
                         " entries are more than one rank can receive; run on "
                         "one rank or use a coarser mesh");
      gather(entries.real.rows, MPI_INT, space);
      gather(entries.real.columns, MPI_INT, space);
      gather(entries.real.values, MPI_DOUBLE, space);
      // The same on every rank: the factors are.
      int any = !entries.imaginary.empty();
      MPI_Allreduce(
        MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, space.communicator());
      if (any)
        gather(entries.imaginary, MPI_DOUBLE, space);
    }



    /** A matrix by rows, columns ascending in each, every place once, no
     * zeros. */
    template <typename Number>
    struct CompressedRows
    {
      std::vector<std::size_t> starts;
      std::vector<int>         columns;
      std::vector<Number>      values;
    };

    double
    value_of(const Entries &entries, const std::size_t k, double)
    {
      return entries.real.values[k];
    }

    std::complex<double>
    value_of(const Entries &entries, const std::size_t k, std::complex<double>)
    {
      return {entries.real.values[k], entries.imaginary[k]};
    }

    template <typename Number>
    CompressedRows<Number>
    compress(Entries entries, const unsigned int n_rows)
    {
      const std::vector<int>  &rows = entries.real.rows;
      std::vector<std::size_t> starts(n_rows + 1, 0);
      for (const int row : rows)
        ++starts[row + 1];
      std::partial_sum(starts.begin(), starts.end(), starts.begin());

      CompressedRows<Number> matrix;
      matrix.columns.resize(rows.size());
      matrix.values.resize(rows.size());
      std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
      for (std::size_t k = 0; k < rows.size(); ++k)
        {
          const std::size_t place = next[rows[k]]++;
          matrix.columns[place]   = entries.real.columns[k];
          matrix.values[place]    = value_of(entries, k, Number());
        }
      entries = Entries();

      matrix.starts.assign(n_rows + 1, 0);
      std::size_t                         n_kept = 0;
      std::vector<std::pair<int, Number>> row;
      for (unsigned int i = 0; i < n_rows; ++i)
        {
          row.clear();
          for (std::size_t k = starts[i]; k < starts[i + 1]; ++k)
            row.emplace_back(matrix.columns[k], matrix.values[k]);
          std::stable_sort(
            row.begin(), row.end(), [](const auto &a, const auto &b) {
              return a.first < b.first;
            });
          for (std::size_t k = 0; k < row.size();)
            {
              const int column = row[k].first;
              Number    sum    = 0.;
              for (; k < row.size() && row[k].first == column; ++k)
                sum += row[k].second;
              if (sum == Number(0.))
                continue;
              matrix.columns[n_kept] = column;
              matrix.values[n_kept]  = sum;
              ++n_kept;
            }
          matrix.starts[i + 1] = n_kept;
        }
      return matrix;
    }



    /** Text that is handed to the stream in large pieces. */
    class Writer
    {
    public:
      explicit Writer(std::ostream &out)
        : out(out)
      {
      }

      ~Writer()
      {
        out << text;
      }

      template <typename Number>
      void
      add(const Number number, const char after)
      {
        char       digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, number);
        text.append(digits, end.ptr);
        text += after;
        if (text.size() > (1 << 16))
          {
            out << text;
            text.clear();
          }
      }

      void
      add(const std::complex<double> &number, const char after)
      {
        add(number.real(), ' ');
        add(number.imag(), after);
      }

    private:
      std::ostream &out;
      std::string   text;
    };

    template <typename Number>
    void
    write_coordinates(const std::string            &path,
                      const CompressedRows<Number> &matrix,
                      const bool                    symmetric,
                      const std::string            &comment)
    {
      const bool        real   = std::is_same_v<Number, double>;
      const std::size_t n_rows = matrix.starts.size() - 1;
      write_atomically(path, [&](std::ostream &out) {
        out << "%%MatrixMarket matrix coordinate "
            << (real ? "real " : "complex ")
            << (symmetric ? "symmetric" : "general") << "\n% " << comment
            << '\n'
            << n_rows << ' ' << n_rows << ' ' << matrix.starts.back() << '\n';
        Writer writer(out);
        for (std::size_t i = 0; i < n_rows; ++i)
          for (std::size_t k = matrix.starts[i]; k < matrix.starts[i + 1]; ++k)
            {
              writer.add(i + 1, ' ');
              writer.add(matrix.columns[k] + 1, ' ');
              writer.add(matrix.values[k], '\n');
            }
      });
    }
  } // namespace



  void
  write_matrix_market(const std::string             &path,
                      const bool                     is_root,
                      const RowSpace                &space,
                      const std::vector<MatrixTerm> &terms,
                      const std::string             &comment)
  {
    Entries entries = entries_of(terms);
    gather(entries, space);
    if (!is_root || space.rank() != 0)
      return;
    const unsigned int n = space.n_global();
    if (is_complex(terms))
      write_coordinates(path,
                        compress<std::complex<double>>(std::move(entries), n),
                        is_symmetric(terms),
                        comment);
    else
      write_coordinates(path,
                        compress<double>(std::move(entries), n),
                        is_symmetric(terms),
                        comment);
  }



  void
  write_matrix_market(const std::string      &path,
                      const Eigen::MatrixXcd &values,
                      const std::string      &comment)
  {
    write_atomically(path, [&](std::ostream &out) {
      out << "%%MatrixMarket matrix array complex general\n% " << comment
          << '\n'
          << values.rows() << ' ' << values.cols() << '\n';
      Writer writer(out);
      for (Eigen::Index j = 0; j < values.cols(); ++j)
        for (Eigen::Index i = 0; i < values.rows(); ++i)
          writer.add(values(i, j), '\n');
    });
  }
} // namespace squeal
