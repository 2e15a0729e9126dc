// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_eigen_arpack_modes_h
#define squeal_source_eigen_arpack_modes_h

#include <squeal/eigen/undamped_modes.h>

namespace squeal
{
  /** The modes below the shift by (P)ARPACK's dsaupd, shift-invert mode 3. */
  UndampedModes arpack_modes(const Pencil         &pencil,
                             const ShiftedInverse &inverse,
                             const ModeOptions    &options);
} // namespace squeal

#endif
