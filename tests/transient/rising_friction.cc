// SPDX-License-Identifier: LGPL-2.1-or-later

// Friction that rises with the slip rate decays a motion in steps of any length
// as its eigenvalue says, of a pair that slides and of one at rest. Arguments:
// sliding or at_rest.

#include "scenes.h"
#include "transient/hand_made.h"

#include <squeal/transient/reduced_transient.h>
#include <squeal/transient/time_step_error.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  constexpr double belt = .1, kinetic = .3;

  /** Rate at which the pair @p k of @p l decays in a motion by steps @p dt that
   * begins with the velocity @p start along y; the motion never sticks. */
  double
  rate_in_time(const ReducedContactModel &m,
               const TransientDrive      &drive,
               const SteadySliding       &s,
               const LinearizedMotion    &l,
               const Eigen::Index         k,
               const double               dt,
               const double               start)
  {
    ReducedTransient run(m, dt, drive, 1., 1e-12);
    run.start(s.coordinates, Eigen::Vector3d(0., start, 0.), s.forces);
    const auto amplitude = [&]() {
      return std::abs(
        l.amplitudes(s, run.coordinates(), run.velocities(), run.forces())[k]);
    };
    double       first = 0., begin = 0.;
    unsigned int n_stuck = 0;
    while (run.time() < 18. * M_PI)
      {
        run.advance();
        n_stuck += run.status()[0] == ContactStatus::stick;
        if (first == 0. && run.time() > 2. * M_PI)
          {
            first = amplitude();
            begin = run.time();
          }
      }
    check(n_stuck == 0, "the node that slides slides on");
    return std::log(amplitude() / first) / (run.time() - begin);
  }

  /** s^2 + 1 + c s / (1 + c G s) = 0 with the dashpot @p c = p mu' behind the
   * flexibility G of a node. */
  Complex
  behind_flexibility(const double c, const double G)
  {
    Complex s(0., 1.);
    for (unsigned int i = 0; i < 50; ++i)
      s = Complex(0., 1.) * std::sqrt(1. + c * s / (1. + c * G * s));
    return s;
  }

  Eigen::Index
  nearest(const LinearizedMotion &l, const Complex exact)
  {
    Eigen::Index k;
    check_below((l.lambda.array() - exact).abs().minCoeff(&k),
                1e-10,
                "decays by the dashpot in series with the flexibility");
    return k;
  }

  /** Friction that rises is that of the slip rate of the step itself: steps of
   * any length give the rate of the dashpot, those as well in which the slip of
   * a node with the coefficient of the step before would change its sign from
   * step to step, below 2 G p mu'. */
  void
  rising_friction()
  {
    constexpr double  flexibility = .2;
    ContactParameters table;
    table.friction_law          = ContactParameters::FrictionLaw::table;
    table.friction_speeds       = {0., .02, .05, .3};
    table.friction_coefficients = {.5, .3, .3, .4};
    for (const bool by_table : {false, true})
      {
        const ContactParameters c =
          by_table ? table : falling(kinetic, kinetic - .1, .2);
        const FrictionLaw law(c);
        check(law.rises(), "the law rises");
        const double        slope = law.slope(belt);
        ReducedContactModel m     = oscillator(1e-3);
        m.flexibility = flexibility * Eigen::MatrixXd::Identity(3, 3);
        const NodalFriction    f = law.in_sliding(m.speed_ratio, belt);
        const SteadySliding    s = steady_sliding(m, f.coefficient, 1., 1e-13);
        const LinearizedMotion l = linearize(m, s, f, belt);
        const Complex          exact = behind_flexibility(slope, flexibility);
        const Eigen::Index     k     = nearest(l, exact);
        for (const double share : {.03, .3, 3.})
          {
            const double dt   = share * flexibility * slope,
                         rate = rate_in_time(
                           m, drive_by(c, belt), s, l, k, dt, 1e-3 * belt),
                         stated = reduced_step_error(m, l, dt)[k].real();
            std::printf("rises, dt %g: sigma %.8f, in time %.8f, stated "
                        "error %.2e\n",
                        dt,
                        exact.real(),
                        rate,
                        stated);
            check_below(std::abs(rate - exact.real() - stated),
                        1e-3 * std::abs(exact.real()) + .1 * std::abs(stated),
                        "rising friction decays in time");
          }
      }
  }



  /** The oscillator on a belt, pressed by 1 N, and a node at rest that another
   * newton presses against its side: it sees the motions along y and z. Nodes
   * give way by @p flexibility, m/N. */
  ReducedContactModel
  beside_abutment(const double flexibility)
  {
    ReducedContactModel m = empty_model(2, 3);
    m.flexibility         = flexibility * Eigen::MatrixXd::Identity(6, 6);
    m.omega_squared[1]    = 1.;
    m.load                = Eigen::Vector3d(-1., 0., -1.);
    m.speed_ratio[1]      = 0.;
    m.participation(0, 0) = m.participation(3, 2) = -1.; // normals z and x
    m.participation(1, 1) = m.participation(4, 1) = -1.;
    m.participation(2, 2) = m.participation(5, 0) = -1.;
    return m;
  }

  /** The same dashpot in a pair at rest whose friction rises from zero. */
  void
  damped_at_rest()
  {
    constexpr double  slope = .1, flexibility = .05, dt = .025;
    ContactParameters slides, rests;
    rests.friction_law          = ContactParameters::FrictionLaw::table;
    rests.friction_speeds       = {0., 10.};
    rests.friction_coefficients = {0., 10. * slope};
    auto laws =
      std::make_shared<FrictionLaws>(FrictionLaws(FrictionLaw(slides)));
    laws->append(FrictionLaw(rests), 1);
    const ReducedContactModel m = beside_abutment(flexibility);
    const NodalFriction       f = laws->in_sliding(m.speed_ratio, belt);
    check(f.coefficient[1] == 0. && f.slope[1] == slope,
          "at rest: no friction, and the slope of the law");
    const SteadySliding s = steady_sliding(m, f.coefficient, 1., 1e-13);
    check_close(s.forces[3], 1., 1e-9, "the abutment bears 1 N");
    const LinearizedMotion l     = linearize(m, s, f, belt);
    const Complex          exact = behind_flexibility(slope, flexibility);
    const Eigen::Index     k     = nearest(l, exact);
    TransientDrive         drive = steady_drive(0., belt);
    drive.laws                   = laws;
    const double rate            = rate_in_time(m, drive, s, l, k, dt, 1e-3),
                 stated          = reduced_step_error(m, l, dt)[k].real();
    std::printf("at rest: sigma %.8f, in time %.8f, stated error %.2e\n",
                exact.real(),
                rate,
                stated);
    check_close(rate, exact.real() + stated, .02, "and so it does in time");
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "sliding")
    rising_friction();
  else if (which == "at_rest")
    damped_at_rest();
  else
    check(false, "an argument: sliding or at_rest");
}
