// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/triggers/trigger_tables.h>
#include <squeal/output/judged_force.h>
#include <squeal/results/column_of.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    using Type          = Table::Type;
    using TriggerColumn = ColumnOf<TriggerResult>;

    /** Of a result of which @p is_there holds; else nothing. */
    TriggerColumn
    where(const Table::Column &declaration,
          bool (TriggerResult::*is_there)() const,
          const std::function<double(const TriggerResult &)> &value)
    {
      return {declaration, [is_there, value](const TriggerResult &r) {
                return (r.*is_there)() ? or_missing(value(r)) : Cell();
              }};
    }

    /** Share of its rms by which the cycle found may differ from the motion
     * that it is sought from: as much as windows of that motion may. */
    constexpr double same_motion = 0.05;

    /** The search may end in another cycle than the motion after the largest
     * impulse stays on, which then says nothing about the squeal. */
    bool
    is_of_squeal(const TriggerResult &r)
    {
      return r.stable.has_converged() && !r.strongest.windows.empty() &&
             std::abs(r.stable.figures.rms_normal /
                        r.strongest.windows.back().rms_normal -
                      1.) <= same_motion;
    }

    /** Of one of the cycles, where it has been found. */
    TriggerColumn
    of_cycle(const Table::Column &declaration,
             CycleResult TriggerResult::*const                 cycle,
             const std::function<double(const CycleResult &)> &value)
    {
      return {declaration, [cycle, value](const TriggerResult &r) {
                const bool is_there = cycle == &TriggerResult::stable
                                        ? is_of_squeal(r)
                                        : (r.*cycle).has_converged();
                return is_there ? Cell(value(r.*cycle)) : Cell();
              }};
    }

    double
    frequency(const CycleResult &c)
    {
      return c.figures.frequency;
    }

    double
    rms(const CycleResult &c)
    {
      return c.figures.rms_normal;
    }

    /** The largest in size beside the trivial one. */
    std::complex<double>
    leading_multiplier(const CycleResult &c)
    {
      const auto &values = c.multipliers.values;
      return values.size() > 1 && values[0] == c.multipliers.trivial
               ? values[1]
               : values[0];
    }

    /** The search may find a cycle gone through twice. */
    double
    off_a_multiple(const double f, const double of_cycle)
    {
      return f / (std::max(1., std::round(f / of_cycle)) * of_cycle) - 1.;
    }

    double
    dominant_line(const CycleResult &c)
    {
      return c.figures.largest_harmonic * c.figures.frequency;
    }

    /** Multipliers above 1 in size by more than their error; nothing where that
     * covers the distance of the largest one to 1. */
    Cell
    n_outside(const CycleResult &c)
    {
      const FloquetMultipliers &m = c.multipliers;
      if (!m.is_stable() && !m.is_unstable())
        return Cell();
      return Cell(std::count_if(m.values.begin(),
                                m.values.end(),
                                [&m](const std::complex<double> &value) {
                                  return std::abs(value) - m.uncertainty() > 1.;
                                }));
    }

    std::vector<TriggerColumn>
    threshold_columns()
    {
      using R = TriggerResult;
      return {
        {{"point", Type::text, "", "that is struck"},
         [](const R &r) { return Cell(r.point); }},
        {{"trigger_status", Type::text, "", "what the search has ended with"},
         [](const R &r) { return Cell(r.status); }},
        where(
          {"impulse_ns", Type::real, "N s", "smallest that leads to squeal"},
          &R::has_threshold,
          [](const R &r) { return r.best().middle(); }),
        where({"impulse_lower_ns",
               Type::real,
               "N s",
               "the motion after it comes back to steady sliding"},
              &R::has_threshold,
              [](const R &r) { return r.best().lower; }),
        where({"impulse_upper_ns",
               Type::real,
               "N s",
               "the motion after it squeals"},
              &R::has_threshold,
              [](const R &r) { return r.best().upper; }),
        where({"impulse_error_ns",
               Type::real,
               "N s",
               "half the bracket and the change with half the steps",
               3},
              &R::has_threshold,
              [](const R &r) { return r.impulse_error(); }),
        {{"n_changes",
          Type::integer,
          "",
          "of what a motion ends in along the ladder of impulses; more than 1: "
          "a larger impulse returns again"},
         [](const R &r) {
           return r.has_threshold() ? Cell(r.threshold.n_changes) : Cell();
         }},
        {{"n_trials", Type::integer, "", "impulses that were tried"},
         [](const R &r) {
           return Cell(r.threshold.trials.size() + r.finer.trials.size());
         }},
        {{"pair_sigma_per_s",
          Type::real,
          "1/s",
          "largest growth rate of all motions about steady sliding"},
         [](const R &r) { return Cell(r.pair.real()); }},
        {{"pair_frequency_hz", Type::real, "Hz", "of that motion"},
         [](const R &r) { return Cell(r.pair.imag() / (2. * M_PI)); }}};
    }

    std::vector<TriggerColumn>
    edge_columns()
    {
      using R              = TriggerResult;
      const auto cycle     = &R::unstable;
      const auto of_period = [](const R &r) {
        return r.edge.frequency > 0. ? r.edge.frequency
                                     : std::numeric_limits<double>::quiet_NaN();
      };
      return {
        {{"edge_status",
          Type::text,
          "",
          "of the motion on the edge and of the cycle sought from it"},
         [](const R &r) {
           return Cell(!r.has_threshold() ? ""
                       : !r.has_edge()    ? "not followed"
                       : r.edge.status == EdgeTrajectory::Status::lost
                         ? "lost"
                         : r.unstable.status());
         }},
        where({"edge_time_s", Type::real, "s", "from the blow to its end"},
              &R::has_edge,
              [](const R &r) { return r.edge.end; }),
        where({"edge_frequency_hz",
               Type::real,
               "Hz",
               "1/period of the motion on the edge"},
              &R::has_edge,
              of_period),
        where({"edge_rms_normal_n", Type::real, "N", "of its normal force"},
              &R::has_edge,
              [](const R &r) { return r.edge.rms_normal; }),
        {judged_force_column("edge_judged_force"),
         [](const R &r) { return judged_force_cell(r.edge.judged_force); }},
        where({"edge_repetition",
               Type::real,
               "",
               "how well it repeats itself with that frequency; 1: exactly"},
              &R::has_edge,
              [](const R &r) { return r.edge.repetition; }),
        of_cycle({"unstable_frequency_hz",
                  Type::real,
                  "Hz",
                  "1/period of the cycle on the edge",
                  8},
                 cycle,
                 frequency),
        of_cycle({"unstable_frequency_error_hz",
                  Type::real,
                  "Hz",
                  "twice the difference to half the steps",
                  3},
                 cycle,
                 &CycleResult::frequency_error),
        of_cycle({"unstable_line_hz",
                  Type::real,
                  "Hz",
                  "largest harmonic of its normal force",
                  8},
                 cycle,
                 dominant_line),
        of_cycle(
          {"unstable_rms_normal_n", Type::real, "N", "of its normal force"},
          cycle,
          rms),
        {judged_force_column("unstable_judged_force"),
         [](const R &r) {
           return judged_force_cell(
             r.unstable.has_converged() ? r.unstable.figures.judged_force : "");
         }},
        of_cycle({"unstable_rms_normal_error_n",
                  Type::real,
                  "N",
                  "twice the difference of the harmonics to half the steps",
                  3},
                 cycle,
                 &CycleResult::rms_normal_error),
        of_cycle(
          {"unstable_multiplier_real",
           Type::real,
           "",
           "largest multiplier in size but the trivial one"},
          cycle,
          [](const CycleResult &c) { return leading_multiplier(c).real(); }),
        of_cycle(
          {"unstable_multiplier_imag", Type::real, "", "the same"},
          cycle,
          [](const CycleResult &c) { return leading_multiplier(c).imag(); }),
        of_cycle(
          {"unstable_multiplier_error",
           Type::real,
           "",
           "the larger of what the trivial one is off 1 and of the "
           "difference to half the steps",
           3},
          cycle,
          [](const CycleResult &c) { return c.multipliers.uncertainty(); }),
        {{"n_outside",
          Type::integer,
          "",
          "its multipliers above 1 in size by more than that; 1: it is the "
          "edge's own attractor; empty where that covers the distance of the "
          "largest one to 1"},
         [](const R &r) {
           return r.unstable.has_converged() ? n_outside(r.unstable) : Cell();
         }},
        {{"edge_frequency_difference_rel",
          Type::real,
          "",
          "of the motion on the edge from the nearest multiple of that of the "
          "cycle",
          3},
         [of_period](const R &r) {
           return r.unstable.has_converged()
                    ? or_missing(
                        off_a_multiple(of_period(r), frequency(r.unstable)))
                    : Cell();
         }},
        {{"edge_rms_difference_rel", Type::real, "", "of the normal force", 3},
         [](const R &r) {
           return r.unstable.has_converged()
                    ? Cell(r.edge.rms_normal / rms(r.unstable) - 1.)
                    : Cell();
         }}};
    }

    std::vector<TriggerColumn>
    stable_columns()
    {
      using R          = TriggerResult;
      const auto cycle = &R::stable;
      return {
        where({"squeal_rms_normal_n",
               Type::real,
               "N",
               "of the normal force in the last window after the largest "
               "impulse"},
              &R::has_threshold,
              [](const R &r) { return r.strongest.windows.back().rms_normal; }),
        {judged_force_column("squeal_judged_force"),
         [](const R &r) {
           return judged_force_cell(
             r.has_threshold() ? r.strongest.windows.back().judged_force : "");
         }},
        {{"stable_status",
          Type::text,
          "",
          "of the cycle that the largest impulse ends in"},
         [](const R &r) {
           return Cell(!r.has_threshold() ? ""
                       : r.stable.has_converged() && !is_of_squeal(r)
                         ? "another cycle"
                         : r.stable.status());
         }},
        of_cycle({"stable_frequency_hz", Type::real, "Hz", "1/period of it", 8},
                 cycle,
                 frequency),
        of_cycle({"stable_frequency_error_hz",
                  Type::real,
                  "Hz",
                  "twice the difference to half the steps",
                  3},
                 cycle,
                 &CycleResult::frequency_error),
        of_cycle({"stable_line_hz",
                  Type::real,
                  "Hz",
                  "largest harmonic of its normal force",
                  8},
                 cycle,
                 dominant_line),
        of_cycle(
          {"stable_rms_normal_n", Type::real, "N", "of its normal force"},
          cycle,
          rms),
        {judged_force_column("stable_judged_force"),
         [](const R &r) {
           return judged_force_cell(
             is_of_squeal(r) ? r.stable.figures.judged_force : "");
         }},
        of_cycle({"stable_rms_normal_error_n",
                  Type::real,
                  "N",
                  "twice the difference of the harmonics to half the steps",
                  3},
                 cycle,
                 &CycleResult::rms_normal_error),
        {{"stability", Type::text, "", "by its Floquet multipliers"},
         [](const R &r) {
           return is_of_squeal(r) ? Cell(r.stable.multipliers.stability())
                                  : Cell();
         }},
        of_cycle({"largest_multiplier",
                  Type::real,
                  "",
                  "in size, of those beside the trivial one"},
                 cycle,
                 [](const CycleResult &c) { return c.multipliers.largest; }),
        of_cycle(
          {"largest_multiplier_error",
           Type::real,
           "",
           "the larger of what the trivial one is off 1 and of the "
           "difference to half the steps",
           3},
          cycle,
          [](const CycleResult &c) { return c.multipliers.uncertainty(); })};
    }
  } // namespace



  Table
  trigger_table(const std::vector<TriggerResult> &results)
  {
    std::vector<TriggerColumn> columns = threshold_columns();
    for (const auto &more : {edge_columns(), stable_columns()})
      columns.insert(columns.end(), more.begin(), more.end());
    return table_of(columns, results);
  }

  std::string
  trigger_sentence(const Table &t, const std::size_t row)
  {
    const auto shown = [&](const std::string &name, const int digits) {
      return rounded_text(t.real(row, name), digits);
    };
    // Of the line and the rms of the cycle whose columns start with `cycle`.
    const auto shown_cycle = [&](const std::string &cycle) {
      const auto of = [&](const std::string &column) {
        return t.real(row, cycle + column);
      };
      const double      times  = of("_line_hz") / of("_frequency_hz");
      const std::string judged = t.text(row, cycle + "_judged_force");
      return with_error(of("_line_hz"), times * of("_frequency_error_hz")) +
             " Hz, " +
             with_error(of("_rms_normal_n"), of("_rms_normal_error_n")) +
             " N rms" + (judged.empty() ? "" : " of the " + judged);
    };
    const std::string at     = " at " + t.text(row, "point"),
                      status = t.text(row, "trigger_status");
    if (t.is_missing(row, "impulse_ns"))
      return status == "steady sliding is unstable"
               ? "steady sliding is unstable (sigma " +
                   shown("pair_sigma_per_s", 4) + " 1/s at " +
                   shown("pair_frequency_hz", 5) + " Hz): it needs no trigger"
               : status + at;
    std::string text = "a blow of " + shown("impulse_ns", 4) +
                       (t.is_missing(row, "impulse_error_ns")
                          ? ""
                          : " +- " + shown("impulse_error_ns", 2)) +
                       " N s" + at + " is enough for squeal" +
                       (t.is_missing(row, "stable_frequency_hz")
                          ? ""
                          : " at " + shown_cycle("stable")) +
                       "; below it steady sliding returns";
    if (status != "threshold")
      text += " (" + status + ")";
    if (!t.is_missing(row, "unstable_frequency_hz"))
      text +=
        "; between them stands " +
        std::string(t.is_missing(row, "n_outside")
                      ? "a cycle whose multipliers the steps leave open"
                    : t.integer(row, "n_outside") > 0 ? "an unstable cycle"
                                                      : "a stable cycle") +
        " at " + shown_cycle("unstable");
    else
      text += "; edge: " + t.text(row, "edge_status");
    if (t.real(row, "n_changes") > 1.)
      text += "; some larger impulse returns again";
    return text;
  }
} // namespace squeal
