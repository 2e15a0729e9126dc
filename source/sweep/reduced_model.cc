// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/sweep/reduced_model.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace squeal
{
  unsigned int
  LocalModel::n_total() const
  {
    return parts.empty() ? 0 : parts.front().rows();
  }

  bool
  ModelCell::contains(const Eigen::VectorXd &point, const double margin) const
  {
    for (Eigen::Index a = 0; a < point.size(); ++a)
      {
        const double d = margin * (upper[a] - lower[a]) + 1e-12;
        if (point[a] < lower[a] - d || point[a] > upper[a] + d)
          return false;
      }
    return true;
  }

  unsigned int
  ReducedModel::n_total() const
  {
    return parts.empty() ? 0 : parts.front().rows();
  }

  unsigned int
  ReducedModel::largest_basis() const
  {
    unsigned int n = 0;
    for (const auto &cell : cells)
      n = std::max(n, cell.local.n_basis);
    return n;
  }

  const ModelCell &
  ReducedModel::cell_of(const Eigen::VectorXd &point) const
  {
    Assert(!cells.empty(), dealii::ExcInternalError());
    std::size_t best     = 0;
    double      distance = 1e300;
    for (std::size_t c = 0; c < cells.size(); ++c)
      {
        const auto  &cell = cells[c];
        const double d =
          (cell.lower - point)
            .cwiseMax(point - cell.upper)
            .cwiseMax(0.)
            .cwiseQuotient((cell.upper - cell.lower).cwiseMax(1e-300))
            .maxCoeff();
        if (d < distance)
          {
            distance = d;
            best     = c;
          }
      }
    return cells[best];
  }

  ModelCell &
  ReducedModel::cell_of(const Eigen::VectorXd &point)
  {
    return const_cast<ModelCell &>(
      static_cast<const ReducedModel &>(*this).cell_of(point));
  }

  void
  ReducedModel::project(ModelCell &cell) const
  {
    cell.local.parts.clear();
    for (const auto &A : parts)
      {
        Eigen::MatrixXd turned = cell.turn.transpose() * A * cell.turn;
        // What is symmetric stays so: rounding would couple close pairs as
        // friction does.
        if (A == A.transpose())
          turned = 0.5 * (turned + turned.transpose()).eval();
        cell.local.parts.push_back(std::move(turned));
      }
  }
} // namespace squeal
