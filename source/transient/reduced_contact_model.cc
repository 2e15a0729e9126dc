// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/eigen/mass_basis.h>
#include <squeal/transient/reduced_contact_model.h>

namespace squeal
{
  Eigen::VectorXd
  ReducedContactModel::Observation::evaluate(
    const Eigen::VectorXd &coordinates,
    const double           load_share,
    const Eigen::VectorXd &forces) const
  {
    return modes * coordinates + load_share * load - contact * forces;
  }



  ReducedContactModel
  reduce_contact_model(const Pencil         &pencil,
                       const ReductionBasis &basis,
                       const double          cut_off,
                       const ContactNodes   &nodes,
                       const Block          &load,
                       const Block          &observers)
  {
    ReducedContactModel model;
    double              alpha, beta;
    if (!pencil.is_rayleigh_damped(alpha, beta))
      throw InputError("Scene/Damping: a transient needs Model = whole model "
                       "or none, without structural damping: damping in the "
                       "time domain is viscous");
    const RowSpace &space = *pencil.space();
    model.cut_off         = cut_off;
    model.omega_squared   = basis.omega_squared;
    model.damping = (alpha + beta * model.omega_squared.array()).matrix();

    const Functionals B = nodes.relative_motion();
    model.participation = B.apply(basis.shapes);
    model.load          = inner_products(space, basis.shapes, load);

    const ResidualResponse residual_response(pencil, basis);
    const Eigen::Index     n         = B.n_rows();
    const Block            responses = residual_response(
      B.apply_transposed(Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n))));
    const Eigen::MatrixXd G = B.apply(responses);
    model.flexibility       = 0.5 * (G + G.transpose());
    // Springs give way: their compliance adds to that of the bodies.
    model.flexibility.diagonal() += nodes.compliance();
    model.load_motion = B.apply(residual_response(load));
    model.initial_gap = Eigen::VectorXd::Zero(nodes.n_nodes());
    model.speed_ratio = nodes.speed_ratio();
    if (observers.cols() > 0)
      {
        const Block responses_of_observers = residual_response(observers);
        model.observed.modes = inner_products(space, observers, basis.shapes);
        model.observed.load =
          inner_products(space, responses_of_observers, load);
        model.observed.contact = B.apply(responses_of_observers).transpose();
      }
    return model;
  }



  double
  cut_off_damping(const double ratio, const double cut_off, const double f)
  {
    return ratio * std::pow(f / cut_off, 8);
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
      result.push_back(
        {modal.col(i), motion.col(i), forces.col(i), observed.col(i)});
    return result;
  }
} // namespace squeal
