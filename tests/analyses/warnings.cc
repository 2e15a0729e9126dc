// SPDX-License-Identifier: LGPL-2.1-or-later

// Warnings and lines that say what is behind a number: masses and springs at
// single points of solid bodies, the friction of a law, superposed responses
// with loss factors, steady sliding of bodies that turn. Arguments: the
// program, the folder of parameter files.

#include "program.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program, folder;

  Outcome
  run(const std::string &text)
  {
    std::filesystem::remove_all("out");
    write_text("run.prm", text);
    return run_program({program, "run.prm"});
  }

  bool
  has(const std::string &text, const std::string &part)
  {
    return unbroken(text).find(part) != std::string::npos;
  }

  std::string
  in_scene(const std::string &text)
  {
    return small_brake + "subsection Scene\n" + text + "end\n";
  }

  std::string
  mass(const std::string &kilograms)
  {
    return in_scene("  set Lumped masses = m\n  subsection Lumped mass m\n    "
                    "set Body = pad\n    set Point = 0.1, 0, 0.01\n    set "
                    "Mass = " +
                    kilograms + "\n  end\n");
  }

  std::string
  spring(const std::string &what)
  {
    return in_scene("  set Springs = s\n  subsection Spring s\n    set Body = "
                    "pad\n    set Direction = 0, 0, 1\n" +
                    what + "  end\n");
  }

  void
  single_points()
  {
    const std::string row =
      "    set First point = 0.096, 0, 0.01\n    set Last point = 0.104, 0, "
      "0.01\n    set Stiffness = 1e7\n";
    for (const auto &[text, name] :
         {std::make_pair(mass("0.01"), std::string("lumped mass 'm'")),
          std::make_pair(spring("    set First point = 0.1, 0, 0.01\n    set "
                                "Last point = 0.1, 0, 0.01\n    set Stiffness "
                                "= 1e7\n"),
                         std::string("spring 's'"))})
      {
        const Outcome     o = run(text);
        const std::string remark =
          name + " acts at single points of body 'pad': its frequencies go "
                 "down without limit as the mesh is refined";
        check(o.code == 0, name + " runs: " + o.errors);
        check(has(o.output, remark), "the first screen warns of " + name);
        check(has(text_of("out/run.json"), remark), "and in run.json");
        check(has(text_of("out/run.json"), "mesh error does not cover"),
              "which says what the stated error leaves out");
      }
    for (const auto &[text, name] :
         {std::make_pair(mass("1e-9"), std::string("a mass of a microgram")),
          std::make_pair(spring("    set Kind = area\n    set Face = z_max\n "
                                "   set Stiffness = 1e11\n"),
                         std::string("an elastic bed")),
          std::make_pair(spring(row + "    set Number = 21\n"),
                         std::string("a row as fine as the cells"))})
      {
        const Outcome o = run(text);
        check(o.code == 0, name + " runs: " + o.errors);
        check(!has(o.output, "acts at single points"),
              name + " has no warning");
      }
    const Outcome rigid = run("include " + folder +
                              "/minimal/hoffmann.prm\nset Output directory = "
                              "out\n");
    check(rigid.code == 0 && !has(rigid.output, "acts at single points"),
          "points of rigid bodies are exact");
  }

  void
  friction_laws()
  {
    const auto law = [](const std::string &text) {
      return in_scene("  subsection Contact pad_disc\n" + text + "  end\n");
    };
    check(has(run(law("")).output, "friction coefficient 0.3"),
          "one coefficient is named");
    const std::string table =
      replaced_in(law("    set Friction law = table\n    set Friction speeds = "
                      "0, 1\n    set Friction coefficients = 0.5, 0.3\n    set "
                      "Sliding speed = 0.5\n"),
                  "    set Friction coefficient = 0.3\n",
                  "");
    const Outcome o = run(table);
    check(o.code == 0, "a table runs: " + o.errors);
    check(has(o.output,
              "friction by a table, 0.5000 at rest to 0.3000 from 1.000 m/s "
              "on, 0.4000 at the sliding speed 0.5000 m/s"),
          "a table is named with what it is at the sliding speed");
  }

  void
  responses()
  {
    const auto response = [](const std::string &damping) {
      return replaced_in(small_brake, "= cea", "= frequency response") +
             "subsection Scene\n  subsection Damping\n    set Model = whole "
             "model\n    set " +
             damping +
             "\n  end\nend\nsubsection Measurement\n  set Points = p\n  "
             "subsection Point p\n    set Body = pad\n    set Position = 0.1, "
             "0, 0.01\n    set Direction = 0, 0, 1\n  end\nend\nsubsection "
             "Frequency response\n  set Number = 5\n  set Check tolerance = "
             "1e-14\nend\n";
    };
    const Outcome lossy = run(response("Structural damping = 0.1"));
    check(lossy.code == 0, "responses run: " + lossy.errors);
    check(has(lossy.output, "superposition and direct solution differ") &&
            has(lossy.output, "no 'Margin' takes away") &&
            !has(lossy.output, "raise 'Frequency response/Margin'"),
          "with loss factors nobody is sent to Margin");
    const Outcome viscous = run(response("Stiffness damping = 1e-7"));
    check(viscous.code == 0 &&
            has(viscous.output, "raise 'Frequency response/Margin'"),
          "without them Margin is what helps");
    std::filesystem::remove_all("out");
    const Outcome loose = run_program(
      {program, "--set", "Eigenvalues/Residual tolerance = 1e-3", "run.prm"});
    check(loose.code == 0 && has(loose.output,
                                 "lower 'Eigenvalues/Residual tolerance' "
                                 "(0.0010), and then raise 'Frequency "
                                 "response/Margin'"),
          "loose pairs are tightened first: " + loose.errors);
  }

  /** 1 cm^2 under 2 MPa: 200 N, whatever the pad is said to be pressed with. */
  void
  forces_of_loads()
  {
    const auto pressed = [](const std::string &force) {
      std::string text =
        in_scene("  set Loads = back\n  subsection Load back\n    set Body = "
                 "pad\n    set Face = z_max\n    set Pressure = 2e6\n  end\n  "
                 "subsection Contact pad_disc\n    set Contact state = "
                 "preload\n    set Normal force = " +
                 force + "\n  end\n");
      return run(text);
    };
    const Outcome other = pressed("1500");
    check(other.code == 0, "a pressed pad runs: " + other.errors);
    check(has(other.output,
              "'Scene/Contact pad_disc/Normal force' = 1500 N has no effect "
              "with 'Contact state = preload': the loads press the pair with "
              "200.0 N"),
          "a force that the loads contradict is named");
    for (const char *force : {"205", "100"}) // the latter is the default
      check(!has(pressed(force).output, "Normal force' ="),
            std::string("not so ") + force + " N");
    // 8 x 2 x 2 nodes with one ring of 16 held, and 8 nodes with 4 along z
    check(has(text_of("out/run.json"), "\"disc\": 48") &&
            has(text_of("out/run.json"), "\"pad\": 16") &&
            has(text_of("out/run.json"), "\"dofs\": 64"),
          "run.json has the unknowns of each body");
  }

  void
  turning_bodies()
  {
    const Outcome o =
      run("include " + folder +
          "/ventilated_brake/pressed.prm\nset Analysis = cea\nset Output "
          "directory = out\nset Overwrite = true\nsubsection Scene\n  "
          "subsection Body disc\n    set Rotation speed = 1\n  end\nend\n");
    check(o.code != 0, "steady sliding with a body that turns is refused");
    check(has(o.errors, "'Scene/Body disc/Rotation speed' = 1") &&
            has(o.errors, "set it to 0") &&
            has(o.errors, "Contact state = full") &&
            !has(o.errors, "loss factors"),
          "by the entry, with the ways out: " + o.errors);
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 3, "two arguments");
  program = argv[1];
  folder  = argv[2];
  single_points();
  friction_laws();
  responses();
  forces_of_loads();
  turning_bodies();
}
