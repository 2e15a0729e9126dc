// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/preload/loaded_scene.h>
#include <squeal/analyses/preload/preload_tables.h>
#include <squeal/analyses/transient/transient_results.h>
#include <squeal/analyses/work_precision/rung_figures.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/model/pressed_model.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    /** Of the last row of a table, NaN where it has none. */
    double
    last_of(const Table &table, const std::string &column)
    {
      const std::size_t row = table.n_rows() - 1;
      return table.is_missing(row, column) ? std::nan("not there")
                                           : table.real(row, column);
    }

    void
    solve_steady_sliding(const Parameters &parameters,
                         Timers           &timers,
                         RungFigures      &rung)
    {
      const Parameters  p = loaded_scene(parameters);
      Model             model(p, timers, {}, Model::Contacts::open);
      const SteadyModel full =
        pressed_model(p, model, p.eigen.highest_frequency, timers)
          .steady(p.preload.tolerance, timers);
      const auto &contacts = p.scene.contacts;
      LoadSteps   steps(contacts);
      steps.add(full.pressed, full.sliding, 1.);
      const Table &t  = steps.table();
      rung.n_unknowns = model.n_unknowns();
      rung.verdict    = last_of(t, "n_open") > 0. ? "part of the face is open"
                                                  : "the whole face is closed";
      rung.figures.push_back({"tangential_n", last_of(t, "tangential_n")});
      for (unsigned int i = 0; i < contacts.size(); ++i)
        for (const char *name : {"secant_stiffness_n_per_m",
                                 "centre_x_m",
                                 "centre_y_m",
                                 "leading_edge_factor",
                                 "peak_pressure_pa"})
          {
            const std::string column = steps.column(i, name);
            rung.figures.push_back({column, last_of(t, column)});
          }
    }

    /** Goes to the end, without checkpoints. */
    void
    run_to_end(TransientRun &run, RunLog &log, Timers &timers)
    {
      Timers::Section section(timers, "Solve: time steps");
      Progress        progress(log, "time steps", run.n_steps_left());
      run.advance([&](const unsigned int n) {
        progress.advance(n);
        return false;
      });
    }

    /** Growth where there is a fit, the limit cycle where there is one. */
    std::vector<RungFigure>
    figures_of_transient(const Table &t)
    {
      const bool has_cycle = t.text(0, "limit_cycle") == "yes";
      const auto of_cycle  = [&](const std::string &name) {
        return has_cycle ? last_of(t, name) : std::nan("no limit cycle");
      };
      return {{"growth_rate_per_s",
               last_of(t, "growth_rate_per_s"),
               last_of(t, "growth_rate_ci_per_s")},
              {"growth_frequency_hz", last_of(t, "growth_frequency_hz")},
              {"limit_cycle_frequency_hz",
               of_cycle("limit_cycle_frequency_hz"),
               of_cycle("limit_cycle_frequency_ci_hz")},
              {"rms_normal_n", of_cycle("rms_normal_n")},
              {"leading_edge_factor", last_of(t, "leading_edge_factor")},
              {"worst_imbalance",
               last_of(t, "worst_imbalance"),
               std::nan("not stated"),
               true}};
    }

    void
    solve_transient(const Parameters &parameters,
                    RunLog           &log,
                    Timers           &timers,
                    RungFigures      &rung)
    {
      Parameters p = parameters;
      for (auto &contact : p.scene.contacts)
        contact.state = ContactParameters::State::full;
      Model                   model(p, timers, {}, Model::Contacts::open);
      const PreparedTransient prepared(
        pressed_model(
          p, model, p.transient.cut_off, timers, p.transient.interface_cut_off),
        p,
        timers);
      TransientRun run(prepared.pressed,
                       prepared.steady,
                       prepared.linear,
                       prepared.branches,
                       p);
      rung.n_unknowns = model.n_unknowns();
      rung.n_modes    = prepared.pressed.model().n_modes();
      rung.n_steps    = run.n_steps_left();
      run_to_end(run, log, timers);
      const TransientFigures f = evaluate_transient(prepared, run.record(), p);
      rung.verdict =
        f.verdict + (f.has_limit_cycle ? ", limit cycle" : ", no limit cycle");
      rung.figures = figures_of_transient(transient_table(f));
    }
  } // namespace



  bool
  RungFigures::is_solved() const
  {
    return !figures.empty();
  }

  double
  RungFigures::value_of(const std::string &name) const
  {
    for (const RungFigure &figure : figures)
      if (figure.name == name)
        return figure.value;
    return std::nan("not there");
  }

  RungFigures
  solve_rung(const Parameters &p, RunLog &log, Timers &timers)
  {
    RungFigures  rung;
    const double start = cpu_seconds();
    if (p.analysis == Parameters::Analysis::transient)
      solve_transient(p, log, timers, rung);
    else
      solve_steady_sliding(p, timers, rung);
    rung.seconds   = cpu_seconds() - start;
    rung.memory_mb = peak_memory_mb();
    return rung;
  }
} // namespace squeal
