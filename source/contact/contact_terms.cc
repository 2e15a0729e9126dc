// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/contact_terms.h>
#include <squeal/contact/friction_law.h>
#include <squeal/contact/spring_stiffness.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    using Coefficients =
      std::function<TermCoefficients(const SceneParameters &)>;

    /** @p coefficients where state @p k of @p n of a pair holds. */
    Coefficients
    where_state(const unsigned int  number,
                const std::size_t   k,
                const std::size_t   n,
                const Coefficients &coefficients)
    {
      if (n == 1)
        return coefficients;
      return [=](const SceneParameters &s) {
        return s.contacts[number].state_number == k ? coefficients(s)
                                                    : TermCoefficients();
      };
    }

    Eigen::VectorXd
    selected_weights(const ContactGeometry   &geometry,
                     const ContactState      &state,
                     const ContactParameters &contact,
                     const bool               slip,
                     const bool               stick)
    {
      Eigen::VectorXd w = Eigen::VectorXd::Zero(geometry.points.size());
      for (Eigen::Index i = 0; i < w.size(); ++i)
        if ((slip && state.status[i] == ContactStatus::slip) ||
            (stick && state.status[i] == ContactStatus::stick))
          w[i] = is_per_area(contact) ? geometry.areas[i] : 1.;
      return w;
    }
  } // namespace



  ContactStatus
  status_of_face(const ContactParameters &contact)
  {
    if (contact.state == ContactParameters::State::stick)
      return ContactStatus::stick;
    return contact.sliding_speed > 0. || FrictionLaw(contact).at_rest() == 0.
             ? ContactStatus::slip
             : ContactStatus::stick;
  }



  void
  refuse_other_status(const SceneParameters &scene, AffineSystem &system)
  {
    std::vector<ContactStatus> statuses;
    for (const auto &contact : scene.contacts)
      statuses.push_back(status_of_face(contact));
    // Every pencil of the system asks for each of its terms.
    auto &coefficients = system.terms.front().coefficients;
    coefficients = [statuses, own = coefficients](const SceneParameters &s) {
      for (std::size_t i = 0; i < statuses.size(); ++i)
        if (s.contacts[i].state == ContactParameters::State::full &&
            status_of_face(s.contacts[i]) != statuses[i])
          throw InputError(
            "Scene/Contact " + s.contacts[i].name +
            "/Contact state: with 'full' the pair sticks at rest ('Sliding "
            "speed = 0') where it has friction, and is free along the face "
            "elsewhere, and the values of this analysis have both: leave out "
            "the speed or the friction coefficient 0, or set 'Contact state "
            "= preload' with 'Formulation = springs'");
      return own(s);
    };
  }



  NodalShares
  friction_shares(const ContactParameters &contact,
                  const ContactGeometry   &geometry)
  {
    return shares_of_largest(
      [&](const double ratio) { return signed_coefficient(contact, ratio); },
      geometry.speed_ratio);
  }



  void
  add_slip_rate_terms(const SceneParameters &scene,
                      const unsigned int     number,
                      const ContactGeometry &geometry,
                      const ContactState    &state,
                      AffineSystem          &system)
  {
    const auto       &contact = scene.contacts[number];
    const NodalShares mu      = friction_shares(contact, geometry);
    Eigen::VectorXd   force   = Eigen::VectorXd::Zero(geometry.points.size());
    for (Eigen::Index i = 0; i < force.size(); ++i)
      if (state.status[i] == ContactStatus::slip)
        force[i] = state.force_share[i];
    if (force.isZero())
      return;
    const auto unit_of_force =
      [in_newtons = state.in_newtons](const ContactParameters &c) {
        return in_newtons ? 1. : c.normal_force;
      };
    if (contact.transverse_slip_term)
      {
        Eigen::VectorXd w = force;
        for (Eigen::Index i = 0; i < w.size(); ++i)
          w[i] *= mu.share[i] / geometry.speed_ratio[i];
        system.terms.push_back(
          {"transverse slip of " + contact.name,
           std::make_shared<LowRankMatrix>(
             geometry.transverse, w, geometry.transverse),
           [number, mu, unit_of_force](const SceneParameters &s) {
             const auto &c = s.contacts[number];
             return TermCoefficients{
               0.,
               std::abs(signed_coefficient(c, mu.speed_ratio)) *
                 unit_of_force(c) / c.sliding_speed,
               0.};
           },
           true});
      }
    const NodalShares slope = shares_of_largest(
      [&](const double ratio) { return sliding_slope(contact, ratio); },
      geometry.speed_ratio);
    // At rest a coefficient that rises from zero damps slip of any direction.
    std::vector<std::shared_ptr<const Functionals>> directions = {
      geometry.tangential};
    if (!(contact.sliding_speed > 0.))
      directions.push_back(geometry.transverse);
    // Also where it is zero in this scene: sweeps may change that.
    for (const auto &rows : directions)
      system.terms.push_back(
        {"friction slope of " + contact.name,
         std::make_shared<LowRankMatrix>(
           rows, force.cwiseProduct(slope.share), rows),
         [number, slope, unit_of_force](const SceneParameters &s) {
           const auto &c = s.contacts[number];
           return TermCoefficients{
             0., unit_of_force(c) * sliding_slope(c, slope.speed_ratio), 0.};
         },
         true});
  }



  namespace
  {
    void
    add_springs(const SceneParameters &scene,
                const unsigned int     number,
                const ContactGeometry &geometry,
                const ContactState    &state,
                AffineSystem          &system)
    {
      const auto &contact = scene.contacts[number];
      const auto  elastic = [number](const SceneParameters &s, const double k) {
        const auto &c = s.contacts[number];
        return elastic_coefficients(
          s, k, c.stiffness_damping, c.structural_damping);
      };
      system.terms.push_back(
        {"normal contact of " + contact.name,
         std::make_shared<LowRankMatrix>(
           geometry.normal,
           selected_weights(geometry, state, contact, true, true),
           geometry.normal),
         [number, elastic](const SceneParameters &s) {
           return elastic(s, normal_stiffness(s.contacts[number]));
         }});

      const NodalShares     mu = friction_shares(contact, geometry);
      const Eigen::VectorXd slip =
        selected_weights(geometry, state, contact, true, false)
          .cwiseProduct(mu.share);
      if (!slip.isZero())
        system.terms.push_back(
          {"friction of " + contact.name,
           std::make_shared<LowRankMatrix>(
             geometry.tangential, slip, geometry.normal),
           [number, elastic, mu](const SceneParameters &s) {
             const auto &c = s.contacts[number];
             // Friction follows the whole normal force, its damping included.
             return elastic(
               s, signed_coefficient(c, mu.speed_ratio) * normal_stiffness(c));
           },
           true});

      const Eigen::VectorXd stick =
        selected_weights(geometry, state, contact, false, true);
      if (!stick.isZero())
        for (const auto &rows : {geometry.tangential, geometry.transverse})
          system.terms.push_back(
            {"sticking contact of " + contact.name,
             std::make_shared<LowRankMatrix>(rows, stick, rows),
             [number, elastic](const SceneParameters &s) {
               return elastic(s, tangential_stiffness(s.contacts[number]));
             }});
      add_slip_rate_terms(scene, number, geometry, state, system);
    }
  } // namespace



  void
  add_spring_contact(const SceneParameters &scene,
                     const unsigned int     number,
                     const ContactGeometry &geometry,
                     const ContactStates   &states,
                     AffineSystem          &system)
  {
    for (std::size_t k = 0; k < states.size(); ++k)
      {
        const std::size_t first = system.terms.size();
        add_springs(scene, number, geometry, states[k], system);
        for (std::size_t i = first; i < system.terms.size(); ++i)
          system.terms[i].coefficients =
            where_state(number, k, states.size(), system.terms[i].coefficients);
      }
  }
} // namespace squeal
