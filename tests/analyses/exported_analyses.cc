// SPDX-License-Identifier: LGPL-2.1-or-later

// Imported matrices in the analyses that exported_scenes leaves: a sweep whose
// contact changes, frequency responses, limit cycles, the comparison of a
// transient with eigenvalues, the implicit integrator and updating give what
// the scene of bodies gives; what matrices lack is refused in one line, before
// any work, and so are tables that are wrong, with file and line. Arguments:
// squeal, part.

#include "exported_scenes.h"

#include <filesystem>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Settings = std::vector<std::string>;

  std::string program;

  // Tolerances below what both are compared to: the rounding of the matrices
  // decides on what a basis keeps.
  const std::string sweep  = R"(subsection Sweep
  set Axes                = mu
  set Frequency tolerance = 1e-9
  set Sigma tolerance     = 1e-6
  subsection Axis mu
    set Entries = Scene/Contact above/Friction coefficient
    set From    = 0.2
    set To      = 0.6
    set Number  = 3
  end
end
)",
                    points = R"(subsection Measurement
  set Points = middle, pin
  subsection Point middle
    set Body      = beam
    set Position  = 0, 0.016, -0.010
    set Direction = 0, 0, 1
  end
  subsection Point pin
    set Body      = upper
    set Position  = 0.005, 0.005, 0
    set Direction = 0, 1, 1
  end
end
subsection Frequency response
  set Contact states = stick, full
  set Number         = 41
end
)",
                    fit    = R"(subsection Measurement
  set Frequencies file = measured.csv
end
subsection Updating
  set Numbers = stiffness
  subsection Number stiffness
    set Entries = Scene/Matrix part stiffness/Factor
    set Lower   = 0.5
    set Upper   = 2
  end
