// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Any number of a scene can be read and changed by its path, with the same
// checks as in a file.
#include <squeal/parameters/number_access.h>

#include "describe.h"
#include "example_scene.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string pad_modulus = "Scene/Body pad/Young modulus";

  void
  reading(const Parameters &p)
  {
    check(get_number(p, pad_modulus) == p.scene.bodies[1].young_modulus,
          "number of a body");
    check(get_number(p, " Scene / Body pad/ Young modulus") ==
            p.scene.bodies[1].young_modulus,
          "blanks in the path");
    check(get_number(p, "Scene/Contact pad_disc/Friction coefficient") == 0.5,
          "number of a contact");
    check(get_number(p, "Discretization/Degree") == 3., "whole number");
    check(get_number(p, "Scene/Body disc/Position[3]") == -0.01,
          "component of a vector");
  }



  void
  unknown_paths(const Parameters &p)
  {
    const auto refused = [&](const std::string              &path,
                             const std::vector<std::string> &parts) {
      check_refused([&]() { get_number(p, path); }, parts, path);
      check_refused([&]() { with_value(p, path, 1.); }, parts, path);
    };
    refused("Scene/Body pad/Young modulos",
            {"unknown entry 'Scene/Body pad/Young modulos'",
             "did you mean 'Scene/Body pad/Young modulus'?"});
    refused("Scene/Body pda/Density",
            {"did you mean 'Scene/Body pad/Density'?"});
    refused("", {"unknown entry ''"});
    refused("Scene/Body pad/Shape", {"not a number"});
    refused("Scene/Body pad/Mesh file", {"not a number"});
    refused("Scene/Body pad/Size", {"is a list", "'Scene/Body pad/Size[1]'"});
    refused("Scene/Body pad/Size[4]", {"no component [4]"});
    refused("Scene/Body pad/Size[0]", {"counted from [1]"});
    refused("Scene/Body pad/Density[2]", {"no component [2]"});
  }



  void
  changing(const Parameters &p)
  {
    const Parameters changed = with_value(p, pad_modulus, 1e9);
    check(changed.scene.bodies[1].young_modulus == 1e9, "the struct follows");
    check(get_number(changed, pad_modulus) == 1e9, "the entry follows");
    check(p.scene.bodies[1].young_modulus != 1e9, "the original stays");

    const std::vector<std::string> before = describe(p);
    const std::vector<std::string> after  = describe(changed);
    unsigned int                   n      = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
      n += before[i] != after[i] ? 1 : 0;
    check(before.size() == after.size() && n == 1, "nothing else changes");
    check(describe(with_value(
            changed, pad_modulus, p.scene.bodies[1].young_modulus)) == before,
          "there and back is exact");

    const Parameters moved = with_value(p, "Scene/Load top/Force[1]", 0.1);
    check(moved.scene.loads[0].force == Vector3{{0.1, 0., -100.}},
          "one component of a list");

    const auto entries = changed_entries(
      p,
      {"Scene/Load top/Force[1]", pad_modulus, "Scene/Load top/Force[2]"},
      {.1, 1e9, .2});
    check(entries ==
            std::map<std::string, std::string>{
              {"Scene/Load top/Force", "0.1, 0.2, -100"}, {pad_modulus, "1e9"}},
          "as written: of a list all components");
  }



  void
  values_that_are_not_allowed(const Parameters &p)
  {
    const auto refused = [&](const std::string &path,
                             const double       value,
                             const std::string &part) {
      check_refused([&]() { with_value(p, path, value); },
                    {"example.prm", part},
                    path + " = " + std::to_string(value));
    };
    refused(pad_modulus, -1., "greater than 0");
    refused(pad_modulus, std::nan(""), "greater than 0");
    refused("Discretization/Degree", 2.5, "whole number");
    refused(
      "Scene/Body disc/Inner radius", 0.13, "greater than 'Inner radius'");
    refused("Scene/Body disc/Height", 0.02, "faces do not meet");
  }
} // namespace

int
main()
{
  const Parameters p = read_parameters(write_example());
  reading(p);
  unknown_paths(p);
  changing(p);
  values_that_are_not_allowed(p);
}
