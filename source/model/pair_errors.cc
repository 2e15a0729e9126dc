// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/model/pair_errors.h>
#include <squeal/model/point_forces.h>
#include <squeal/model/turning_modes.h>


namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    ComplexBlock
    expanded(const Model &model, const ComplexBlock &X)
    {
      const Block re = model.linearized().expand(Block(X.real())),
                  im = model.linearized().expand(Block(X.imag()));
      ComplexBlock result(re.rows(), re.cols());
      result.real() = re;
      result.imag() = im;
      return result;
    }

    /** y^T (2 lambda M + C) x of every pair. */
    Eigen::VectorXcd
    derivatives(const Pencil &pencil, const ComplexPairs &pairs)
    {
      const Pencil::Products products = pencil.apply(pairs.right);
      ComplexBlock           image    = products.damping;
      for (unsigned int k = 0; k < pairs.size(); ++k)
        image.col(k) += 2. * pairs.lambda[k] * products.mass.col(k);
      Eigen::MatrixXd sums(pairs.size(), 2);
      for (unsigned int k = 0; k < pairs.size(); ++k)
        {
          const Complex d =
            (pairs.left.col(k).transpose() * image.col(k))(0, 0);
          sums(k, 0) = d.real();
          sums(k, 1) = d.imag();
        }
      pencil.space()->sum(sums);
      Eigen::VectorXcd result(pairs.size());
      result.real() = sums.col(0);
      result.imag() = sums.col(1);
      return result;
    }

    /** Forces of springs on the columns: friction acts on the right vectors,
     * its transpose on the left ones. */
    std::vector<PointForces>
    forces_of_springs(const Model &model, const Block &columns)
    {
      std::vector<PointForces> right =
        spring_forces(model, columns, FrictionForces::sliding);
      const std::vector<PointForces> left =
        spring_forces(model, columns, FrictionForces::transposed);
      for (std::size_t i = 0; i < right.size(); ++i)
        for (Eigen::Index k = 0; k + 3 < columns.cols(); k += 4)
          right[i].forces.middleCols(k + 2, 2) =
            left[i].forces.middleCols(k + 2, 2);
      return right;
    }
  } // namespace



  PairErrors
  pair_mesh_errors(const Model        &model,
                   const Pencil       &pencil,
                   const ComplexPairs &pairs)
  {
    const Discretization *d = model.discretization();
    if (!d || !d->has_mesh() || has_turning_body(model.parameters().scene) ||
        pairs.left.cols() != pairs.right.cols())
      return PairErrors::unknown(pairs.size());
    PairShapes shapes;
    shapes.lambda       = pairs.lambda;
    shapes.right        = expanded(model, pairs.right);
    shapes.left         = expanded(model, pairs.left);
    shapes.derivative   = derivatives(pencil, pairs);
    const Block columns = columns_of(shapes);
    auto        forces  = forces_of_springs(model, columns);
    const auto  mortar =
      mortar_forces(model, columns, [&](const unsigned int body) {
        return inertia_of_columns(model.parameters().scene, body, pairs.lambda);
      });
    forces.insert(forces.end(), mortar.begin(), mortar.end());
    return estimate_pair_errors(*d, shapes, forces);
  }
} // namespace squeal
