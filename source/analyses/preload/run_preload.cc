// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/analyses.h>
#include <squeal/base/exceptions.h>
#include <squeal/model/pressed_model.h>
#include <squeal/output/contact_output.h>
#include <squeal/results/chart.h>
#include <squeal/results/json_file.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <ostream>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** States at equal shares of the load, the last one full. */
    std::vector<SteadySliding>
    load_steps(PressedModel     &pressed,
               const Parameters &p,
               SteadySliding    &full,
               Timers           &timers)
    {
      full = pressed.steady(p.preload.tolerance, timers);
      Timers::Section    section(timers, "Solve: load steps");
      const unsigned int n = p.preload.load_steps;
      if (pressed.speed() == 0.)
        {
          const auto states = press_at_rest(pressed.model(),
                                            pressed.friction_law().at_rest(),
                                            n,
                                            p.preload.tolerance);
          full              = states.back();
          return states;
        }
      std::vector<SteadySliding> states;
      for (unsigned int k = 1; k < n; ++k)
        states.push_back(steady_sliding(pressed.model(),
                                        pressed.sliding_friction().coefficient,
                                        double(k) / n,
                                        p.preload.tolerance));
      states.push_back(full);
      return states;
    }

    /** The scene of the loads: a held support is kept where they have moved it,
     * so that the state is that of the guided one. */
    Parameters
    moving(Parameters p)
    {
      p.scene.contacts[0].state = ContactParameters::State::full;
      for (auto &support : p.scene.supports)
        if (support.kind == SupportParameters::Kind::held)
          support.kind = SupportParameters::Kind::guided;
      return p;
    }

    Table
    step_columns()
    {
      using Type = Table::Type;
      return Table(
        {{"load_share", Type::real, "", "share of the load", 3},
         {"normal_n", Type::real, "N", "resultant of the pressure"},
         {"tangential_n",
          Type::real,
          "N",
          "along the sliding, target on source"},
         {"radial_n",
          Type::real,
          "N",
          "across the sliding (outwards on a disc), target on source",
          3},
         {"n_open", Type::integer, "", "open nodes"},
         {"n_slip", Type::integer, "", "slipping nodes"},
         {"n_stick", Type::integer, "", "sticking nodes"},
         {"centre_x_m",
          Type::real,
          "m",
          "of pressure, from the face's, across the sliding",
          4},
         {"centre_y_m",
          Type::real,
          "m",
          "of pressure, from the face's, along the sliding",
          4},
         {"leading_edge_factor",
          Type::real,
          "",
          "pressure at the entry edge over the mean of the face",
          4},
         {"mean_pressure_pa", Type::real, "Pa", "over the whole face", 4},
         {"peak_pressure_pa", Type::real, "Pa", "of a node", 4},
         {"approach_m",
          Type::real,
          "m",
          "of the source's far face to the target",
          4},
         {"secant_stiffness_n_per_m",
          Type::real,
          "N/m",
          "normal force over that approach",
          5},
         {"approach_of_load_m",
          Type::real,
          "m",
          "of the loaded face to the target",
          4},
         {"secant_stiffness_of_load_n_per_m",
          Type::real,
          "N/m",
          "normal force over that approach",
          5},
         {"newton_iterations", Type::integer, "", "of the last friction step"},
         {"residual_rel", Type::real, "", "of the contact law", 2}});
    }

    void
    add_step(Table               &table,
             const PressedModel  &pressed,
             const SteadySliding &state,
             const double         share)
    {
      const auto r = contact_resultant(pressed.geometry(), state.forces);
      const Eigen::VectorXd z = pressed.model().observed.evaluate(
        state.coordinates, share, state.forces);
      const double approach =
        z[PressedModel::target_at_contact] - z[PressedModel::far_face];
      const double of_load =
        z[PressedModel::target_at_contact] - z[PressedModel::loaded_face];
      table.add_row({share,
                     r.force[2],
                     r.force[1],
                     r.force[0],
                     state.n_with(ContactStatus::open),
                     state.n_with(ContactStatus::slip),
                     state.n_with(ContactStatus::stick),
                     or_missing(r.centre[0]),
                     or_missing(r.centre[1]),
                     or_missing(r.leading_edge_factor),
                     r.mean_pressure,
                     r.peak_pressure,
                     approach,
                     or_missing(r.force[2] / approach),
                     of_load,
                     or_missing(r.force[2] / of_load),
                     state.report.iterations,
                     state.report.residual});
    }

    /** preload_stiffness.csv: the load steps at other values of a number. */
    Table
    stiffness_table(RunContext &context)
    {
      const auto         &p     = context.parameters;
      Table               table = step_columns();
      std::vector<double> values;
      Progress            progress(
        context.log, "contact stiffness", p.preload.stiffness_values.size());
      for (const double value : p.preload.stiffness_values)
        {
          const Parameters q =
            moving(with_value(p, p.preload.stiffness_entry, value));
          Model         model(q, context.timers);
          PressedModel  pressed(q,
                               *model.discretization(),
                               model.body_matrices(),
                               q.eigen.highest_frequency,
                               context.timers);
          SteadySliding full;
          const auto    states = load_steps(pressed, q, full, context.timers);
          for (std::size_t k = 0; k < states.size(); ++k)
            {
              add_step(
                table, pressed, states[k], double(k + 1) / states.size());
              values.push_back(value);
            }
          progress.advance();
        }
      table.add_column(
        {"value", Table::Type::real, "", "of " + p.preload.stiffness_entry});
      for (std::size_t i = 0; i < values.size(); ++i)
        table.set(i, "value", values[i]);
      return table;
    }

    void
    draw_stiffness(RunContext        &context,
                   const Table       &table,
                   const std::string &path)
    {
      Chart chart;
      chart.title   = "Secant stiffness of pad and contact";
      chart.x.label = "value of " + context.parameters.preload.stiffness_entry;
      chart.x.scale = AxisSettings::Scale::logarithmic;
      chart.y.label = "N/m";
      chart.y.scale = AxisSettings::Scale::logarithmic;
      ChartSeries s;
      s.label = "full load";
      s.style = ChartSeries::Style::lines_points;
      for (std::size_t i = 0; i < table.n_rows(); ++i)
        if (table.real(i, "load_share") == 1.)
          {
            s.x.push_back(table.real(i, "value"));
            s.y.push_back(table.real(i, "secant_stiffness_n_per_m"));
          }
      chart.series = {s};
      context.plotter.draw(draw_charts({chart}), path);
    }

    void
    write_preload_json(const Table       &steps,
                       const std::string &path,
                       const double       friction,
                       const double       speed)
    {
      nlohmann::ordered_json json = {{"format_version", 1},
                                     {"friction_coefficient", friction},
                                     {"sliding_speed_m_per_s", speed}};
      const std::size_t      last = steps.n_rows() - 1;
      for (const auto &column : steps.columns())
        json[column.name] = steps.real(last, column.name);
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (std::size_t i = 0; i < steps.n_rows(); ++i)
        {
          nlohmann::ordered_json row;
          for (const auto &column : steps.columns())
            row[column.name] = steps.real(i, column.name);
          list.push_back(row);
        }
      json["load_steps"] = list;
      write_json(path, json);
    }



    /** contact.vtu and the picture of pressure and status. Returns the name of
     * the former. */
    std::string
    write_contact(RunContext          &context,
                  const PressedModel  &pressed,
                  const SteadySliding &full,
                  const Table         &contact,
                  HtmlReport          &report)
    {
      const ContactGeometry &g        = pressed.geometry();
      std::vector<double>    pressure = contact.reals("pressure_pa"), traction,
                          status;
      for (const auto s : full.status)
        status.push_back(static_cast<int>(s));
      for (std::size_t j = 0; j < g.points.size(); ++j)
        {
          for (const char *name : {"traction_x_pa", "traction_y_pa"})
            traction.push_back(contact.real(j, name));
          traction.push_back(0.);
        }
      const ContactMap  map       = contact_map(g);
      const std::string open_this = "contact.vtu";
      map.write_vtu(context.output.file(open_this),
                    {{"pressure", pressure},
                     {"traction", traction},
                     {"gap", contact.reals("gap_m")},
                     {"status", status}});
      if (context.parameters.output.plots)
        {
          Timers::Section section(context.timers, "Write: charts");
          for (double &value : pressure)
            value *= 1e-6;
          context.output.file("plots/pressure.png");
          const std::string path = context.output.path() + "/plots/pressure";
          map.plot(
            context.plotter,
            {{"Contact pressure", "MPa", pressure, 0., 0., {}, {}},
             {"0 open, 1 stick, 2 slip", "status", status, 0., 2., {}, {}}},
            path);
          report.section("Pressure");
          report.figure(path + ".png",
                        "Pressure and status of the contact nodes; the "
                        "target's surface moves to " +
                          sliding_text(g));
        }
      return open_this;
    }



    void
    report_stiffness(RunContext &context, HtmlReport &report)
    {
      const Table table = stiffness_table(context);
      context.write_table("preload_stiffness.csv", table);
      report.section("Contact stiffness");
      if (context.parameters.output.plots && context.is_root)
        {
          context.output.file("plots/stiffness.png");
          const std::string path = context.output.path() + "/plots/stiffness";
          draw_stiffness(context, table, path);
          report.figure(path + ".png", "Secant stiffness at full load", true);
        }
      report.table(table,
                   "Secant contact stiffness",
                   {"value",
                    "load_share",
                    "normal_n",
                    "n_open",
                    "leading_edge_factor",
                    "secant_stiffness_n_per_m",
                    "secant_stiffness_of_load_n_per_m"});
    }



    /** The value of a column as the table shows it, in the last step. */
    std::string
    at_full_load(const Table &steps, const std::string &name)
    {
      return steps.display(steps.n_rows() - 1, steps.column_index(name));
    }



    /** The contact under the full load, the last of @p steps, as figures of the
     * run. */
    std::vector<std::pair<std::string, std::string>>
    full_load_figures(const Table &steps, const unsigned int n_unknowns)
    {
      const auto shown = [&](const std::string &name) {
        return at_full_load(steps, name);
      };
      return {
        {"nodes open, slipping, sticking",
         shown("n_open") + ", " + shown("n_slip") + ", " + shown("n_stick")},
        {"normal force", shown("normal_n") + " N"},
        {"friction force", shown("tangential_n") + " N"},
        {"centre of pressure across, along the sliding",
         shown("centre_x_m") + ", " + shown("centre_y_m") + " m"},
        {"leading-edge factor", shown("leading_edge_factor")},
        {"peak pressure", shown("peak_pressure_pa") + " Pa"},
        {"secant stiffness", shown("secant_stiffness_n_per_m") + " N/m"},
        {"unknowns", std::to_string(n_unknowns)}};
    }



    /** "5 of 9 nodes slip, ..." under the full load. */
    std::string
    full_load_text(const Table &steps, const std::size_t n_nodes)
    {
      const auto shown = [&](const std::string &name) {
        return at_full_load(steps, name);
      };
      return shown("n_slip") + " of " + std::to_string(n_nodes) +
             " nodes slip, " + shown("n_stick") + " stick, " + shown("n_open") +
             " are open";
    }



    void
    log_steps(RunContext &context, const Table &steps, const bool is_at_rest)
    {
      context.log.heading(is_at_rest ? "Contact at rest" : "Steady sliding");
      std::ostringstream text;
      steps.print(text,
                  {"load_share",
                   "normal_n",
                   "tangential_n",
                   "n_open",
                   "n_slip",
                   "n_stick",
                   "leading_edge_factor",
                   "secant_stiffness_n_per_m"});
      context.log.info(text.str());
    }
  } // namespace



  void
  run_preload(RunContext &context)
  {
    const Parameters p = moving(context.parameters);
    Model            model(p, context.timers);
    model.print_summary(context.log);
    PressedModel  pressed(p,
                         *model.discretization(),
                         model.body_matrices(),
                         p.eigen.highest_frequency,
                         context.timers);
    SteadySliding full;
    const auto    states = load_steps(pressed, p, full, context.timers);
    Table         steps  = step_columns();
    for (std::size_t k = 0; k < states.size(); ++k)
      add_step(steps, pressed, states[k], double(k + 1) / states.size());
    context.write_table("preload.csv", steps);
    const Table contact = contact_table(pressed.geometry(),
                                        full.forces,
                                        full.motion,
                                        pressed.model().initial_gap,
                                        full.status);
    context.write_table("contact.csv", contact);

    const bool is_at_rest = pressed.speed() == 0.;
    log_steps(context, steps, is_at_rest);
    context.record.n_dofs  = model.n_unknowns();
    context.record.figures = full_load_figures(steps, model.n_unknowns());

    HtmlReport report(
      (is_at_rest ? "Contact at rest of " : "Steady sliding of ") +
        p.scene.name,
      "pressure under the loads, compression positive");
    report.set_verdict(HtmlReport::Verdict::neutral,
                       full_load_text(steps, pressed.geometry().points.size()),
                       context.record.figures);
    std::string open_this;
    if (context.is_root)
      {
        write_preload_json(steps,
                           context.output.file("preload.json"),
                           p.scene.contacts[0].friction_coefficient,
                           pressed.speed());
        open_this = write_contact(context, pressed, full, contact, report);
      }
    report.section("Load steps");
    report.table(steps, "Contact over the load");
    if (!p.preload.stiffness_entry.empty())
      report_stiffness(context, report);
    context.finish(p.output.report ? &report : nullptr, open_this);
  }
} // namespace squeal
