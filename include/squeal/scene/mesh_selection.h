// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_mesh_selection_h
#define squeal_scene_mesh_selection_h

#include <squeal/parameters/scene_parameters.h>
#include <squeal/scene/mesh_file.h>

namespace squeal
{
  /** The name of a physical group, or its number where it has none. */
  std::string name_of_group(const std::map<int, std::string> &names,
                            const int                         tag);

  /** Why @p word may mean more than one of the groups @p tags, each a @p kind
   * (physical surface, ...): two have this name, or one has it and another,
   * which has none, this number. "" where it does not. */
  std::string two_meanings_of(const std::string                &word,
                              const std::map<int, std::string> &names,
                              const std::set<int>              &tags,
                              const std::string                &kind);

  /** The cells of a mesh file that make a body: all, or those of its physical
   * volume, element set or property. */
  class MeshSelection
  {
  public:
    /** Throws InputError where there are none, where two volumes may be meant
     * and where some are no hexahedra of first or second order. Both arguments
     * must live on. */
    MeshSelection(const MeshFile &file, const BodyParameters &body);

    bool holds(const MeshFile::Element &element) const;

    /** Position of the material that the file gives the cells; -1: none. Throws
     * InputError where it gives them several. */
    int material() const;

    /** Other physical volumes that use nodes of the body. */
    std::vector<std::string> touching_volumes() const;

    /** Throws InputError: the body and its mesh file @p text. */
    [[noreturn]] void fail(const std::string &text) const;

  private:
    void check_physical_volume() const;
    void check_kinds() const;

    const MeshFile       &file;
    const BodyParameters &body;
  };
} // namespace squeal

#endif
