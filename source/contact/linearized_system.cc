// SPDX-License-Identifier: LGPL-2.1-or-later

// Puts the bodies and every contact pair of a scene together.

#include <squeal/base/exceptions.h>
#include <squeal/contact/contact_faces.h>
#include <squeal/contact/contact_terms.h>
#include <squeal/contact/elimination.h>
#include <squeal/contact/mortar.h>

#include <numeric>

namespace squeal
{
  namespace
  {
    bool
    slips(const ContactParameters &contact)
    {
      return contact.state == ContactParameters::State::full;
    }

    /** Mortar pair of a contact, and which functional of the relative sliding
     * belongs to each dependent unknown. */
    struct MortarContact
    {
      unsigned int                  number;
      std::vector<unsigned int>     dependent;   /**< numbers in the list */
      std::vector<Functionals::Row> tangential;  /**< times shares of mu */
      double                        speed_ratio; /**< where mu is largest */
    };

    /** All components of every source node follow the target. */
    void
    append_tie(const MortarCoupling &coupling, DependentUnknowns &dependent)
    {
      for (std::size_t j = 0; j < coupling.nodes.size(); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          if (coupling.source_rows[j][c] != -1u)
            {
              dependent.rows.push_back(coupling.source_rows[j][c]);
              dependent.combinations.push_back(coupling.target_rows[j][c]);
            }
    }

    /** Closed nodes follow the target along z, sticking ones in every
     * direction; the multipliers of slipping ones make friction. */
    MortarContact
    append_contact(const MortarCoupling  &coupling,
                   const ContactGeometry &geometry,
                   const ContactState    &state,
                   const NodalShares     &friction,
                   const unsigned int     number,
                   DependentUnknowns     &dependent)
    {
      MortarContact contact{number, {}, {}, friction.speed_ratio};
      for (std::size_t j = 0; j < coupling.nodes.size(); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const bool follows =
              state.status[j] == ContactStatus::stick ||
              (state.status[j] == ContactStatus::slip && c == 2);
            if (!follows || coupling.source_rows[j][c] == -1u)
              continue;
            if (state.status[j] == ContactStatus::slip)
              {
                contact.dependent.push_back(dependent.rows.size());
                contact.tangential.push_back(geometry.tangential->rows()[j]);
                for (auto &[column, weight] : contact.tangential.back())
                  weight *= friction.share[j];
              }
            dependent.rows.push_back(coupling.source_rows[j][c]);
            dependent.combinations.push_back(coupling.target_rows[j][c]);
          }
      return contact;
    }

    /** Contact geometry of a mortar pair: its nodes. */
    ContactGeometry
    nodal_geometry(const Discretization    &d,
                   const ContactParameters &contact,
                   const MortarCoupling    &coupling)
    {
      ContactGeometry g;
      g.points = coupling.nodes;
      g.areas  = coupling.weights;
      slip_directions(
        d.scene(), contact, g.points, g.slip_direction, g.speed_ratio);
      std::vector<Functionals::Row> normal, tangential, transverse;
      for (std::size_t j = 0; j < g.points.size(); ++j)
        {
          std::array<Functionals::Row, 3> source;
          for (unsigned int c = 0; c < 3; ++c)
            if (coupling.source_rows[j][c] != -1u)
              source[c] = {{coupling.source_rows[j][c], 1.}};
          const auto &t        = coupling.target_rows[j];
          const auto &[tx, ty] = g.slip_direction[j];
          normal.push_back(combine({{1., &t[2]}, {-1., &source[2]}}));
          tangential.push_back(combine(
            {{tx, &t[0]}, {ty, &t[1]}, {-tx, &source[0]}, {-ty, &source[1]}}));
          transverse.push_back(combine(
            {{ty, &t[0]}, {-tx, &t[1]}, {-ty, &source[0]}, {tx, &source[1]}}));
          g.source_rows.push_back(source);
          g.target_rows.push_back(t);
        }
      g.normal = std::make_shared<Functionals>(d.space(), std::move(normal));
      g.tangential =
        std::make_shared<Functionals>(d.space(), std::move(tangential));
      g.transverse =
        std::make_shared<Functionals>(d.space(), std::move(transverse));
      return g;
    }

    /** Shares proportional to the tributary areas: an even pressure. */
    ContactState
    even_pressure(const ContactGeometry &g, const ContactStatus status)
    {
      ContactState state = uniform_state(g, status);
      const double total = std::accumulate(g.areas.begin(), g.areas.end(), 0.);
      for (std::size_t j = 0; j < g.areas.size(); ++j)
        state.force_share[j] = g.areas[j] / total;
      return state;
    }

    unsigned int
    target_of(const SceneParameters &scene, const ContactParameters &contact)
    {
      return contact.target_body == "ground"
               ? -1u
               : body_index(scene, contact.target_body);
    }



    std::shared_ptr<const Elimination>
    eliminate(LinearizedSystem                 &result,
              const DependentUnknowns          &dependent,
              const std::vector<MortarContact> &mortar_contacts)
    {
      const auto elimination =
        std::make_shared<const Elimination>(result.system.space, dependent);
      AffineSystem reduced;
      reduced.space = elimination->reduced_space();
      for (const auto &term : result.system.terms)
        reduced.terms.push_back(
          {term.name,
           std::make_shared<EliminatedOperator>(term.matrix, elimination),
           term.coefficients});
      for (const auto &contact : mortar_contacts)
        {
          // One functional for every dependent unknown: those of other pairs
          // carry none.
          std::vector<Functionals::Row> rows(dependent.rows.size());
          for (std::size_t k = 0; k < contact.dependent.size(); ++k)
            rows[contact.dependent[k]] = contact.tangential[k];
          const auto tangential = std::make_shared<const Functionals>(
            result.system.space, std::move(rows));
          const unsigned int number = contact.number;
          for (const auto &term : result.system.terms)
            reduced.terms.push_back(
              {"friction by " + term.name,
               std::make_shared<MultiplierFriction>(
                 term.matrix, elimination, tangential),
               [number, ratio = contact.speed_ratio, c = term.coefficients](
                 const SceneParameters &s) {
                 const double mu =
                   signed_coefficient(s.contacts[number], ratio);
                 TermCoefficients value = c(s);
                 value.mass *= mu;
                 value.damping *= mu;
                 value.stiffness *= mu;
                 return value;
               }});
        }
      result.system = std::move(reduced);
      result.expand = [elimination](const Block &v) {
        return elimination->expand(v);
      };
      result.restrict_forces = [elimination](const Block &f) {
        return elimination->restrict_forces(f);
      };
      result.reduce = [elimination](const Functionals &functionals) {
        return elimination->reduce(functionals);
      };
      return elimination;
    }

    /** Dependent unknowns of the ties that are not conforming. */
    DependentUnknowns
    tied_unknowns(const Discretization &d, const PointEvaluator &evaluator)
    {
      const auto       &scene = d.scene();
      DependentUnknowns dependent;
      for (unsigned int i = 0; i < scene.ties.size(); ++i)
        if (!d.coarse_mesh().tie_is_conforming[i])
          {
            const auto &tie = scene.ties[i];
            append_tie(make_mortar_coupling(d,
                                            evaluator,
                                            face_id(d.coarse_mesh(),
                                                    scene,
                                                    tie.source_body,
                                                    tie.source_face),
                                            body_index(scene, tie.target_body),
                                            "Scene/Tie " + tie.name),
                       dependent);
          }
      return dependent;
    }

    MortarCoupling
    coupling_of(const Discretization    &d,
                const PointEvaluator    &evaluator,
                const ContactParameters &contact)
    {
      const unsigned int face = face_id(
        d.coarse_mesh(), d.scene(), contact.source_body, contact.source_face);
      const unsigned int target = target_of(d.scene(), contact);
      const std::string  where  = "Scene/Contact " + contact.name;
      return contact.formulation ==
                 ContactParameters::Formulation::node_to_surface
               ? make_node_coupling(d, evaluator, face, target, where)
               : make_mortar_coupling(d, evaluator, face, target, where);
    }

    LinearizedSystem
    bodies_alone(const Discretization            &d,
                 const std::vector<BodyMatrices> &bodies)
    {
      LinearizedSystem result;
      result.system = body_system(d, bodies);
      result.expand = result.restrict_forces = [](const Block &v) { return v; };
      return result;
    }
  } // namespace



