// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_other_degree_h
#define squeal_model_other_degree_h

#include <squeal/model/model.h>

#include <memory>

namespace squeal
{
  class PressedConditions;

  /** The scene of a model on the same mesh with elements of another degree. */
  struct OtherDegree
  {
    std::unique_ptr<Discretization> space;
    LinearizedSystem                system;
    std::unique_ptr<Pencil>         pencil;
  };

  /** Assembles it. Contact states are those of steady sliding with that
   * degree, or those of the model where its springs stay where they are.
   * @p pressed: what steady sliding has in common with other scenes on the same
   * mesh, of the number @p bodies, or null. */
  OtherDegree with_degree(const Model       &model,
                          const unsigned int degree,
                          Timers            &timers,
                          PressedConditions *pressed = nullptr,
                          const std::size_t  bodies  = 0);
} // namespace squeal

#endif
