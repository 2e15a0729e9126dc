// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/motion_output.h>
#include <squeal/analyses/transient/saved_transient.h>
#include <squeal/analyses/transient/transient_sound.h>

#include <squeal/analyses/analyses.h>
#include <squeal/analyses/transient/transient_results.h>
#include <squeal/analyses/transient/transient_verdict.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/stop_request.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/model/drive_warnings.h>
#include <squeal/model/rotor_symmetry.h>
#include <squeal/model/strain_warnings.h>
#include <squeal/output/moving_pictures.h>
#include <squeal/output/open_scene_output.h>
#include <squeal/output/record_unknowns.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** Goes on to the end with progress and checkpoints; a signal ends the
     * program after one more checkpoint. */
    void
    integrate(TransientRun &run, SavedTransient &saved, RunContext &context)
    {
      const auto &t = context.parameters.transient;
      saved.resume(run, context);
      StopRequest stop;
      bool        finished;
      {
        Timers::Section section(context.timers, "Solve: time steps");
        Progress        progress(context.log, "time steps", run.n_steps_left());
        double          last = wall_seconds();
        finished             = run.advance([&](const unsigned int n) {
          progress.advance(
            n,
            "t = " + rounded_text(run.record().samples.back().time, 4) + " s");
          if (t.checkpoint_interval > 0. &&
              wall_seconds() - last > t.checkpoint_interval)
            {
              saved.write(run);
              last = wall_seconds();
            }
          return stop.is_there();
        });
      }
      if (!finished)
        {
          saved.write(run);
          context.log.info("stopped; the same command continues from " +
                           saved.path());
          stop.repeat();
          throw ComputationError("stopped by a signal");
        }
    }

    /** Tables of the run but for that over a changing speed. */
    struct RunTables
    {
      Table summary, branches, zones, phases;
    };



    RunTables
    write_tables(RunContext              &context,
                 const PreparedTransient &prepared,
                 const TransientRecord   &record,
                 const TransientFigures  &f)
    {
      RunTables tables = {transient_table(f),
                          branch_table(f),
                          zone_table(prepared, record),
                          phase_table(record, f)};
      context.write_table("transient.csv", tables.summary);
      context.write_table("branches.csv", tables.branches);
      context.write_table("forces.csv", force_table(prepared, record));
      context.write_table("energy.csv", energy_table(prepared, record));
      context.write_table("probes.csv", probe_table(prepared, record));
      context.write_table("zones.csv", tables.zones);
      context.write_table("phase.csv", tables.phases);
      return tables;
    }



    /** History (null on other ranks than the root), JSON and sound. */
    void
    write_files(RunContext              &context,
                const PreparedTransient &prepared,
                const TransientRecord   &record,
                const TransientFigures  &f,
                const HistoryStream     *history)
    {
      if (!context.is_root)
        return;
      Timers::Section section(context.timers, "Write: history");
      write_transient_json(
        f,
        explained_verdict(
          f, evaluate_trigger(record, f, context.parameters.transient)),
        context.output.file("transient.json"));
      write_sounds(context, prepared, record, f);
      if (history->n_samples() > 0)
        write_contact_history(prepared,
                              *history,
                              context.parameters.scene.name,
                              context.output.file("contact_history.h5"));
    }



    std::vector<std::pair<std::string, std::string>>
    figures_of_run(const Table            &summary,
                   const TransientFigures &f,
                   const TriggerOutcome   &trigger,
                   const bool              is_reduced)
    {
      const auto shown = [&](const std::string &name) {
        return summary.display(0, summary.column_index(name));
      };
      const auto by_cut = [&](const std::string &name) {
        return summary.is_missing(0, name) ? "" : " +- " + shown(name);
      };
      const bool        has_fit = !summary.is_missing(0, "growth_rate_per_s");
      const std::string reduction =
        f.leading < 0 || !is_reduced
          ? ""
          : "; motions above the cut-off would add " +
              shown("sigma_error_reduction_per_s") + " 1/s, " +
              shown("frequency_error_reduction_hz") + " Hz";
      std::vector<std::pair<std::string, std::string>> figures = {
        {"verdict", explained_verdict(f, trigger)},
        {"growth rate",
         has_fit
           ? shown("growth_rate_per_s") + " +- " +
               shown("growth_rate_ci_per_s") + " 1/s at " +
               shown("growth_frequency_hz") +
               " Hz (fit and time step; mesh error not estimated)" + reduction
           : reason_for_no_rate(f)},
        {"linearised about steady sliding",
         f.leading < 0 ? "no pair in the band"
                       : shown("sigma_linear_per_s") + " 1/s at " +
                           shown("frequency_linear_hz") + " Hz"},
        {"limit cycle", limit_cycle_text(f)},
        {"normal force" + of_judged(f.loudest),
         shown(f.loudest.name.empty() ? "mean_normal_n"
                                      : "loudest_mean_normal_n") +
           by_cut("mean_normal_error_n") + " N, rms " + shown("rms_normal_n") +
           by_cut("rms_normal_error_n") + " N" +
           (f.loudest.is_beside_sums() ? " of the " + f.loudest.force_name
                                       : "") +
           ", which changes by " + shown("rms_normal_change_n") +
           " N from half to half of its time, " +
           (f.min_normal < 1e-6 * f.mean_normal ? "0" : shown("min_normal_n")) +
           " to " + shown("max_normal_n") + " N"},
        {"nodes: slip, stick, stick-slip, separating, never closed",
         shown("n_slip") + ", " + shown("n_sticking") + ", " +
           shown("n_stick_slip") + ", " + shown("n_separating") + ", " +
           shown("n_never")},
        {"worst imbalance of the ledger", shown("worst_imbalance")},
        {"steps per second",
         shown("steps_per_second") + ", " + shown("iterations_per_step") +
           " iterations a step"}};
      if (!f.loudest.name.empty())
        figures.emplace_back("mean normal force of the sliding pairs together",
                             shown("mean_normal_n") + " N");
      if (!trigger.text.empty())
        figures.emplace_back(
          "outcome",
          trigger.text + ": rms of the " +
            (trigger.pair.is_beside_sums() ? trigger.pair.force_name
                                           : "normal force") +
            of_judged(trigger.pair) + " " + rounded_text(trigger.before, 3) +
            " N before the trigger, " + rounded_text(trigger.after, 3) +
            " N after it, " + rounded_text(trigger.end, 3) + " N at the end");
      return figures;
    }



    void
    log_pairs(RunLog &log, const Table &branches)
    {
      log.heading("Pairs about steady sliding and in time");
      std::ostringstream text;
      branches.print(text,
                     {"branch",
                      "frequency_linear_hz",
                      "sigma_linear_per_s",
                      "sigma_cea_per_s",
                      "frequency_transient_hz",
                      "growth_rate_per_s",
                      "growth_rate_ci_per_s",
                      "e_foldings"});
      log.info(text.str());
    }



    /** Warns where the linearised motion and the eigenvalues of the whole model
     * differ by more than what the reduction leaves out: their contacts are
     * then not the same. */
    void
    warn_of_other_contact(const TransientFigures &f,
                          const bool              is_damped_at_cut_off,
                          RunLog                 &log)
    {
      for (const BranchResult &b : f.branches)
        {
          const double difference = b.sigma_cea - b.sigma - b.sigma_reduction,
                       allowed    = std::max(3., .02 * std::abs(b.sigma_cea)) +
                                 std::abs(b.sigma_reduction);
          if (std::isfinite(b.sigma_cea) && !(std::abs(difference) <= allowed))
            log.warning(
              "the pair at " + rounded_text(b.frequency, 6) +
              " Hz has sigma = " + rounded_text(b.sigma, 4) +
              " 1/s in the motion linearised about steady sliding and " +
              rounded_text(b.sigma_cea, 4) +
              " 1/s in the eigenvalue analysis, which the reduction does not "
              "explain: " +
              (is_damped_at_cut_off ? "'Transient/Cut-off damping' takes part "
                                      "in time alone, where "
                                    : "in time ") +
              "springs of the contact have no damping, and tangential "
              "ones act in series with the slip");
        }
    }

    /** Warns where the rms of a limit cycle has not settled. */
    void
    warn_of_rising_rms(const TransientFigures &f, RunLog &log)
    {
      if (f.has_limit_cycle &&
          std::abs(f.rms_change_share) > settled_rms_change)
        log.warning(
          "the rms of the limit cycle still " +
          std::string(f.rms_change_share > 0. ? "rises" : "falls") + ", by " +
          rounded_text(100. * std::abs(f.rms_change_share), 2) +
          " % between the halves of the time that it is taken over: raise "
          "'Transient/End time'");
    }

    void
    report_run(RunContext              &context,
               const Model             &model,
               const PreparedTransient &prepared,
               const TransientRecord   &record,
               const TransientFigures  &f,
               const HistoryStream     *history)
    {
      const auto     &p      = context.parameters;
      const RunTables tables = write_tables(context, prepared, record, f);
      write_files(context, prepared, record, f, history);
      const TriggerOutcome trigger  = evaluate_trigger(record, f, p.transient);
      const std::string    left_out = left_out_text(f);
      context.record.figures        = figures_of_run(
        tables.summary,
        f,
        trigger,
        p.transient.integrator == TransientParameters::Integrator::reduced);
      const bool  has_ramp = p.transient.final_speed_ratio != 1.;
      const Table speeds   = speed_table(prepared, record, f, p);
      if (has_ramp)
        context.write_table("speeds.csv", speeds);
      const Block motion =
        record.frames.empty() ? Block() : motion_of_frames(prepared, record, p);
      const std::string animation =
        write_animation(context, model, prepared, record, motion);
      log_pairs(context.log, tables.branches);
      warn_of_other_contact(f, p.transient.cut_off_damping > 0., context.log);
      if (const std::string text = text_of_moment(f); !text.empty())
        context.log.warning(text);
      warn_of_rising_rms(f, context.log);
      if (f.is_beyond_in_steps)
        context.log.warning(text_of_sampling(
          f.beyond_samples, p.transient.sample_interval, true));
      if (!left_out.empty())
        context.log.info("  " + left_out);

      HtmlReport report("Transient of " + p.scene.name,
                        "motion in time about steady sliding");
      report.set_verdict(f.verdict == "unstable" || squeals(f, trigger) ||
                             prepared.outside.fastest().real() > 0.
                           ? HtmlReport::Verdict::bad
                         : f.verdict == "stable" ? HtmlReport::Verdict::good
                                                 : HtmlReport::Verdict::neutral,
                         (has_ramp ? least_friction_text(speeds) + "; " : "") +
                           transient_headline(f, trigger),
                         context.record.figures);
      if (p.output.plots && context.is_root)
        {
          Timers::Section section(context.timers, "Write: charts");
          draw_transient(context, prepared, record, f, *history, report);
          draw_phases(context, {{"", tables.phases}}, report);
          if (has_ramp)
            draw_speeds(context, speeds, report);
        }
      if (motion.cols() > 1)
        {
          report.section("Motion");
          // The view has one place for every point.
          if (p.transient.disc_frame ==
              TransientParameters::DiscFrame::corotating)
            report.paragraph("The mesh turns: motion.pvd has it in ParaView.");
          else
            show_frames(context,
                        model,
                        motion,
                        "The last " + std::to_string(motion.cols()) +
                          " samples",
                        report);
        }
      report.section("Pairs");
      if (!left_out.empty())
        report.paragraph(left_out);
      report.table(tables.branches, "Pairs about steady sliding and in time");
      report.section("Contact zones");
      report.table(tables.zones, "Second half of the run", {}, {}, false);
      context.finish(p.output.report ? &report : nullptr, animation);
    }



    /** Warns where what the reduced model leaves out counts for a growing pair
     * of the band. */
    void
    report_reduction(const PreparedTransient &prepared,
                     const Parameters        &p,
                     RunLog                  &log)
    {
      if (p.transient.integrator != TransientParameters::Integrator::reduced)
        return;
      for (const unsigned int k : prepared.branches)
        {
          const std::complex<double> lambda = prepared.linear.lambda[k],
                                     error  = prepared.reduction_errors[k];
          if (lambda.real() > 0. &&
              std::abs(error.real()) > std::max(3., .02 * lambda.real()))
            log.warning("the motions above the cut-off, without mass and "
                        "damping here, would add about " +
                        rounded_text(error.real(), 2) + " 1/s to the " +
                        rounded_text(lambda.real(), 3) +
                        " 1/s of the pair at " +
                        rounded_text(lambda.imag() / (2. * M_PI), 6) +
                        " Hz: raise 'Transient/Cut-off' or 'Interface "
                        "cut-off'");
        }
    }



    /** Warns where a growing motion is too fast for the samples. */
    void
    warn_of_sampling(const LinearizedMotion    &linear,
                     const TransientParameters &t,
                     RunLog                    &log)
    {
      const double f = frequency_beyond_samples(linear, t, t.sample_interval);
      if (f > 0.)
        log.warning(text_of_sampling(f, t.sample_interval, false));
    }

    /** What grows fastest in the reduced model about steady sliding, in the
     * band or not, and whether the run has that motion. */
    void
    report_fastest(const PreparedTransient &prepared,
                   const Parameters        &p,
                   RunLog                  &log)
    {
      const LinearizedMotion &linear = prepared.linear;
      Eigen::Index            k;
      const double            sigma     = linear.lambda.real().maxCoeff(&k);
      const double            frequency = linear.lambda[k].imag() / (2. * M_PI);
      const std::string       text      = "sigma of " + rounded_text(sigma, 5) +
                               " 1/s at " + rounded_text(frequency, 6) + " Hz";
      const bool is_there = is_of_the_run(linear.lambda[k], p.transient);
      const bool has_all =
        p.transient.integrator == TransientParameters::Integrator::reduced;
      log.info(
        "  largest of " +
        std::string(has_all ? "all motions" : "the motions below the cut-off") +
        " about steady sliding: " + text +
        (is_there ? ""
                  : ", of the reduced model above its cut-off, which "
                    "this run does not use"));
      if (const std::string of_reduction =
            text_of_growth_of_reduction(prepared.outside);
          !of_reduction.empty() && !has_all)
        log.info("  " + of_reduction + ", so that this run does not have it");
      if (const std::string growing = text_of_growth_outside(
            growth_of_run(prepared.outside, p.transient));
          !growing.empty())
        log.warning(growing + ": the branches do not show it" +
                    (prepared.outside.is_led_by_reduction() && has_all
                       ? "; raise 'Transient/Cut-off'"
                       : ""));
    }
  } // namespace



  void
  run_transient(RunContext &context)
  {
    if (!context.parameters.sweep.axes.empty() ||
        !context.parameters.transient.tops.empty() ||
        !context.parameters.transient.integrators.empty())
      return run_campaign(context);
    Parameters p = context.parameters;
    warn_of_drive(p, context.log);
    for (auto &contact : p.scene.contacts)
      contact.state = ContactParameters::State::full;
    Model model(p, context.timers, {}, Model::Contacts::open);
    model.print_summary(context.log);
    if (p.transient.disc_frame == TransientParameters::DiscFrame::eulerian)
      warn_of_frozen_rotors(model, context.log);
    if (p.output.export_matrices)
      write_open_scene(context, model, "matrices");
    const auto              earlier = SavedTransient::earlier_modes(context);
    const PreparedTransient prepared(
      pressed_model(p,
                    model,
                    p.transient.cut_off,
                    context.timers,
                    p.transient.interface_cut_off,
                    earlier ? &*earlier : nullptr),
      p,
      context.timers);
    record_unknowns(model, context.record);
    context.log.key_values(
      {{"modes up to the cut-off",
        std::to_string(prepared.pressed.model().n_modes())},
       {"contact nodes", std::to_string(prepared.pressed.model().n_nodes())},
       {"closed in steady sliding", std::to_string(prepared.steady.n_closed())},
       {"pairs in the band", std::to_string(prepared.branches.size())}});
    report_cut_off_damping(prepared.pressed,
                           prepared.steady,
                           prepared.linear,
                           growing_pairs(prepared.linear, p.eigen),
                           p,
                           context.log);
    warn_of_sampling(prepared.motions(p), p.transient, context.log);
    warn_of_large_strains(
      p.scene, prepared.pressed, prepared.steady, context.log);
    warn_of_short_lag(prepared.pressed, prepared.steady, p, context.log);
    report_fastest(prepared, p, context.log);
    report_reduction(prepared, p, context.log);
    SavedTransient saved(prepared.pressed, context);
    TransientRun   run(prepared.pressed,
                     prepared.steady,
                     prepared.linear,
                     prepared.branches,
                     p,
                     saved.history());
    integrate(run, saved, context);
    ComplexPairs cea;
    if (p.transient.compare_with_cea)
      cea = whole_model_pairs(p,
                              prepared.pressed.states_of(prepared.steady),
                              context.log,
                              context.timers);
    report_run(context,
               model,
               prepared,
               run.record(),
               evaluate_transient(
                 prepared, run.record(), p, cea.size() > 0 ? &cea : nullptr),
               saved.history());
    saved.remove();
  }
} // namespace squeal
