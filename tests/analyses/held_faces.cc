// SPDX-License-Identifier: LGPL-2.1-or-later

// Faces that a tie joins and faces that supports hold: what is on a tied face
// acts there, what a tie would have to hold on the other body is refused, a
// guided face with an edge that is held stands still on either side of a body,
// a rigid body is not guided, and a contact face with nodes that a tie holds is
// refused by all analyses. Argument: the program.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  /** Two blocks, one on the other; @p scene goes into the scene, and without a
   * kind there is no tie. */
  std::string
  two_blocks(const std::string &scene,
             const std::string &tie,
             const std::string &cells_below)
  {
    return R"(set Analysis         = modes
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies = a, b
  set Ties   = )" +
           std::string(tie.empty() ? "" : "t") + R"(
  subsection Body a
    set Shape = block
    set Size  = 0.1, 0.1, 0.05
    set Cells = )" +
           cells_below + R"(
  end
  subsection Body b
    set Shape    = block
    set Size     = 0.1, 0.1, 0.05
    set Position = 0, 0, 0.05
    set Cells    = 2, 2, 1
  end
)" +
           (tie.empty() ? "" :
                        R"(  subsection Tie t
    set Source body = a
    set Source face = z_max
    set Target body = b
    set Target face = z_min
    set Kind        = )" + tie +
                          "\n  end\n") +
           scene + R"(
end
subsection Discretization
  set Degree         = 1
  set Estimate error = false
end
subsection Eigenvalues
  set Highest frequency = 60000
end
subsection Output
  set Plots  = false
  set Shapes = none
end
)";
  }

  std::string
  support(const std::string &name,
          const std::string &body,
          const std::string &face,
          const std::string &kind = "clamped")
  {
    return "  subsection Support " + name + "\n    set Body = " + body +
           "\n    set Face = " + face + "\n    set Kind = " + kind +
           "\n  end\n";
  }

  Outcome
  run(const std::string &text)
  {
    std::filesystem::remove_all("out");
    write_text("scene.prm", text);
    return run_program({program, "scene.prm"});
  }

  std::vector<double>
  frequencies(const std::string &text, const std::string &claim)
  {
    const Outcome o = run(text);
    check(o.code == 0, claim + ": " + o.errors);
    return read_csv("out/modes.csv").reals("frequency_hz");
  }

  void
  check_same(const std::vector<double> &a,
             const std::vector<double> &b,
             const double               tolerance,
             const std::string         &claim)
  {
    check(a.size() == b.size() && a.size() > 2,
          claim + ": as many modes, " + std::to_string(a.size()));
    Worst worst;
    for (std::size_t i = 0; i < a.size(); ++i)
      worst.add(std::abs(a[i] / b[i] - 1.));
    check(worst.largest() < tolerance, claim);
  }

  void
  refused(const std::string              &text,
          const std::vector<std::string> &parts,
          const std::string              &claim)
  {
    const Outcome     o    = run(text);
    const std::string said = unbroken(o.errors);
    check(o.code != 0, claim);
    for (const std::string &part : parts)
      check(said.find(part) != std::string::npos,
            claim + ": '" + part + "' in: " + said);
  }

  /** A face that a tie joins, held, beside both blocks held there by
   * themselves. */
  void
  check_tied_faces()
  {
    const std::string held = "  set Supports = s, end\n" +
                             support("s", "b", "z_min") +
                             support("end", "a", "z_min");
    const std::string apart =
      "  set Supports = s, u, end\n" + support("s", "b", "z_min") +
      support("u", "a", "z_max") + support("end", "a", "z_min");
    const auto tied =
      frequencies(two_blocks(held, "automatic", "2, 2, 1"), "held on a tie");
    // Without the tie: both are clamped on the faces that it joins.
    const auto alone =
      frequencies(two_blocks(apart, "", "2, 2, 1"), "clamped apart");
    check_same(tied, alone, 1e-9, "a support on a tied face holds both bodies");
    refused(two_blocks(held, "conforming", "2, 2, 1"),
            {"Scene/Tie t", "Scene/Support s", "Kind = mortar"},
            "a conforming tie of a face that is held is refused");
    refused(two_blocks("  set Supports = s\n" + support("s", "a", "z_max"),
                       "automatic",
                       "2, 2, 1"),
            {"Scene/Tie t", "Scene/Support s", "exchange source and target"},
            "a support of the source of a mortar tie is refused");
  }

  void
  check_held_edges()
  {
    const auto on = [](const std::string &body) {
      return "  set Supports = s\n" + support("s", body, "x_min");
    };
    const auto conforming = frequencies(
                 two_blocks(on("a"), "conforming", "2, 2, 1"), "conforming"),
               mortar = frequencies(two_blocks("  set Supports = s, r\n" +
                                                 support("s", "a", "x_min") +
                                                 support("r", "b", "x_min"),
                                               "mortar",
                                               "3, 3, 1"),
                                    "both held");
    check(conforming.front() < mortar.front(),
          "blocks that are both held at one side are stiffer");
    refused(two_blocks(on("a"), "mortar", "2, 2, 1"),
            {"Scene/Tie t", "Scene/Support s", "body 'b' there too"},
            "an edge of the source that is held alone is refused");
    check_same(frequencies(two_blocks(on("b"), "mortar", "2, 2, 1"),
                           "held on the target"),
               frequencies(two_blocks(on("b"), "conforming", "2, 2, 1"),
                           "held, conforming"),
               1e-9,
               "an edge of the target is held through a mortar tie");
  }

  std::string
  block_with(const std::string &side)
  {
    return R"(set Analysis         = modes
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = b
  set Supports = top, side
  subsection Body b
    set Shape = block
    set Size  = 0.1, 0.1, 0.1
    set Cells = 2, 2, 2
  end
)" + support("top", "b", "z_max", "guided") +
           support("side", "b", side) + R"(
