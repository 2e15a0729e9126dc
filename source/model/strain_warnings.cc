// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/base/run_log.h>
#include <squeal/model/pressed_model.h>
#include <squeal/model/strain_warnings.h>
#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/unit_notes.h>

#include <algorithm>
#include <numeric>

namespace squeal
{
  namespace
  {
    void
    warn_of_pair(const SceneParameters   &scene,
                 const ContactParameters &contact,
                 const ContactGeometry   &geometry,
                 const double             force,
                 RunLog                  &log)
    {
      constexpr double largest_strain = 0.1;
      const double     area =
        std::accumulate(geometry.areas.begin(), geometry.areas.end(), 0.);
      if (scene.kind != SceneParameters::Kind::bodies || !(area > 0.))
        return;
      for (const std::string &name : {contact.source_body, contact.target_body})
        {
          const BodyParameters &body    = scene.bodies[body_index(scene, name)];
          const double          modulus = lowest_young_modulus(body);
          if (body.shape != BodyParameters::Shape::rigid &&
              force / area > largest_strain * modulus)
            log.warning("contact " + contact.name + ": its mean pressure, " +
                        rounded_text(force / area, 3) + " Pa, is " +
                        rounded_text(force / area / modulus, 2) +
                        " times the Young modulus of " + name +
                        ": small displacements, which all results rest on, do "
                        "not hold; look at the units of loads, lengths and "
                        "moduli");
        }
    }
  } // namespace



  void
  warn_of_large_strains(const SceneParameters              &scene,
                        const std::vector<ContactGeometry> &contacts,
                        const std::vector<ContactState>    &states,
                        RunLog                             &log)
  {
    for (std::size_t i = 0; i < states.size(); ++i)
      if (states[i].in_newtons)
        warn_of_pair(scene,
                     scene.contacts[i],
                     contacts[i],
                     std::accumulate(states[i].force_share.begin(),
                                     states[i].force_share.end(),
                                     0.),
                     log);
  }



  void
  warn_of_large_strains(const SceneParameters &scene,
                        const PressedModel    &pressed,
                        const SteadySliding   &steady,
                        RunLog                &log)
  {
    const auto &pairs = pressed.nodes().pairs();
    for (std::size_t i = 0; i < pairs.size(); ++i)
      {
        // Normal, along and across the sliding.
        const Eigen::VectorXd forces = pairs[i].part(steady.forces);
        double                normal = 0.;
        for (Eigen::Index j = 0; j < forces.size(); j += 3)
          normal += forces[j];
        warn_of_pair(scene, scene.contacts[i], pairs[i].geometry, normal, log);
      }
  }
} // namespace squeal
