// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_reduced_motions_h
#define squeal_model_reduced_motions_h

#include <squeal/model/pressed_model.h>
#include <squeal/transient/linearized_motion.h>

#include <complex>
#include <string>
#include <vector>

namespace squeal
{
  class RunLog;

  /** The motions about the steady sliding of @p about. Throws InputError where
   * `Transient/Cut-off` leaves the bodies none. */
  LinearizedMotion motions_about(const SteadyModel &about);

  /** Growing pairs of @p linear within @p band, the fastest first. */
  std::vector<Eigen::Index> growing_pairs(const LinearizedMotion &linear,
                                          const EigenParameters  &band);

  /** Pairs of @p linear within @p band, those of the largest real part first. */
  std::vector<Eigen::Index> pairs_in_band(const LinearizedMotion &linear,
                                          const EigenParameters  &band);

  /** Whether a run by the integrator of @p t has the motion of eigenvalue
   * @p lambda, 1/s, of the reduced model. Above the cut-off the reduced model
   * has motions that the bodies do not have: they are motions of the reduced
   * integrator, not of those of all unknowns. */
  bool is_of_the_run(const std::complex<double> lambda,
                     const TransientParameters &t);

  /** The eigenvalue, 1/s, of the largest real part about steady sliding, of the
   * motions of the run; 0 where that does not grow. */
  std::complex<double> fastest_growth(const LinearizedMotion    &linear,
                                      const TransientParameters &t);

  /** Logs what `Transient/Cut-off damping`, which keeps impacts from ringing,
   * does to the @p pairs of @p linear: modes near the cut-off follow their
   * motion too, and are damped in that. Warns where a growth rate moves by more
   * than 2 % and 3 1/s. */
  void report_cut_off_damping(const PressedModel              &pressed,
                              const SteadySliding             &steady,
                              const LinearizedMotion          &linear,
                              const std::vector<Eigen::Index> &pairs,
                              const Parameters                &parameters,
                              RunLog                          &log);
} // namespace squeal

#endif
