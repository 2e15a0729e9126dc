// SPDX-License-Identifier: LGPL-2.1-or-later

// Growth outside the band is that of the bodies: where the estimate of what the
// reduced model leaves out is no small correction they are asked, motions of
// the reduced model alone do not hide theirs, and what cannot be asked is left
// open.

#include "check.h"

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/base/exceptions.h>
#include <squeal/model/growth_outside.h>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  bool
  has(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  constexpr double turn = 2. * M_PI;

  /** Motions at 1 kHz, in the band, at 15 kHz and, above the cut-off of 20 kHz,
   * at 34 kHz. */
  struct GrowingScene
  {
    GrowingScene()
    {
      motion.lambda.resize(3);
      motion.lambda << std::complex<double>(-5., turn * 1e3),
        std::complex<double>(20., turn * 15e3),
        std::complex<double>(2142., turn * 34e3);
      p.eigen.highest_frequency = 2000.;
      p.transient.cut_off       = 20e3;
    }

    /** By an integrator, with the bodies' motions near each shift. */
    GrowthOutside
    growth(const TransientParameters::Integrator integrator)
    {
      p.transient.integrator = integrator;
      n_asked                = 0;
      return growth_outside(
        motion, error, p, [this](const std::complex<double> shift) {
          ++n_asked;
          Eigen::VectorXcd near(3);
          near << std::conj(of_bodies), of_bodies,
            std::complex<double>(-400., shift.imag() + turn * 1e3);
          return MotionsNear{near, turn * 1500.};
        });
    }

    LinearizedMotion     motion;
    Eigen::VectorXcd     error     = Eigen::VectorXcd::Zero(3);
    std::complex<double> of_bodies = {-300., turn * 34.2e3};
    Parameters           p;
    unsigned int         n_asked = 0;
  };

  using Integrator = TransientParameters::Integrator;

  /** Above the cut-off the estimate of what the reduction leaves out decides
   * nothing: the bodies do, of which the slower motions are named, too. */
  void
  growth_outside_the_band()
  {
    GrowingScene  scene;
    GrowthOutside growth = scene.growth(Integrator::reduced);
    std::string   text   = text_of_growth_outside(growth);
    check(scene.n_asked == 1 && growth.is_led_by_reduction() &&
            has(text, "34000 Hz") && has(text, "but not in the bodies") &&
            has(text, "within 1500 Hz"),
          "growth that the bodies do not have: " + text);
    check(growth.fastest() == scene.motion.lambda[1] &&
            text.rfind("a motion at 15000 Hz, outside the band, grows (sigma "
                       "of 20.0 1/s)",
                       0) == 0,
          "does not hide what they have: " + text);
    scene.of_bodies = {150., turn * 34.2e3};
    growth          = scene.growth(Integrator::reduced);
    text            = text_of_growth_outside(growth);
    check(growth.fastest() == scene.of_bodies && has(text, "34200 Hz") &&
            has(text, "150") && !has(text, "but not"),
          "growth of the bodies has their numbers: " + text);
    for (const Integrator all : {Integrator::implicit, Integrator::explicit_})
      {
        check(has(text_of_growth_outside(scene.growth(all)), "15000 Hz") &&
                scene.n_asked == 0,
              "runs of all unknowns have motions up to the cut-off");
        scene.motion.lambda[1] = -scene.motion.lambda[1];
        check(text_of_growth_outside(scene.growth(all)).empty(),
              "and none beyond it");
        scene.motion.lambda[1] = -scene.motion.lambda[1];
      }
    scene.p.transient.integrator = Integrator::reduced;
    const GrowthOutside open =
      growth_outside(scene.motion,
                     scene.error,
                     scene.p,
                     [](const std::complex<double>) -> MotionsNear {
                       throw InputError("no eigenvalues");
                     });
    text = text_of_growth_outside(open);
    check(has(text, "34000 Hz, outside the band, may grow") &&
            has(text, "is not known (no eigenvalues)") &&
            open.fastest() == scene.motion.lambda[2],
          "what cannot be asked is left open: " + text);
  }

  /** Below the cut-off the estimate decides while it is small, and where it
   * makes a motion grow the bodies are asked. */
  void
  growth_by_the_reduction()
  {
    GrowingScene scene;
    scene.motion.lambda[2] = {-1., turn * 34e3};
    scene.error[1]         = -2.;
    check(scene.growth(Integrator::implicit).fastest().real() == 20. &&
            scene.n_asked == 0,
          "a small correction");
    scene.error[1]      = -35.;
    GrowthOutside asked = scene.growth(Integrator::implicit);
    check(scene.n_asked == 1 && asked.is_led_by_reduction() &&
            text_of_growth_outside(growth_of_run(asked, scene.p.transient))
              .empty() &&
            has(text_of_growth_of_reduction(asked), "15000 Hz"),
          "growth that the bodies do not have is none of their runs");
    check(
      motions_of_run(scene.motion, asked, scene.p.transient).lambda[1].real() <
        0.,
      "which have the motion of the bodies instead");
    asked = scene.growth(Integrator::reduced);
    check(has(text_of_growth_outside(growth_of_run(asked, scene.p.transient)),
              "but not in the bodies"),
          "the reduced integrator has it");
    scene.motion.lambda[1] = {-55., turn * 15e3};
    scene.error[1]         = 227.;
    scene.of_bodies        = {255., turn * 15.05e3};
    asked                  = scene.growth(Integrator::reduced);
    check(scene.n_asked == 1 && asked.fastest() == scene.of_bodies &&
            !asked.is_led_by_reduction(),
          "growth that the reduced model lacks");
    scene.of_bodies.real(-9.);
    check(scene.growth(Integrator::reduced).motions.empty(),
          "and none where nothing grows");
    scene.error[1]         = 0.;
    scene.motion.lambda[1] = {1.2e-9, turn * 15e3};
    check(scene.growth(Integrator::reduced).motions.empty(),
          "rounding is no growth");
  }
} // namespace

int
main()
{
  growth_outside_the_band();
  growth_by_the_reduction();
}
