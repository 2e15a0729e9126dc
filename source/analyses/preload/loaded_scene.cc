// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/preload/loaded_scene.h>
#include <squeal/model/pressed_model.h>

namespace squeal
{
  Parameters
  loaded_scene(const Parameters &parameters)
  {
    Parameters p = without_damping(parameters);
    for (auto &contact : p.scene.contacts)
      contact.state = ContactParameters::State::full;
    for (auto &support : p.scene.supports)
      if (support.kind == SupportParameters::Kind::held)
        support.kind = SupportParameters::Kind::guided;
    return p;
  }
} // namespace squeal
