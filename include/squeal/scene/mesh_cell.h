// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_mesh_cell_h
#define squeal_scene_mesh_cell_h

#include <squeal/scene/curved_cell.h>
#include <squeal/scene/mesh_file.h>

#include <map>
#include <optional>

namespace squeal
{
  /** The points of a hexahedron of 8, 20 or 27 nodes. Where the file gives none
   * they are what the shape functions of 8 or 20 nodes have there. m */
  CellNodes nodes_of_hexahedron(const MeshFile          &file,
                                const MeshFile::Element &element);

  /** Orders of the nodes of a hexahedron; they differ behind the corners. */
  enum class NodeOrder
  {
    abaqus,
    nastran
  };

  /** The 8, 20 or 27 nodes of a hexahedron, given in the order of Abaqus or
   * Nastran, in Gmsh's. */
  std::vector<unsigned int> in_gmsh_order(
    const std::vector<unsigned int> &nodes,
    const NodeOrder                  order);

  /** Positions of the two corners of the edge of a CHEXA whose middle point is
   * at @p position, 8 to 19. */
  std::array<unsigned int, 2> ends_of_nastran_edge(const unsigned int position);

  /** Positions of the corners of the faces of a hexahedron, round each face, in
   * the order of Abaqus' S1 to S6. */
  const std::array<std::array<unsigned int, 4>, 6> &faces_of_gmsh_cell();

  /** Adds the faces of hexahedra whose four corners @p holds as quadrilaterals
   * of a group. */
  void add_faces_of_nodes(MeshFile                &file,
                          const std::vector<bool> &holds,
                          const unsigned int       group);

  /** Tells whether cells agree on the edges and faces they share. */
  class SharedPoints
  {
  public:
    /** The number of an element that has other points on an edge or a face than
     * this one, or nothing. */
    std::optional<long> disagrees(const MeshFile::Element &element,
                                  const CellNodes         &nodes);

  private:
    struct Known
    {
      dealii::Point<3> x;
      long             element;
    };
    /** Middles of edges and faces by their sorted corners. */
    std::map<std::vector<unsigned int>, Known> known;
  };
} // namespace squeal

#endif
