// SPDX-License-Identifier: LGPL-2.1-or-later

// The program from end to end: histories, damage, correlation; and what a user
// can get wrong ends in one line and a non-zero exit code, with no results.
// Argument: the program.
#include "../analyses/program.h"
#include "program_texts.h"
#include "worst.h"

#include <squeal/results/table.h>
#include <squeal/tribology/damage/damage_table.h>
#include <squeal/tribology/statistics/spatial.h>

#include <nlohmann/json.hpp>

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  std::string program;

  Outcome
  run(const std::string &text)
  {
    write_text("test.prm", text);
    return run_program({program, "test.prm"});
  }

  void
  runs(const std::string &text, const std::string &claim)
  {
    const Outcome outcome = run(text);
    check(outcome.code == 0, claim + ": " + outcome.errors);
  }

  /** The file for ParaView holds what the table holds. */
  void
  check_vtu(const Table &table)
  {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName("damage/damage.vtu");
    reader->Update();
    vtkUnstructuredGrid *grid = reader->GetOutput();
    check(grid->GetNumberOfPoints() == 25 && grid->GetNumberOfCells() == 16,
          "damage.vtu: 25 nodes, 16 cells");
    for (const char *name : {"x_m", "y_m", "damage_m5_per_s"})
      {
        vtkDataArray *values = grid->GetPointData()->GetArray(name);
        check(values != nullptr, std::string("damage.vtu has ") + name);
        for (vtkIdType i = 0; i < 25; ++i)
          check(std::abs(values->GetTuple1(i) - table.real(i, name)) <=
                  1e-9 * std::abs(table.real(i, name)),
                std::string("damage.vtu: ") + name);
      }
    for (vtkIdType i = 0; i < 25; ++i)
      check(std::abs(grid->GetPoint(i)[1] - table.real(i, "y_m")) < 1e-12,
            "damage.vtu: places");
  }



  /** The words that a reader sees of a page up to its parameters, marks between
   * them. */
  std::string
  visible(const std::string &path)
  {
    std::string page = text_of(path), words;
    for (const std::string part : {"script", "style"})
      for (std::size_t from = page.find("<" + part); from != std::string::npos;
           from             = page.find("<" + part))
        page.erase(from, page.find("</" + part, from) - from);
    bool is_mark = false;
    for (const char c : page)
      {
        is_mark = is_mark || c == '<';
        if (!is_mark)
          words += c;
        else if (c == '>')
          {
            is_mark = false;
            words += '|';
          }
      }
    return words.substr(0, words.rfind("How to repeat"));
  }



  /** The longest run of digits after a point. */
  int
  most_decimals(const std::string &text)
  {
    int most = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '.')
        {
          int n = 0;
          while (i + 1 < text.size() && text[i + 1] >= '0' &&
                 text[i + 1] <= '9')
            {
              ++n;
              ++i;
            }
          if (n > most)
            most = n;
        }
    return most;
  }



  /** Reports have verdicts with and without shared causes side by side, no
   * number of nine digits or more and no section of an analysis that did not
   * run. */
  void
  check_reports()
  {
    for (const char *file : {"damage/report.html", "correlation/report.html"})
      {
        const std::string text = visible(file);
        check(most_decimals(text) < 9,
              std::string(file) + " has no squeezed digits: " +
                std::to_string(most_decimals(text)));
        check(text.find("nan") == std::string::npos &&
                text.find("is not there") == std::string::npos,
              std::string(file) + " speaks of what is there");
      }
    const std::string damage = visible("damage/report.html");
    check(damage.find("MPa") != std::string::npos &&
            damage.find("an application is 1200 s of it") != std::string::npos,
          "engineering units, and what an application is");
    const std::string links = visible("correlation/report.html");
    check(links.find("verdict without") != std::string::npos &&
            links.find("verdict without") > links.find("verdict") &&
            links.find("shared causes taken out") != std::string::npos,
          "verdicts with and without shared causes side by side");
    check(links.find("|Overlays|") == std::string::npos,
          "no section of images where none were read");
  }



  /** With a thickness the pad is a block, and few points are flagged. */
  void
  check_block()
  {
    const Table half_space = read_csv("damage/subsurface.csv");
    runs(replaced_in(damage_prm,
                     "  set Samples = 40\n",
                     "  set Samples = 40\n  set Pad thickness = 0.01\n"
                     "  set Finest cell = 4e-4\n"),
         "damage in a block");
    const Table block = read_csv("damage/subsurface.csv");
    check(block.n_rows() == half_space.n_rows(), "the same points");
    int   before = 0, after = 0;
    Worst change;
    for (std::size_t i = 0; i < block.n_rows(); ++i)
      {
        before += int(half_space.real(i, "near_edge"));
        after += int(block.real(i, "near_edge"));
        check(half_space.text(i, "field") == "half-space" &&
                block.text(i, "field") == "block",
              "the field of row " + std::to_string(i));
        if (half_space.real(i, "near_edge") == 0.)
          change.add(std::abs(
            block.real(i, "dang_van") / half_space.real(i, "dang_van") - 1.));
      }
    std::cout << before << " points flagged, in a block " << after
              << ", Dang Van changes by at most " << change.largest() << "\n";
    check(after < before, "fewer points are flagged");
    check(change.largest() > .05 && change.largest() < 2.,
          "the sides matter to Dang Van");
  }



  void
  whole_chain()
  {
    for (const std::string name : {"squealing", "silent"})
      {
        runs(history_prm(name), name + " history");
        check(fs::exists(name + "/history.h5") &&
                fs::exists(name + "/run.json") &&
                fs::exists(name + "/report.html"),
              name + ": files");
      }
    runs(damage_prm, "damage");
    for (const char *file : {"damage.csv",
                             "damage.h5",
                             "damage.vtu",
                             "totals.csv",
                             "subsurface.csv",
                             "run.json",
                             "report.html"})
      check(fs::exists(std::string("damage/") + file), file);
    const Table table = read_csv("damage/damage.csv");
    check(table.n_rows() == 25, "25 nodes");
    const Table totals = read_csv("damage/totals.csv");
    check(totals.real(0, "mean_damage_m3_per_s") >
            1e3 * totals.real(1, "mean_damage_m3_per_s"),
          "squeal does far more damage");
    check(std::abs(totals.real(0, "mean_pressure_pa") /
                     totals.real(1, "mean_pressure_pa") -
                   1.) < .03,
          "at the same mean pressure");
    double leading = 0., trailing = 0.;
    for (std::size_t i = 0; i < 25; ++i)
      (table.real(i, "y_m") < -4e-3 ? leading : trailing) =
        std::max(table.real(i, "y_m") < -4e-3 ? leading : trailing,
                 table.real(i, "damage_m5_per_s"));
    check(leading > 10. * trailing, "most at the leading edge");
    check_vtu(table);

    // chunks and a second run change no byte
    const std::string before = text_of("damage/damage.csv");
    runs(replaced_in(damage_prm,
                     "subsection History\n",
                     "subsection History\n  set Chunk = 100\n"),
         "damage in small pieces");
    check(text_of("damage/damage.csv") == before, "the same to the last digit");

    check_block();

    std::string features = "x_m,y_m,crack_density_per_m\n";
    for (std::size_t i = 0; i < 25; ++i)
      features += table.text(i, "x_m") + "," + table.text(i, "y_m") + "," +
                  table.text(i, "damage_m3_per_s") + "\n";
    write_text("features.csv", features);
    write_text("again.csv", features + "0,0,1\n");
    runs(correlation_prm, "correlation");
    const auto json =
      nlohmann::json::parse(text_of("correlation/correlation.json"));
    check(json.at("links").size() == 2 &&
            json.at("links")[0].at("pearson").get<double>() > .999,
          "a feature that is the index itself");
    check(json.at("links")[0].at("verdict") == "synthetic: supported" &&
            json.at("links")[0].at("verdict_without") ==
              "synthetic: supported" &&
            json.at("links")[0].at("p_conditional").get<double>() < 1e-6 &&
            json.at("links")[0].at("conditional_cells").get<double>() < 20. &&
            json.at("shared_causes").size() == 3,
          "it is supported with and without shared causes, on few cells");
    check(text_of("correlation/run.json").find("25 cells are known, worth") !=
            std::string::npos,
          "which is warned of");
    check_reports();
    for (const auto &link : json.at("links"))
      check(link.at("verdict").get<std::string>().rfind("synthetic: ", 0) == 0,
            "synthetic verdicts say so");
    check(json.at("groups").size() == 1 &&
            json.at("groups")[0].at("verdict") == "synthetic: undecided",
          "one silent and one squealing pad leave it undecided");
  }

  void
  refuses(const std::string              &text,
          const std::vector<std::string> &parts,
          const std::string              &claim)
  {
    fs::remove_all("refused");
    std::string changed = text;
    const auto  at      = changed.find("set Output directory = ");
    changed.replace(
      at, changed.find('\n', at) - at, "set Output directory = refused");
    const Outcome outcome = run(changed);
    check(outcome.code == 2,
          claim + ": exit code " + std::to_string(outcome.code) + " (" +
            outcome.errors + ")");
    check(outcome.errors.rfind("squeal: ", 0) == 0 &&
            outcome.errors.find('\n') == outcome.errors.size() - 1,
          claim + ": one line: " + outcome.errors);
    for (const std::string &part : parts)
      check(outcome.errors.find(part) != std::string::npos,
            claim + ": the line says '" + part + "': " + outcome.errors);
    for (const auto &[name, content] : files_below("refused"))
      check(name == "run.log" || name == ".squeal_files",
            claim + ": no results (" + name + ")");
  }

  void
  bad_input()
  {
    refuses(replaced_in(damage_prm, "set Samples", "set Smples"),
            {"unknown entry", "Samples"},
            "a misspelt entry");
    refuses(
      replaced_in(damage_prm, "set Samples = 40", "set Pad thickness = 3e-3"),
      {"Pad thickness", "contact nodes"},
      "a pad that is thin for its nodes");
    const Outcome own = run(replaced_in(damage_prm,
                                        "set Output directory = damage",
                                        "set Output directory = squealing"));
    check(own.code == 2 &&
            own.errors.find("'History/File' reads") != std::string::npos &&
            own.errors.find("history.h5 is a result of an earlier run") !=
              std::string::npos &&
            fs::exists("squealing/history.h5"),
          "a history in the output directory is refused and stays: " +
            own.errors);
    refuses(replaced_in(damage_prm, "squealing/history.h5", "nowhere.h5"),
            {"History/File", "nowhere.h5"},
            "a missing history");
    refuses(replaced_in(damage_prm, "squealing/history.h5", "squealing"),
            {"History/File"},
            "a history that is a folder");
    write_text("garbage.h5", std::string(3000, '\x7f'));
    refuses(replaced_in(damage_prm, "squealing/history.h5", "garbage.h5"),
            {"garbage.h5", "no HDF5"},
            "garbage");
    fs::copy_file(
      "squealing/history.h5", "cut.h5", fs::copy_options::overwrite_existing);
    fs::resize_file("cut.h5", fs::file_size("cut.h5") * 2 / 3);
    refuses(replaced_in(damage_prm, "squealing/history.h5", "cut.h5"),
            {"cut.h5", "is damaged"},
            "a truncated history");
    refuses(replaced_in(damage_prm, "end\n", "  set Start time = 5\nend\n"),
            {"Start time"},
            "a window without samples");
    write_text(
      "other.prm",
      replaced_in(replaced_in(history_prm("silent"), "edge = 5", "edge = 4"),
                  "= silent\nset Ov",
                  "= other\nset Ov"));
    check(run_program({program, "other.prm"}).code == 0, "another mesh");
    refuses(replaced_in(damage_prm, "silent/history.h5", "other/history.h5"),
            {"other contact nodes"},
            "runs on different meshes");
    refuses(replaced_in(correlation_prm, "damage_m3_per_s", "damage_m4_per_s"),
            {"damage_m4_per_s"},
            "an unknown index");
    fs::copy_file(
      "features.csv", "copy.csv", fs::copy_options::overwrite_existing);
    for (const std::string same :
         {"features.csv", "./features.csv", "copy.csv"})
      refuses(replaced_in(correlation_prm,
                          "features.csv, again.csv",
                          "features.csv, " + same),
              {"Feature tables",
               "same pad twice",
               fs::path(same).filename().string()},
              "a pad that counts twice: " + same);
    write_text("away.csv", "x_m,y_m,f\n1,1,1\n");
    refuses(replaced_in(correlation_prm,
                        "features.csv, again.csv",
                        "features.csv, away.csv"),
            {"away.csv:2", "no cell"},
            "a feature beside the pad");
    write_text("nan.csv", "x_m,y_m,f\n0,0,nan\n");
    refuses(replaced_in(correlation_prm,
                        "features.csv, again.csv",
                        "features.csv, nan.csv"),
            {"nan.csv:2"},
            "a feature that is no number");
    write_text("lacks.csv", "x_m,f\n0,0\n");
    refuses(replaced_in(correlation_prm,
                        "features.csv, again.csv",
                        "features.csv, lacks.csv"),
            {"lacks.csv", "y_m"},
            "a missing column");
  }

  /** By the program itself, which starts anew. */
  void
  command_line()
  {
    // existing results
    write_text("test.prm",
               replaced_in(damage_prm, "set Overwrite = true\n", ""));
    const Outcome outcome = run_program({program, "test.prm"});
    check(outcome.code == 2 && fs::exists("damage/damage.csv"),
          "existing results stay: " + outcome.errors);
    check(run_program({program, "--nonsense"}).code == 2 &&
            run_program({program}).code == 2 &&
            run_program({program, "--help"}).code == 0 &&
            run_program({program, "--version"}).code == 0,
          "the command line");
    const Outcome defaults = run_program({program, "--print-defaults"});
    write_text("defaults.prm",
               replaced_in(defaults.output,
                           "set File =\n",
                           "set File = squealing/history.h5\n"));
    check(run_program({program, "--validate", "defaults.prm"}).code == 0,
          "the printed defaults can be read");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument: the program");
  program = argv[1];
  whole_chain();
  bad_input();
  programs_start_anew = true;
  command_line();
}
