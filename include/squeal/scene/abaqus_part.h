// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_abaqus_part_h
#define squeal_scene_abaqus_part_h

#include <squeal/scene/mesh_file.h>

#include <array>

namespace squeal
{
  /** What a part of an Abaqus input file holds, or a model without parts, or
   * the assembly. Names are looked up in capitals. */
  struct AbaqusPart
  {
    /** Nodes or elements by their position in the part. */
    struct Set
    {
      std::string               name; /**< as written first */
      std::vector<unsigned int> members;
    };
    struct Surface
    {
      std::string name;
      /** Elements and their faces 0 to 5; 6: all of them. */
      std::vector<std::array<unsigned int, 2>> faces;
      /** Of a surface of nodes. */
      std::vector<unsigned int> nodes;
    };
    struct Section
    {
      /** The set of elements as written, and where; empty once the elements
       * are known. */
      std::string               set;
      unsigned int              line;
      std::vector<unsigned int> elements;
      std::string               material; /**< in capitals */
      bool                      is_oriented;
    };
    using Numbers = std::map<long, unsigned int>;

    std::vector<dealii::Point<3>>  points;
    std::vector<MeshFile::Element> elements;
    Numbers                        number_of_node, number_of_element;
    std::map<std::string, Set>     node_sets, element_sets;
    std::map<std::string, Surface> surfaces;
    std::vector<Section>           sections;
  };

  /** Adds a part to the assembly, its names with that of the instance in front
   * ("Pad-1.face") and its elements as a set of that name. Numbers of nodes and
   * elements stay with the instance. */
  void add_instance(AbaqusPart        &assembly,
                    const AbaqusPart  &part,
                    const std::string &name);

  /** Where an instance stands in its assembly. */
  struct InstancePlace
  {
    dealii::Tensor<1, 3>  shift;  /**< m */
    std::array<double, 7> turn{}; /**< two points of the axis, m; degrees */
  };

  /** Shifts the points of an instance, then turns them by the right hand. */
  void place_instance(AbaqusPart &part, const InstancePlace &place);

  /** Makes a mesh file of a whole model: groups of sets and surfaces. Of the
   * sets of nodes those that @p wanted names; of surfaces, too, unless it is
   * empty. Materials must be known: @p material gives their positions. */
  void add_to_mesh(const AbaqusPart                 &model,
                   const std::vector<std::string>   &wanted,
                   const std::map<std::string, int> &material,
                   MeshFile                         &file);
} // namespace squeal

#endif
