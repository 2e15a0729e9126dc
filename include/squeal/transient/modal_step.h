// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_modal_step_h
#define squeal_transient_modal_step_h

#include <squeal/transient/modal_operator.h>
#include <squeal/transient/reduced_contact_model.h>

namespace squeal
{
  /**
   * The exact motion of all modes over a step under forces F that change
   * linearly from its start to its end:
   *   q_1 = q_q q_0 + q_v v_0 + q_f0 F_0 + q_f1 F_1, and so for v_1,
   * mode by mode, and of all together where damping couples them.
   */
  struct ModalStep
  {
    ModalStep(const ReducedContactModel &model, const double time_step);

    ModalOperator q_q, q_v, q_f0, q_f1, v_q, v_v, v_f0, v_f1;

    /** W with u_1 = a - W lambda_1: the motion of the nodes at the end of the
     * step by forces there, the massless flexibility included, m/N, and what
     * fill_of_null_space() adds. */
    Eigen::MatrixXd delassus(const ReducedContactModel &model) const;

  private:
    void set_mode_by_mode(const ReducedContactModel &model,
                          const double               time_step);
    void set_coupled(const ReducedContactModel &model, const double time_step);
  };

  /**
   * Whether steps of that length keep a closed contact quiet. Forces linear in
   * time that hold the nodes at the end of every step are Newmark's method with
   * beta = 1/6 for what the contact's own stiffness G^-1 makes of the modes: it
   * is unstable beyond omega dt = 2 sqrt(3). All nodes stick here, the stiffest
   * contact there is; the growth of a motion tells.
   */
  bool is_stable_step(const ReducedContactModel &model, const double time_step);

  /** The largest stable step up to @p asked, to 1 %. Throws ComputationError
   * where none above a billionth of it is stable. */
  double largest_stable_step(const ReducedContactModel &model,
                             const double               asked);
} // namespace squeal

#endif
