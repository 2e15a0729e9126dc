// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/mass_basis.h>

#include <deal.II/base/exceptions.h>

#include <Eigen/Eigenvalues>

#include <sys/mman.h>

#include <algorithm>
#include <new>
#include <utility>

namespace squeal
{
  GrowingBlock::GrowingBlock(const unsigned int rows)
    : n_rows(rows)
  {
  }

  GrowingBlock::GrowingBlock(GrowingBlock &&other) noexcept
    : n_rows(other.n_rows)
    , n_used(std::exchange(other.n_used, 0))
    , n_bytes(std::exchange(other.n_bytes, 0))
    , data(std::exchange(other.data, nullptr))
  {
  }

  GrowingBlock &
  GrowingBlock::operator=(GrowingBlock &&other) noexcept
  {
    std::swap(n_rows, other.n_rows);
    std::swap(n_used, other.n_used);
    std::swap(n_bytes, other.n_bytes);
    std::swap(data, other.data);
    return *this;
  }

  GrowingBlock::~GrowingBlock()
  {
    if (data)
      munmap(data, n_bytes);
  }

  void
  GrowingBlock::reserve(const std::size_t wanted)
  {
    if (wanted <= n_bytes)
      return;
    const std::size_t larger = std::max(wanted, n_bytes + n_bytes / 4);
    void *moved = data ? mremap(data, n_bytes, larger, MREMAP_MAYMOVE)
                       : mmap(nullptr,
                              larger,
                              PROT_READ | PROT_WRITE,
                              MAP_PRIVATE | MAP_ANONYMOUS,
                              -1,
                              0);
    if (moved == MAP_FAILED)
      throw std::bad_alloc();
    data    = static_cast<double *>(moved);
    n_bytes = larger;
  }

  void
  GrowingBlock::append(const Eigen::Ref<const Block> &columns)
  {
    AssertDimension(columns.rows(), n_rows);
    const std::size_t n_old = n_rows * static_cast<std::size_t>(n_used);
    reserve((n_old + columns.size()) * sizeof(double));
    Eigen::Map<Block>(data + n_old, n_rows, columns.cols()) = columns;
    n_used += columns.cols();
  }

  unsigned int
  GrowingBlock::n_columns() const
  {
    return n_used;
  }

  Eigen::Map<const Block>
  GrowingBlock::view() const
  {
    return Eigen::Map<const Block>(data, n_rows, n_used);
  }



  MassBasis::MassBasis(const Pencil &p, const BasisProducts products)
    : pencil(p)
    , keeps(products == BasisProducts::kept)
    , Q(p.space()->n_owned())
    , MQ(p.space()->n_owned())
  {
  }

  void
  MassBasis::adopt(const Eigen::Ref<const Block> &W,
                   const Eigen::Ref<const Block> &MW)
  {
    AssertDimension(size(), 0);
    Q.append(W);
    if (keeps)
      MQ.append(MW);
  }

  bool
  MassBasis::keeps_products() const
  {
    return keeps;
  }

  unsigned int
  MassBasis::size() const
  {
    return Q.n_columns();
  }

  Eigen::Map<const Block>
  MassBasis::vectors() const
  {
    return Q.view();
  }

  Eigen::Map<const Block>
  MassBasis::mass_products() const
  {
    return MQ.view();
  }



  namespace
  {
    /** Shortening above which one projection is enough. What it leaves of the
     * basis is divided by the shortening, step after step: with 0.01 a basis
     * that came to hold most of the space was no longer orthogonal. */
    constexpr double once_is_enough = 0.1;

    Eigen::VectorXd
    mass_norms(const RowSpace &space, const Block &W, const Block &MW)
    {
      Eigen::MatrixXd squares = W.cwiseProduct(MW).colwise().sum();
      space.sum(squares);
      return squares.row(0).cwiseMax(1e-300).cwiseSqrt();
    }
  } // namespace



  Block
  MassBasis::extend(Block            W,
                    const double     drop,
                    Eigen::MatrixXd *coefficients,
                    const bool       twice)
  {
    const RowSpace &space = *pencil.space();
    Block           MW    = pencil.multiply_mass(W);
    for (unsigned int pass = 0; pass < 2 && W.cols() > 0; ++pass)
      {
        // To unit size first: columns may differ by orders of magnitude, and
        // what counts is how much of each is new.
        const Eigen::VectorXd sizes = mass_norms(space, W, MW);
        W  = (W * sizes.cwiseInverse().asDiagonal()).eval();
        MW = (MW * sizes.cwiseInverse().asDiagonal()).eval();
        if (size() > 0)
          {
            const Eigen::MatrixXd h = keeps
                                        ? inner_products(space, MQ.view(), W)
                                        : inner_products(space, Q.view(), MW);
            W.noalias() -= Q.view() * h;
            if (keeps)
              MW.noalias() -= MQ.view() * h;
            else
              MW = pencil.multiply_mass(W);
            if (coefficients && pass == 0)
              *coefficients = h * sizes.asDiagonal();
          }
        Eigen::MatrixXd gram = inner_products(space, W, MW);
        gram                 = 0.5 * (gram + gram.transpose()).eval();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
        const Eigen::VectorXd &values    = solver.eigenvalues();
        const double           threshold = pass == 0 ? drop * drop : 0.1;
        Eigen::Index           first     = 0;
        while (first < values.size() && values[first] <= threshold)
          ++first;
        const Eigen::Index    n = values.size() - first;
        const Eigen::MatrixXd T =
          solver.eigenvectors().rightCols(n) *
          values.tail(n).cwiseSqrt().cwiseInverse().asDiagonal();
        W = (W * T).eval();
        // Afresh: an updated product holds the rounding errors of all before,
        // times the shortening of each.
        MW = pencil.multiply_mass(W);
        // Once is enough where little was taken away.
        if (!twice && n > 0 && values[first] > once_is_enough * once_is_enough)
          break;
      }
    Q.append(W);
    if (keeps)
      MQ.append(MW);
    return W;
  }
} // namespace squeal
