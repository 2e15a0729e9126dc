// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_preload_stiffness_entry_check_h
#define squeal_analyses_preload_stiffness_entry_check_h

#include <squeal/model/model.h>

namespace squeal
{
  /**
   * Looks whether `Preload/Stiffness entry` does anything to steady sliding at
   * one of its values: by the stiffness of a part of the scene, the springs of
   * a pair or its friction, if the entry enters by such numbers alone. A table
   * over one that does not would say that it does not matter. Nothing where no
   * entry is given.
   *
   * Throws InputError. @p parameters: those of the loads, loaded_scene(), which
   * @p model is made of.
   */
  void check_stiffness_entry(const Parameters &parameters, const Model &model);
} // namespace squeal

#endif
