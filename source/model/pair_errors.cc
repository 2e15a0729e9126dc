// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/friction_law.h>
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

    /** The nodes of a contact without springs that slip: the sliding there,
     * and the motion of the source along the normal. */
    struct SlippingNodes
    {
      std::vector<Functionals::Row> tangential, normal;
      std::vector<double>           mu; /**< of each node */
    };

    SlippingNodes
    slipping_nodes(const Model &model, const unsigned int i)
    {
      const ContactParameters &contact = model.parameters().scene.contacts[i];
      const ContactGeometry   &g       = model.linearized().contacts[i];
      const auto              &status  = model.linearized().states[i].status;
      SlippingNodes            result;
      for (std::size_t j = 0; j < g.points.size(); ++j)
        {
          if (status[j] != ContactStatus::slip)
            continue;
          const auto &n = g.frames[j].normal;
          result.tangential.push_back(g.tangential->rows()[j]);
          result.normal.push_back(combine({{n[0], &g.source_rows[j][0]},
                                           {n[1], &g.source_rows[j][1]},
                                           {n[2], &g.source_rows[j][2]}}));
          result.mu.push_back(signed_coefficient(contact, g.speed_ratio[j]));
        }
      return result;
    }

    /** What friction adds to left vectors @p full of contacts whose normal
     * motion is eliminated. The forces n lambda + mu t lambda of the right
     * vectors do no work on the left ones: those do not follow the target
     * along n, but part from it by -mu times their sliding. */
    Block
    friction_of_left(const Model &model, const Block &full)
    {
      const auto &contacts = model.parameters().scene.contacts;
      const auto &space    = model.discretization()->space();
      Block       result   = Block::Zero(full.rows(), full.cols());
      for (unsigned int i = 0; i < contacts.size(); ++i)
        {
          if (contacts[i].formulation ==
              ContactParameters::Formulation::springs)
            continue;
          const SlippingNodes nodes = slipping_nodes(model, i);
          const Eigen::Map<const Eigen::VectorXd> mu(nodes.mu.data(),
                                                     nodes.mu.size());
          Eigen::MatrixXd                         sliding =
            Functionals(space, nodes.tangential).apply(full);
          sliding = (mu.asDiagonal() * sliding).eval();
          result += Functionals(space, nodes.normal).apply_transposed(sliding);
        }
      return result;
    }

    ComplexBlock
    expanded_left(const Model &model, const ComplexBlock &Y)
    {
      ComplexBlock result = expanded(model, Y);
      const Block  re     = friction_of_left(model, result.real()),
                  im      = friction_of_left(model, result.imag());
      result.real() += re;
      result.imag() += im;
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

    /** Forces of springs and mortar pairs on the columns: friction acts on the
     * right vectors, its transpose on the left ones. */
    std::vector<PointForces>
    forces_on(const Model            &model,
              const Block            &columns,
              const Eigen::VectorXcd &lambda)
    {
      const auto with = [&](const FrictionForces friction) {
        std::vector<PointForces> all = spring_forces(model, columns, friction);
        const std::vector<PointForces> mortar = mortar_forces(
          model,
          columns,
          [&](const unsigned int body) {
            return inertia_of_columns(model.parameters().scene, body, lambda);
          },
          friction);
        all.insert(all.end(), mortar.begin(), mortar.end());
        return all;
      };
      std::vector<PointForces>       right = with(FrictionForces::sliding);
      const std::vector<PointForces> left  = with(FrictionForces::transposed);
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
    shapes.left         = expanded_left(model, pairs.left);
    shapes.derivative   = derivatives(pencil, pairs);
    const Block columns = columns_of(shapes);
    return estimate_pair_errors(
      *d, shapes, forces_on(model, columns, pairs.lambda));
  }
} // namespace squeal
