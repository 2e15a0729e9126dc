// SPDX-License-Identifier: LGPL-2.1-or-later

// The pressed brake of prm/tribobrake on a coarse mesh, with free, guided and
// held top, from its parameter file to motion in time.

#include "check.h"
#include "source_directory.h"
#include "worst.h"

#include <squeal/analyses/transient/campaign_table.h>
#include <squeal/analyses/transient/transient_verdict.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/output/contact_output.h>
#include <squeal/transient/reduced_transient.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdio>
#include <memory>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  Parameters
  coarse(const std::string &top, std::vector<std::string> more = {})
  {
    std::vector<std::string> all = {"Analysis = transient",
                                    "Scene/Body disc/Cells = 16, 3, 1",
                                    "Scene/Body pad/Cells = 2, 2, 2",
                                    "Scene/Body support/Cells = 2, 2, 6",
                                    "Scene/Contact pad_disc/Contact state = "
                                    "full",
                                    "Scene/Support top/Kind = " + top};
    all.insert(all.end(), more.begin(), more.end());
    const Parameters p = read_parameters(
      std::string(SQUEAL_SOURCE_DIR) + "/prm/tribobrake/pressed.prm", all);
    p.check();
    return p;
  }

  struct Brake
  {
    Brake(const Parameters &p, const double cut_off = 20e3)
      : parameters(p)
      , model(parameters, timers)
      , pressed(parameters,
                *model.discretization(),
                model.body_matrices(),
                cut_off,
                timers)
    {
    }

    const ContactGeometry &
    geometry() const
    {
      return pressed.nodes().pairs()[0].geometry;
    }

    const Parameters parameters;
    Timers           timers;
    Model            model;
    PressedModel     pressed;
  };

  void
  check_close(const double       got,
              const double       expected,
              const double       tolerance,
              const std::string &claim)
  {
    char text[200];
    std::snprintf(text, sizeof text, ": %.10g, %.10g", got, expected);
    check(std::abs(got - expected) <= tolerance, claim + text);
  }

  void
  tops()
  {
    std::vector<Eigen::VectorXd> forces;
    for (const std::string top : {"free", "guided", "held"})
      {
        Brake                brake(coarse(top));
        const SteadyModel    about = brake.pressed.steady(1e-10, brake.timers);
        const SteadySliding &s     = about.sliding;
        const auto           r = contact_resultant(brake.geometry(), s.forces);
        check_close(r.force[2], 100., 1e-6, top + ": carries the load");
        check_close(r.force[1], 50., 1e-6, top + ": friction along +y");
        // About 4.6 times the mean, 3 mm from the middle of a pad of 10 mm.
        check(r.leading_edge_factor > 4.,
              top + ": pressed at the edge of entry, " +
                std::to_string(r.leading_edge_factor));
        check(r.centre[1] < -2.5e-3, top + ": centre of pressure towards it");
        forces.push_back(s.forces);

        TransientDrive drive;
        drive.friction = [](double) { return .5; };
        drive.speed    = [&](double) { return brake.pressed.speed(); };
        drive.load     = [](double) { return 1.; };
        ReducedTransient run(
          about.pressed.model(), 2e-6, drive, 100. / s.status.size());
        run.start(
          s.coordinates, Eigen::VectorXd::Zero(s.coordinates.size()), s.forces);
        Worst worst;
        for (unsigned int i = 0; i < 500; ++i)
          {
            run.advance();
            worst.add((run.forces() - s.forces)
                        .cwiseAbs()
                        .maxCoeff<Eigen::PropagateNaN>());
          }
        check(worst.largest() < 1e-4,
              top + ": undisturbed it stays in steady sliding, " +
                std::to_string(worst.largest()) + " N");
      }
    check((forces[1] - forces[2]).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <
            1e-6,
          "held: the forces of the guided top");
    check((forces[0] - forces[1]).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() >
            0.1,
          "guided: others than with the free top");
  }

  void
  backwards()
  {
    // Mirrored in y and turning backwards.
    Brake forth(coarse("free")),
      back(
        coarse("free", {"Scene/Contact pad_disc/Friction coefficient = -0.5"}));
    const auto a = contact_resultant(
      forth.geometry(),
      forth.pressed.steady(1e-10, forth.timers).sliding.forces);
    const auto b = contact_resultant(
      back.geometry(), back.pressed.steady(1e-10, back.timers).sliding.forces);
    check(sliding_text(forth.geometry()) == "+y" &&
            sliding_text(back.geometry()) == "-y",
          "the sliding turns");
    check(a.force[1] > 0., "friction drags the pad along the sliding");
    check_close(b.force[1], a.force[1], 1e-6, "along it friction is the same");
    check_close(b.centre[1], a.centre[1], 1e-8, "and the centre of pressure");
    check_close(b.leading_edge_factor,
                a.leading_edge_factor,
                1e-6,
                "the edge of entry is the other one");
  }

  void
  springs()
  {
    Brake                brake(coarse("free",
                       {"Scene/Contact pad_disc/Formulation = springs",
                                       "Scene/Contact pad_disc/Grid = 5, 5"}));
    const SteadyModel    about = brake.pressed.steady(1e-10, brake.timers);
    const SteadySliding &s     = about.sliding;
    check_close(s.resultant()[0], 100., 1e-6, "springs carry the load");
    const auto           states = press_at_rest(about.pressed.model(), .5, 4);
    const SteadySliding &rest   = states.back();
    check_close(rest.resultant()[0], 100., 1e-6, "at rest too");
    check(rest.n_with(ContactStatus::stick) > 0, "there nodes stick");
    for (std::size_t j = 0; j < rest.status.size(); ++j)
      check(rest.forces.segment<2>(3 * j + 1).norm() <=
              .5 * rest.forces[3 * j] + 1e-7,
            "within the friction cone");
  }

  void
  ramp_and_hammer()
  {
    Brake                   brake(coarse("guided",
                       {"Transient/Start = ramp",
                                          "Scene/Load press/Ramp time = 2e-3",
                                          "Scene/Contact pad_disc/Friction coefficient = 0.1",
                                          "Scene/Damping/Stiffness damping = 1e-5",
                                          "Transient/End time = 8e-3",
                                          "Transient/Time step = 4e-6",
                                          "Transient/Hammer/Body = support",
                                          "Transient/Hammer/Face = y_min",
                                          "Transient/Hammer/Force = 0, 20, 0",
                                          "Transient/Hammer/Time = 3e-3"}));
    const PreparedTransient prepared(
      brake.pressed, brake.parameters, brake.timers);
    TransientRun run(prepared.pressed,
                     prepared.steady,
                     prepared.linear,
                     prepared.branches,
                     brake.parameters);
    check(run.advance(), "to the end");
    const auto &record  = run.record();
    const auto &samples = record.samples;
    Worst       worst;
    Worst       struck;
    for (std::size_t k = 0; k < samples.size(); ++k)
      {
        const auto &s = samples[k];
        // Before that next to no work is done.
        if (s.time > 2e-4)
          worst.add(s.imbalance);
        if (s.time > 3e-3 && s.time < 3.4e-3)
          struck.add(std::abs(record.pair(k, 0).acceleration[1]));
      }
    check_close(samples.front().normal, 0., 1e-12, "no force at the start");
    check(force_table(prepared, record).is_missing(0, "leading_edge_factor"),
          "nor an edge that it could lean on");
    CampaignRun campaign;
    campaign.parameters = brake.parameters;
    Table table         = campaign_columns(brake.parameters);
    table.add_row(
      campaign_row(campaign,
                   prepared,
                   record,
                   evaluate_transient(prepared, record, brake.parameters)));
    check_close(table.real(0, "leading_edge_factor"),
                contact_resultant(prepared.pressed.nodes().pairs()[0].geometry,
                                  prepared.steady.forces)
                  .leading_edge_factor,
                1e-12,
                "a campaign states the edge in steady sliding");
    check_close(samples.back().normal, 100., 5., "the load at the end");
    check(worst.largest() < 1e-3,
          "the ledger closes over ramp and blow: " +
            std::to_string(worst.largest()));
    check(struck.largest() > 30.,
          "the blow is felt: " + std::to_string(struck.largest()));
  }
  /** What rings on about a steady sliding that is stable is no limit cycle;
   * what the contact bounds is one. */
  void
  limit_cycles()
  {
    for (const auto &[friction, squeals] :
         {std::make_pair("0.1", false), std::make_pair("0.5", true)})
      {
        Brake                   brake(coarse("free",
                           {"Scene/Contact pad_disc/Friction coefficient = " +
                                                std::string(friction),
                                              "Scene/Body pad/Young modulus = 1.6e10",
                                              "Eigenvalues/Lowest frequency = 900",
                                              "Eigenvalues/Highest frequency = 7000",
                                              "Transient/Disturbance = 1e-6",
                                              "Transient/End time = 0.08",
                                              "Transient/Time step = 4e-6"}));
        const PreparedTransient prepared(
          brake.pressed, brake.parameters, brake.timers);
        TransientRun run(prepared.pressed,
                         prepared.steady,
                         prepared.linear,
                         prepared.branches,
                         brake.parameters);
        check(run.advance(), "to the end");
        const TransientFigures f =
          evaluate_transient(prepared, run.record(), brake.parameters);
        const std::string name = std::string("friction ") + friction + ": ";
        const std::string text = limit_cycle_text(f);
        // How even the squeal is differs from machine to machine.
        const bool looks_steady =
          f.least_rms > .8 * f.most_rms && f.most_rms > 1e-4 * f.mean_normal;
        check(squeals
                ? f.least_rms > .5 * f.mean_normal && f.most_rms < f.mean_normal
                : looks_steady,
              name + "quarters of " + std::to_string(f.least_rms) + " to " +
                std::to_string(f.most_rms) + " N rms");
        check(f.verdict == (squeals ? "unstable" : "stable"), name + f.verdict);
        check(f.dies_out == !squeals, name + "dies out or not");
        Worst worst;
        for (const BranchResult &b : f.branches)
          if (b.fit.is_valid)
            worst.add(std::abs(b.fit.frequency / b.frequency - 1.));
        check(f.branches[f.leading].fit.is_valid && worst.largest() < .025,
              name + "rates of pairs that turn at their own frequency only: " +
                std::to_string(worst.largest()));
        check(f.has_limit_cycle == (squeals && looks_steady), name + text);
        check((text.find("dies out") != std::string::npos) == !squeals &&
                (text.find("Hz") != std::string::npos) == f.has_limit_cycle,
              name + "said in words: " + text);
        if (!squeals)
          check_close(f.phase, 0., 1e-2, name + "all slip: forces in phase");
      }
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "tops")
    tops();
  else if (which == "backwards")
    backwards();
  else if (which == "springs")
    springs();
  else if (which == "ramp")
    ramp_and_hammer();
  else if (which == "limit_cycles")
    limit_cycles();
  else
    check(false, "an argument: tops, backwards, springs, ramp or limit_cycles");
}
