// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_loose_parts_h
#define squeal_scene_loose_parts_h

#include <squeal/scene/coarse_mesh.h>

namespace squeal
{
  /**
   * A body may consist of parts that share no vertices (vanes between two
   * rings) if ties, contacts, supports or springs on areas hold each of them:
   * every part must hang on the ground, or on the part of most cells. Pairs of
   * faces hold parts where the boxes round both meet. Throws InputError that
   * names a loose part by its size and a node. Conforming ties must be joined.
   */
  void refuse_loose_parts(const SceneParameters &scene, const CoarseMesh &mesh);

  /**
   * Sentences for the log about bodies of mesh files that are slit open: faces
   * of their surface that lie on others of the same body with nodes of their
   * own, within 1e-5 of a face's size. Ties and contacts between faces of one
   * body are no slits. Conforming ties must be joined.
   */
  std::vector<std::string> remarks_on_slits(const SceneParameters &scene,
                                            const CoarseMesh      &mesh);
} // namespace squeal

#endif
