// SPDX-License-Identifier: LGPL-2.1-or-later

// A brake whose disc turns with its mesh beside the same brake with a disc that
// stands still and slides: statics at several angles, a ramp in time with its
// energies and a restart.

#include "transient/turning_brake.h"
#include "worst.h"

#include <squeal/base/exceptions.h>
#include <squeal/contact/turning_contacts.h>
#include <squeal/transient/explicit_transient.h>
#include <squeal/transient/implicit_transient.h>

#include <deal.II/base/mpi.h>

#include <chrono>
#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Steady sliding with the disc at an angle: the sink of the load, m, where
   * the normal force goes through, m, and the nodal forces. */
  struct Static
  {
    double          sink;
    Eigen::Vector2d centre;
    Eigen::VectorXd forces;
  };

  Static
  press(const Reduced &r, TurningContact &turning, const double angle)
  {
    FullContactModel full = full_model(r);
    full.relative_motion  = turning.relative_motion(angle);
    const auto model      = reduce_contact_model(
      r.pencil,
      r.basis,
      r.model.cut_off,
      ContactNodes(r.scene.contacts, {turning.geometry(angle)}),
      Block(full.load));
    const SteadySliding s   = steady_sliding(model, mu);
    const auto          sum = s.resultant();
    check_close(sum[0], load, 1e-9, "the pad carries the load");
    check_close(sum[1], mu * load, 1e-9, "and its friction");
    Eigen::Vector2d centre(0., 0.);
    for (unsigned int j = 0; j < r.model.n_nodes(); ++j)
      for (unsigned int c = 0; c < 2; ++c)
        centre[c] += s.forces[3 * j] / load * turning.mortar().nodes()[j][c];
    return {full.load.dot(static_motion(full, s.coordinates, 1., s.forces)) /
              load,
            centre,
            s.forces};
  }

  void
  statics()
  {
    std::vector<double> sinks, centres, all_forces;
    for (const unsigned int n : {1, 2, 4})
      {
        // Statics do not depend on how many modes there are beside those of the
        // forces.
        const Reduced r(turning_brake({{16 * n, 3 * n, 1}}, 2), 3e3);
        const auto    turning = turning_contact(r, 0);
        const double  pitch   = 2. * M_PI / (16 * n);
        const Static  still   = press(r, *turning, 0.);
        const Static  whole   = press(r, *turning, 3. * pitch);
        check_below(std::abs(whole.sink / still.sink - 1.),
                    1e-9,
                    "a turn by whole cells: the sink of the load");
        check_below((whole.forces - still.forces).norm() / still.forces.norm(),
                    1e-6,
                    "a turn by whole cells: the nodal forces");
        Worst sink, centre, forces;
        for (const double share : {.17, .35, .5, .71})
          {
            const Static s = press(r, *turning, (2. + share) * pitch);
            sink.add(std::abs(s.sink / still.sink - 1.));
            centre.add((s.centre - still.centre).norm() / .01);
            forces.add((s.forces - still.forces).norm() / still.forces.norm());
          }
        std::printf("disc of %u cells: sink %.3e m, changes by %.2e with the "
                    "angle, centre of pressure by %.2e of the pad's width, "
                    "nodal forces by %.2e\n",
                    16 * n,
                    still.sink,
                    sink.largest(),
                    centre.largest(),
                    forces.largest());
        sinks.push_back(sink.largest());
        centres.push_back(centre.largest());
        all_forces.push_back(forces.largest());
      }
    check_below(sinks[2], 1e-3, "finest disc, any angle: sink");
    check_below(centres[2], 5e-3, "finest disc, any angle: centre");
    check_below(all_forces[2], 3e-2, "finest disc, any angle: nodal forces");
    for (unsigned int i = 1; i < 3; ++i)
      {
        check_below(sinks[i], sinks[i - 1] / 2., "sink: falls with the cells");
        check_below(all_forces[i],
                    all_forces[i - 1],
                    "nodal forces: fall with the cells");
      }
  }



  struct Course
  {
    std::vector<double> normal, tangential;
    double              imbalance, steps_per_second;
    EnergyLedger        ledger;
  };

  Course
  run(TransientIntegrator &motion,
      const Reduced       &r,
      const double         end,
      const double         dt)
  {
    Course     result;
    const auto begin = std::chrono::steady_clock::now();
    motion.start(Eigen::VectorXd::Zero(r.model.n_modes()),
                 Eigen::VectorXd::Zero(r.model.n_modes()),
                 Eigen::VectorXd::Zero(3 * r.model.n_nodes()));
    unsigned int n = 0;
    while (motion.time() < end)
      {
        motion.advance();
        if (motion.time() >= result.normal.size() * dt)
          {
            double normal = 0., tangential = 0.;
            for (unsigned int j = 0; j < r.model.n_nodes(); ++j)
              {
                normal += motion.forces()[3 * j];
                tangential += motion.forces()[3 * j + 1];
              }
            result.normal.push_back(normal);
            result.tangential.push_back(tangential);
          }
        ++n;
      }
    result.ledger           = motion.ledger();
    result.imbalance        = motion.ledger().imbalance();
    result.steps_per_second = n / std::chrono::duration<double>(
                                    std::chrono::steady_clock::now() - begin)
                                    .count();
    return result;
  }

  double
  rms_difference(const std::vector<double> &a, const std::vector<double> &b)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += std::pow(a[i] - b[i], 2);
    return std::sqrt(sum / a.size());
  }

  /** Twice the course with half the step less that with the whole one: without
   * what falls with the step. */
  std::vector<double>
  extrapolated(const Course &whole, const Course &half)
  {
    std::vector<double> result = half.normal;
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] += half.normal[i] - whole.normal[i];
    return result;
  }

  /** The two integrators have the same motion as their steps go to 0. All steps
   * divide the interval of the samples, that none is taken late. */
  void
  implicit_and_explicit(const FullContactModel &turning,
                        const Reduced          &r,
                        const double            end)
  {
    const double        interval = 1e-5;
    std::vector<Course> implicits, explicits;
    for (const unsigned int n : {2, 4, 8})
      {
        ImplicitTransient motion(
          turning, interval / n, drive(4e-4), load / r.model.n_nodes());
        implicits.push_back(run(motion, r, end, interval));
        check_below(
          implicits.back().imbalance, 1e-10, "implicit: the ledger closes");
      }
    const double n_stable = std::ceil(interval / stable_step(r));
    for (const unsigned int n : {1, 2, 4})
      {
        ExplicitTransient motion(turning,
                                 interval / (n * n_stable),
                                 drive(4e-4),
                                 load / r.model.n_nodes());
        explicits.push_back(run(motion, r, end, interval));
      }
    for (const auto *courses : {&implicits, &explicits})
      {
        const auto       &c = *courses;
        const std::string name =
          courses == &implicits ? "implicit" : "explicit";
        const double first  = rms_difference(c[0].normal, c[1].normal),
                     second = rms_difference(c[1].normal, c[2].normal);
        std::printf("%s: half the step changes the force by %.2e, again half "
                    "by %.2e; ledger %.1e, %.0f steps/s\n",
                    name.c_str(),
                    first / load,
                    second / load,
                    c[2].imbalance,
                    c[2].steps_per_second);
        check_close(std::log2(first / second),
                    1.,
                    .15,
                    name + ": first order in the step");
      }
    check_below(rms_difference(extrapolated(implicits[1], implicits[2]),
                               extrapolated(explicits[1], explicits[2])) /
                  load,
                3e-4,
                "implicit against explicit, both extrapolated to no step");
  }

  void
  agreement()
  {
    const double        end = 2e-3;
    std::vector<double> differences;
    for (const unsigned int n : {1, 2, 4})
      {
        const SceneParameters scene = turning_brake({{16 * n, 3 * n, 1}}, 1);
        const Reduced         r(scene, 12e3, 0., true, 1);
        const double          dt    = stable_step(r);
        FullContactModel      still = full_model(r), turning = still;
        turning.turning =
          std::make_shared<TurningContacts>(turning_contact(r, 250));
        ExplicitTransient eulerian(
          still, dt, drive(4e-4), load / r.model.n_nodes()),
          corotating(turning, dt, drive(4e-4), load / r.model.n_nodes());
        const Course a      = run(eulerian, r, end, 1e-5),
                     b      = run(corotating, r, end, 1e-5);
        const double normal = rms_difference(a.normal, b.normal) / load,
                     tangential =
                       rms_difference(a.tangential, b.tangential) / (mu * load);
        std::printf("disc of %u cells, %u unknowns, turned by %.2f cells: rms "
                    "difference normal %.2e, tangential %.2e; ledger %.1e and "
                    "%.1e; driving %.4e and %.4e J, friction %.4e and %.4e J; "
                    "%.0f and %.0f steps/s\n",
                    16 * n,
                    r.pencil.space()->n_global(),
                    fast * end / .1075 / (2 * M_PI / (16 * n)),
                    normal,
                    tangential,
                    a.imbalance,
                    b.imbalance,
                    a.ledger.driving,
                    b.ledger.driving,
                    a.ledger.friction,
                    b.ledger.friction,
                    a.steps_per_second,
                    b.steps_per_second);
        check_below(b.imbalance, 1e-10, "explicit: the ledger closes");
        differences.push_back(std::max(normal, tangential));
        if (n > 1)
          continue;
        implicit_and_explicit(turning, r, end);
      }
    check_below(differences[2], 3e-3, "finest disc: both frames agree");
    for (unsigned int i = 1; i < 3; ++i)
      check_below(differences[i],
                  differences[i - 1] / 2.,
                  "the difference falls with the disc's cells");
    // Between the first and the second order: edges of cells pass the pad's.
    check_below(differences[2],
                differences[0] / 8.,
                "a quarter of the cells' width: order 1.5 at least");
  }

  /** Without friction and damping the turning of an axisymmetric disc does no
   * work but what its cells let through. */
  void
  no_friction()
  {
    std::vector<double> shares;
    for (const unsigned int n : {1, 2})
      {
        SceneParameters scene = turning_brake({{16 * n, 3 * n, 1}}, 1);
        scene.damping         = {};
        const Reduced    r(scene, 12e3, 0., true, 1);
        FullContactModel full = full_model(r);
        full.turning =
          std::make_shared<TurningContacts>(turning_contact(r, 250));
        TransientDrive d = drive(0.);
        d.friction       = [](double) { return 0.; };
        ExplicitTransient motion(
          full, stable_step(r), d, load / r.model.n_nodes());
        const SteadySliding s = steady_sliding(r.model, 0.);
        motion.start(
          s.coordinates, Eigen::VectorXd::Zero(r.model.n_modes()), s.forces);
        Worst largest;
        while (motion.time() < 2e-3)
          {
            motion.advance();
            largest.add(std::abs(motion.ledger().driving));
          }
        const EnergyLedger e = motion.ledger();
        shares.push_back(largest.largest() / e.start);
        std::printf("disc of %u cells: work of the turning at most %.2e J, "
                    "stored %.2e J, ledger %.1e\n",
                    16 * n,
                    largest.largest(),
                    e.start,
                    e.imbalance());
        check(e.friction == 0., "no friction");
        check_below(e.imbalance(), 1e-10, "the ledger closes");
      }
    check_below(shares[1], shares[0] / 2., "the work falls with the cells");
  }



  /** A continued run against one that was not stopped. */
  void
  restart()
  {
    const Reduced r(turning_brake({{16, 3, 1}}, 2), 12e3, 0., true, 1);
    const double  dt = stable_step(r), h = dt / .9 * .5;
    const auto    explicit_run = [&]() -> std::unique_ptr<TransientIntegrator> {
      FullContactModel m = full_model(r);
      m.turning = std::make_shared<TurningContacts>(turning_contact(r, 20));
      return std::make_unique<ExplicitTransient>(
        m, h, drive(1e-4), load / r.model.n_nodes());
    };
    const auto implicit_run = [&]() -> std::unique_ptr<TransientIntegrator> {
      FullContactModel m = full_model(r);
      m.turning = std::make_shared<TurningContacts>(turning_contact(r, 20));
      return std::make_unique<ImplicitTransient>(
        m, 4e-6, drive(1e-4), load / r.model.n_nodes());
    };
    const auto compare = [&](const auto &make, const std::string &name) {
      const auto start = [&](TransientIntegrator &run) {
        run.start(Eigen::VectorXd::Zero(r.model.n_modes()),
                  Eigen::VectorXd::Zero(r.model.n_modes()),
                  Eigen::VectorXd::Zero(3 * r.model.n_nodes()));
      };
      const auto whole = make(), second = make();
      start(*whole);
      for (unsigned int i = 0; i < 500; ++i)
        whole->advance();
      const NamedNumbers memory = whole->memory();
      for (unsigned int i = 0; i < 500; ++i)
        whole->advance();
      start(*second);
      second->restore(memory);
      for (unsigned int i = 0; i < 500; ++i)
        second->advance();
      check(whole->memory() == second->memory(),
            name + ": a continued run gives the same bits");
      check(whole->forces().norm() > 1., name + ": the pad is pressed on");
    };
    compare(explicit_run, "explicit");
    compare(implicit_run, "implicit");
    const ShiftedInverse inverse(r.pencil, -1e12);
    check_throws<InputError>(
      [&]() {
        ContactCompliance(inverse, std::vector<unsigned int>(30000), 30000);
      },
      "Transient/Disc frame",
      "a ring of too many unknowns for the memory is refused");
  }



} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "statics")
    statics();
  else if (which == "agreement")
    agreement();
  else if (which == "no_friction")
    no_friction();
  else if (which == "restart")
    restart();
  else
    check(false, "an argument: statics, agreement, no_friction or restart");
}
