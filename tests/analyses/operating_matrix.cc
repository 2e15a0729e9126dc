// SPDX-License-Identifier: LGPL-2.1-or-later

// Every field of an operating matrix is what the eigenvalue analysis about the
// same steady sliding finds, and a brake that is symmetric squeals alike
// forward and backward. Arguments: the program and the folder of parameter
// files.

#include <squeal/results/table.h>

#include "../worst.h"
#include "program.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string pads[] = {"upper", "lower"};

  const std::string estimated =
    "subsection Discretization\n set Estimate error = true\nend\n";

  struct Band
  {
    std::string lowest = "7000", highest = "8000"; // Hz
  };

  std::string
  scene(const std::string &folder,
        const std::string &more,
        const std::string &friction = "0.5",
        const Band        &band     = {})
  {
    std::string text = "include " + folder + "/own_brake/scene.prm\n" + more +
                       "\nset Overwrite = true\n"
                       "subsection Discretization\n set Degree = 1\nend\n"
                       "subsection Eigenvalues\n set Lowest frequency = " +
                       band.lowest +
                       "\n set Highest frequency = " + band.highest +
                       "\nend\n"
                       "subsection Output\n set Plots = false\n"
                       " set Report = false\n set Shapes = none\nend\n"
                       "subsection Scene\n";
    for (const std::string &pad : pads)
      text += " subsection Contact " + pad +
              "\n  set Friction coefficient = " + friction + "\n end\n";
    return text + "end\n";
  }

  std::string
  pressed(const std::string &pressure)
  {
    std::string text = "subsection Scene\n";
    for (const std::string &pad : pads)
      text += " subsection Load press_" + pad +
              "\n  set Pressure = " + pressure + "\n end\n";
    return text + "end\n";
  }

  /** The small brake with changes of its text. */
  std::string
  changed_brake(const std::vector<std::pair<std::string, std::string>> &changes)
  {
    std::string text = small_brake;
    for (const auto &[old, by] : changes)
      text = replaced_in(text, old, by);
    return text;
  }

  std::size_t
  loudest_of(const Table &pairs)
  {
    std::size_t loudest = 0;
    for (std::size_t i = 0; i < pairs.n_rows(); ++i)
      if (pairs.real(i, "sigma_per_s") > pairs.real(loudest, "sigma_per_s"))
        loudest = i;
    return loudest;
  }

  /** A lining whose modulus depends on temperature and a mass at one end of
   * a pad: forward and backward differ, and so do steady slidings. */
  const std::string one_sided_brake =
    "subsection Scene\n set Lumped masses = clip\n"
    " subsection Lumped mass clip\n  set Body = plate_upper\n"
    "  set Point = 0.104, 0.009, 0.0125\n  set Mass = 0.02\n end\n"
    " subsection Body lining_upper\n  set Modulus table file = lining.csv\n"
    " end\nend\n";

  /** Moduli over frequency are costly to solve with: the loudest alone. */
  const Band about_loudest = {"7300", "7500"};

  void
  one_sided(const std::string &program, const std::string &folder)
  {
    write_text("lining.csv",
               "frequency_Hz,temperature_C,storage_modulus_Pa,loss_factor\n"
               "100,0,9e9,0.02\n10000,0,10e9,0.02\n"
               "100,80,5e9,0.05\n10000,80,6e9,0.05\n");
    write_text("one_sided.prm",
               scene(folder,
                     "set Analysis = operating matrix\n"
                     "set Output directory = one_sided",
                     "0.5",
                     about_loudest) +
                 one_sided_brake +
                 "subsection Operating matrix\n set Temperatures = 10, 70\n"
                 " set Both directions = true\nend\n");
    check(run_program({program, "one_sided.prm"}).code == 0,
          "temperatures run");
    const Table matrix = read_csv("one_sided/operating_matrix.csv");
    check(matrix.n_rows() == 4, "two temperatures, two directions");
    Worst       difference;
    std::size_t row = 0;
    // the first and the last of its four conditions
    for (const auto &[mu, temperature] :
         std::vector<std::pair<std::string, std::string>>{{"0.5", "10"},
                                                          {"-0.5", "70"}})
      {
        std::string text =
          scene(folder,
                "set Analysis = cea\nset Output directory = alone",
                mu,
                about_loudest) +
          one_sided_brake +
          "subsection Scene\n subsection Body lining_upper\n"
          "  set Temperature = " +
          temperature + "\n end\n";
        write_text("alone.prm", text + "end\n");
        check(run_program({program, "alone.prm"}).code == 0,
              "one temperature runs");
        const Table       alone   = read_csv("alone/eigenvalues.csv");
        const std::size_t loudest = loudest_of(alone);
        for (const std::string column : {"frequency_hz", "sigma_per_s"})
          difference.add(std::abs(
            matrix.real(row, column) / alone.real(loudest, column) - 1.));
        row = 3;
      }
    check(difference.largest() < 1e-9,
          "temperatures and directions as the eigenvalue analysis");
    check(
      std::abs(matrix.real(0, "sigma_per_s") / matrix.real(2, "sigma_per_s") -
               1.) > 0.1,
      "forward and backward differ");
  }

  /** With 'Refinement = eigenvalue error' each condition has the mesh that the
   * eigenvalue analysis of it ends with. */
  void
  refined_as_alone(const std::string &program)
  {
    const std::string refined =
      "set Overwrite = true\nsubsection Discretization\n"
      " set Refinement = eigenvalue error\n set Tolerance = 1e-2\n"
      " set Maximum cycles = 2\nend\n"
      "subsection Operating matrix\n set Both directions = true\nend\n";
    write_text("coarse.prm", small_brake);
    for (const auto &[name, analysis] :
         {std::pair("refined_alone", "cea"),
          std::pair("refined", "operating matrix")})
      {
        write_text("refined.prm",
                   "include coarse.prm\n" + refined + "set Analysis = " +
                     analysis + "\nset Output directory = " + name + "\n");
        const Outcome o = run_program({program, "refined.prm"});
        check(o.code == 0, std::string(name) + ": " + o.errors);
      }
    const auto last_mesh = [](const std::string &folder) {
      const std::string log = text_of(folder + "/run.log");
      const std::size_t at  = log.find("  mesh 1: ");
      check(at != std::string::npos, folder + ": the mesh is refined");
      return log.substr(at, log.find('\n', at) - at);
    };
    check(last_mesh("refined") == last_mesh("refined_alone"),
          "to the mesh of the eigenvalue analysis: " + last_mesh("refined"));
  }

  /** A lining that its pressure stiffens: the moduli and the contact of each
   * condition are those of its pressure. The table is the same at all
   * frequencies, so that a modulus of the body gives the same pairs. */
  void
  stiffened_by_pressure(const std::string &program, const std::string &folder)
  {
    write_text("pressed.csv",
               "pressure_Pa,frequency_Hz,temperature_C,storage_modulus_Pa,"
               "loss_factor\n"
               "0.5e6,100,20,5e9,0\n0.5e6,10000,20,5e9,0\n"
               "2e6,100,20,1e10,0\n2e6,10000,20,1e10,0\n");
    const std::string table =
      "subsection Scene\n subsection Body lining_upper\n"
      "  set Modulus table file = pressed.csv\n  set Pressure = 0.5e6\n"
      " end\nend\n";
    write_text("stiffened.prm",
               scene(folder,
                     "set Analysis = operating matrix\n"
                     "set Output directory = stiffened") +
                 table +
                 "subsection Operating matrix\n set Pressures = 0.5e6, 2e6\n"
                 "end\n");
    check(run_program({program, "stiffened.prm"}).code == 0, "pressures run");
    const Table matrix = read_csv("stiffened/operating_matrix.csv");
    check(matrix.n_rows() == 2, "two pressures");
    Worst difference;
    for (unsigned int k = 0; k < 2; ++k)
      {
        const std::string modulus = k == 0 ? "5e9" : "1e10";
        write_text(
          "alone.prm",
          scene(folder, "set Analysis = cea\nset Output directory = alone") +
            pressed(k == 0 ? "0.5e6" : "2e6") +
            "subsection Scene\n subsection Body lining_upper\n"
            "  set Young modulus = " +
            modulus + "\n end\nend\n");
        check(run_program({program, "alone.prm"}).code == 0,
              "the modulus of one pressure runs");
        const Table       alone   = read_csv("alone/eigenvalues.csv");
        const std::size_t loudest = loudest_of(alone);
        for (const std::string column : {"frequency_hz", "sigma_per_s"})
          difference.add(std::abs(
            matrix.real(k, column) / alone.real(loudest, column) - 1.));
      }
    check(difference.largest() < 1e-9,
          "pressures as the eigenvalue analysis with their moduli");
    check(
      std::abs(matrix.real(0, "sigma_per_s") / matrix.real(1, "sigma_per_s") -
               1.) > 0.1,
      "which matter");

    // The last condition lies beyond the table: nothing is solved before.
    write_text("beyond.prm",
               scene(folder,
                     "set Analysis = operating matrix\n"
                     "set Output directory = beyond") +
                 table +
                 "subsection Operating matrix\n set Pressures = 0.5e6, 3e6\n"
                 "end\n");
    const Outcome beyond = run_program({program, "beyond.prm"});
    check(beyond.code != 0 &&
            unbroken(beyond.errors).find("the body has 3e6") !=
              std::string::npos,
          "a pressure beyond the table: " + beyond.errors);
    check(beyond.output.find("by the inertia") == std::string::npos,
          "which is refused before any work");

    // Contacts that no load presses feel the pressure by the table alone.
    for (const std::string file : {"pressed.csv", "lining.csv"})
      {
        write_text(
          "closed.prm",
          "include stiffened.prm\nset Output directory = closed\n"
          "set Overwrite = true\nsubsection Scene\n"
          " subsection Body lining_upper\n  set Modulus table file = " +
            file + (file == "pressed.csv" ? "" : "\n  set Pressure = 0") +
            "\n end\n"
            " subsection Contact lower\n  set Contact state = full\n"
            " end\n subsection Contact upper\n"
            "  set Contact state = full\n end\nend\n");
        const Outcome o = run_program({program, "closed.prm"});
        check(o.code == (file == "pressed.csv" ? 0 : 2) &&
                (o.code == 0 ||
                 unbroken(o.errors).find("'Operating matrix/Pressures' acts on "
                                         "nothing") != std::string::npos),
              "pressures of " + file + " alone: " + o.errors);
      }

    write_text(
      "no_column.prm",
      scene(folder, "set Analysis = cea\nset Output directory = no_column") +
        "subsection Scene\n subsection Body lining_upper\n"
        "  set Modulus table file = lining.csv\n"
        "  set Pressure = 1e6\n end\nend\n");
    const Outcome o = run_program({program, "no_column.prm"});
    check(o.code != 0 && o.errors.find("pressure_Pa") != std::string::npos,
          "a pressure that the table does not know: " + o.errors);
  }

  /** A disc that turns through the frame turns back where its sliding does: by
   * the mirror symmetry of the pad both directions have the same pairs. Loads
   * that pull are no pressures. */
  void
  turning(const std::string &program)
  {
    const std::string brake = changed_brake(
      {{"set Analysis         = cea", "set Analysis = operating matrix"},
       {"set Cells         = 8, 1, 1",
        "set Cells         = 8, 1, 1\n    set Rotation speed = 300"},
       {"set Friction coefficient = 0.3",
        "set Friction coefficient = 0.3\n    set Friction direction = slip"}});
    write_text("turning.prm",
               brake + "set Overwrite = true\n"
                       "subsection Operating matrix\n"
                       " set Both directions = true\nend\n");
    const Outcome o = run_program({program, "turning.prm"});
    check(o.code == 0, "a disc that turns both ways: " + o.errors);
    const Table matrix = read_csv("out/operating_matrix.csv");
    check(matrix.n_rows() == 2, "two directions");
    for (const std::string column : {"frequency_hz", "sigma_per_s"})
      check_close(matrix.real(1, column),
                  matrix.real(0, column),
                  1e-6,
                  column + " forward and backward",
                  1e3);
    write_text(
      "pull.prm",
      changed_brake(
        {{"set Analysis         = cea", "set Analysis = operating matrix"},
         {"set Contacts = pad_disc",
          "set Contacts = pad_disc\n  set Loads = pull\n  subsection "
          "Load pull\n    set Body = pad\n    set Face = z_max\n    "
          "set Pressure = -1e6\n  end"},
         {"set Grid                 = 2, 2",
          "set Grid = 2, 2\n    set Contact state = preload"}}) +
        "subsection Operating matrix\n set Pressures = 2e6\nend\n");
    const Outcome pull = run_program({program, "pull.prm"});
    check(pull.code == 2 &&
            pull.errors.find("'Scene/Load pull/Pressure' = -1") !=
              std::string::npos &&
            pull.errors.find("pulls") != std::string::npos,
          "a pull is not made a push: " + pull.errors);
  }

  /** Where friction alone differs, backward starts from the factor and the
   * pairs of forward; its pairs are those of the analysis that starts anew. */
  void
  started_from_the_other_direction(const std::string &program)
  {
    const auto brake = [&](const std::string &analysis,
                           const std::string &friction) {
      return changed_brake(
               {{"set Analysis         = cea", "set Analysis = " + analysis},
                {"set Friction coefficient = 0.3",
                 "set Friction slope = -0.05\n    set Normal force = 100\n"
                 "    set Friction coefficient = " +
                   friction}}) +
             "set Overwrite = true\nsubsection Scene\n"
             " set Lumped masses = clip\n subsection Lumped mass clip\n"
             "  set Body = disc\n  set Point = 0.1, 0.03, 0\n"
             "  set Mass = 0.5\n end\nend\n";
    };
    write_text("both.prm",
               brake("operating matrix", "0.3") +
                 "subsection Operating matrix\n"
                 " set Both directions = true\nend\n");
    const Outcome o = run_program({program, "both.prm"});
    check(o.code == 0, "a disc with a clip on one side: " + o.errors);
    check(unbroken(o.output).find("factor and modes of the condition") !=
            std::string::npos,
          "backward starts from forward");
    const Table matrix = read_csv("out/operating_matrix.csv");
    check(matrix.n_rows() == 2, "two directions");
    Worst difference;
    for (const std::string friction : {"0.3", "-0.3"})
      {
        write_text("alone.prm", brake("cea", friction));
        check(run_program({program, "alone.prm"}).code == 0, "alone it runs");
        const Table       alone   = read_csv("out/eigenvalues.csv");
        const std::size_t loudest = loudest_of(alone);
        const std::size_t row     = friction == "0.3" ? 0 : 1;
        for (const std::string column : {"frequency_hz", "sigma_per_s"})
          difference.add(std::abs(
            matrix.real(row, column) / alone.real(loudest, column) - 1.));
      }
    check(difference.largest() < 1e-8, "and finds what it finds alone");
    check(
      std::abs(matrix.real(0, "sigma_per_s") / matrix.real(1, "sigma_per_s") -
               1.) > 1e-3,
      "which is another growth");
  }

  /** Speeds are refused where friction is the same at all of them. */
  void
  speeds(const std::string &program)
  {
    const auto run = [&](const std::vector<std::string> &settings) {
      write_text("speeds.prm",
                 changed_brake({{"set Analysis         = cea",
                                 "set Analysis = operating matrix"}}) +
                   "set Overwrite = true\n"
                   "subsection Operating matrix\n set Speeds = 2, 4\nend\n");
      std::vector<std::string> words = {program};
      for (const std::string &setting : settings)
        words.insert(words.end(),
                     {"--set", "Scene/Contact pad_disc/" + setting});
      words.push_back("speeds.prm");
      return run_program(words);
    };
    for (const auto &more : std::vector<std::vector<std::string>>{
           {},
           {"Friction slope = -0.01"},
           {"Friction law = exponential", "Decay speed = 0"},
           {"Normal force = 0", "Transverse slip term = true"}})
      {
        std::vector<std::string> all = {"Sliding speed = 2",
                                        "Normal force = 100"};
        all.insert(all.end(), more.begin(), more.end());
        const Outcome o = run(all);
        check(o.code == 2 &&
                unbroken(o.errors).find("'Operating matrix/Speeds'") !=
                  std::string::npos,
              "speeds without effect are refused: " + o.errors);
      }
    const Outcome o = run({"Sliding speed = 2",
                           "Friction law = exponential",
                           "Static friction coefficient = 0.6",
                           "Decay speed = 2"});
    check(o.code == 0, "and taken where friction follows them: " + o.errors);
    const Table matrix = read_csv("out/operating_matrix.csv");
    check(matrix.n_rows() == 2 &&
            matrix.real(0, "sigma_per_s") != matrix.real(1, "sigma_per_s"),
          "with an effect");
  }

  /** On a coarse mesh of linear elements the least damped pair of the pin on a
   * beam decays by less than the error of its growth rate, which the verdict
   * says, and by nothing that is known without an estimate. */
  void
  left_open(const std::string &program, const std::string &folder)
  {
    const auto said = [&](const std::string &estimate) {
      write_text("open.prm",
                 "include " + folder +
                   "/pin_on_beam/scene.prm\n"
                   "set Analysis = operating matrix\nset Overwrite = true\n"
                   "set Output directory = open\nsubsection Scene\n"
                   " subsection Body beam\n  set Cells = 1, 6, 1\n end\n"
                   " subsection Body pin\n  set Cells = 2, 2, 3\n end\n"
                   " subsection Contact pin_beam\n"
                   "  set Friction coefficient = 0.5\n end\n"
                   " subsection Load press\n  set Force = 0, 0, 0\n"
                   "  set Pressure = 5e5\n end\nend\n"
                   "subsection Discretization\n set Degree = 1\n"
                   " set Estimate error = " +
                   estimate +
                   "\nend\nsubsection Output\n set Plots = false\n"
                   " set Shapes = none\nend\n"
                   "subsection Operating matrix\n"
                   " set Speeds = 0.05\nend\n");
      const Outcome o = run_program({program, "open.prm"});
      check(o.code == 0, "the pin on a beam runs: " + o.errors);
      return unbroken(text_of("open/report.html")) + unbroken(o.output);
    };
    const std::string open = said("true"), unknown = said("false");
    check(open.find("under 1 of 1 conditions the mesh leaves open whether a "
                    "pair grows") != std::string::npos,
          "the mesh leaves growth open");
    check(unknown.find("the error of growth rates by the mesh is not "
                       "estimated") != std::string::npos,
          "without an estimate stable is so on this mesh only");
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc == 3, "program and folder");
  const std::string program = argv[1], folder = argv[2];
  refined_as_alone(program);
  write_text("matrix.prm",
             scene(folder,
                   "set Analysis = operating matrix\n"
                   "set Output directory = matrix") +
               estimated +
               "subsection Operating matrix\n set Pressures = 0.5e6, 2e6\n"
               " set Both directions = true\nend\n");
  check(run_program({program, "matrix.prm"}).code == 0, "the matrix runs");
  const Table matrix = read_csv("matrix/operating_matrix.csv");
  check(matrix.n_rows() == 4, "two pressures, two directions");

  Worst difference, asymmetry, errors;
  for (unsigned int k = 0; k < 2; ++k)
    {
      write_text(
        "alone.prm",
        scene(folder, "set Analysis = cea\nset Output directory = alone") +
          estimated + pressed(k == 0 ? "0.5e6" : "2e6"));
      check(run_program({program, "alone.prm"}).code == 0, "one pressure runs");
      const Table       alone   = read_csv("alone/eigenvalues.csv");
      const std::size_t loudest = loudest_of(alone);
      check(alone.real(loudest, "sigma_per_s") > 100.,
            "there is something to compare");
      errors.add(std::abs(matrix.real(k, "sigma_error_mesh_per_s") /
                            alone.real(loudest, "sigma_error_mesh_per_s") -
                          1.));
      for (const std::string column : {"frequency_hz", "sigma_per_s"})
        {
          const double expected = alone.real(loudest, column);
          difference.add(std::abs(matrix.real(k, column) / expected - 1.));
          asymmetry.add(std::abs(matrix.real(k + 2, column) / expected - 1.));
        }
    }
  check(errors.largest() < 1e-6, "errors of growth rates by the mesh as there");
  left_open(program, folder);
  one_sided(program, folder);
  stiffened_by_pressure(program, folder);
  turning(program);
  started_from_the_other_direction(program);
  speeds(program);
  check(difference.largest() < 1e-9, "as the eigenvalue analysis");
  check(asymmetry.largest() < 1e-6, "alike in both directions");
}
