// SPDX-License-Identifier: LGPL-2.1-or-later

// What a transient says: growth of every branch in the linear phase, the limit
// cycle in the second half of the run.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/base/worst_of.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/model/cea_solution.h>
#include <squeal/transient/common_period.h>
#include <squeal/transient/growth_rule.h>
#include <squeal/transient/slow_part.h>
#include <squeal/transient/time_step_error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

    /** Share by which the frequency of a fit may be off that of its pair. */
    constexpr double same_frequency = 0.02;

    /** The longest stretch of samples without a change of status. */
    std::pair<std::size_t, std::size_t>
    linear_phase(const std::vector<TransientSample> &samples)
    {
      std::pair<std::size_t, std::size_t> best{0, 0};
      for (std::size_t i = 0, first = 0; i <= samples.size(); ++i)
        if (i == samples.size() || samples[i].is_linear == 0.)
          {
            if (i - first > best.second - best.first)
              best = {first, i};
            first = i + 1;
          }
      return best;
    }

    double
    mean_of(const std::vector<double> &x)
    {
      double sum = 0.;
      for (const double value : x)
        sum += value;
      return x.empty() ? 0. : sum / x.size();
    }

    /** What the time step adds to lambda of every recorded branch, 1/s. */
    std::vector<std::complex<double>>
    step_errors(const PreparedTransient &prepared, const TransientParameters &t)
    {
      using Integrator = TransientParameters::Integrator;
      std::vector<std::complex<double>> result;
      const Eigen::VectorXcd            reduced =
        reduced_step_error(prepared.pressed.model(), prepared.linear, t.step());
      for (const unsigned int k : prepared.branches)
        {
          const std::complex<double> lambda   = prepared.linear.lambda[k],
                                     by_slope = prepared.linear.by_slope[k];
          const auto error                    = [&]() {
            switch (t.integrator)
              {
              case Integrator::implicit:
                return implicit_step_error(lambda, t.step(), by_slope);
              case Integrator::explicit_:
                return explicit_step_error(lambda,
                                           t.step(),
                                           t.beta_2,
                                           by_slope,
                                           prepared.linear.by_viscosity[k]);
              case Integrator::reduced:
                return std::complex<double>(reduced[k]);
              }
            unknown_choice("integrator");
          };
          result.push_back(error());
        }
      return result;
    }

    /** Growth of the pair of @p lambda over the samples @p linear. */
    GrowthFit
    fit_linear_phase(const std::vector<double>                 &times,
                     const std::vector<std::complex<double>>   &amplitudes,
                     const std::pair<std::size_t, std::size_t> &linear,
                     const std::complex<double>                 lambda)
    {
      if (linear.second < linear.first + 2)
        return {};
      const auto period  = static_cast<std::size_t>(std::round(
        2. * M_PI / std::abs(lambda.imag()) / (times[1] - times[0])));
      const auto turning = without_drift(
        {amplitudes.begin() + linear.first, amplitudes.begin() + linear.second},
        period);
      // What is left turns by its constant share a half period off the ends.
      const std::size_t edge = std::min(period, turning.size()) / 2;
      const auto        window =
        fit_window(turning, edge, turning.size() - edge, lambda.real() < 0.);
      return fit_growth(
        {times.begin() + linear.first, times.begin() + linear.second},
        turning,
        window.first,
        window.second);
    }

    void
    evaluate_branches(const PreparedTransient   &prepared,
                      const TransientRecord     &record,
                      const TransientParameters &settings,
                      const ComplexPairs        *cea,
                      TransientFigures          &f)
    {
      const auto   times    = record.times();
      const auto   linear   = linear_phase(record.samples);
      const double rms_from = 0.5 * times.back();
      if (linear.first < linear.second)
        {
          f.linear_start = times[linear.first];
          f.linear_end   = times[linear.second - 1];
        }
      const unsigned int n      = prepared.branches.size();
      const auto         errors = step_errors(prepared, settings);
      for (unsigned int k = 0; k < n; ++k)
        {
          const auto   lambda = prepared.linear.lambda[prepared.branches[k]];
          BranchResult b;
          b.sigma             = lambda.real();
          b.frequency         = lambda.imag() / (2. * M_PI);
          b.sigma_cea         = not_known;
          b.frequency_cea     = not_known;
          const auto left_out = prepared.reduction_errors[prepared.branches[k]];
          b.sigma_reduction   = left_out.real();
          b.frequency_reduction = left_out.imag() / (2. * M_PI);
          const auto a          = record.branch(k, n);
          b.fit                 = fit_linear_phase(times, a, linear, lambda);
          b.fit.include(errors[k]);
          // In the linear phase a pair turns at its own frequency. What does
          // not is a trace of other motions, and its slope nobody's rate.
          if (std::abs(b.fit.frequency - b.frequency) >
              same_frequency * b.frequency +
                std::abs(errors[k].imag()) / (2. * M_PI))
            b.fit.is_valid = false;
          b.fit.is_valid = tells_a_rate(b.fit);
          std::vector<double> sizes;
          for (std::size_t i = 0; i < a.size(); ++i)
            if (times[i] >= rms_from)
              sizes.push_back(std::norm(a[i]));
          b.last_amplitude = std::sqrt(mean_of(sizes));
          for (unsigned int i = 0; cea && i < cea->size(); ++i)
            if (const double d = std::abs(cea->lambda[i] - lambda);
                std::isnan(b.sigma_cea) ||
                d < std::hypot(b.sigma_cea - lambda.real(),
                               2. * M_PI * b.frequency_cea - lambda.imag()))
              {
                b.sigma_cea     = cea->sigma(i);
                b.frequency_cea = cea->frequency(i);
              }
          if (f.leading < 0 || b.sigma > f.branches[f.leading].sigma)
            f.leading = k;
          f.branches.push_back(b);
        }
    }

    std::string
    verdict_of(const TransientFigures &f)
    {
      if (f.leading < 0)
        return "undecided";
      const bool       decays_alone = f.growing_outside.empty();
      const GrowthFit &fit          = f.branches[f.leading].fit;
      if (!fit.is_valid)
        return "undecided";
      return fit.rate - fit.rate_ci > 0.                   ? "unstable"
             : fit.rate + fit.rate_ci < 0. && decays_alone ? "stable"
                                                           : "undecided";
    }

    void
    evaluate_nodes(const TransientRecord &record, TransientFigures &f)
    {
      double stick = 0., closed = 0.;
      for (const NodeShares &node : record.nodes)
        {
          stick += node.stick;
          closed += node.stick + node.slip;
          f.max_slip_speed_ratio =
            std::max(f.max_slip_speed_ratio, node.fastest_slip);
          f.peak_pressure = std::max(f.peak_pressure, node.peak_pressure);
          if (node.stick + node.slip == 0.)
            ++f.n_never;
          else if (node.open > 0.)
            ++f.n_separating;
          else if (node.slip == 0.)
            ++f.n_sticking;
          else if (node.stick > 0.)
            ++f.n_stick_slip;
          else
            ++f.n_slip;
        }
      f.stick_fraction = closed > 0. ? stick / closed : 0.;
    }

    /** The forces of the loudest pair over the second half, without their slow
     * parts, N: first the one that is judged, then sums, both moments and that
     * of the node that vibrates most, times the number of nodes. */
    std::vector<MotionSignal>
    signals_of_loudest(const PreparedTransient &prepared,
                       const TransientRecord   &record,
                       const TransientFigures  &f)
    {
      std::vector<MotionSignal> result;
      const auto add = [&](JudgedPair pair, const JudgedForce force) {
        pair.force                    = force;
        const std::vector<double> all = samples_of(record, pair);
        result.push_back({without_slow_part(
          {all.begin() + record.samples.size() / 2, all.end()})});
      };
      add(f.loudest, f.loudest.force);
      add(f.loudest, JudgedForce::normal);
      add(f.loudest, JudgedForce::tangential);
      for (const MomentParts &parts :
           {MomentParts{{1., 0.}}, MomentParts{{0., 1.}}})
        {
          JudgedPair pair = f.loudest;
          pair.parts      = parts;
          add(pair, JudgedForce::moment);
        }
      if (record.watched.numbers.empty())
        return result;
      add(f.loudest, JudgedForce::node);
      result.back().is_local = true;
      // Against its share of the normal force.
      const bool is_judged = f.loudest.force == JudgedForce::node;
      for (double &force : result.back().values)
        force *=
          is_judged
            ? 1.
            : prepared.pressed.nodes().pairs()[f.loudest.number].n_nodes();
      return result;
    }

    /** Frequency, lines and what the four quarters of the time say of them. */
    void
    evaluate_lines(const std::vector<MotionSignal> &signals,
                   const double                     interval,
                   const double                     lowest,
                   TransientFigures                &f)
    {
      const double       highest = highest_line(interval);
      const CommonPeriod period =
        common_period(signals, interval, lowest, highest);
      f.largest_line = period.largest_line;
      f.frequency    = period.frequency;
      f.frequency_ci = period.frequency_ci;
      f.repetition   = period.repetition;
      const Spectrum spectrum =
        power_spectrum(signals.front().values, interval);
      for (unsigned int k = 1; k <= 5 && k * f.frequency < highest; ++k)
        f.harmonics.push_back(spectrum.line_rms(k * f.frequency, 0.02 / k));
    }

    /** Whether every motion that the run has decays about steady sliding. */
    bool
    all_decay(const LinearizedMotion &linear, const TransientParameters &t)
    {
      return std::all_of(linear.lambda.begin(),
                         linear.lambda.end(),
                         [&t](const std::complex<double> lambda) {
                           return lambda.real() < 0. ||
                                  !is_of_the_run(lambda, t);
                         });
    }

    void
    evaluate_limit_cycle(const PreparedTransient &prepared,
                         const TransientRecord   &record,
                         const Parameters        &p,
                         TransientFigures        &f)
    {
      evaluate_forces(prepared.pressed.nodes(), record, f);
      const auto       &samples = record.samples;
      const std::size_t first   = samples.size() / 2;
      // Weakly damped motion loses less than that in the half of a run; a mesh
      // that turns goes on exciting it.
      f.dies_out =
        p.transient.disc_frame == TransientParameters::DiscFrame::eulerian &&
        all_decay(prepared.linear, p.transient) &&
        std::all_of(samples.begin() + first, samples.end(), [](const auto &s) {
          return s.is_linear != 0.;
        });
      f.vibrates        = !f.dies_out && !nothing_vibrates(f);
      f.has_limit_cycle = f.vibrates && f.least_rms > 0.8 * f.most_rms;
      const double interval =
        samples.size() > 1 ? samples[1].time - samples[0].time : 1.;
      const auto late_of = [&](const std::vector<double> &all) {
        return std::vector<double>(all.begin() + first, all.end());
      };
      f.beyond_samples =
        frequency_beyond_samples(prepared.motions(p), p.transient, interval);
      // Noise has a largest line, too.
      if (f.beyond_samples == 0. && !nothing_vibrates(f))
        {
          f.beyond_samples = line_beyond_samples(
            record, f.loudest, p.eigen.lowest_frequency, interval);
          f.is_beyond_in_steps = f.beyond_samples > 0.;
        }
      if (f.beyond_samples > 0.)
        {
          f.repetition = f.phase = not_known;
          return;
        }
      evaluate_lines(signals_of_loudest(prepared, record, f),
                     interval,
                     p.eigen.lowest_frequency,
                     f);
      evaluate_cut(samples.back().time - samples[first].time, f);
      const auto of_sums = [&](double PairSample::*const force) {
        return record.forces_of(f.loudest.number, force);
      };
      // The line of a moment or a node is none of the sums.
      if (f.loudest.is_beside_sums())
        f.phase = not_known;
      else if (f.largest_line > 0.)
        f.phase = phase_difference(late_of(of_sums(&PairSample::pressing)),
                                   late_of(of_sums(&PairSample::pulling)),
                                   interval,
                                   f.largest_line);
    }
  } // namespace



  PreparedTransient::PreparedTransient(const PressedModel &model,
                                       const Parameters   &p,
                                       Timers             &timers)
    : PreparedTransient(model.steady(p.preload.tolerance, timers), p, timers)
  {
  }

  PreparedTransient::PreparedTransient(const SteadyModel &model,
                                       const Parameters  &p,
                                       Timers            &timers)
    : pressed(model.pressed)
    , steady(model.sliding)
  {
    Timers::Section section(timers, "Solve: linearised motion");
    linear = linearize(
      pressed.model(), steady, pressed.sliding_friction(), pressed.speed());
    reduction_errors = reduction_error(pressed.model(),
                                       steady,
                                       pressed.sliding_friction(),
                                       pressed.speed(),
                                       linear);
    outside = growth_outside(model, linear, reduction_errors, p, timers);
    for (Eigen::Index k = 0; k < linear.lambda.size(); ++k)
      if (const double f = linear.lambda[k].imag() / (2. * M_PI);
          is_between(f, p.eigen.lowest_frequency, p.eigen.highest_frequency) &&
          linear.lambda[k].real() > -0.3 * linear.lambda[k].imag())
        branches.push_back(k);
  }



  LinearizedMotion
  PreparedTransient::motions(const Parameters &p) const
  {
    return motions_of_run(linear, outside, p.transient);
  }



  TransientFigures
  evaluate_transient(const PreparedTransient &prepared,
                     const TransientRecord   &record,
                     const Parameters        &p,
                     const ComplexPairs      *cea)
  {
    TransientFigures f;
    evaluate_branches(prepared, record, p.transient, cea, f);
    const GrowthOutside growth = growth_of_run(prepared.outside, p.transient);
    f.growing_outside          = text_of_growth_outside(growth);
    f.vibrates_by_reduction    = growth.is_led_by_reduction();
    if (f.vibrates_by_reduction)
      f.growing_outside += ": what vibrates in this run may be that alone";
    f.has_unseen_motions =
      p.transient.integrator != TransientParameters::Integrator::reduced;
    f.verdict = verdict_of(f);
    evaluate_limit_cycle(prepared, record, p, f);
    evaluate_nodes(record, f);
    // Against the work of the whole run: at the start there is next to none.
    const auto work = [&](const TransientSample &s) {
      return std::abs(s.driving) + std::abs(s.load) +
             record.samples.front().kinetic + record.samples.front().elastic;
    };
    for (const auto &sample : record.samples)
      f.worst_imbalance =
        worst_of(f.worst_imbalance,
                 sample.imbalance * work(sample) /
                   std::max(work(record.samples.back()), 1e-300));
    f.steps_per_second    = record.n_steps / std::max(record.cpu_seconds, 1e-9);
    f.n_inversions        = record.n_inversions;
    f.iterations_per_step = record.n_iterations / std::max(record.n_steps, 1.);
    return f;
  }



  double
  frequency_beyond_samples(const LinearizedMotion    &linear,
                           const TransientParameters &t,
                           const double               interval)
  {
    /** What grows by fewer e-foldings over a run stays small. */
    constexpr double           least_e_foldings = 7.;
    const std::complex<double> lambda           = fastest_growth(linear, t);
    const double               f                = lambda.imag() / (2. * M_PI);
    return f > highest_line(interval) &&
               lambda.real() * t.end_time > least_e_foldings
             ? f
             : 0.;
  }

  double
  sigma_with_full_contact(const PreparedTransient &prepared,
                          const Parameters        &p)
  {
    SteadySliding whole = prepared.steady;
    for (const ContactPair &pair : prepared.pressed.nodes().pairs())
      {
        if (!pair.slides())
          continue;
        const Eigen::VectorXd forces = pair.part(prepared.steady.forces);
        Eigen::Vector3d       sum    = Eigen::Vector3d::Zero();
        double                total  = 0.;
        for (unsigned int k = 0; k < pair.n_nodes(); ++k)
          {
            sum += forces.segment<3>(3 * k);
            total += pair.geometry.areas[k];
          }
        for (unsigned int k = 0; k < pair.n_nodes(); ++k)
          {
            whole.status[pair.first + k] = ContactStatus::slip;
            whole.forces.segment<3>(3 * (pair.first + k)) =
              pair.geometry.areas[k] / total * sum;
          }
      }
    const LinearizedMotion motion =
      linearize(prepared.pressed.model(),
                whole,
                prepared.pressed.sliding_friction(),
                prepared.pressed.speed());
    double sigma = -std::numeric_limits<double>::infinity();
    for (const auto &lambda : motion.lambda)
      if (const double f = lambda.imag() / (2. * M_PI);
          is_between(f, p.eigen.lowest_frequency, p.eigen.highest_frequency))
        sigma = std::max(sigma, lambda.real());
    return sigma;
  }



  ComplexPairs
  whole_model_pairs(const Parameters                 &parameters,
                    const std::vector<ContactStates> &states,
                    RunLog                           &log,
                    Timers                           &timers)
  {
    Model        model(parameters, timers, states);
    ModeSolution modes    = solve_modes(model, log, timers);
    CeaSolution  solution = solve_cea(model, modes, log, timers);
    warn_of_growth_left_out(solution, "pairs of the whole model: ", log);
    return std::move(solution.pairs);
  }
} // namespace squeal
