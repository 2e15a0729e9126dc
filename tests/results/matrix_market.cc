// SPDX-License-Identifier: LGPL-2.1-or-later

// MatrixMarket files hold the sum of the terms to the last digit, symmetric
// ones by their lower triangle, and are not left half written.

#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/sparse_matrix.h>
#include <squeal/results/matrix_market.h>

#include <squeal/scene/matrix_import.h>

#include <filesystem>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Four unknowns and operators on them. */
  struct Example
  {
    const std::shared_ptr<const RowSpace> rows =
      std::make_shared<const RowSpace>(4);
    const std::shared_ptr<const SparseMatrix>
      A = sparse({{0, 0, 1.}, {1, 0, -.1}, {2, 2, 1. / 3.}, {3, 1, 5e-300}}),
      B = sparse({{0, 0, 1.}, {3, 3, 1e22}, {3, 1, 2.}}),
      S = sparse({{2, 1, .7}}, SparseMatrix::Symmetry::skew);

    std::shared_ptr<const SparseMatrix>
    sparse(
      const std::vector<std::tuple<int, int, double>> &lower,
      const SparseMatrix::Symmetry symmetry = SparseMatrix::Symmetry::symmetric)
    {
      Triplets triplets;
      for (const auto &[i, j, a] : lower)
        triplets.add(i, j, a);
      return std::make_shared<const SparseMatrix>(rows, triplets, symmetry);
    }
  };

  void
  check_file(const std::vector<MatrixTerm> &terms,
             const std::string             &expected,
             const std::string             &name)
  {
    write_matrix_market("a.mtx", true, RowSpace(4), terms, "text");
    check(read_file("a.mtx") == expected, name + "\n" + read_file("a.mtx"));
  }

  void
  test_texts()
  {
    const Example e;
    check_file({{1., e.A}, {-1., e.B}},
               "%%MatrixMarket matrix coordinate real symmetric\n% text\n"
               "4 4 4\n"
               "2 1 -0.1\n"
               "3 3 0.3333333333333333\n"
               "4 2 -2\n"
               "4 4 -1e+22\n",
               "a sum: each place once, in order, zeros left out");
    check_file({{2., e.S}, {0., e.A}},
               "%%MatrixMarket matrix coordinate real general\n% text\n"
               "4 4 2\n"
               "2 3 -1.4\n"
               "3 2 1.4\n",
               "not symmetric: both triangles; a term of factor 0 is no term");
    check_file({{{1., .5}, e.B}},
               "%%MatrixMarket matrix coordinate complex symmetric\n% text\n"
               "4 4 3\n"
               "1 1 1 0.5\n"
               "4 2 2 1\n"
               "4 4 1e+22 5e+21\n",
               "complex");
    check_file({{{0., 1.}, e.A}, {1., e.S}},
               "%%MatrixMarket matrix coordinate complex general\n% text\n"
               "4 4 8\n"
               "1 1 0 1\n"
               "1 2 0 -0.1\n"
               "2 1 0 -0.1\n"
               "2 3 -0.7 0\n"
               "2 4 0 5e-300\n"
               "3 2 0.7 0\n"
               "3 3 0 0.3333333333333333\n"
               "4 2 0 5e-300\n",
               "complex and not symmetric");
    check_file({},
               "%%MatrixMarket matrix coordinate real symmetric\n% text\n"
               "4 4 0\n",
               "no terms: zeros");
    Eigen::MatrixXcd X(2, 2);
    X << 1., 2., std::complex<double>(.1, -3.), 0.;
    write_matrix_market("x.mtx", X, "text");
    check(read_file("x.mtx") ==
            "%%MatrixMarket matrix array complex general\n% text\n2 2\n"
            "1 0\n0.1 -3\n2 0\n0 0\n",
          "a full matrix, column by column");
  }

  /** Doubles of all sizes come back as they were. */
  void
  test_digits()
  {
    Triplets            lower;
    const int           n     = 3000;
    const auto          space = std::make_shared<const RowSpace>(n);
    double              a     = 1e-150;
    std::vector<double> values;
    for (int i = 0; i < n; ++i)
      {
        a *= 1.2589254117941673;
        values.push_back(i % 2 ? a : -a);
        lower.add(i, i, values.back());
      }
    write_matrix_market(
      "digits.mtx",
      true,
      *space,
      {{1., std::make_shared<const SparseMatrix>(space, lower)}},
      "digits");
    MatrixPartParameters part;
    part.file            = "digits.mtx";
    part.role            = MatrixPartParameters::Role::damping;
    const auto read_back = read_matrix(part);
    check(read_back.values == values, "every double comes back");
  }

  void
  test_unwritable()
  {
    const Example e;
    check_throws<InputError>(
      [&] {
        write_matrix_market("missing/a.mtx", true, *e.rows, {{1., e.A}}, "");
      },
      "cannot write 'missing/a.mtx'",
      "a folder that is not there");
    check(!std::filesystem::exists("missing"), "nothing is left behind");
    write_matrix_market("other.mtx", false, *e.rows, {{1., e.A}}, "");
    check(!std::filesystem::exists("other.mtx"), "only the root writes");
  }
} // namespace



int
main()
{
  // RowSpace asks MPI for its ranks.
  MPI_Init(nullptr, nullptr);
  test_texts();
  test_digits();
  test_unwritable();
  MPI_Finalize();
  return 0;
}
