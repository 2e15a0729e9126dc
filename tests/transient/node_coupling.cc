// SPDX-License-Identifier: LGPL-2.1-or-later

// Node to surface beside mortar: the same on matching faces, nearly the same
// steady sliding of the coarse brake, and the even pressure that it does not
// pass on.

#include "transient/pressed_brake.h"
#include "worst.h"

#include <squeal/contact/mortar.h>

#include <squeal/base/exceptions.h>

#include <deal.II/base/mpi.h>

#include <cstdio>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  struct Pair
  {
    MortarCoupling mortar, node;
  };

  SceneParameters
  two_blocks(const std::array<unsigned int, 3> &source,
             const std::array<unsigned int, 3> &target,
             const double                       target_width = .03)
  {
    SceneParameters s;
    s.bodies = {
      make_block(
        "target", {{0., 0., -.01}}, {{target_width, .02, .01}}, target),
      make_block("source", {{0., 0., 0.}}, {{.03, .02, .01}}, source)};
    return s;
  }

  Pair
  couplings(const Discretization &d)
  {
    const PointEvaluator evaluator(d);
    const unsigned int   face =
      face_id(d.coarse_mesh(), d.scene(), "source", "z_min");
    return {make_mortar_coupling(d, evaluator, face, 0, "test"),
            make_node_coupling(d, evaluator, face, 0, "test")};
  }

  /** Largest difference of what both give for a field of the target. */
  template <typename Field>
  double
  difference(const Discretization &d, const Pair &pair, const Field &field)
  {
    const Eigen::VectorXd u = interpolate(
      d,
      [&](const dealii::Point<3> &x) {
        return dealii::Tensor<1, 3>({field(x), 2. * field(x), -field(x)});
      },
      0);
    const auto value = [&](const Functionals::Row &row) {
      double sum = 0.;
      for (const auto &[r, weight] : row)
        sum += weight * u[r];
      return sum;
    };
    Worst worst;
    for (std::size_t j = 0; j < pair.node.nodes.size(); ++j)
      for (unsigned int c = 0; c < 3; ++c)
        worst.add(std::abs(value(pair.node.target_rows[j][c]) -
                           value(pair.mortar.target_rows[j][c])));
    return worst.largest();
  }

  void
  check_transfer()
  {
    const auto linear = [](const dealii::Point<3> &x) {
      return 1. + 30. * x[0] - 50. * x[1];
    };
    const auto wave = [](const dealii::Point<3> &x) {
      return std::sin(300. * x[0]) * std::cos(200. * x[1]);
    };
    for (const unsigned int degree : {1, 2, 3})
      {
        const std::string p        = ", p = " + std::to_string(degree);
        const auto        matching = two_blocks({{3, 2, 1}}, {{3, 2, 1}}),
                   other           = two_blocks({{3, 2, 1}}, {{4, 3, 1}});
        const Discretization a(matching, {}, degree, MPI_COMM_SELF),
          b(other, {}, degree, MPI_COMM_SELF);
        const Pair on_matching = couplings(a), on_other = couplings(b);
        Worst      areas;
        for (std::size_t j = 0; j < on_matching.node.weights.size(); ++j)
          areas.add(std::abs(
            on_matching.node.weights[j] / on_matching.mortar.weights[j] - 1.));
        check_below(areas.largest(), 1e-12, "the same tributary areas" + p);
        check_below(difference(a, on_matching, linear),
                    1e-12,
                    "matching faces, linear fields" + p);
        check_below(difference(a, on_matching, wave),
                    1e-12,
                    "matching faces, a wave" + p);
        check_below(difference(b, on_other, linear),
                    1e-12,
                    "other faces, linear fields" + p);
        check(difference(b, on_other, wave) > 1e-3,
              "other faces, a wave: not the same" + p);
      }
  }

  /** The nodal forces of an even pressure, largest error over largest force. */
  double
  pressure_error(const Discretization &d, const MortarCoupling &m)
  {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(d.space()->n_global());
    for (std::size_t j = 0; j < m.nodes.size(); ++j)
      for (const auto &[row, weight] : m.target_rows[j][2])
        force[row] += m.weights[j] * weight;
    LoadParameters load;
    load.body            = "target";
    load.face            = "z_max";
    load.force           = {{0., 0., .03 * .02}};
    const Block expected = load_vector(d, PointEvaluator(d), load);
    return (force - expected.col(0))
             .cwiseAbs()
             .maxCoeff<Eigen::PropagateNaN>() /
           expected.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  }

  void
  check_even_pressure()
  {
    for (const unsigned int degree : {1, 2})
      {
        const auto           s = two_blocks({{3, 2, 1}}, {{4, 3, 1}});
        const Discretization d(s, {}, degree, MPI_COMM_SELF);
        const Pair           pair = couplings(d);
        const std::string    p    = ", p = " + std::to_string(degree);
        check_below(pressure_error(d, pair.mortar),
                    1e-13,
                    "mortar passes an even pressure on" + p);
        const double error = pressure_error(d, pair.node);
        check(error > .05,
              "node to surface does not" + p + ": off by " + number(error));
      }
  }

  void
  check_refusal()
  {
    const auto           s = two_blocks({{2, 2, 1}}, {{2, 2, 1}}, .025);
    const Discretization d(s, {}, 1, MPI_COMM_SELF);
    check_throws<InputError>(
      [&] {
        make_node_coupling(d,
                           PointEvaluator(d),
                           face_id(d.coarse_mesh(), s, "source", "z_min"),
                           0,
                           "Scene/Contact c");
      },
      "Scene/Contact c: the faces do not meet",
      "a node beside the target is refused");
  }

  /** Leading edge (y < 0) over the mean pressure. */
  double
  leading_edge_factor(const Reduced &r, const SteadySliding &s)
  {
    const auto &g    = r.separated.contacts[0];
    double      area = 0., total = 0., force = 0., edge = 0.;
    for (std::size_t j = 0; j < g.points.size(); ++j)
      {
        total += g.areas[j];
        force += s.forces[3 * j];
        if (g.points[j][1] < -.005 + 1e-9)
          {
            area += g.areas[j];
            edge += s.forces[3 * j];
          }
      }
    return edge / area / (force / total);
  }

  void
  check_steady_sliding()
  {
    const double    mu    = .5;
    SceneParameters scene = pressed_brake(mu);
    const Reduced   mortar(scene, 15e3);
    scene.contacts[0].formulation =
      ContactParameters::Formulation::node_to_surface;
    const Reduced       node(scene, 15e3);
    const SteadySliding a = steady_sliding(mortar.model, mu),
                        b = steady_sliding(node.model, mu);
    const double factor_a = leading_edge_factor(mortar, a),
                 factor_b = leading_edge_factor(node, b);
    std::printf("closed nodes %u, %u of %zu; leading edge %.4f, %.4f\n",
                a.n_closed(),
                b.n_closed(),
                a.status.size(),
                factor_a,
                factor_b);
    check(a.n_closed() < a.status.size(), "some nodes are open");
    check(a.n_closed() == b.n_closed(), "as many closed nodes as with mortar");
    check_below(std::abs(factor_b / factor_a - 1.),
                1e-2,
                "nearly the same pressure at the leading edge");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  check_transfer();
  check_even_pressure();
  check_refusal();
  check_steady_sliding();
  return 0;
}
