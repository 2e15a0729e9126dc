// SPDX-License-Identifier: LGPL-2.1-or-later

// A scene that is exported with open contacts and imported again is the same
// in every analysis: steady sliding, eigenvalues about it, motion in time, and
// the damage that it does. Steady sliding does not depend on how many modes it
// is computed with. The TriboBrake with a coarse mesh, whose tie takes
// unknowns out, and two pins on two sides of a beam. Arguments: squeal,
// squeal-tribology, the folder of parameter files.

#include "exported_scenes.h"

#include <squeal/base/files.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program, damage_program, prm;

  void
  run(const std::string              &scene,
      const std::string              &analysis,
      const std::string              &directory,
      const std::vector<std::string> &settings = {})
  {
    run_scene(program, scene, analysis, directory, settings);
  }

  /** Both complex numbers of every pair over its modulus. */
  void
  check_eigenvalues(const std::string &a, const std::string &b)
  {
    const Table s = read_csv(a + "/eigenvalues.csv"),
                t = read_csv(b + "/eigenvalues.csv");
    check(s.n_rows() == t.n_rows() && s.n_rows() > 3, "as many pairs");
    Worst worst;
    for (std::size_t i = 0; i < s.n_rows(); ++i)
      worst.add(
        std::hypot(s.real(i, "sigma_per_s") - t.real(i, "sigma_per_s"),
                   2. * M_PI *
                     (s.real(i, "frequency_hz") - t.real(i, "frequency_hz"))) /
        (2. * M_PI * s.real(i, "frequency_hz")));
    check(worst.largest() <= 1e-9,
          "eigenvalues of " + b + " differ by " +
            std::to_string(worst.largest() / 1e-12) + "e-12");
  }

  std::string
  damage_of(const std::string &history, const std::string &directory)
  {
    write_text("damage.prm",
               "set Analysis = damage\nset Output directory = " + directory +
                 "\nset Overwrite = true\nsubsection History\n"
                 "  set File = " +
                 history + "/contact_history.h5\nend\n" +
                 "subsection Subsurface\n  set Compute = false\nend\n"
                 "subsection Output\n  set Plots = false\nend\n");
    const Outcome o = run_program({damage_program, "damage.prm"});
    check(o.code == 0, "damage of " + history + ": " + o.errors);
    return directory;
  }

  std::vector<std::string>
  damage_columns(const std::string &file)
  {
    std::vector<std::string> names;
    for (const Table::Column &column : read_csv(file).columns())
      if (column.name.rfind("damage_m", 0) == 0)
        names.push_back(column.name);
    check(!names.empty(), "damage in " + file);
    return names;
  }

  /** @p maps: names of the damage maps. @p gently: settings with which the
   * motion from rest does not squeal, which would amplify rounding. */
  void
  same_in_every_analysis(const std::string              &name,
                         const std::string              &scene,
                         const std::vector<std::string> &maps,
                         std::vector<std::string>        gently)
  {
    const std::string own = name + "_own", other = name + "_other",
                      imported =
                        "include " + own + "_preload/matrices/scene.prm\n";
    run(scene, "preload", own + "_preload", {"Output/Export matrices = true"});
    run(imported, "preload", other + "_preload");
    check_same(own + "_preload/contact.csv",
               other + "_preload/contact.csv",
               {"pressure_pa", "traction_y_pa"},
               1e-8);

    // The far face is a mean over its area, whatever the nodes are.
    if (own == "brake_own")
      check_same(own + "_preload/preload.csv",
                 other + "_preload/preload.csv",
                 {"approach_m", "secant_stiffness_n_per_m"},
                 1e-8);

    run(imported,
        "preload",
        other + "_more_modes",
        {"Eigenvalues/Highest frequency = 14000"});
    check_same(other + "_preload/contact.csv",
               other + "_more_modes/contact.csv",
               {"pressure_pa", "traction_y_pa"},
               2e-9);

    run(scene, "cea", own + "_cea");
    run(imported, "cea", other + "_cea");
    check_eigenvalues(own + "_cea", other + "_cea");

    run(scene, "transient", own + "_growth");
    run(imported, "transient", other + "_growth");
    const Table a = read_csv(own + "_growth/branches.csv"),
                b = read_csv(other + "_growth/branches.csv");
    check(a.n_rows() == b.n_rows() && a.n_rows() > 0, "as many pairs");
    const double
      rate =
        read_csv(own + "_growth/transient.csv").real(0, "growth_rate_per_s"),
      again =
        read_csv(other + "_growth/transient.csv").real(0, "growth_rate_per_s");
    check(std::abs(again - rate) <= 1e-3 * std::abs(rate),
          "growth rate of " + other + ": " + std::to_string(again) + ", " +
            std::to_string(rate));

    // From rest nothing is left to chance: the motions are the same.
    gently.insert(gently.end(),
                  {"Transient/Start = ramp",
                   "Transient/Disturbance = 0",
                   "Transient/End time = 0.008"});
    for (const auto &[text, directory] :
         {std::make_pair(scene, own), std::make_pair(imported, other)})
      run(text, "transient", directory + "_ramp", gently);
    check_same(own + "_ramp/forces.csv",
               other + "_ramp/forces.csv",
               {"normal_n", "tangential_n"},
               1e-6);
    damage_of(own + "_ramp", own + "_damage");
    damage_of(other + "_ramp", other + "_damage");
    for (const std::string &map : maps)
      check_same(own + "_damage/" + map,
                 other + "_damage/" + map,
                 damage_columns(own + "_damage/" + map),
                 1e-6);
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 4, "arguments: squeal, squeal-tribology, prm");
  program        = argv[1];
  damage_program = argv[2];
  prm            = argv[3];
  same_in_every_analysis("pins",
                         squealing_pins(),
                         {"damage_above.csv", "damage_below.csv"},
                         {"Scene/Contact above/Friction coefficient = 0.3",
                          "Scene/Load press_up/Ramp time = 0.004",
                          "Scene/Load press_low/Ramp time = 0.004"});
  // Cells of the disc that the pad touches end at the clamped bore.
  same_in_every_analysis(
    "brake",
    "include " + prm +
      "/tribobrake/pressed.prm\n"
      "subsection Scene\n"
      "  subsection Body disc\n    set Cells = 24, 1, 1\n  end\n"
      "  subsection Body pad\n    set Cells = 2, 2, 2\n"
      "    set Young modulus = 10^10.2\n  end\n"
      "  subsection Body support\n    set Cells = 2, 2, 6\n  end\n"
      "  subsection Contact pad_disc\n    set Formulation = springs\n"
      "    set Grid = 5, 5\n    set Normal stiffness = 1e9\n  end\n"
      "end\n",
    {"damage.csv"},
    {"Scene/Contact pad_disc/Friction coefficient = 0.2",
     "Scene/Load press/Ramp time = 0.004"});
  check(read_file("brake_own_preload/matrices/contact.csv").find("held z") !=
          std::string::npos,
        "the pattern says what supports hold of a target's motion");
}
