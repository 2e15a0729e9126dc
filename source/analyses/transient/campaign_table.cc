// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/campaign_table.h>
#include <squeal/output/judged_force.h>
#include <squeal/parameters/choices.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** The branch that the comparison is about: the largest sigma of the whole
     * model. */
    const BranchResult *
    leading_branch(const TransientFigures &f)
    {
      return f.leading >= 0 ? &f.branches[f.leading] : nullptr;
    }

    using Columns = std::vector<Table::Column>;

    Columns
    comparison_columns()
    {
      return {
        {"contact_state", Type::text, "", "closed and all nodes"},
        {"integrator", Type::text, "", ""},
        {"sigma_cea_per_s", Type::real, "1/s", "whole model"},
        {"growth_rate_per_s", Type::real, "1/s", "linear phase"},
        {"growth_rate_ci_per_s",
         Type::real,
         "1/s",
         "95 % and the time step's part",
         3},
        {"frequency_cea_hz", Type::real, "Hz", "whole model", 7},
        {"frequency_transient_hz", Type::real, "Hz", "linear phase", 7},
        {"e_foldings", Type::real, "", "within the window", 3},
        {"sigma_reduced_per_s", Type::real, "1/s", "reduced model"},
        {"rate_difference",
         Type::real,
         "",
         "over the larger of 2 % and 3 1/s",
         3},
        {"frequency_difference_rel", Type::real, "", "", 2},
        {"worst_imbalance", Type::real, "", "of the energy ledger", 2},
        {"steps_per_second", Type::real, "1/s", "of one core", 4},
        {"sigma_full_contact_per_s", Type::real, "1/s", "whole face, reduced"}};
    }

    Columns
    cycle_columns()
    {
      return {
        {"stable", Type::text, "", "about steady sliding: yes, no, undecided"},
        {"growth_rate_per_s", Type::real, "1/s", "linear phase"},
        {"frequency_hz", Type::real, "Hz", "of the period", 6},
        {"rms_normal_n", Type::real, "N", "about the mean"},
        {"min_normal_n", Type::real, "N", ""},
        {"max_normal_n", Type::real, "N", ""},
        {"separates", Type::text, "", "all nodes are open at a time"},
        {"sigma_linear_per_s",
         Type::real,
         "1/s",
         "of the linearised motion, by the reduced model"},
        {"max_slip_speed_ratio", Type::real, "", "over |V| of its pair", 4},
        {"stick_fraction", Type::real, "", "of closed node-time", 4},
        {"rms_pad_acceleration", Type::real, "m/s2", "", 4},
        {"frequency_linear_hz", Type::real, "Hz", "of that sigma", 6},
        {"n_closed", Type::integer, "", "nodes in steady sliding"},
        {"n_unstable", Type::integer, "", "pairs of the band"},
        {"limit_cycle", Type::text, "", "the second half is steady"},
        {"worst_imbalance", Type::real, "", "of the energy ledger", 2},
        {"steps_per_second", Type::real, "1/s", "of one core", 4},
        {"unstable_pairs", Type::text, "", "Hz (1/s), about the contact"},
        {"integrator", Type::text, "", ""},
        {"frequency_ci_hz", Type::real, "Hz", "of the quarters", 2},
        {"largest_line_hz", Type::real, "Hz", "of the force that is judged", 6},
        {"sigma_full_contact_per_s", Type::real, "1/s", "whole face closed", 4},
        {"macroscopic_friction", Type::real, "", "mean friction over normal"},
        {"phase_deg", Type::real, "deg", "tangential against normal", 4},
        {"repetition", Type::real, "", "of the normal force", 3},
        {"leading_edge_factor",
         Type::real,
         "",
         "pressure there over the mean one in steady sliding, all pairs",
         4},
        {"n_unknowns", Type::integer, "", "of the finite elements"},
        {"n_modes", Type::integer, "", "that move in the reduced model"},
        {"rms_normal_change_n",
         Type::real,
         "N",
         "of the rms from the first to the second half of its time",
         3}};
    }

    Columns
    trigger_columns()
    {
      return {
        {"outcome",
         Type::text,
         "",
         "of the trigger: squeal by itself, after it (a limit cycle that may "
         "stand beside stable sliding), temporary, none"},
        {"before_trigger_n", Type::real, "N", "rms of the normal force", 3},
        {"after_trigger_n", Type::real, "N", "the tenth that follows", 3},
        {"end_n", Type::real, "N", "the last tenth of the run", 3},
        {"lasting_s", Type::real, "s", "above 10 % of the mean force", 3}};
    }



    std::vector<Cell>
    comparison_cells(const CampaignRun       &run,
                     const PreparedTransient &prepared,
                     const TransientFigures  &f)
    {
      const BranchResult *b     = leading_branch(f);
      const double        nan   = std::nan("");
      const bool          fit   = b && b->fit.is_valid;
      const double        sigma = b ? b->sigma_cea : nan,
                   rate         = fit ? b->fit.rate : nan,
                   freq         = fit ? b->fit.frequency : nan;
      std::vector<Cell> cells;
      cells.emplace_back(std::to_string(prepared.steady.n_closed()) + " of " +
                         std::to_string(prepared.steady.status.size()));
      cells.emplace_back(choice_name(run.parameters.transient.integrator));
      for (const double value :
           {sigma,
            rate,
            fit ? b->fit.rate_ci : nan,
            b ? b->frequency_cea : nan,
            freq,
            fit ? b->fit.e_foldings() : nan,
            b ? b->sigma : nan,
            std::abs(rate - sigma) / std::max(0.02 * std::abs(sigma), 3.),
            b ? std::abs(freq / b->frequency_cea - 1.) : nan,
            f.worst_imbalance,
            f.steps_per_second,
            sigma_with_full_contact(prepared, run.parameters)})
        cells.push_back(or_missing(value));
      return cells;
    }

    /** Number of unstable pairs, and their text: "3417 (382); 6583 (207)". */
    std::pair<unsigned int, std::string>
    unstable_pairs(const TransientFigures &f)
    {
      std::string  pairs;
      unsigned int n = 0;
      for (const auto &branch : f.branches)
        if (branch.sigma > 0.)
          {
            ++n;
            pairs += (pairs.empty() ? "" : "; ") +
                     rounded_text(branch.frequency, 4) + " (" +
                     rounded_text(branch.sigma, 3) + ")";
          }
      return {n, n == 0 ? "none" : pairs};
    }

    std::vector<Cell>
    cycle_cells(const CampaignRun       &run,
                const PreparedTransient &prepared,
                const TransientFigures  &f)
    {
      const BranchResult *b          = leading_branch(f);
      const double        nan        = std::nan("");
      const auto [n_unstable, pairs] = unstable_pairs(f);
      const auto vibrating           = [&](const double value) {
        return f.vibrates ? or_missing(value) : Cell();
      };
      const auto of_lines = [&](const double value) {
        return f.beyond_samples > 0. ? Cell() : vibrating(value);
      };
      return {
        f.verdict == "unstable" ? "no"
        : f.verdict == "stable" ? "yes"
                                : "undecided",
        or_missing(b && b->fit.is_valid ? b->fit.rate : nan),
        of_lines(f.frequency),
        f.rms_normal,
        f.min_normal,
        f.max_normal,
        f.separates ? "yes" : "no",
        or_missing(b ? b->sigma : nan),
        f.max_slip_speed_ratio,
        f.stick_fraction,
        f.rms_acceleration,
        or_missing(b ? b->frequency : nan),
        prepared.steady.n_closed(),
        n_unstable,
        f.has_limit_cycle ? "yes" : "no",
        f.worst_imbalance,
        f.steps_per_second,
        pairs,
        choice_name(run.parameters.transient.integrator),
        vibrating(f.frequency_ci),
        of_lines(f.largest_line),
        or_missing(sigma_with_full_contact(prepared, run.parameters)),
        or_missing(f.macroscopic_friction),
        or_missing(f.phase),
        vibrating(f.repetition),
        or_missing(leading_edge_factor(
          ForceSums(prepared.pressed.nodes()).of(prepared.steady.forces))),
        prepared.pressed.n_unknowns(),
        prepared.pressed.model().n_modes(),
        or_missing(f.rms_change)};
    }

    std::vector<Cell>
    trigger_cells(const TriggerOutcome &trigger)
    {
      return {trigger.text,
              trigger.before,
              trigger.after,
              trigger.end,
              trigger.lasting};
    }

    Cell
    judged_beside_sums(const JudgedPair &pair)
    {
      return judged_force_cell(pair.is_beside_sums() ? pair.force_name : "");
    }

    bool
    has_several_pairs(const Parameters &p)
    {
      return p.scene.contacts.size() > 1;
    }
  } // namespace



  Table
  campaign_columns(const Parameters &p)
  {
    Table table;
    for (const auto &axis : p.sweep.axes)
      table.add_column(
        {axis.name, Type::real, shown_unit(axis, p.scene), axis.entries[0]});
    table.add_column({"top", Type::text, "", "kind of the support"});
    const bool compares = p.transient.compare_with_cea;
    for (const auto &column : compares ? comparison_columns() : cycle_columns())
      table.add_column(column);
    if (!compares && has_trigger(p.transient))
      for (const auto &column : trigger_columns())
        table.add_column(column);
    if (!compares && has_several_pairs(p))
      table.add_column(
        {"loudest_pair", Type::text, "", "whose vibration this is"});
    if (!compares && has_several_pairs(p) && has_trigger(p.transient))
      table.add_column(
        {"outcome_pair", Type::text, "", "whose outcome this is"});
    if (!compares)
      table.add_column(judged_force_column("judged_force"));
    if (!compares)
      table.add_column({"judged_share",
                        Type::real,
                        "",
                        "what the judged force has of the normal force",
                        4});
    if (!compares && has_trigger(p.transient))
      table.add_column(judged_force_column("outcome_judged_force"));
    return table;
  }



  std::vector<Cell>
  campaign_row(const CampaignRun       &run,
               const PreparedTransient &prepared,
               const TransientRecord   &record,
               const TransientFigures  &f)
  {
    const auto       &t = run.parameters.transient;
    std::vector<Cell> row(run.shown.begin(), run.shown.end());
    row.emplace_back(run.top);
    const auto append = [&](const std::vector<Cell> &cells) {
      row.insert(row.end(), cells.begin(), cells.end());
    };
    append(t.compare_with_cea ? comparison_cells(run, prepared, f)
                              : cycle_cells(run, prepared, f));
    if (t.compare_with_cea)
      return row;
    const TriggerOutcome trigger = evaluate_trigger(record, f, t);
    if (has_trigger(t))
      append(trigger_cells(trigger));
    if (has_several_pairs(run.parameters))
      row.emplace_back(f.loudest.name);
    if (has_several_pairs(run.parameters) && has_trigger(t))
      row.emplace_back(trigger.pair.name);
    row.push_back(judged_beside_sums(f.loudest));
    row.emplace_back(f.loudest.share);
    if (has_trigger(t))
      row.push_back(judged_beside_sums(trigger.pair));
    return row;
  }

  std::vector<Cell>
  row_without_sliding(const CampaignRun &run, const Table &table)
  {
    std::vector<Cell> row(run.shown.begin(), run.shown.end());
    row.emplace_back(run.top);
    row.emplace_back("no steady sliding");
    row.resize(table.columns().size());
    return row;
  }

} // namespace squeal
