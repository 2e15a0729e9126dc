// SPDX-License-Identifier: LGPL-2.1-or-later

// Changes that stop a squeal, and what else they wake.

#include "stopping_change.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** Direct solutions for one range at most. */
    constexpr unsigned int most_checks = 3;

    std::string
    percent(const double share)
    {
      return (share > 0. ? "+" : "") + rounded_text(100. * share, 3) + " %";
    }

    std::string
    text_of(const GrowingPair &pair, const double share)
    {
      return rounded_text(pair.frequency, 4) + " Hz, sigma " +
             rounded_text(pair.sigma, 3) + " 1/s, at " + percent(share);
    }

    struct Target
    {
      const SweepLine     *line;
      const UnstableRange *range;
    };

    std::vector<Target>
    worst_ranges(const SweepSolution &solution, const unsigned int n)
    {
      std::vector<Target> result;
      for (const auto &line : solution.lines)
        for (const auto &range : line.ranges)
          result.push_back({&line, &range});
      std::stable_sort(
        result.begin(), result.end(), [](const auto &a, const auto &b) {
          return a.range->peak_sigma > b.range->peak_sigma;
        });
      result.resize(std::min<std::size_t>(result.size(), n));
      return result;
    }

    Table
    empty_suggestions(const SweepGrid &grid)
    {
      Table table;
      add_fixed_axes(table, grid);
      for (const Table::Column &column : std::vector<Table::Column>{
             {"branch", Type::text, "", "unstable branch"},
             {"coordinate", Type::real, "", "of its peak on the first axis", 6},
             {"frequency_hz", Type::real, "Hz", "there", 6},
             {"sigma_per_s", Type::real, "1/s", "there", 5},
             {"rank", Type::integer, "", "1: the smallest change"},
             {"entry", Type::text, "", "number of the scene"},
             {"value", Type::real, "", "as it stands, SI units", 5},
             {"new_value", Type::real, "", "that leaves no pair unstable", 5},
             {"change_percent", Type::real, "", "from one to the other", 3},
             {"largest_sigma_per_s",
              Type::real,
              "1/s",
              "of the band with it, on the basis",
              4},
             {"stable_to_percent",
              Type::real,
              "",
              "change at which a pair is unstable again, or the largest tried",
              3},
             {"direct_sigma_per_s",
              Type::real,
              "1/s",
              "the largest of a direct solution with it",
              4},
             {"direct_frequency_hz", Type::real, "Hz", "of that pair", 6},
             {"verdict", Type::text, "", "what the direct solution says"},
             {"tunes_in",
              Type::text,
              "",
              "worst other pair that is unstable on the way"}})
        table.add_column(column);
      return table;
    }

    Cell
    sigma_cell(const WorstPair &worst)
    {
      return worst ? Cell(worst->sigma) : Cell();
    }

    /** In words. */
    std::string
    verdict_of(const DirectAnswer &answer)
    {
      const std::string verdict =
        answer.is_stable() ? "stable" : "still unstable";
      return !answer.outside
               ? verdict
               : verdict + "; outside the band " +
                   rounded_text(answer.outside->frequency, 4) +
                   " Hz grows by " + rounded_text(answer.outside->sigma, 3) +
                   " 1/s";
    }

    std::vector<StoppingChange>
    changes_for(const ChangedScene           &scene,
                const std::vector<Influence> &numbers,
                const double                  largest)
    {
      std::vector<StoppingChange> result;
      for (const auto &number : numbers)
        {
          if (number.value == 0.)
            continue;
          const StoppingChange up = smallest_change(scene, number, largest, 1.);
          const StoppingChange down =
            smallest_change(scene, number, largest, -1.);
          const bool takes_up =
            down.share == 0. ||
            (up.share != 0. && std::abs(up.share) < std::abs(down.share));
          result.push_back(takes_up ? up : down);
        }
      std::stable_sort(
        result.begin(), result.end(), [](const auto &a, const auto &b) {
          return (a.share == 0. ? 1e300 : std::abs(a.share)) <
                 (b.share == 0. ? 1e300 : std::abs(b.share));
        });
      return result;
    }

    std::string
    squeal_of(const PeakPair &peak)
    {
      return "the squeal at " + rounded_text(peak.frequency(), 4) + " Hz";
    }

    void
    warn_of_tuning(RunContext           &context,
                   const PeakPair       &peak,
                   const StoppingChange &change)
    {
      if (change.tuned_in)
        context.log.warning("changing " + change.entry + " against " +
                            squeal_of(peak) + " tunes in another pair: " +
                            text_of(*change.tuned_in, change.tuned_in_at));
    }

    /** That no change holds, among those that were checked. */
    void
    warn_of_none(RunContext                        &context,
                 const PeakPair                    &peak,
                 const std::vector<StoppingChange> &changes)
    {
      const auto n_found =
        std::count_if(changes.begin(),
                      changes.end(),
                      [](const StoppingChange &c) { return c.share != 0.; });
      if (n_found <= most_checks)
        context.log.warning("no single change within Sweep/Largest change "
                            "stops " +
                            squeal_of(peak));
      else
        context.log.warning(
          "none of the " + std::to_string(most_checks) +
          " smallest changes that were checked by direct solutions stops " +
          squeal_of(peak) + "; " + std::to_string(n_found - most_checks) +
          " others were not checked");
    }
  } // namespace



  Table
  suggestion_table(const SweepModel    &model,
                   const SweepSolution &solution,
                   RunContext          &context)
  {
    Timers::Section        section(context.timers, "Solve: suggestions");
    const SweepGrid       &grid    = model.grid();
    const SweepParameters &p       = context.parameters.sweep;
    Table                  table   = empty_suggestions(grid);
    const auto             targets = worst_ranges(solution, p.suggestions);
    Progress               progress(context.log, "suggestions", targets.size());
    for (const auto &[line, range] : targets)
      {
        progress.advance();
        const auto peak = peak_pair(model, *line, *range);
        if (!peak)
          continue;
        const ChangedScene scene(model, *peak, p.largest_change);
        const auto         changes = changes_for(
          scene, influences(model, *peak, p.sensitivities), p.largest_change);
        bool is_settled = false;
        for (std::size_t k = 0; k < changes.size(); ++k)
          {
            const StoppingChange       &change = changes[k];
            const bool                  exists = change.share != 0.;
            std::optional<DirectAnswer> direct;
            if (exists && !is_settled && k < most_checks)
              direct = scene.solve_directly(change);
            if (direct && direct->is_stable())
              {
                is_settled = true;
                warn_of_tuning(context, *peak, change);
              }
            std::vector<Cell> row = fixed_values(grid, line->start);
            row.insert(row.end(),
                       {line->branch_names[range->branch],
                        range->peak_at,
                        peak->frequency(),
                        peak->sigma(),
                        k + 1,
                        change.entry,
                        change.value,
                        exists ? Cell(change.new_value()) : Cell(),
                        exists ? Cell(100. * change.share) : Cell(),
                        exists ? sigma_cell(change.worst) : Cell(),
                        exists ? Cell(100. * change.up_to) : Cell(),
                        direct ? sigma_cell(direct->worst) : Cell(),
                        direct && direct->worst ? Cell(direct->worst->frequency)
                                                : Cell(),
                        direct   ? verdict_of(*direct)
                        : exists ? "not checked"
                                 : "none within Largest change",
                        change.tuned_in
                          ? text_of(*change.tuned_in, change.tuned_in_at)
                          : ""});
            table.add_row(row);
          }
        if (!is_settled)
          warn_of_none(context, *peak, changes);
      }
    return table;
  }
} // namespace squeal
