// SPDX-License-Identifier: LGPL-2.1-or-later

// Names of the modes of a coarse TriboBrake over random small steps of the
// pad's stiffness, of friction, of the mesh and from the undamped modes to the
// complex pairs. Argument: the number of steps.
//
// A shape that stays (each the other's nearest, MAC above 0.95 of all bodies
// and of the disc by itself, of which a name says how both move) must not turn
// from one name into another. Where a shape crosses the limit between two names
// it is called by both for a while: to such a tie, and from it, a name may
// change to one of the two. Ties must stay few, or nothing would be said.

#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/model/cea_solution.h>
#include <squeal/output/cea_quantities.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <sstream>

#include "check.h"
#include "source_directory.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  struct Point
  {
    double      log10_e_pad, mu;
    std::string disc_cells;
  };

  /** Names and displacements at the points of the signature, the same points
   * for every mesh, as columns of length one. */
  struct Shapes
  {
    std::vector<std::string> names;
    Eigen::MatrixXcd         displacements, of_disc;
  };

  struct Solution
  {
    Shapes modes, pairs;
  };

  Shapes
  shapes_of(const Model                 &model,
            const Block                 &real,
            const Block                 &imaginary,
            const std::vector<ModeName> &names,
            const unsigned int           n)
  {
    Shapes          shapes;
    const auto      signature = model.namer().signature();
    const auto     &system    = model.linearized();
    Eigen::MatrixXd re        = signature->apply(system.expand(real));
    Eigen::MatrixXd im        = signature->apply(system.expand(imaginary));
    shapes.displacements.resize(re.rows(), n);
    shapes.displacements.real() = re.leftCols(n);
    shapes.displacements.imag() = im.leftCols(n);
    shapes.displacements.colwise().normalize();
    // Ten rings of 24 points, three directions: the disc is the first body.
    shapes.of_disc = shapes.displacements.topRows(10 * 24 * 3);
    shapes.of_disc.colwise().normalize();
    for (unsigned int i = 0; i < n; ++i)
      shapes.names.push_back(names[i].text);
    return shapes;
  }

  Solution
  solve(const Point &point)
  {
    const auto number = [](const double value) {
      std::ostringstream text;
      text.precision(17);
      text << value;
      return text.str();
    };
    const Parameters parameters = read_parameters(
      SQUEAL_SOURCE_DIR "/prm/tribobrake/calibrated.prm",
      {"Analysis = cea",
       "Eigenvalues/Lowest frequency = 1000",
       "Eigenvalues/Highest frequency = 8000",
       "Discretization/Degree = 2",
       "Discretization/Estimate error = false",
       "Scene/Body disc/Cells = " + point.disc_cells,
       "Scene/Body pad/Cells = 1, 1, 1",
       "Scene/Body support/Cells = 1, 1, 4",
       "Scene/Body pad/Young modulus = " +
         number(std::pow(10., point.log10_e_pad)),
       "Scene/Contact pad_disc/Friction coefficient = " + number(point.mu)});
    std::ostringstream console;
    RunLog             log(true, console);
    Timers             timers;
    const Model        model(parameters, timers);
    ModeSolution       modes = solve_modes(model, log, timers);
    const ComplexPairs pairs = solve_cea(model, modes, log, timers).pairs;
    const auto         names = pair_quantities(model, modes, pairs).names;
    const Block       &x     = modes.modes.shapes;
    return {shapes_of(model,
                      x,
                      Block(Block::Zero(x.rows(), x.cols())),
                      modes.names,
                      modes.n_up_to(parameters.eigen.highest_frequency)),
            shapes_of(model,
                      Block(pairs.right.real()),
                      Block(pairs.right.imag()),
                      names,
                      pairs.size())};
  }



  std::set<std::string>
  alternatives(const std::string &name)
  {
    std::set<std::string> result;
    std::istringstream    in(name);
    for (std::string one; std::getline(in, one, '|');)
      result.insert(one);
    return result;
  }

  struct Count
  {
    unsigned int n_steps = 0, n_names = 0, n_ties = 0;
    /** Shapes that stayed; of these: another name; to or from a tie. */
    unsigned int n_compared = 0, n_changed = 0, n_through_ties = 0;

    void
    add_names(const Shapes &shapes)
    {
      n_names += shapes.names.size();
      for (const auto &name : shapes.names)
        n_ties += alternatives(name).size() > 1;
    }

    void
    add_step(const Shapes &a, const Shapes &b)
    {
      ++n_steps;
      const Eigen::MatrixXd mac =
        (a.displacements.adjoint() * b.displacements).cwiseAbs2();
      const Eigen::MatrixXd mac_of_disc =
        (a.of_disc.adjoint() * b.of_disc).cwiseAbs2();
      for (Eigen::Index i = 0; i < mac.rows(); ++i)
        {
          Eigen::Index nearest, back;
          const double value = mac.row(i).maxCoeff(&nearest);
          mac.col(nearest).maxCoeff(&back);
          if (!(value > 0.95) || !(mac_of_disc(i, nearest) > 0.95) || back != i)
            continue;
          ++n_compared;
          const std::string &from = a.names[i], &to = b.names[nearest];
          if (from == to)
            continue;
          std::vector<std::string> common;
          const auto               x = alternatives(from), y = alternatives(to);
          std::set_intersection(
            x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(common));
          ++(common.empty() ? n_changed : n_through_ties);
          if (common.empty())
            std::cout << "changed: " << from << " to " << to << " at MAC "
                      << value << std::endl;
        }
    }
  };



  Count
  walk(const unsigned int n_steps)
  {
    const std::vector<std::string> meshes = {
      "20, 3, 1", "21, 3, 1", "22, 3, 1"};
    std::mt19937 random(20061129); // any seed
    const auto   uniform = [&](const double a, const double b) {
      return std::uniform_real_distribution<double>(a, b)(random);
    };
    Count count;
    while (count.n_steps < n_steps)
      {
        const unsigned int mesh = random() % meshes.size();
        const Point start{uniform(9., 11.), uniform(0.01, 0.7), meshes[mesh]};
        const Solution base = solve(start);
        count.add_names(base.modes);
        count.add_names(base.pairs);
        // From one analysis to the other.
        count.add_step(base.modes, base.pairs);
        Point softer = start;
        softer.log10_e_pad += uniform(-0.005, 0.005);
        count.add_step(base.pairs, solve(softer).pairs);
        Point rougher = start;
        rougher.mu += uniform(-0.005, 0.005);
        count.add_step(base.pairs, solve(rougher).pairs);
        Point finer      = start;
        finer.disc_cells = meshes[(mesh + 1) % meshes.size()];
        count.add_step(base.pairs, solve(finer).pairs);
      }
    return count;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check(argc == 2, "one argument");
  const Count count = walk(std::stoul(argv[1]));
  std::cout << count.n_steps << " steps, " << count.n_compared
            << " shapes that stay, " << count.n_changed
            << " with another name, " << count.n_through_ties
            << " from or to a tie; " << count.n_ties << " ties among "
            << count.n_names << " names" << std::endl;
  check(count.n_compared > 10 * count.n_steps,
        "more than ten shapes stay in a step");
  check(count.n_changed == 0, "no shape turns from one name into another");
  check(count.n_ties <= 0.05 * count.n_names, "at most 5 % of names are ties");
  check(count.n_through_ties <= 0.02 * count.n_compared,
        "names pass through ties seldom");
}
