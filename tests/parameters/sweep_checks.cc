// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What is wrong with a sweep is said in one line that names the entry.
#include <squeal/base/exceptions.h>
#include <squeal/parameters/parameters.h>
#include <squeal/sweep/sweep_grid.h>

#include "check.h"
#include "source_directory.h"

#include <string>
#include <vector>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string file =
    SQUEAL_SOURCE_DIR "/prm/tribobrake/stability_map.prm";

  void
  refused(const std::vector<std::string> &overrides,
          const std::string              &part,
          const std::string              &text)
  {
    check_throws<InputError>(
      [&]() { read_parameters(file, overrides).check(); }, part, text);
  }

  void
  faults()
  {
    refused({"Sweep/Axis e_pad/Entries = Scene/Body pad/Yung modulus"},
            "did you mean 'Scene/Body pad/Young modulus'",
            "an unknown entry is told with the nearest name");
    refused({"Sweep/Axis e_pad/Entries = Scene/Body pad/Shape"},
            "is not a number",
            "an entry that is no number");
    refused({"Sweep/Axis e_pad/Entries = Discretization/Degree"},
            "only numbers of the scene",
            "an entry outside the scene");
    refused({"Sweep/Axis e_pad/Entries ="}, "is empty", "an axis of nothing");
    refused({"Sweep/Axis mu/Entries = Scene/Body pad/Young modulus"},
            "is swept already",
            "one entry on two axes");
    refused({"Sweep/Axis mu/Entries = Scene/Body disc/Rotation speed"},
            "one sign in both",
            "turning of a body that stands still in the scene");
    const std::string contact    = "Scene/Contact pad_disc/",
                      slip       = contact + "Transverse slip term = true",
                      turning    = "Scene/Body disc/Rotation speed",
                      sliding    = contact + "Sliding speed",
                      axis       = "Sweep/Axis mu/Entries = ",
                      scale      = "Sweep/Axis mu/Scale = list",
                      in_scene[] = {turning + " = 10", sliding + " = 1"};
    for (const std::string &alone : {turning, sliding})
      refused({in_scene[0], in_scene[1], slip, axis + alone},
              "on one axis",
              "one of two speeds of one motion");
    refused({in_scene[0], in_scene[1], axis + contact + "Friction slope"},
            "which is 0 in the scene",
            "a first term of the slip rate of a body that turns");
    const auto both = [&](const std::string &values) {
      return std::vector<std::string>{in_scene[0],
                                      in_scene[1],
                                      slip,
                                      scale,
                                      axis + turning + ", " + sliding,
                                      "Sweep/Axis mu/Values = 1, 2",
                                      "Sweep/Axis mu/Entry values = " + values};
    };
    refused(both("10, 20, 1, 1.5"),
            "not in the ratio",
            "two speeds that part on the way");
    read_parameters(file, both("10, 20, 1, 2")).check();
    refused({"Scene/Contact pad_disc/Contact state = preload",
             "Sweep/Axis e_pad/Entries = Scene/Contact pad_disc/Normal force"},
            "has no effect",
            "a normal force that the loads decide");
    const std::vector<std::string> suggest = {
      "Sweep/Suggestions = 1",
      "Sweep/Sensitivities = Scene/Body pad/Young modulus"};
    read_parameters(file, suggest).check();
    refused({suggest[0],
             suggest[1],
             "Scene/Contact pad_disc/Contact state = preload"},
            "Suggestions",
            "changes that open points of the contact");
    refused(
      {"Sweep/Axis e_pad/From = -1e9"}, "Axis e_pad", "a negative stiffness");
    refused({"Sweep/Axis e_pad/From = 1e11"},
            "nothing to sweep",
            "a range without length");
    refused({"Sweep/Axis e_pad/From = 1e9, 2e9"},
            "has 2 numbers",
            "more ends than entries");
    refused({"Sweep/Axis mu/Values ="}, "is empty", "a list without values");
    refused({"Sweep/Axis mu/Values = 0.1, 0.2",
             "Sweep/Axis mu/Entry values = 0.1, 0.2, 0.3"},
            "give 2",
            "values of the entries that are not as many as the list has");
    refused({"Sweep/Axis e_pad/Entry values = 1e9, 1e11"},
            "'Scale = list'",
            "values of the entries without a list");
    refused(
      {"Sweep/Axis mu/Values = 0.2, 0.1"}, "must ascend", "a list that falls");
    refused(
      {"Sweep/Axis e_pad/Number = 10000000", "Sweep/Axis mu/Values = 0.1, 0.2"},
      "Number",
      "more values than allowed");
    refused(
      {"Sweep/Sensitivities = Scene/Contact pad_disk/Friction coefficient"},
      "did you mean",
      "an unknown sensitivity");
  }

  /** How an axis scatters. */
  void
  distributions()
  {
    const std::string pad    = "Sweep/Axis e_pad/";
    const auto        normal = [&](const std::vector<std::string> &more) {
      std::vector<std::string> all = {"Sweep/Scatter samples = 10",
                                      pad + "Distribution = normal"};
      for (const auto &entry : more)
        all.push_back(pad + entry);
      return all;
    };
    refused(normal({"Mean = 10"}),
            "needs a 'Deviation'",
            "a mean that would have no effect");
    refused({pad + "Mean = 10"}, "'uniform'", "a mean of what is uniform");
    refused(
      {pad + "Deviation = 0.1"}, "'uniform'", "a deviation of what is uniform");
    refused(normal({"Mean = 1e10", "Deviation = 0.1"}),
            "common logarithms",
            "the mean of a logarithmic axis as a value");
    refused(normal({"Mean = 12", "Deviation = 0.3"}),
            "less than 0.1 %",
            "an axis more than three deviations off");
    read_parameters(file, normal({"Mean = 11.5", "Deviation = 0.3"})).check();
    read_parameters(file, normal({})).check();
    check(true, "others are taken");
  }

  /** Its values are 0.1 apart, and rounding leaves -1.4e-17 in place of 0. */
  void
  zero_is_a_value()
  {
    const std::string  mu = "Sweep/Axis mu/";
    const SweepGrid    grid(read_parameters(file,
                                         {mu + "Scale = linear",
                                             mu + "Values =",
                                             mu + "From = -0.1",
                                             mu + "To = 0.5",
                                             mu + "Number = 7"}));
    const unsigned int a = grid.axis(0).name == "mu" ? 0 : 1;
    check(grid.coordinates(a)[1] == 0., "zero between ends of either sign");
    check(entry_value(grid.axis(a), 0, 1. / 6.) == 0., "for every entry");
    check(grid.coordinates(a)[0] == -0.1 && grid.coordinates(a)[6] == 0.5,
          "the ends as they are");
  }

  void
  setter()
  {
    const Parameters p = read_parameters(file);
    NumberSetter     set(p,
                     {"Scene/Body pad/Young modulus",
                          "Scene/Contact pad_disc/Friction coefficient"});
    const auto      &scene = set.scene({3.25e9, 0.123});
    const Parameters slow =
      with_value(with_value(p, "Scene/Body pad/Young modulus", 3.25e9),
                 "Scene/Contact pad_disc/Friction coefficient",
                 0.123);
    check(scene.bodies[1].young_modulus == slow.scene.bodies[1].young_modulus &&
            scene.contacts[0].friction_coefficient ==
              slow.scene.contacts[0].friction_coefficient &&
            scene.bodies[0].young_modulus == slow.scene.bodies[0].young_modulus,
          "the quick way to a scene is the slow one");
    check(set.scene({1e10, 0.3}).bodies[1].young_modulus == 1e10,
          "values are set again");

    NumberSetter components(
      p, {"Scene/Body pad/Position[3]", "Scene/Body pad/Position[1]"});
    for (const double x : {.5, .25})
      check(components.scene({2. * x, x}).bodies[1].position ==
              Vector3{{x, p.scene.bodies[1].position[1], 2. * x}},
            "components of one list move together");
  }
} // namespace

int
main()
{
  faults();
  distributions();
  zero_is_a_value();
  setter();
}
