// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_tied_faces_h
#define squeal_scene_tied_faces_h

#include <squeal/scene/coarse_mesh.h>

#include <set>
#include <string>

namespace squeal
{
  /** Vertices of the boundary quads with this id; none of a face that a
   * conforming tie has joined. */
  std::set<unsigned int> vertices_of_face(const CoarseMesh  &mesh,
                                          const unsigned int id);

  /** Path of a support, load, bed, contact or other tie on one of the faces of
   * a tie, or nothing. A conforming tie leaves no such faces: inside the joined
   * bodies nothing can be held or loaded by their names. */
  std::string other_use_of_tied_faces(const SceneParameters &scene,
                                      const TieParameters   &tie);

  /**
   * Nodes of the source face of a mortar tie follow the target. Throws
   * InputError where a support holds some of them along a component that the
   * supports of the target leave free there: the target would be loose instead
   * of held.
   */
  void check_supports_on_ties(const SceneParameters &scene,
                              const CoarseMesh      &mesh);
} // namespace squeal

#endif
