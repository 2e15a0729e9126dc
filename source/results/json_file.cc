// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/results/json_file.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace squeal
{
  namespace
  {
    template <typename Json>
    void
    require_finite(const Json        &json,
                   const std::string &place,
                   const std::string &path)
    {
      if (json.is_number_float() && !std::isfinite(json.template get<double>()))
        throw ComputationError("'" + path + "': " + place +
                               " is not a finite number");
      if (json.is_structured())
        for (const auto &[key, value] : json.items())
          require_finite(value, place + "/" + key, path);
    }

    template <typename Json>
    void
    write(const std::string &path, const Json &json)
    {
      require_finite(json, "", path);
      const std::string text =
        json.dump(2, ' ', false, Json::error_handler_t::replace);
      write_atomically(path, [&](std::ostream &out) { out << text << '\n'; });
    }
  } // namespace



  void
  write_json(const std::string &path, const nlohmann::ordered_json &json)
  {
    write(path, json);
  }

  void
  write_json(const std::string &path, const nlohmann::json &json)
  {
    write(path, json);
  }
} // namespace squeal
