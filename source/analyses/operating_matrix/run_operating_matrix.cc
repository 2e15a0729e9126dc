// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/analyses.h>
#include <squeal/analyses/operating_matrix/operating_chart.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/model/cea_solution.h>
#include <squeal/model/frequency_pencil.h>
#include <squeal/model/pressed_model.h>
#include <squeal/output/cea_quantities.h>
#include <squeal/output/headline_error.h>
#include <squeal/output/loudest_pairs.h>
#include <squeal/scene/modulus_table.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** What one model is solved at, about a steady sliding of its own. */
    struct Condition
    {
      std::optional<double> pressure, speed, temperature;
      bool                  backward = false;
    };

    /** @p values or, where there are none, the one of the scene. */
    std::vector<std::optional<double>>
    or_of_scene(const std::vector<double> &values)
    {
      if (values.empty())
        return {std::nullopt};
      return {values.begin(), values.end()};
    }

    std::vector<Condition>
    conditions(const OperatingMatrixParameters &m)
    {
      std::vector<Condition> result;
      for (const bool backward : {false, true})
        if (!backward || m.both_directions)
          for (const auto &speed : or_of_scene(m.speeds))
            for (const auto &pressure : or_of_scene(m.pressures))
              for (const auto &temperature : or_of_scene(m.temperatures))
                result.push_back({pressure, speed, temperature, backward});
      return result;
    }

    Parameters
    at_condition(Parameters p, const Condition &c)
    {
      for (auto &load : p.scene.loads)
        if (c.pressure && load.pressure != 0.)
          load.pressure = *c.pressure;
      for (auto &contact : p.scene.contacts)
        {
          if (c.speed && contact.sliding_speed > 0.)
            contact.sliding_speed = *c.speed;
          if (c.backward)
            contact.friction_coefficient *= -1.;
        }
      return p;
    }

    /** The scene with all tables at the temperature and the pressure of a
     * condition and their moduli of the reference frequency. */
    SceneParameters
    with_moduli(const Parameters &p, const Condition &c)
    {
      SceneParameters     scene = p.scene;
      const ModulusTables tables(scene);
      for (auto &body : scene.bodies)
        {
          if (c.temperature && body.has_modulus_table())
            body.temperature = *c.temperature;
          if (c.pressure && tables.depend_on_pressure(body))
            body.pressure = *c.pressure;
        }
      tables.require_band(
        scene, p.eigen.lowest_frequency, p.eigen.highest_frequency);
      return tables.at(scene, reference_frequency(p.eigen));
    }

    std::vector<Table::Column>
    columns()
    {
      using Type                        = Table::Type;
      std::vector<Table::Column> result = {
        {"pressure_pa", Type::real, "Pa", "of all loads that press", 6},
        {"temperature_c", Type::real, "degrees Celsius", "of all tables", 5},
        {"speed_m_per_s", Type::real, "m/s", "sliding speed", 5},
        {"direction", Type::text, "", "forward or backward"}};
      append_pair_columns(result);
      result.push_back({"n_unstable",
                        Type::integer,
                        "",
                        "unstable pairs in the band under these conditions"});
      return result;
    }

    std::string
    text_of(const Condition &c)
    {
      std::string text = c.backward ? "backward" : "forward";
      if (c.pressure)
        text += ", " + rounded_text(*c.pressure, 4) + " Pa";
      if (c.speed)
        text += ", " + rounded_text(*c.speed, 4) + " m/s";
      if (c.temperature)
        text += ", " + rounded_text(*c.temperature, 4) + " degrees Celsius";
      return text;
    }

    /** Rows of all unstable pairs, the loudest last; of the loudest alone where
     * none is unstable. */
    std::vector<std::vector<Cell>>
    rows_of(const Model        &model,
            const ModeSolution &modes,
            const ComplexPairs &pairs,
            const Condition    &c)
    {
      const PairQuantities quantities = pair_quantities(model, modes, pairs);
      const LoudestPairs   listed     = loudest_pairs(pairs);
      const auto           given      = [](const std::optional<double> &value) {
        return value ? Cell(*value) : Cell();
      };
      std::vector<std::vector<Cell>> result;
      for (const unsigned int i : listed.numbers)
        {
          std::vector<Cell> row = {given(c.pressure),
                                   given(c.temperature),
                                   given(c.speed),
                                   c.backward ? "backward" : "forward"};
          append_pair_cells(row, pairs, quantities, i);
          row.push_back(listed.n_unstable);
          result.push_back(std::move(row));
        }
      return result;
    }

    /** A condition's scene, at its moduli: the contact of steady sliding
     * depends on them, too. */
    Parameters
    parameters_of(const Parameters &p, const Condition &c)
    {
      Parameters here = at_condition(p, c);
      here.scene      = with_moduli(here, c);
      return here;
    }

    /** Conditions of one pressure and one temperature: bodies and loads are the
     * same, which speed and direction do not change. */
    std::map<std::pair<std::optional<double>, std::optional<double>>,
             std::vector<std::size_t>>
    with_same_bodies(const std::vector<Condition> &all)
    {
      std::map<std::pair<std::optional<double>, std::optional<double>>,
               std::vector<std::size_t>>
        result;
      for (std::size_t k = 0; k < all.size(); ++k)
        result[{all[k].pressure, all[k].temperature}].push_back(k);
      return result;
    }

    /** The scene of a condition cut open and pressed on. */
    struct PressedCondition
    {
      PressedCondition(const Parameters &p, Timers &timers)
        : parameters(without_damping(p))
        , open(parameters, timers, {}, Model::Contacts::open)
        , pressed(pressed_for_states(parameters, open, timers))
      {
      }
      const Parameters   parameters;
      const Model        open;
      const PressedModel pressed;
    };

    /** The pairs under one condition, as rows; @p pressed: of its bodies, none
     * where no contact asks for it. */
    std::vector<std::vector<Cell>>
    solve_condition(const Parameters       &here,
                    const Condition        &c,
                    const PressedCondition *pressed,
                    RunContext             &context)
    {
      std::vector<ContactStates> states;
      if (pressed)
        {
          const Parameters undamped = without_damping(here);
          states                    = preload_states(
            pressed->pressed.with_sliding(undamped, context.timers),
            undamped,
            context.timers);
        }
      Model             model(here, context.timers, states);
      ModeSolution      modes = solve_modes(model, context.log, context.timers);
      const CeaSolution solution =
        solve_cea(model, modes, context.log, context.timers);
      context.record.n_dofs = model.n_unknowns();
      if (solution.pairs.size() == 0)
        refuse_empty_band(here, modes);
      return rows_of(model, modes, solution.pairs, c);
    }

    /** Rows of the pairs under every condition, in their order. */
    std::vector<std::vector<std::vector<Cell>>>
    solve_conditions(const std::vector<Condition> &all, RunContext &context)
    {
      std::vector<std::vector<std::vector<Cell>>> result(all.size());
      std::size_t                                 n_done = 0;
      for (const auto &[key, members] : with_same_bodies(all))
        {
          std::optional<PressedCondition> pressed;
          for (const std::size_t k : members)
            {
              context.log.heading(text_of(all[k]) + ", " +
                                  std::to_string(++n_done) + " of " +
                                  std::to_string(all.size()));
              const Parameters here = parameters_of(context.parameters, all[k]);
              if (!pressed && has_preload_state(here.scene))
                pressed.emplace(here, context.timers);
              result[k] = solve_condition(
                here, all[k], pressed ? &*pressed : nullptr, context);
            }
        }
      return result;
    }

    /** Where it squeals, in a sentence. */
    std::string
    verdict_of(const Table &loudest)
    {
      std::size_t           n = 0, most = 0;
      std::set<std::string> names;
      for (std::size_t i = 0; i < loudest.n_rows(); ++i)
        {
          if (loudest.integer(i, "n_unstable") > 0)
            {
              ++n;
              names.insert(loudest.text(i, "name"));
            }
          if (loudest.real(i, "sigma_per_s") >
              loudest.real(most, "sigma_per_s"))
            most = i;
        }
      std::ostringstream text;
      text << "unstable under " << n << " of " << loudest.n_rows()
           << " conditions";
      if (n == 0)
        return text.str();
      text << ", loudest with "
           << rounded_text(loudest.real(most, "sigma_per_s"), 4) << " 1/s at "
           << rounded_text(loudest.real(most, "frequency_hz"), 5) << " Hz ("
           << loudest.text(most, "name") << ", "
           << loudest.text(most, "direction");
      for (const auto &[column, unit] :
           {std::make_pair("pressure_pa", " Pa"),
            std::make_pair("temperature_c", " degrees Celsius"),
            std::make_pair("speed_m_per_s", " m/s")})
        if (!loudest.is_missing(most, column))
          text << ", " << rounded_text(loudest.real(most, column), 4) << unit;
      text << ")";
      return text.str();
    }
  } // namespace



  void
  run_operating_matrix(RunContext &context)
  {
    const auto &p              = context.parameters;
    const auto  all_conditions = conditions(p.operating_matrix);
    // What some table does not cover ends the run before any work.
    for (const Condition &c : all_conditions)
      parameters_of(p, c);
    Table all(columns()), loudest(columns());
    for (const auto &rows : solve_conditions(all_conditions, context))
      {
        for (const auto &row : rows)
          all.add_row(row);
        loudest.add_row(rows.back());
      }
    context.write_table("operating_matrix.csv", loudest);
    context.write_table("operating_pairs.csv", all);
    context.log.heading("Loudest pair under every condition");
    std::ostringstream text;
    loudest.print(text);
    context.log.info(text.str());

    const std::string verdict = verdict_of(loudest);
    context.record.figures    = {
         {"which", verdict},
         {"largest error of a pair by the basis, relative",
          headline_error(
         {error_of_column("reduction", all, "error_estimate_rel")})},
         {"error by the mesh", "not estimated here; Analysis = cea states it"},
         {"unknowns", std::to_string(context.record.n_dofs)}};
    HtmlReport report("Operating matrix of " + p.scene.name,
                      "lambda = sigma + i omega, sigma > 0 unstable");
    const auto n_unstable = loudest.reals("sigma_per_s");
    report.set_verdict(*std::max_element(n_unstable.begin(), n_unstable.end()) >
                           0.
                         ? HtmlReport::Verdict::bad
                         : HtmlReport::Verdict::good,
                       verdict,
                       context.record.figures);
    if (p.output.plots && context.is_root)
      {
        context.output.file("plots/operating_matrix.png");
        const std::string path =
          context.output.path() + "/plots/operating_matrix";
        context.plotter.draw(operating_chart(loudest), path);
        report.section("Where it squeals");
        report.figure(path + ".png",
                      "Loudest pair: growth rate as colour, frequency in kHz "
                      "above the growth rate in 1/s",
                      true);
      }
    report.section("Loudest pair under every condition");
    report.table(loudest, "operating_matrix.csv");
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
