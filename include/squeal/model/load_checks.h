// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_load_checks_h
#define squeal_model_load_checks_h

#include <squeal/base/row_space.h>
#include <squeal/parameters/parameters.h>

#include <string>

namespace squeal
{
  /** Throws InputError naming @p section where @p load is not zero but none of
   * its nodal forces @p force, N, acts on an unknown of @p space: supports hold
   * all of its face. Collective. */
  void require_motion(const RowSpace       &space,
                      const Block          &force,
                      const LoadParameters &load,
                      const std::string    &section);

  /** The hammer's largest force. */
  LoadParameters load_of(const HammerParameters &hammer);
} // namespace squeal

#endif
