// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/analyses.h>
#include <squeal/analyses/preload/loaded_scene.h>
#include <squeal/analyses/preload/preload_mesh_error.h>
#include <squeal/analyses/preload/preload_tables.h>
#include <squeal/analyses/preload/stiffness_entry_check.h>
#include <squeal/base/exceptions.h>
#include <squeal/contact/pressure_moments.h>
#include <squeal/contact/summed_pairs.h>
#include <squeal/model/pressed_model.h>
#include <squeal/model/rotor_symmetry.h>
#include <squeal/model/strain_warnings.h>
#include <squeal/output/contact_output.h>
#include <squeal/output/open_scene_output.h>
#include <squeal/output/record_unknowns.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/results/chart.h>

#include <cmath>
#include <ostream>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** States at equal shares of the load up to the full one. */
    std::vector<SteadySliding>
    load_steps(const SteadyModel &full, const Parameters &p, Timers &timers)
    {
      Timers::Section     section(timers, "Solve: load steps");
      const PressedModel &pressed = full.pressed;
      const unsigned int  n       = p.preload.load_steps;
      if (pressed.speed() == 0.)
        return press_at_rest(
          pressed.model(),
          pressed.nodes().laws().at_rest(pressed.nodes().n_nodes()),
          n,
          p.preload.tolerance);
      std::vector<SteadySliding> states;
      for (unsigned int k = 1; k < n; ++k)
        states.push_back(steady_sliding(pressed.model(),
                                        pressed.sliding_friction().coefficient,
                                        double(k) / n,
                                        p.preload.tolerance));
      states.push_back(full.sliding);
      return states;
    }

    /** preload_stiffness.csv: the load steps at other values of a number. */
    Table
    stiffness_table(RunContext &context)
    {
      const auto         &p = context.parameters;
      LoadSteps           steps(p.scene.contacts);
      std::vector<double> values;
      Progress            progress(
        context.log, "contact stiffness", p.preload.stiffness_values.size());
      for (const double value : p.preload.stiffness_values)
        {
          const Parameters q =
            loaded_scene(with_value(p, p.preload.stiffness_entry, value));
          Model             model(q, context.timers, {}, Model::Contacts::open);
          const SteadyModel full =
            pressed_model(q, model, q.eigen.highest_frequency, context.timers)
              .steady(q.preload.tolerance, context.timers);
          const auto states = load_steps(full, q, context.timers);
          for (std::size_t k = 0; k < states.size(); ++k)
            {
              steps.add(full.pressed, states[k], double(k + 1) / states.size());
              values.push_back(value);
            }
          progress.advance();
        }
      Table table = steps.table();
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
      chart.x.label = axis_title({context.parameters.preload.stiffness_entry},
                                 context.parameters.scene);
      chart.x.scale = AxisSettings::Scale::logarithmic;
      chart.y.label = "secant stiffness in N/m";
      chart.y.scale = AxisSettings::Scale::logarithmic;
      const auto     &contacts = context.parameters.scene.contacts;
      const LoadSteps columns(contacts);
      for (unsigned int pair = 0; pair < contacts.size(); ++pair)
        {
          ChartSeries s;
          s.label = contacts.size() > 1 ? contacts[pair].name : "full load";
          s.ink   = series_ink(pair);
          s.style = ChartSeries::Style::lines_points;
          for (std::size_t i = 0; i < table.n_rows(); ++i)
            if (const std::string shown =
                  columns.column(pair, "secant_stiffness_n_per_m");
                table.real(i, "load_share") == 1. &&
                !table.is_missing(i, shown))
              {
                s.x.push_back(table.real(i, "value"));
                s.y.push_back(table.real(i, shown));
              }
          chart.series.push_back(s);
        }
      context.plotter.draw(draw_charts({chart}), path);
    }

    /** contact.vtu of a pair and the picture of its pressure and status.
     * Returns the name of the former. */
    std::string
    write_contact(RunContext            &context,
                  const ContactPair     &pair,
                  const bool             is_one_of_several,
                  const SteadySliding   &full,
                  const Eigen::VectorXd &initial_gap,
                  HtmlReport            &report)
    {
      const ContactGeometry &g     = pair.geometry;
      const std::string     suffix = is_one_of_several ? "_" + pair.name() : "";
      const Eigen::VectorXd forces = pair.part(full.forces),
                            motion = pair.part(full.motion),
                            gap    = pair.part(initial_gap, 1);
      std::vector<double> pressure, opening, traction, status;
      for (const auto s : pair.part(full.status))
        status.push_back(static_cast<int>(s));
      for (const auto &q : tractions(g, forces))
        for (unsigned int c = 0; c < 3; ++c)
          traction.push_back(q[c]);
      for (std::size_t j = 0; j < g.points.size(); ++j)
        {
          pressure.push_back(forces[3 * j] / g.areas[j]);
          opening.push_back(gap[j] - motion[3 * j]);
        }
      const ContactMap  map       = contact_map(g);
      const std::string open_this = "contact" + suffix + ".vtu";
      map.write_vtu(context.output.file(open_this),
                    {{"pressure", pressure},
                     {"traction", traction},
                     {"gap", opening},
                     {"status", status}});
      if (context.parameters.output.plots)
        {
          Timers::Section section(context.timers, "Write: charts");
          for (double &value : pressure)
            value = pressure_on_map(value);
          const std::string name = "plots/pressure" + suffix;
          context.output.file(name + ".png");
          const std::string path = context.output.path() + "/" + name;
          map.plot(context.plotter,
                   {{"Contact pressure", "MPa", pressure, 0., 0., {}, {}, {}},
                    {"Status", "", status, 0., 0., status_names(), {}, {}}},
                   path);
          report.section(is_one_of_several ? "Pressure of " + pair.name()
                                           : "Pressure");
          report.figure(path + ".png",
                        "Pressure and status of the contact nodes; grey: "
                        "open");
        }
      return open_this;
    }

    /** Of all pairs; returns the name of one file. */
    std::string
    write_contacts(RunContext          &context,
                   const PressedModel  &pressed,
                   const SteadySliding &full,
                   HtmlReport          &report)
    {
      const auto &pairs = pressed.nodes().pairs();
      std::string name;
      for (const ContactPair &pair : pairs)
        {
          const std::string file = write_contact(context,
                                                 pair,
                                                 pairs.size() > 1,
                                                 full,
                                                 pressed.model().initial_gap,
                                                 report);
          if (name.empty())
            name = file;
        }
      return name;
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
      const auto              &contacts = context.parameters.scene.contacts;
      const LoadSteps          columns(contacts);
      std::vector<std::string> shown = {
        "value", "load_share", "normal_n", "n_open"};
      for (unsigned int i = 0; i < contacts.size(); ++i)
        for (const char *name : {"leading_edge_factor",
                                 "secant_stiffness_n_per_m",
                                 "secant_stiffness_of_load_n_per_m"})
          shown.push_back(columns.column(i, name));
      report.table(table, "Secant contact stiffness", shown);
    }



    /** Friction of the pairs that slide together, and of each curved one the
     * moment about the axis of its target, which its resultant does not tell.
     */
    std::vector<std::pair<std::string, std::string>>
    friction_figures(const PressedModel    &pressed,
                     const SteadySliding   &full,
                     const SceneParameters &scene)
    {
      const auto                                      &nodes = pressed.nodes();
      std::vector<std::pair<std::string, std::string>> figures(1);
      double                                           sum       = 0.;
      bool                                             is_curved = false;
      for (const ContactPair &pair : nodes.pairs())
        {
          if (!is_summed(nodes, pair))
            continue;
          sum += friction_along_sliding(pair, pair.part(full.forces));
          if (is_flat(pair.geometry))
            continue;
          is_curved                 = true;
          const std::string &target = pair.parameters.target_body;
          if (target == "ground" || !pair.slides())
            continue;
          const auto &body = scene.bodies[body_index(scene, target)];
          figures.emplace_back(
            (nodes.pairs().size() > 1 ? pair.name() + ": " : std::string()) +
              "moment on " + pair.parameters.source_body +
              " about the rotation axis of " + target,
            rounded_text(
              moment_about_axis(pair.geometry, pair.part(full.forces), body),
              6) +
              " N m");
        }
      figures[0] = {is_curved ? "friction of the nodes, each along its sliding"
                              : "friction force",
                    rounded_text(sum, 6) + " N"};
      return figures;
    }



    /** The contact under the full load, the last of @p steps, as figures of the
     * run. */
    std::vector<std::pair<std::string, std::string>>
    full_load_figures(const LoadSteps       &steps,
                      const PressedModel    &pressed,
                      const SteadySliding   &full,
                      const SceneParameters &scene,
                      const unsigned int     n_unknowns)
    {
      const auto shown = [&](const std::string &name) {
        return steps.at_full_load(name);
      };
      std::vector<std::pair<std::string, std::string>> figures = {
        {"nodes open, slipping, sticking",
         shown("n_open") + ", " + shown("n_slip") + ", " + shown("n_stick")},
        {"normal force", shown("normal_n") + " N"}};
      for (const auto &figure : friction_figures(pressed, full, scene))
        figures.push_back(figure);
      for (unsigned int i = 0; i < scene.contacts.size(); ++i)
        {
          const bool         several = scene.contacts.size() > 1;
          const ContactPair &pair    = pressed.nodes().pairs()[i];
          const std::string  of =
            several ? scene.contacts[i].name + ": " : std::string();
          const auto add = [&](const std::string &title,
                               const std::string &value) {
            figures.emplace_back(of + title, value);
          };
          const auto own = [&](const std::string &name) {
            return shown(steps.column(i, name));
          };
          if (several)
            {
              add("nodes open, slipping, sticking",
                  own("n_open") + ", " + own("n_slip") + ", " + own("n_stick"));
              add("normal, friction force",
                  own("normal_n") + ", " +
                    rounded_text(
                      friction_along_sliding(pair, pair.part(full.forces)), 6) +
                    " N");
            }
          add("centre of pressure across, along the sliding",
              own("centre_x_m") + ", " + own("centre_y_m") + " m");
          add("leading-edge factor", own("leading_edge_factor"));
          add("peak pressure", own("peak_pressure_pa") + " Pa");
          add("secant stiffness", own("secant_stiffness_n_per_m") + " N/m");
        }
      figures.emplace_back("unknowns", std::to_string(n_unknowns));
      return figures;
    }



    /** "5 of 9 nodes slip, ..." under the full load. */
    std::string
    full_load_text(const LoadSteps &steps, const std::size_t n_nodes)
    {
      return steps.at_full_load("n_slip") + " of " + std::to_string(n_nodes) +
             " nodes slip, " + steps.at_full_load("n_stick") + " stick, " +
             steps.at_full_load("n_open") + " are open";
    }



    void
    log_steps(RunContext      &context,
              const LoadSteps &steps,
              const bool       is_at_rest)
    {
      context.log.heading(is_at_rest ? "Contact at rest" : "Steady sliding");
      std::ostringstream       text;
      const auto              &contacts = context.parameters.scene.contacts;
      std::vector<std::string> shown    = {"load_share",
                                           "normal_n",
                                           "tangential_n",
                                           "n_open",
                                           "n_slip",
                                           "n_stick"};
      for (unsigned int i = 0; i < contacts.size(); ++i)
        {
          if (contacts.size() > 1)
            shown.push_back(steps.column(i, "normal_n"));
          else
            shown.push_back("leading_edge_factor");
          shown.push_back(steps.column(i, "secant_stiffness_n_per_m"));
        }
      steps.table().print(text, shown);
      context.log.info(text.str());
    }
  } // namespace



  void
  run_preload(RunContext &context)
  {
    const Parameters p = loaded_scene(context.parameters);
    Model            model(p, context.timers, {}, Model::Contacts::open);
    check_stiffness_entry(p, model);
    model.print_summary(context.log);
    warn_of_frozen_rotors(model, context.log);
    if (p.output.export_matrices)
      write_open_scene(context, model, "matrices");
    const SteadyModel full =
      pressed_model(p, model, p.eigen.highest_frequency, context.timers)
        .steady(p.preload.tolerance, context.timers);
    const PressedModel &pressed = full.pressed;
    warn_of_large_strains(p.scene, pressed, full.sliding, context.log);
    const auto states = load_steps(full, p, context.timers);
    LoadSteps  steps(p.scene.contacts,
                    p.preload.run_in == PreloadParameters::RunIn::archard);
    for (std::size_t k = 0; k < states.size(); ++k)
      steps.add(pressed, states[k], double(k + 1) / states.size());
    context.write_table("preload.csv", steps.table());
    context.write_table("contact.csv",
                        contact_nodes_table(pressed, full.sliding));
    const auto mesh_error =
      preload_mesh_error(p, model, steps, context.log, context.timers);
    if (mesh_error)
      context.write_table("preload_mesh_error.csv", *mesh_error);

    const bool is_at_rest = pressed.speed() == 0.;
    log_steps(context, steps, is_at_rest);
    record_unknowns(model, context.record);
    context.record.figures = full_load_figures(
      steps, pressed, full.sliding, p.scene, model.n_unknowns());

    HtmlReport report(
      (is_at_rest ? "Contact at rest of " : "Steady sliding of ") +
        p.scene.name,
      "pressure under the loads, compression positive");
    report.set_verdict(HtmlReport::Verdict::neutral,
                       full_load_text(steps, pressed.nodes().n_nodes()) + "; " +
                         mesh_error_text(mesh_error),
                       context.record.figures);
    std::string open_this;
    if (context.is_root)
      {
        steps.write_json(p.scene.contacts, context.output.file("preload.json"));
        open_this = write_contacts(context, pressed, full.sliding, report);
      }
    report.section("Load steps");
    report.table(steps.table(), "Contact over the load");
    if (mesh_error)
      {
        report.section("Error by the mesh");
        report.table(*mesh_error, "Full load, and with one degree less");
      }
    if (!p.preload.stiffness_entry.empty())
      report_stiffness(context, report);
    context.finish(p.output.report ? &report : nullptr, open_this);
  }
} // namespace squeal
