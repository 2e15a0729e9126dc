// SPDX-License-Identifier: LGPL-2.1-or-later

// Transients over the axes of `Sweep` and several tops, several at a time.

#include <squeal/base/exceptions.h>
#include <squeal/base/stop_request.h>
#include <squeal/driver/run_context.h>
#include <squeal/driver/transient_results.h>
#include <squeal/parameters/choices.h>
#include <squeal/results/chart.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <future>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;
    using Kind = SupportParameters::Kind;
    using Json = nlohmann::ordered_json;

    std::vector<double>
    axis_values(const SweepAxisParameters &a)
    {
      if (a.scale == SweepAxisParameters::Scale::list)
        return a.values;
      std::vector<double> result;
      for (unsigned int i = 0; i < a.number; ++i)
        {
          const double s = a.number > 1 ? double(i) / (a.number - 1) : 0.;
          result.push_back(a.scale == SweepAxisParameters::Scale::logarithmic
                             ? a.from[0] * std::pow(a.to[0] / a.from[0], s)
                             : (1. - s) * a.from[0] + s * a.to[0]);
        }
      return result;
    }

    bool
    is_friction(const SweepAxisParameters &a)
    {
      for (const auto &entry : a.entries)
        if (entry.find("/Friction coefficient") == std::string::npos)
          return false;
      return true;
    }

    /** What a table shows of a value: names tell. */
    double
    shown_value(const std::string &axis, const double value)
    {
      if (axis.rfind("log10_", 0) == 0)
        return std::log10(value);
      return axis.size() > 4 && axis.substr(axis.size() - 4) == "_mpa"
               ? 1e-6 * value
               : value;
    }

    /** Combinations of the values of some axes. */
    std::vector<std::vector<double>>
    combinations(const std::vector<SweepAxisParameters> &axes,
                 const bool                              friction)
    {
      std::vector<std::vector<double>> all = {{}};
      for (const auto &axis : axes)
        if (is_friction(axis) == friction)
          {
            std::vector<std::vector<double>> next;
            for (const auto &head : all)
              for (const double value : axis_values(axis))
                {
                  next.push_back(head);
                  next.back().push_back(value);
                }
            all = next;
          }
      return all;
    }

    Parameters
    at_point(Parameters                              p,
             const std::vector<SweepAxisParameters> &axes,
             const std::vector<double>              &values,
             const bool                              friction)
    {
      std::size_t i = 0;
      for (const auto &axis : axes)
        if (is_friction(axis) == friction)
          {
            for (const auto &entry : axis.entries)
              p = with_value(p, entry, values[i]);
            ++i;
          }
      return p;
    }

    /** One run: where it stands and, once it is done, its row. */
    struct CampaignRun
    {
      Parameters          parameters;
      std::vector<double> shown; /**< in the order of the axes */
      std::string         top, key;
    };

    Table
    campaign_columns(const Parameters &p)
    {
      Table table;
      for (const auto &axis : p.sweep.axes)
        table.add_column({axis.name, Type::real, "", "axis of the campaign"});
      table.add_column({"top", Type::text, "", "kind of the support"});
      std::vector<Table::Column> columns = {
        {"contact_state", Type::text, "", "closed and all nodes"},
        {"integrator", Type::text, "", ""},
        {"sigma_cea_per_s", Type::real, "1/s", "whole model"},
        {"growth_rate_per_s", Type::real, "1/s", "linear phase"},
        {"growth_rate_ci_per_s", Type::real, "1/s", "95 %", 3},
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
        {"steps_per_second", Type::real, "1/s", "of one core", 4}};
      if (!p.transient.compare_with_cea)
        columns = {
          {"stable", Type::text, "", "yes, no or undecided"},
          {"growth_rate_per_s", Type::real, "1/s", "linear phase"},
          {"frequency_hz", Type::real, "Hz", "largest line of the force", 6},
          {"rms_normal_n", Type::real, "N", "about the mean"},
          {"min_normal_n", Type::real, "N", ""},
          {"max_normal_n", Type::real, "N", ""},
          {"separates", Type::text, "", "all nodes are open at a time"},
          {"sigma_cea_per_s", Type::real, "1/s", "about the same contact"},
          {"max_slip_speed_ratio", Type::real, "", "over |V|", 4},
          {"stick_fraction", Type::real, "", "of closed node-time", 4},
          {"rms_pad_acceleration", Type::real, "m/s2", "", 4},
          {"frequency_cea_hz", Type::real, "Hz", "of that sigma", 6},
          {"n_closed", Type::integer, "", "nodes in steady sliding"},
          {"n_unstable", Type::integer, "", "pairs of the band"},
          {"limit_cycle", Type::text, "", "the second half is steady"},
          {"worst_imbalance", Type::real, "", "of the energy ledger", 2},
          {"steps_per_second", Type::real, "1/s", "of one core", 4},
          {"unstable_pairs", Type::text, "", "Hz (1/s), about the contact"}};
      for (const auto &column : columns)
        table.add_column(column);
      return table;
    }

    Cell
    known(const double value)
    {
      return std::isfinite(value) ? Cell(value) : Cell();
    }

    /** The branch that the comparison is about: the largest sigma of the whole
     * model. */
    const BranchResult *
    leading_branch(const TransientFigures &f)
    {
      return f.leading >= 0 ? &f.branches[f.leading] : nullptr;
    }

    std::vector<Cell>
    row_of(const CampaignRun       &run,
           const PreparedTransient &prepared,
           const TransientFigures  &f,
           const bool               compares)
    {
      std::vector<Cell> row(run.shown.begin(), run.shown.end());
      row.emplace_back(run.top);
      const BranchResult *b   = leading_branch(f);
      const double        nan = std::nan("");
      const bool          fit = b && b->fit.is_valid;
      if (compares)
        {
          const double sigma = b ? b->sigma_cea : nan,
                       rate  = fit ? b->fit.rate : nan,
                       freq  = fit ? b->fit.frequency : nan;
          row.emplace_back(std::to_string(prepared.steady.n_closed()) + " of " +
                           std::to_string(prepared.steady.status.size()));
          row.emplace_back("reduced");
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
                f.steps_per_second})
            row.push_back(known(value));
          return row;
        }
      std::string  pairs;
      unsigned int n_unstable = 0;
      for (const auto &branch : f.branches)
        if (branch.sigma > 0.)
          {
            ++n_unstable;
            pairs += (pairs.empty() ? "" : "; ") +
                     rounded_text(branch.frequency, 4) + " (" +
                     rounded_text(branch.sigma, 3) + ")";
          }
      const bool is_unstable = f.verdict == "unstable";
      row.emplace_back(is_unstable             ? "no"
                       : f.verdict == "stable" ? "yes"
                                               : "undecided");
      row.push_back(known(fit ? b->fit.rate : nan));
      row.push_back(known(is_unstable ? f.frequency : nan));
      for (const double value : {f.rms_normal, f.min_normal, f.max_normal})
        row.push_back(known(value));
      row.emplace_back(f.separates ? "yes" : "no");
      row.push_back(known(b ? b->sigma : nan));
      for (const double value :
           {f.max_slip_speed_ratio, f.stick_fraction, f.rms_acceleration})
        row.push_back(known(value));
      row.push_back(known(b ? b->frequency : nan));
      row.emplace_back(prepared.steady.n_closed());
      row.emplace_back(n_unstable);
      row.emplace_back(f.has_limit_cycle ? "yes" : "no");
      row.push_back(known(f.worst_imbalance));
      row.push_back(known(f.steps_per_second));
      row.emplace_back(pairs.empty() ? "none" : pairs);
      return row;
    }

    /** The row of a point that has no steady sliding. */
    std::vector<Cell>
    row_without_sliding(const CampaignRun &run, const Table &table)
    {
      std::vector<Cell> row(run.shown.begin(), run.shown.end());
      row.emplace_back(run.top);
      row.emplace_back("no steady sliding");
      row.resize(table.columns().size());
      return row;
    }



    /** Rows of runs that an earlier campaign has finished, by their keys. */
    class FinishedRuns
    {
    public:
      FinishedRuns(const std::string &path, const bool resume)
        : path(path)
      {
        std::ifstream in(path);
        if (!in || !resume)
          return;
        try
          {
            rows = Json::parse(in);
          }
        catch (const std::exception &)
          {
            throw InputError("'" + path +
                             "' cannot be read: remove it or set "
                             "Transient/Resume = false");
          }
      }

      bool
      find(const std::string &key, std::vector<Cell> &row) const
      {
        const auto found = rows.find(key);
        if (found == rows.end())
          return false;
        row.clear();
        for (const auto &cell : *found)
          if (cell.is_string())
            row.emplace_back(cell.get<std::string>());
          else if (cell.is_number_integer())
            row.emplace_back(cell.get<long long>());
          else if (cell.is_number())
            row.emplace_back(cell.get<double>());
          else
            row.emplace_back();
        return true;
      }

      void
      add(const std::string &key, const std::vector<Cell> &row)
      {
        Json list = Json::array();
        for (const Cell &cell : row)
          if (const auto *real = std::get_if<double>(&cell.value))
            list.push_back(*real);
          else if (const auto *whole = std::get_if<long long>(&cell.value))
            list.push_back(*whole);
          else if (const auto *text = std::get_if<std::string>(&cell.value))
            list.push_back(*text);
          else
            list.push_back(nullptr);
        rows[key] = list;
        write_atomically(path, [&](std::ostream &out) { out << rows.dump(1); });
      }

    private:
      const std::string path;
      Json              rows = Json::object();
    };



    /** All runs with one set of bodies. */
    class CampaignGroup
    {
    public:
      CampaignGroup(const Parameters &p, RunContext &c)
        : parameters(p)
        , context(c)
        , model(parameters, c.timers)
        , pressed(parameters,
                  *model.discretization(),
                  model.body_matrices(),
                  parameters.transient.cut_off,
                  c.timers)
      {
        context.record.n_dofs = model.n_unknowns();
      }

      struct Outcome
      {
        std::vector<Cell> row;
        bool              finished = false;
      };

      /** Steady sliding and its linearisation; null where there is none. */
      std::unique_ptr<PreparedTransient>
      prepare(const CampaignRun &run)
      {
        PressedModel with = pressed;
        with.set_friction(
          std::abs(run.parameters.scene.contacts[0].friction_coefficient));
        try
          {
            return std::make_unique<PreparedTransient>(
              with, run.parameters, context.timers);
          }
        catch (const ComputationError &e)
          {
            context.log.warning(e.what());
            return {};
          }
      }

      /** For a thread of its own. With a comparison the run ends with its
       * linear phase. */
      static TransientRecord
      integrate(const CampaignRun       &run,
                const PreparedTransient &prepared,
                const StopRequest       &stop)
      {
        TransientRun transient(prepared.pressed,
                               prepared.steady,
                               prepared.linear,
                               prepared.branches,
                               run.parameters);
        const bool   linear_only = run.parameters.transient.compare_with_cea;
        transient.advance([&](const unsigned int) {
          return stop.is_there() ||
                 (linear_only && !transient.record().changes.empty());
        });
        return transient.record();
      }

      Outcome
      evaluate(const CampaignRun       &run,
               const PreparedTransient &prepared,
               const TransientRecord   &record)
      {
        ComplexPairs cea;
        if (run.parameters.transient.compare_with_cea)
          cea = whole_model_pairs(run.parameters,
                                  prepared.pressed.state_of(prepared.steady),
                                  context.log,
                                  context.timers);
        const TransientFigures f = evaluate_transient(
          prepared, record, run.parameters, cea.size() > 0 ? &cea : nullptr);
        return {
          row_of(run, prepared, f, run.parameters.transient.compare_with_cea),
          true};
      }

    private:
      const Parameters parameters;
      RunContext      &context;
      Model            model;
      PressedModel     pressed;
    };



    std::string
    finished_file(const Parameters &p)
    {
      std::string directory = p.output.directory;
      while (directory.size() > 1 && directory.back() == '/')
        directory.pop_back();
      return directory + "_runs.json";
    }

    std::vector<double>
    shown_values(const std::vector<SweepAxisParameters> &axes,
                 const std::vector<double>              &others,
                 const std::vector<double>              &frictions)
    {
      std::vector<double> result;
      std::size_t         i = 0, k = 0;
      for (const auto &axis : axes)
        result.push_back(shown_value(
          axis.name, is_friction(axis) ? frictions[k++] : others[i++]));
      return result;
    }

    /** Runs of one group that are still to be done, a few at a time. */
    void
    run_group(const std::vector<CampaignRun> &runs,
              RunContext                     &context,
              FinishedRuns                   &finished,
              Progress                       &progress,
              Table                          &table)
    {
      const Parameters              &p = context.parameters;
      std::unique_ptr<CampaignGroup> group;
      const auto                     add = [&](const CampaignRun       &run,
                           const std::vector<Cell> &row,
                           const bool               is_new) {
        table.add_row(row);
        if (is_new && context.is_root)
          finished.add(run.key, row);
        progress.advance(1, run.top);
      };
      for (std::size_t first = 0; first < runs.size();
           first += p.transient.threads)
        {
          const std::size_t last =
            std::min<std::size_t>(first + p.transient.threads, runs.size());
          std::vector<std::unique_ptr<PreparedTransient>> prepared;
          std::vector<std::future<TransientRecord>>       records;
          std::vector<std::vector<Cell>>                  rows(last - first);
          StopRequest                                     stop;
          for (std::size_t i = first; i < last; ++i)
            {
              prepared.emplace_back();
              records.emplace_back();
              if (finished.find(runs[i].key, rows[i - first]))
                continue;
              if (!group)
                group = std::make_unique<CampaignGroup>(runs[first].parameters,
                                                        context);
              prepared.back() = group->prepare(runs[i]);
              if (prepared.back())
                records.back() =
                  std::async(std::launch::async, [&, i, first]() {
                    return CampaignGroup::integrate(
                      runs[i], *prepared[i - first], stop);
                  });
            }
          for (std::size_t i = first; i < last; ++i)
            {
              const bool is_known = !rows[i - first].empty();
              if (is_known)
                {
                  add(runs[i], rows[i - first], false);
                  continue;
                }
              if (!prepared[i - first])
                {
                  add(runs[i], row_without_sliding(runs[i], table), true);
                  continue;
                }
              TransientRecord record;
              {
                Timers::Section section(context.timers, "Solve: time steps");
                record = records[i - first].get();
              }
              if (stop.is_there())
                {
                  for (std::size_t k = i + 1; k < last; ++k)
                    if (records[k - first].valid())
                      records[k - first].wait();
                  context.log.info("stopped; the same command goes on with the "
                                   "runs that are left");
                  stop.repeat();
                }
              add(runs[i],
                  group->evaluate(runs[i], *prepared[i - first], record).row,
                  true);
            }
        }
    }

    void
    draw_comparison(RunContext &context, const Table &table, HtmlReport &report)
    {
      Chart chart;
      chart.title   = "Growth in time against the eigenvalue analysis";
      chart.x.label = "sigma of the whole model in 1/s";
      chart.y.label = "growth rate in time in 1/s";
      ChartSeries line;
      line.label               = "equal";
      line.style               = ChartSeries::Style::lines;
      line.ink                 = Ink::grey;
      double           ends[2] = {0., 0.};
      static const Ink inks[]  = {Ink::blue, Ink::vermillion, Ink::green};
      std::vector<ChartSeries> series;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        {
          const std::string top = table.text(i, "top");
          auto              s   = std::find_if(series.begin(),
                                series.end(),
                                [&](const auto &x) { return x.label == top; });
          if (s == series.end())
            {
              ChartSeries next;
              next.label = top;
              next.ink   = inks[series.size() % 3];
              s          = series.insert(series.end(), next);
            }
          const double x = table.real(i, "sigma_cea_per_s"),
                       y = table.real(i, "growth_rate_per_s");
          if (!std::isfinite(x) || !std::isfinite(y))
            continue;
          s->x.push_back(x);
          s->y.push_back(y);
          ends[0] = std::min({ends[0], x, y});
          ends[1] = std::max({ends[1], x, y});
        }
      line.x       = {ends[0], ends[1]};
      line.y       = line.x;
      chart.series = series;
      chart.series.push_back(line);
      context.output.file("plots/comparison.png");
      const std::string path = context.output.path() + "/plots/comparison";
      context.plotter.draw(draw_charts({chart}), path);
      report.section("Comparison");
      report.figure(path + ".png", "Growth rates", true);
    }
  } // namespace



  void
  run_campaign(RunContext &context)
  {
    const Parameters        &p    = context.parameters;
    const auto              &axes = p.sweep.axes;
    std::vector<std::string> tops = p.transient.tops;
    if (tops.empty())
      tops.push_back("");
    Table                                 table = campaign_columns(p);
    std::vector<std::vector<CampaignRun>> groups;
    std::size_t                           n_runs = 0;
    for (const std::string &top : tops)
      for (const auto &others : combinations(axes, false))
        {
          Parameters base = at_point(p, axes, others, false);
          groups.emplace_back();
          for (const auto &frictions : combinations(axes, true))
            {
              CampaignRun run{at_point(base, axes, frictions, true),
                              shown_values(axes, others, frictions),
                              top,
                              ""};
              auto       &scene       = run.parameters.scene;
              scene.contacts[0].state = ContactParameters::State::full;
              for (auto &support : scene.supports)
                if (!top.empty() && support.name == p.transient.top_support)
                  for (const auto &[name, kind] : choices(Kind()))
                    if (name == top)
                      support.kind = kind;
              // Node fields are not kept in a campaign.
              run.parameters.transient.history_start       = 1e300;
              run.parameters.discretization.estimate_error = false;
              run.key = key_of_motion(run.parameters);
              groups.back().push_back(run);
              ++n_runs;
            }
        }
    if (p.scene.contacts[0].friction_coefficient < 0.)
      throw InputError("Scene/Contact/Friction coefficient: a campaign needs "
                       "one of at least 0");
    FinishedRuns finished(finished_file(p), p.transient.resume);
    {
      Progress progress(context.log, "transients", n_runs);
      for (const auto &runs : groups)
        run_group(runs, context, finished, progress, table);
    }
    context.write_table(p.transient.campaign_table, table);
    std::ostringstream text;
    table.print(text);
    context.log.heading("Campaign");
    context.log.info(text.str());
    context.record.figures = {{"runs", std::to_string(table.n_rows())}};
    HtmlReport report("Transients of " + p.scene.name,
                      "over the axes of the campaign");
    report.set_verdict(HtmlReport::Verdict::neutral,
                       std::to_string(table.n_rows()) + " runs",
                       context.record.figures);
    if (p.transient.compare_with_cea && p.output.plots && context.is_root)
      draw_comparison(context, table, report);
    report.section("Runs");
    report.table(table, "One row for each run");
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
