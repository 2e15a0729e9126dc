// SPDX-License-Identifier: LGPL-2.1-or-later

// What is wrong with the parameters of the damage program alone is found by
// what the program begins with, before there is anything to leave: one line
// that names what to change. What the program makes of such a line is tested
// in programs.cc.
#include "../analyses/program.h"
#include "program_texts.h"

#include <squeal/base/exceptions.h>
#include <squeal/tribology/setup/tribology_parameters.h>

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  void
  refuses_entries(const std::string              &text,
                  const std::vector<std::string> &parts,
                  const std::string              &claim)
  {
    write_text("test.prm", text);
    std::string line;
    try
      {
        read_tribology_parameters("test.prm").check();
      }
    catch (const InputError &error)
      {
        line = error.what();
      }
    check(!line.empty() && line.find('\n') == std::string::npos,
          claim + ": one line: " + line);
    for (const std::string &part : parts)
      check(line.find(part) != std::string::npos,
            claim + ": the line says '" + part + "': " + line);
  }



  void
  lists_of_paths_with_commas()
  {
    namespace fs = std::filesystem;
    fs::create_directory("pad a,b");
    write_text("pad a,b/damage.csv", "x_m\n");
    refuses_entries(replaced_in(correlation_prm,
                                "damage/damage.csv, damage/damage.csv",
                                "damage/damage.csv, pad a,b/damage.csv"),
                    {"test.prm:5: ", "Damage tables", "'pad a,b/damage.csv'"},
                    "a list with a path that has a comma");
    const fs::path here = fs::current_path();
    fs::current_path("pad a,b");
    refuses_entries(correlation_prm,
                    {"Damage tables", "comma", "pad a,b'"},
                    "a list in a folder that has a comma");
    refuses_entries(
      "set Analysis = recorded history\nsubsection Recorded history\n"
      "  set Source = csv\n  set Samples = s.csv\nend\n",
      {"Nodes"},
      "a single path there has its own faults alone");
    fs::current_path(here);
  }



  /** squeal knows the analyses of this program, which knows those of squeal. */
  void
  analyses_of_the_other_program()
  {
    for (const auto &[name, analysis] :
         choices(TribologyParameters::Analysis()))
      {
        write_text("test.prm", "set Analysis = " + name + "\n");
        std::string line;
        try
          {
            read_parameters("test.prm");
          }
        catch (const InputError &error)
          {
            line = error.what();
          }
        check(line.find("is for squeal-tribology") != std::string::npos,
              "squeal does not take 'Analysis = " + name + "': " + line);
      }
    for (const auto &[name, analysis] : choices(Parameters::Analysis()))
      refuses_entries("set Analysis = " + name + "\n",
                      {"test.prm:1: ", "is for squeal;"},
                      "an analysis of squeal");
  }
} // namespace



int
main()
{
  for (const std::string &good :
       {damage_prm, correlation_prm, history_prm("squealing")})
    {
      write_text("test.prm", good);
      read_tribology_parameters("test.prm").check();
    }
  refuses_entries(
    replaced_in(damage_prm, "subsection Subsurface", "subsection Subsurfce"),
    {"unknown section", "Subsurface"},
    "a misspelt section");
  refuses_entries(replaced_in(damage_prm, "dang van,", "dan van,"),
                  {"Criteria", "dang van"},
                  "an unknown criterion");
  refuses_entries(replaced_in(damage_prm, "Samples = 40", "Samples = 1"),
                  {"Samples", "from 8"},
                  "out of range");
  refuses_entries(
    replaced_in(damage_prm, "set Samples = 40", "set Pad thickness = 1e-3"),
    {"Depths", "Pad thickness"},
    "depths beyond the pad");
  refuses_entries(
    replaced_in(damage_prm, "Analysis = damage", "Analysis = damge"),
    {"Analysis", "did you mean 'damage'"},
    "a misspelt analysis");
  refuses_entries(damage_prm +
                    "subsection Fatigue\n  set Constants = 1e6\nend\n",
                  {"Constants", "Exponents"},
                  "constants for some slopes only");
  refuses_entries(damage_prm +
                    "subsection Fatigue\n  set Mean stress = goodman\nend\n",
                  {"Ultimate strength"},
                  "Goodman without a strength");
  refuses_entries(
    damage_prm + "subsection Fatigue\n  set Quantity = traction y\n  set Mean "
                 "stress = goodman\n  set Ultimate strength = 1e5\nend\n",
    {"Mean stress", "sign of the sliding"},
    "a mean stress of a traction");
  refuses_entries(
    replaced_in(history_prm("squealing"), "Duration = 0.02", "Rate = 100"),
    {"Rate", "Frequency"},
    "too few samples a period");
  refuses_entries(
    replaced_in(history_prm("squealing"), "Run = squealing", "Source = csv"),
    {"Samples"},
    "a table that is not named");
  const std::string tables =
    "set Source = csv\n  set Samples = s.csv\n  set Nodes = n.csv\n  set ";
  for (const std::string entry : {"Slip speed = 2",
                                  "Friction coefficient = 0.2",
                                  "Rate = 99999",
                                  "Run = silent"})
    refuses_entries(
      "set Analysis = recorded history\nset Output directory = x\n"
      "subsection Recorded history\n  " +
        tables + entry + "\nend\n",
      {entry.substr(0, entry.find(" =")), "Source = csv"},
      "an entry of the generator beside tables");
  refuses_entries(replaced_in(history_prm("squealing"),
                              "set Run = squealing",
                              "set Samples = s.csv"),
                  {"Samples", "Source = clipped sine"},
                  "a table beside the generator");
  lists_of_paths_with_commas();
  analyses_of_the_other_program();
  refuses_entries(
    replaced_in(correlation_prm, "features.csv, again.csv", "features.csv"),
    {"Feature tables"},
    "fewer tables of features");
  for (const std::string entry :
       {"Test pairs = 500", "Test lengths = 1", "Test patterns = trend"})
    refuses_entries(replaced_in(correlation_prm,
                                "set Feature tables",
                                "set " + entry + "\n  set Feature tables"),
                    {entry.substr(0, entry.find(" =")), "Self test = true"},
                    "an entry of the self test without it");
}
