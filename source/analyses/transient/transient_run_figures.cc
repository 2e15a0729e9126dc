// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/run_figures.h>
#include <squeal/analyses/transient/transient_results.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/model/pressed_model.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    /** Of the one row of a table, NaN where it has none. */
    double
    figure_of(const Table &table, const std::string &column)
    {
      return table.is_missing(0, column) ? std::nan("not there")
                                         : table.real(0, column);
    }

    /** Goes to the end, without checkpoints. */
    void
    go_to_end(TransientRun &run, RunLog &log, Timers &timers)
    {
      Timers::Section section(timers, "Solve: time steps");
      Progress        progress(log, "time steps", run.n_steps_left());
      run.advance([&](const unsigned int n) {
        progress.advance(n);
        return false;
      });
    }

    /** Growth where there is a fit, the limit cycle where there is one. */
    std::vector<RunFigure>
    figures_of_table(const Table &t)
    {
      const bool has_cycle = t.text(0, "limit_cycle") == "yes";
      const auto of_cycle  = [&](const std::string &name) {
        return has_cycle ? figure_of(t, name) : std::nan("no limit cycle");
      };
      return {{"growth_rate_per_s",
               figure_of(t, "growth_rate_per_s"),
               figure_of(t, "growth_rate_ci_per_s")},
              {"growth_frequency_hz", figure_of(t, "growth_frequency_hz")},
              {"limit_cycle_frequency_hz",
               of_cycle("limit_cycle_frequency_hz"),
               of_cycle("limit_cycle_frequency_ci_hz")},
              {"rms_normal_n",
               of_cycle("rms_normal_n"),
               std::abs(of_cycle("rms_normal_change_n"))},
              {"leading_edge_factor", figure_of(t, "leading_edge_factor")},
              {"worst_imbalance",
               figure_of(t, "worst_imbalance"),
               std::nan("not stated"),
               true}};
    }
  } // namespace



  RunFigures
  figures_of_transient(const Parameters &parameters,
                       RunLog           &log,
                       Timers           &timers)
  {
    RunFigures run;
    Parameters p = parameters;
    for (auto &contact : p.scene.contacts)
      contact.state = ContactParameters::State::full;
    Model                   model(p, timers, {}, Model::Contacts::open);
    const PreparedTransient prepared(
      pressed_model(
        p, model, p.transient.cut_off, timers, p.transient.interface_cut_off),
      p,
      timers);
    TransientRun motion(
      prepared.pressed, prepared.steady, prepared.linear, prepared.branches, p);
    run.n_unknowns = model.n_unknowns();
    run.n_modes    = prepared.pressed.model().n_modes();
    run.n_steps    = motion.n_steps_left();
    go_to_end(motion, log, timers);
    const TransientFigures f = evaluate_transient(prepared, motion.record(), p);
    run.verdict =
      f.verdict + (f.has_limit_cycle ? ", limit cycle" : ", no limit cycle");
    run.figures = figures_of_table(transient_table(f));
    return run;
  }
} // namespace squeal
