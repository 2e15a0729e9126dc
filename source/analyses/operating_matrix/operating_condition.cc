// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/operating_matrix/operating_condition.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/model/frequency_pencil.h>
#include <squeal/scene/modulus_table.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** @p values or, where there are none, the one of the scene. */
    std::vector<std::optional<double>>
    or_of_scene(const std::vector<double> &values)
    {
      if (values.empty())
        return {std::nullopt};
      return {values.begin(), values.end()};
    }

    Parameters
    at_condition(Parameters p, const OperatingCondition &c)
    {
      for (auto &load : p.scene.loads)
        if (c.pressure && load.pressure != 0.)
          load.pressure = *c.pressure;
      for (auto &contact : p.scene.contacts)
        {
          if (c.speed && contact.sliding_speed > 0.)
            contact.sliding_speed = *c.speed;
          if (c.backward)
            contact.friction_coefficient *= -1.;
        }
      if (c.backward)
        for (auto &body : p.scene.bodies)
          body.rotation_speed *= -1.;
      return p;
    }

    /** The scene with all tables at the temperature and the pressure of a
     * condition and their moduli of the reference frequency. */
    SceneParameters
    with_moduli(const Parameters &p, const OperatingCondition &c)
    {
      SceneParameters     scene = p.scene;
      const ModulusTables tables(scene);
      for (auto &body : scene.bodies)
        {
          if (c.temperature && body.has_modulus_table())
            body.temperature = *c.temperature;
          if (c.pressure && tables.depend_on_pressure(body))
            body.pressure = *c.pressure;
        }
      const bool is_felt = presses_contacts(scene) ||
                           std::any_of(scene.bodies.begin(),
                                       scene.bodies.end(),
                                       [&tables](const auto &body) {
                                         return tables.depend_on_pressure(body);
                                       });
      if (c.pressure && !is_felt)
        throw InputError(
          "'Operating matrix/Pressures' acts on nothing: no modulus table has "
          "the column pressure_Pa, and no load with a 'Pressure' presses a "
          "contact with 'Contact state = preload'");
      tables.require_band(
        scene, p.eigen.lowest_frequency, p.eigen.highest_frequency);
      return tables.at(scene, reference_frequency(p.eigen));
    }
  } // namespace



  std::vector<OperatingCondition>
  operating_conditions(const OperatingMatrixParameters &m)
  {
    std::vector<OperatingCondition> result;
    for (const bool backward : {false, true})
      if (!backward || m.both_directions)
        for (const auto &speed : or_of_scene(m.speeds))
          for (const auto &pressure : or_of_scene(m.pressures))
            for (const auto &temperature : or_of_scene(m.temperatures))
              result.push_back({pressure, speed, temperature, backward});
    return result;
  }

  std::string
  text_of(const OperatingCondition &c)
  {
    std::string text = c.backward ? "backward" : "forward";
    if (c.pressure)
      text += ", " + rounded_text(*c.pressure, 4) + " Pa";
    if (c.speed)
      text += ", " + rounded_text(*c.speed, 4) + " m/s";
    if (c.temperature)
      text += ", " + rounded_text(*c.temperature, 4) + " degrees Celsius";
    return text;
  }

  Parameters
  parameters_of(const Parameters &p, const OperatingCondition &c)
  {
    Parameters here = at_condition(p, c);
    here.scene      = with_moduli(here, c);
    return here;
  }

  std::map<std::pair<std::optional<double>, std::optional<double>>,
           std::vector<std::size_t>>
  with_same_bodies(const std::vector<OperatingCondition> &all)
  {
    std::map<std::pair<std::optional<double>, std::optional<double>>,
             std::vector<std::size_t>>
      result;
    for (std::size_t k = 0; k < all.size(); ++k)
      result[{all[k].pressure, all[k].temperature}].push_back(k);
    return result;
  }
} // namespace squeal
