// SPDX-License-Identifier: LGPL-2.1-or-later

// Statistics of the contact force are those of every step, however far apart
// the samples are, with each integrator, and the same bits where a run goes on
// from a checkpoint.

#include "transient/two_pads.h"
#include "worst.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Integrator = TransientParameters::Integrator;

  constexpr unsigned int n_steps = 1000;

  /** Two pads that bounce on a disc. */
  Parameters
  bouncing(const Integrator integrator, const unsigned int steps_of_sample)
  {
    Parameters p                = parameters_of(disc_brake(.3));
    p.transient.integrator      = integrator;
    p.transient.time_step       = 2e-7;
    p.transient.end_time        = n_steps * p.transient.time_step;
    p.transient.sample_interval = steps_of_sample * p.transient.time_step;
    p.transient.disturbance     = 1e-4;
    p.transient.tolerance       = 1e-10;
    if (integrator == Integrator::explicit_)
      p.discretization.mass = DiscretizationParameters::Mass::lumped;
    return p;
  }

  /** A brake, its transient and what it comes to. */
  struct Bounce
  {
    explicit Bounce(const Parameters &p)
      : pressed(p)
      , prepared(pressed.pressed, pressed.p, pressed.timers)
    {
    }

    TransientRun
    start() const
    {
      return TransientRun(prepared.pressed,
                          prepared.steady,
                          prepared.linear,
                          prepared.branches,
                          pressed.p);
    }

    TransientFigures
    figures(const TransientRun &run) const
    {
      return evaluate_transient(prepared, run.record(), pressed.p);
    }

    Pressed           pressed;
    PreparedTransient prepared;
  };

  /** Every number that is said to be one of all steps. */
  std::vector<double>
  numbers_of(const TransientFigures &f)
  {
    return {f.mean_normal_of_all,
            double(f.loudest.number),
            f.mean_normal,
            f.rms_normal,
            f.min_normal,
            f.max_normal,
            f.mean_tangential,
            f.rms_tangential,
            f.macroscopic_friction,
            f.mean_leading_edge_factor,
            f.least_rms,
            f.most_rms,
            f.rms_acceleration,
            f.separates ? 1. : 0.};
  }

  /** Of samples that are steps, by the plain formulas. */
  void
  check_formulas(const TransientRecord  &record,
                 const TransientFigures &f,
                 const std::string      &claim)
  {
    const unsigned int  first = n_steps / 2 + 1;
    const double        n     = n_steps / 2;
    double              mean = 0., square = 0., edge = 0.;
    double              mean_of_all = 0.;
    std::vector<double> normal, accelerations(record.n_pairs(), 0.);
    for (unsigned int k = first; k <= n_steps; ++k)
      {
        const TransientSample &s = record.samples[k];
        normal.push_back(record.pair(k, f.loudest.number).normal);
        mean += normal.back() / n;
        mean_of_all += s.normal / n;
        edge += s.leading_edge * s.normal / n;
        for (unsigned int i = 0; i < record.n_pairs(); ++i)
          for (const double a : record.pair(k, i).acceleration)
            accelerations[i] += a * a / n;
      }
    for (const double x : normal)
      square += (x - mean) * (x - mean) / n;
    const auto [least, most] =
      std::minmax_element(normal.begin(), normal.end());
    // Sums in another order: rounding.
    constexpr double rounding = 1e-10;
    check_close(
      f.mean_normal_of_all, mean_of_all, rounding, claim + "mean of all");
    check_close(f.mean_normal, mean, rounding, claim + "mean");
    check_close(f.rms_normal, std::sqrt(square), rounding, claim + "rms");
    check_close(f.min_normal, *least, rounding, claim + "least", mean);
    check_close(f.max_normal, *most, rounding, claim + "largest");
    check_close(f.mean_leading_edge_factor,
                edge / mean_of_all,
                rounding,
                claim + "leading edge");
    const double loudest =
      *std::max_element(accelerations.begin(), accelerations.end());
    check_close(
      f.rms_acceleration, std::sqrt(loudest), rounding, claim + "acceleration");
  }

  /** The largest force on pair @p i that samples of the second half see. */
  double
  largest_of_samples(const TransientRecord &record, const unsigned int i)
  {
    Worst largest;
    for (std::size_t k = record.samples.size() / 2; k < record.samples.size();
         ++k)
      largest.add(record.pair(k, i).normal);
    return largest.largest();
  }

  void
  check_integrator(const Integrator integrator, const std::string &claim)
  {
    const Bounce each(bouncing(integrator, 1)), few(bouncing(integrator, 200));
    TransientRun fine = each.start(), coarse = few.start();
    fine.advance();
    coarse.advance();
    const TransientFigures f = each.figures(fine), g = few.figures(coarse);
    std::printf("%smean %.4f N, %.4f to %.4f N, in samples up to %.4f N\n",
                claim.c_str(),
                f.mean_normal,
                f.min_normal,
                f.max_normal,
                largest_of_samples(coarse.record(), f.loudest.number));
    check(f.max_normal >
            1.01 * largest_of_samples(coarse.record(), f.loudest.number),
          claim + "the largest force is between two samples");
    check_formulas(fine.record(), f, claim);
    check(numbers_of(f) == numbers_of(g),
          claim + "every bit whatever the interval of the samples");

    // The watch is called every fifty steps.
    TransientRun stopped = few.start(), resumed = few.start();
    check(!stopped.advance([&](const unsigned int) {
      return stopped.record().n_steps > .7 * n_steps;
    }),
          claim + "stopped behind the middle");
    resumed.restore(stopped.memory());
    resumed.advance();
    check(numbers_of(few.figures(resumed)) == numbers_of(g),
          claim + "every bit after a restart");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  for (const auto &[integrator, name] :
       {std::make_pair(Integrator::reduced, std::string("reduced")),
        std::make_pair(Integrator::implicit, std::string("implicit")),
        std::make_pair(Integrator::explicit_, std::string("explicit"))})
    if (which == name)
      {
        check_integrator(integrator, name + ": ");
        return 0;
      }
  check(false, "an argument: reduced, implicit or explicit");
}
