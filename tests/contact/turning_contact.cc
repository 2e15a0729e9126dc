// SPDX-License-Identifier: LGPL-2.1-or-later

// A mortar contact whose target turns, at arbitrary angles: it passes on what
// the one that stands still passes on, turns by whole cells change nothing, and
// the search from the angle before finds what a search of all faces does.

#include "scenes.h"
#include "worst.h"

#include <squeal/base/exceptions.h>
#include <squeal/contact/turning_contact.h>

#include <deal.II/base/mpi.h>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr unsigned int n_cells = 16; // round the disc

  SceneParameters
  brake()
  {
    SceneParameters s    = coarse_brake(.5);
    s.bodies[0].cells    = {{n_cells, 3, 1}};
    auto &c              = s.contacts[0];
    c.formulation        = ContactParameters::Formulation::mortar;
    c.friction_direction = ContactParameters::FrictionDirection::slip;
    return s;
  }

  struct Pair
  {
    explicit Pair(const unsigned int degree)
      : scene(brake())
      , d(scene, Model::parameters(0), degree, MPI_COMM_SELF)
      , separated(separated_system(d, assemble_bodies(d)))
    {
    }

    std::unique_ptr<TurningContact>
    turning(const unsigned int knots_per_cell = 0) const
    {
      return std::make_unique<TurningContact>(d,
                                              scene.contacts[0],
                                              separated.contacts[0],
                                              separated.reduce,
                                              knots_per_cell);
    }

    /** The motion of all bodies by a field u(x) of the fixed axes, the disc
     * turned by @p angle. */
    template <typename Field>
    Eigen::VectorXd
    motion(const Field &field, const double angle) const
    {
      const double c = std::cos(angle), s = std::sin(angle);
      return interpolate(
               d,
               [&](const dealii::Point<3> &x) {
                 const dealii::Tensor<1, 3> u = field(dealii::Point<3>(
                   c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]));
                 return dealii::Tensor<1, 3>(
                   {c * u[0] + s * u[1], -s * u[0] + c * u[1], u[2]});
               },
               0) +
             interpolate(d, field, 1) + interpolate(d, field, 2);
    }

    SceneParameters  scene;
    Discretization   d;
    LinearizedSystem separated;
  };

  using Rows = std::vector<Functionals::Row>;

  double
  largest_difference(const Functionals &a, const Functionals &b)
  {
    const unsigned int n     = a.space().n_global();
    const auto         dense = [n](const Functionals &f) {
      Eigen::MatrixXd result = Eigen::MatrixXd::Zero(f.n_rows(), n);
      for (unsigned int r = 0; r < f.n_rows(); ++r)
        for (const auto &[column, weight] : f.rows()[r])
          result(r, column) += weight;
      return result;
    };
    return (dense(a) - dense(b)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  }

  void
  passes_on(const unsigned int degree)
  {
    const std::string name = "degree " + std::to_string(degree) + ", ";
    const Pair        pair(degree);
    const auto        turning = pair.turning();
    const auto        still   = pair.turning()->relative_motion(0.);
    check_below(
      largest_difference(
        *still,
        *std::make_shared<Functionals>(
          still->space_pointer(),
          [&]() {
            Rows        rows;
            const auto &g = pair.separated.contacts[0];
            for (std::size_t j = 0; j < g.points.size(); ++j)
              for (const auto &part : {g.normal, g.tangential, g.transverse})
                rows.push_back(part->rows()[j]);
            return rows;
          }())),
      1e-12,
      name + "angle 0: the contact that stands still");
    for (const double angle : {.05, .1, .37, 1.234, 2.9, -1.3, 40.})
      {
        const std::string at = name + "turned by " + number(angle) + ": ";
        Worst             worst_sum;
        TurningMortar     mortar(
          pair.d,
          face_id(pair.d.coarse_mesh(), pair.scene, "pad", "z_min"),
          0,
          "test");
        for (const auto &row : mortar.rows(angle))
          {
            double sum = -1.;
            for (const auto &[b, weight] : row)
              sum += weight;
            worst_sum.add(std::abs(sum));
          }
        check_below(
          worst_sum.largest(), 1e-12, at + "rows of D^-1 M add up to one");
        const auto B = turning->relative_motion(angle);
        // What all rigid motions do to no node, no contact forces do to the
        // sum of forces and moments.
        Worst worst;
        for (unsigned int k = 0; k < 6; ++k)
          {
            const Eigen::VectorXd u = pair.motion(
              [k](const dealii::Point<3> &x) {
                dealii::Tensor<1, 3> e, axis;
                if (k < 3)
                  {
                    e[k] = 1.;
                    return e;
                  }
                axis[k - 3] = 10.;
                return dealii::cross_product_3d(axis, x);
              },
              angle);
            worst.add(
              B->apply(Block(u)).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
          }
        check_below(worst.largest(),
                    1e-12,
                    at + "forces and moments of the two sides cancel");
        // An even pressure gives the disc int phi: the mean of a motion that
        // the disc's elements hold and the pad's do not.
        const auto wave = [&](const dealii::Point<3> &x) {
          return dealii::Tensor<1, 3>({0., 0., 3. - 20. * x[0] + 7. * x[1]});
        };
        const auto     &g = pair.separated.contacts[0];
        Eigen::VectorXd p = Eigen::VectorXd::Zero(3 * g.areas.size());
        for (std::size_t j = 0; j < g.areas.size(); ++j)
          p[3 * j] = g.areas[j];
        const Eigen::VectorXd on_disc = interpolate(
          pair.d,
          [&](const dealii::Point<3> &x) {
            const double c = std::cos(angle), s = std::sin(angle);
            return wave({c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]});
          },
          0);
        check_close(p.dot(Eigen::VectorXd(B->apply(Block(on_disc)))),
                    1e-4 * (3. - 20. * .1075),
                    1e-12,
                    at + "work of an even pressure");
      }
  }



  void
  whole_cells()
  {
    const Pair   pair(2);
    const auto   turning = pair.turning();
    const double pitch   = 2. * M_PI / n_cells;
    const auto   f       = [](const dealii::Point<3> &x) {
      return dealii::Tensor<1, 3>({std::sin(90. * x[0]),
                                   std::cos(50. * x[1] + 30. * x[0]),
                                   std::sin(70. * x[1])});
    };
    for (const double start : {0., .3 * pitch})
      {
        const Eigen::VectorXd u0 =
          turning->relative_motion(start)->apply(Block(pair.motion(f, start)));
        Worst worst;
        for (const unsigned int k : {1, 5, 16})
          {
            const double a = start + k * pitch;
            worst.add((Eigen::VectorXd(turning->relative_motion(a)->apply(
                         Block(pair.motion(f, a)))) -
                       u0)
                        .cwiseAbs()
                        .maxCoeff<Eigen::PropagateNaN>());
          }
        check_below(
          worst.largest(), 1e-11, "a turn by whole cells changes nothing");
      }
  }



  void
  search()
  {
    const Pair pair(2);
    const auto id = face_id(pair.d.coarse_mesh(), pair.scene, "pad", "z_min");
    TurningMortar along(pair.d, id, 0, "test");
    const double  step  = .01;
    unsigned int  first = 0;
    for (unsigned int i = 0; i <= 60; ++i)
      {
        const Rows rows = along.rows(i * step);
        if (i == 0)
          first = along.n_pairs_tried();
        if (i % 10 == 0)
          {
            TurningMortar anew(pair.d, id, 0, "test");
            check(anew.rows(i * step) == rows,
                  "the search from the angle before gives the same bits");
          }
      }
    std::printf("%u pairs at first, %u in 60 steps\n",
                first,
                along.n_pairs_tried() - first);

    // Between knots: second order. The curvature of the weights jumps where
    // edges pass each other, so that single factors vary about 4.
    const auto          exact = pair.turning();
    std::vector<double> errors;
    for (const unsigned int knots : {50, 100, 200, 400})
      {
        const auto between = pair.turning(knots);
        errors.push_back(0.);
        for (double angle = .0171; angle < .8; angle += .0037)
          errors.back() =
            std::max(errors.back(),
                     largest_difference(*exact->relative_motion(angle),
                                        *between->relative_motion(angle)));
        std::printf("%u knots a cell: %.2e\n", knots, errors.back());
      }
    check_below(errors.back(), 5e-6, "between 400 knots a cell");
    check_close(std::log2(errors.front() / errors.back()) / 3.,
                2.,
                .1,
                "between knots: second order");
    for (std::size_t i = 1; i < errors.size(); ++i)
      check_below(errors[i], errors[i - 1] / 3., "falls with their number");

    ContactGeometry backwards = pair.separated.contacts[0];
    for (auto &frame : backwards.frames)
      {
        frame.sliding *= -1.;
        frame.transverse *= -1.;
      }
    check_close(exact->angle(.1075), 1., 2e-3, "it turns the way it slides");
    check_close(
      TurningContact(
        pair.d, pair.scene.contacts[0], backwards, pair.separated.reduce)
        .angle(.1075),
      -exact->angle(.1075),
      1e-12,
      "and back where it slides back");

    SceneParameters wrong = pair.scene;
    wrong.contacts[0].friction_direction =
      ContactParameters::FrictionDirection::fixed_y;
    const Discretization   d(wrong, Model::parameters(0), 1, MPI_COMM_SELF);
    const LinearizedSystem separated = separated_system(d, assemble_bodies(d));
    check_throws<InputError>(
      [&]() { TurningContact(d, wrong.contacts[0], separated.contacts[0]); },
      "Friction direction",
      "a sliding that is no turning is refused");
  }
} // namespace

int
main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  passes_on(1);
  passes_on(2);
  whole_cells();
  search();
}
