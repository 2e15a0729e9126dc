// SPDX-License-Identifier: LGPL-2.1-or-later

// What is left of the limit cycles of several growing pairs.

#include <squeal/analyses/limit_cycle/cycle_campaign.h>
#include <squeal/analyses/limit_cycle/cycle_columns.h>
#include <squeal/output/judged_force.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** Cycles are the same within these shares and their errors. */
    constexpr double same_frequency = 1e-3, same_rms = 1e-2;

    /** Multipliers above this, less their error, are those of an unstable
     * cycle whatever motions do: below it they can be off by more. */
    constexpr double largest_of_stable = 1.01;

    bool
    agree(const double a,
          const double b,
          const double share,
          const double error)
    {
      return std::abs(a - b) <=
             share * std::max(std::abs(a), std::abs(b)) + error;
    }

    /** Whether the forces and moments of every pair, and the forces of all
     * together, are as large. */
    bool
    have_same_forces(const CycleResult &a, const CycleResult &b)
    {
      const auto forces = [](const CycleFigures &f) {
        std::vector<double>       result  = f.rms_of_pairs();
        const std::vector<double> moments = f.moments_of_pairs();
        result.insert(result.end(), moments.begin(), moments.end());
        result.push_back(f.rms_together);
        return result;
      };
      const std::vector<double> fine_a   = forces(a.figures),
                                fine_b   = forces(b.figures),
                                coarse_a = forces(a.coarse_figures),
                                coarse_b = forces(b.coarse_figures);
      const double size = std::max(a.figures.rms_normal, b.figures.rms_normal);
      for (std::size_t p = 0; p < fine_a.size(); ++p)
        if (std::abs(fine_a[p] - fine_b[p]) >
            same_rms * size + error_by_steps(fine_a[p], coarse_a[p]) +
              error_by_steps(fine_b[p], coarse_b[p]))
          return false;
      return true;
    }

    /** Motions, whichever multiple of their shortest period was found. */
    bool
    are_same(const CycleResult &a, const CycleResult &b)
    {
      const double times_a = a.figures.repetitions(),
                   times_b = b.figures.repetitions();
      return agree(times_a * a.figures.frequency,
                   times_b * b.figures.frequency,
                   same_frequency,
                   times_a * a.frequency_error() +
                     times_b * b.frequency_error()) &&
             have_same_forces(a, b);
    }

    struct PointRow
    {
      const std::vector<CycleResult> &cycles;
      const std::vector<MotionTrial> &trials; /**< the last from the cycle */
      CycleOutcome                    outcome;
      std::complex<double> outside = 0.; /**< growth outside the band, 1/s */

      const CycleResult *
      heard() const
      {
        return outcome.heard < 0 ? nullptr : &cycles[outcome.heard];
      }
      /** The pair of the largest growth rate; the cycles are in that order. */
      const CycleResult *
      fastest() const
      {
        return cycles.empty() ? nullptr : &cycles.front();
      }
    };

    /** Whether the motions of all pairs last without coming back. */
    bool
    has_no_period(const std::vector<CycleResult> &cycles)
    {
      return std::all_of(cycles.begin(), cycles.end(), [](const auto &c) {
        return c.coarse.status == CycleStatus::aperiodic;
      });
    }

    /** Whether motions from elsewhere were followed and all are known to end
     * elsewhere. */
    bool
    is_never_reached(const std::vector<MotionTrial> &trials)
    {
      return trials.size() > 1 && std::all_of(trials.begin(),
                                              trials.end() - 1,
                                              [](const MotionTrial &x) {
                                                return x.ends_elsewhere();
                                              });
    }

    using PointColumn = ColumnOf<PointRow>;

    /** Of one of the cycles, if there is one. */
    PointColumn
    of(const Table::Column &declaration,
       const CycleResult *(PointRow::*which)() const,
       const std::function<double(const CycleResult &)> &value)
    {
      return {declaration, [which, value](const PointRow &row) {
                const CycleResult *c = (row.*which)();
                return c ? Cell(value(*c)) : Cell();
              }};
    }

    std::vector<PointColumn>
    count_columns()
    {
      const auto count = [](std::size_t CycleOutcome::*number) {
        return
          [number](const PointRow &row) { return Cell(row.outcome.*number); };
      };
      return {
        {{"outcome", Type::text, "", "of all growing pairs"},
         [](const PointRow &row) { return Cell(row.outcome.text); }},
        {{"n_growing", Type::integer, "", "pairs about steady sliding"},
         [](const PointRow &row) { return Cell(row.cycles.size()); }},
        {{"n_converged",
          Type::integer,
          "",
          "growing pairs from which a periodic motion was found"},
         count(&CycleOutcome::n_converged)},
        {{"n_different", Type::integer, "", "periodic motions among them"},
         count(&CycleOutcome::n_different)},
        {{"n_stable", Type::integer, "", "stable ones"},
         count(&CycleOutcome::n_stable)}};
    }

    /** What grows outside the band, where it is the fastest. */
    std::vector<PointColumn>
    outside_columns()
    {
      const auto of_outside = [](const Table::Column &declaration, auto value) {
        return PointColumn{declaration, [value](const PointRow &row) {
                             return row.outside.real() > 0.
                                      ? Cell(value(row.outside))
                                      : Cell();
                           }};
      };
      using Lambda = std::complex<double>;
      return {
        of_outside({"outside_hz",
                    Type::real,
                    "Hz",
                    "of the motion outside the band that grows fastest "
                    "of all"},
                   [](const Lambda &x) { return x.imag() / (2. * M_PI); }),
        of_outside(
          {"outside_sigma_per_s", Type::real, "1/s", "its growth rate"},
          [](const Lambda &x) { return x.real(); })};
    }

    std::vector<PointColumn>
    trial_columns()
    {
      const auto where = [](const Table::Column &declaration, auto value) {
        return PointColumn{declaration, [value](const PointRow &row) {
                             return row.trials.empty()
                                      ? Cell()
                                      : Cell(value(row.trials));
                           }};
      };
      using Trials       = std::vector<MotionTrial>;
      const auto counted = [](bool MotionTrial::*what) {
        return [what](const Trials &t) -> std::size_t {
          return std::count_if(
            t.begin(), t.end() - 1, [what](const MotionTrial &x) {
              return x.*what;
            });
        };
      };
      return {where({"n_starts",
                     Type::integer,
                     "",
                     "motions from other starts that were followed"},
                    [](const Trials &t) { return t.size() - 1; }),
              where({"n_ending_in_cycle",
                     Type::integer,
                     "",
                     "those that end in the cycle that is heard"},
                    counted(&MotionTrial::ends_in)),
              where({"n_undecided",
                     Type::integer,
                     "",
                     "those that were still on their way to it"},
                    counted(&MotionTrial::is_undecided)),
              where({"stays",
                     Type::text,
                     "",
                     "whether a motion that starts on that cycle stays there"},
                    [](const Trials &t) {
                      return std::string(t.back().ends_in ? "yes" : "no");
                    }),
              where({"growth_ends_in_cycle",
                     Type::text,
                     "",
                     "whether what small disturbances of steady sliding grow "
                     "to ends in that cycle"},
                    growth_ends_in_cycle)};
    }

    std::vector<PointColumn>
    columns(const std::vector<std::string> &pairs)
    {
      std::vector<PointColumn>       result = count_columns();
      const std::vector<PointColumn> more   = {
          of({"fastest_pair_hz",
              Type::real,
              "Hz",
              "frequency of the pair of the largest growth rate"},
           &PointRow::fastest,
           [](const CycleResult &c) { return c.pair.imag() / (2. * M_PI); }),
          of({"fastest_sigma_per_s", Type::real, "1/s", "its growth rate"},
           &PointRow::fastest,
           [](const CycleResult &c) { return c.pair.real(); }),
          of({"frequency_hz",
              Type::real,
              "Hz",
              "1/period of the motion that is heard",
              8},
           &PointRow::heard,
           [](const CycleResult &c) { return c.figures.frequency; }),
          of({"frequency_error_hz",
              Type::real,
              "Hz",
              "twice the difference to half the steps",
              3},
           &PointRow::heard,
           [](const CycleResult &c) { return c.frequency_error(); }),
          of({"dominant_line_hz",
              Type::real,
              "Hz",
              "largest harmonic of its normal force"},
           &PointRow::heard,
           [](const CycleResult &c) {
             return c.figures.largest_harmonic * c.figures.frequency;
           }),
          of({"rms_normal_n", Type::real, "N", "of its normal force"},
           &PointRow::heard,
           [](const CycleResult &c) { return c.figures.rms_normal; }),
          of({"rms_normal_error_n",
              Type::real,
              "N",
              "twice the difference of the harmonics to half the steps",
              3},
           &PointRow::heard,
           [](const CycleResult &c) { return c.rms_normal_error(); }),
          {judged_force_column("judged_force"),
           [](const PointRow &row) {
           const CycleResult *c = row.heard();
           return judged_force_cell(c ? c->figures.judged_force : "");
         }},
          of({"min_normal_n", Type::real, "N", "least normal force"},
           &PointRow::heard,
           [](const CycleResult &c) { return c.figures.min_normal; }),
          of({"max_normal_n", Type::real, "N", "largest normal force"},
           &PointRow::heard,
           [](const CycleResult &c) { return c.figures.max_normal; }),
          of({"largest_multiplier", Type::real, "", "its stability"},
           &PointRow::heard,
           [](const CycleResult &c) { return c.multipliers.largest; }),
          of({"largest_multiplier_error",
              Type::real,
              "",
              "its stability is open where the multiplier is nearer to 1",
              3},
           &PointRow::heard,
           [](const CycleResult &c) { return c.multipliers.uncertainty(); })};
      result.insert(result.end(), more.begin(), more.end());
      const std::vector<PointColumn> trials = trial_columns();
      result.insert(result.end(), trials.begin(), trials.end());
      const std::vector<PointColumn> of_pairs =
        of_each_pair<PointRow>(pairs, [](const PointRow &row) {
          const CycleResult *c = row.heard();
          return c ? &c->figures : nullptr;
        });
      result.insert(result.end(), of_pairs.begin(), of_pairs.end());
      const std::vector<PointColumn> outside = outside_columns();
      result.insert(result.end(), outside.begin(), outside.end());
      return result;
    }
  } // namespace



  CycleOutcome
  outcome_of(const std::vector<CycleResult> &cycles)
  {
    CycleOutcome     result;
    std::vector<int> different;
    for (int i = 0; i < static_cast<int>(cycles.size()); ++i)
      if (cycles[i].has_converged())
        {
          ++result.n_converged;
          bool is_new = true;
          for (const int k : different)
            is_new = is_new && !are_same(cycles[i], cycles[k]);
          if (!is_new)
            continue;
          different.push_back(i);
          if (cycles[i].multipliers.is_stable())
            {
              ++result.n_stable;
              if (result.heard < 0 || cycles[result.heard].figures.rms_normal <
                                        cycles[i].figures.rms_normal)
                result.heard = i;
            }
          else if (!cycles[i].multipliers.is_unstable())
            result.open.push_back(i);
        }
    result.n_different = different.size();
    if (result.n_stable == 0 && result.open.size() == 1)
      result.heard = result.open.front();
    result.text = cycles.empty()           ? "steady sliding"
                  : result.n_stable > 1    ? "several stable limit cycles"
                  : result.n_stable == 1   ? "stable limit cycle"
                  : !result.open.empty()   ? "limit cycle, stability open"
                  : result.n_converged > 0 ? "limit cycles found are unstable"
                  : has_no_period(cycles)  ? "no period"
                                           : "no limit cycle found";
    return result;
  }

  Table
  outcome_table(const std::vector<CycleResult> &cycles,
                const PointTrials              &trials,
                const std::vector<std::string> &pairs,
                const std::complex<double>      outside)
  {
    CycleOutcome outcome = outcome_of(cycles);
    if (cycles.empty() && outside.real() > 0.)
      outcome.text = "steady sliding in the band, growth outside";
    const bool all_end_there =
      trials.cycle >= 0 &&
      std::all_of(trials.motions.begin(),
                  trials.motions.end(),
                  [](const MotionTrial &x) { return x.ends_in; });
    // What is unstable by far is no attractor, however long motions stay near.
    const bool is_far_from_stable =
      trials.cycle >= 0 && cycles[trials.cycle].multipliers.largest -
                               cycles[trials.cycle].multipliers.uncertainty() >
                             largest_of_stable;
    if (all_end_there)
      outcome.heard = is_far_from_stable ? -1 : trials.cycle;
    else if (trials.cycle >= 0 && !outcome.open.empty())
      outcome.heard = is_never_reached(trials.motions) ? -1 : trials.cycle;
    if (all_end_there && outcome.n_stable == 0)
      outcome.text = is_far_from_stable
                       ? "unstable limit cycle that motions stay near"
                       : "limit cycle, stable in time";
    // Linearised once round the cycle and followed for long do not agree.
    if (trials.cycle >= 0 && !trials.motions.empty() &&
        !trials.motions.back().ends_in && outcome.n_stable == 1 &&
        cycles[trials.cycle].multipliers.is_stable())
      outcome.text = "stable limit cycle, left by the motion from it";
    return table_of(
      columns(pairs),
      std::vector<PointRow>{{cycles, trials.motions, outcome, outside}});
  }

  Table
  outcome_without_sliding(const std::vector<std::string> &pairs)
  {
    CycleOutcome outcome;
    outcome.text = "no steady sliding";
    const std::vector<CycleResult> none;
    const std::vector<MotionTrial> not_followed;
    return table_of(columns(pairs),
                    std::vector<PointRow>{{none, not_followed, outcome, 0.}});
  }
} // namespace squeal
