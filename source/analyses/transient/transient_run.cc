// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/transient_run.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/timers.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/base/worst_of.h>
#include <squeal/output/contact_output.h>
#include <squeal/parameters/choices.h>
#include <squeal/transient/explicit_transient.h>
#include <squeal/transient/implicit_transient.h>
#include <squeal/transient/reduced_transient.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace squeal
{
  namespace
  {
    constexpr unsigned int steps_between_watches = 50;

    double
    half_sine(const double time, const double start, const double duration)
    {
      const double s = (time - start) / duration;
      return s > 0. && s < 1. ? std::sin(M_PI * s) : 0.;
    }

    /** From 0 to 1, smooth. */
    double
    ramp(const double time, const double duration)
    {
      if (time >= duration)
        return 1.;
      return time <= 0. ? 0. : 0.5 * (1. - std::cos(M_PI * time / duration));
    }

    /** CPU seconds of this thread. */
    double
    thread_seconds()
    {
      timespec now;
      ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
      return now.tv_sec + 1e-9 * now.tv_nsec;
    }
  } // namespace



  TransientDrive
  make_drive(const PressedModel &pressed, const Parameters &p)
  {
    const TransientParameters t = p.transient;
    TransientDrive            drive;
    const FrictionLaw         law   = pressed.friction_law();
    const double              speed = pressed.speed();
    if (!law.is_constant())
      drive.law = std::make_shared<const FrictionLaw>(law);
    drive.friction = [mu = law.is_constant() ? pressed.friction() : 0.,
                      t](const double time) {
      return mu + t.friction_impulse * half_sine(time,
                                                 t.friction_impulse_time,
                                                 t.friction_impulse_duration);
    };
    drive.speed = [speed, t](const double time) {
      return speed * (1. + (t.final_speed_ratio - 1.) * time / t.end_time);
    };
    // Loads share one ramp: the longest.
    double ramp_time = 0.;
    for (const auto &load : p.scene.loads)
      ramp_time = std::max(ramp_time, load.ramp_time);
    const bool ramped = t.start == TransientParameters::Start::ramp;
    drive.load        = [ramped, ramp_time](const double time) {
      return ramped ? ramp(time, ramp_time) : 1.;
    };
    if (!t.hammer.body.empty())
      {
        LoadParameters load;
        load.name  = "hammer";
        load.body  = t.hammer.body;
        load.face  = t.hammer.face;
        load.force = t.hammer.force;
        drive.forces.push_back({pressed.force(load), [t](const double time) {
                                  return half_sine(
                                    time, t.hammer.time, t.hammer.duration);
                                }});
      }
    return drive;
  }



  std::unique_ptr<TransientIntegrator>
  make_integrator(const PressedModel  &pressed,
                  const SteadySliding &steady,
                  const Parameters    &p)
  {
    using Integrator   = TransientParameters::Integrator;
    const auto  &t     = p.transient;
    const auto   drive = make_drive(pressed, p);
    const double force = steady.resultant()[0] / pressed.model().n_nodes();
    const auto   method =
      t.contact_method == TransientParameters::ContactMethod::newton
          ? ContactSolver::Method::newton
          : ContactSolver::Method::gauss_seidel;
    switch (t.integrator)
      {
      case Integrator::implicit:
        return std::make_unique<ImplicitTransient>(pressed.full_model(steady),
                                                   t.step(),
                                                   drive,
                                                   force,
                                                   t.tolerance,
                                                   method);
      case Integrator::explicit_:
        return std::make_unique<ExplicitTransient>(pressed.full_model(steady),
                                                   t.step(),
                                                   drive,
                                                   force,
                                                   t.tolerance,
                                                   method,
                                                   t.beta_2);
      case Integrator::reduced:
        return std::make_unique<ReducedTransient>(
          pressed.model(), t.step(), drive, force, t.tolerance, method);
      }
    unknown_choice("integrator");
  }



  std::vector<double>
  TransientRecord::times() const
  {
    std::vector<double> result;
    for (const auto &sample : samples)
      result.push_back(sample.time);
    return result;
  }

  std::vector<std::complex<double>>
  TransientRecord::branch(const unsigned int k, const unsigned int n) const
  {
    std::vector<std::complex<double>> result;
    for (std::size_t i = k; i < amplitudes.size(); i += n)
      result.push_back(amplitudes[i]);
    return result;
  }



  namespace
  {
    /** Some of the pairs, without their right vectors. */
    LinearizedMotion
    only(const LinearizedMotion &all, const std::vector<unsigned int> &pairs)
    {
      LinearizedMotion result;
      result.lambda = all.lambda(pairs);
      result.left   = all.left(pairs, Eigen::all);
      return result;
    }
  } // namespace



  TransientRun::TransientRun(const PressedModel              &model,
                             const SteadySliding             &state,
                             const LinearizedMotion          &linearized,
                             const std::vector<unsigned int> &branches,
                             const Parameters                &p)
    : pressed(model)
    , steady(state)
    , recorded(only(linearized, branches))
    , settings(p.transient)
    , edge(leading_edge(model.geometry()))
    , n_steps(std::lround(settings.end_time / settings.step()))
    , stride(
        std::max<long>(1,
                       std::lround(settings.sample_interval / settings.step())))
    , motion(make_integrator(model, state, p))
  {
    const unsigned int n = model.model().n_modes();
    kept.nodes.resize(model.model().n_nodes());
    for (std::size_t j = 0; j < edge.size(); ++j)
      {
        area += model.geometry().areas[j];
        edge_area += edge[j] ? model.geometry().areas[j] : 0.;
      }
    const Eigen::VectorXd v = model.disturbance(settings.disturbance);
    if (settings.start == TransientParameters::Start::ramp)
      motion->start(Eigen::VectorXd::Zero(n),
                    v,
                    Eigen::VectorXd::Zero(steady.forces.size()));
    else
      motion->start(steady.coordinates, v, steady.forces);
    status      = settings.start == TransientParameters::Start::ramp
                    ? std::vector<ContactStatus>(edge.size(), ContactStatus::open)
                    : steady.status;
    last_motion = motion->motion();
    take_sample(status == steady.status);
  }



  bool
  TransientRun::advance(const Watch &watch)
  {
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
            kept.changes.push_back({motion->time(), j, now[j]});
        status               = now;
        linear_since_sample  = linear_since_sample && status == steady.status;
        const unsigned int n = static_cast<unsigned int>(kept.n_steps);
        if (n > n_steps / 2)
          take_node_shares();
        if (n % stride == 0)
          {
            take_sample(linear_since_sample);
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



  void
  TransientRun::take_node_shares()
  {
    const double           speed  = pressed.speed();
    const Eigen::VectorXd &u      = motion->motion();
    const Eigen::VectorXd &lambda = motion->forces();
    const double           way    = settings.step() * speed *
                       (1. + (settings.final_speed_ratio - 1.) *
                               motion->time() / settings.end_time);
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
        const double along = u[3 * j + 1] - last_motion[3 * j + 1] +
                             way * pressed.model().speed_ratio[j],
                     across = u[3 * j + 2] - last_motion[3 * j + 2];
        node.fastest_slip =
          std::max(node.fastest_slip,
                   std::hypot(along, across) / (settings.step() * speed));
        node.peak_pressure = std::max(
          node.peak_pressure, lambda[3 * j] / pressed.geometry().areas[j]);
      }
  }



  void
  TransientRun::take_sample(const bool is_linear)
  {
    const auto            &g      = pressed.geometry();
    const Eigen::VectorXd &lambda = motion->forces();
    TransientSample        s;
    s.time            = motion->time();
    s.is_linear       = is_linear;
    const auto force  = resultant_force(g, lambda);
    s.radial          = force[0];
    s.tangential      = force[1];
    s.normal          = force[2];
    double edge_force = 0.;
    for (std::size_t j = 0; j < status.size(); ++j)
      {
        edge_force += edge[j] ? lambda[3 * j] : 0.;
        s.n_open += status[j] == ContactStatus::open;
        s.n_stick += status[j] == ContactStatus::stick;
      }
    s.leading_edge =
      s.normal > 0. ? edge_force / edge_area * area / s.normal : 0.;
    const Eigen::VectorXd x = motion->observed_motion(),
                          a = motion->observed_accelerations();
    for (unsigned int c = 0; c < 3; ++c)
      {
        s.position[c]     = x[PressedModel::centre_x + c];
        s.acceleration[c] = a[PressedModel::centre_x + c];
      }
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
    if (s.time >= settings.history_start - 1e-9)
      take_node_fields(s, kept.history);
    if (kept.samples.size() + settings.animation_frames > n_steps / stride + 1)
      take_frame(s);
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
  TransientRun::take_node_fields(const TransientSample &s,
                                 HistorySamples        &h) const
  {
    const auto            &g      = pressed.geometry();
    const Eigen::VectorXd &lambda = motion->forces();
    const Eigen::VectorXd &u      = motion->motion();
    const auto             q      = tractions(g, lambda);
    h.time.push_back(s.time);
    const double step = motion->time() > 0. ? settings.step() : 1.;
    double       x = 0., y = 0.; // of the resultant: fields have global axes
    for (std::size_t j = 0; j < status.size(); ++j)
      {
        const double tx = g.frames[j].sliding[0], ty = g.frames[j].sliding[1];
        const double way =
          pressed.speed() * pressed.model().speed_ratio[j] *
          (1. + (settings.final_speed_ratio - 1.) * s.time / settings.end_time);
        const double along =
                       (u[3 * j + 1] - last_motion[3 * j + 1]) / step + way,
                     across = (u[3 * j + 2] - last_motion[3 * j + 2]) / step;
        x += q[2 * j] * g.areas[j];
        y += q[2 * j + 1] * g.areas[j];
        h.pressure.push_back(lambda[3 * j] / g.areas[j]);
        h.traction.push_back(q[2 * j]);
        h.traction.push_back(q[2 * j + 1]);
        h.slip_rate.push_back(tx * along + ty * across);
        h.slip_rate.push_back(ty * along - tx * across);
        h.gap.push_back(
          std::max(0., pressed.model().initial_gap[j] - u[3 * j]));
        h.status.push_back(static_cast<double>(status[j]));
      }
    for (const double f : {x, y, s.normal})
      h.resultants.push_back(f);
    for (unsigned int c = 0; c < 3; ++c)
      h.probes.push_back(s.acceleration[c]);
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