  LinearizedSystem
  linearized_system(const Discretization             &d,
                    const std::vector<BodyMatrices>  &bodies,
                    const std::vector<ContactStates> &given)
  {
    check_contact_faces(d);
    const auto                &scene = d.scene();
    const PointEvaluator       evaluator(d);
    LinearizedSystem           result    = bodies_alone(d, bodies);
    DependentUnknowns          dependent = tied_unknowns(d, evaluator);
    std::vector<MortarContact> mortar_contacts;
    for (unsigned int i = 0; i < scene.contacts.size(); ++i)
      {
        const auto         &contact = scene.contacts[i];
        const ContactStatus status =
          slips(contact) ? ContactStatus::slip : ContactStatus::stick;
        if (contact.formulation == ContactParameters::Formulation::springs)
          {
            ContactGeometry g = make_contact_geometry(d, evaluator, contact);
            const ContactStates states =
              given.empty() ? ContactStates{uniform_state(g, status)}
                            : given[i];
            add_spring_contact(d, i, g, states, result.system);
            result.contacts.push_back(std::move(g));
            result.states.push_back(states.front());
            continue;
          }
        const MortarCoupling coupling = coupling_of(d, evaluator, contact);
        ContactGeometry      g        = nodal_geometry(d, contact, coupling);
        if (!given.empty() && given[i].size() > 1)
          throw InputError("Scene/Contact " + contact.name +
                           ": contact states that change over a sweep need "
                           "'Formulation = springs'");
        ContactState state =
          given.empty() ? even_pressure(g, status) : given[i].front();
        AssertDimension(state.status.size(), g.points.size());
        const MortarContact pair = append_contact(
          coupling, g, state, friction_shares(contact, g), i, dependent);
        if (!pair.dependent.empty())
          mortar_contacts.push_back(pair);
        add_slip_rate_terms(d, i, g, state, result.system);
        result.contacts.push_back(std::move(g));
        result.states.push_back(std::move(state));
      }
    if (!dependent.rows.empty())
      eliminate(result, dependent, mortar_contacts);
    return result;
  }



  LinearizedSystem
  separated_system(const Discretization            &d,
                   const std::vector<BodyMatrices> &bodies)
  {
    check_contact_faces(d);
    const PointEvaluator evaluator(d);
    LinearizedSystem     result = bodies_alone(d, bodies);
    for (const auto &contact : d.scene().contacts)
      result.contacts.push_back(
        contact.formulation == ContactParameters::Formulation::springs
          ? make_contact_geometry(d, evaluator, contact)
          : nodal_geometry(d, contact, coupling_of(d, evaluator, contact)));
    const DependentUnknowns dependent = tied_unknowns(d, evaluator);
    if (!dependent.rows.empty())
      {
        const auto elimination = eliminate(result, dependent, {});
        for (auto &g : result.contacts)
          for (auto *rows : {&g.normal, &g.tangential, &g.transverse})
            *rows = elimination->reduce(**rows);
      }
    for (const auto &g : result.contacts)
      result.states.push_back(uniform_state(g, ContactStatus::open));
    return result;
  }
} // namespace squeal
