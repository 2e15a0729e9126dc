// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/sum_operator.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/contact/imported_geometry.h>
#include <squeal/model/imported_system.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    using Role = MatrixPartParameters::Role;

    /** What part @p i, read as @p matrix, counts in M, C and K. */
    TermCoefficients
    coefficients_of(const SceneParameters         &s,
                    const unsigned int             i,
                    const bool                     is_damping,
                    const ImportedMatrix::Symmetry symmetry)
    {
      const double f = s.matrix_parts[i].factor;
      const bool   whole =
        s.damping.model == DampingParameters::Model::whole_model;
      switch (s.matrix_parts[i].role)
        {
        case Role::mass:
          return {f, whole ? s.damping.mass_damping * f : 0., 0.};
        case Role::damping:
          return {0., f, 0.};
        case Role::stiffness:
        case Role::normal_contact:
          return elastic_coefficients(s, f, 0., 0.);
        case Role::friction:
          // Where the target turns backwards, what friction adds to the damping
          // of the sliding is the same: |mu|. What couples it to the normal
          // motion changes its sign.
          if (is_damping)
            return {0.,
                    f * (symmetry == ImportedMatrix::Symmetry::symmetric
                           ? std::abs(s.friction_coefficient)
                           : s.friction_coefficient),
                    0.};
          return elastic_coefficients(s, f * s.friction_coefficient, 0., 0.);
        case Role::circulatory:
          // No material: what damping there is has been counted.
          return {0., 0., f};
        }
      unknown_choice("role");
    }

    std::shared_ptr<const LinearOperator>
    operator_of(const ImportedMatrix                  &part,
                const std::shared_ptr<const RowSpace> &rows)
    {
      const auto symmetric =
        std::make_shared<const SparseMatrix>(rows, lower_symmetric_part(part));
      const bool is_symmetric =
        part.symmetry == ImportedMatrix::Symmetry::symmetric;
      if (is_symmetric && part.role != Role::friction &&
          part.role != Role::circulatory)
        return symmetric;
      // One non-symmetric operator: the undamped, frictionless problem must
      // not take in its symmetric half. Friction that is given as K(mu) - K(0)
      // has a part, K(0), that is nothing else.
      const auto skew = std::make_shared<const SparseMatrix>(
        rows,
        is_symmetric ? Triplets() : lower_skew_part(part),
        SparseMatrix::Symmetry::skew);
      return std::make_shared<SumOperator>(
        std::vector<SumOperator::Part>{{1., symmetric}, {1., skew}});
    }

    /** The point pairs of a scene that names no contacts. */
    void
    add_pattern(const ImportedContact &contact, AffineSystem &system)
    {
      const auto normal =
        std::make_shared<const Functionals>(system.space, contact.normal);
      const auto sliding =
        std::make_shared<const Functionals>(system.space, contact.sliding);
      const Eigen::VectorXd weights = Eigen::Map<const Eigen::VectorXd>(
        contact.stiffness_factors.data(), contact.stiffness_factors.size());
      system.terms.push_back(
        {"normal contact",
         std::make_shared<LowRankMatrix>(normal, weights, normal),
         [](const SceneParameters &s) {
           return elastic_coefficients(s, s.contact_normal_stiffness, 0., 0.);
         }});
      system.terms.push_back(
        {"friction",
         std::make_shared<LowRankMatrix>(sliding, weights, normal),
         [](const SceneParameters &s) {
           return elastic_coefficients(
             s, s.friction_coefficient * s.contact_normal_stiffness, 0., 0.);
         },
         true});
    }
  } // namespace



  LinearizedSystem
  imported_parts(const ImportedModel &model)
  {
    LinearizedSystem result;
    result.system.space    = std::make_shared<const RowSpace>(model.n_dofs);
    result.expand          = [](const Block &v) { return v; };
    result.restrict_forces = result.expand;
    for (unsigned int i = 0; i < model.parts.size(); ++i)
      {
        const auto  matrix = operator_of(model.parts[i], result.system.space);
        const auto &part   = model.parts[i];
        result.system.terms.push_back(
          {part.name,
           matrix,
           [i, is_damping = part.is_damping, symmetry = part.symmetry](
             const SceneParameters &s) {
             return coefficients_of(s, i, is_damping, symmetry);
           },
           part.role == Role::friction});
      }
    return result;
  }



  namespace
  {
    /** @p factor: of a part by its number. */
    template <typename Factor>
    std::shared_ptr<const LinearOperator>
    sum_of_masses(const ImportedModel &model, const Factor &factor)
    {
      const auto rows = std::make_shared<const RowSpace>(model.n_dofs);
      std::vector<SumOperator::Part> masses;
      for (unsigned int i = 0; i < model.parts.size(); ++i)
        if (model.parts[i].role == Role::mass)
          masses.emplace_back(factor(i),
                              std::make_shared<const SparseMatrix>(
                                rows, lower_symmetric_part(model.parts[i])));
      return std::make_shared<SumOperator>(std::move(masses));
    }
  } // namespace

  std::shared_ptr<const LinearOperator>
  imported_mass(const ImportedModel &model)
  {
    return sum_of_masses(
      model, [&](const unsigned int i) { return model.parts[i].factor; });
  }

  std::shared_ptr<const LinearOperator>
  imported_mass(const ImportedModel &model, const SceneParameters &scene)
  {
    return sum_of_masses(model, [&](const unsigned int i) {
      return scene.matrix_parts[i].factor;
    });
  }



  Block
  translations(const ImportedModel &model, const std::string &body)
  {
    Block result = Block::Zero(model.n_dofs, 3);
    if (model.labels.empty())
      return result;
    for (unsigned int i = 0; i < model.n_dofs; ++i)
      if (const unsigned int c = model.labels[i].component;
          c >= 1 && c <= 3 &&
          (body.empty() || model.bodies[model.body_of[i]] == body))
        result(i, c - 1) = 1.;
    return result;
  }



  void
  add_imported_contact(const SceneParameters            &scene,
                       const ImportedModel              &model,
                       const std::vector<ContactStates> &states,
                       LinearizedSystem                 &system)
  {
    if (!model.contact.pairs.empty())
      add_pattern(model.contact, system.system);
    for (unsigned int i = 0; i < model.contacts.size(); ++i)
      {
        ContactGeometry g =
          imported_geometry(system.system.space, model.contacts[i]);
        const ContactStates all = i < states.size() && !states[i].empty()
                                    ? states[i]
                                    : ContactStates{uniform_state(
                                        g, status_of_face(scene.contacts[i]))};
        add_spring_contact(scene, i, g, all, system.system);
        system.contacts.push_back(std::move(g));
        system.states.push_back(all.front());
      }
    if (!model.contacts.empty())
      refuse_other_status(scene, system.system);
  }



  void
  add_open_contacts(const ImportedModel &model, LinearizedSystem &system)
  {
    for (const ImportedContact &contact : model.contacts)
      {
        system.contacts.push_back(
          imported_geometry(system.system.space, contact));
        system.states.push_back(
          uniform_state(system.contacts.back(), ContactStatus::open));
      }
  }
} // namespace squeal
