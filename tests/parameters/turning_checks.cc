// SPDX-License-Identifier: LGPL-2.1-or-later

// What `Analysis = angles` may turn: bodies about one line, with all that is
// glued to them.

#include "example_scene.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  void
  check_change_refused(const std::vector<std::string> &overrides,
                       const std::vector<std::string> &parts)
  {
    check_override_refused("example.prm", overrides, parts, overrides.back());
  }



  /** Bodies that turn as one have one axis, which is a line. */
  void
  turning_lines()
  {
    const std::vector<std::string> turning = {"Analysis = angles",
                                              "Angles/Turning bodies = disc, "
                                              "pad, support",
                                              "Scene/Body support/Rotation "
                                              "centre = 0, 0, 0",
                                              "Angles/To = 10"};
    const auto with = [&](const std::vector<std::string> &changes) {
      std::vector<std::string> result = turning;
      result.insert(result.end(), changes.begin(), changes.end());
      return result;
    };
    check_change_refused(turning,
                         {"'Angles/Turning bodies'", "Rotation centre"});
    check_change_refused(with({"Scene/Body pad/Rotation axis = 1, 0, 0"}),
                         {"'Angles/Turning bodies'", "Rotation axis"});
    read_parameters("example.prm",
                    with({"Scene/Body disc/Rotation centre = 0, 0, 0",
                          "Scene/Body pad/Rotation centre = 0, 0, 0.02"}))
      .check();
  }



  /** What is glued turns as one, whatever is named of it. */
  void
  turned_as_one()
  {
    const auto turning = [](const std::string              &bodies,
                            const std::vector<std::string> &more) {
      std::vector<std::string> result = {"Analysis = angles", "Angles/To = 10"};
      result.insert(result.end(), more.begin(), more.end());
      result.push_back("Angles/Turning bodies = " + bodies);
      return result;
    };
    check_change_refused(
      turning("pad", {}),
      {"'Angles/Turning bodies'", "leaves out 'support'", "'pad'"});
    const std::vector<std::string> layer = {
      "Scene/Bodies = disc, pad, support, shim",
      "Scene/Body shim/Shape = layer",
      "Scene/Body shim/Layer body = disc",
      "Scene/Body shim/Layer face = bottom"};
    read_parameters("example.prm", turning("disc", layer)).check();
    check_change_refused(
      turning("disc, shim", layer),
      {"'Angles/Turning bodies'", "contains the layer 'shim'"});
    check_change_refused(
      turning("disc", {"Scene/Body disc/Rotation centre = 0.03, 0, 0"}),
      {"'Scene/Body disc/Rotation centre'", "Analysis = angles"});
  }
} // namespace



int
main()
{
  write_example();
  turning_lines();
  turned_as_one();
}
