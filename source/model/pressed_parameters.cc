// SPDX-License-Identifier: LGPL-2.1-or-later

// What of the parameters a pressed model goes by.

#include <squeal/model/pressed_model.h>

#include <algorithm>

namespace squeal
{
  Parameters
  without_damping(Parameters parameters)
  {
    SceneParameters &scene = parameters.scene;
    scene.damping          = DampingParameters();
    scene.damping.model    = DampingParameters::Model::none;
    for (BodyParameters &body : scene.bodies)
      body.table_loss_factor = 0.;
    for (SpringParameters &spring : scene.springs)
      {
        spring.dashpot  = 0.;
        spring.dashpots = Vector3();
      }
    for (MatrixPartParameters &part : scene.matrix_parts)
      if (part.role == MatrixPartParameters::Role::damping)
        part.factor = 0.;
    return parameters;
  }



  double
  cut_off_of_statics(const Parameters &parameters)
  {
    return std::min(2000., parameters.eigen.highest_frequency);
  }



  bool
  has_preload_state(const SceneParameters &scene)
  {
    return std::any_of(
      scene.contacts.begin(), scene.contacts.end(), [](const auto &contact) {
        return contact.state == ContactParameters::State::preload;
      });
  }

  bool
  has_held_support(const SceneParameters &scene)
  {
    for (const auto &support : scene.supports)
      if (support.kind == SupportParameters::Kind::held)
        return true;
    return false;
  }
} // namespace squeal
