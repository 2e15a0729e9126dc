// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_coarse_mesh_h
#define squeal_scene_coarse_mesh_h

#include <squeal/parameters/scene_parameters.h>

#include <squeal/scene/curved_cell.h>

#include <deal.II/base/point.h>

#include <deal.II/grid/tria_description.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * The coarse hexahedral mesh of all meshed bodies of a scene. Bodies share
   * vertices only across conforming ties; coincident vertices of a contact
   * pair stay apart. Cells carry their body's number as material id, boundary
   * faces the id of face_id().
   */
  struct CoarseMesh
  {
    std::vector<dealii::Point<3>>    vertices;
    std::vector<dealii::CellData<3>> cells;
    dealii::SubCellData              boundary;
    /** Nodes of the cells of second order that are curved, by their position
     * in cells. m */
    std::map<unsigned int, CellNodes> curved;
    /** Ids of faces that such cells make round although all corners may lie in
     * one plane. */
    std::set<unsigned int> round_faces;
    /** Names of the faces of each body; the position is the face number. */
    std::vector<std::vector<std::string>> face_names;
    /** True for the ties whose face meshes match and were joined. */
    std::vector<bool> tie_is_conforming;
    /** Sentences for the log about mesh files. */
    std::vector<std::string> remarks;
  };

  /** Faces with names a body can have at most. */
  constexpr unsigned int max_faces_per_body = 64;

  /** Boundary id of a face in the mesh of the scene. */
  unsigned int face_id(const unsigned int body, const unsigned int face);

  /** Number of the body of this name. Throws InputError. */
  unsigned int body_index(const SceneParameters &scene,
                          const std::string     &name);

  /** The axis, 0 to 2, that a flat face looks along, to either side; -1u where
   * it is not flat or looks along none. */
  unsigned int axis_of_face(const CoarseMesh &mesh, const unsigned int face);

  /** Boundary id by names. Throws InputError naming the faces there are. */
  unsigned int face_id(const CoarseMesh      &mesh,
                       const SceneParameters &scene,
                       const std::string     &body,
                       const std::string     &face);

  /**
   * Meshes every body and joins conforming ties. Throws InputError where a
   * mesh file is unusable (not hexahedral, inverted cells, unknown physical
   * name), two bodies share nodes in their file or are tied there without a tie
   * or a contact between them here, or a conforming tie does not match.
   */
  CoarseMesh make_coarse_mesh(const SceneParameters &scene);

  /** The mesh of one body; boundary ids are face numbers. */
  struct BodyMesh
  {
    std::vector<dealii::Point<3>>    vertices;
    std::vector<dealii::CellData<3>> cells;
    std::vector<dealii::CellData<2>> boundary;
    std::vector<std::string>         face_names;
    /** As in CoarseMesh; the faces by their numbers. */
    std::map<unsigned int, CellNodes> curved;
    std::set<unsigned int>            round_faces;
    /** Other volumes of the mesh file that use nodes of this body. */
    std::vector<std::string> touching_volumes;
    /** Ties of the mesh file: their names and those of their surfaces. */
    std::vector<std::array<std::string, 3>> file_ties;
    /** Sentences for the log about what the mesh file says and the body does
     * not follow. */
    std::vector<std::string> remarks;
  };
  BodyMesh make_body_mesh(const BodyParameters &body);

  /** Reads the hexahedra, surfaces and sets of a body's mesh file. */
  BodyMesh read_mesh_body(const BodyParameters &body);
} // namespace squeal

#endif
