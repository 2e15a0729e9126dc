// SPDX-License-Identifier: LGPL-2.1-or-later

// Steady sliding by the program: what the scene does not have is no number of
// preload.json, one load has one secant stiffness however it is given, entries
// of a stiffness table that do nothing are refused, and half of a symmetric
// scene carries half the load. Argument: the program.

#include "program.h"

#include <nlohmann/json.hpp>

using namespace squeal::testing;

namespace
{
  std::string program;

  /** A pad of @p shape on an annulus that turns under it. */
  std::string
  scene(const std::string &pad, const std::string &top, const std::string &foot)
  {
    return R"(set Analysis         = preload
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = disc, pad
  set Supports = inner, top
  set Loads    = press
  set Contacts = c
  subsection Body disc
    set Shape        = annulus
    set Inner radius = 0.05
    set Outer radius = 0.12
    set Height       = 0.01
    set Position     = 0, 0, -0.01
    set Cells        = 16, 2, 1
  end
  subsection Body pad
    set Young modulus = 1e10
    set Density       = 2500
)" + pad +
           R"(  end
  subsection Support inner
    set Body = disc
    set Face = inner
  end
  subsection Support top
    set Body       = pad
    set Kind       = components
    set Components = x, y
    set Face       = )" +
           top + R"(
  end
  subsection Load press
    set Body = pad
    set Face = )" +
           top + R"(
  end
  subsection Contact c
    set Source body          = pad
    set Target body          = disc
    set Target face          = top
    set Formulation          = mortar
    set Contact state        = preload
    set Friction coefficient = 0.3
    set Friction direction   = slip
    set Sliding speed        = 1
    set Source face          = )" +
           foot + R"(
  end
end
subsection Discretization
  set Degree         = 2
  set Estimate error = false
end
subsection Eigenvalues
  set Highest frequency = 9000
end
subsection Preload
  set Load steps = 1
end
subsection Output
  set Plots  = false
  set Report = false
