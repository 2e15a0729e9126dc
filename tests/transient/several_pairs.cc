// SPDX-License-Identifier: LGPL-2.1-or-later

// Several pairs in one scene: pads far apart on a stiff plate do not know of
// each other; a pad that is dragged against its abutment; two pads on a disc,
// whose growth in time is that of the eigenvalue analysis about the same
// contact; what each pair loses in its slip; a disc that bends between two
// pads, whose forces cancel in their sum.

#include "transient/two_pads.h"
#include "worst.h"

#include <squeal/base/run_log.h>

#include <deal.II/base/mpi.h>

#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Pads "a" and "b" on a plate that is as stiff as ground. */
  SceneParameters
  stiff_plate(const bool a, const bool b)
  {
    SceneParameters s;
    s.bodies = {
      make_block("plate", {{0., 0., -.01}}, {{.2, .04, .01}}, {{10, 2, 1}})};
    s.bodies[0].young_modulus = 1e18;
    s.supports                = {make_clamp("plate", "z_min")};
    for (const auto &[name, x, mu] :
         {std::make_tuple(std::string("a"), -.05, .5),
          std::make_tuple(std::string("b"), .05, .2)})
      {
        if (!(name == "a" ? a : b))
          continue;
        s.bodies.push_back(
          make_block(name, {{x, 0., 0.}}, {{.02, .015, .01}}, {{2, 2, 2}}));
        s.bodies.back().young_modulus = 2e9;
        s.bodies.back().density       = 2500.;
        add_springs(s, name, {{x, 0., .01}}, {{3e5, 5e5, 2e5}});
        s.contacts.push_back(make_contact(name, "z_min", "plate", "z_max", mu));
        s.loads.push_back(make_load(name, "z_max", {{0., 0., -20.}}));
      }
    s.damping.model             = DampingParameters::Model::whole_model;
    s.damping.stiffness_damping = 1e-7;
    return s;
  }

  void
  apart()
  {
    const Pressed both(parameters_of(stiff_plate(true, true)));
    Worst         worst;
    for (const unsigned int i : {0u, 1u})
      {
        const Pressed alone(parameters_of(stiff_plate(i == 0, i == 1)));
        const auto   &pair = both.pressed.nodes().pairs()[i];
        const double  mean = alone.resultant(0)[0] / alone.steady.status.size();
        worst.add((pair.part(both.steady.forces) - alone.steady.forces).norm() /
                  mean);
        check(pair.part(both.steady.status) == alone.steady.status,
              "the status of a single pad");
        check_below(std::abs(both.resultant(i)[1] / both.resultant(i)[0] -
                             (i == 0 ? .5 : .2)),
                    1e-9,
                    "each pad has its own friction");
      }
    check_below(worst.largest(), 1e-6, "forces of pads far apart");
  }



  /** The transient of @p r to its end. */
  TransientRecord
  record_of(const Pressed &r, const PreparedTransient &prepared)
  {
    TransientRun run(prepared.pressed,
                     prepared.steady,
                     prepared.linear,
                     prepared.branches,
                     r.p);
    run.advance();
    return run.record();
  }

  /** In steady sliding every node slips at the speed of its own pair. */
  void
  speeds_of_pairs()
  {
    SceneParameters scene           = stiff_plate(true, true);
    scene.contacts[1].sliding_speed = .1 * scene.contacts[0].sliding_speed;
    Parameters p                    = parameters_of(scene);
    p.transient.time_step           = 2e-7;
    p.transient.end_time            = 2e-5;
    p.transient.sample_interval     = 2e-6;
    p.transient.disturbance         = 0.;
    p.transient.tolerance           = 1e-11;
    Pressed                 r(p);
    const PreparedTransient prepared(r.pressed, r.p, r.timers);
    const TransientRecord   record = record_of(r, prepared);
    Worst                   off;
    for (const NodeShares &node : record.nodes)
      off.add(std::abs(node.fastest_slip - 1.));
    check_within(off, 1e-6, "slip over the sliding speed of the own pair");
    const double ratio =
      evaluate_transient(prepared, record, r.p).max_slip_speed_ratio;
    check_close(ratio, 1., 1e-6, "and the largest of all");
  }



  /** A pad on a plate that drags it along +y against a clamped abutment. */
  SceneParameters
  pad_in_abutment(const double mu_of_abutment)
  {
    SceneParameters s;
    s.bodies = {
      make_block("plate", {{0., 0., -.01}}, {{.06, .06, .01}}, {{4, 4, 1}}),
      make_block("pad", {{0., 0., 0.}}, {{.02, .02, .01}}, {{2, 2, 2}}),
      make_block(
        "holder", {{0., .015, .002}}, {{.014, .01, .006}}, {{2, 1, 2}})};
    s.bodies[1].young_modulus = 5e9;
    s.bodies[1].density       = 2500.;
    s.supports = {make_clamp("plate", "z_min"), make_clamp("holder", "y_max")};
    add_springs(s, "pad", {{0., 0., .01}}, {{1e3, 1e3, 1e3}});
    s.contacts = {
      make_contact("pad", "z_min", "plate", "z_max", .4),
      make_contact("holder", "y_min", "pad", "y_max", mu_of_abutment)};
    s.contacts[1].sliding_direction    = {{1., 0., 0.}};
    s.contacts[1].sliding_speed        = 0.;
    s.contacts[1].transverse_slip_term = false;
    s.loads                     = {make_load("pad", "z_max", {{0., 0., -50.}})};
    s.damping.model             = DampingParameters::Model::whole_model;
    s.damping.stiffness_damping = 1e-7;
    return s;
  }

  /** Undisturbed motion stays in steady sliding. */
  void
  stays_there(const Pressed &r, const std::string &claim)
  {
    Parameters p          = r.p;
    p.transient.time_step = 2e-7;
    p.transient.tolerance = 1e-11;
    const auto motion     = make_integrator(r.pressed, r.steady, p);
    motion->start(r.steady.coordinates,
                  Eigen::VectorXd::Zero(r.steady.coordinates.size()),
                  r.steady.forces);
    Worst worst;
    for (unsigned int i = 0; i < 300; ++i)
      {
        motion->advance();
        worst.add((motion->forces() - r.steady.forces).norm());
      }
    check_below(worst.largest() / r.steady.forces.norm(),
                1e-6,
                claim + "undisturbed it stays in steady sliding");
  }

  void
  abutment()
  {
    for (const double mu : {0., .3})
      {
        const Pressed     r(parameters_of(pad_in_abutment(mu)));
        const auto       &pairs    = r.pressed.nodes().pairs();
        const auto        on_plate = r.resultant(0), on_holder = r.resultant(1);
        const std::string claim = "abutment of mu " + number(mu) + ": ";
        std::printf("plate %.6f %.6f %.6f, holder %.6f %.6f %.6f N\n",
                    on_plate[0],
                    on_plate[1],
                    on_plate[2],
                    on_holder[0],
                    on_holder[1],
                    on_holder[2]);
        check_below(std::abs(on_plate[1] / on_plate[0] - .4),
                    1e-9,
                    claim + "the plate drags the pad");
        // Weak springs take next to nothing.
        check_below(std::abs(on_holder[0] - on_plate[1]),
                    1e-2,
                    claim + "the abutment takes the friction");
        // The pad's normal is +y, x would slide, so that z is across: what the
        // pad does to its holder there.
        check_below(std::abs(on_plate[0] - on_holder[2] - 50.),
                    1e-2,
                    claim + "and both carry the load");
        check(mu == 0. ? std::abs(on_holder[2]) < 1e-6
                       : std::abs(on_holder[2]) > 1e-3,
              claim + "its own friction holds the pad along z: " +
                number(on_holder[2]));
        Worst        cone;
        const auto   forces   = pairs[1].part(r.steady.forces);
        const auto   status   = pairs[1].part(r.steady.status);
        unsigned int n_closed = 0;
        for (std::size_t j = 0; j < status.size(); ++j)
          {
            cone.add(forces.segment<2>(3 * j + 1).norm() - mu * forces[3 * j]);
            n_closed += status[j] != ContactStatus::open;
            check(status[j] == ContactStatus::open ||
                    status[j] ==
                      (mu > 0. ? ContactStatus::stick : ContactStatus::slip),
                  claim + "nothing moves in a pair at rest");
          }
        check(n_closed > 0, claim + "it touches");
        check_below(
          cone.largest(), 1e-6, claim + "within its cone of friction");
        stays_there(r, claim);
      }
  }



  /** Largest relative difference of the sum over pairs to the ledger's loss in
   * slip, over all samples. */
  double
  losses_beside_whole(const TransientRecord &record)
  {
    Worst worst;
    for (std::size_t k = 1; k < record.samples.size(); ++k)
      {
        double sum = 0.;
        for (unsigned int i = 0; i < record.n_pairs(); ++i)
          sum += record.pair(k, i).friction;
        worst.add(std::abs(sum / record.samples[k].friction - 1.));
      }
    return worst.largest();
  }

  void
  growth()
  {
    RunLog     log(false);
    Parameters p            = parameters_of(disc_brake(.5), 2);
    p.transient.time_step   = 1e-6;
    p.transient.end_time    = .02;
    p.transient.disturbance = 1e-16;
    p.transient.tolerance   = 1e-10;
    Pressed                 r(p);
    const PreparedTransient prepared(r.pressed, r.p, r.timers);
    std::printf("closed %u of %zu; upper %.4f N, lower %.4f N\n",
                prepared.steady.n_closed(),
                prepared.steady.status.size(),
                r.resultant(0)[0],
                r.resultant(1)[0]);
    for (const unsigned int k : prepared.branches)
      if (const auto lambda = prepared.linear.lambda[k]; lambda.real() > 0.)
        std::printf("%.1f Hz grows by %.2f 1/s\n",
                    lambda.imag() / (2. * M_PI),
                    lambda.real());
    std::fflush(stdout);
    TransientRun run(prepared.pressed,
                     prepared.steady,
                     prepared.linear,
                     prepared.branches,
                     r.p);
    // The linear phase tells; what follows takes its time.
    run.advance(
      [&](const unsigned int) { return run.record().n_changes > 0.; });
    const ComplexPairs cea = whole_model_pairs(
      r.p, prepared.pressed.states_of(prepared.steady), log, r.timers);
    const TransientFigures f =
      evaluate_transient(prepared, run.record(), r.p, &cea);
    check(f.leading >= 0, "there is a pair in the band");
    for (const BranchResult &b : f.branches)
      if (b.sigma > 0. || b.fit.is_valid)
        std::printf("%.2f Hz: sigma %.3f, CEA %.3f at %.2f Hz, growth %.3f +- "
                    "%.3f, %s\n",
                    b.frequency,
                    b.sigma,
                    b.sigma_cea,
                    b.frequency_cea,
                    b.fit.rate,
                    b.fit.rate_ci,
                    b.fit.is_valid ? "fitted" : "not fitted");
    const BranchResult &b = f.branches[f.leading];
    check(b.sigma_cea > 20., "two pads make a pair grow");
    check(b.fit.is_valid, "and its growth shows");
    check_below(std::abs(b.fit.rate - b.sigma_cea),
                std::max(.02 * b.sigma_cea, 3.),
                "growth in time is sigma of the eigenvalue analysis, 1/s");
    check_below(f.worst_imbalance, 1e-3, "the ledger closes");
    // Both pads' forces add up to the resultants.
    Worst worst;
    for (std::size_t k = 0; k < run.record().samples.size(); ++k)
      worst.add(std::abs(run.record().pair(k, 0).normal +
                         run.record().pair(k, 1).normal -
                         run.record().samples[k].normal));
    check_below(worst.largest(), 1e-9, "normal forces of both pads add up, N");
    check_below(
      losses_beside_whole(run.record()), 1e-12, "losses of both pads add up");
  }



  /** Power that a pair loses in steady sliding, mu N |V| of every node, W. */
  double
  power_of(const Pressed &r, const ContactPair &pair, const double mu)
  {
    double result = 0.;
    for (unsigned int j = pair.first; j < pair.first + pair.n_nodes(); ++j)
      result += mu * r.steady.forces[3 * j] * r.pressed.speed() *
                r.pressed.model().speed_ratio[j];
    return result;
  }

  void
  dissipation_of(const SceneParameters                &scene,
                 const std::vector<double>            &friction,
                 const TransientParameters::Integrator integrator,
                 const std::string                    &claim)
  {
    Parameters p                = parameters_of(scene);
    p.transient.integrator      = integrator;
    p.transient.time_step       = 2e-7;
    p.transient.sample_interval = 1e-5;
    p.transient.end_time        = 1e-4;
    p.transient.tolerance       = 1e-11;
    p.transient.disturbance     = 0.;
    if (integrator == TransientParameters::Integrator::explicit_)
      p.discretization.mass = DiscretizationParameters::Mass::lumped;
    Pressed                 r(p);
    const PreparedTransient prepared(r.pressed, r.p, r.timers);
    TransientRun            run(prepared.pressed,
                     prepared.steady,
                     prepared.linear,
                     prepared.branches,
                     r.p);
    run.advance();
    const TransientRecord &record = run.record();
    const Table            forces = force_table(prepared, record),
                energies          = energy_table(prepared, record);
    Worst  worst;
    double whole = 0.;
    for (unsigned int i = 0; i < friction.size(); ++i)
      {
        const ContactPair &pair = r.pressed.nodes().pairs()[i];
        const double       mean = power_of(r, pair, friction[i]);
        whole += mean;
        // A pair at rest is measured by what a sliding one of its force loses.
        const double scale =
          mean > 0. ? mean : r.pressed.speed() * r.resultant(i)[0];
        for (std::size_t k = 1; k < record.samples.size(); ++k)
          worst.add(
            std::abs(forces.real(k, pair.name() + "_friction_power_w") - mean) /
            scale);
        worst.add(std::abs(energies.real(10, pair.name() + "_friction_j") /
                             p.transient.end_time -
                           mean) /
                  scale);
      }
    worst.add(std::abs(forces.real(5, "friction_power_w") / whole - 1.));
    check(forces.is_missing(0, "friction_power_w"),
          "no power before the start");
    check_below(
      worst.largest(), 1e-6, claim + "each pair loses mu N v, also in sum");
    check_below(losses_beside_whole(record), 1e-12, claim + "losses add up");
  }

  void
  dissipation()
  {
    using Integrator = TransientParameters::Integrator;
    dissipation_of(
      pad_in_abutment(.3), {.4, 0.}, Integrator::reduced, "abutment: ");
    SceneParameters pads                  = disc_brake(.1);
    pads.contacts[1].friction_coefficient = .2;
    for (const auto &[integrator, name] :
         {std::make_pair(Integrator::reduced, "reduced: "),
          std::make_pair(Integrator::implicit, "implicit: "),
          std::make_pair(Integrator::explicit_, "explicit: ")})
      dissipation_of(pads, {.1, .2}, integrator, name);
  }



  /** A disc between two pads that are mirror images of each other, with a blow
   * on one of its sides that bends it. */
  Parameters
  struck_brake()
  {
    SceneParameters scene      = disc_brake(.1);
    scene.damping.mass_damping = 300.;
    Parameters p               = parameters_of(scene);
    auto      &t               = p.transient;
    t.time_step                = 2e-6;
    t.sample_interval          = 2e-6;
    t.end_time                 = .02;
    t.tolerance                = 1e-10;
    t.disturbance              = 0.;
    t.hammer.body              = "disc";
    t.hammer.face              = "top";
    t.hammer.force             = {{0., 0., -2000.}};
    t.hammer.time              = 1e-4;
    t.hammer.duration          = 2e-4;
    return p;
  }

  /** Of a force of the second half. */
  double
  rms_of_half(const std::vector<double> &force)
  {
    const std::size_t first = force.size() / 2, n = force.size() - first;
    double            mean = 0., square = 0.;
    for (std::size_t k = first; k < force.size(); ++k)
      mean += force[k] / n;
    for (std::size_t k = first; k < force.size(); ++k)
      square += (force[k] - mean) * (force[k] - mean) / n;
    return std::sqrt(square);
  }

  void
  opposed()
  {
    const Parameters        p = struck_brake();
    Pressed                 r(p);
    const PreparedTransient prepared(r.pressed, r.p, r.timers);
    const TransientRecord   record = record_of(r, prepared);
    const TransientFigures  f      = evaluate_transient(prepared, record, r.p);
    const Table             table  = transient_table(f);
    std::vector<double>     sum;
    for (const TransientSample &s : record.samples)
      sum.push_back(s.normal);
    const double rms[] = {
      rms_of_half(record.forces_of(0, &PairSample::normal)),
      rms_of_half(record.forces_of(1, &PairSample::normal))};
    std::printf("rms %.4g and %.4g N, of the sum %.4g N; %.2f Hz\n",
                rms[0],
                rms[1],
                rms_of_half(sum),
                f.largest_line);
    check(rms_of_half(sum) < .2 * rms[0], "the pads' forces cancel");
    check_close(rms[1], rms[0], .02, "each vibrates as much as the other");
    // Samples and steps of the second half differ by one.
    check_close(table.real(0, "rms_normal_n"),
                rms[f.loudest.number],
                2e-3,
                "the rms is that of one pad");
    check_close(table.real(0, "mean_normal_n"), 400., .05, "both carry");
    check_close(
      table.real(0, "loudest_mean_normal_n"), 200., .05, "each its share");
    check(table.text(0, "loudest_pair") ==
            r.pressed.nodes().pairs()[f.loudest.number].name(),
          "named");
    Worst off;
    for (const unsigned int k : prepared.branches)
      off.add(std::abs(table.real(0, "largest_line_hz") -
                       prepared.linear.lambda[k].imag() / (2. * M_PI)));
    check_below(off.smallest() / f.largest_line,
                5e-3,
                "its line is a frequency of the brake");
    check(evaluate_trigger(record, f, r.p.transient).text ==
            "temporary after the trigger",
          "the blow is felt: " +
            evaluate_trigger(record, f, r.p.transient).text);
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "apart")
    apart();
  else if (which == "speeds")
    speeds_of_pairs();
  else if (which == "opposed")
    opposed();
  else if (which == "abutment")
    abutment();
  else if (which == "growth")
    growth();
  else if (which == "dissipation")
    dissipation();
  else
    check(false, "an argument: one of the names above");
}
