// SPDX-License-Identifier: LGPL-2.1-or-later

// The product of a symmetric matrix in blocks is that of the dense matrix,
// whatever rows are missing from the blocks.

#include "check.h"

#include <squeal/base/symmetric_block_matrix.h>

#include <random>

using namespace squeal;
using squeal::testing::check;

namespace
{
  struct Case
  {
    Triplets        lower;
    Eigen::MatrixXd dense;
  };

  /** A chain of @p n_vertices with three unknowns each, of which those are left
   * out that @p keep refuses; neighbours up to @p reach are coupled. */
  template <typename Keep>
  Case
  chain(const int n_vertices, const int reach, const Keep &keep)
  {
    std::vector<int> vertex;
    for (int v = 0; v < n_vertices; ++v)
      for (int c = 0; c < 3; ++c)
        if (keep(v, c))
          vertex.push_back(v);
    const int                        n = static_cast<int>(vertex.size());
    Case                             result{{}, Eigen::MatrixXd::Zero(n, n)};
    std::mt19937                     generator(3);
    std::normal_distribution<double> normal;
    for (int i = n - 1; i >= 0; --i)
      for (int j = 0; j <= i; ++j)
        if (vertex[i] - vertex[j] <= reach)
          for (const double value : {normal(generator), normal(generator)})
            {
              // Entries of one place come in two parts, rows backwards.
              result.lower.add(i, j, value);
              result.dense(i, j) += value;
              if (i != j)
                result.dense(j, i) += value;
            }
    return result;
  }

  void
  compare(const Case &c, const std::string &name)
  {
    SymmetricBlockMatrix A(c.lower, c.dense.rows());
    Eigen::VectorXd      y;
    // The second product must not see what the first has left behind.
    for (unsigned int pass = 0; pass < 2; ++pass)
      {
        const Eigen::VectorXd x = Eigen::VectorXd::Random(c.dense.rows());
        A.multiply(x, y);
        check(y.size() == x.size() &&
                (y - c.dense * x).norm() <= 1e-13 * (c.dense * x).norm(),
              name + ": y = A x");
      }
  }
} // namespace



int
main()
{
  compare(chain(40, 3, [](int, int) { return true; }), "whole vertices");
  compare(chain(40, 3, [](int v, int c) { return v % 3 != 0 || c == 1; }),
          "guided vertices");
  compare(chain(17, 16, [](int v, int c) { return (v + c) % 2 == 0; }),
          "full matrix");
  compare(chain(1, 0, [](int, int c) { return c == 0; }), "one unknown");
  compare(chain(30, 0, [](int, int) { return true; }), "diagonal blocks");
  {
    Triplets lower;
    lower.add(0, 0, 2.);
    lower.add(7, 0, 1.);
    Case c{lower, Eigen::MatrixXd::Zero(8, 8)};
    c.dense(0, 0) = 2.;
    c.dense(7, 0) = c.dense(0, 7) = 1.;
    compare(c, "rows without entries");
  }
  return 0;
}
