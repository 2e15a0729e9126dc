// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The certified basis of a coarse TriboBrake over the box of its stability map:
// true errors, estimates, reuse.
#include <squeal/base/exceptions.h>
#include <squeal/eigen/certified_solver.h>
#include <squeal/sweep/branch_tracker.h>
#include <squeal/sweep/continued_pencils.h>
#include <squeal/sweep/stability.h>

#include "check.h"
#include "coarse_brake.h"
#include "source_directory.h"
#include "worst.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <fstream>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Setup = CoarseBrake;

  /** Coordinates of coalescences on lines through the box. */
  std::vector<SweepPoint>
  lock_ins(const Setup &setup, const ReducedModel &model)
  {
    std::vector<SweepPoint> result;
    TrackingOptions         options;
    options.lowest_frequency  = 2000.;
    options.highest_frequency = 6000.;
    for (const double mu : {0.2, 0.5, 0.7})
      {
        const auto solver = [&](const double x) {
          SweepPoint point(2);
          point << x, mu;
          return setup.solve(model, point);
        };
        BranchTracker       tracker(solver, options);
        std::vector<double> coordinates;
        for (unsigned int i = 0; i <= 50; ++i)
          coordinates.push_back(9. + 0.04 * i);
        const auto line = tracker.track(coordinates);
        SweepPoint start(2);
        start << 9., mu;
        for (const auto &e :
             LineStability(solver, options, 1e-6)
               .exceptional_points(line,
                                   continuation_of(setup.system, model, start)))
          {
            SweepPoint point(2);
            point << e.coordinate.real(), mu;
            result.push_back(point);
          }
      }
    return result;
  }

  void
  thirty_points(const Setup &setup, const ReducedModel &model)
  {
    const auto coalescences = lock_ins(setup, model);
    check(coalescences.size() >= 4,
          "lock-ins in the box: " + std::to_string(coalescences.size()));
    std::vector<SweepPoint> points;
    for (unsigned int i = 0; i < 10; ++i)
      {
        points.push_back(coalescences[i % coalescences.size()]);
        points.back()[0] += (i % 2 ? 1. : -1.) * 1e-4 / (1. + i / 4);
      }
    const auto spread = setup.grid.spread(520);
    points.insert(points.end(), spread.end() - 20, spread.end());

    Worst        worst_frequency;
    Worst        worst_sigma;
    unsigned int n_judged = 0, n_pairs = 0, n_zero = 0;
    Worst        least;
    Worst        largest;
    for (const auto &point : points)
      {
        const ComplexPairs pairs  = setup.solve(model, point);
        const ComplexPairs direct = setup.direct(setup.grid.scene(point));
        ComplexPairs       truth  = pairs;
        estimate_errors(truth, direct.lambda);
        for (unsigned int i = 0; i < pairs.size(); ++i)
          {
            const double error = truth.error_estimate[i];
            const double shift = error * std::abs(pairs.lambda[i]);
            worst_frequency.add(shift / pairs.lambda[i].imag());
            worst_sigma.add(shift);
            ++n_pairs;
            n_zero += pairs.error_estimate[i] == 0.;
            if (!(error <= 1e-10))
              {
                ++n_judged;
                least.add(pairs.error_estimate[i] / error);
                largest.add(pairs.error_estimate[i] / error);
              }
          }
      }
    std::cout << n_pairs << " pairs, " << n_judged
              << " errors above 1e-10, estimate over error from "
              << least.smallest() << " to " << largest.largest()
              << ", worst error " << worst_frequency.largest() << ", "
              << worst_sigma.largest() << " 1/s\n";
    check(worst_frequency.largest() <= setup.options.frequency_tolerance,
          "frequencies of 30 points within the tolerance");
    check(worst_sigma.largest() <= setup.options.sigma_tolerance,
          "sigmas of 30 points within the tolerance");
    check(n_judged > 30, "enough errors to judge the estimates");
    check(n_zero == 0, "no estimate vanishes");
    check(least.smallest() > 1. / 3. && largest.largest() < 3.,
          "estimates within a factor of 3");
  }

  void
  reuse(const Setup &setup, const ReducedModel &model)
  {
    write_reduced_model(model, "abc", "basis.h5");
    std::string        hash;
    const ReducedModel again = read_reduced_model("basis.h5", hash);
    check(hash == "abc", "the hash comes back");
    SweepPoint point(2);
    point << 10.1, 0.4;
    const ComplexPairs a = setup.solve(model, point),
                       b = setup.solve(again, point);
    check(a.size() == b.size() &&
            (a.lambda - b.lambda).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <
              1e-12 * a.lambda.cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
          "a saved basis gives the same eigenvalues");
    {
      std::ifstream     in("basis.h5", std::ios::binary);
      const std::string all((std::istreambuf_iterator<char>(in)), {});
      std::ofstream("short.h5", std::ios::binary)
        << all.substr(0, all.size() / 2);
      std::ofstream("text.h5") << "no HDF5\n";
    }
    check_throws<InputError>([&]() { read_reduced_model("short.h5", hash); },
                             "short.h5",
                             "a file that is cut off is refused");
    check_throws<InputError>([&]() { read_reduced_model("text.h5", hash); },
                             "text.h5",
                             "a file that is no HDF5 is refused");
  }

  void
  geometry_is_refused()
  {
    Parameters p =
      read_parameters(SQUEAL_SOURCE_DIR "/prm/tribobrake/stability_map.prm",
                      {"Sweep/Axis mu/Entries = Scene/Body disc/Height",
                       "Sweep/Axis mu/Values = 0.01, 0.02"});
    const SweepGrid    grid(p);
    const AffineSystem nothing;
    check_throws<InputError>([&]() { ParametricSystem(nothing, grid); },
                             "Scene/Body disc/Height",
                             "a length is no factor of a matrix");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  geometry_is_refused();
  const Setup  setup;
  BasisBuilder builder(setup.system, setup.options);
  const auto   model = builder.build([](const BasisRound &round) {
    std::cout << "basis " << round.basis_size << ", " << round.n_factors
              << " factors: " << round.worst.frequency << ", "
              << round.worst.sigma << " 1/s\n";
  });
  std::cout << model.n_total() << " vectors, cells of up to "
            << model.largest_basis() << "\n";
  check(setup.system.merged().terms.size() == 4, "four affine parts");
  thirty_points(setup, model);
  reuse(setup, model);
}
