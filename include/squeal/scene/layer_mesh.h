// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_layer_mesh_h
#define squeal_scene_layer_mesh_h

#include <squeal/scene/coarse_mesh.h>

#include <vector>

namespace squeal
{
  /** The mesh of a layer and what of it belongs to the body below. */
  struct LayerMesh
  {
    /** Its first vertices are those of the body below on the covered face; no
     * boundary there. */
    BodyMesh mesh;
    /** Their numbers in the mesh of the body below. */
    std::vector<unsigned int> shared;
  };

  /**
   * Hexahedra extruded from the quadrilaterals of a face of the body below:
   * every node moves by the vector whose component along the normal of each
   * quadrilateral that meets there is the thickness. Between facets of a round
   * face the layer is as thick as within them. Faces of second order keep their
   * shape, a layer on them is of second order along the face.
   *
   * @param scene  whose body number @p number is the layer
   * @param below  the mesh of the body that it lies on
   *
   * Throws InputError where that body has no such face, where the face folds so
   * sharply that no node has such a vector, or where the layer is too thick for
   * a hollow face.
   */
  LayerMesh make_layer_mesh(const SceneParameters &scene,
                            const unsigned int     number,
                            const BodyMesh        &below);

  /** The body at the bottom of a stack of layers; @p body itself where it is no
   * layer. */
  const BodyParameters &bottom_body(const SceneParameters &scene,
                                    const BodyParameters  &body);
} // namespace squeal

#endif
