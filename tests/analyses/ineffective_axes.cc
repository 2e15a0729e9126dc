// SPDX-License-Identifier: LGPL-2.1-or-later

// An axis of a sweep along which neither mass nor damping nor stiffness
// changes, and an entry without effect that moves along with others, is refused
// by its name before the sweep, with what is behind it; the same axes go where
// the scene depends on them. Argument: the program.

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
}
