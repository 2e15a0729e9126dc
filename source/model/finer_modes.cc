// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/timers.h>
#include <squeal/eigen/undamped_modes.h>
#include <squeal/model/finer_modes.h>
#include <squeal/model/pressed_model.h>

#include <deal.II/distributed/tria.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    /** 1 - 2 nu of an isotropic material below which its cells' own errors are
     * not to be trusted: at 0.02 they are within a factor 3 no longer. */
    constexpr double least_compliance = 0.1;

    /** Bulk compliance over the sum of the compliances along the axes: 1 - 2 nu
     * of an isotropic material. */
    double
    volume_compliance(const BodyParameters &body)
    {
      if (body.material_model == BodyParameters::MaterialModel::isotropic)
        return 1. - 2. * body.poisson_ratio;
      const auto &E               = body.young_moduli;
      const auto &[n23, n13, n12] = body.poisson_ratios;
      const double along          = 1. / E[0] + 1. / E[1] + 1. / E[2];
      return 1. - 2. * (n12 / E[0] + n13 / E[0] + n23 / E[1]) / along;
    }

    /** Contact states of @p model for the finer unknowns: those of point
     * springs stay where they are; mortar nodes are others. */
    std::vector<ContactStates>
    states_for(const Model                     &model,
               const Discretization            &fine,
               const std::vector<BodyMatrices> &bodies,
               Timers                          &timers)
    {
      bool has_preload = false, all_grids = true;
      for (const auto &contact : model.parameters().scene.contacts)
        {
          has_preload =
            has_preload || contact.state == ContactParameters::State::preload;
          all_grids =
            all_grids &&
            contact.formulation == ContactParameters::Formulation::springs &&
            contact.layout == ContactParameters::SpringLayout::grid;
        }
      if (!has_preload)
        return {};
      if (!all_grids)
        return {ContactStates{
          preload_state(model.parameters(), fine, bodies, timers)}};
      std::vector<ContactStates> result;
      for (const ContactState &state : model.linearized().states)
        result.push_back({state});
      return result;
    }
  } // namespace



  std::vector<std::string>
  nearly_incompressible_bodies(const SceneParameters &scene)
  {
    std::vector<std::string> names;
    for (const auto &body : scene.bodies)
      if (body.shape != BodyParameters::Shape::rigid &&
          volume_compliance(body) < least_compliance * (1. - 1e-12))
        names.push_back(body.name);
    return names;
  }



  Eigen::VectorXd
  errors_by_next_degree(const Model           &model,
                        const Eigen::VectorXd &omega_squared,
                        const double           limit,
                        Timers                &timers)
  {
    Timers::Section section(timers, "Solve: modes of the next degree");
    const auto     &p = model.parameters();
    const auto      fine =
      model.discretization()->with_degree(model.discretization()->degree() + 1);
    const auto             bodies = assemble_bodies(*fine);
    const LinearizedSystem system = linearized_system(
      *fine, bodies, states_for(model, *fine, bodies, timers));
    const Pencil pencil(system.system, p.scene);
    ModeOptions  options;
    options.tolerance = p.eigen.mode_tolerance;
    // A curved face of a higher degree may raise a frequency a little.
    const UndampedModes modes =
      undamped_modes(pencil, ShiftedInverse(pencil, 1.1 * limit), options);
    if (modes.omega_squared.size() < omega_squared.size())
      throw ComputationError(
        "the modes of the next degree, from which the errors of a nearly "
        "incompressible body are estimated, are fewer than those of the mesh: "
        "refine the mesh or set Discretization/Estimate error = false");
    const double    factor = 0.5 * (model.discretization()->degree() + 1.);
    Eigen::VectorXd errors = Eigen::VectorXd::Zero(omega_squared.size());
    for (Eigen::Index i = 0; i < errors.size(); ++i)
      if (omega_squared[i] > 1e-9 * limit)
        errors[i] =
          modes.omega_squared[i] > 0.
            ? factor *
                std::abs(std::sqrt(omega_squared[i] / modes.omega_squared[i]) -
                         1.)
            : std::nan("");
    return errors;
  }
} // namespace squeal
