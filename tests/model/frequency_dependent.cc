// SPDX-License-Identifier: LGPL-2.1-or-later

// Layers whose modulus follows the frequency of each pair: a sandwich beam has
// the frequencies and loss factors of Ross, Kerwin and Ungar; the pairs of a
// brake with friction are those of a direct nonlinear solver, each once; a
// table of one modulus is that modulus.

#include "scenes.h"
#include "worst.h"

#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/discretization/affine_system.h>
#include <squeal/discretization/pair_error.h>
#include <squeal/eigen/direct_solver.h>
#include <squeal/model/cea_solution.h>
#include <squeal/model/frequency_pencil.h>
#include <squeal/scene/modulus_table.h>

#include <deal.II/base/mpi.h>

#include <fstream>
#include <sstream>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  /** Power laws of frequency, f in Hz. */
  double
  storage(const double f)
  {
    return 2e7 * std::pow(f / 1000., .3);
  }
  double
  loss(const double f)
  {
    return .5 + .1 * std::log10(f / 1000.);
  }

  void
  write_table(const std::string                         &file,
              const std::function<double(const double)> &e,
              const std::function<double(const double)> &eta)
  {
    std::ofstream out(file);
    out << "frequency_Hz, temperature_C, storage_modulus_Pa, loss_factor\n";
    out.precision(17);
    for (double f = 10.; f < 1.1e5; f *= 1.25892541179416721)
      out << f << ", 20, " << e(f) << ", " << eta(f) << "\n";
  }

  BodyParameters
  make_layer(const std::string &name,
             const std::string &body,
             const std::string &face,
             const double       thickness)
  {
    BodyParameters layer;
    layer.name       = name;
    layer.shape      = BodyParameters::Shape::layer;
    layer.layer_body = body;
    layer.layer_face = face;
    layer.thickness  = thickness;
    return layer;
  }

  struct Solved
  {
    explicit Solved(Parameters p)
      : parameters(with_moduli(std::move(p)))
      , model(parameters, timers)
    {
      std::ostringstream console;
      RunLog             log(true, console);
      ModeSolution       modes = solve_modes(model, log, timers);
      pairs                    = solve_cea(model, modes, log, timers).pairs;
    }

    static Parameters
    with_moduli(Parameters p)
    {
      p.check();
      take_modulus_tables(p);
      return p;
    }

    Timers        timers;
    Parameters    parameters;
    squeal::Model model;
    ComplexPairs  pairs;
  };

  Parameters
  in_band(const double lowest, const double highest)
  {
    Parameters p;
    p.analysis                      = Parameters::Analysis::cea;
    p.output.directory              = "out";
    p.eigen.lowest_frequency        = lowest;
    p.eigen.highest_frequency       = highest;
    p.discretization.degree         = 3;
    p.discretization.estimate_error = false;
    return p;
  }



  /** Steel, rubber, steel, guided at both ends, where a wave cos(k x) fits
   * exactly: no Poisson effect, nothing moves along y. */
  void
  sandwich()
  {
    write_table("rubber.csv", storage, loss);
    const double length = .3, h = .002, h_core = .001, E = 2e11, rho = 7800.,
                 rho_core = 1200.;
    Parameters p          = in_band(60., 2500.);
    auto      &scene      = p.scene;
    scene.bodies          = {
               make_block("lower", {{0., 0., 0.}}, {{length, .01, h}}, {{16, 1, 1}}),
               make_block("core", {{0., 0., h}}, {{length, .01, h_core}}, {{16, 1, 1}}),
               make_block(
        "upper", {{0., 0., h + h_core}}, {{length, .01, h}}, {{16, 1, 1}})};
    scene.ties = {make_tie("core", "z_min", "lower", "z_max"),
                  make_tie("upper", "z_min", "core", "z_max")};
    for (auto &body : scene.bodies)
      {
        body.young_modulus = E;
        body.poisson_ratio = 0.;
        body.density       = rho;
      }
    scene.bodies[1].density            = rho_core;
    scene.bodies[1].modulus_table_file = "rubber.csv";
    const auto hold                    = [&](const std::string &body,
                          const std::string &face,
                          const std::string &component) {
      SupportParameters support = make_clamp(body, face);
      support.name              = "s" + std::to_string(scene.supports.size());
      support.kind              = SupportParameters::Kind::components;
      support.components        = {component};
      scene.supports.push_back(support);
    };
    for (const std::string body : {"lower", "core", "upper"})
      {
        for (const std::string end : {"x_min", "x_max"})
          hold(body, end, "x");
        for (const std::string side : {"y_min", "y_max"})
          hold(body, side, "y");
      }
    const Solved solved(p);

    const double mass = 2. * rho * h + rho_core * h_core, d = h + h_core;
    Worst        frequency, factor;
    for (unsigned int n = 2; n <= 6; ++n)
      {
        const double k     = n * M_PI / length;
        double       omega = 1e3;
        Complex      square;
        for (unsigned int step = 0; step < 100; ++step)
          {
            const double  f = omega / (2. * M_PI);
            const Complex G = storage(f) / 2. * Complex(1., loss(f)); // nu = 0
            const Complex g = G * (2. / (E * h)) / (h_core * k * k);
            const Complex B =
              2. * E * h * h * h / 12. + .5 * E * h * d * d * g / (1. + g);
            square = B * k * k * k * k / mass;
            omega  = std::sqrt(square).real();
          }
        double  nearest = 1e300;
        Complex found;
        for (unsigned int i = 0; i < solved.pairs.size(); ++i)
          {
            const Complex s = -solved.pairs.lambda[i] * solved.pairs.lambda[i];
            if (std::abs(s - square) < nearest)
              {
                nearest = std::abs(s - square);
                found   = s;
              }
          }
        const double f      = omega / (2. * M_PI);
        const double f_fe   = std::sqrt(found).real() / (2. * M_PI);
        const double eta    = square.imag() / square.real();
        const double eta_fe = found.imag() / found.real();
        std::cout << "n " << n << ": " << f_fe << " Hz (" << f << "), loss "
                  << eta_fe << " (" << eta << ")\n";
        frequency.add(std::abs(f_fe / f - 1.));
        factor.add(std::abs(eta_fe / eta - 1.));
      }
    check(frequency.is_within(.02),
          "frequencies of Ross, Kerwin and Ungar, off by at most " +
            internal::digits(frequency.largest()));
    check(factor.is_within(.02),
          "loss factors of Ross, Kerwin and Ungar, off by at most " +
            internal::digits(factor.largest()));
  }



  /** A pad with a layer of rubber and one of steel on its back, pressed on a
   * disc by springs. */
  Parameters
  brake()
  {
    Parameters p            = in_band(800., 5000.);
    p.discretization.degree = 2;
    p.scene                 = coarse_brake(.5);
    auto &scene             = p.scene;
    scene.bodies.pop_back();
    scene.ties.clear();
    scene.springs.clear();
    scene.bodies.push_back(make_layer("rubber", "pad", "z_max", .001));
    scene.bodies.push_back(make_layer("plate", "rubber", "outer", .002));
    scene.bodies[2].poisson_ratio      = .45;
    scene.bodies[2].density            = 1200.;
    scene.bodies[2].modulus_table_file = "rubber.csv";
    scene.supports[0].name             = "inner";
    SupportParameters back             = make_clamp("plate", "outer");
    back.name                          = "back";
    back.kind                          = SupportParameters::Kind::components;
    back.components                    = {"x", "y"};
    scene.supports.push_back(back);
    scene.contacts[0].name = "pad_disc";
    return p;
  }

  /** By Arnoldi about the pair with the moduli at its own frequency, until that
   * changes by a hundredth of what it is compared to: each step makes the error
   * many times smaller. */
  Complex
  directly(const Solved &solved, Complex lambda)
  {
    const ModulusTables tables(solved.parameters.scene);
    for (unsigned int step = 0; step < 30; ++step)
      {
        const Pencil pencil(
          solved.model.linearized().system,
          tables.at(solved.parameters.scene, lambda.imag() / (2. * M_PI)));
        const Complex      shift = lambda * Complex(1., 1e-4);
        const ComplexPairs near  = DirectSolver(pencil, shift).solve(4);
        Complex            best  = near.lambda[0];
        for (unsigned int i = 1; i < near.size(); ++i)
          if (std::abs(near.lambda[i] - lambda) < std::abs(best - lambda))
            best = near.lambda[i];
        const double change = std::abs(best - lambda) / std::abs(best);
        lambda              = best;
        if (change < 1e-10)
          break;
      }
    return lambda;
  }

  void
  against_direct(const Parameters &p)
  {
    const Solved solved(p);
    check(solved.pairs.size() > 8, "pairs in the band");
    bool  grows = false;
    Worst difference, residual;
    for (unsigned int i = 0; i < solved.pairs.size(); ++i)
      {
        const Complex l = solved.pairs.lambda[i];
        grows           = grows || l.real() > 0.;
        difference.add(std::abs(directly(solved, l) - l) / std::abs(l),
                       internal::digits(l.imag() / (2. * M_PI)));
        residual.add(solved.pairs.residual[i]);
        std::cout << l.imag() / (2. * M_PI) << " Hz, " << l.real()
                  << " 1/s, residual " << solved.pairs.residual[i]
                  << ", estimate " << solved.pairs.error_estimate[i] << "\n";
      }
    check(difference.is_within(1e-8),
          "pairs as a direct nonlinear solver, off by at most " +
            internal::digits(difference.largest()));
    check(residual.is_within(1e-8), "residuals of the nonlinear problem");

    // None is lost: with fixed moduli as many as there are about them.
    const ModulusTables tables(solved.parameters.scene);
    const auto          n_below = [&](const double f) {
      const Pencil       pencil(solved.model.linearized().system,
                          tables.at(solved.parameters.scene, f));
      const DirectSolver solver(pencil, {0., 2. * M_PI * 4000.});
      const ComplexPairs all = solver.solve(80);
      unsigned int       n   = 0;
      for (unsigned int i = 0; i < all.size(); ++i)
        n += all.frequency(i) > 0. && all.frequency(i) < f &&
             std::abs(all.lambda[i].real()) < 5e4;
      return n;
    };
    check(n_below(5000.) - n_below(800.) == solved.pairs.size(),
          "as many as the direct solver counts at the ends of the band");
  }



  /** The loss factor of a table takes the place of that of the whole model in
   * its body, and there alone; damping by beta stays. */
  void
  one_loss_factor()
  {
    const double    E = 2e9, of_table = .4, of_model = .1, beta = 1e-6;
    SceneParameters s;
    s.bodies = {make_block("a", {}, {{1., 1., 1.}}, {{1, 1, 1}})};
    s.bodies[0].young_modulus      = E;
    s.bodies[0].modulus_table_file = "rubber.csv";
    s.bodies[0].table_loss_factor  = of_table;
    s.damping.model                = DampingParameters::Model::whole_model;
    s.damping.structural_damping   = of_model;
    s.damping.stiffness_damping    = beta;
    const auto of = [&]() { return elastic_coefficients(s, s.bodies[0]); };
    check_close(of().stiffness.imag(), of_table * E, 1e-14, "of the table");
    check_close(of().stiffness.real(), E, 1e-14, "its modulus");
    check_close(of().damping, beta * E, 1e-14, "beta of the whole model");
    const Complex factor = stiffness_factor(s, 0, 1e3);
    check_close(factor.imag(), of_table, 1e-14, "in the error of a pair, too");
    check_close(factor.real(), 1. + 1e3 * beta, 1e-14, "with beta");
    s.bodies[0].modulus_table_file = "";
    check_close(of().stiffness.imag(),
                of_model * E,
                1e-14,
                "of the whole model without a table");
  }



  void
  constant()
  {
    write_table(
      "rubber.csv", [](double) { return 2.5e7; }, [](double) { return .4; });
    const Solved table(brake());
    Parameters   p                       = brake();
    p.scene.damping                      = {};
    p.scene.damping.model                = DampingParameters::Model::per_part;
    p.scene.bodies[2].modulus_table_file = "";
    p.scene.bodies[2].young_modulus      = 2.5e7;
    p.scene.bodies[2].structural_damping = .4;
    Parameters q                         = brake();
    q.scene.damping                      = p.scene.damping;
    const Solved one(p), other(q);
    check(one.pairs.size() == other.pairs.size(), "as many pairs");
    Worst difference;
    for (unsigned int i = 0; i < one.pairs.size(); ++i)
      difference.add(std::abs(one.pairs.lambda[i] - other.pairs.lambda[i]) /
                     std::abs(one.pairs.lambda[i]));
    check(difference.is_within(1e-10),
          "a constant table is a constant modulus, off by at most " +
            internal::digits(difference.largest()));
    one_loss_factor();
    check(table.pairs.size() > 8, "with damping of the whole model beside it");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string                        test = argv[1];
  if (test == "sandwich")
    sandwich();
  else if (test == "brake")
    {
      write_table("rubber.csv", storage, loss);
      against_direct(brake());
    }
  else if (test == "mortar")
    {
      // The pad's own table enters the friction of the eliminated contact.
      write_table("rubber.csv", storage, loss);
      write_table(
        "pad.csv",
        [](const double f) { return 1e3 * storage(f); },
        [](const double f) { return .1 * loss(f); });
      Parameters p                         = brake();
      p.scene.bodies[1].modulus_table_file = "pad.csv";
      p.scene.contacts[0].formulation = ContactParameters::Formulation::mortar;
      p.scene.contacts[0].friction_coefficient = .4;
      against_direct(p);
    }
  else
    constant();
}
