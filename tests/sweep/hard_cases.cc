// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Certified sweeps of a coarse TriboBrake where sweeps get hard: no friction,
// too much of it and the wrong way round; stiffnesses over many decades;
// hanging nodes under the pad. True errors everywhere by direct solutions.
#include <squeal/eigen/certified_solver.h>

#include "check.h"
#include "coarse_brake.h"
#include "worst.h"

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_handler.h>

#include <algorithm>
#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Setup = CoarseBrake;

  ReducedModel
  build(const Setup &setup)
  {
    BasisBuilder builder(setup.system, setup.options);
    const auto   model = builder.build();
    std::cout << model.n_total() << " vectors, " << model.cells.size()
              << " cells of up to " << model.largest_basis() << "\n";
    return model;
  }

  /** Every pair of a point is one of the full model, within the tolerances. */
  ComplexPairs
  judge(const Setup &setup, const ReducedModel &model, const SweepPoint &point)
  {
    const ComplexPairs pairs  = setup.solve(model, point);
    const ComplexPairs direct = setup.direct(setup.grid.scene(point));
    Worst              worst_frequency;
    Worst              worst_sigma;
    ComplexPairs       truth = pairs;
    estimate_errors(truth, direct.lambda);
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        const double shift =
          truth.error_estimate[i] * std::abs(pairs.lambda[i]);
        worst_frequency.add(shift / pairs.lambda[i].imag());
        worst_sigma.add(shift);
      }
    std::ostringstream text;
    text << "at " << point.transpose() << ": " << pairs.size()
         << " pairs within the tolerance, worst " << worst_frequency.largest()
         << ", " << worst_sigma.largest() << " 1/s";
    check(pairs.size() > 0 &&
            worst_frequency.largest() <= setup.options.frequency_tolerance &&
            worst_sigma.largest() <= setup.options.sigma_tolerance,
          text.str());
    // None is missing: all that the direct solver has inside the band.
    unsigned int n_inside = 0;
    for (unsigned int i = 0; i < direct.size(); ++i)
      n_inside += direct.frequency(i) > setup.options.band.lowest &&
                  direct.frequency(i) < setup.options.band.highest;
    check(n_inside == pairs.size(),
          "and none missing of " + std::to_string(n_inside));
    return pairs;
  }

  SweepPoint
  at(const double x, const double y)
  {
    SweepPoint point(2);
    point << x, y;
    return point;
  }

  void
  friction()
  {
    const Setup setup({"Sweep/Axis e_pad/From = 1e10",
                       "Sweep/Axis e_pad/To = 4e10",
                       "Sweep/Axis mu/Scale = linear",
                       "Sweep/Axis mu/From = -0.5",
                       "Sweep/Axis mu/To = 1.5",
                       "Sweep/Axis mu/Number = 9"});
    const auto  model = build(setup);
    const auto  none  = judge(setup, model, at(10.3, 0.));
    for (unsigned int i = 0; i < none.size(); ++i)
      check(none.sigma(i) < 0., "without friction nothing grows");
    judge(setup, model, at(10.3, 1.5));
    judge(setup, model, at(10.55, 1.2));
    const auto forth = judge(setup, model, at(10.4, 0.3)),
               back  = judge(setup, model, at(10.4, -0.3));
    check(forth.size() == back.size(), "as many pairs turning backwards");
    for (unsigned int i = 0; i < forth.size(); ++i)
      {
        Worst nearest;
        for (unsigned int j = 0; j < back.size(); ++j)
          nearest.add(std::abs(forth.lambda[i] - back.lambda[j]));
        check(nearest.smallest() < 2e-6 * std::abs(forth.lambda[i]),
              "the mirrored brake turns backwards with the same pairs");
      }
  }

  void
  stiffness()
  {
    // Below 1e8 Pa the pad alone has hundreds of modes in the band.
    const Setup setup({"Sweep/Axis e_pad/From = 1e8",
                       "Sweep/Axis e_pad/To = 1e13",
                       "Sweep/Axis mu/Values = 0.3, 0.5"});
    const auto  model = build(setup);
    for (const double x : {8., 8.6, 9.7, 11.1, 12.4, 13.})
      judge(setup, model, at(x, 0.4));
  }

  void
  soft_pad()
  {
    // At 1e6 Pa the pad alone has its first modes here. The band ends well
    // below the disc's next modes: a sweep enlarges the small basis where one
    // of them comes in with a large estimate, here it is taken as it is.
    Setup setup({"Sweep/Axis e_pad/From = 1e6",
                 "Sweep/Axis e_pad/To = 1e13",
                 "Sweep/Axis mu/Values = 0.3, 0.5"});
    setup.options.band = {800., 1850.};
    setup.n_direct     = 90;
    const auto model   = build(setup);
    for (const double x : {6., 7.3, 10.4, 13.})
      judge(setup, model, at(x, 0.4));
  }

  void
  contact()
  {
    const Setup setup({"Scene/Body pad/Cells = 2, 2, 2",
                       "Scene/Body support/Cells = 2, 2, 6",
                       "Sweep/Axis e_pad/Entries = Scene/Contact "
                       "pad_disc/Normal stiffness",
                       "Sweep/Axis e_pad/From = 1e4",
                       "Sweep/Axis e_pad/To = 1e14",
                       "Sweep/Axis mu/Values = 0.3, 0.5"});
    const auto  model = build(setup);
    for (const double x : {4., 6.2, 8.4, 10.1, 12.3, 14.})
      judge(setup, model, at(x, 0.4));
  }

  /** The whole face, two thirds of it with a soft pad, one third with much
   * friction too. */
  void
  contact_states()
  {
    const auto states = [](SweepGrid &grid) {
      ContactStates result(3);
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int i = 0; i < 121; ++i)
          {
            const bool open = i % 11 >= (k == 0 ? 11u : k == 1 ? 7u : 4u);
            result[k].status.push_back(open ? ContactStatus::open
                                            : ContactStatus::slip);
            result[k].force_share.push_back(1. / 121.);
          }
      std::vector<unsigned int> numbers;
      for (std::size_t i = 0; i < grid.n_points(); ++i)
        {
          const SweepPoint point = grid.point(i);
          numbers.push_back(point[0] > 10.35 ? 0 : point[1] < 0.4 ? 1 : 2);
        }
      grid.set_states(numbers);
      return result;
    };
    const Setup setup({"Sweep/Axis e_pad/From = 1e10",
                       "Sweep/Axis e_pad/To = 4e10",
                       "Sweep/Axis e_pad/Number = 7",
                       "Sweep/Axis mu/Values = 0.1, 0.3, 0.5"},
                      {},
                      states);
    const auto  model = build(setup);
    for (const SweepPoint &point : setup.grid.state_representatives())
      judge(setup, model, point);
    const auto soft  = judge(setup, model, at(10.1, 0.45)),
               stiff = judge(setup, model, at(10.5, 0.5));
    check(setup.grid.state_number(at(10.1, 0.45)) == 2 &&
            setup.grid.state_number(at(10.5, 0.5)) == 0,
          "points between those of the grid have the state of the nearest");
    check(soft.size() > 0 && stiff.size() > 0, "both have pairs in the band");
    // The state matters: the same numbers with the whole face closed.
    SceneParameters scene          = setup.grid.scene(at(10.1, 0.45));
    scene.contacts[0].state_number = 0;
    const ComplexPairs whole       = setup.direct(scene);
    Worst              largest_distance;
    for (unsigned int i = 0; i < soft.size(); ++i)
      largest_distance.add((whole.lambda.array() - soft.lambda[i])
                             .abs()
                             .minCoeff<Eigen::PropagateNaN>());
    check(largest_distance.largest() > 100.,
          "a third of the face gives another spectrum: " +
            std::to_string(largest_distance.largest()) + " 1/s");
  }

  void
  hanging_nodes()
  {
    const auto under_the_pad = [](Discretization &d) {
      std::vector<double> marks(d.triangulation().n_active_cells(), 0.);
      unsigned int        n = 0;
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->material_id() == 0 && cell->center()[0] > 0.1 &&
            std::abs(cell->center()[1]) < 0.03)
          {
            marks[cell->active_cell_index()] = 1.;
            ++n;
          }
      const auto before = d.triangulation().n_active_cells();
      d.refine(marks, 1.);
      check(n > 0 && d.triangulation().n_active_cells() == before + 7 * n,
            "cells of the disc are divided: " + std::to_string(n));
    };
    const Setup setup(
      {"Sweep/Axis e_pad/From = 1e10", "Sweep/Axis e_pad/To = 4e10"},
      under_the_pad);
    const auto model = build(setup);
    for (const double x : {10.05, 10.3, 10.55})
      judge(setup, model, at(x, 0.6));
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        which = argc > 1 ? argv[1] : "";
  if (which == "friction")
    friction();
  else if (which == "stiffness")
    stiffness();
  else if (which == "soft_pad")
    soft_pad();
  else if (which == "contact")
    contact();
  else if (which == "hanging_nodes")
    hanging_nodes();
  else if (which == "contact_states")
    contact_states();
  else
    check(false,
          "an argument: friction, stiffness, soft_pad, contact, hanging_nodes "
          "or contact_states");
}
