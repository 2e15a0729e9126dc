// SPDX-License-Identifier: LGPL-2.1-or-later

// What to change to stop a squeal.

#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/model/contact_states.h>
#include <squeal/sweep/sensitivity.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** What a derivative is the slope of over this share to either side. */
    constexpr double one_per_cent = 0.01;

    /** Whether steady sliding at a peak, with a number one per cent larger or
     * smaller, has another contact than the derivatives hold. */
    bool
    changes_contact(const ChangedContact &contact,
                    const SweepModel     &model,
                    const PeakPair       &peak,
                    const unsigned int    number)
    {
      const auto held = model.contact_at(peak.point);
      for (const double factor : {1. - one_per_cent, 1. + one_per_cent})
        if (!contact.is_that(model.grid().scene(peak.point, number, factor),
                             held))
          return true;
      return false;
    }

    void
    warn_of_contact(const unsigned int n,
                    const Table       &table,
                    RunContext        &context)
    {
      if (n > 0)
        context.log.warning(
          std::to_string(n) + " of the " + std::to_string(table.n_rows()) +
          " derivatives in sensitivities.csv hold a contact state that one per "
          "cent of the number changes (contact_changes = 1): growth rates jump "
          "where it does; an axis of the number shows them");
    }
  } // namespace



  std::optional<PeakPair>
  peak_pair(const SweepModel    &model,
            const SweepLine     &line,
            const UnstableRange &range)
  {
    PeakPair result;
    result.point    = line.start;
    result.point[0] = range.peak_at;
    result.pairs =
      solve_point_refined(model.reduced(),
                          result.point,
                          model.system().coefficients(result.point),
                          model.band());
    double best = 1e300;
    for (unsigned int i = 0; i < result.pairs.size(); ++i)
      if (const double d = std::hypot(
            result.pairs.sigma(i) - range.peak_sigma,
            2. * M_PI * (result.pairs.frequency(i) - range.peak_frequency));
          d < best)
        {
          best         = d;
          result.index = i;
        }
    if (best == 1e300)
      return {};
    return result;
  }



  std::vector<Influence>
  influences(const SweepModel               &model,
             const PeakPair                 &peak,
             const std::vector<std::string> &wanted)
  {
    const SweepGrid         &grid    = model.grid();
    std::vector<std::string> entries = grid.entries();
    entries.insert(
      entries.end(), grid.other_entries().begin(), grid.other_entries().end());
    std::vector<Influence> result;
    for (unsigned int e = 0; e < entries.size(); ++e)
      {
        if (std::find(wanted.begin(), wanted.end(), entries[e]) == wanted.end())
          continue;
        const std::complex<double> d = sensitivities(model.reduced(),
                                                     model.system(),
                                                     peak.point,
                                                     peak.pairs,
                                                     e)[peak.index];
        result.push_back({e,
                          entries[e],
                          grid.entry_value(peak.point, e),
                          0.01 * d.real(),
                          0.01 * d.imag() / (2. * M_PI)});
      }
    std::stable_sort(
      result.begin(), result.end(), [](const auto &a, const auto &b) {
        return std::abs(a.sigma) > std::abs(b.sigma);
      });
    return result;
  }



  Table
  sensitivity_table(const SweepModel    &model,
                    const SweepSolution &solution,
                    RunContext          &context)
  {
    Timers::Section  section(context.timers, "Solve: sensitivities");
    const SweepGrid &grid = model.grid();
    Table            table;
    add_fixed_axes(table, grid);
    for (const Table::Column &column : std::vector<Table::Column>{
           {"branch", Type::text, "", "unstable branch"},
           {"coordinate", Type::real, "", "of its peak on the first axis", 6},
           {"frequency_hz", Type::real, "Hz", "there", 6},
           {"sigma_per_s", Type::real, "1/s", "there", 5},
           {"rank", Type::integer, "", "1: the most influential"},
           {"entry", Type::text, "", "number of the scene"},
           {"value", Type::real, "", "of the entry, SI units", 5},
           {"dsigma_per_percent",
            Type::real,
            "1/s",
            "for one per cent more",
            4},
           {"dfrequency_per_percent",
            Type::real,
            "Hz",
            "for one per cent more",
            4},
           {"percent_to_zero",
            Type::real,
            "",
            "change that would bring sigma to 0 if it went on like this",
            3}})
      table.add_column(column);
    std::optional<ChangedContact> contact;
    if (model.has_contact_states())
      {
        contact.emplace(model.run_parameters(), context.timers);
        table.add_column({"contact_changes",
                          Type::integer,
                          "",
                          "1: one per cent of the number changes the contact "
                          "state, which the derivative holds"});
      }
    unsigned int n_changes = 0;
    for (const auto &line : solution.lines)
      for (const auto &range : line.ranges)
        {
          const auto peak = peak_pair(model, line, range);
          if (!peak)
            continue;
          const auto found =
            influences(model, *peak, context.parameters.sweep.sensitivities);
          for (std::size_t k = 0; k < found.size(); ++k)
            {
              std::vector<Cell> row = fixed_values(grid, line.start);
              const Influence  &f   = found[k];
              row.insert(
                row.end(),
                {line.branch_names[range.branch],
                 range.peak_at,
                 peak->frequency(),
                 peak->sigma(),
                 k + 1,
                 f.entry,
                 f.value,
                 f.sigma,
                 f.frequency,
                 f.sigma == 0. ? Cell() : Cell(-peak->sigma() / f.sigma)});
              if (contact)
                {
                  const bool changes =
                    changes_contact(*contact, model, *peak, f.number);
                  row.emplace_back(changes ? 1 : 0);
                  n_changes += changes;
                }
              table.add_row(row);
            }
        }
    warn_of_contact(n_changes, table, context);
    return table;
  }
} // namespace squeal
