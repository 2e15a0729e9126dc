// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_turning_sense_h
#define squeal_contact_turning_sense_h

#include <squeal/contact/contact_frames.h>

namespace squeal
{
  /**
   * A body that turns through the fixed frame (`Rotation speed`) slides along
   * what rubs on it: throws InputError that names contact, place and both
   * directions where the sliding direction of @p frames, with the sign of the
   * friction coefficient, points against the relative velocity of target and
   * source. The growth rates would have the wrong sign. Nothing is asked where
   * neither body turns, and without friction. Throws also where a pair with
   * terms of the slip rate has a `Sliding speed` that is not, to a tenth, the
   * mean relative speed at @p points.
   *
   * @param points  contact points, m
   * @param frames  one for each of them
   */
  void require_sliding_as_turning(const SceneParameters               &scene,
                                  const ContactParameters             &contact,
                                  const std::vector<dealii::Point<3>> &points,
                                  const std::vector<ContactFrame>     &frames);
} // namespace squeal

#endif
