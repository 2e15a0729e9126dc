// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/eigen/mass_basis.h>
#include <squeal/transient/reduced_contact_model.h>

#include "sliding_flexibility.h"

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  bool
  is_held_along_face(const Eigen::MatrixXd &flexibility,
                     const unsigned int     node,
                     const Eigen::Vector3d &direction)
  {
    constexpr double      rounding = 1e-12;
    const Eigen::Matrix3d own = flexibility.block<3, 3>(3 * node, 3 * node);
    return direction[0] == 0. &&
           !(direction.dot(own * direction) > rounding * own(0, 0));
  }

  bool
  is_held_along_face(const ReducedContactModel &m,
                     const unsigned int         node,
                     const Eigen::Vector3d     &direction)
  {
    constexpr double rounding = 1e-10; // of the largest motion in a mode
    if (!is_held_along_face(m.flexibility, node, direction))
      return false;
    const Eigen::MatrixXd &Psi = m.participation;
    return Psi.size() == 0 ||
           !((direction.transpose() * Psi.middleRows<3>(3 * node))
               .cwiseAbs()
               .maxCoeff() > rounding * Psi.cwiseAbs().maxCoeff());
  }



  namespace
  {
    /** Of the flexibility along the normal, along the sliding: so little that a
     * target that slides reaches friction's limit in any step. One at rest does
     * not, and a small share of it would stiffen the law without need. */
    constexpr double share_of_sliding = 1e-6;

    /** Of the least motion along the face that there is, of those that there
     * are not: a force reaches friction's limit by what moves, and differences
     * between nodes that only move together do not hold it below. */
    constexpr double share_of_least_motion = 1e-6;

    /** Of the largest motion along the face, what an inverse can still tell
     * from none. */
    constexpr double least_share_of_largest = 1e-13;

    /** Of the largest motion along the face by a force of 1 N there, below
     * which one is rounding. */
    constexpr double rounding_of_face = 1e-11;

    /** Whether the target slides past node @p j; without speeds all do. */
    bool
    slides_past(const Eigen::VectorXd &speed_ratio, const Eigen::Index j)
    {
      return speed_ratio.size() == 0 || speed_ratio[j] != 0.;
    }
  } // namespace

  void
  fill_where_held(Eigen::MatrixXd &W, const Eigen::VectorXd &speed_ratio)
  {
    for (Eigen::Index j = 0; j < W.rows() / 3; ++j)
      for (const unsigned int c : {1, 2})
        if (is_held_along_face(W, j, Eigen::Vector3d::Unit(c)))
          {
            // Across the sliding as much as the rest has, for the iteration.
            const double share =
              c == 1 && slides_past(speed_ratio, j) ? share_of_sliding : 1.;
            W(3 * j + c, 3 * j + c) += share * W(3 * j, 3 * j);
          }
  }



  namespace
  {
    /** Whether Cholesky's method finds a pivot of @p W, symmetric, that is
     * rounding, or none: what it costs beside eigenvalues is little. */
    bool
    may_be_singular(const Eigen::MatrixXd &W)
    {
      const Eigen::LLT<Eigen::MatrixXd> factor(W);
      return factor.info() != Eigen::Success ||
             (factor.matrixLLT().diagonal().array().square() <=
              rounding_of_face * W.diagonal().array())
               .any();
    }

    /** Orthonormal columns, those of eigenvalue 0 of @p W, symmetric. */
    Eigen::MatrixXd
    null_space(const Eigen::MatrixXd &W)
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> pairs(W);
      const double     largest = pairs.eigenvalues().cwiseAbs().maxCoeff();
      std::vector<int> columns;
      for (Eigen::Index k = 0; k < W.rows(); ++k)
        if (std::abs(pairs.eigenvalues()[k]) <= rounding_of_face * largest)
          columns.push_back(k);
      return pairs.eigenvectors()(Eigen::all, columns);
    }
  } // namespace

  namespace
  {
    /** The rows along the faces but for those fill_where_held() sees to. */
    std::vector<int>
    moving_rows_of_face(const Eigen::MatrixXd &W)
    {
      std::vector<int> result;
      for (Eigen::Index j = 0; j < W.rows() / 3; ++j)
        for (const int c : {1, 2})
          if (!is_held_along_face(W, j, Eigen::Vector3d::Unit(c)))
            result.push_back(3 * j + c);
      return result;
    }

    /** What the motions @p null, orthonormal, get beside those of @p of_face,
     * symmetric, that are orthogonal to them. */
    double
    size_of_fill(const Eigen::MatrixXd &of_face, const Eigen::MatrixXd &null)
    {
      // Lifted above all others, the null space leaves its complement below.
      const double          above  = 2. * of_face.trace();
      Eigen::MatrixXd       lifted = of_face + above * null * null.transpose();
      const Eigen::VectorXd sizes =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(lifted,
                                                       Eigen::EigenvaluesOnly)
          .eigenvalues()
          .head(of_face.rows() - null.cols());
      if (sizes.size() == 0 || !(sizes[sizes.size() - 1] > 0.))
        return 0.;
      const double largest = sizes[sizes.size() - 1];
      double       least   = largest;
      for (const double size : sizes)
        if (size > rounding_of_face * largest)
          least = std::min(least, size);
      return std::max(share_of_least_motion * least,
                      least_share_of_largest * largest);
    }

    /** What @p W gets along the motions that @p all has not. */
    Eigen::MatrixXd
    fill_beside(const Eigen::MatrixXd &W, const Eigen::MatrixXd &all)
    {
      if (!W.allFinite() || !all.allFinite())
        return {};
      const std::vector<int> rows = moving_rows_of_face(all);
      if (rows.empty())
        return {};
      const Eigen::MatrixXd of_face = all(rows, rows);
      if (!may_be_singular(of_face))
        return {};
      const Eigen::MatrixXd null = null_space(of_face);
      if (null.cols() == 0)
        return {};
      Eigen::MatrixXd result = Eigen::MatrixXd::Zero(W.rows(), W.cols());
      result(rows, rows) =
        size_of_fill(W(rows, rows), null) * null * null.transpose();
      return result;
    }

    /** Compliance of the modes that something holds, 0 of the others. */
    Eigen::VectorXd
    compliance_of_held(const ReducedContactModel &model)
    {
      return (model.omega_squared.array() > 0.)
        .select(model.omega_squared.cwiseInverse(), 0.);
    }

    /** All that moves in @p model. Motions without a stiffness would drown the
     * others: modes and residual flexibility count alike, and not at all where
     * the latter is the rounding of what the modes leave. */
    Eigen::MatrixXd
    all_motions(const ReducedContactModel &model)
    {
      constexpr double       rounding = 1e-13; // of the motions in modes
      const Eigen::MatrixXd &Psi      = model.participation;
      Eigen::MatrixXd        all      = Psi * Psi.transpose();
      const double           of_modes = all.trace();
      if (!(of_modes > 0.))
        return model.flexibility;
      const double flexibility = model.flexibility.trace();
      const double in_modes =
        Psi.colwise().squaredNorm().dot(compliance_of_held(model));
      if (flexibility > rounding * in_modes)
        all = (all * (flexibility / of_modes) + model.flexibility).eval();
      return all;
    }
  } // namespace

  Eigen::MatrixXd
  fill_of_null_space(const Eigen::MatrixXd &W)
  {
    return fill_beside(W, W);
  }

  Eigen::MatrixXd
  fill_of_null_space(const ReducedContactModel &model, const Eigen::MatrixXd &W)
  {
    return fill_beside(W, all_motions(model));
  }

  Eigen::MatrixXd
  fill_of_null_space(const ReducedContactModel &model)
  {
    const Eigen::MatrixXd &Psi = model.participation;
    return fill_of_null_space(
      model,
      Eigen::MatrixXd(Psi * compliance_of_held(model).asDiagonal() *
                        Psi.transpose() +
                      model.flexibility));
  }



  Eigen::VectorXd
  ReducedContactModel::Observation::evaluate(
    const Eigen::VectorXd &coordinates,
    const double           load_share,
    const Eigen::VectorXd &forces) const
  {
    return modes * coordinates + load_share * load - contact * forces;
  }



  void
  ReducedContactModel::turn_back(const std::vector<bool> &of_nodes)
  {
    AssertDimension(of_nodes.size(), n_nodes());
    Eigen::VectorXd sign = Eigen::VectorXd::Ones(3 * n_nodes());
    for (unsigned int j = 0; j < n_nodes(); ++j)
      if (of_nodes[j])
        sign.segment(3 * j + 1, 2).setConstant(-1.);
    for (Eigen::MatrixXd *x : {&participation, &residual_coupling})
      if (x->size() > 0)
        *x = (sign.asDiagonal() * *x).eval();
    for (Eigen::MatrixXd *x :
         {&flexibility, &residual_inertia, &residual_damping})
      if (x->size() > 0)
        *x = (sign.asDiagonal() * *x * sign.asDiagonal()).eval();
    load_motion = sign.cwiseProduct(load_motion).eval();
    if (observed.contact.size() > 0)
      observed.contact = (observed.contact * sign.asDiagonal()).eval();
  }



  namespace
  {
    /** Sets the columns of @p observers that hold NaN on some rank to zero, as
     * no system may be solved with them, and says which hold none. */
    std::vector<bool>
    take_known(const RowSpace &space, Block &observers)
    {
      const Eigen::VectorXd norms = space.norms(observers);
      std::vector<bool>     is_known;
      for (Eigen::Index i = 0; i < observers.cols(); ++i)
        {
          is_known.push_back(std::isfinite(norms[i]));
          if (!is_known.back())
            observers.col(i).setZero();
        }
      return is_known;
    }

    void
    set_damping(const Pencil         &pencil,
                const ReductionBasis &basis,
                ReducedContactModel  &model)
    {
      check_time_domain_damping(pencil);
      double alpha, beta;
      if (pencil.is_rayleigh_damped(alpha, beta))
        {
          model.damping = (alpha + beta * model.omega_squared.array()).matrix();
          return;
        }
      const Eigen::MatrixXd D =
        inner_products(*pencil.space(),
                       basis.shapes,
                       pencil.multiply_damping(Block(basis.shapes)));
      model.damping          = D.diagonal();
      model.damping_coupling = 0.5 * (D + D.transpose());
      model.damping_coupling.diagonal().setZero();
    }
  } // namespace



  void
  check_time_domain_damping(const Pencil &pencil)
  {
    if (!pencil.is_viscously_damped())
      throw InputError(
        "steady sliding and motions in time take mass damping, stiffness "
        "damping and dashpots of the whole model or of its parts, but no loss "
        "factors ('Structural damping', modulus tables) and no damping "
        "matrices that are not symmetric");
  }



  ReducedContactModel
  reduce_contact_model(const Pencil         &pencil,
                       const ReductionBasis &basis,
                       const double          cut_off,
                       const ContactNodes   &nodes,
                       const Block          &load,
                       const Block          &observers,
                       const Flexibility     flexibility)
  {
    ReducedContactModel model;
    const RowSpace     &space = *pencil.space();
    model.cut_off             = cut_off;
    model.omega_squared       = basis.omega_squared;
    set_damping(pencil, basis, model);

    const Functionals B = nodes.relative_motion();
    model.participation = B.apply(basis.shapes);
    model.load          = inner_products(space, basis.shapes, load);

    // Modes above the cut-off are left with a relative error of the square of
    // the shift's share of it.
    const ResidualResponse residual_response =
      flexibility == Flexibility::complete
        ? ResidualResponse(pencil, basis)
        : ResidualResponse(pencil, basis, shift_of_sliding * cut_off);
    if (flexibility == Flexibility::complete)
      {
        ResidualFlexibility residual = residual_response.flexibility(B);
        model.flexibility            = std::move(residual.flexibility);
        model.residual_inertia       = std::move(residual.inertia);
        model.residual_damping       = std::move(residual.damping);
        model.residual_coupling      = std::move(residual.coupling);
      }
    else
      {
        const SlidingFlexibility sliding(nodes);
        model.flexibility = sliding.complete(B.apply(
          residual_response.approximate(B.apply_transposed(sliding.forces()))));
      }
    // Springs give way: their compliance adds to that of the bodies.
    model.flexibility.diagonal() += nodes.compliance();
    const Block response   = residual_response(load);
    model.load_motion      = B.apply(response);
    model.load_flexibility = inner_products(space, load, response).sum();
    model.initial_gap      = Eigen::VectorXd::Zero(nodes.n_nodes());
    model.speed_ratio      = nodes.speed_ratio();
    if (observers.cols() > 0)
      {
        Block                   known      = observers;
        const std::vector<bool> is_known   = take_known(space, known);
        const Block responses_of_observers = residual_response(known);
        model.observed.modes = inner_products(space, known, basis.shapes);
        model.observed.load =
          inner_products(space, responses_of_observers, load);
        model.observed.contact = B.apply(responses_of_observers).transpose();
        for (std::size_t i = 0; i < is_known.size(); ++i)
          if (!is_known[i])
            model.observed.load.row(i).setConstant(
              std::numeric_limits<double>::quiet_NaN());
      }
    return model;
  }



  double
  cut_off_damping(const double ratio, const double cut_off, const double f)
  {
    // Ritz vectors of the interface go far above the cut-off: they are to
    // follow the contact, and not to be held by damping.
    return ratio * std::min(1., std::pow(f / cut_off, 8));
  }



  void
  add_cut_off_damping(ReducedContactModel &model, const double ratio)
  {
    for (Eigen::Index k = 0; k < model.damping.size(); ++k)
      {
        const double omega = std::sqrt(std::max(model.omega_squared[k], 0.));
        model.damping[k] +=
          2. * omega *
          cut_off_damping(ratio, model.cut_off, omega / (2. * M_PI));
      }
  }



  std::vector<ModalForce>
  modal_forces(const Pencil         &pencil,
               const ReductionBasis &basis,
               const Functionals    &relative_motion,
               const Block          &forces,
               const Block          &observers)
  {
    const RowSpace        &space = *pencil.space();
    const ResidualResponse residual_response(pencil, basis);
    const Block            responses = residual_response(forces);
    const Eigen::MatrixXd  modal = inner_products(space, basis.shapes, forces),
                          motion = relative_motion.apply(responses),
                          observed =
                            inner_products(space, observers, responses);
    std::vector<ModalForce> result;
    for (Eigen::Index i = 0; i < forces.cols(); ++i)
      result.push_back({modal.col(i),
                        motion.col(i),
                        forces.col(i),
                        observed.col(i),
                        responses.col(i)});
    return result;
  }
} // namespace squeal
