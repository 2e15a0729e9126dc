// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/mass_basis.h>
#include <squeal/transient/reduction_basis.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** A motion slower than this is rigid: nothing holds it. The second number
     * is a share of the frequency of the matrices and holds where files have
     * units in which all frequencies are small numbers. */
    constexpr double rigid_frequency = 0.5, // Hz
      rigid_share                    = 1e-4;

    /** The same of the shift of a factor beside zero. */
    constexpr double shift_share = 1e-3;

    /** Size of the frequencies of @p pencil, Hz: that of a motion in which all
     * unknowns take part; 0 where nothing is stiff. */
    double
    matrix_frequency(const Pencil &pencil)
    {
      const RowSpace &space = *pencil.space();
      Block           x(space.n_owned(), 1);
      for (unsigned int i = 0; i < space.n_owned(); ++i)
        x(i, 0) = std::cos(1e3 * (space.first_owned() + i + 1.));
      Eigen::MatrixXd sizes(1, 2);
      sizes << x.cwiseProduct(pencil.multiply_undamped_stiffness(x)).sum(),
        x.cwiseProduct(pencil.multiply_mass(x)).sum();
      space.sum(sizes);
      return std::sqrt(std::max(sizes(0, 0), 0.) / sizes(0, 1)) / (2. * M_PI);
    }

    /** @p frequency, Hz, or @p share of that of the matrices, where they have
     * one that is so small. */
    double
    scaled_frequency(const Pencil &pencil,
                     const double  frequency,
                     const double  share)
    {
      const double of_matrices = share * matrix_frequency(pencil);
      return of_matrices > 0. ? std::min(frequency, of_matrices) : frequency;
    }

    /** Directions that shrink below this share of their size are dropped. */
    constexpr double krylov_drop = 1e-7;

    /** Right-hand sides of one solve. */
    constexpr Eigen::Index columns_at_once = 128;

    /** Appends the Ritz vectors up to @p cut_off to a basis of modes. */
    void
    append_ritz_vectors(const Pencil      &pencil,
                        const Functionals &B,
                        const double       cut_off,
                        ReductionBasis    &basis)
    {
      const RowSpace        &space = *pencil.space();
      const ResidualResponse residual_response(pencil, basis);
      const Eigen::Index     n = B.n_rows();
      MassBasis              krylov(pencil);
      Block                  next = residual_response(
        B.apply_transposed(Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n))));
      for (unsigned int level = 0; level < 2; ++level)
        {
          const Block added = krylov.extend(next, krylov_drop);
          if (level == 0)
            next = residual_response(pencil.multiply_mass(added));
        }
      const auto            Q = krylov.vectors();
      const Eigen::MatrixXd K =
        inner_products(space, Q, pencil.multiply_undamped_stiffness(Block(Q)));
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
        Eigen::MatrixXd(0.5 * (K + K.transpose())));
      const double highest = std::pow(2. * M_PI * cut_off, 2);
      const auto   n_kept =
        (ritz.eigenvalues().array() < highest).cast<int>().sum();
      const Eigen::MatrixXd Z   = ritz.eigenvectors().leftCols(n_kept);
      const Eigen::Index    old = basis.omega_squared.size();
      basis.shapes.conservativeResize(Eigen::NoChange, old + n_kept);
      basis.mass_shapes.conservativeResize(Eigen::NoChange, old + n_kept);
      basis.omega_squared.conservativeResize(old + n_kept);
      basis.shapes.rightCols(n_kept)      = Q * Z;
      basis.mass_shapes.rightCols(n_kept) = krylov.mass_products() * Z;
      basis.omega_squared.tail(n_kept)    = ritz.eigenvalues().head(n_kept);
    }
  } // namespace



  ReductionBasis
  reduction_basis(const Pencil        &pencil,
                  const UndampedModes &modes,
                  const Functionals   &relative_motion,
                  const double         interface_cut_off)
  {
    ReductionBasis basis;
    basis.n_modes       = modes.n_certified;
    basis.shapes        = modes.shapes.leftCols(basis.n_modes);
    basis.mass_shapes   = pencil.multiply_mass(basis.shapes);
    basis.omega_squared = modes.omega_squared.head(basis.n_modes);
    const double rigid  = std::pow(
      2. * M_PI * scaled_frequency(pencil, rigid_frequency, rigid_share), 2);
    for (Eigen::Index k = 0; k < basis.omega_squared.size(); ++k)
      if (basis.omega_squared[k] < rigid)
        basis.omega_squared[k] = 0.;
    if (interface_cut_off > 0.)
      append_ritz_vectors(pencil, relative_motion, interface_cut_off, basis);
    return basis;
  }



  ResidualResponse::ResidualResponse(const Pencil         &pencil,
                                     const ReductionBasis &b,
                                     const double          shift)
    : space(*pencil.space())
    , basis(b)
    , pencil(pencil)
    , inverse(
        pencil,
        -std::pow(2. * M_PI * scaled_frequency(pencil, shift, shift_share), 2))
  {
  }



  Block
  ResidualResponse::without_modes(const Block &forces) const
  {
    const auto phi   = basis.shapes.leftCols(basis.n_modes),
               M_phi = basis.mass_shapes.leftCols(basis.n_modes);
    Block rest       = forces;
    rest -= M_phi * inner_products(space, phi, rest);
    Block x = inverse.solve(rest);
    x -= phi * inner_products(space, M_phi, x);
    return x;
  }

  Block
  ResidualResponse::operator()(const Block &forces) const
  {
    // The factor stands beside zero, which is an error of shift / omega^2 in
    // every mode that is left: a second round squares it.
    Block x = without_modes(forces);
    x += without_modes(forces - pencil.multiply_undamped_stiffness(x));
    subtract_ritz_vectors(forces, x);
    return x;
  }

  Block
  ResidualResponse::approximate(const Block &forces) const
  {
    Block x = without_modes(forces);
    subtract_ritz_vectors(forces, x);
    return x;
  }

  void
  ResidualResponse::subtract_ritz_vectors(const Block &forces, Block &x) const
  {
    const Eigen::Index n_ritz = basis.omega_squared.size() - basis.n_modes;
    if (n_ritz == 0)
      return;
    const auto ritz = basis.shapes.rightCols(n_ritz);
    x -= ritz * basis.omega_squared.tail(n_ritz).cwiseInverse().asDiagonal() *
         inner_products(space, ritz, forces);
  }


  ResidualFlexibility
  ResidualResponse::flexibility(const Functionals &B) const
  {
    const Eigen::Index  n = B.n_rows();
    Block               x(space.n_owned(), n);
    ResidualFlexibility result;
    Eigen::MatrixXd    &G = result.flexibility;
    G.resize(n, n);
    // Columns in groups: whole blocks of forces and products beside the
    // responses would take four times the memory.
    for (Eigen::Index first = 0; first < n; first += columns_at_once)
      {
        const Eigen::Index m    = std::min(columns_at_once, n - first);
        Eigen::MatrixXd    unit = Eigen::MatrixXd::Zero(n, m);
        unit.middleRows(first, m).setIdentity();
        const Block moved      = without_modes(B.apply_transposed(unit));
        x.middleCols(first, m) = moved;
        G.middleCols(first, m) = B.apply(moved);
      }
    // The second round of the operator answers to -shift M x. As both sides are
    // the same functionals, its products with these are those of x with it: no
    // solve. Those of one half are enough.
    result.inertia =
      products(x, [this](const Block &y) { return pencil.multiply_mass(y); });
    G = Eigen::MatrixXd(G.selfadjointView<Eigen::Lower>()) -
        inverse.shift() * result.inertia;
    const Eigen::Index n_ritz = basis.omega_squared.size() - basis.n_modes;
    const auto         ritz   = basis.shapes.rightCols(n_ritz);
    if (n_ritz > 0)
      {
        const Eigen::MatrixXd Psi = B.apply(Block(ritz));
        const auto W = basis.omega_squared.tail(n_ritz).cwiseInverse();
        const Eigen::MatrixXd static_ritz = Psi * W.asDiagonal();
        G -= static_ritz * Psi.transpose();
        result.inertia -= static_ritz * static_ritz.transpose();
        x.noalias() -= ritz * static_ritz.transpose();
      }
    double alpha, beta;
    if (pencil.is_rayleigh_damped(alpha, beta))
      result.damping = alpha * result.inertia + beta * G;
    else
      {
        result.damping = products(
          x, [this](const Block &y) { return pencil.multiply_damping(y); });
        result.coupling = damping_of_basis(x);
      }
    return result;
  }

  Eigen::MatrixXd
  ResidualResponse::damping_of_basis(const Block &x) const
  {
    const Eigen::Index n = basis.shapes.cols();
    Eigen::MatrixXd    result(x.cols(), n);
    for (Eigen::Index first = 0; first < n; first += columns_at_once)
      {
        const Eigen::Index m        = std::min(columns_at_once, n - first);
        result.middleCols(first, m) = inner_products(
          space,
          x,
          pencil.multiply_damping(Block(basis.shapes.middleCols(first, m))));
      }
    return result;
  }

  Eigen::MatrixXd
  ResidualResponse::products(
    const Block                               &x,
    const std::function<Block(const Block &)> &multiply) const
  {
    const Eigen::Index n = x.cols();
    Eigen::MatrixXd    result(n, n);
    for (Eigen::Index first = 0; first < n; first += columns_at_once)
      {
        const Eigen::Index m = std::min(columns_at_once, n - first);
        result.block(first, first, n - first, m) =
          inner_products(space,
                         x.rightCols(n - first),
                         multiply(Block(x.middleCols(first, m))));
      }
    return result.selfadjointView<Eigen::Lower>();
  }
} // namespace squeal
