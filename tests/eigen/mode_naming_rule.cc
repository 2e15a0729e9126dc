// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The rule of names on shapes in closed form: a disc of given Fourier content
// and a pad of given motion, next to and away from the limits between names.
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <functional>

#include "check.h"
#include "mode_naming_model.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  /** Axial, tangential, radial displacement at radius r (0 inner, 1 outer edge)
   * and angle from the pad. */
  using Field = std::function<std::array<Complex, 3>(double r, double angle)>;

  Field
  bending(const std::function<Complex(double r, double angle)> &w)
  {
    return [w](const double r, const double angle) {
      return std::array<Complex, 3>{{w(r, angle), 0., 0.}};
    };
  }

  /** A disc with one more body, without an eigenvalue problem. */
  class Scene
  {
  public:
    Scene()
      : model(scene(), 1)
      , evaluator(model.discretization)
      , disc(*disc_rings(model.discretization)[0],
             model.discretization.scene().bodies[0].density,
             evaluator,
             0,
             model.namer.reference_angle(),
             rows)
    {
    }

    /** Coordinates of a disc that moves as @p field. */
    Eigen::VectorXcd
    disc_coordinates(const Field &field) const
    {
      const unsigned int      n_rings = 10, n_angles = 72;
      const dealii::QGauss<1> gauss(n_rings);
      Eigen::VectorXcd        samples(disc.n_samples());
      check(samples.size() == 3 * n_rings * n_angles, "samples of the disc");
      for (unsigned int k = 0, i = 0; k < n_rings; ++k)
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int j = 0; j < n_angles; ++j)
            samples[i++] =
              field(gauss.point(k)[0], 2. * M_PI * j / n_angles)[c];
      Eigen::VectorXcd result(disc.n_coordinates());
      result.real() = disc.coordinates(Eigen::MatrixXd(samples.real()));
      result.imag() = disc.coordinates(Eigen::MatrixXd(samples.imag()));
      return result;
    }

    /** The beam moves tangentially as @p motion along its height 0 to 1. */
    Eigen::VectorXcd
    coordinates(const Field                         &field,
                const std::function<double(double)> &motion) const
    {
      const Eigen::VectorXcd on_disc = disc_coordinates(field);
      Eigen::VectorXcd       result =
        Eigen::VectorXcd::Zero(model.namer.n_coordinates());
      result.head(on_disc.size()) = on_disc;
      // A slice: three displacements, a rotation, five changes of shape.
      const unsigned int n_rows = 9,
                         n      = (result.size() - on_disc.size()) / n_rows;
      for (unsigned int s = 0; s < n; ++s)
        result[on_disc.size() + n_rows * s + 1] = motion((s + 0.5) / n);
      return result;
    }

    /** Names of shapes, a column each, of given energy shares of the disc. */
    std::vector<std::string>
    names(const Eigen::MatrixXcd &coordinates, const double disc_share) const
    {
      Eigen::MatrixXd shares(2, coordinates.cols());
      shares.row(0).setConstant(disc_share);
      shares.row(1).setConstant(1. - disc_share);
      std::vector<std::string> result;
      for (const auto &name : model.namer.name_coordinates(coordinates, shares))
        result.push_back(name.text);
      return result;
    }

    std::string
    disc_name(const Field &field) const
    {
      return names(coordinates(field, [](double) { return 0.; }), 1.)[0];
    }

    std::string
    beam_name(const std::function<double(double)> &motion) const
    {
      const Field rest = bending([](double, double) { return 0.; });
      return names(coordinates(rest, motion), 0.)[0];
    }

  private:
    static SceneParameters
    scene()
    {
      SceneParameters scene = disc_scene({{16, 2, 1}});
      scene.bodies.push_back(
        block("beam", {{0.1, 0., 0.}}, {{0.01, 0.01, 0.1}}, {{1, 1, 5}}));
      return scene;
    }

    Model                         model;
    PointEvaluator                evaluator;
    std::vector<Functionals::Row> rows;
    DiscShapes                    disc;
  };

  void
  expect(const std::string &name,
         const std::string &expected,
         const std::string &text)
  {
    check(name == expected, text + ": " + name + ", expected " + expected);
  }



  void
  pure_shapes_have_their_names(const Scene &scene)
  {
    for (int m = 0; m < 9; ++m)
      for (int n = 0; n < 3; ++n)
        for (const bool sine : {false, true})
          {
            if (m == 0 && sine)
              continue;
            const auto wave = [=](const double r, const double angle) {
              return std::cos(n * M_PI * r) *
                     (sine ? std::sin(m * angle) : std::cos(m * angle));
            };
            const std::string text = "(" + std::to_string(n) + "," +
                                     std::to_string(m) +
                                     (m == 0 ? ""
                                      : sine ? "-"
                                             : "+") +
                                     ")";
            expect(scene.disc_name(bending(wave)), text, "bending");
            expect(scene.disc_name([&](const double r, const double angle) {
              return std::array<Complex, 3>{{0., wave(r, angle), 0.}};
            }),
                   "T" + text,
                   "round the axis");
            expect(scene.disc_name([&](const double r, const double angle) {
              return std::array<Complex, 3>{{0., 0., wave(r, angle)}};
            }),
                   "R" + text,
                   "through the axis");
          }
  }

  /** a^2 of cos(3 theta) and b^2 of cos(4 theta), in opposition at the pad or
   * not; with the sines, in opposition in the slope. */
  std::string
  mixture(const Scene &scene,
          const double a2,
          const double b2,
          const double sign,
          const bool   sine = false)
  {
    return scene.disc_name(bending([=](const double r, const double angle) {
      const auto wave = [&](const int m) {
        return sine ? std::sin(m * angle) : std::cos(m * angle);
      };
      return r * (std::sqrt(a2) * wave(3) + sign * std::sqrt(b2) * wave(4));
    }));
  }

  void
  near_ties_are_named_as_ties(const Scene &scene)
  {
    // In phase at the pad: the larger one, equal parts are a tie whichever is
    // larger.
    expect(mixture(scene, 60., 40., 1.), "(0,3+)", "60 of m = 3 and 40 of 4");
    expect(mixture(scene, 40., 60., 1.), "(0,4+)", "40 of m = 3 and 60 of 4");
    expect(mixture(scene, 51., 49., 1.), "(0,3+)|(0,4+)", "51 and 49");
    expect(mixture(scene, 49., 51., 1.), "(0,3+)|(0,4+)", "49 and 51");
    // No neighbours: no reason to hold one against the other.
    const auto far = [&](const double a, const double b) {
      return scene.disc_name(bending([=](const double r, const double angle) {
        return r * (std::sqrt(a) * std::cos(2 * angle) -
                    std::sqrt(b) * std::cos(7 * angle));
      }));
    };
    expect(far(55., 45.), "(0,2+)", "55 of m = 2 and 45 of 7");
    expect(far(45., 55.), "(0,7+)", "45 of m = 2 and 55 of 7");
    expect(far(49.5, 50.5), "(0,2+)|(0,7+)", "equal parts");
    // A nodal circle that comes and goes: the inner lobe is 10 % of the outer.
    expect(scene.disc_name(bending([](const double r, const double angle) {
      return (r - 0.09) * std::cos(2. * angle);
    })),
           "(0,2+)|(1,2+)",
           "a lobe that may be counted");
  }

  void
  a_disc_held_at_the_pad_keeps_its_name(const Scene &scene)
  {
    for (const bool sine : {false, true})
      {
        const std::string parity = sine ? "-)" : "+)";
        for (const double ratio : {0., 0.1, 0.5, 0.98, 1.02, 2., 3., 4.5})
          expect(mixture(scene, 1., ratio, -1., sine),
                 "(0,3" + parity,
                 "m = 4 against m = 3, energy " + std::to_string(ratio));
        // tan^2(67.5 degrees) = 5.83
        expect(mixture(scene, 1., 5.83, -1., sine),
               "(0,3" + parity + "|(0,4" + parity,
               "m = 4 against m = 3, energy 5.83");
        for (const double ratio : {7.5, 20., 1e3})
          expect(mixture(scene, 1., ratio, -1., sine),
                 "(0,4" + parity,
                 "m = 4 against m = 3, energy " + std::to_string(ratio));
      }
  }

  void
  the_least_sign_at_the_pad_decides_nothing(const Scene &scene)
  {
    // All but pinned at the pad, where the count of sign changes hangs on
    // the last per cent.
    for (const double rest : {-0.15, -0.05, -1e-3, 0., 1e-3, 0.05, 0.15})
      expect(scene.disc_name(bending([=](const double r, const double angle) {
        return r * (0.6 * std::cos(2. * angle) + 0.35 * std::cos(angle) -
                    (0.95 - rest) * std::cos(3. * angle));
      })),
             "(0,2+)",
             "displacement at the pad " + std::to_string(rest));
  }



  void
  doublets_and_phases(const Scene &scene)
  {
    const auto turned = [&](const double degrees) {
      return scene.disc_name(bending([=](const double r, const double angle) {
        return r * std::cos(3. * angle - degrees * M_PI / 180.);
      }));
    };
    expect(turned(10.), "(0,3+)", "turned by 10 degrees of the phase");
    expect(turned(80.), "(0,3-)", "by 80");
    expect(turned(44.9), "(0,3+)|(0,3-)", "by nearly half");
    expect(turned(45.1), "(0,3+)|(0,3-)", "by little more than half");
    for (int k = 0; k < 24; ++k)
      {
        const Complex phase = std::polar(1., 2. * M_PI * k / 24 + 0.01);
        expect(scene.disc_name(bending([=](const double r, const double angle) {
          return phase * r *
                 (std::cos(3. * angle) - 0.9 * std::cos(4. * angle) +
                  Complex(0., 0.4) * std::sin(3. * angle));
        })),
               "(0,3+)",
               "phase " + std::to_string(k));
        expect(scene.disc_name(bending([=](const double r, const double angle) {
          return phase * r * std::polar(1., 3. * angle);
        })),
               "(0,3+)|(0,3-)",
               "a travelling wave, phase " + std::to_string(k));
      }
  }



  void
  bodies_are_named_by_their_motion(const Scene &scene)
  {
    expect(scene.beam_name([](double) { return 1.; }),
           "beam tangential 1",
           "moves as one");
    expect(scene.beam_name([](const double z) { return z - 0.6; }),
           "beam tangential 2",
           "swings");
    expect(scene.beam_name(
             [](const double z) { return std::cos(2. * M_PI * z) - 0.1; }),
           "beam tangential 3",
           "bends");
    expect(scene.beam_name([](const double z) { return z - 0.12; }),
           "beam tangential 1|beam tangential 2",
           "an end that hardly moves");

    // The number does not depend on what else is in the table.
    const Field      rest = bending([](double, double) { return 0.; });
    Eigen::MatrixXcd table(
      scene.coordinates(rest, [](double) { return 1.; }).size(), 2);
    table.col(0) =
      scene.coordinates(rest, [](const double z) { return z - 0.5; });
    table.col(1)     = scene.coordinates(rest, [](double) { return 1.; });
    const auto first = scene.names(table, 0.);
    const auto second =
      scene.names(Eigen::MatrixXcd(table.rowwise().reverse()), 0.);
    check(first[0] == second[1] && first[1] == second[0],
          "names do not depend on the order: " + first[0] + ", " + first[1]);
  }

  void
  shares_decide_what_is_mentioned(const Scene &scene)
  {
    const auto named = [&](const double disc_share) {
      return scene.names(
        scene.coordinates(bending([](const double r, const double angle) {
                            return r * std::cos(3. * angle);
                          }),
                          [](double) { return 1.; }),
        disc_share)[0];
    };
    expect(named(0.001), "beam tangential 1", "a still disc");
    expect(named(0.0049),
           "(0,3+) beam tangential 1|beam tangential 1",
           "a disc at the limit");
    expect(named(0.0051), named(0.0049), "and beyond it");
    expect(named(0.01), "(0,3+) beam tangential 1", "a disc with 1 %");
    expect(named(0.55), "(0,3+) beam tangential 1", "both");
    expect(named(0.69), "(0,3+)|(0,3+) beam tangential 1", "a beam of 31 %");
    expect(named(0.71), named(0.69), "and of 29 %");
    expect(named(0.8), "(0,3+)", "a beam with 20 %");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const Scene                              scene;
  const std::string                        only = argc > 1 ? argv[1] : "";
  const std::vector<std::pair<std::string, void (*)(const Scene &)>> parts = {
    {"pure", pure_shapes_have_their_names},
    {"ties", near_ties_are_named_as_ties},
    {"held", a_disc_held_at_the_pad_keeps_its_name},
    {"sign", the_least_sign_at_the_pad_decides_nothing},
    {"doublets", doublets_and_phases},
    {"bodies", bodies_are_named_by_their_motion},
    {"shares", shares_decide_what_is_mentioned}};
  for (const auto &[name, part] : parts)
    if (only.empty() || only == name)
      part(scene);
}
