// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/glued_bodies.h>

namespace squeal
{
  std::vector<std::array<std::string, 2>>
  glued_bodies(const SceneParameters &scene)
  {
    std::vector<std::array<std::string, 2>> result;
    for (const TieParameters &tie : scene.ties)
      result.push_back({{tie.source_body, tie.target_body}});
    for (const BodyParameters &body : scene.bodies)
      if (body.shape == BodyParameters::Shape::layer)
        result.push_back({{body.layer_body, body.name}});
    return result;
  }



  std::set<std::string>
  glued_to(const SceneParameters &scene, const std::string &body)
  {
    std::set<std::string> names{body};
    for (std::size_t n = 0; n != names.size();)
      {
        n = names.size();
        for (const auto &[a, b] : glued_bodies(scene))
          if (names.count(a) + names.count(b) == 1)
            names.insert({a, b});
      }
    return names;
  }
} // namespace squeal
