// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/transient_results.h>
#include <squeal/analyses/transient/transient_run.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/timers.h>
#include <squeal/base/worst_of.h>
#include <squeal/contact/pressure_moments.h>
#include <squeal/contact/summed_pairs.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>

namespace squeal
{
  namespace
  {
    constexpr unsigned int steps_between_watches = 50;

    /** CPU seconds of this thread. */
    double
    thread_seconds()
    {
      timespec now;
      ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
      return now.tv_sec + 1e-9 * now.tv_nsec;
    }
  } // namespace



  namespace
  {
    /** Some of the pairs, without their right vectors. */
    LinearizedMotion
    only(const LinearizedMotion &all, const std::vector<unsigned int> &pairs)
    {
      LinearizedMotion result;
      result.lambda          = all.lambda(pairs);
      result.left            = all.left(pairs, Eigen::all);
      result.rows_viscous    = all.rows_viscous;
      result.limit_by_normal = all.limit_by_normal;
      return result;
    }
  } // namespace



  TransientRun::TransientRun(const PressedModel              &model,
                             const SteadySliding             &state,
                             const LinearizedMotion          &linearized,
                             const std::vector<unsigned int> &branches,
                             const Parameters                &p,
                             HistoryStream                   *stream)
    : pressed(model)
    , steady(state)
    , recorded(only(linearized, branches))
    , settings(p.transient)
    , areas(model.nodes().areas())
    , sums(model.nodes())
    , senses(transverse_senses(model.nodes()))
    , n_steps(std::lround(settings.end_time / settings.step()))
    , stride(
        std::max<long>(1,
                       std::lround(settings.sample_interval / settings.step())))
    , motion(make_integrator(model, state, p))
    , history(stream)
  {
    const unsigned int n       = model.model().n_modes(),
                       n_nodes = model.model().n_nodes();
    const auto &pairs          = model.nodes().pairs();
    kept.nodes.resize(n_nodes);
    kept.stretches.resize(n_force_stretches);
    kept.watched = WatchedNodes(model.nodes());
    if (pairs.size() > 1)
      kept.pair_stretches.resize(pairs.size() * n_force_stretches);
    if (has_trigger(settings))
      {
        kept.trigger_stretches.resize(pairs.size() * n_trigger_stretches);
        kept.watched.trigger_pieces.resize(kept.watched.numbers.size() *
                                           n_trigger_stretches);
      }
    kept.square_accelerations.assign(pairs.size(), 0.);
    kept.frame_nodes.resize(pairs.size());
    for (const ContactPair &pair : pairs)
      {
        axes.emplace_back(pair.geometry);
        flat.push_back(is_flat(pair.geometry));
        speeds.insert(
          speeds.end(), pair.n_nodes(), pair.parameters.sliding_speed);
      }
    const Eigen::VectorXd v = model.disturbance(settings.disturbance);
    if (settings.start == TransientParameters::Start::ramp)
      motion->start(Eigen::VectorXd::Zero(n),
                    v,
                    Eigen::VectorXd::Zero(steady.forces.size()));
    else
      motion->start(steady.coordinates, v, steady.forces);
    status      = settings.start == TransientParameters::Start::ramp
                    ? std::vector<ContactStatus>(n_nodes, ContactStatus::open)
                    : steady.status;
    last_motion = motion->motion();
    take_sample(status == steady.status);
  }



  StepSums
  TransientRun::force_sums() const
  {
    return sums.of(motion->forces(), speed_now() < 0.);
  }



  bool
  TransientRun::advance(const Watch &watch)
  {
    if (kept.n_steps == 0. && history)
      {
        history->start();
        take_history();
      }
    unsigned int n_since = 0;
    double       begin   = thread_seconds();
    while (kept.n_steps < n_steps)
      {
        const ContactReport report = motion->advance();
        ++kept.n_steps;
        kept.n_iterations += report.iterations;
        kept.n_sweeps += report.sweeps;
        kept.worst_residual = worst_of(kept.worst_residual, report.residual);
        const auto &now     = motion->status();
        for (std::size_t j = 0; j < now.size(); ++j)
          if (now[j] != status[j])
            {
              kept.n_changes += 1.;
              if (history && motion->time() >= settings.history_start - 1e-9)
                history->append(StatusChange{motion->time(), j, now[j]});
            }
        status               = now;
        linear_since_sample  = linear_since_sample && status == steady.status;
        const unsigned int n = static_cast<unsigned int>(kept.n_steps);
        if (n > n_steps / 2)
          {
            take_node_shares();
            take_accelerations();
          }
        take_step_forces();
        if (n % stride == 0)
          {
            take_sample(linear_since_sample);
            take_history();
            linear_since_sample = true;
          }
        last_motion = motion->motion();
        if (++n_since == steps_between_watches && watch)
          {
            kept.cpu_seconds += thread_seconds() - begin;
            const bool stop = watch(n_since);
            begin           = thread_seconds();
            n_since         = 0;
            if (stop)
              return false;
          }
      }
    kept.cpu_seconds += thread_seconds() - begin;
    kept.n_inversions = motion->n_inversions();
    if (watch && n_since > 0)
      watch(n_since);
    return true;
  }



