// SPDX-License-Identifier: LGPL-2.1-or-later

// Puts the bodies and every contact pair of a scene together.

#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/contact/contact_faces.h>
#include <squeal/contact/contact_terms.h>
#include <squeal/contact/elimination.h>
#include <squeal/contact/friction_law.h>
#include <squeal/contact/mortar.h>

#include <map>

namespace squeal
{
  namespace
  {
    /** The nodes of a mortar pair that slip: the sliding there, and what takes
     * the normal force out of the forces on the source nodes. */
    struct MortarContact
    {
      unsigned int                  number;
      std::vector<Functionals::Row> tangential;  /**< times shares of mu */
      std::vector<Functionals::Row> normal;      /**< of forces */
      double                        speed_ratio; /**< where mu is largest */
    };

    /** All components of every source node follow the target. */
    void
    append_tie(const MortarCoupling &coupling,
               const std::string    &name,
               DependentUnknowns    &dependent)
    {
      for (std::size_t j = 0; j < coupling.nodes.size(); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          if (coupling.source_rows[j][c] != -1u)
            {
              dependent.rows.push_back(coupling.source_rows[j][c]);
              dependent.combinations.push_back(coupling.target_rows[j][c]);
              dependent.owners.push_back(name);
            }
    }

    /** Free component of a source node that is largest in the normal, or -1u
     * if the node is held along all of it. */
    unsigned int
    component_along(const dealii::Tensor<1, 3>        &normal,
                    const std::array<unsigned int, 3> &rows)
    {
      unsigned int best = -1u;
      for (unsigned int c = 0; c < 3; ++c)
        if (rows[c] != -1u && normal[c] != 0. &&
            (best == -1u || std::abs(normal[c]) > std::abs(normal[best])))
          best = c;
      return best;
    }

    /** The force along the normal on a source node, as a functional of the
     * forces on it. What the support of a held component takes is unknown. */
    Functionals::Row
    normal_force(const ContactParameters           &contact,
                 const dealii::Point<3>            &node,
                 const dealii::Tensor<1, 3>        &normal,
                 const std::array<unsigned int, 3> &rows)
    {
      Functionals::Row row;
      for (unsigned int c = 0; c < 3; ++c)
        if (normal[c] != 0.)
          {
            if (rows[c] == -1u)
              throw InputError(
                "contact " + contact.name + ": the source node at (" +
                rounded_text(node[0], 4) + ", " + rounded_text(node[1], 4) +
                ", " + rounded_text(node[2], 4) +
                ") m is held by a support along an axis that is neither along "
                "the contact normal nor across it: friction there is unknown; "
                "set 'Formulation = springs'");
            row.emplace_back(rows[c], normal[c]);
          }
      return row;
    }

    /** Refuses a closed node that supports hold along the contact where the
     * target can move: it would have to hold the target. */
    void
    require_held_target(const ContactParameters &contact,
                        const dealii::Point<3>  &node,
                        const Functionals::Row  &target)
    {
      if (!target.empty())
        throw InputError(
          "contact " + contact.name + ": the source node at (" +
          rounded_text(node[0], 4) + ", " + rounded_text(node[1], 4) + ", " +
          rounded_text(node[2], 4) +
          ") m is held by a support along the contact, and would hold the "
          "target; exchange source and target, or set 'Formulation = springs'");
    }

    /** Closed nodes follow the target along the normal, sticking ones in every
     * direction; the multipliers of slipping ones make friction. */
    MortarContact
    append_contact(const MortarCoupling    &coupling,
                   const ContactGeometry   &geometry,
                   const ContactParameters &contact,
                   const ContactState      &state,
                   const NodalShares       &friction,
                   const unsigned int       number,
                   DependentUnknowns       &dependent)
    {
      MortarContact result{number, {}, {}, friction.speed_ratio};
      for (std::size_t j = 0; j < coupling.nodes.size(); ++j)
        {
          const auto &rows = coupling.source_rows[j];
          if (state.status[j] == ContactStatus::stick)
            for (unsigned int c = 0; c < 3; ++c)
              {
                if (rows[c] == -1u)
                  {
                    require_held_target(
                      contact, coupling.nodes[j], coupling.target_rows[j][c]);
                    continue;
                  }
                dependent.rows.push_back(rows[c]);
                dependent.combinations.push_back(coupling.target_rows[j][c]);
              }
          if (state.status[j] != ContactStatus::slip)
            continue;
          const auto        &n = geometry.frames[j].normal;
          const unsigned int c = component_along(n, rows);
          if (c == -1u)
            {
              for (unsigned int k = 0; k < 3; ++k)
                if (n[k] != 0.)
                  require_held_target(
                    contact, coupling.nodes[j], coupling.target_rows[j][k]);
              continue;
            }
          // n . (u_target - u_source) = 0, solved for component c.
          std::vector<std::pair<double, const Functionals::Row *>> parts;
          for (unsigned int k = 0; k < 3; ++k)
            if (n[k] != 0.)
              {
                parts.emplace_back(n[k] / n[c], &coupling.target_rows[j][k]);
                if (k != c)
                  parts.emplace_back(-n[k] / n[c], &geometry.source_rows[j][k]);
              }
          dependent.rows.push_back(rows[c]);
          dependent.combinations.push_back(combine(parts));
          result.normal.push_back(
            normal_force(contact, coupling.nodes[j], n, rows));
          result.tangential.push_back(geometry.tangential->rows()[j]);
          for (auto &[column, weight] : result.tangential.back())
            weight *= friction.share[j];
        }
      dependent.owners.resize(dependent.rows.size(), "contact " + contact.name);
      return result;
    }

    /** Contact geometry of a mortar pair: its nodes. */
    ContactGeometry
    nodal_geometry(const Discretization    &d,
                   const ContactParameters &contact,
                   const MortarCoupling    &coupling)
    {
      ContactGeometry g;
      g.points      = coupling.nodes;
      g.areas       = coupling.weights;
      g.quads       = coupling.quads;
      g.target_rows = coupling.target_rows;
      for (const auto &rows : coupling.source_rows)
        {
          g.source_rows.emplace_back();
          for (unsigned int c = 0; c < 3; ++c)
            if (rows[c] != -1u)
              g.source_rows.back()[c] = {{rows[c], 1.}};
        }
      set_frames(d, contact, coupling.normals, g);
      return g;
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
           term.coefficients,
           term.is_friction});
      for (const auto &contact : mortar_contacts)
        {
          const auto tangential = elimination->reduce(
            Functionals(result.system.space, contact.tangential));
          const Functionals  normal(result.system.space, contact.normal);
          const unsigned int number = contact.number;
          for (const auto &term : result.system.terms)
            reduced.terms.push_back(
              {"friction by " + term.name,
               std::make_shared<MultiplierFriction>(
                 *term.matrix, *elimination, tangential, normal),
               [number, ratio = contact.speed_ratio, c = term.coefficients](
                 const SceneParameters &s) {
                 const double mu =
                   signed_coefficient(s.contacts[number], ratio);
                 TermCoefficients value = c(s);
                 value.mass *= mu;
                 value.damping *= mu;
                 value.stiffness *= mu;
                 return value;
               },
               true});
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
            append_tie(make_tie_coupling(d, evaluator, i),
                       "tie " + scene.ties[i].name,
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

    /** Friction is recovered from all forces along the normal on a source node:
     * no other pair, and no tie, may push or pull it that way. */
    void
    require_known_friction(const SceneParameters            &scene,
                           const DependentUnknowns          &dependent,
                           const std::vector<MortarContact> &mortar_contacts)
    {
      // Who pushes which unknown.
      std::multimap<unsigned int, std::string> pushed;
      for (std::size_t k = 0; k < dependent.rows.size(); ++k)
        {
          pushed.emplace(dependent.rows[k], dependent.owners[k]);
          for (const auto &[row, weight] : dependent.combinations[k])
            pushed.emplace(row, dependent.owners[k]);
        }
      const auto name_of = [&](const MortarContact &contact) {
        return "contact " + scene.contacts[contact.number].name;
      };
      const auto rubs = [&](const MortarContact &contact) {
        return !FrictionLaw(scene.contacts[contact.number]).is_frictionless();
      };
      for (const MortarContact &contact : mortar_contacts)
        if (rubs(contact))
          for (const auto &functional : contact.tangential)
            for (const auto &[row, weight] : functional)
              pushed.emplace(row, name_of(contact));
      for (const MortarContact &contact : mortar_contacts)
        if (rubs(contact))
          for (const auto &functional : contact.normal)
            for (const auto &[row, weight] : functional)
              for (auto [i, end] = pushed.equal_range(row); i != end; ++i)
                if (i->second != name_of(contact))
                  throw InputError(
                    "Scene: " + name_of(contact) + " and " + i->second +
                    " push one node of the source face of the former along "
                    "its normal: friction there is unknown; part the faces, or "
                    "set 'Formulation = springs'");
    }

    [[noreturn]] void
    refuse_common_node(const std::string &a,
                       const std::string &b,
                       const std::string &how)
    {
      throw InputError("Scene: " + a + " and " + b +
                       " have a node in common, " + how +
                       ": part the faces, exchange source and target of one "
                       "of them, or set 'Formulation = springs'");
    }

    /** A source node follows one target only, and that target none. */
    void
    require_independent(const DependentUnknowns &dependent)
    {
      std::map<unsigned int, std::string> owner;
      for (std::size_t k = 0; k < dependent.rows.size(); ++k)
        if (const auto [it, is_new] =
              owner.emplace(dependent.rows[k], dependent.owners[k]);
            !is_new)
          refuse_common_node(
            it->second, dependent.owners[k], "on the source face of both");
      for (std::size_t k = 0; k < dependent.rows.size(); ++k)
        for (const auto &[row, weight] : dependent.combinations[k])
          if (const auto it = owner.find(row);
              it != owner.end() && it->second != dependent.owners[k])
            refuse_common_node(
              it->second,
              dependent.owners[k],
              "on the source face of the one and the target face of the "
              "other");
    }

    /** A source node that a tie holds along the normal follows the tie's target
     * and has no motion of its own that a contact could act on. */
    void
    require_free_source_nodes(const SceneParameters              &scene,
                              const std::vector<ContactGeometry> &geometries,
                              const DependentUnknowns            &tied)
    {
      std::map<unsigned int, std::string> owner;
      for (std::size_t k = 0; k < tied.rows.size(); ++k)
        owner.emplace(tied.rows[k], tied.owners[k]);
      for (std::size_t i = 0; i < scene.contacts.size(); ++i)
        if (scene.contacts[i].formulation !=
            ContactParameters::Formulation::springs)
          for (std::size_t j = 0; j < geometries[i].points.size(); ++j)
            for (unsigned int c = 0; c < 3; ++c)
              if (std::abs(geometries[i].frames[j].normal[c]) > .5)
                for (const auto &[row, weight] :
                     geometries[i].source_rows[j][c])
                  if (const auto it = owner.find(row); it != owner.end())
                    refuse_common_node(it->second,
                                       "contact " + scene.contacts[i].name,
                                       "on the source face of both");
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



  std::vector<MortarCoupling>
  contact_couplings(const Discretization &d)
  {
    const PointEvaluator        evaluator(d);
    std::vector<MortarCoupling> result;
    for (const auto &contact : d.scene().contacts)
      result.push_back(contact.formulation ==
                           ContactParameters::Formulation::springs
                         ? MortarCoupling()
                         : coupling_of(d, evaluator, contact));
    return result;
  }



  LinearizedSystem
  linearized_system(const Discretization              &d,
                    const std::vector<BodyMatrices>   &bodies,
                    const std::vector<ContactStates>  &given,
                    const std::vector<MortarCoupling> *couplings)
  {
    check_contact_faces(d);
    const std::vector<MortarCoupling> made =
      couplings ? std::vector<MortarCoupling>() : contact_couplings(d);
    const auto                &scene = d.scene();
    const PointEvaluator       evaluator(d);
    LinearizedSystem           result    = bodies_alone(d, bodies);
    DependentUnknowns          dependent = tied_unknowns(d, evaluator);
    std::vector<MortarContact> mortar_contacts;
    const auto                 is_given = [&](const unsigned int i) {
      return i < given.size() && !given[i].empty();
    };
    for (unsigned int i = 0; i < scene.contacts.size(); ++i)
      {
        const auto         &contact = scene.contacts[i];
        const ContactStatus status  = status_of_face(contact);
        if (contact.formulation == ContactParameters::Formulation::springs)
          {
            ContactGeometry g = make_contact_geometry(d, evaluator, contact);
            const ContactStates states =
              is_given(i) ? given[i] : ContactStates{uniform_state(g, status)};
            add_spring_contact(scene, i, g, states, result.system);
            result.contacts.push_back(std::move(g));
            result.states.push_back(states.front());
            continue;
          }
        const MortarCoupling &coupling = (couplings ? *couplings : made)[i];
        ContactGeometry       g        = nodal_geometry(d, contact, coupling);
        if (is_given(i) && given[i].size() > 1)
          throw InputError("Scene/Contact " + contact.name +
                           ": contact states that change over a sweep need "
                           "'Formulation = springs'");
        ContactState state =
          is_given(i) ? given[i].front() : uniform_state(g, status);
        AssertDimension(state.status.size(), g.points.size());
        const MortarContact pair = append_contact(coupling,
                                                  g,
                                                  contact,
                                                  state,
                                                  friction_shares(contact, g),
                                                  i,
                                                  dependent);
        if (!pair.normal.empty())
          mortar_contacts.push_back(pair);
        add_slip_rate_terms(scene, i, g, state, result.system);
        result.contacts.push_back(std::move(g));
        result.states.push_back(std::move(state));
      }
    require_independent(dependent);
    require_known_friction(scene, dependent, mortar_contacts);
    if (!dependent.rows.empty())
      eliminate(result, dependent, mortar_contacts);
    refuse_other_status(scene, result.system);
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
    require_independent(dependent);
    require_free_source_nodes(d.scene(), result.contacts, dependent);
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
