// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/timers.h>
#include <squeal/eigen/undamped_modes.h>
#include <squeal/model/finer_modes.h>
#include <squeal/model/linear_solver.h>
#include <squeal/model/other_degree.h>

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
    Timers::Section   section(timers, "Solve: modes of the next degree");
    const auto       &p = model.parameters();
    const OtherDegree fine =
      with_degree(model, model.discretization()->degree() + 1, timers);
    ModeOptions options;
    options.tolerance = p.eigen.mode_tolerance;
    // A curved face of a higher degree may raise a frequency a little.
    const ShiftedInverse inverse(
      *fine.pencil, 1.1 * limit, factor_storage(p, *fine.pencil->space()));
    const UndampedModes modes = undamped_modes(*fine.pencil, inverse, options);
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