  double
  TransientRun::speed_now() const
  {
    return pressed.speed() * (1. + (settings.final_speed_ratio - 1.) *
                                     motion->time() / settings.end_time);
  }

  void
  TransientRun::take_node_shares()
  {
    const Eigen::VectorXd &u      = motion->motion();
    const Eigen::VectorXd &lambda = motion->forces();
    const Eigen::VectorXd &ratio  = pressed.model().speed_ratio;
    const double           way    = settings.step() * speed_now();
    for (std::size_t j = 0; j < status.size(); ++j)
      {
        NodeShares &node = kept.nodes[j];
        switch (status[j])
          {
          case ContactStatus::open:
            node.open += 1.;
            break;
          case ContactStatus::stick:
            node.stick += 1.;
            break;
          case ContactStatus::slip:
            node.slip += 1.;
            break;
          }
        const double along =
                       u[3 * j + 1] - last_motion[3 * j + 1] + way * ratio[j],
                     across = u[3 * j + 2] - last_motion[3 * j + 2];
        if (speeds[j] > 0. && ratio[j] > 0.)
          node.fastest_slip =
            std::max(node.fastest_slip,
                     std::hypot(along, across) / (settings.step() * speeds[j]));
        node.peak_pressure =
          std::max(node.peak_pressure, lambda[3 * j] / areas[j]);
      }
  }



  void
  TransientRun::take_step_forces()
  {
    const StepSums force = force_sums();
    // Of step 1, 2, ...; in 64 bits, as long runs have 1e8 steps.
    const auto          n       = static_cast<std::uint64_t>(kept.n_steps);
    const std::uint64_t stretch = (n - 1) * n_force_stretches / n_steps;
    kept.stretches[stretch].add(
      force,
      std::all_of(status.begin(), status.end(), [](const ContactStatus s) {
        return s == ContactStatus::open;
      }));
    std::vector<StepSums> of_pairs = sums.of_pairs(motion->forces());
    for (std::size_t i = 0; i < of_pairs.size(); ++i)
      kept.pair_stretches[i * n_force_stretches + stretch].add(of_pairs[i],
                                                               false);
    kept.watched.add_step(motion->forces(),
                          stretch,
                          n_steps_left() < WatchedNodes::most_last_steps);
    if (of_pairs.empty())
      of_pairs = {force};
    take_trigger_forces(of_pairs);
    if (n_steps_left() < most_last_steps)
      for (const StepSums &sum : of_pairs)
        kept.last_steps.push_back({motion->time(),
                                   sum.normal,
                                   sum.tangential,
                                   sum.first_moment,
                                   sum.second_moment});
  }



  void
  TransientRun::take_trigger_forces(const std::vector<StepSums> &of_pairs)
  {
    if (kept.trigger_stretches.empty())
      return;
    const auto          n       = static_cast<std::uint64_t>(kept.n_steps);
    const std::uint64_t stretch = (n - 1) * n_trigger_stretches / n_steps;
    for (std::size_t i = 0; i < of_pairs.size(); ++i)
      kept.trigger_stretches[i * n_trigger_stretches + stretch].add(of_pairs[i],
                                                                    false);
    kept.watched.add_trigger_step(motion->forces(), stretch);
  }



  void
  TransientRun::take_accelerations()
  {
    const Eigen::VectorXd a = motion->observed_accelerations();
    for (unsigned int i = 0; i < kept.square_accelerations.size(); ++i)
      kept.square_accelerations[i] +=
        a.segment<3>(PressedModel::observer(i, PressedModel::centre_x))
          .squaredNorm();
  }



