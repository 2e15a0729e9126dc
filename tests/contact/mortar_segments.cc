// SPDX-License-Identifier: LGPL-2.1-or-later

// Segments of mortar pairs: they cover the source face, the dual functions are
// biorthogonal, curved faces and edges, and what sampling at Gauss points
// costs.

#include "contact/turned_block.h"
#include "worst.h"

#include <squeal/contact/face_overlap.h>
#include <squeal/contact/mortar.h>
#include <squeal/discretization/face_quadrature.h>

#include <deal.II/base/mpi.h>

#include <cstdio>
#include <numeric>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** Parallelograms that share a plane: n x n on a square of this width about
   * (.5, .5), turned about z; normals up or down; tilted about x. */
  std::vector<SurfaceFace>
  square_faces(const FaceBasis   &basis,
               const unsigned int n,
               const double       width,
               const double       angle,
               const bool         up,
               const double       tilt = 0.)
  {
    std::vector<SurfaceFace> faces;
    const unsigned int       p = basis.degree();
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          std::vector<dealii::Point<3>> nodes;
          for (unsigned int b = 0; b <= p; ++b)
            for (unsigned int a = 0; a <= p; ++a)
              {
                const double s =
                               width * ((i + double(up ? a : b) / p) / n - .5),
                             t =
                               width * ((j + double(up ? b : a) / p) / n - .5);
                const double y = std::sin(angle) * s + std::cos(angle) * t;
                nodes.emplace_back(.5 + std::cos(angle) * s -
                                     std::sin(angle) * t,
                                   .5 + y,
                                   tilt * y);
              }
          faces.emplace_back(basis, nodes);
        }
    return faces;
  }

  /** Largest |sum of weights - 1| of a source face. */
  double
  uncovered(const std::vector<SurfaceFace> &sources,
            const std::vector<SurfaceFace> &targets,
            const unsigned int              degree)
  {
    Worst worst;
    for (const auto &source : sources)
      {
        double sum = 0.;
        for (const auto &target : targets)
          for (const auto &point : face_overlap(source, target, degree))
            sum += point.weight;
        worst.add(std::abs(sum - 1.));
      }
    return worst.largest();
  }

  void
  check_areas()
  {
    for (const unsigned int degree : {1, 2})
      {
        const FaceBasis   basis(degree);
        const std::string p = ", p = " + std::to_string(degree);
        for (const double angle : {0., 1e-9, .12, M_PI / 4.})
          check_below(uncovered(square_faces(basis, 3, 1., angle, false),
                                square_faces(basis, 4, 1.5, 0., true),
                                degree),
                      1e-13,
                      "3 x 3 on 4 x 4 faces, turned by " + number(angle) + p +
                        ": segments cover every face");
        check_below(uncovered(square_faces(basis, 3, 1., .12, false),
                              square_faces(basis, 4, 1.5, 0., true, 4e-5),
                              degree),
                    1e-13,
                    "on a plane that is tilted by 4e-5" + p);
        check_below(
          std::abs(uncovered(square_faces(basis, 3, 1., .12, false),
                             square_faces(basis, 4, 1.5, 0., true, .05),
                             degree) -
                   1.),
          0.,
          "on one tilted by .05 there are faces that do not meet at all" + p);
        check_below(std::abs(uncovered(square_faces(basis, 3, 1., 0., false),
                                       square_faces(basis, 4, 1.5, 0., false),
                                       degree) -
                             1.),
                    0.,
                    "faces that look the same way do not meet" + p);
      }
  }

  MortarCoupling
  coupling(const Discretization &d,
           const std::string    &source,
           const std::string    &face,
           const std::string    &target)
  {
    return make_mortar_coupling(
      d,
      PointEvaluator(d),
      face_id(d.coarse_mesh(), d.scene(), source, face),
      body_index(d.scene(), target),
      "test");
  }

  /** On matching faces D^-1 M is int psi_j phi_k / D_j. */
  double
  biorthogonality(const MortarCoupling &m)
  {
    Worst worst;
    for (const auto &rows : m.target_rows)
      for (const auto &row : rows)
        {
          Worst  others;
          double partner = 0.;
          others.add(0.);
          for (const auto &[r, w] : row)
            if (std::abs(w) > std::abs(partner))
              {
                others.add(std::abs(partner));
                partner = w;
              }
            else
              others.add(std::abs(w));
          worst.add(std::abs(partner - 1.));
          worst.add(others.largest());
        }
    return worst.largest();
  }

  void
  check_biorthogonality()
  {
    for (const unsigned int degree : {1, 2, 3})
      {
        SceneParameters s;
        s.bodies = {
          make_block("under", {{0., 0., -.01}}, {{.03, .02, .01}}, {{3, 2, 1}}),
          make_block("over", {{0., 0., 0.}}, {{.03, .02, .01}}, {{3, 2, 1}}),
          make_annulus({{12, 2, 1}}),
          make_annulus({{12, 2, 1}})};
        s.bodies[3].name     = "ring";
        s.bodies[3].position = {{0., 0., 0.}};
        for (unsigned int b = 0; b < 2; ++b)
          {
            s.bodies.push_back(make_turned_block(s.bodies[b], .1));
            s.bodies.back().name += " turned";
          }
        const Discretization d(s, {}, degree, MPI_COMM_SELF);
        const std::string    p =
          " faces, p = " + std::to_string(degree) + ": int psi_j phi_k";
        check_below(biorthogonality(coupling(d, "over", "z_min", "under")),
                    1e-13,
                    "square" + p);
        check_below(
          biorthogonality(coupling(d, "over turned", "z_min", "under turned")),
          1e-13,
          "quadrilateral" + p);
        check_below(biorthogonality(coupling(d, "ring", "bottom", "disc")),
                    1e-13,
                    "curved" + p);
      }
  }

  /** Largest error of a transferred field, x then y then 1. */
  double
  transfer_error(const Discretization &d,
                 const MortarCoupling &m,
                 const unsigned int    body,
                 const bool            constant)
  {
    Worst worst;
    for (unsigned int k = 0; k < (constant ? 1u : 3u); ++k)
      {
        const auto value = [&](const dealii::Point<3> &x) {
          return constant ? 1. : 10. * x[k];
        };
        const Eigen::VectorXd u = interpolate(
          d,
          [&](const dealii::Point<3> &x) {
            return dealii::Tensor<1, 3>({value(x), value(x), value(x)});
          },
          body);
        for (std::size_t j = 0; j < m.nodes.size(); ++j)
          for (unsigned int c = 0; c < 3; ++c)
            {
              double sum = 0.;
              for (const auto &[row, weight] : m.target_rows[j][c])
                sum += weight * u[row];
              worst.add(std::abs(sum - value(m.nodes[j])));
            }
      }
    return worst.largest();
  }

  /** Nodal forces of an even pressure of 1 Pa on the source face. */
  Eigen::VectorXd
  even_pressure(const Discretization &d, const MortarCoupling &m)
  {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(d.space()->n_global());
    for (std::size_t j = 0; j < m.nodes.size(); ++j)
      for (const auto &[row, weight] : m.target_rows[j][2])
        force[row] += m.weights[j] * weight;
    return force;
  }

  /** The same sampled at n^2 Gauss points of every source face. */
  Eigen::VectorXd
  sampled_pressure(const Discretization &d,
                   const std::string    &source,
                   const unsigned int    n)
  {
    const FaceQuadrature points = face_quadrature(
      d, face_id(d.coarse_mesh(), d.scene(), source, "z_min"), n);
    const auto target = PointEvaluator(d).displacements(0, points.points, 1e-4);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(d.space()->n_global());
    for (std::size_t q = 0; q < points.points.size(); ++q)
      for (const auto &[row, weight] : target.rows[q][2])
        force[row] += points.areas[q] * weight;
    return force;
  }

  double
  relative(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
  {
    return (a - b).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() /
           b.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  }

  /** Pads of several meshes in one place on a disc. */
  void
  check_curved_target_edges()
  {
    for (const unsigned int degree : {2, 3})
      {
        SceneParameters s;
        s.bodies = {make_annulus({{24, 4, 1}})};
        for (const unsigned int n : {1, 3, 5})
          s.bodies.push_back(make_block("pad " + std::to_string(n),
                                        {{.0851, .003, 0.}},
                                        {{.03, .04, .01}},
                                        {{n, n == 5 ? 7 : n, 1}}));
        const std::string p = ", p = " + std::to_string(degree);
        for (const bool hanging : {false, true})
          {
            Discretization d(s, {}, degree, MPI_COMM_SELF);
            if (hanging)
              refine_one_cell(d, 0, .085, .01);
            const std::string nodes =
              hanging ? ", hanging nodes on the disc" : "";
            std::vector<Eigen::VectorXd> forces;
            for (const unsigned int b : {1, 2, 3})
              {
                const auto m = coupling(d, s.bodies[b].name, "z_min", "disc");
                check_close(
                  std::accumulate(m.weights.begin(), m.weights.end(), 0.),
                  .03 * .04,
                  1e-12,
                  s.bodies[b].name + p + nodes + ": weights sum to the area");
                check_below(transfer_error(d, m, 0, true),
                            1e-12,
                            s.bodies[b].name + p + nodes + ": constants");
                check_below(transfer_error(d, m, 0, false),
                            1e-12,
                            s.bodies[b].name + p + nodes + ": linear fields");
                forces.push_back(even_pressure(d, m));
              }
            for (const unsigned int b : {0, 1})
              check_below(relative(forces[b], forces[2]),
                          1e-10,
                          s.bodies[b + 1].name + p + nodes +
                            ": the nodal forces of an even pressure on the "
                            "disc do not depend on the pad's mesh");
            if (hanging || degree > 2)
              continue;
            double before = 0.;
            for (const unsigned int n : {4, 16, 64})
              {
                const double error =
                  relative(sampled_pressure(d, "pad 3", n), forces[1]);
                std::printf(
                  "%u^2 Gauss points a face%s: %.3g\n", n, p.c_str(), error);
                if (before > 0.)
                  check_below(error,
                              before / 8.,
                              "sampling at four times as many points a line "
                              "approaches the segments in order 1.5 to 2" +
                                p);
                before = error;
              }
          }
      }
  }

  void
  check_curved_sources()
  {
    // Edges of the source face that are arcs.
    for (const unsigned int degree : {1, 2, 3})
      {
        SceneParameters s;
        s.bodies = {make_annulus({{24, 4, 1}})};
        BodyParameters pin;
        pin.name         = "pin";
        pin.shape        = BodyParameters::Shape::cylinder;
        pin.position     = {{.086, .002, 0.}};
        pin.outer_radius = .012;
        pin.height       = .01;
        pin.cells        = {{8, 1, 1}};
        s.bodies.push_back(pin);
        const Discretization d(s, {}, degree, MPI_COMM_SELF);
        const auto           m = coupling(d, "pin", "bottom", "disc");
        const std::string    p = ", p = " + std::to_string(degree);
        const double         area =
          face_quadrature(d, face_id(d.coarse_mesh(), s, "pin", "bottom"), 8)
            .total_area();
        check_close(std::accumulate(m.weights.begin(), m.weights.end(), 0.),
                    area,
                    1e-12,
                    "round pin" + p + ": weights sum to the area");
        check_below(transfer_error(d, m, 0, true),
                    1e-12,
                    "round pin" + p + ": constants");
        check_below(transfer_error(d, m, 0, false),
                    1e-12,
                    "round pin" + p + ": linear fields");
      }
    // A shaft in a hub: cylinders of one radius, different meshes.
    for (const unsigned int degree : {2, 3})
      {
        SceneParameters s;
        s.bodies = {make_annulus({{12, 1, 1}}, .02)};
        BodyParameters shaft;
        shaft.name         = "shaft";
        shaft.shape        = BodyParameters::Shape::cylinder;
        shaft.position     = s.bodies[0].position;
        shaft.outer_radius = s.bodies[0].inner_radius;
        shaft.height       = .02;
        shaft.cells        = {{8, 1, 2}};
        s.bodies.push_back(shaft);
        double before = 0.;
        for (const unsigned int refinements : {0, 1, 2})
          {
            const Discretization d(
              s, Model::parameters(refinements), degree, MPI_COMM_SELF);
            const auto m = coupling(d, "shaft", "side", "disc");
            check_below(transfer_error(d, m, 0, true),
                        1e-12,
                        "shaft in a hub: constants");
            const double      error = transfer_error(d, m, 0, false);
            const std::string at =
              "shaft in a hub, p = " + std::to_string(degree) + ", " +
              std::to_string(refinements) + " refinements: linear fields, ";
            std::printf("%s%.3g\n", at.c_str(), error);
            if (refinements == 2)
              check_below(error,
                          before / std::pow(2., degree + .8),
                          at + "order p + 1 of the geometry");
            before = error;
          }
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  check_areas();
  check_biorthogonality();
  check_curved_target_edges();
  check_curved_sources();
  return 0;
}
