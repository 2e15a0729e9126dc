// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_gmsh_file_h
#define squeal_scene_gmsh_file_h

#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * What a Gmsh file says, before anything is made of it. Source of the
   * format: the Gmsh reference manual, "MSH file format" 4.1 and 2 (legacy).
   */
  struct GmshFile
  {
    enum class Kind
    {
      low_dimensional, /**< points and lines */
      quadrilateral,   /**< with 4, 8 or 9 nodes */
      other_surface,
      hexahedron,              /**< with 8, 20 or 27 nodes */
      higher_order_hexahedron, /**< of third or higher order */
      tetrahedron,
      wedge,
      pyramid,
      other_volume
    };
    struct Element
    {
      long         tag; /**< its number in the file */
      Kind         kind;
      unsigned int group; /**< index into groups */
      /** Indices into nodes, in Gmsh's order, the corners first; of hexahedra
       * and quadrilaterals only. */
      std::vector<unsigned int> nodes;
    };

    std::vector<dealii::Point<3>> nodes;
    std::vector<Element>          elements; /**< surfaces and volumes */
    /** Physical tags of the elements of one group, positive; may be none. */
    std::vector<std::vector<int>> groups;
    /** Names of physical surfaces and volumes by tag. */
    std::map<int, std::string> surface_names, volume_names;
  };

  /**
   * Reads an ASCII file of format 4.1 or 2.x. Throws InputError, one line
   * "file:line: ...", where the file is missing, a directory, empty, binary,
   * of another version, truncated or damaged.
   */
  GmshFile read_gmsh_file(const std::string &name);
} // namespace squeal

#endif