  void
  TransientRun::take_pair_samples(TransientSample &s)
  {
    const Eigen::VectorXd &lambda = motion->forces();
    const Eigen::VectorXd &losses = motion->friction_losses();
    const Eigen::VectorXd  x      = motion->observed_motion(),
                          a       = motion->observed_accelerations();
    const auto &pairs             = pressed.nodes().pairs();
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        const Eigen::VectorXd forces = pairs[i].part(lambda);
        const auto force   = resultant_force(pairs[i].geometry, forces);
        const auto moments = sums.moments(i, lambda);
        PairSample sample;
        sample.radial        = force[0];
        sample.tangential    = force[1];
        sample.normal        = force[2];
        sample.pressing      = force[2];
        sample.pulling       = force[1];
        sample.first_moment  = moments[0];
        sample.second_moment = moments[1];
        if (!flat[i])
          {
            const Eigen::Vector2d both = sum_rows(pairs[i].geometry) * forces;
            sample.pressing            = both[0];
            sample.pulling             = both[1];
          }
        sample.friction =
          losses.segment(pairs[i].first, pairs[i].n_nodes()).sum();
        const unsigned int centre =
          PressedModel::observer(i, PressedModel::centre_x);
        for (unsigned int c = 0; c < 3; ++c)
          {
            sample.position[c]     = x[centre + c];
            sample.acceleration[c] = a[centre + c];
          }
        kept.pairs.push_back(sample);
        if (!is_summed(pressed.nodes(), pairs[i]))
          continue;
        s.radial += senses[i] * sample.radial;
        s.tangential += sample.tangential;
        s.normal += sample.normal;
      }
  }



  void
  TransientRun::take_sample(const bool is_linear)
  {
    const Eigen::VectorXd &lambda = motion->forces();
    TransientSample        s;
    s.time      = motion->time();
    s.is_linear = is_linear;
    take_pair_samples(s);
    kept.watched.add_sample(lambda);
    for (std::size_t j = 0; j < status.size(); ++j)
      {
        s.n_open += status[j] == ContactStatus::open;
        s.n_stick += status[j] == ContactStatus::stick;
      }
    const StepSums sum   = force_sums();
    s.leading_edge       = leading_edge_factor(sum);
    const EnergyLedger e = motion->ledger();
    s.kinetic            = e.kinetic;
    s.elastic            = e.elastic;
    s.damping            = e.damping;
    s.friction           = e.friction;
    s.driving            = e.driving;
    s.load               = e.load;
    s.numerical          = e.numerical;
    s.imbalance          = e.imbalance();
    kept.samples.push_back(s);
    for (const auto &a : recorded.amplitudes(
           steady, motion->coordinates(), motion->velocities(), lambda))
      kept.amplitudes.push_back(a);
    if (kept.samples.size() + settings.animation_frames > n_steps / stride + 1)
      take_frame(s);
  }



  void
  TransientRun::take_history()
  {
    const TransientSample &s = kept.samples.back();
    if (!history || s.time < settings.history_start - 1e-9)
      return;
    std::vector<HistorySamples> fields(pressed.nodes().pairs().size());
    take_node_fields(s, fields);
    history->append(fields);
  }



  void
  TransientRun::take_frame(const TransientSample &s)
  {
    MotionFrame frame;
    frame.time        = s.time;
    frame.coordinates = motion->coordinates();
    frame.forces      = motion->forces();
    if (const Eigen::VectorXd *all = motion->unknowns())
      frame.unknowns = *all;
    kept.frames.push_back(frame);
    take_node_fields(s, kept.frame_nodes);
  }



  void
  TransientRun::take_node_fields(const TransientSample       &s,
                                 std::vector<HistorySamples> &histories) const
  {
    for (unsigned int i = 0; i < histories.size(); ++i)
      take_nodes_of(i, s, histories[i]);
  }

  void
  TransientRun::take_nodes_of(const unsigned int     number,
                              const TransientSample &s,
                              HistorySamples        &h) const
  {
    const ContactPair     &pair   = pressed.nodes().pairs()[number];
    Eigen::VectorXd        lambda = motion->forces();
    const Eigen::VectorXd &u      = motion->motion();
    // What the tolerance of the contact law leaves on open nodes is no force.
    for (std::size_t j = 0; j < status.size(); ++j)
      if (status[j] == ContactStatus::open)
        lambda.segment<3>(3 * j).setZero();
    h.time.push_back(s.time);
    const double step = motion->time() > 0. ? settings.step() : 1.;
    // Fields and their resultant have the axes of the face.
    double x = 0., y = 0., normal = 0.;
    for (unsigned int k = 0; k < pair.n_nodes(); ++k)
      {
        const std::size_t j   = pair.first + k;
        const double      way = speed_now() * pressed.model().speed_ratio[j],
                     along =
                       (u[3 * j + 1] - last_motion[3 * j + 1]) / step + way,
                     across = (u[3 * j + 2] - last_motion[3 * j + 2]) / step;
        const auto pull =
          axes[number].components(k, lambda[3 * j + 1], lambda[3 * j + 2]);
        const auto slip = axes[number].components(k, along, across);
        x += pull[0];
        y += pull[1];
        normal += lambda[3 * j];
        h.pressure.push_back(lambda[3 * j] / areas[j]);
        for (unsigned int c = 0; c < 2; ++c)
          {
            h.traction.push_back(pull[c] / areas[j]);
            h.slip_rate.push_back(slip[c]);
          }
        h.gap.push_back(
          std::max(0., pressed.model().initial_gap[j] - u[3 * j]));
        h.status.push_back(static_cast<double>(status[j]));
      }
    for (const double f : {x, y, normal})
      h.resultants.push_back(f);
    const PairSample &sample = kept.pair(kept.samples.size() - 1, number);
    for (unsigned int c = 0; c < 3; ++c)
      h.probes.push_back(sample.acceleration[c]);
    for (const double e_now : {s.kinetic,
                               s.elastic,
                               s.damping,
                               s.friction,
                               s.driving,
                               s.load,
                               s.numerical})
      h.energies.push_back(e_now);
  }



  const TransientRecord &
  TransientRun::record() const
  {
    return kept;
  }

  unsigned int
  TransientRun::n_steps_left() const
  {
    return n_steps - static_cast<unsigned int>(kept.n_steps);
  }
} // namespace squeal
