// SPDX-License-Identifier: LGPL-2.1-or-later

// Signs of contact and friction by symmetries: the spectrum of a scene does not
// change when the whole scene is turned about any axis, when it is mirrored
// with its sliding, when a pad presses from below instead of from above, when
// pairs are renumbered, and when lengths are in other units. Dense matrices, so
// that no solver is in between.

#include "turned_block.h"

#include <deal.II/base/mpi.h>

#include <Eigen/Eigenvalues>

#include <functional>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Point       = dealii::Point<3>;
  using Formulation = ContactParameters::Formulation;
  using Layout      = ContactParameters::SpringLayout;
  using Direction   = ContactParameters::FrictionDirection;

  /** How a scene is placed: x becomes factor R x, an orthogonal R. */
  struct Placing
  {
    Eigen::Matrix3d R      = Eigen::Matrix3d::Identity();
    double          factor = 1.;

    Vector3
    direction(const Vector3 &v) const
    {
      const Eigen::Vector3d w = R * Eigen::Vector3d(v[0], v[1], v[2]);
      return {{w[0], w[1], w[2]}};
    }

    Vector3
    point(const Vector3 &v) const
    {
      Vector3 w = direction(v);
      for (double &c : w)
        c *= factor;
      return w;
    }
  };

  /** A block whose mesh file is written where @p placing puts it. */
  BodyParameters
  placed_block(const BodyParameters &block, const Placing &placing)
  {
    BodyParameters     body = make_turned_block(block, 0.);
    std::ifstream      in(body.mesh_file);
    std::ostringstream out;
    out.precision(17);
    bool is_node = false;
    for (std::string line; std::getline(in, line);)
      {
        if (line[0] == '$')
          is_node = line == "$Nodes";
        std::istringstream words(line);
        int                number;
        Vector3            x;
        if (is_node && words >> number >> x[0] >> x[1] >> x[2])
          {
            for (unsigned int c = 0; c < 3; ++c)
              x[c] += block.position[c];
            x = placing.point(x);
            out << number << ' ' << x[0] << ' ' << x[1] << ' ' << x[2] << '\n';
          }
        else
          out << line << '\n';
      }
    in.close();
    std::ofstream(body.mesh_file) << out.str();
    body.position = {{0., 0., 0.}};
    return body;
  }

  struct Options
  {
    Formulation formulation = Formulation::springs;
    Layout      layout      = Layout::grid;
    Direction   direction   = Direction::given;
    double      mu          = 1.;
    bool        above = true, below = false;
    bool        is_reversed = false; /**< order of the pairs */
    double      y           = 0.004; /**< of the pads */
    double      sense       = 1.;    /**< of the sliding direction */
  };

  /** Pads on three springs each, on a plate that one edge holds. */
  SceneParameters
  scene_of(const Options &o, const Placing &placing = {})
  {
    SceneParameters s;
    const double    L         = placing.factor;
    s.bodies                  = {placed_block(
      make_block("plate", {{.1, 0., -.01}}, {{.06, .05, .01}}, {{3, 2, 1}}),
      placing)};
    s.bodies[0].rotation_axis = placing.direction({{0., 0., o.sense}});
    s.supports                = {make_clamp("plate", "x_min")};
    const auto add            = [&](const std::string &name, const double z) {
      const bool is_above = z >= 0.;
      s.bodies.push_back(placed_block(
        make_block(name, {{.105, o.y, z}}, {{.02, .015, .01}}, {{2, 2, 1}}),
        placing));
      s.bodies.back().young_modulus = 2e10;
      s.bodies.back().density       = 2500.;
      for (unsigned int c = 0; c < 3; ++c)
        {
          SpringParameters spring;
          spring.name = name + std::to_string(c);
          spring.body = name;
          spring.first_point =
            placing.point({{.1, o.y, is_above ? .01 : -.02}});
          spring.last_point =
            placing.point({{.11, o.y, is_above ? .01 : -.02}});
          spring.number    = 2;
          spring.direction = placing.direction(
            {{double(c == 0), double(c == 1), double(c == 2)}});
          spring.stiffness = 3e7 * (1. + c) / L;
          s.springs.push_back(spring);
        }
      ContactParameters contact;
      contact.name                      = name + " on plate";
      contact.source_body               = name;
      contact.source_face               = is_above ? "z_min" : "z_max";
      contact.target_body               = "plate";
      contact.target_face               = is_above ? "z_max" : "z_min";
      contact.formulation               = o.formulation;
      contact.layout                    = o.layout;
      contact.grid                      = {{4, 4}};
      contact.normal_stiffness          = 2e7 / L;
      contact.normal_stiffness_per_area = 1e12 / (L * L * L);
      contact.friction_coefficient      = o.mu;
      contact.friction_direction        = o.direction;
      if (o.direction == Direction::given)
        contact.sliding_direction = placing.direction({{0., o.sense, 0.}});
      contact.transverse_slip_term = true;
      contact.sliding_speed        = L;
      contact.normal_force         = 10.;
      s.contacts.push_back(contact);
    };
    if (o.above)
      add("upper", 0.);
    if (o.below)
      add("lower", -.02);
    if (o.is_reversed)
      std::reverse(s.contacts.begin(), s.contacts.end());
    for (BodyParameters &body : s.bodies)
      {
        // Newton, second and the unit of length: E in N/L^2, rho in N s^2/L^4.
        body.young_modulus /= L * L;
        body.density /= L * L * L * L;
      }
    s.damping.model             = DampingParameters::Model::whole_model;
    s.damping.mass_damping      = 1.;
    s.damping.stiffness_damping = 1e-9;
    return s;
  }

  /** All eigenvalues with a positive imaginary part, ascending. */
  std::vector<std::complex<double>>
  spectrum(const SceneParameters &scene, const unsigned int degree = 1)
  {
    const Discretization d(scene, {}, degree, MPI_COMM_SELF);
    const auto      system = linearized_system(d, assemble_bodies(d)).system;
    const int       n      = system.space->n_global();
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n), C = M, K = M;
    const Block     unit = Block::Identity(n, n);
    for (const AffineTerm &term : system.terms)
      {
        const TermCoefficients c = term.coefficients(scene);
        if (c.is_zero())
          continue;
        const Eigen::MatrixXd A = term.matrix->multiply(unit);
        M += c.mass * A;
        C += c.damping * A;
        K += c.stiffness.real() * A;
      }
    const Eigen::LLT<Eigen::MatrixXd> mass(0.5 * (M + M.transpose()));
    check(mass.info() == Eigen::Success, "the mass is positive definite");
    Eigen::MatrixXd S = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    // Of one size: velocities over a typical frequency.
    const double w = 1e5;
    S.topRightCorner(n, n).diagonal().setConstant(w);
    S.bottomLeftCorner(n, n)              = -mass.solve(K) / w;
    S.bottomRightCorner(n, n)             = -mass.solve(C);
    const Eigen::VectorXcd            all = S.eigenvalues();
    std::vector<std::complex<double>> result;
    for (const auto &lambda : all)
      if (lambda.imag() > 0.)
        result.push_back(lambda);
    std::sort(result.begin(), result.end(), [](const auto a, const auto b) {
      return a.imag() < b.imag();
    });
    return result;
  }

  unsigned int
  n_growing(const std::vector<std::complex<double>> &all)
  {
    return std::count_if(all.begin(), all.end(), [](const auto lambda) {
      return lambda.real() > 1.;
    });
  }

  /** Every eigenvalue of @p a, or the mean of those that all but coincide with
   * it, is one of @p b. */
  void
  same(const std::vector<std::complex<double>> &a,
       const std::vector<std::complex<double>> &b,
       const std::string                       &claim)
  {
    check(a.size() == b.size() && a.size() > 50, claim + ": as many");
    Worst      worst;
    const auto mean_near = [](const std::vector<std::complex<double>> &all,
                              const std::complex<double>               to) {
      std::complex<double> sum = 0.;
      unsigned int         n   = 0;
      for (const auto lambda : all)
        if (std::abs(lambda - to) < 1e-4 * std::abs(to))
          {
            sum += lambda;
            ++n;
          }
      return sum / double(n);
    };
    for (const auto lambda : a)
      worst.add(std::abs(mean_near(b, lambda) - mean_near(a, lambda)) /
                std::abs(lambda));
    std::cout << "        " << claim << ": " << worst.largest() << std::endl;
    check(worst.largest() <= 1e-9, claim);
  }

  Placing
  turned(const double angle, const Eigen::Vector3d &axis)
  {
    return {Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), 1.};
  }

  void
  test_formulation(Options o, const std::string &name)
  {
    for (const Direction direction : {Direction::given, Direction::slip})
      {
        o.direction = direction;
        const std::string claim =
          name + (direction == Direction::slip ? ", slip" : ", given");
        const auto straight = spectrum(scene_of(o));
        check(n_growing(straight) > 0,
              claim + ": friction makes " +
                std::to_string(n_growing(straight)) + " pairs grow");
        same(straight,
             spectrum(scene_of(o, turned(.7, {1., 2., 3.}))),
             claim + ", turned about an oblique axis");
        same(straight,
             spectrum(scene_of(o, turned(M_PI / 2., {1., 0., 0.}))),
             claim + ", the target looks along -y");
        same(straight,
             spectrum(scene_of(o, turned(-M_PI / 2., {0., 1., 0.}))),
             claim + ", the target looks along -x");
        same(straight,
             spectrum(scene_of(o, turned(M_PI, {1., 0., 0.}))),
             claim + ", turned upside down");
        Options mirrored = o;
        mirrored.y       = -o.y;
        mirrored.sense   = -o.sense;
        same(straight, spectrum(scene_of(mirrored)), claim + ", mirrored in y");
        Options below = o;
        below.above   = false;
        below.below   = true;
        same(straight, spectrum(scene_of(below)), claim + ", pad below");
        Options backwards = o;
        backwards.sense   = -1.;
        backwards.mu      = -o.mu;
        same(straight,
             spectrum(scene_of(backwards)),
             claim + ", -mu against the other direction");
        Options opposite = o;
        opposite.sense   = -1.;
        const auto other = spectrum(scene_of(opposite));
        Worst      difference;
        for (std::size_t i = 0; i < std::min(other.size(), straight.size());
             ++i)
          difference.add(std::abs(other[i] - straight[i]) /
                         std::abs(straight[i]));
        check(difference.largest() > 1e-6,
              claim + ": the sense of sliding tells");
      }
  }

  /** Two pads, on two sides. */
  void
  test_two_pads(Options o, const std::string &name)
  {
    o.below             = true;
    const auto straight = spectrum(scene_of(o));
    check(n_growing(straight) > 0, name + ": two pads make a pair grow");
    Options renumbered     = o;
    renumbered.is_reversed = true;
    same(straight, spectrum(scene_of(renumbered)), name + ", renumbered");
    same(straight,
         spectrum(scene_of(o, turned(2., {-1., .5, 1.}))),
         name + ", two pads turned");
    same(straight,
         spectrum(scene_of(o, turned(M_PI, {0., 1., 0.}))),
         name + ", the pads exchanged");
    Placing millimetres;
    millimetres.factor = 1e3;
    same(straight,
         spectrum(scene_of(o, millimetres)),
         name + ", lengths in millimetres");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  Options                                  grid, quadrature, mortar, nodes;
  quadrature.layout  = Layout::quadrature;
  mortar.formulation = Formulation::mortar;
  nodes.formulation  = Formulation::node_to_surface;
  for (const auto &[options, name] :
       std::vector<std::pair<Options, std::string>>{
         {grid, "springs on a grid"},
         {quadrature, "springs at quadrature points"},
         {mortar, "mortar"},
         {nodes, "node to surface"}})
    {
      test_formulation(options, name);
      test_two_pads(options, name);
    }
}
