// SPDX-License-Identifier: LGPL-2.1-or-later

// Dual mortar operators: weights add up to the face, constants and linear
// fields cross matching, non-matching and hanging-node meshes exactly.

#include "scenes.h"
#include "worst.h"

#include <squeal/contact/mortar.h>

#include <squeal/base/exceptions.h>

#include <deal.II/base/mpi.h>

#include <numeric>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  SceneParameters
  two_blocks(const std::array<unsigned int, 3> &source,
             const std::array<unsigned int, 3> &target,
             const double                       target_width)
  {
    SceneParameters s;
    s.bodies = {
      make_block("source", {{.001, -.002, 0.}}, {{.02, .01, .005}}, source),
      make_block(
        "target", {{.001, -.002, -.005}}, {{target_width, .01, .005}}, target)};
    return s;
  }

  void
  check_transfer(const Discretization &d,
                 const double          area,
                 const std::string    &name)
  {
    const MortarCoupling m = make_mortar_coupling(
      d,
      PointEvaluator(d),
      face_id(d.coarse_mesh(), d.scene(), "source", "z_min"),
      1,
      "test");
    check_close(std::accumulate(m.weights.begin(), m.weights.end(), 0.),
                area,
                1e-13,
                name + ": weights sum to the face area");
    check(*std::min_element(m.weights.begin(), m.weights.end()) > 0.,
          name + ": every node has a positive weight");
    for (unsigned int k = 0; k < 4; ++k)
      {
        // u_c = 1, x, y, x - 2 y, times a scale of its own for each c.
        const auto value = [k](const dealii::Point<3> &x) {
          return std::array<double, 4>{
            {1., 100. * x[0], 100. * x[1], 100. * (x[0] - 2. * x[1])}}[k];
        };
        const Eigen::VectorXd u = interpolate(
          d,
          [&](const dealii::Point<3> &x) {
            dealii::Tensor<1, 3> t;
            for (unsigned int c = 0; c < 3; ++c)
              t[c] = (c + 1.) * value(x);
            return t;
          },
          1);
        Worst worst;
        for (unsigned int j = 0; j < m.nodes.size(); ++j)
          for (unsigned int c = 0; c < 3; ++c)
            {
              double sum = 0.;
              for (const auto &[row, weight] : m.target_rows[j][c])
                sum += weight * u[row];
              worst.add(std::abs(sum - (c + 1.) * value(m.nodes[j])));
            }
        check_below(worst.largest(),
                    2e-12,
                    name + ": " + (k == 0 ? "constants" : "linear fields") +
                      " are reproduced");
      }
  }

  void
  check_matching_is_pointwise(const unsigned int degree)
  {
    const SceneParameters s = two_blocks({{3, 2, 1}}, {{3, 2, 1}}, .02);
    const Discretization  d(s, {}, degree, MPI_COMM_SELF);
    const MortarCoupling  m =
      make_mortar_coupling(d,
                           PointEvaluator(d),
                           face_id(d.coarse_mesh(), s, "source", "z_min"),
                           1,
                           "test");
    Worst worst;
    for (const auto &rows : m.target_rows)
      for (const auto &row : rows)
        {
          std::vector<double> weights;
          for (const auto &[r, w] : row)
            weights.push_back(w);
          std::sort(weights.begin(), weights.end());
          worst.add(std::abs(weights.back() - 1.));
          weights.pop_back();
          for (const double w : weights)
            worst.add(std::abs(w));
        }
    check_below(worst.largest(),
                1e-11,
                "on matching meshes a node follows its partner, p = " +
                  std::to_string(degree));
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  for (const unsigned int degree : {1, 2, 3})
    {
      check_matching_is_pointwise(degree);
      const std::string p = ", p = " + std::to_string(degree);
      {
        const auto s = two_blocks({{3, 2, 1}}, {{3, 2, 1}}, .02);
        check_transfer(
          Discretization(s, {}, degree, MPI_COMM_SELF), 2e-4, "matching" + p);
      }
      {
        const auto s = two_blocks({{3, 3, 1}}, {{2, 5, 1}}, .025);
        check_transfer(Discretization(s, {}, degree, MPI_COMM_SELF),
                       2e-4,
                       "non-matching" + p);
      }
      {
        const auto          s = two_blocks({{2, 2, 1}}, {{2, 2, 2}}, .03);
        Discretization      d(s, {}, degree, MPI_COMM_SELF);
        std::vector<double> marks(d.triangulation().n_active_cells(), 0.);
        unsigned int        marked = 0;
        for (const auto &cell : d.dof_handler().active_cell_iterators())
          if (cell->material_id() == 1 && marked == 0 &&
              cell->center()[2] > -.0025)
            marks[cell->active_cell_index()] = ++marked;
        d.refine(marks, .9);
        check_transfer(d, 2e-4, "hanging nodes on the target" + p);
      }
    }

  const auto           s = two_blocks({{2, 2, 1}}, {{2, 2, 1}}, .015);
  const Discretization d(s, {}, 1, MPI_COMM_SELF);
  check_throws<InputError>(
    [&] {
      make_mortar_coupling(d,
                           PointEvaluator(d),
                           face_id(d.coarse_mesh(), s, "source", "z_min"),
                           1,
                           "Scene/Tie t");
    },
    "Scene/Tie t",
    "a source face that leaves the target is refused");
  return 0;
}
