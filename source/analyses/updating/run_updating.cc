// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/analyses.h>
#include <squeal/analyses/updating/updating_model.h>
#include <squeal/base/files.h>
#include <squeal/output/record_unknowns.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/number_access.h>
#include <squeal/parameters/text.h>
#include <squeal/results/chart.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    double
    error_percent(const UpdatingModel      &model,
                  const UpdatingEvaluation &e,
                  const unsigned int        i)
    {
      return 100. * (e.frequencies[i] / model.measured()[i].frequency - 1.);
    }

    /** Root mean square of the relative errors, unweighted, in per cent. */
    double
    rms_percent(const UpdatingModel &model, const UpdatingEvaluation &e)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < e.frequencies.size(); ++i)
        sum += std::pow(error_percent(model, e, i), 2);
      return std::sqrt(sum / e.frequencies.size());
    }

    Table
    number_table(const UpdatingParameters &p, const UpdatingFit &fit)
    {
      Table table(
        {{"number", Type::text, "", "that was fitted"},
         {"entry", Type::text, "", "first entry of the scene"},
         {"start", Type::real, "", "value in the file, SI units", 5},
         {"value", Type::real, "", "fitted value", 6},
         {"interval_lower",
          Type::real,
          "",
          "lower end of the confidence interval; nothing where the data do not "
          "tell",
          5},
         {"interval_upper", Type::real, "", "upper end", 5},
         {"lower", Type::real, "", "bound", 5},
         {"upper", Type::real, "", "bound", 5},
         {"at_bound", Type::integer, "", "1: the fit ended at a bound"},
         {"identified", Type::integer, "", "0: the data do not determine it"},
         {"sensitivity",
          Type::real,
          "",
          "norm of the weighted relative changes of all frequencies over the "
          "relative change of the number",
          3},
         {"correlated_with", Type::text, "", "number most correlated with it"},
         {"correlation", Type::real, "", "with that number", 3}});
      for (std::size_t i = 0; i < fit.numbers.size(); ++i)
        {
          const FittedNumber &n = fit.numbers[i];
          table.add_row({p.numbers[i].name,
                         p.numbers[i].entries[0],
                         n.start,
                         n.value,
                         or_missing(n.interval_lower),
                         or_missing(n.interval_upper),
                         n.lower,
                         n.upper,
                         n.is_at_bound ? 1 : 0,
                         n.is_identified ? 1 : 0,
                         n.sensitivity,
                         n.partner < 0 ? "" : p.numbers[n.partner].name,
                         n.partner < 0 ? Cell() : Cell(n.correlation)});
        }
      return table;
    }

    /** "E_disc = 2.057e11 Pa (95 %: 2.02e11 to 2.09e11)" of every number. */
    std::string
    numbers_text(const Parameters &p, const UpdatingFit &fit)
    {
      std::string text;
      for (std::size_t i = 0; i < fit.numbers.size(); ++i)
        {
          const FittedNumber &n       = fit.numbers[i];
          const auto         &entries = p.updating.numbers[i].entries;
          const std::string   unit    = unit_of_entry(entries[0], p.scene);
          text += (text.empty() ? "" : ", ") +
                  symbol_of_entries(entries, p.scene) + " = " +
                  rounded_text(n.value, 4) + (unit.empty() ? "" : " " + unit);
          text += n.is_identified && std::isfinite(n.interval_lower) &&
                      std::isfinite(n.interval_upper)
                    ? " (" + rounded_text(n.interval_lower, 3) + " to " +
                        rounded_text(n.interval_upper, 3) + ")"
                    : " (not determined)";
        }
      return text;
    }

    Table
    frequency_table(const UpdatingModel &model, const UpdatingFit &fit)
    {
      Table table(
        {{"name", Type::text, "", "of the measured mode"},
         {"measured_hz", Type::real, "Hz", "measured", 6},
         {"weight", Type::real, "", "of its squared error", 3},
         {"start_hz", Type::real, "Hz", "of the scene as it was", 6},
         {"start_error_percent", Type::real, "%", "of that", 3},
         {"updated_hz", Type::real, "Hz", "of the fitted scene", 6},
         {"updated_error_percent", Type::real, "%", "of that", 3},
         {"mode", Type::text, "", "name in the fitted scene"},
         {"mac", Type::real, "", "with the shape it was followed from", 3},
         {"mac_measured",
          Type::real,
          "",
          "with the measured shape; nothing where modes are paired by name",
          3}});
      for (unsigned int i = 0; i < model.measured().size(); ++i)
        table.add_row({model.measured()[i].name,
                       model.measured()[i].frequency,
                       model.measured()[i].weight,
                       fit.first.frequencies[i],
                       error_percent(model, fit.first, i),
                       fit.best.frequencies[i],
                       error_percent(model, fit.best, i),
                       fit.best.names[i],
                       fit.best.mac[i],
                       fit.best.mac_measured.size() > 0
                         ? or_missing(fit.best.mac_measured[i])
                         : Cell()});
      return table;
    }

    Table
    history_table(const UpdatingParameters &p,
                  const UpdatingModel      &model,
                  const UpdatingFit        &fit)
    {
      Table table({{"evaluation", Type::integer, "", "from 1"},
                   {"rms_error_percent", Type::real, "%", "unweighted", 4}});
      for (const auto &number : p.numbers)
        table.add_column({number.name, Type::real, "", number.entries[0], 6});
      for (std::size_t k = 0; k < fit.history.size(); ++k)
        {
          std::vector<Cell> row = {k + 1, rms_percent(model, fit.history[k])};
          for (unsigned int n = 0; n < model.n_numbers(); ++n)
            row.emplace_back(model.start_value(n) *
                             std::exp(fit.history[k].logarithms[n]));
          table.add_row(row);
        }
      return table;
    }

    /** A body of a mesh file may have its material from there: one fitted
     * number of it needs the others and that this is put off. */
    void
    complete_materials(const Parameters                   &p,
                       std::map<std::string, std::string> &settings)
    {
      using Body = BodyParameters;
      for (const Body &body : p.scene.bodies)
        {
          const std::string        section = "Scene/Body " + body.name + "/";
          std::vector<std::string> material;
          for (const char *entry :
               {"Young modulus", "Poisson ratio", "Density"})
            material.push_back(section + entry);
          if ((body.shape == Body::Shape::abaqus ||
               body.shape == Body::Shape::nastran) &&
              body.material_model == Body::MaterialModel::isotropic &&
              std::any_of(
                material.begin(), material.end(), [&](const std::string &path) {
                  return settings.count(path) > 0;
                }))
            {
              settings[section + "Material from mesh file"] = "false";
              for (const std::string &path : material)
                settings.emplace(path, shortest_text(get_number(p, path)));
            }
        }
    }

    /** Settings for a file that includes the scene, one line an entry. */
    void
    write_settings(std::ostream        &out,
                   const Parameters    &p,
                   const UpdatingModel &model,
                   const UpdatingFit   &fit)
    {
      std::vector<std::string> paths;
      std::vector<double>      values;
      for (unsigned int n = 0; n < model.n_numbers(); ++n)
        for (std::size_t e = 0; e < p.updating.numbers[n].entries.size(); ++e)
          {
            paths.push_back(p.updating.numbers[n].entries[e]);
            values.push_back(model.start_value(n, e) *
                             std::exp(fit.best.logarithms[n]));
          }
      auto settings = changed_entries(p, paths, values);
      complete_materials(p, settings);
      out
        << "# Fitted numbers: each line goes behind --set, or into the section "
           "that its path names.\n";
      for (const auto &[path, text] : settings)
        out << path << " = " << text << '\n';
    }

    /** Whether the mode paired with a measured one is too little like it. */
    bool
    is_doubtful(const UpdatingParameters &p,
                const UpdatingFit        &fit,
                const unsigned int        i)
    {
      return !(fit.best.mac[i] >= p.minimum_mac) ||
             (fit.best.mac_measured.size() > 0 &&
              !(fit.best.mac_measured[i] >= p.minimum_mac));
    }

    void
    warn_of_pairs(RunContext          &context,
                  const UpdatingModel &model,
                  const UpdatingFit   &fit)
    {
      const auto &p = context.parameters.updating;
      for (unsigned int i = 0; i < model.measured().size(); ++i)
        if (is_doubtful(p, fit, i))
          {
            const bool is_followed = fit.best.mac[i] >= p.minimum_mac;
            context.log.warning(
              "the mode paired with '" + model.measured()[i].name + "' at " +
              rounded_text(model.measured()[i].frequency, 5) + " Hz, " +
              fit.best.names[i] + " at " +
              rounded_text(fit.best.frequencies[i], 5) + " Hz, is like " +
              (is_followed ? "the measured shape"
                           : "the mode it was followed from") +
              " with a MAC of " +
              rounded_text(
                is_followed ? fit.best.mac_measured[i] : fit.best.mac[i], 2) +
              " only, below 'Updating/Minimum MAC'");
          }
    }

    void
    warn(RunContext          &context,
         const UpdatingModel &model,
         const UpdatingFit   &fit)
    {
      const auto &p = context.parameters.updating;
      if (!fit.has_converged)
        context.log.warning("the fit has not converged: " + fit.ended);
      if (fit.has_no_spare)
        context.log.warning(
          "as many frequencies as numbers, " +
          std::to_string(fit.numbers.size()) +
          ": they are met whatever their errors, so that there are no "
          "confidence intervals and nothing says how good the numbers are: "
          "add frequencies or take numbers out");
      for (std::size_t i = 0; i < fit.numbers.size(); ++i)
        {
          const FittedNumber &n = fit.numbers[i];
          if (n.is_unknown || (!n.is_identified && !fit.has_no_spare))
            context.log.warning(
              "the data do not identify " + p.numbers[i].name +
              (n.partner >= 0 && std::abs(n.correlation) > 0.95
                 ? " apart from " + p.numbers[n.partner].name
                 : std::string()) +
              ": its value is a matter of chance");
          if (n.is_at_bound)
            context.log.warning(p.numbers[i].name + " = " +
                                rounded_text(n.value, 5) +
                                " is at a bound: its interval means little");
        }
      warn_of_pairs(context, model, fit);
    }

    void
    draw(RunContext          &context,
         const UpdatingModel &model,
         const UpdatingFit   &fit,
         HtmlReport          &report)
    {
      if (!context.is_root)
        return;
      Chart chart;
      chart.title   = "Errors of the frequencies before and after";
      chart.x.label = "measured frequency in Hz";
      chart.y.label = "error in per cent";
      chart.lines.push_back({false, 0., "", Ink::black, false});
      ChartSeries before, after;
      before.label  = "before";
      before.ink    = Ink::grey;
      before.hollow = true;
      after.label   = "fitted";
      for (unsigned int i = 0; i < model.measured().size(); ++i)
        for (const auto &[series, e] :
             {std::make_pair(&before, &fit.first), {&after, &fit.best}})
          {
            series->x.push_back(model.measured()[i].frequency);
            series->y.push_back(error_percent(model, *e, i));
            series->names.push_back(series == &after ? model.measured()[i].name
                                                     : "");
          }
      chart.series = {before, after};
      context.output.file("plots/errors.png");
      const std::string path = context.output.path() + "/plots/errors";
      context.plotter.draw(draw_charts({chart}), path);
      report.section("Charts");
      report.figure(path + ".png", "Errors before and after", true);
    }
  } // namespace



  void
  run_updating(RunContext &context)
  {
    const auto   &p = context.parameters;
    UpdatingModel model(context);
    context.log.heading(
      "Fit of " + std::to_string(model.n_numbers()) + " numbers to " +
      std::to_string(model.measured().size()) + " frequencies");
    const UpdatingFit fit = fit_numbers(model, p.updating, context.log);
    warn(context, model, fit);

    const Table numbers     = number_table(p.updating, fit);
    const Table frequencies = frequency_table(model, fit);
    context.write_table("updated_numbers.csv", numbers);
    context.write_table("updated_frequencies.csv", frequencies);
    context.write_table("updating_history.csv",
                        history_table(p.updating, model, fit));
    if (context.is_root)
      write_atomically(
        context.output.file("updated_settings.txt"),
        [&](std::ostream &out) { write_settings(out, p, model, fit); });
    const bool has_shapes = model.model().namer().n_coordinates() > 0;
    if (has_shapes)
      context.log.info(explanation_of_names());
    for (const auto &[title, table] :
         {std::make_pair("Fitted numbers", &numbers),
          std::make_pair("Frequencies", &frequencies)})
      {
        std::ostringstream text;
        table->print(text);
        context.log.heading(title);
        context.log.info(text.str());
      }

    unsigned int n_unknown = 0, n_doubtful = 0;
    for (const auto &n : fit.numbers)
      n_unknown += !n.is_identified;
    for (unsigned int i = 0; i < model.measured().size(); ++i)
      n_doubtful += is_doubtful(p.updating, fit, i);
    const std::string before = rounded_text(rms_percent(model, fit.first), 4),
                      after  = rounded_text(rms_percent(model, fit.best), 4);
    record_unknowns(model.model(), context.record);
    context.record.figures = {
      {"rms error before", before + " %"},
      {"rms error after", after + " %; mesh error not estimated"},
      {"evaluations", std::to_string(fit.history.size())},
      {"ended", fit.ended},
      {"numbers that the data do not identify", std::to_string(n_unknown)},
      {"pairs of modes below the minimum MAC",
       std::to_string(n_doubtful) + " of " +
         std::to_string(model.measured().size())},
      {"unknowns", std::to_string(model.model().n_unknowns())}};

    HtmlReport report("Updating of " + p.scene.name,
                      "numbers of the scene fitted to measured frequencies");
    report.set_verdict(fit.has_converged && n_unknown == 0 && n_doubtful == 0
                         ? HtmlReport::Verdict::good
                         : HtmlReport::Verdict::bad,
                       "rms error " + before + " % before, " + after +
                         " % after the fit: " + numbers_text(p, fit) +
                         "; mesh error not estimated",
                       context.record.figures);
    if (p.output.plots)
      {
        Timers::Section section(context.timers, "Write: charts");
        draw(context, model, fit, report);
      }
    report.section("Numbers");
    report.table(numbers, "Fitted numbers");
    report.section("Frequencies");
    report.table(frequencies, "Measured and computed frequencies");
    if (has_shapes)
      report.paragraph(explanation_of_names());
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
