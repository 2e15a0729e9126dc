// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/numbers.h>
#include <squeal/scene/modulus_table.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  ModulusTables::ModulusTables(const SceneParameters &scene)
    : of_body(scene.bodies.size())
  {
    for (std::size_t b = 0; b < of_body.size(); ++b)
      if (const std::string &file = scene.bodies[b].modulus_table_file;
          !file.empty())
        {
          auto &table = of_file[file];
          if (!table)
            table = std::make_shared<const ModulusTable>(file);
          of_body[b] = table;
        }
  }

  bool
  ModulusTables::depend_on_frequency() const
  {
    return std::any_of(of_file.begin(), of_file.end(), [](const auto &table) {
      return table.second->depends_on_frequency();
    });
  }

  bool
  ModulusTables::depend_on_pressure(const BodyParameters &body) const
  {
    const auto table = of_file.find(body.modulus_table_file);
    return table != of_file.end() && table->second->depends_on_pressure();
  }

  bool
  ModulusTables::empty() const
  {
    return std::none_of(of_body.begin(), of_body.end(), [](const auto &table) {
      return bool(table);
    });
  }

  SceneParameters
  ModulusTables::at(const SceneParameters &scene, const double f) const
  {
    SceneParameters result = scene;
    for (std::size_t b = 0; b < of_body.size(); ++b)
      if (of_body[b])
        {
          auto                &body = result.bodies[b];
          const ComplexModulus m =
            of_body[b]->at(f,
                           body.temperature,
                           body.pressure,
                           BodyParameters::ModulusExtrapolation::constant);
          body.young_modulus     = m.storage;
          body.table_loss_factor = m.loss_factor;
        }
    return result;
  }

  void
  ModulusTables::require_band(const SceneParameters &scene,
                              const double           lowest,
                              const double           highest) const
  {
    for (std::size_t b = 0; b < of_body.size(); ++b)
      if (of_body[b])
        for (const double f : {lowest, highest})
          try
            {
              const auto &body = scene.bodies[b];
              if (body.pressure != 0. && !of_body[b]->depends_on_pressure())
                throw InputError(
                  "'Pressure' = " + prm::format_number(body.pressure) +
                  ", but the modulus table '" + body.modulus_table_file +
                  "' has no column pressure_Pa");
              of_body[b]->at(
                f, body.temperature, body.pressure, body.modulus_extrapolation);
            }
          catch (const InputError &error)
            {
              throw InputError("body '" + scene.bodies[b].name +
                               "': " + error.what());
            }
  }



  double
  reference_frequency(const EigenParameters &band)
  {
    return band.lowest_frequency > 0.
             ? std::sqrt(band.lowest_frequency * band.highest_frequency)
             : 0.1 * band.highest_frequency;
  }

  void
  take_modulus_tables(Parameters &parameters)
  {
    const ModulusTables tables(parameters.scene);
    if (tables.empty())
      return;
    const EigenParameters &band = parameters.eigen;
    tables.require_band(
      parameters.scene, band.lowest_frequency, band.highest_frequency);
    parameters.scene = tables.at(parameters.scene, reference_frequency(band));
  }
} // namespace squeal
