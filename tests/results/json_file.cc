// SPDX-License-Identifier: LGPL-2.1-or-later
// A JSON file holds every number as it is, or is not written.
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/results/json_file.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

int
main()
{
  const std::string      path = "figures.json";
  nlohmann::ordered_json json = {{"b", 0.1}, {"a", {1, 2, nullptr}}};
  write_json(path, json);
  check(nlohmann::ordered_json::parse(read_file(path)) == json,
        "the file holds what was given");
  check(read_file(path).find("\"b\"") < read_file(path).find("\"a\""),
        "in the order given");

  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    {
      nlohmann::json worse = {
        {"images", {{{"length", 1.}}, {{"length", bad}}}}};
      check_throws<ComputationError>([&] { write_json(path, worse); },
                                     "/images/1/length is not a finite number",
                                     "a number that is none is refused");
      check(nlohmann::ordered_json::parse(read_file(path)) == json,
            "the older file stays");
    }

  write_json(path, nlohmann::json{{"name", "\xff"}});
  check(nlohmann::json::parse(read_file(path)).at("name") == "\xEF\xBF\xBD",
        "a text that is no UTF-8 is repaired");
}
