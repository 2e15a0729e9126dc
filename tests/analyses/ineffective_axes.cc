// SPDX-License-Identifier: LGPL-2.1-or-later

// An axis of a sweep along which neither mass nor damping nor stiffness
// changes, and an entry without effect that moves along with others, is refused
// by its name before the sweep, with what is behind it; the same axes go where
// the scene depends on them, or one of the scenes that a sweep rebuilds. A pair
// that sticks neither needs its sliding speed on an axis nor takes it there.
// Argument: the program.

#include "program.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  Outcome
  sweep(const std::string &scene,
        const std::string &entry,
        const std::string &from,
        const std::string &to)
  {
    std::filesystem::remove_all("out");
    write_text("axes.prm",
               replaced_in(small_brake,
                           "set Analysis         = cea",
                           "set Analysis         = sweep") +
                 "subsection Scene\n" + scene +
                 "end\nsubsection Sweep\n  set Axes = mu, dead\n"
                 "  subsection Axis mu\n"
                 "    set Entries = Scene/Contact pad_disc/Friction "
                 "coefficient\n    set From = 0.1\n    set To = 0.3\n    set "
                 "Number = 3\n  end\n  subsection Axis dead\n    set Entries "
                 "= " +
                 entry + "\n    set From = " + from + "\n    set To = " + to +
                 "\n    set Number = 3\n  end\nend\n");
    return run_program({program, "axes.prm"});
  }

  void
  refused(const std::string &scene,
          const std::string &entry,
          const std::string &from,
          const std::string &to,
          const std::string &reason,
          const std::string &others = "")
  {
    const Outcome     o    = sweep(scene, others + entry, from, to);
    const std::string text = unbroken(o.errors);
    check(o.code != 0, entry + " without effect is refused");
    for (const std::string &part :
         {std::string("Sweep/Axis dead: "),
          std::string("neither mass nor damping nor stiffness"),
          entry,
          reason})
      check(text.find(part) != std::string::npos,
            "the message has '" + part + "': " + text);
    check(!std::filesystem::exists("out/eigenvalues.csv"),
          "nothing has been swept");
  }

  /** An entry that is to be varied beside the axes. */
  void
  refused_beside(const std::string &scene,
                 const std::string &entry,
                 const bool         acts)
  {
    std::filesystem::remove_all("out");
    write_text("beside.prm",
               replaced_in(small_brake,
                           "set Analysis         = cea",
                           "set Analysis         = sweep") +
                 "subsection Scene\n" + scene +
                 "end\nsubsection Sweep\n  set Axes = mu\n"
                 "  set Sensitivities = " +
                 entry +
                 "\n  subsection Axis mu\n    set Entries = Scene/Contact "
                 "pad_disc/Friction coefficient\n    set From = 0.1\n    set "
                 "To = 0.3\n    set Number = 3\n  end\nend\n");
    const Outcome o = run_program({program, "beside.prm"});
    check((o.code == 0) == acts,
          "a sensitivity to " + entry + (acts ? " runs: " : " is refused: ") +
            o.errors);
    check(acts || unbroken(o.errors).find("is to be varied beside the axes") !=
                    std::string::npos,
          "and the line says so");
  }

  void
  accepted(const std::string &scene,
           const std::string &entry,
           const std::string &from,
           const std::string &to)
  {
    const Outcome o = sweep(scene, entry, from, to);
    check(o.code == 0, entry + " with an effect is swept: " + o.errors);
  }

  Outcome
  sweep_of(const std::string &brake,
           const std::string &scene,
           const std::string &axes)
  {
    std::filesystem::remove_all("out");
    write_text("own.prm",
               replaced_in(brake,
                           "set Analysis         = cea",
                           "set Analysis         = sweep") +
                 "subsection Scene\n" + scene + "end\nsubsection Sweep\n" +
                 axes + "end\n");
    return run_program({program, "own.prm"});
  }

  /** An axis of the friction coefficient from 0 with another number that needs
   * new matrices: in the first of its scenes nothing slides with friction. */
  void
  scenes_are_looked_at_together(const std::string &contact,
                                const std::string &slip)
  {
    const std::string both =
      "  subsection Axis both\n    set Entries = " + contact +
      "Friction coefficient, Scene/Body pad/Poisson ratio\n    set From = 0, "
      "0.2\n    set To = 0.3, 0.3\n    set Number = 3\n  end\n";
    const auto speed = [&](const std::string &entries) {
      return "  set Axes = both, v\n" + both +
             "  subsection Axis v\n    set Entries = " + entries +
             "\n    set Scale = list\n    set Values = 1, 4\n  end\n";
    };
    for (const std::string beside : {"", ", Scene/Body pad/Density"})
      {
        const Outcome o = sweep_of(
          small_brake, slip, speed(contact + "Sliding speed" + beside));
        check(o.code == 0,
              "friction from 0 on in scenes of their own: the speed" + beside +
                " is swept: " + o.errors);
      }
    const Outcome dead =
      sweep_of(small_brake, "", speed(contact + "Sliding speed"));
    check(dead.code != 0 &&
            unbroken(dead.errors).find("or the friction coefficient is 0") !=
              std::string::npos,
          "a speed that acts in none of them is refused: " + dead.errors);
    const Outcome alone =
      sweep_of(small_brake, slip, "  set Axes = both\n" + both);
    check(alone.code != 0 &&
            unbroken(alone.errors)
                .find("needs new matrices ('Scene/Body pad/Poisson "
                      "ratio')") != std::string::npos,
          "the axis alone is refused by its entry: " + alone.errors);
  }

  /** A disc that turns between a pad that slips and one that sticks, both with
   * terms of the slip rate: the speed of the second acts on nothing. */
  void
  sticking_pairs_have_no_speed()
  {
    std::string brake = replaced_in(
      small_brake, "Bodies   = disc, pad", "Bodies = disc, pad, low");
    brake = replaced_in(
      brake, "Contacts = pad_disc", "Contacts = pad_disc, low_disc");
    brake = replaced_in(brake, "inner_edge, top\n", "inner_edge, top, base\n");
    const std::string slip =
      "    set Friction direction = slip\n    set Sliding speed = 10\n    set "
      "Transverse slip term = true\n    set Normal force = 100\n";
    const std::string scene =
      "  subsection Body disc\n    set Rotation speed = 100\n  end\n"
      "  subsection Body low\n    set Shape = block\n    set Size = 0.01, "
      "0.01, 0.01\n    set Position = 0.1, 0, -0.02\n    set Cells = 1, 1, "
      "1\n    set Young modulus = 2e10\n    set Density = 2500\n  end\n"
      "  subsection Support base\n    set Body = low\n    set Face = "
      "z_min\n  end\n  subsection Contact pad_disc\n" +
      slip +
      "  end\n  subsection Contact low_disc\n    set Source body = low\n    "
      "set Source face = z_max\n    set Target body = disc\n    set Target "
      "face = bottom\n    set Grid = 2, 2\n    set Friction coefficient = "
      "0.3\n    set Contact state = stick\n" +
      slip + "  end\n";
    const auto axis = [](const std::string &more,
                         const std::string &from,
                         const std::string &to) {
      return "  set Axes = turning\n  subsection Axis turning\n    set Entries "
             "= Scene/Body disc/Rotation speed, Scene/Contact pad_disc/Sliding "
             "speed" +
             more + "\n    set From = 80, 8" + from + "\n    set To = 120, 12" +
             to + "\n    set Number = 2\n  end\n";
    };
    const Outcome o = sweep_of(brake, scene, axis("", "", ""));
    check(o.code == 0,
          "the turning is swept with the sliding pair: " + o.errors);
    const Outcome both =
      sweep_of(brake,
               scene,
               axis(", Scene/Contact low_disc/Sliding speed", ", 8", ", 12"));
    check(both.code != 0 &&
            unbroken(both.errors).find("the pair sticks") != std::string::npos,
          "the speed of the sticking pair is refused for that: " + both.errors);
    const Outcome none = sweep_of(
      brake,
      scene,
      "  set Axes = turning\n  subsection Axis turning\n    set Entries = "
      "Scene/Body disc/Rotation speed\n    set From = 80\n    set To = "
      "120\n    set Number = 2\n  end\n");
    check(none.code != 0 &&
            unbroken(none.errors)
                .find("without 'Scene/Contact pad_disc/Sliding speed'") !=
              std::string::npos,
          "the sliding pair asks for its own: " + none.errors);
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program                   = argv[1];
  const std::string contact = "Scene/Contact pad_disc/",
                    pad     = "Scene/Body pad/";
  const std::string whole =
    "  subsection Damping\n    set Model = whole model\n    set Stiffness "
    "damping = 1e-8\n  end\n";
  const std::string parts =
    "  subsection Damping\n    set Model = per part\n  end\n";
  const std::string slip =
    "  subsection Contact pad_disc\n    set Transverse slip term = true\n    "
    "set Normal force = 100\n    set Sliding speed = 2\n  end\n";
  refused(whole,
          pad + "Structural damping",
          "0",
          "0.1",
          "'Scene/Damping/Model = whole");
  refused(whole,
          contact + "Tangential stiffness",
          "1e6",
          "1e7",
          "it acts where nodes stick");
  refused(whole,
          contact + "Normal stiffness per area",
          "1e10",
          "1e12",
          "layout 'quadrature'");
  refused(parts,
          "Scene/Damping/Stiffness damping",
          "1e-8",
          "1e-7",
          "'Scene/Damping/Model = per part'");
  refused(whole,
          pad + "Structural damping",
          "0.01",
          "0.1",
          "moves along with other entries",
          pad + "Density, ");
  refused_beside(whole, contact + "Tangential stiffness", false);
  refused_beside(whole, pad + "Density", true);
  accepted(parts, pad + "Structural damping", "0", "0.1");
  accepted(whole, contact + "Normal stiffness", "1e7", "1e8");
  // Together, and of one factor, which makes them one part of the sweep.
  accepted(whole, pad + "Density, Scene/Body disc/Density", "2000", "3000");
  // Through the friction term alone.
  accepted(slip, contact + "Sliding speed", "1", "4");
  scenes_are_looked_at_together(contact, slip);
  sticking_pairs_have_no_speed();
}