end
subsection Discretization
  set Degree         = 2
  set Estimate error = false
end
subsection Eigenvalues
  set Highest frequency = 25000
end
subsection Output
  set Plots  = false
  set Shapes = none
end
)";
  }

  void
  check_guided_faces()
  {
    const auto left  = frequencies(block_with("x_min"), "left"),
               right = frequencies(block_with("x_max"), "right"),
               still = frequencies(
                 replaced_in(block_with("x_min"),
                             "set Kind = guided",
                             "set Kind = components\n    set Components = z"),
                 "held");
    check_same(
      left, right, 1e-9, "a guided face does not know left from right");
    check_same(left, still, 1e-9, "with a held edge it stands still");
  }

  void
  check_rigid_bodies()
  {
    refused(R"(set Analysis         = modes
set Output directory = out
subsection Scene
  set Bodies   = m
  set Supports = s
  subsection Body m
    set Shape = rigid
    set Mass  = 1
  end
  subsection Support s
    set Body = m
    set Kind = guided
  end
end
)",
            {"Scene/Support s", "rx, ry, rz"},
            "a rigid body is not guided");
  }
  /** A block that slides on a floor, one side of it tied to a rigid body. */
  const std::string tied_slider = R"(set Output directory = out
subsection Scene
  set Bodies   = floor, block, lump
  set Supports = below, guide
  set Ties     = glue
  set Loads    = press
  set Contacts = rub
  subsection Body floor
    set Shape    = block
    set Size     = 0.02, 0.02, 0.01
    set Position = 0, 0, -0.01
    set Cells    = 1, 1, 1
  end
  subsection Body block
    set Shape = block
    set Size  = 0.01, 0.01, 0.01
    set Cells = 1, 1, 1
  end
  subsection Body lump
    set Shape    = rigid
    set Mass     = 0.1
    set Inertia  = 1e-5, 1e-5, 1e-5
    set Position = 0, 0, 0.005
  end
  subsection Support guide
    set Body       = lump
    set Kind       = components
    set Components = x, y, ry, rz
  end
  subsection Tie glue
    set Source body = block
    set Source face = y_max
    set Target body = lump
  end
  subsection Load press
    set Body  = block
    set Face  = z_max
    set Force = 0, 0, -100
  end
  subsection Contact rub
    set Formulation          = mortar
    set Contact state        = preload
    set Source body          = block
    set Source face          = z_min
    set Target body          = floor
    set Target face          = z_max
    set Friction direction   = fixed y
    set Sliding speed        = 0.1
    set Friction coefficient = 0.3
  end
)" + support("below", "floor", "z_min") +
                                  R"(end
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
  check_tied_contact_nodes()
  {
    for (const char *analysis : {"cea", "preload", "transient", "limit cycle"})
      refused(
        "set Analysis = " + std::string(analysis) + "\n" + tied_slider,
        {"tie glue and contact rub have a node in common", "part the faces"},
        std::string(analysis) + ": a tie holds nodes of the contact");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "usage: test_analyses_held_faces PROGRAM");
  program = argv[1];
  check_tied_faces();
  check_held_edges();
  check_guided_faces();
  check_rigid_bodies();
  check_tied_contact_nodes();
}
