// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/preload/preload_mesh_error.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/base/worst_of.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** What is compared of every pair, and what integrates over the face:
     * pressures at an edge have no limit where they are singular. */
    struct Quantity
    {
      const char *name, *unit;
      bool        integrates;
    };
    constexpr Quantity quantities[] = {
      {"normal_n", "N", true},
      {"tangential_n", "N", true},
      {"secant_stiffness_n_per_m", "N/m", true},
      {"leading_edge_factor", "", false},
      {"peak_pressure_pa", "Pa", false}};

    LoadSteps
    full_load_of_degree(const Parameters  &p,
                        const Model       &model,
                        const unsigned int degree,
                        Timers            &timers)
    {
      const auto        space  = model.discretization()->with_degree(degree);
      const auto        bodies = assemble_bodies(*space);
      const SteadyModel steady =
        PressedModel(p, *space, bodies, cut_off_of_statics(p), timers)
          .steady(p.preload.tolerance, timers);
      LoadSteps result(p.scene.contacts,
                       p.preload.run_in == PreloadParameters::RunIn::archard);
      result.add(steady.pressed, steady.sliding, 1.);
      return result;
    }

    double
    relative_change(const double value, const double other)
    {
      const double size = std::max(std::abs(value), std::abs(other));
      return size > 0. ? std::abs(value - other) / size : 0.;
    }
  } // namespace



  std::optional<Table>
  preload_mesh_error(const Parameters &p,
                     const Model      &model,
                     const LoadSteps  &steps,
                     RunLog           &log,
                     Timers           &timers)
  {
    const Discretization *space = model.discretization();
    if (!p.discretization.estimate_error || !space || !space->has_mesh() ||
        space->degree() < 2)
      return {};
    Timers::Section section(timers, "Solve: mesh error of the contact");
    std::optional<LoadSteps> found;
    try
      {
        found.emplace(
          full_load_of_degree(p, model, space->degree() - 1, timers));
      }
    catch (const ComputationError &error)
      {
        // The state that was asked for is there all the same.
        log.warning(
          std::string("no steady sliding with one degree less, so that "
                      "the error by the mesh is not known: ") +
          error.what());
        return {};
      }
    const LoadSteps &lower = *found;
    Table            table(
      {{"contact", Type::text, "", "pair"},
                  {"quantity", Type::text, "", "column of preload.csv, full load"},
                  {"unit", Type::text, "", "of both values"},
                  {"value", Type::real, "", "with the elements of the run", 7},
                  {"value_lower_degree", Type::real, "", "with one degree less", 7},
                  {"change_rel", Type::real, "", "over the larger of both", 3}});
    const std::size_t last = steps.table().n_rows() - 1;
    for (unsigned int i = 0; i < p.scene.contacts.size(); ++i)
      for (const Quantity &q : quantities)
        {
          const std::string column = steps.column(i, q.name);
          if (steps.table().is_missing(last, column) ||
              lower.table().is_missing(0, column))
            continue;
          const double value = steps.table().real(last, column),
                       other = lower.table().real(0, column);
          table.add_row({p.scene.contacts[i].name,
                         q.name,
                         q.unit,
                         value,
                         other,
                         relative_change(value, other)});
        }
    return table;
  }



  std::string
  mesh_error_text(const std::optional<Table> &changes)
  {
    if (!changes)
      return "mesh error not estimated";
    std::set<std::string> integrated;
    for (const Quantity &q : quantities)
      if (q.integrates)
        integrated.insert(q.name);
    double forces = 0., pressures = 0.;
    for (std::size_t i = 0; i < changes->n_rows(); ++i)
      {
        double &worst = integrated.count(changes->text(i, "quantity")) > 0
                          ? forces
                          : pressures;
        worst         = worst_of(worst, changes->real(i, "change_rel"));
      }
    return "elements of one degree less change forces and stiffness by up to " +
           rounded_text(100. * forces, 2) + " %, pressures at edges by up to " +
           rounded_text(100. * pressures, 2) + " %";
  }
} // namespace squeal