end
)";

  const std::string pins     = squealing_pins(),
                    imported = "include own/matrices/scene.prm\n";

  void
  run(const std::string &scene,
      const std::string &analysis,
      const std::string &directory,
      const Settings    &settings = {})
  {
    run_scene(program, scene, analysis, directory, settings);
  }

  void
  check_linear()
  {
    const Settings lowest = {"Eigenvalues/Highest frequency = 3000"};
    run(pins + sweep, "sweep", "own_sweep", lowest);
    run(imported + sweep, "sweep", "other_sweep", lowest);
    // As far as the reduced bases of both are certified.
    check_same("own_sweep/eigenvalues.csv",
               "other_sweep/eigenvalues.csv",
               {"sigma_per_s", "frequency_hz"},
               1e-6);
    check_same("own_sweep/eigenvalues.csv",
               "other_sweep/eigenvalues.csv",
               {"closed_points"},
               0.);
    run(pins + points, "frequency response", "own_response");
    run(imported + points, "frequency response", "other_response");
    check_same("own_response/frequency_response.csv",
               "other_response/frequency_response.csv",
               {"real", "imag"},
               1e-9);
  }

  /** Frequencies of the matrices; the fit starts from 0.9 of them. */
  void
  check_updating()
  {
    const Settings full = {"Scene/Contact above/Contact state = full",
                           "Scene/Contact below/Contact state = full"};
    run(imported, "cea", "twin", full);
    const Table table = read_csv("twin/eigenvalues.csv");
    std::string text  = "name,frequency_hz,weight\n";
    for (std::size_t i = 0; i < 4; ++i)
      text += table.text(i, "name") + "," +
              shortest_text(table.real(i, "frequency_hz")) + ",1\n";
    write_text("measured.csv", text);
    Settings start = full;
    start.push_back("Scene/Matrix part stiffness/Factor = 0.9");
    run(imported + fit, "updating", "updated", start);
    const double factor =
      read_csv("updated/updated_numbers.csv").real(0, "value");
    check(std::abs(factor - 1.) <= 1e-6,
          "fitted factor of the stiffness " + std::to_string(factor));
  }

  /** The cycles start from strokes at points of their own, nodes or corners of
   * cells, so that each may be found as several periods of one motion: the same
   * within the errors that are stated. */
  void
  check_same_motion(const Table &a, const Table &b)
  {
    const double f = a.real(0, "frequency_hz"), g = b.real(0, "frequency_hz"),
                 df = a.real(0, "frequency_error_hz"),
                 dg = b.real(0, "frequency_error_hz");
    bool is_same    = false;
    for (int m = 1; m <= 4; ++m)
      for (int n = 1; n <= 4; ++n)
        is_same = is_same || std::abs(m * f - n * g) <= m * df + n * dg;
    check(is_same,
          "frequency of the limit cycle: " + std::to_string(f) + " +- " +
            std::to_string(df) + ", " + std::to_string(g) + " +- " +
            std::to_string(dg));
    for (const std::string force : {"mean", "rms", "min", "max"})
      {
        const auto off = [&](const Table &t) {
          return t.real(0, force + "_normal_error_n");
        };
        check(std::abs(a.real(0, force + "_normal_n") -
                       b.real(0, force + "_normal_n")) <= off(a) + off(b),
              "its " + force + " normal force");
      }
  }

  void
  check_motions()
  {
    run(pins, "limit cycle", "own_cycle");
    run(imported, "limit cycle", "other_cycle");
    check_same("own_cycle/limit_cycle.csv",
               "other_cycle/limit_cycle.csv",
               {"pair_frequency_hz", "pair_sigma_per_s"},
               1e-9);
    check_same_motion(read_csv("own_cycle/limit_cycle.csv"),
                      read_csv("other_cycle/limit_cycle.csv"));
    const Settings with_cea = {"Transient/Compare with CEA = true",
                               "Transient/End time = 0.006"};
    run(pins, "transient", "own_compared", with_cea);
    run(imported, "transient", "other_compared", with_cea);
    check_same("own_compared/branches.csv",
               "other_compared/branches.csv",
               {"sigma_cea_per_s", "frequency_cea_hz"},
               1e-9);
  }

  /** Pins that cannot enter, from rest: the same motion in all unknowns. */
  void
  check_implicit()
  {
    const Settings settings  = {"Transient/Integrator = implicit",
                                "Transient/Compare with CEA = false",
                                "Transient/Start = ramp",
                                "Transient/Disturbance = 0",
                                "Transient/History start = 0",
                                "Transient/End time = 0.001",
                                "Scene/Load press_up/Ramp time = 0.004",
                                "Scene/Load press_low/Ramp time = 0.004"};
    Settings       exporting = settings;
    exporting.push_back("Output/Export matrices = true");
    run(two_pins, "transient", "own_implicit", exporting);
    run("include own_implicit/matrices/scene.prm\n",
        "transient",
        "other_implicit",
        settings);
    check_same("own_implicit/forces.csv",
               "other_implicit/forces.csv",
               {"normal_n", "tangential_n"},
               1e-9);
  }

  void
  check_refused(const std::string &scene,
                const std::string &analysis,
                const Settings    &settings,
                const std::string &text)
  {
    std::filesystem::remove_all("refused");
    const Outcome o = outcome_of(program, scene, analysis, "refused", settings);
    check(o.code == 2, "exit code of a refusal: " + std::to_string(o.code));
    check(o.errors.find(text) != std::string::npos &&
            o.errors.find('\n') == o.errors.size() - 1,
          "'" + text + "' in one line: " + o.errors);
    check(!std::filesystem::exists("refused"), "nothing is written");
  }

  void
  check_refusals()
  {
    check_refused(imported, "angles", {}, "turns meshes");
    check_refused(
      imported,
      "work precision",
      {"Work precision/Ladders = refinement", "Work precision/Values = 0, 1"},
      "imported matrices have no mesh");
    check_refused(imported,
                  "transient",
                  {"Transient/Integrator = explicit"},
                  "lumped masses");
    check_refused(imported,
                  "transient",
                  {"Transient/Animation frames = 9"},
                  "no mesh to draw");
    check_refused(imported,
                  "transient",
                  {"Transient/Hammer/Body = upper"},
                  "no face to strike");
    for (const char *analysis : {"cea", "sweep"})
      check_refused(imported + sweep,
                    analysis,
                    {"Scene/Contact above/Formulation = mortar"},
                    "must be springs");
    const std::string damped =
      "include own/matrices/scene.prm\n"
      "subsection Scene\n  subsection Matrix part damping\n"
      "    set File = own/matrices/damping.mtx\n    set Role = damping\n"
      "  end\nend\n";
    const Settings parts = {"Scene/Matrix parts = mass, stiffness, damping"};
    check_refused(damped, "transient", parts, "C = alpha M + beta K");
    check_refused(damped, "limit cycle", parts, "C = alpha M + beta K");
    Settings friction = parts;
    friction.push_back("Scene/Matrix part damping/Role = friction");
    check_refused(damped, "cea", friction, "without 'Contacts'");
    const std::string place = "Measurement/Point pin/Position = 0, 0, 0.013";
    const Outcome     o     = outcome_of(
      program, imported + points, "frequency response", "beside", {place});
    check(o.code == 2 && o.errors.find("is at no node of 'upper': the nearest "
                                       "is ") != std::string::npos,
          "a point beside all nodes: " + o.errors);
  }

  /** The line that begins with @p start in a copy of a table is changed by
   * @p change, or left out where that returns nothing. */
  void
  check_bad_table(const std::string                                     &file,
                  const std::string                                     &start,
                  const std::function<std::string(const std::string &)> &change,
                  const std::string                                     &text)
  {
    std::filesystem::remove_all("bad");
    std::filesystem::copy("own/matrices", "bad");
    std::istringstream in(text_of("bad/" + file));
    std::string        result, line;
    unsigned int       n_changed = 0;
    while (std::getline(in, line))
      if (line.rfind(start, 0) != 0)
        result += line + '\n';
      else
        {
          const std::string changed = change(line);
          ++n_changed;
          if (!changed.empty())
            result += changed + '\n';
        }
    check(n_changed > 0, "a line '" + start + "' in " + file);
    write_text("bad/" + file, result);
    const Outcome o =
      outcome_of(program, "include bad/scene.prm\n", "preload", "refused");
    check(o.code == 2 && o.errors.find(text) != std::string::npos &&
            o.errors.find("bad/" + file) != std::string::npos &&
            o.errors.find('\n') == o.errors.size() - 1,
          "'" + text + "' in one line: " + o.errors);
  }

  /** With another field of a line of comma-separated values. */
  std::function<std::string(const std::string &)>
  field(const unsigned int number, const std::string &value)
  {
    return [number, value](const std::string &line) {
      std::istringstream in(line);
      std::string        result, cell;
      for (unsigned int i = 0; std::getline(in, cell, ','); ++i)
        result += (i > 0 ? "," : "") + (i == number ? value : cell);
      return result;
    };
  }

  void
  check_bad_tables()
  {
    const auto gone = [](const std::string &) { return std::string(); };
    const auto transverse_only_gone = [](const std::string &line) {
      return line.find("transverse") != std::string::npos ? "" : line;
    };
    check_bad_table("contact.csv",
                    "above,1,target,normal",
                    gone,
                    "has weights of target and source in some of its rows");
    check_bad_table("contact.csv",
                    "above,2,target,transverse",
                    gone,
                    "has weights of target and source in some of its rows");
    check_bad_table(
      "contact.csv", "above,2,", transverse_only_gone, "has no transverse row");
    check_bad_table("contact.csv",
                    "above,6,source,normal",
                    field(5, "0.5"),
                    "do not add up to the same");
    check_bad_table("contact.csv", "below,", gone, "has no pair");
    check_bad_table(
      "contact.csv", "above,3,source,normal", field(5, "nan"), "contact.csv:");
    check_bad_table("contact.csv",
                    "above,3,source,sliding",
                    field(4, "999999"),
                    "does not exist");
    check_bad_table("contact.csv",
                    "above,4,",
                    field(9, "-1e-6"),
                    "the area must be positive");
    check_bad_table(
      "contact.csv", "above,5,", field(0, "aside"), "'Scene/Contacts'");
    check_bad_table("nodes.csv", "7,", gone, "");
    check_bad_table("nodes.csv", "7,", field(7, "inf"), "nodes.csv:8");
    check_bad_table("nodes.csv", "dof,", field(7, "load_x"), "load_press_up");
    check_bad_table("nodes.csv", "7,", field(0, "8"), "given twice");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 3, "arguments: squeal, part");
  program                = argv[1];
  const std::string part = argv[2];
  run(pins, "preload", "own", {"Output/Export matrices = true"});
  if (part == "linear")
    {
      check_linear();
      check_updating();
    }
  else if (part == "motions")
    {
      check_motions();
      check_implicit();
    }
  else
    {
      check(part == "refusals", "part: linear, motions or refusals");
      check_refusals();
      check_bad_tables();
    }
}
