// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_mortar_faces_h
#define squeal_contact_mortar_faces_h

#include <squeal/contact/surface_face.h>
#include <squeal/discretization/discretization.h>

#include <deal.II/base/bounding_box.h>

#include <array>
#include <string>
#include <vector>

namespace squeal
{
  /** A face that carries multipliers; the same on every rank. */
  struct SourceFace
  {
    SurfaceFace geometry;
    /** A number of each node that faces with this node share. */
    std::vector<unsigned int> keys;
    /** Row of each node's displacement (x, y, z); -1u where held. */
    std::vector<std::array<unsigned int, 3>> rows;
  };

  /** All faces of one boundary id. Nodes that hang are where the mapping has
   * them, and have no row to write to. */
  std::vector<SourceFace> all_faces(const Discretization &discretization,
                                    const FaceBasis      &basis,
                                    const unsigned int    face_id);

  /** The same to carry multipliers. Throws InputError (its text begins with
   * @p where) where they carry hanging nodes. */
  std::vector<SourceFace> source_faces(const Discretization &discretization,
                                       const FaceBasis      &basis,
                                       const unsigned int    face_id,
                                       const std::string    &where);

  /** A face that multipliers push, of an owned cell, and its unknowns. */
  struct TargetFace
  {
    SurfaceFace geometry;
    /** Degrees of freedom of each node, x, y, z; hanging ones too. */
    std::vector<std::array<dealii::types::global_dof_index, 3>> dofs;
    /** Which face of the scene it belongs to. */
    dealii::types::boundary_id id = 0;
  };

  /** Faces on the boundary of a body, of owned cells that reach @p box. Hanging
   * nodes stand where their constraints put them. */
  std::vector<TargetFace> target_faces(const Discretization &discretization,
                                       const FaceBasis      &basis,
                                       const unsigned int    body,
                                       const dealii::BoundingBox<3> &box);

  /** A box round a face, with room for what its nodes do not show. */
  dealii::BoundingBox<3> bounding_box(const SurfaceFace &face);

  /** One round all of them, of which there must be some. */
  dealii::BoundingBox<3> bounding_box(const std::vector<SourceFace> &faces);
} // namespace squeal

#endif
