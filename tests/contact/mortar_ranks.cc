// SPDX-License-Identifier: LGPL-2.1-or-later

// The mortar operators of two ranks are those of one, and those of imported
// cells of second order are those of squeal's own rings.

#include "../scene/gmsh_annulus.h"
#include "contact/turned_block.h"
#include "worst.h"

#include <squeal/contact/mortar.h>

#include <deal.II/base/mpi.h>

#include <map>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Values of all free unknowns, on every rank. */
  template <typename Field>
  Eigen::VectorXd
  everywhere(const Discretization &d, const Field &field)
  {
    const auto     &fe = d.dof_handler().get_fe();
    Eigen::VectorXd result =
      Eigen::VectorXd::Constant(d.space()->n_global(), -1e300);
    std::vector<dealii::types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            if (const Combination &c = d.expansion(dofs[i]);
                c.size() == 1 && c[0].second == 1.)
              result[c[0].first] =
                field(d.mapping().transform_unit_to_real_cell(
                        cell, fe.unit_support_point(i)),
                      fe.system_to_component_index(i).first);
        }
    MPI_Allreduce(MPI_IN_PLACE,
                  result.data(),
                  static_cast<int>(result.size()),
                  MPI_DOUBLE,
                  MPI_MAX,
                  d.space()->communicator());
    return result;
  }

  struct AtNode
  {
    double                weight;
    std::array<double, 3> target;
  };

  /** Weights and transferred values of a field by the place of each node. */
  std::map<std::array<long, 3>, AtNode>
  transfer(const SceneParameters &scene,
           const std::string     &face,
           const bool             refines,
           const unsigned int     degree,
           const MPI_Comm         communicator)
  {
    Discretization      d(scene, {}, degree, communicator);
    std::vector<double> marks(d.triangulation().n_active_cells(), 1e-6);
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == 0 &&
          cell->center()[1] > 0. && cell->center()[0] > .06)
        marks[cell->active_cell_index()] = 1.;
    if (refines)
      d.refine(marks, .99);
    unsigned int owned = 0;
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      owned += cell->is_locally_owned() && cell->material_id() == 0;
    check(owned > 0, "every rank has a part of the disc");
    const PointEvaluator evaluator(d);
    const MortarCoupling m =
      scene.ties.empty()
        ? make_mortar_coupling(d,
                               evaluator,
                               face_id(d.coarse_mesh(), scene, "ring", face),
                               0,
                               "test")
        : make_tie_coupling(d, evaluator, 0);
    const Eigen::VectorXd u =
      everywhere(d, [](const dealii::Point<3> &x, const unsigned int c) {
        return std::sin(300. * x[0] + c) * std::cos(200. * x[1] - c);
      });
    std::map<std::array<long, 3>, AtNode> result;
    for (std::size_t j = 0; j < m.nodes.size(); ++j)
      {
        AtNode node{m.weights[j], {{0., 0., 0.}}};
        for (unsigned int c = 0; c < 3; ++c)
          for (const auto &[row, weight] : m.target_rows[j][c])
            node.target[c] += weight * u[row];
        result[{{std::lround(1e7 * m.nodes[j][0]),
                 std::lround(1e7 * m.nodes[j][1]),
                 std::lround(1e7 * m.nodes[j][2])}}] = node;
      }
    return result;
  }

  using Transfer = std::map<std::array<long, 3>, AtNode>;

  /** Weights over the mean one, and values. */
  void
  check_same(const Transfer    &one,
             const Transfer    &two,
             const std::size_t  n_nodes,
             const std::string &what)
  {
    check(one.size() == two.size() && one.size() == n_nodes,
          what + ": as many nodes");
    double area = 0.;
    for (const auto &[place, a] : one)
      area += a.weight / n_nodes;
    Worst weights, values;
    for (const auto &[place, a] : one)
      {
        const auto &b = two.at(place);
        weights.add(std::abs(a.weight - b.weight));
        for (unsigned int c = 0; c < 3; ++c)
          values.add(std::abs(a.target[c] - b.target[c]));
      }
    check_below(weights.largest() / area, 1e-12, what + ": weights");
    check_below(values.largest(), 1e-12, what + ": values");
  }

  /** A hub in a rim. */
  SceneParameters
  hub_and_rim()
  {
    SceneParameters scene;
    scene.bodies = {make_annulus({{16, 1, 1}}), make_annulus({{11, 1, 1}})};
    for (auto &body : scene.bodies)
      {
        body.position     = {{0., 0., 0.}};
        body.height       = .02;
        body.inner_radius = .08;
        body.outer_radius = .12;
      }
    scene.bodies[1].name         = "ring";
    scene.bodies[1].inner_radius = .05;
    scene.bodies[1].outer_radius = .08;
    return scene;
  }

  SceneParameters
  imported(SceneParameters scene, const unsigned int n_nodes = 27)
  {
    for (auto &body : scene.bodies)
      {
        const std::string file =
          "ranks_" + body.name + std::to_string(n_nodes) + ".msh";
        if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
          AnnulusFile(body, n_nodes).write_2(file);
        body.shape     = BodyParameters::Shape::gmsh;
        body.mesh_file = file;
      }
    MPI_Barrier(MPI_COMM_WORLD);
    return scene;
  }

  void
  imported_rings()
  {
    const SceneParameters own = hub_and_rim(), files = imported(own);
    for (const unsigned int degree : {2, 3})
      {
        const std::string p = ", p = " + std::to_string(degree);
        for (const bool refines : {false, true})
          check_same(transfer(files, "outer", refines, degree, MPI_COMM_SELF),
                     transfer(files, "outer", refines, degree, MPI_COMM_WORLD),
                     11 * degree * (degree + 1),
                     std::string("imported rings, one and two ranks") +
                       (refines ? ", hanging nodes" : "") + p);
      }
    // a hub of facets tied to a rim of arcs
    SceneParameters tied    = own;
    tied.bodies[1].cells[0] = 22;
    tied.bodies[1]          = imported(tied, 8).bodies[1];
    tied.ties               = {
                    make_tie("ring", "outer", "disc", "inner", TieParameters::Kind::mortar)};
    check_same(transfer(tied, "", true, 2, MPI_COMM_SELF),
               transfer(tied, "", true, 2, MPI_COMM_WORLD),
               22 * 2 * 3,
               "tied facets, one and two ranks");
    check_same(transfer(own, "outer", false, 2, MPI_COMM_WORLD),
               transfer(files, "outer", false, 2, MPI_COMM_WORLD),
               11 * 2 * 3,
               "own and imported rings, p = 2");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  check(dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 2,
        "two ranks");
  SceneParameters scene;
  scene.bodies = {make_annulus({{16, 2, 1}}), make_annulus({{11, 2, 1}})};
  scene.bodies[1].name         = "ring";
  scene.bodies[1].position     = {{0., 0., 0.}};
  scene.bodies[1].inner_radius = .06;
  scene.bodies[1].outer_radius = .11;
  for (const unsigned int degree : {1, 2})
    {
      const std::string p = ", p = " + std::to_string(degree);
      check_same(transfer(scene, "bottom", true, degree, MPI_COMM_SELF),
                 transfer(scene, "bottom", true, degree, MPI_COMM_WORLD),
                 11 * degree * (2 * degree + 1),
                 "one and two ranks" + p);
    }
  imported_rings();
  return 0;
}
