// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_feature_place_h
#define squeal_tribology_statistics_feature_place_h

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** What takes places of features to those of the nodes. */
  struct FeaturePlace
  {
    std::array<double, 2> shift{{0., 0.}}; /**< m */
    /** Whether the features lie on the face without it, too: a part of it
     * that is seen may lie anywhere. They are then taken as they stand. */
    bool is_assumed = false;
  };

  /**
   * Images are known from the centre of the pad on (@p from_centre); a
   * transient's nodes (@p points, m) stand where the pad stands on the disc.
   * Other features (@p places, m) lie on the face as they stand or, where they
   * do not, from its centre on. Where they do both, features that reach over
   * the whole face lie where their middle is nearer to that of the face.
   */
  FeaturePlace place_of_features(
    const std::vector<std::array<double, 3>> &points,
    const std::vector<std::array<double, 2>> &places,
    bool                                      from_centre);
} // namespace squeal::tribology

#endif
