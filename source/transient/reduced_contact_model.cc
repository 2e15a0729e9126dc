// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/eigen/mass_basis.h>
#include <squeal/transient/reduced_contact_model.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    /** Normal, tangential and transverse rows of every node, interleaved. */
    Functionals
    relative_motion(const ContactGeometry &geometry)
    {
      std::vector<Functionals::Row> rows;
      for (std::size_t j = 0; j < geometry.points.size(); ++j)
        for (const auto &part :
             {geometry.normal, geometry.tangential, geometry.transverse})
          rows.push_back(part->rows()[j]);
      return Functionals(geometry.normal->space_pointer(), std::move(rows));
    }

    /** A motion slower than this is rigid: nothing holds it. */
    constexpr double rigid_frequency = 0.5; // Hz

    /** Responses without their share in the modes, on a factor just below
     * zero, where rigid motions do no harm. */
    class ResidualResponse
    {
    public:
      ResidualResponse(const Pencil &pencil, const Block &shapes)
        : space(*pencil.space())
        , phi(shapes)
        , M_phi(pencil.multiply_mass(shapes))
        , inverse(pencil, -std::pow(2. * M_PI * 20., 2))
      {
      }

      Block
      operator()(const Block &forces) const
      {
        const Block rest = forces - M_phi * inner_products(space, phi, forces);
        const Block x    = inverse.solve(rest);
        return x - phi * inner_products(space, M_phi, x);
      }

      const RowSpace      &space;
      const Block          phi, M_phi;
      const ShiftedInverse inverse;
    };
  } // namespace



  Eigen::VectorXd
  ReducedContactModel::Observation::evaluate(
    const Eigen::VectorXd &coordinates,
    const double           load_share,
    const Eigen::VectorXd &forces) const
  {
    return modes * coordinates + load_share * load - contact * forces;
  }



  ReducedContactModel
  reduce_contact_model(const Pencil          &pencil,
                       const UndampedModes   &modes,
                       const double           cut_off,
                       const ContactGeometry &geometry,
                       const Block           &load,
                       const Block           &observers)
  {
    ReducedContactModel model;
    double              alpha, beta;
    if (!pencil.is_rayleigh_damped(alpha, beta))
      throw InputError("Scene/Damping: a transient needs Model = whole model "
                       "or none, without structural damping: damping in the "
                       "time domain is viscous");
    const RowSpace    &space   = *pencil.space();
    const unsigned int n_modes = modes.n_certified;
    const Block        phi     = modes.shapes.leftCols(n_modes);
    model.cut_off              = cut_off;
    model.omega_squared        = modes.omega_squared.head(n_modes);
    for (Eigen::Index k = 0; k < model.omega_squared.size(); ++k)
      if (model.omega_squared[k] < std::pow(2. * M_PI * rigid_frequency, 2))
        model.omega_squared[k] = 0.;
    model.damping = (alpha + beta * model.omega_squared.array()).matrix();

    const Functionals B = relative_motion(geometry);
    model.participation = B.apply(phi);
    model.load          = inner_products(space, phi, load);

    const ResidualResponse residual_response(pencil, phi);
    const Eigen::Index     n         = B.n_rows();
    const Block            responses = residual_response(
      B.apply_transposed(Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n))));
    const Eigen::MatrixXd G = B.apply(responses);
    model.flexibility       = 0.5 * (G + G.transpose());
    model.load_motion       = B.apply(residual_response(load));
    model.initial_gap       = Eigen::VectorXd::Zero(geometry.points.size());
    model.speed_ratio       = Eigen::Map<const Eigen::VectorXd>(
      geometry.speed_ratio.data(), geometry.speed_ratio.size());
    if (observers.cols() > 0)
      {
        const Block responses_of_observers = residual_response(observers);
        model.observed.modes = inner_products(space, observers, phi);
        model.observed.load =
          inner_products(space, responses_of_observers, load);
        model.observed.contact = B.apply(responses_of_observers).transpose();
      }
    return model;
  }



  std::vector<ModalForce>
  modal_forces(const Pencil          &pencil,
               const UndampedModes   &modes,
               const ContactGeometry &geometry,
               const Block           &forces)
  {
    const Block            phi = modes.shapes.leftCols(modes.n_certified);
    const ResidualResponse residual_response(pencil, phi);
    const Functionals      B     = relative_motion(geometry);
    const Eigen::MatrixXd  modal = inner_products(*pencil.space(), phi, forces);
    const Eigen::MatrixXd  motion = B.apply(residual_response(forces));
    std::vector<ModalForce> result;
    for (Eigen::Index i = 0; i < forces.cols(); ++i)
      result.push_back({modal.col(i), motion.col(i)});
    return result;
  }
} // namespace squeal
