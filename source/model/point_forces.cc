// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/friction_law.h>
#include <squeal/contact/mortar.h>
#include <squeal/contact/spring_stiffness.h>
#include <squeal/discretization/element_matrices.h>
#include <squeal/discretization/face_quadrature.h>
#include <squeal/discretization/face_tractions.h>
#include <squeal/discretization/point_evaluator.h>
#include <squeal/model/point_forces.h>

#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    using Formulation = ContactParameters::Formulation;

    constexpr double alone = std::numeric_limits<double>::infinity();

    /** The same points on the second body, which feels the opposite force. */
    void
    append_both(const unsigned int                   body,
                const int                            other,
                const std::vector<dealii::Point<3>> &points,
                const Eigen::MatrixXd               &forces,
                const double                         spacing,
                std::vector<PointForces>            &result)
    {
      result.push_back({body, points, forces, spacing});
      if (other >= 0)
        result.push_back(
          {static_cast<unsigned int>(other), points, -forces, spacing});
    }

    /** Number of a body, or -1 for the ground. */
    int
    body_or_ground(const SceneParameters &scene, const std::string &name)
    {
      return name == "ground" ? -1 : static_cast<int>(body_index(scene, name));
    }



    /** Forces of the springs of contact pair @p i on its source: three rows a
     * point. n . (u_d - u_p) > 0 pushes the source along n. */
    Eigen::MatrixXd
    contact_forces(const Model         &model,
                   const unsigned int   i,
                   const Block         &full,
                   const FrictionForces friction)
    {
      const auto            &contact = model.parameters().scene.contacts[i];
      const ContactGeometry &g       = model.linearized().contacts[i];
      const auto            &status  = model.linearized().states[i].status;
      const Eigen::MatrixXd  normal  = g.normal->apply(full),
                            along    = g.tangential->apply(full),
                            across   = g.transverse->apply(full);
      Eigen::MatrixXd forces =
        Eigen::MatrixXd::Zero(3 * g.points.size(), full.cols());
      for (std::size_t p = 0; p < g.points.size(); ++p)
        {
          if (status[p] == ContactStatus::open)
            continue;
          const ContactFrame &frame = g.frames[p];
          const double        area  = is_per_area(contact) ? g.areas[p] : 1.,
                       k_n          = area * normal_stiffness(contact),
                       k_t          = area * tangential_stiffness(contact);
          const bool         sticks = status[p] == ContactStatus::stick;
          Eigen::RowVectorXd f_n    = k_n * normal.row(p), f_t, f_s;
          f_t = f_s = Eigen::RowVectorXd::Zero(full.cols());
          if (sticks)
            {
              f_t = k_t * along.row(p);
              f_s = k_t * across.row(p);
            }
          else if (friction != FrictionForces::none)
            {
              const double mu = signed_coefficient(contact, g.speed_ratio[p]);
              if (friction == FrictionForces::sliding)
                f_t = mu * f_n;
              else
                f_n += k_n * mu * along.row(p);
            }
          for (unsigned int c = 0; c < 3; ++c)
            forces.row(3 * p + c) = frame.normal[c] * f_n +
                                    frame.sliding[c] * f_t +
                                    frame.transverse[c] * f_s;
        }
      return forces;
    }



    /** Where springs are attached, the weight of each and their distance. */
    struct Attachment
    {
      std::vector<dealii::Point<3>> points;
      std::vector<double>           weights;
      double                        spacing;
    };

    Attachment
    attachment_of(const Discretization &d, const SpringParameters &spring)
    {
      if (spring.kind == SpringParameters::Kind::area)
        {
          const FaceQuadrature face = face_quadrature(
            d, face_id(d.coarse_mesh(), d.scene(), spring.body, spring.face));
          return {face.points, face.areas, 0.};
        }
      const auto points = spring_points(spring);
      return {points,
              std::vector<double>(points.size(), 1.),
              spring.number > 1
                ? points.front().distance(points.back()) / (spring.number - 1)
                : alone};
    }

    void
    append_spring_forces(const Discretization     &d,
                         const SpringParameters   &spring,
                         const Block              &full,
                         std::vector<PointForces> &result)
    {
      const PointEvaluator evaluator(d);
      const Attachment     at    = attachment_of(d, spring);
      const unsigned int   body  = body_index(d.scene(), spring.body);
      const int            other = body_or_ground(d.scene(), spring.other_body);
      const auto rows = evaluator.displacements(body, at.points, 1e-4).rows;
      const auto other_rows =
        evaluator.displacements(other < 0 ? body : other, at.points, 1e-4).rows;
      Eigen::Matrix3d K = Eigen::Matrix3d::Zero();
      for (unsigned int c = 0; c < 3; ++c)
        {
          K(c, c) += spring.stiffnesses[c];
          for (unsigned int k = 0; k < 3; ++k)
            K(c, k) +=
              spring.stiffness * spring.direction[c] * spring.direction[k];
        }
      std::vector<Functionals::Row> motion;
      for (std::size_t p = 0; p < at.points.size(); ++p)
        for (unsigned int c = 0; c < 3; ++c)
          motion.push_back(
            other < 0 ? rows[p][c]
                      : combine({{1., &rows[p][c]}, {-1., &other_rows[p][c]}}));
      Eigen::MatrixXd forces =
        Functionals(d.space(), std::move(motion)).apply(full);
      for (std::size_t p = 0; p < at.points.size(); ++p)
        forces.middleRows(3 * p, 3) =
          (-at.weights[p] * K * forces.middleRows(3 * p, 3)).eval();
      append_both(body, other, at.points, forces, at.spacing, result);
    }
  } // namespace



  std::vector<PointForces>
  spring_forces(const Model         &model,
                const Block         &full,
                const FrictionForces friction)
  {
    const auto              &scene = model.parameters().scene;
    const auto              &d     = *model.discretization();
    std::vector<PointForces> result;
    for (unsigned int i = 0; i < scene.contacts.size(); ++i)
      {
        const auto &contact = scene.contacts[i];
        if (contact.formulation != Formulation::springs)
          continue;
        const auto  &g       = model.linearized().contacts[i];
        const double spacing = is_per_area(contact)  ? 0.
                               : g.points.size() > 1 ? std::sqrt(g.areas[0])
                                                     : alone;
        append_both(body_index(scene, contact.source_body),
                    body_or_ground(scene, contact.target_body),
                    g.points,
                    contact_forces(model, i, full, friction),
                    spacing,
                    result);
      }
    for (const auto &spring : scene.springs)
      append_spring_forces(d, spring, full, result);
    return result;
  }



  namespace
  {
    /** The nodes that a mortar contact or tie leads. */
    struct LedNodes
    {
      std::string                              body, face, target;
      std::vector<std::array<unsigned int, 3>> rows;
      std::vector<double>                      areas;
      /** I - P of each node, where P turns the traction that two tied bodies
       * would pass on into the one that these do; empty: zero. */
      std::vector<Eigen::Matrix3d> not_passed = {};
    };

    /** I - P of a contact point: one that slips passes on the normal part n,
     * and with it that along the sliding, mu t; on left vectors, and without
     * friction, n alone. */
    Eigen::Matrix3d
    not_passed_at(const ContactFrame  &frame,
                  const ContactStatus  status,
                  const double         mu,
                  const FrictionForces friction)
    {
      if (status == ContactStatus::stick)
        return Eigen::Matrix3d::Zero();
      Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
      if (status == ContactStatus::open)
        return result;
      const auto &n = frame.normal, &t = frame.sliding;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int k = 0; k < 3; ++k)
          result(i, k) -=
            (n[i] + (friction == FrictionForces::sliding ? mu * t[i] : 0.)) *
            n[k];
      return result;
    }

    /** Of the nodes of a mortar contact. */
    LedNodes
    led_nodes_of(const ContactParameters &contact,
                 const ContactGeometry   &nodes,
                 const ContactState      &state,
                 const FrictionForces     friction)
    {
      LedNodes result{contact.source_body,
                      contact.source_face,
                      contact.target_body,
                      {},
                      nodes.areas};
      for (std::size_t j = 0; j < nodes.frames.size(); ++j)
        result.not_passed.push_back(
          not_passed_at(nodes.frames[j],
                        state.status[j],
                        signed_coefficient(contact, nodes.speed_ratio[j]),
                        friction));
      for (const auto &rows : nodes.source_rows)
        {
          result.rows.push_back({{-1u, -1u, -1u}});
          for (unsigned int c = 0; c < 3; ++c)
            if (!rows[c].empty()) // not held
              result.rows.back()[c] = rows[c].front().first;
        }
      return result;
    }

    std::vector<LedNodes>
    led_nodes(const Model &model, const FrictionForces friction)
    {
      const Discretization &d     = *model.discretization();
      const auto           &scene = d.scene();
      const PointEvaluator  evaluator(d);
      std::vector<LedNodes> result;
      for (unsigned int i = 0; i < scene.ties.size(); ++i)
        if (!d.coarse_mesh().tie_is_conforming[i])
          {
            const auto          &tie      = scene.ties[i];
            const MortarCoupling coupling = make_tie_coupling(d, evaluator, i);
            result.push_back({tie.source_body,
                              tie.source_face,
                              tie.target_body,
                              coupling.source_rows,
                              coupling.weights});
          }
      for (std::size_t i = 0; i < scene.contacts.size(); ++i)
        if (scene.contacts[i].formulation != Formulation::springs)
          result.push_back(led_nodes_of(scene.contacts[i],
                                        model.linearized().contacts[i],
                                        model.linearized().states[i],
                                        friction));
      return result;
    }

    /** Nodal tractions, Pa, in the rows of the nodes: what the body leaves over
     * there, over the areas. */
    Block
    nodal_tractions(const Model                       &model,
                    const LedNodes                    &nodes,
                    const Block                       &full,
                    const Eigen::SparseMatrix<double> &W)
    {
      const auto        &scene = model.parameters().scene;
      const unsigned int b     = body_index(scene, nodes.body);
      const auto        &body  = scene.bodies[b];
      const auto        &space = *model.discretization()->space();
      const auto        &A     = model.body_matrices()[b];
      const double       E =
        body.material_model == BodyParameters::MaterialModel::isotropic
                ? body.young_modulus
                : 1.;
      const Block left_over =
        E * A.stiffness->multiply(full) -
        body.density * (A.mass->multiply(full) * W).eval();
      Block      result = Block::Zero(full.rows(), full.cols());
      const auto first = space.first_owned(), n = space.n_owned();
      for (std::size_t j = 0; j < nodes.rows.size(); ++j)
        for (const unsigned int row : nodes.rows[j])
          if (row != -1u && row >= first && row < first + n)
            result.row(row - first) =
              left_over.row(row - first) / nodes.areas[j];
      return result;
    }

    /** I - P of the nodes as columns, in their rows. */
    Block
    not_passed_in_rows(const Discretization &d, const LedNodes &nodes)
    {
      const auto &space = *d.space();
      const auto  first = space.first_owned(), n = space.n_owned();
      Block       result = Block::Zero(n, 3);
      for (std::size_t j = 0; j < nodes.not_passed.size(); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          if (const unsigned int row = nodes.rows[j][c];
              row != -1u && row >= first && row < first + n)
            result.row(row - first) = nodes.not_passed[j].row(c);
      return result;
    }

    /** The share of the source's own traction in the one that both bodies can
     * agree on: with it the corrections of both take the least energy, as those
     * of two cells of one body do. */
    double
    share_of_source(const SceneParameters &scene, const LedNodes &nodes)
    {
      const int target = body_or_ground(scene, nodes.target);
      if (target < 0 ||
          scene.bodies[target].shape == BodyParameters::Shape::rigid)
        return 1.;
      const double own = largest_elastic_constant(
                     scene.bodies[body_index(scene, nodes.body)]),
                   theirs = largest_elastic_constant(scene.bodies[target]);
      return theirs / (own + theirs);
    }

    /** Tractions at the points of the source face, Pa, three rows a point.
     * Those of the nodes, @p nodal, are what the bodies pass on, but as smooth
     * as the nodes: beside an edge that holds, or on a body much softer than
     * the one that holds it, they are far from its stresses. They give way to
     * the mean of the stresses of both sides as far as the nodes pass it on. */
    Eigen::MatrixXd
    agreed_tractions(const Model           &model,
                     const LedNodes        &nodes,
                     const FaceQuadrature  &face,
                     const Block           &full,
                     const Eigen::MatrixXd &nodal,
                     const Eigen::MatrixXd &not_passed)
    {
      const Discretization &d     = *model.discretization();
      const double          share = share_of_source(d.scene(), nodes);
      const FaceTractions   own   = face_tractions(
        d, full, body_index(d.scene(), nodes.body), face.points, face.normals);
      FaceTractions theirs;
      if (share < 1.)
        theirs = face_tractions(d,
                                full,
                                body_index(d.scene(), nodes.target),
                                face.points,
                                face.normals);
      Eigen::MatrixXd result = nodal;
      for (std::size_t q = 0; q < face.points.size(); ++q)
        {
          const auto      of_nodes = nodal.middleRows(3 * q, 3);
          Eigen::MatrixXd change   = Eigen::MatrixXd::Zero(3, nodal.cols());
          if (own.found[q])
            change += share * (own.values.middleRows(3 * q, 3) - of_nodes);
          if (share < 1. && theirs.found[q])
            change +=
              (1. - share) * (theirs.values.middleRows(3 * q, 3) - of_nodes);
          const Eigen::Matrix3d P =
            Eigen::Matrix3d::Identity() - not_passed.middleRows(3 * q, 3);
          result.middleRows(3 * q, 3) += P * change;
        }
      return result;
    }
  } // namespace



  std::vector<PointForces>
  mortar_forces(
    const Model &model,
    const Block &full,
    const std::function<Eigen::SparseMatrix<double>(const unsigned int)>
                        &inertia,
    const FrictionForces friction)
  {
    const auto              &d = *model.discretization();
    const PointEvaluator     evaluator(d);
    std::vector<PointForces> result;
    for (const LedNodes &nodes : led_nodes(model, friction))
      {
        const unsigned int   body = body_index(d.scene(), nodes.body);
        const FaceQuadrature face = face_quadrature(
          d, face_id(d.coarse_mesh(), d.scene(), nodes.body, nodes.face));
        const Block tractions =
          nodal_tractions(model, nodes, full, inertia(body));
        std::vector<Functionals::Row> rows;
        for (const auto &at :
             evaluator.displacements(body, face.points, 1e-4).rows)
          rows.insert(rows.end(), at.begin(), at.end());
        const Functionals at_points(d.space(), std::move(rows));
        Eigen::MatrixXd   forces =
          agreed_tractions(model,
                           nodes,
                           face,
                           full,
                           at_points.apply(tractions),
                           at_points.apply(not_passed_in_rows(d, nodes)));
        for (std::size_t q = 0; q < face.points.size(); ++q)
          forces.middleRows(3 * q, 3) *= face.areas[q];
        append_both(body,
                    body_or_ground(d.scene(), nodes.target),
                    face.points,
                    forces,
                    0.,
                    result);
      }
    return result;
  }



  std::vector<PointForces>
  undamped_forces(const Model           &model,
                  const Block           &full,
                  const Eigen::VectorXd &omega_squared)
  {
    std::vector<PointForces> result =
      spring_forces(model, full, FrictionForces::none);
    Eigen::SparseMatrix<double> inertia(full.cols(), full.cols());
    for (Eigen::Index k = 0; k < full.cols(); ++k)
      inertia.insert(k, k) = omega_squared[k];
    const std::vector<PointForces> mortar = mortar_forces(
      model,
      full,
      [&](const unsigned int) { return inertia; },
      FrictionForces::none);
    result.insert(result.end(), mortar.begin(), mortar.end());
    return result;
  }
} // namespace squeal
