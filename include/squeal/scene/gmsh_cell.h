// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_gmsh_cell_h
#define squeal_scene_gmsh_cell_h

#include <squeal/scene/curved_cell.h>
#include <squeal/scene/gmsh_file.h>

#include <map>
#include <optional>

namespace squeal
{
  /** The points of a hexahedron of 8, 20 or 27 nodes. Where the file gives none
   * they are what the shape functions of 8 or 20 nodes have there. m */
  CellNodes nodes_of_hexahedron(const GmshFile          &file,
                                const GmshFile::Element &element);

  /** Tells whether cells agree on the edges and faces they share. */
  class SharedPoints
  {
  public:
    /** The number of an element that has other points on an edge or a face than
     * this one, or nothing. */
    std::optional<long> disagrees(const GmshFile::Element &element,
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
