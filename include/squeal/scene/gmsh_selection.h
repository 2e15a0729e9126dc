// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_gmsh_selection_h
#define squeal_scene_gmsh_selection_h

#include <squeal/parameters/scene_parameters.h>
#include <squeal/scene/gmsh_file.h>

namespace squeal
{
  /** The name of a physical group, or its number where it has none. */
  std::string name_of_group(const std::map<int, std::string> &names,
                            const int                         tag);

  /** The cells of a Gmsh file that make a body: all, or those of its physical
   * volume. */
  class GmshSelection
  {
  public:
    /** Throws InputError where there are none or where some are no hexahedra of
     * first or second order. Both arguments must live on. */
    GmshSelection(const GmshFile &file, const BodyParameters &body);

    bool holds(const GmshFile::Element &element) const;

    /** Other physical volumes that use nodes of the body. */
    std::vector<std::string> touching_volumes() const;

    /** Throws InputError: the body and its mesh file @p text. */
    [[noreturn]] void fail(const std::string &text) const;

  private:
    void check_physical_volume() const;
    void check_kinds() const;

    const GmshFile       &file;
    const BodyParameters &body;
  };
} // namespace squeal

#endif
