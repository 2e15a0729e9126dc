// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_mesh_file_h
#define squeal_scene_mesh_file_h

#include <squeal/parameters/scene_parameters.h>

#include <deal.II/base/point.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * What a mesh file says, before anything is made of it.
   */
  struct MeshFile
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
      fluid, /**< of any shape */
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
      /** Position in materials; -1: none is given. */
      int material = -1;
    };
    /** An elastic material in the units of the file. */
    struct Material
    {
      std::string name;
      /** Why it cannot be used; empty if it can. */
      std::string fault;
      double      young_modulus = 0., poisson_ratio = 0., density = 0.;
    };
    /** A tie of two surfaces. */
    struct Tie
    {
      std::string name, source, target;
    };

    std::vector<dealii::Point<3>> nodes;
    std::vector<Element>          elements; /**< surfaces and volumes */
    /** Physical tags of the elements of one group, positive; may be none. */
    std::vector<std::vector<int>> groups;
    /** Names of physical surfaces and volumes by tag. */
    std::map<int, std::string> surface_names, volume_names;
    std::vector<Material>      materials;
    std::vector<Tie>           ties;
    /** Keywords of the file that say something of the model, such as couplings,
     * and are not followed. */
    std::set<std::string> passed_over;
    /** Whether the format writes a cell once for each of its groups. */
    bool repeats_cells = false;
  };

  /** Gives physical tags to the names of a mesh that has names only, and groups
   * to lists of tags. */
  class MeshGroups
  {
  public:
    /** Fills the names and groups of @p file, which is kept. */
    explicit MeshGroups(MeshFile &file);

    /** The tag of a name, the same for each call. */
    int surface(const std::string &name);
    int volume(const std::string &name);
    /** The group of elements with these tags. */
    unsigned int of(const std::vector<int> &tags);

  private:
    MeshFile                                &file;
    std::map<std::string, int>               surfaces, volumes;
    std::map<std::vector<int>, unsigned int> known;
  };

  /** Reads the mesh file of a body, whichever format its shape says; lengths in
   * m. Throws InputError. */
  MeshFile read_mesh_file(const BodyParameters &body);

  /**
   * Reads an ASCII file of format 4.1 or 2.x of Gmsh; source of the format: its
   * reference manual, "MSH file format" 4.1 and 2 (legacy). Throws InputError,
   * one line "file:line: ...", where the file is missing, a directory, empty,
   * binary, of another version, truncated or damaged.
   */
  MeshFile read_gmsh_file(const std::string &name);

  /**
   * Reads an Abaqus input file, with or without parts. Surfaces of solid
   * elements become quadrilaterals in a group of their name; sets of nodes too
   * where @p sets names them. Names within a part carry that of the instance
   * in front, "Pad-1.face". Source of the format: Abaqus keywords reference and
   * its elements guide ("Three-dimensional solid element library"). Throws
   * InputError, one line "file:line: ...", for damaged files and for keywords
   * that make nodes or elements and are not read.
   */
  MeshFile read_abaqus_mesh(const std::string              &name,
                            const std::vector<std::string> &sets);

  /**
   * Reads the bulk data of a Nastran file. Skins of plate elements become
   * quadrilaterals in a group named by the number of their property, the faces
   * of pressure loads in "load n", and the sets of grid points that @p sets
   * names in "set n". Volumes are properties and sets of elements. Source of
   * the format: MSC Nastran quick reference guide (CHEXA, PLOAD4, SET3). Throws
   * InputError as the other readers do.
   */
  MeshFile read_nastran_mesh(const std::string              &name,
                             const std::vector<std::string> &sets);
} // namespace squeal

#endif
