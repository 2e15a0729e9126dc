// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_other_degree_h
#define squeal_model_other_degree_h

#include <squeal/model/model.h>

#include <memory>

namespace squeal
{
  class CommonParts;
  class PressedConditions;

  /** What a scene shares with others whose meshes are made of the same numbers,
   * on elements of another degree. */
  struct SharedByScenes
  {
    CommonParts       *parts;
    PressedConditions *pressed;
    /** The same for scenes whose bodies and loads are the same. */
    std::size_t bodies;
  };

  /** The scene of a model on the same mesh with elements of another degree. */
  struct OtherDegree
  {
    std::unique_ptr<Discretization> space;
    LinearizedSystem                system;
    std::unique_ptr<Pencil>         pencil;
  };

  /** Assembles it. Contact states are those of steady sliding with that
   * degree, or those of the model where its springs stay where they are.
   * @p shared: null where nothing is. */
  OtherDegree with_degree(const Model          &model,
                          const unsigned int    degree,
                          Timers               &timers,
                          const SharedByScenes *shared = nullptr);
} // namespace squeal

#endif
