// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_transient_contact_factor_h
#define squeal_source_transient_contact_factor_h

#include <squeal/transient/reduced_contact_model.h>

#include <optional>

namespace squeal
{
  /** Size of the rounding of the flexibility of @p model, m/N: that of the
   * static motion by 1 N, of which it is what the modes leave. */
  double rounding_of_flexibility(const ReducedContactModel &model);

  /** Forces of a square flexibility, m/N, that need not be regular: where the
   * modes leave little of the bodies, it gives way in fewer motions than it has
   * rows, and is rounding in the others. */
  class ContactFactor
  {
  public:
    ContactFactor() = default;
    /** What is no larger than @p rounding, m/N, counts as nothing. */
    ContactFactor(const Eigen::MatrixXd &flexibility, const double rounding);

    bool is_regular() const;
    /** Forces that move it by @p motions, as far as any do, and none that move
     * nothing. */
    Eigen::MatrixXd solve(const Eigen::MatrixXd &motions) const;
    /** Orthonormal: motions that no force makes, forces that move nothing. */
    const Eigen::MatrixXd &left_null_space() const;
    const Eigen::MatrixXd &null_space() const;

  private:
    std::optional<Eigen::PartialPivLU<Eigen::MatrixXd>> factor;
    Eigen::MatrixXd                                     inverse, left, right;
  };
} // namespace squeal

#endif
