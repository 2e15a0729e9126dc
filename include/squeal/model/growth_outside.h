// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_growth_outside_h
#define squeal_model_growth_outside_h

#include <squeal/model/reduced_motions.h>

#include <complex>
#include <functional>
#include <string>
#include <vector>

namespace squeal
{
  class Timers;

  /** A motion of the reduced model about steady sliding outside the band that
   * grows or would grow by what it leaves out, and whether the bodies have it.
   */
  struct MotionOutside
  {
    enum class Owner
    {
      bodies,    /**< they grow there, too */
      reduction, /**< nothing of them grows near it */
      not_known
    };
    Owner                owner;
    Eigen::Index         index;  /**< in the LinearizedMotion */
    std::complex<double> lambda; /**< of the reduced model, 1/s */
    /** What the reduced model leaves out would add, to first order, 1/s. */
    std::complex<double> estimate;
    /** Of the bodies, 1/s: the growing motion that is nearest, else the one
     * that is nearest; `lambda` where the estimate suffices or nobody looked.
     */
    std::complex<double> of_bodies;
    /** From `lambda`, 1/s, within which nothing of the bodies grows. */
    double      reach = 0.;
    std::string why; /**< it is not known */
  };

  /** Those that grow faster than all of the band, in the reduced model or by
   * the estimate, the fastest first. */
  struct GrowthOutside
  {
    std::vector<MotionOutside> motions;

    /** The fastest that the bodies have or may have, 1/s; 0 without one. */
    std::complex<double> fastest() const;
    /** The fastest is one that the bodies do not have. */
    bool is_led_by_reduction() const;
  };

  /** Eigenvalues of the whole model next to a shift, 1/s, and how far from it
   * there is no other. */
  struct MotionsNear
  {
    Eigen::VectorXcd lambda;
    double           reach;
  };
  using MotionsOfBodies =
    std::function<MotionsNear(const std::complex<double> shift)>;

  /**
   * Growth of the motions of the run (is_of_the_run()) of @p linear outside
   * the band. What the reduced model leaves out, @p estimate, 1/s, of
   * reduction_error(), decides where it is a small correction. Elsewhere the
   * bodies are asked, whose InputError or ComputationError leaves it open.
   */
  GrowthOutside growth_outside(const LinearizedMotion &linear,
                               const Eigen::VectorXcd &estimate,
                               const Parameters       &parameters,
                               const MotionsOfBodies  &bodies);

  /** With the model of all unknowns about the same contact state, assembled
   * where it is asked and factorised at each shift. Collective. */
  GrowthOutside growth_outside(const SteadyModel      &about,
                               const LinearizedMotion &linear,
                               const Eigen::VectorXcd &estimate,
                               const Parameters       &parameters,
                               Timers                 &timers);
  GrowthOutside growth_outside(const SteadyModel      &about,
                               const LinearizedMotion &linear,
                               const Parameters       &parameters,
                               Timers                 &timers);

  /** In words, what the bodies have first: "a motion at 38995 Hz, outside the
   * band, grows (sigma of 6.52 1/s)"; empty where there is none. */
  std::string text_of_growth_outside(const GrowthOutside &growth);

  /** The clause of what the reduced model alone has; empty where there is
   * none. */
  std::string text_of_growth_of_reduction(const GrowthOutside &growth);
} // namespace squeal

#endif
