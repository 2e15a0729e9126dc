// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/face_coverage.h>
#include <squeal/contact/mortar_integrals.h>
#include <squeal/contact/spring_stiffness.h>
#include <squeal/discretization/point_evaluator.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    bool
    is_rigid_body(const SceneParameters &scene, const std::string &name)
    {
      return scene.bodies[body_index(scene, name)].shape ==
             BodyParameters::Shape::rigid;
    }

    /** Shares that the faces @p targets are opposite to. Of several behind
     * one another springs take the nearest. */
    std::vector<SourceIntegrals>
    covered_shares(const Discretization          &d,
                   const FaceBasis               &basis,
                   const std::vector<SourceFace> &sources,
                   const std::vector<TargetFace> &targets)
    {
      auto shares = integrals_of_all_faces(
        basis, sources, targets, limits_of_meshes, d.space()->communicator());
      for (SourceIntegrals &share : shares)
        share.covered = std::min(share.covered, 1.);
      return shares;
    }

    void
    check_spring_contact(const Discretization    &d,
                         const ContactParameters &contact)
    {
      const auto     &scene = d.scene();
      const FaceBasis basis(d.degree());
      const auto      sources = all_faces(
        d,
        basis,
        face_id(
          d.coarse_mesh(), scene, contact.source_body, contact.source_face));
      auto               targets = target_faces(d,
                                  basis,
                                  body_index(scene, contact.target_body),
                                  bounding_box(sources));
      const unsigned int id      = face_id(
        d.coarse_mesh(), scene, contact.target_body, contact.target_face);
      targets.erase(
        std::remove_if(targets.begin(),
                       targets.end(),
                       [&](const TargetFace &face) { return face.id != id; }),
        targets.end());
      check_covered(sources,
                    covered_shares(d, basis, sources, targets),
                    "Scene/Contact " + contact.name,
                    limits_of_meshes);
    }

    /** Whether all of a face lies inside the body, as the points tell that
     * springs look up. */
    bool
    lies_inside(const PointEvaluator &evaluator,
                const unsigned int    body,
                const SurfaceFace    &face)
    {
      const dealii::QGauss<2>       quadrature(16);
      std::vector<dealii::Point<3>> points;
      for (const auto &unit : quadrature.get_points())
        points.push_back(face.point(unit));
      const auto found = evaluator.displacements(body, points, 1e-4).found;
      return std::count(found.begin(), found.end(), false) == 0;
    }

    void
    check_bed(const Discretization &d, const SpringParameters &spring)
    {
      const auto        &scene = d.scene();
      const unsigned int other = body_index(scene, spring.other_body);
      const FaceBasis    basis(d.degree());
      const auto         sources = all_faces(
        d, basis, face_id(d.coarse_mesh(), scene, spring.body, spring.face));
      if (sources.empty())
        return; // under a tie or a layer: refused where the bed is made
      const PointEvaluator evaluator(d);
      auto                 shares =
        covered_shares(d,
                       basis,
                       sources,
                       target_faces(d, basis, other, bounding_box(sources)));
      for (std::size_t e = 0; e < sources.size(); ++e)
        if (1. - shares[e].covered > limits_of_meshes.beside &&
            lies_inside(evaluator, other, sources[e].geometry))
          shares[e].covered = 1.;
      check_covered(
        sources, shares, "Scene/Spring " + spring.name, limits_of_meshes);
    }
  } // namespace



  void
  check_faces_covered(const Discretization &d)
  {
    using Formulation = ContactParameters::Formulation;
    const auto &scene = d.scene();
    for (const auto &contact : scene.contacts)
      if (contact.formulation == Formulation::springs && is_per_area(contact) &&
          contact.target_body != "ground" &&
          !is_rigid_body(scene, contact.source_body) &&
          !is_rigid_body(scene, contact.target_body))
        check_spring_contact(d, contact);
    for (const auto &spring : scene.springs)
      if (spring.kind == SpringParameters::Kind::area &&
          spring.other_body != "ground" && !is_rigid_body(scene, spring.body) &&
          !is_rigid_body(scene, spring.other_body))
        check_bed(d, spring);
  }
} // namespace squeal
