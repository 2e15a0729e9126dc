// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_saved_modes_h
#define squeal_transient_saved_modes_h

#include <squeal/base/named_numbers.h>
#include <squeal/transient/reduction_basis.h>

#include <optional>
#include <string>

namespace squeal
{
  /**
   * By what a later run finds the motions of a basis again that a saved state
   * has its coordinates in. On several ranks modes repeat to rounding only,
   * their signs not at all, and those of one frequency share their plane in
   * another way each time. What fixed loads do to each motion tells which
   * combination of the new ones it is, with some numbers a mode in place of all
   * unknowns.
   */
  struct SavedModes
  {
    Eigen::VectorXd omega_squared; /**< (rad/s)^2 */
    unsigned int    n_modes = 0;   /**< the first ones, Ritz vectors follow */
    Eigen::MatrixXd shares; /**< loads x motions: load^T phi, the loads random
                               with the same numbers in every run */

    /** 16 digits that are others where a motion has another sign or other
     * bits. */
    std::string checksum() const;

    NamedNumbers numbers() const;
    /** None where there are no numbers. Throws InputError. */
    static std::optional<SavedModes> from_numbers(const NamedNumbers &numbers);
  };

  /** Those of @p basis. Collective. */
  SavedModes saved_modes(const ReductionBasis &basis, const RowSpace &space);

  /** Turns the motions of @p basis, one of the same bodies, into those of
   * @p saved; false, and nothing changes, where they are none of its
   * combinations to 1e-6. Collective. */
  bool turn_into(ReductionBasis   &basis,
                 const SavedModes &saved,
                 const Pencil     &pencil);
} // namespace squeal

#endif