end
)";
  }

  std::string
  block_scene()
  {
    return scene("    set Size     = 0.02, 0.02, 0.01\n"
                 "    set Position = 0.09, 0, 0\n"
                 "    set Cells    = 2, 2, 1\n",
                 "z_max",
                 "z_min");
  }

  Outcome
  run(const std::string &text, const std::vector<std::string> &settings)
  {
    write_text("preload.prm", text);
    std::vector<std::string> words = {program};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("preload.prm");
    return run_program(words);
  }

  nlohmann::json
  result_of(const std::string &text, const std::vector<std::string> &settings)
  {
    const Outcome outcome = run(text, settings);
    check(outcome.code == 0, "the run ends well " + outcome.errors);
    return nlohmann::json::parse(text_of("out/preload.json"));
  }

  void
  ring()
  {
    const auto json = result_of(scene("    set Shape        = annulus\n"
                                      "    set Inner radius = 0.06\n"
                                      "    set Outer radius = 0.1\n"
                                      "    set Height       = 0.01\n"
                                      "    set Cells        = 16, 2, 1\n",
                                      "top",
                                      "bottom"),
                                {"Scene/Load press/Force = 0, 0, -1000"});
    check(json.at("leading_edge_factor").is_null(),
          "a ring has no leading edge: null");
    check_close(json.at("normal_n").get<double>(),
                1000.,
                1e-6,
                "and the normal force of its load");
    check(json.at("approach_m").get<double>() > 0.,
          "its far face approaches the disc");
  }

  void
  loads()
  {
    std::vector<double> stiffness;
    for (const auto &[force, pressure] : {std::make_pair("0, 0, -100", "0"),
                                          {"0, 0, 0", "250000"},
                                          {"0, 0, -50", "125000"},
                                          {"0, 30, -100", "0"}})
      stiffness.push_back(
        result_of(block_scene(),
                  {std::string("Scene/Load press/Force = ") + force,
                   std::string("Scene/Load press/Pressure = ") + pressure})
          .at("secant_stiffness_of_load_n_per_m")
          .get<double>());
    for (const double k : stiffness)
      check_close(k,
                  stiffness[0],
                  1e-6,
                  "secant stiffness to the load is that of the load pressing");
  }

  /** The depth of what has worn is arbitrary, and with it any approach. */
  void
  run_in()
  {
    std::vector<std::string> settings = {"Scene/Load press/Force = 0, 0, -100",
                                         "Preload/Run-in = archard"};
    const auto               json     = result_of(block_scene(), settings);
    for (const char *name : {"approach_m",
                             "secant_stiffness_n_per_m",
                             "approach_of_load_m",
                             "secant_stiffness_of_load_n_per_m"})
      check(json.at(name).is_null(),
            std::string(name) + " of worn faces: null");
    check_close(json.at("normal_n").get<double>(), 100., 1e-6, "their force");
    settings.insert(settings.end(),
                    {"Preload/Stiffness entry = Scene/Body pad/Young modulus",
                     "Preload/Stiffness values = 1e9, 1e10"});
    const Outcome outcome = run(block_scene(), settings);
    check(outcome.code != 0 &&
            unbroken(outcome.errors).find("'Run-in") != std::string::npos,
          "and no stiffness over a number of the scene: " + outcome.errors);
  }

  void
  entries_without_effect()
  {
    for (const auto &[entry, values, reason] :
         {std::make_tuple("Scene/Contact c/Normal force",
                          "50, 500",
                          "the loads of the scene press the pairs"),
          {"Scene/Contact c/Normal stiffness",
           "1e7, 1e9",
           "springs of the layout 'grid'"},
          {"Scene/Body pad/Temperature", "20, 200", "no 'Modulus table file'"},
          {"Scene/Body pad/Density", "2000, 3000", "as it stands"}})
      {
        const Outcome outcome =
          run(block_scene(),
              {"Scene/Load press/Force = 0, 0, -100",
               std::string("Preload/Stiffness entry = ") + entry,
               std::string("Preload/Stiffness values = ") + values});
        check(outcome.code != 0, std::string(entry) + " is refused");
        const std::string text = unbroken(outcome.errors);
        check(text.find("Preload/Stiffness entry") != std::string::npos &&
                text.find(reason) != std::string::npos,
              "and the reason said: " + text);
      }
    for (const auto &[entry, values] :
         {std::make_pair("Scene/Body pad/Young modulus", "1e9, 1e10"),
          {"Scene/Contact c/Friction coefficient", "0.1, 0.3"}})
      check(run(block_scene(),
                {"Scene/Load press/Force = 0, 0, -100",
                 std::string("Preload/Stiffness entry = ") + entry,
                 std::string("Preload/Stiffness values = ") + values})
                .code == 0,
            std::string(entry) + " has an effect");
  }

  /** A pad that slides over a floor along y, whole or one half of it, held
   * along x where it is cut. */
  std::string
  cut_scene(const bool is_half)
  {
    const std::string more = is_half ? R"(
  subsection Support pad_cut
    set Body       = pad
    set Face       = x_min
    set Kind       = components
    set Components = x
  end
  subsection Support floor_cut
    set Body       = floor
    set Face       = x_min
    set Kind       = components
    set Components = x
  end
)"
                                     : "";
    const std::string x = is_half ? "0.005" : "0", n = is_half ? "2" : "4",
                      width       = is_half ? "0.01" : "0.02",
                      floor_x     = is_half ? "0.01" : "0",
                      floor_width = is_half ? "0.02" : "0.04";
    return R"(set Analysis         = preload
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = floor, pad
  set Springs  = along, across
  set Loads    = press
  set Contacts = c
  set Supports = ground)" +
           std::string(is_half ? ", pad_cut, floor_cut\n" : "\n") +
           "  subsection Body floor\n    set Size = " + floor_width +
           ", .05, .02\n    set Position = " + floor_x +
           ", 0, -.02\n    set Cells = " + n +
           ", 3, 1\n  end\n  subsection Body pad\n    set Size = " + width +
           ", .02, .01\n    set Position = " + x +
           ", 0, 0\n    set Cells = " + n + R"(, 3, 1
    set Young modulus = 1e10
    set Density       = 2500
  end
  subsection Support ground
    set Body = floor
    set Face = z_min
  end
  subsection Spring along
    set Kind      = area
    set Body      = pad
    set Face      = z_max
    set Direction = 0, 1, 0
    set Stiffness = 1e10
  end
  subsection Spring across
    set Kind      = area
    set Body      = pad
    set Face      = z_max
    set Direction = 1, 0, 0
    set Stiffness = 1e8
  end
  subsection Load press
    set Body = pad
    set Face = z_max
    set Pressure = 1e6
  end
  subsection Contact c
    set Source body          = pad
    set Source face          = z_min
    set Target body          = floor
    set Target face          = z_max
    set Formulation          = mortar
    set Contact state        = preload
    set Friction coefficient = 0.3
    set Sliding speed        = 1
  end
)" + more + R"(end
subsection Discretization
  set Degree         = 2
  set Estimate error = false
end
subsection Eigenvalues
  set Highest frequency = 20000
end
subsection Preload
  set Load steps = 1
end
subsection Output
  set Plots  = false
  set Report = false
end
)";
  }

  void
  symmetry_plane()
  {
    for (const std::string formulation : {"mortar", "node to surface"})
      {
        const std::vector<std::string> settings = {
          "Scene/Contact c/Formulation = " + formulation};
        const auto whole = result_of(cut_scene(false), settings),
                   half  = result_of(cut_scene(true), settings);
        for (const char *name : {"normal_n", "tangential_n"})
          check_close(2. * half.at(name).get<double>(),
                      whole.at(name).get<double>(),
                      1e-6,
                      formulation + ": two halves carry the whole, " + name);
        for (const char *name :
             {"leading_edge_factor", "peak_pressure_pa", "approach_m"})
          check_close(half.at(name).get<double>(),
                      whole.at(name).get<double>(),
                      1e-6,
                      formulation + ": half is as the whole, " + name);
      }
  }

  /** A block that stands on a floor, pressed by 100 N; nothing but friction
   * holds it along the face, 30 N at most. */
  const std::string standing_block = R"(set Analysis         = preload
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = floor, block
  set Supports = ground
  set Loads    = press, pull
  set Contacts = c
  subsection Body floor
    set Size          = 0.04, 0.06, 0.004
    set Position      = 0, 0, -0.004
    set Young modulus = 1e13
  end
  subsection Body block
    set Size          = 0.02, 0.03, 0.004
    set Position      = 0, 0, 0
    set Young modulus = 1e13
  end
  subsection Support ground
    set Body = floor
    set Face = z_min
  end
  subsection Load press
    set Body  = block
    set Face  = z_max
    set Force = 0, 0, -100
  end
  subsection Load pull
    set Body  = block
    set Face  = z_max
    set Force = 0, 20, 0
  end
  subsection Contact c
    set Source body          = block
    set Source face          = z_min
    set Target body          = floor
    set Target face          = z_max
    set Grid                 = 5, 7
    set Normal stiffness     = 1e6
    set Tangential stiffness = 4e5
    set Contact state        = preload
    set Friction coefficient = 0.3
    set Friction direction   = given
    set Sliding direction    = 0, 1, 0
    set Sliding speed        = 0
  end
end
subsection Discretization
  set Degree         = 1
  set Estimate error = false
end
subsection Output
  set Plots  = false
  set Report = false
end
)";

  void
  held_by_friction()
  {
    const auto json = result_of(standing_block, {});
    check_close(json.at("normal_n").get<double>(), 100., 1e-8, "it is pressed");
    check_close(std::abs(json.at("tangential_n").get<double>()),
                20.,
                1e-8,
                "friction alone holds it along the face");
    const Outcome outcome =
      run(standing_block, {"Scene/Load pull/Force = 0, 31, 0"});
    check(outcome.code == 3 &&
            unbroken(outcome.errors).find("more pulls at one along the face") !=
              std::string::npos,
          "and more than it holds has no solution: " + outcome.errors);
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "the program is given");
  program = argv[1];
  ring();
  loads();
  run_in();
  entries_without_effect();
  symmetry_plane();
  held_by_friction();
}
