// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_continued_pencils_h
#define squeal_sweep_continued_pencils_h

#include <squeal/sweep/exceptional_point.h>
#include <squeal/sweep/parametric_system.h>
#include <squeal/sweep/reduced_model.h>

namespace squeal
{
  /**
   * The reduced model on the line along the first axis through @p start at
   * complex coordinates: first on the basis V of the cell, then on the common
   * basis. All of it must outlive the result.
   *
   * The coefficients of the parts are continued by polynomials through their
   * values on the real axis, within one segment of a list and one contact
   * state, which have laws of their own. Where polynomials of up to degree 12
   * do not give the values between to 1e-10 there is no continuation.
   */
  Continuation continuation_of(const ParametricSystem &system,
                               const ReducedModel     &model,
                               const SweepPoint       &start);
} // namespace squeal

#endif
