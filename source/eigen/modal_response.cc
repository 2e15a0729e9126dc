// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/row_space.h>
#include <squeal/eigen/modal_response.h>

#include <Eigen/LU>

#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Relative distance below which eigenvalues count as one: far above their
     * rounding, far below the width of any resonance. */
    constexpr double multiple = 1e-9;

    /** X^T Y over all ranks. */
    Eigen::MatrixXcd
    product(const RowSpace &space, const Block &X, const ComplexBlock &Y)
    {
      Eigen::MatrixXcd result(X.cols(), Y.cols());
      result.real() = space.dot(X, Block(Y.real()));
      result.imag() = space.dot(X, Block(Y.imag()));
      return result;
    }
  } // namespace



  DirectResponse::DirectResponse(const Pencil &pencil,
                                 const Block  &forces,
                                 const Block  &observations)
    : pencil(pencil)
    , forces(forces)
    , observations(observations)
  {
  }



  Eigen::MatrixXcd
  DirectResponse::solve(const double omega) const
  {
    std::vector<int>            rows, columns;
    std::vector<Complex>        values;
    MumpsFactorization<Complex> factor(
      pencil.space(), MumpsFactorization<Complex>::Symmetry::general);
    pencil.quadratic_entries({0., omega}, rows, columns, values);
    factor.factorize(std::move(rows), std::move(columns), std::move(values));
    const ComplexBlock X = factor.solve(forces.cast<Complex>());
    return product(*pencil.space(), observations, X);
  }



  ModalResponse::ModalResponse(const Pencil       &pencil,
                               const ComplexPairs &pairs,
                               const Block        &forces,
                               const Block        &observations)
    : lambda(pairs.lambda)
    , partner(pairs.lambda.conjugate())
    , has_partner(pairs.size())
    , observed(product(*pencil.space(), observations, pairs.right))
    , flexibility(Eigen::MatrixXcd::Zero(observations.cols(), forces.cols()))
    , first(flexibility)
    , second(flexibility)
    , is_real(!pencil.has_structural_damping())
  {
    const RowSpace        &space = *pencil.space();
    const Pencil::Products P     = pencil.apply(pairs.right);
    const Eigen::MatrixXcd mass  = space.dot(pairs.left, P.mass);
    const Eigen::MatrixXcd damp  = space.dot(pairs.left, P.damping);
    participation = product(space, forces, pairs.left).transpose();
    for (unsigned int i = 0; i < pairs.size();)
      {
        unsigned int n = 1;
        while (i + n < pairs.size() && std::abs(lambda[i + n] - lambda[i]) <=
                                         multiple * std::abs(lambda[i]))
          ++n;
        const Complex          mean = lambda.segment(i, n).mean();
        const Eigen::MatrixXcd norm =
          2. * mean * mass.block(i, i, n, n) + damp.block(i, i, n, n);
        const Eigen::MatrixXcd left = participation.middleRows(i, n);
        participation.middleRows(i, n) =
          Eigen::FullPivLU<Eigen::MatrixXcd>(norm).solve(left);
        for (unsigned int k = i; k < i + n; ++k)
          {
            if (!is_real)
              partner[k] = -lambda[k] - damp(k, k) / mass(k, k);
            has_partner[k] =
              std::abs(lambda[k].imag()) > 1e-12 * std::abs(lambda[k]);
          }
        i += n;
      }
  }



  Eigen::MatrixXcd
  ModalResponse::superposition(const Complex s) const
  {
    const Eigen::VectorXcd own    = (s - lambda.array()).inverse();
    Eigen::MatrixXcd       result = observed * own.asDiagonal() * participation;
    const Eigen::VectorXcd other =
      has_partner.cast<Complex>().array() / (s - partner.array());
    if (is_real)
      result +=
        observed.conjugate() * other.asDiagonal() * participation.conjugate();
    else
      result -= observed * other.asDiagonal() * participation;
    return result;
  }



  void
  ModalResponse::set_flexibility(const Eigen::MatrixXcd &exact)
  {
    flexibility = exact - superposition(0.);
    if (is_real)
      flexibility.imag().setZero();
  }

  void
  ModalResponse::set_inertia(const double omega, const Eigen::MatrixXcd &exact)
  {
    const Eigen::MatrixXcd D = exact - superposition({0., omega}) - flexibility;
    if (is_real)
      {
        first  = (D.imag() / omega).cast<Complex>();
        second = (-D.real() / (omega * omega)).cast<Complex>();
      }
    else
      second = -D / (omega * omega);
  }



  Eigen::MatrixXcd
  ModalResponse::receptance(const double omega) const
  {
    const Complex s(0., omega);
    return superposition(s) + flexibility + s * first + s * s * second;
  }



  Eigen::VectorXcd
  ModalResponse::residues(const unsigned int i, const unsigned int j) const
  {
    return observed.row(i).transpose().cwiseProduct(participation.col(j));
  }

  const Eigen::MatrixXcd &
  ModalResponse::shapes() const
  {
    return observed;
  }
} // namespace squeal
