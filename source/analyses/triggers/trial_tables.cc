// SPDX-License-Identifier: LGPL-2.1-or-later

// What the search of a trigger has tried: impulses, and motions by windows.

#include <squeal/analyses/triggers/trigger_tables.h>
#include <squeal/output/judged_force.h>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    void
    add_windows(Table                           &table,
                const std::string               &point,
                const std::string               &motion,
                const std::vector<MotionWindow> &windows)
    {
      for (const MotionWindow &w : windows)
        table.add_row({point,
                       motion,
                       w.time,
                       w.rms_normal,
                       judged_force_cell(w.judged_force),
                       w.rms_forces,
                       w.amplitude,
                       w.is_as_steady ? 1 : 0});
    }

    void
    add_trials(Table                  &table,
               const std::string      &point,
               const std::string      &steps,
               const TriggerThreshold &threshold)
    {
      for (const auto &trial : threshold.trials)
        table.add_row({point, steps, trial.impulse, fate_text(trial.fate)});
    }
  } // namespace



  Table
  trial_table(const std::vector<TriggerResult> &results)
  {
    Table table(
      {{"point", Type::text, "", "that is struck"},
       {"steps", Type::text, "", "whole, or half of those of the parameters"},
       {"impulse_ns", Type::real, "N s", "of the blow"},
       {"fate", Type::text, "", "what the motion after it ends in"}});
    for (const TriggerResult &r : results)
      {
        add_trials(table, r.point, "whole", r.threshold);
        add_trials(table, r.point, "half", r.finer);
      }
    return table;
  }

  Table
  motion_table(const std::vector<TriggerResult> &results)
  {
    Table table(
      {{"point", Type::text, "", "that is struck"},
       {"motion", Type::text, "", "which one"},
       {"time_s", Type::real, "s", "from the blow to the end of the window"},
       {"rms_normal_n", Type::real, "N", "of the normal force in the window"},
       judged_force_column("judged_force"),
       {"rms_forces_n",
        Type::real,
        "N",
        "root of the squares of normal and tangential force about their means"},
       {"amplitude_sqrt_j",
        Type::real,
        "sqrt(J)",
        "rms of the norm of the energy away from steady sliding"},
       {"is_as_steady",
        Type::integer,
        "",
        "1 where every node keeps its status of steady sliding"}});
    for (const TriggerResult &r : results)
      {
        add_windows(table, r.point, "largest impulse", r.strongest.windows);
        add_windows(table, r.point, "below", r.below.windows);
        add_windows(table, r.point, "above", r.above.windows);
        for (const auto &stretch : r.edge.stretches)
          {
            add_windows(table, r.point, "edge, below", stretch.lower);
            add_windows(table, r.point, "edge, above", stretch.upper);
          }
      }
    return table;
  }
} // namespace squeal
