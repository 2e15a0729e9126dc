// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/sweep/sweep_scenes.h>
#include <squeal/base/exceptions.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/number_access.h>
#include <squeal/sweep/parametric_system.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    bool
    keeps_matrices(const SweepAxisParameters &axis)
    {
      return std::all_of(
        axis.entries.begin(), axis.entries.end(), &is_affine_entry);
    }

    /** The first entry that factors of fixed matrices can not follow. */
    std::string
    rebuilding_entry(const SweepAxisParameters &axis)
    {
      return *std::find_if_not(
        axis.entries.begin(), axis.entries.end(), &is_affine_entry);
    }
  } // namespace



  std::string
  SweepScene::title() const
  {
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i)
      text += (i > 0 ? ", " : "") + columns[i].name + " = " +
              rounded_text(values[i], 6);
    return text;
  }

  void
  SweepScene::enter(Table &table) const
  {
    for (std::size_t i = values.size(); i-- > 0;)
      table.put_first(columns[i], values[i]);
  }



  std::vector<SweepScene>
  sweep_scenes(const Parameters &p)
  {
    Parameters inner = p, outer = p;
    inner.sweep.axes.clear();
    outer.sweep.axes.clear();
    outer.sweep.sensitivities.clear();
    for (const auto &axis : p.sweep.axes)
      (keeps_matrices(axis) ? inner : outer).sweep.axes.push_back(axis);
    if (outer.sweep.axes.empty())
      return {{p, {}, {}, ""}};
    if (inner.sweep.axes.empty())
      throw InputError(
        "'Sweep/Axes': every axis has an entry that needs new matrices ('" +
        rebuilding_entry(outer.sweep.axes[0]) +
        "'), and none is left to be swept in each scene: add an axis of "
        "stiffnesses, densities, friction or the like alone");
    const SweepGrid                grid(outer);
    const std::vector<std::string> entries = grid.entries();
    std::vector<SweepScene>        scenes;
    for (std::size_t i = 0; i < grid.n_points(); ++i)
      {
        const SweepPoint          point  = grid.point(i);
        const std::vector<double> values = grid.values(point);
        SweepScene                scene;
        scene.parameters            = with_values(p, entries, values);
        scene.parameters.sweep.axes = inner.sweep.axes;
        for (unsigned int a = 0; a < grid.n_axes(); ++a)
          {
            const auto &axis = grid.axis(a);
            scene.columns.push_back({axis.name,
                                     Table::Type::real,
                                     unit_of_entry(axis.entries[0], p.scene),
                                     axis.entries[0],
                                     6});
            scene.values.push_back(grid.value(a, point[a]));
            scene.name += (a > 0 ? "_" : "") + axis.name + "_" +
                          rounded_text(scene.values.back(), 6);
          }
        scenes.push_back(std::move(scene));
      }
    return scenes;
  }
} // namespace squeal
