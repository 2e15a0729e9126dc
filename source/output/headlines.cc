// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/output/headlines.h>
#include <squeal/output/open_signs.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Four digits without zeros at the end. */
    std::string
    brief(const double value)
    {
      const std::string text = shortest_text(std::stod(rounded_text(value, 4)));
      // Not 177800000, which nobody counts.
      return text.size() > 7 && text.find_first_of(".e") == std::string::npos
               ? rounded_text(value, 4)
               : text;
    }

    std::string
    percent(const double share)
    {
      return rounded_text(100. * share, 3);
    }

    /** "mu = 0.2", with the unit of the entry. */
    std::string
    with_value(const SweepAxisParameters &axis,
               const SceneParameters     &scene,
               const double               value)
    {
      const std::string unit = unit_of_entry(axis.entries.at(0), scene);
      return symbol_of_entries(axis.entries, scene) + " = " + brief(value) +
             (unit.empty() ? "" : " " + unit);
    }

    /** The values of the axes of a run, in words. */
    std::string
    run_name(const Table           &table,
             const std::size_t      row,
             const SweepParameters &sweep,
             const SceneParameters &scene)
    {
      std::string name;
      for (const auto &axis : sweep.axes)
        if (table.has_column(axis.name))
          {
            // in the unit of the table, which may be another one than the
            // entry's
            const std::string unit =
              table.columns()[table.column_index(axis.name)].unit;
            name += (name.empty() ? "" : ", ") +
                    symbol_of_entries(axis.entries, scene) + " = " +
                    brief(table.real(row, axis.name)) +
                    (unit.empty() ? "" : " " + unit);
          }
      if (table.has_column("top") && !table.text(row, "top").empty())
        name += (name.empty() ? "top " : ", top ") + table.text(row, "top");
      return name;
    }

    /** The largest value of a column; NaN without any. */
    double
    largest(const Table &table, const std::string &column)
    {
      double value = std::nan("");
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        if (!table.is_missing(i, column) &&
            !(std::abs(table.real(i, column)) <= value))
          value = std::abs(table.real(i, column));
      return value;
    }
  } // namespace



  std::string
  scatter_headline(const Table &t)
  {
    if (t.n_rows() == 0)
      return "no samples were drawn";
    const double doubt = t.real(0, "undecided"),
                 held  = t.has_column("undecided_contact")
                           ? t.real(0, "undecided_contact")
                           : 0.;
    return "squeals in " + percent(t.real(0, "probability")) + " % of " +
           t.display(0, t.column_index("samples")) +
           " samples (95 %: " + percent(t.real(0, "lower_95")) + " to " +
           percent(t.real(0, "upper_95")) + " %); " +
           (held > 0. ? percent(held) +
                          " % of them lie between points of different contact "
                          "states and are undecided"
                      : "the sigma of " + percent(doubt) +
                          " % of them is below its own error");
  }



  std::string
  suggestion_headline(const Table &t, const SceneParameters &scene)
  {
    if (t.n_rows() == 0)
      return "nothing squeals: there is nothing to change";
    // the rows of the loudest pair come first, its smallest change leading
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      if (t.text(i, "verdict") == "stable")
        {
          const double      change = t.real(i, "change_percent");
          const std::string tuned  = t.text(i, "tunes_in");
          return (change > 0. ? "+" : "") + rounded_text(change, 3) + " % of " +
                 symbol_of_entries({t.text(i, "entry")}, scene) +
                 " ends the squeal at " +
                 rounded_text(t.real(i, "frequency_hz"), 5) + " Hz (sigma " +
                 rounded_text(t.real(i, "sigma_per_s"), 4) +
                 " 1/s; a direct solution with it: " +
                 rounded_text(t.real(i, "direct_sigma_per_s"), 3) + " 1/s)" +
                 (tuned.empty() ? ", and tunes in no other pair"
                                : ", and tunes in on the way " + tuned);
        }
    return "no single change that was tried ends the squeal at " +
           rounded_text(t.real(0, "frequency_hz"), 5) + " Hz";
  }



  std::string
  trigger_headline(const Table           &table,
                   const SweepParameters &sweep,
                   const SceneParameters &scene)
  {
    constexpr std::size_t most_named = 3;
    std::string           text;
    std::size_t           n_told = 0;
    for (const auto &[outcome, words] :
         {std::pair{"squeal by itself", "by itself"},
          {"squeal after the trigger", "after the trigger alone"},
          {"temporary after the trigger", "for a while after the trigger"}})
      {
        std::vector<std::string> runs;
        for (std::size_t i = 0; i < table.n_rows(); ++i)
          if (table.text(i, "outcome") == outcome)
            runs.push_back(run_name(table, i, sweep, scene));
        if (runs.empty())
          continue;
        n_told += runs.size();
        text +=
          (text.empty() ? "of " + counted(table.n_rows(), "run") + " " : "; ") +
          std::to_string(runs.size()) +
          (std::string(outcome).rfind("squeal", 0) == 0
             ? (runs.size() == 1 ? " squeals " : " squeal ")
             : (runs.size() == 1 ? " vibrates " : " vibrate ")) +
          words;
        if (runs.size() <= most_named)
          text += " (" + prm::join(runs, "; ") + ")";
      }
    std::size_t n_short = 0;
    for (std::size_t i = 0; i < table.n_rows(); ++i)
      n_short += table.text(i, "outcome") == "run too short";
    n_told += n_short;
    if (n_short > 0)
      text += (text.empty() ? "of " + counted(table.n_rows(), "run") + " "
                            : std::string("; ")) +
              std::to_string(n_short) + (n_short == 1 ? " ends" : " end") +
              " too soon after the trigger to tell";
    if (text.empty())
      text = "none of " + counted(table.n_rows(), "run") + " squeals";
    else if (n_told < table.n_rows())
      text += "; " + std::to_string(table.n_rows() - n_told) +
              (table.n_rows() - n_told == 1 ? " stays quiet" : " stay quiet");
    return text + "; largest imbalance of an energy ledger " +
           rounded_text(largest(table, "worst_imbalance"), 2);
  }



  std::string
  campaign_headline(const Table &t)
  {
    std::size_t n_unstable = 0, n_cycles = 0;
    double      low = HUGE_VAL, high = 0.;
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      {
        n_unstable += t.text(i, "stable") == "no";
        if (t.text(i, "limit_cycle") != "yes")
          continue;
        ++n_cycles;
        if (!t.is_missing(i, "frequency_hz"))
          {
            low  = std::min(low, t.real(i, "frequency_hz"));
            high = std::max(high, t.real(i, "frequency_hz"));
          }
      }
    std::string text = std::to_string(n_unstable) + " of " +
                       counted(t.n_rows(), "run") +
                       " unstable about steady sliding, " +
                       std::to_string(n_cycles) + " with a limit cycle";
    if (high > 0.)
      text += " at " + rounded_text(low, 4) +
              (high > low ? " to " + rounded_text(high, 4) : "") +
              " Hz, known to " +
              rounded_text(largest(t, "frequency_ci_hz"), 2) + " Hz";
    return text + "; largest imbalance of an energy ledger " +
           rounded_text(largest(t, "worst_imbalance"), 2);
  }



  std::string
  friction_headline(const Table           &t,
                    const SweepParameters &sweep,
                    const SceneParameters &scene)
  {
    const SweepAxisParameters &axis = sweep.axes.at(0);
    // rows of one value of all other axes, by their name
    std::vector<std::pair<std::string, std::vector<std::size_t>>> groups;
    SweepParameters others = sweep;
    others.axes.erase(others.axes.begin());
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      {
        if (t.is_missing(i, "macroscopic_friction"))
          continue;
        const std::string name = run_name(t, i, others, scene);
        auto              group =
          std::find_if(groups.begin(), groups.end(), [&](const auto &g) {
            return g.first == name;
          });
        if (group == groups.end())
          group = groups.insert(group, {name, {}});
        group->second.push_back(i);
      }
    std::vector<std::string> texts;
    for (const auto &[name, rows] : groups)
      {
        const auto friction = [&t](const std::size_t i) {
          return t.real(i, "macroscopic_friction");
        };
        const auto [least, most] =
          std::minmax_element(rows.begin(),
                              rows.end(),
                              [&](const std::size_t i, const std::size_t j) {
                                return friction(i) < friction(j);
                              });
        const std::string low  = rounded_text(friction(*least), 3),
                          high = rounded_text(friction(*most), 3);
        texts.push_back((name.empty() ? "" : name + ": ") +
                        (low == high
                           ? low + " throughout"
                           : low + " (at " + brief(t.real(*least, axis.name)) +
                               " m/s) to " + high + " (at " +
                               brief(t.real(*most, axis.name)) + " m/s)"));
      }
    return texts.empty()
             ? ""
             : "macroscopic friction over the speed: " + prm::join(texts, "; ");
  }



  std::string
  comparison_headline(const Table &t)
  {
    std::size_t n = 0, n_within = 0;
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      if (!t.is_missing(i, "rate_difference") &&
          std::isfinite(t.real(i, "rate_difference")))
        {
          ++n;
          n_within += t.real(i, "rate_difference") <= 1.;
        }
    if (n == 0)
      return "no growth rate of " + counted(t.n_rows(), "run") +
             " could be fitted";
    return std::to_string(n_within) + " of " + counted(n, "growth rate") +
           " in time within 2 % or 3 1/s of the eigenvalue analysis (largest "
           "difference " +
           rounded_text(largest(t, "rate_difference"), 2) +
           " of that), frequencies within " +
           rounded_text(100. * largest(t, "frequency_difference_rel"), 2) +
           " %; fits known to " +
           rounded_text(largest(t, "growth_rate_ci_per_s"), 2) + " 1/s" +
           (n < t.n_rows()
              ? "; " + counted(t.n_rows() - n, "run") + " without a rate"
              : "");
  }



  std::string
  work_headline(const Table &t)
  {
    std::size_t best = t.n_rows();
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      if (!t.is_missing(i, "dofs") &&
          (best == t.n_rows() || t.real(i, "dofs") < t.real(best, "dofs")))
        best = i;
    const auto is_within = [&t](const std::size_t i) {
      return t.has_column("found") && t.text(i, "found") == "by every rung";
    };
    if (t.n_rows() == 0 || best == t.n_rows())
      {
        std::string text = "no ladder tells what the asked error takes";
        for (std::size_t i = 0; i < t.n_rows(); ++i)
          if (is_within(i))
            text +=
              "; every rung of '" + t.text(i, "ladder") + "' is within it";
        return text;
      }
    std::string text =
      "an error of " + percent(t.real(best, "error_rel")) + " % takes " +
      rounded_text(t.real(best, "dofs"), 3) + " unknowns" +
      (t.is_missing(best, "seconds")
         ? ""
         : " and " + rounded_text(t.real(best, "seconds"), 3) + " s") +
      " by the ladder '" + t.text(best, "ladder") + "' (" +
      t.text(best, "found") + ")";
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      if (i != best)
        text += is_within(i)
                  ? "; every rung of '" + t.text(i, "ladder") + "' is within it"
                : t.is_missing(i, "dofs_over_least")
                  ? "; '" + t.text(i, "ladder") + "' does not reach it"
                  : "; " + rounded_text(t.real(i, "dofs_over_least"), 3) +
                      " times as many unknowns by '" + t.text(i, "ladder") +
                      "'";
    return text;
  }



  std::string
  figure_headline(const Table &t)
  {
    if (t.n_rows() == 0)
      return "no figure is there on two rungs of a ladder";
    std::size_t worst = 0, n_found = 0;
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      {
        if (t.real(i, "largest_error_rel") > t.real(worst, "largest_error_rel"))
          worst = i;
        n_found += t.text(i, "found") != "not found" &&
                   t.text(i, "found") != "extrapolated";
      }
    const auto named = [&](const std::size_t i) {
      return t.text(i, "figure") + " by the ladder '" + t.text(i, "ladder") +
             "'";
    };
    std::string text =
      "an error of " + percent(t.real(0, "error_rel")) + " % is reached by " +
      std::to_string(n_found) + " of " + std::to_string(t.n_rows()) +
      " figures of the ladders; largest error: " +
      percent(t.real(worst, "largest_error_rel")) + " % of " + named(worst) +
      ", " + percent(t.real(worst, "least_error_rel")) + " % on its best rung";
    std::size_t dearest = t.n_rows();
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      if (!t.is_missing(i, "seconds") &&
          (dearest == t.n_rows() ||
           t.real(i, "seconds") > t.real(dearest, "seconds")))
        dearest = i;
    if (dearest < t.n_rows())
      text += "; the dearest is " + named(dearest) + " with " +
              rounded_text(t.real(dearest, "seconds"), 3) + " s (" +
              t.text(dearest, "found") + ")";
    return text + "; errors are those against each ladder's finest rung";
  }



  std::string
  resonance_headline(const Table &t, const std::string &unit)
  {
    constexpr std::size_t    most_named = 3;
    constexpr double         same_mode  = 0.02; // of its frequency
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      if (!t.is_missing(i, "peak"))
        rows.push_back(i);
    std::stable_sort(
      rows.begin(), rows.end(), [&](const std::size_t i, const std::size_t j) {
        return t.real(i, "peak") > t.real(j, "peak");
      });
    // the same mode answers at many points and, somewhat moved, in several
    // states of the contact: each is named once
    std::vector<std::size_t> told;
    std::vector<std::string> texts;
    for (const std::size_t i : rows)
      {
        const double frequency = t.real(i, "frequency_hz");
        if (texts.size() == most_named ||
            std::any_of(told.begin(), told.end(), [&](const std::size_t j) {
              return t.text(i, "name") == t.text(j, "name") &&
                     std::abs(t.real(j, "frequency_hz") - frequency) <
                       same_mode * frequency;
            }))
          continue;
        told.push_back(i);
        texts.push_back(rounded_text(frequency, 5) + " Hz (" +
                        t.text(i, "name") + ", " +
                        rounded_text(t.real(i, "peak"), 3) + " " + unit + ")");
      }
    std::vector<std::string> endless;
    for (std::size_t i = 0; i < t.n_rows(); ++i)
      if (t.is_missing(i, "peak"))
        {
          const std::string text = rounded_text(t.real(i, "frequency_hz"), 5) +
                                   " Hz (" + t.text(i, "name") + ")";
          if (std::find(endless.begin(), endless.end(), text) == endless.end())
            endless.push_back(text);
        }
    const std::size_t n_endless = endless.size();
    endless.resize(std::min(n_endless, most_named));
    std::vector<std::string> parts;
    if (!texts.empty())
      parts.push_back("largest resonances: " + prm::join(texts, ", "));
    if (n_endless > 0)
      parts.push_back(
        "without damping, so that their peaks have no bound: " +
        prm::join(endless, ", ") +
        (n_endless > most_named
           ? " and " + std::to_string(n_endless - most_named) + " more"
           : ""));
    return parts.empty() ? "no resonance in the band" : prm::join(parts, "; ");
  }



  std::string
  range_headline(const Table           &t,
                 const SweepParameters &sweep,
                 const SceneParameters &scene,
                 const bool             is_meshed)
  {
    const SweepAxisParameters &axis = sweep.axes.at(0);
    const std::string          name = symbol_of_entries(axis.entries, scene);
    if (t.n_rows() == 0)
      return "stable over the whole range of " + name +
             (is_meshed ? std::string(" on this mesh; ") + growth_error_unknown
                        : "");
    std::size_t loudest = 0;
    for (std::size_t i = 1; i < t.n_rows(); ++i)
      if (t.real(i, "peak_sigma_per_s") > t.real(loudest, "peak_sigma_per_s"))
        loudest = i;
    const std::string unit  = unit_of_entry(axis.entries.at(0), scene);
    const bool        below = t.integer(loudest, "at_lower_limit") != 0,
               above        = t.integer(loudest, "at_upper_limit") != 0;
    const auto leaves       = [&](const std::string &column) {
      return t.has_column(column) && t.integer(loudest, column) != 0;
    };
    std::string text =
      (t.n_rows() == 1 ? "unstable for " : "loudest for ") + name + " from " +
      brief(t.real(loudest, "lower")) + " to " +
      brief(t.real(loudest, "upper")) + (unit.empty() ? "" : " " + unit) +
      (below && above ? " (all that was tried)"
       : below        ? " (from the lowest tried on)"
       : above        ? " (to the highest tried)"
                      : "") +
      (leaves("leaves_band_below") || leaves("leaves_band_above")
         ? " (and on, outside the frequency band)"
         : "");
    for (std::size_t a = 1; a < sweep.axes.size(); ++a)
      if (t.has_column(sweep.axes[a].name))
        text +=
          (a == 1 ? " at " : ", ") +
          with_value(sweep.axes[a], scene, t.real(loudest, sweep.axes[a].name));
    return text + ": sigma up to " +
           brief(t.real(loudest, "peak_sigma_per_s")) + " 1/s at " +
           rounded_text(t.real(loudest, "frequency_at_peak_hz"), 5) + " Hz";
  }
} // namespace squeal
