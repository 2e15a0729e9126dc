// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_open_scene_h
#define squeal_model_open_scene_h

#include <squeal/contact/contact_nodes.h>
#include <squeal/contact/contact_terms.h>
#include <squeal/parameters/parameters.h>

#include <functional>

namespace squeal
{
  struct ImportedModel;

  /** A scene with its contact pairs cut open and all that steady sliding and
   * transients need of it, whatever it comes from. */
  struct OpenScene
  {
    LinearizedSystem separated;
    ContactNodes     nodes;
    /** Forces on the unknowns of the system, N: of all loads together, and of
     * one of them. */
    Block                                        load;
    std::function<Block(const LoadParameters &)> force_of;
    /** Functionals of the unknowns, PressedModel::n_observers a pair. */
    Block observed;
    /** Forces at random at some points of every body. */
    Block struck;
    /** Null for imported models. */
    const Discretization *discretization = nullptr;
  };

  /** References are kept. */
  OpenScene open_scene(const SceneParameters           &scene,
                       const Discretization            &discretization,
                       const std::vector<BodyMatrices> &bodies);

  /** Of an imported model. The loads are those of its node table; the motion of
   * a body's centre is that of its centre of mass; the far face of a source is
   * that of the node table, or else its nodes furthest along the normal. */
  OpenScene open_scene(const SceneParameters &scene,
                       const ImportedModel   &model);
} // namespace squeal

#endif
