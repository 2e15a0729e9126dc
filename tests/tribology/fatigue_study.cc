// SPDX-License-Identifier: LGPL-2.1-or-later

// The chain from histories to a verdict, with the program. Cracks that follow a
// damage which is a mere function of place, as the generator's, are linked to
// it only as long as nobody asks for the leading edge: any map that
// concentrates there would do as well, and the verdict says undecided. Cracks
// that do not follow it are not linked at all; a verdict on made images says
// so. Arguments: the program, the folder of the parameter files; for histories
// of short transients also the program that computes them.
#include "../analyses/program.h"
#include "worst.h"

#include <squeal/results/table.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

using namespace squeal;
using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  std::string program, transient_program;

  void
  run(std::vector<std::string> arguments)
  {
    const bool is_transient =
      arguments.back().find("_transient.prm") != std::string::npos;
    if (is_transient)
      arguments.insert(arguments.begin(),
                       {"--set",
                        "Transient/End time = 0.008",
                        "--set",
                        "Transient/History start = 0.005"});
    std::vector<std::string> line = {is_transient ? transient_program
                                                  : program};
    line.insert(line.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run_program(line);
    check(outcome.code == 0, arguments.back() + ": " + outcome.errors);
  }



  /** Verdict on crack density against damage of the pads; @p key says which. */
  std::map<int, std::string>
  verdicts(const std::string &directory, const std::string &key = "verdict")
  {
    const auto json =
      nlohmann::json::parse(text_of(directory + "/correlation.json"));
    check(json.at("synthetic").get<bool>(), "the result is marked synthetic");
    std::map<int, std::string> result;
    for (const auto &link : json.at("links"))
      {
        const std::string verdict = link.at(key);
        check(verdict.rfind("synthetic: ", 0) == 0, "a verdict says synthetic");
        if (link.at("index") == "damage_m3_per_s" &&
            link.at("feature") == "crack_density_per_m")
          result[link.at("pad")] = verdict;
      }
    for (const auto &group : json.at("groups"))
      check(group.at("verdict") == "synthetic: undecided",
            "one pad for a group decides nothing");
    return result;
  }



  /** What the chain leaves behind. */
  void
  check_files(const std::string &results)
  {
    for (const char *file : {"squealing_transient/contact_history.h5",
                             "squealing_transient/transient.json",
                             "silent_transient/contact_history.h5",
                             "damage/damage.csv",
                             "damage/subsurface.csv",
                             "damage/damage.h5",
                             "damage/damage.vtu",
                             "damage/totals.csv",
                             "damage/report.html",
                             "silent_damage/damage.csv",
                             "squealing_images/specimen_0001.png",
                             "silent_images/specimen_0101.png",
                             "squealing_segmentation/cells.csv",
                             "squealing_segmentation/segmentation.json",
                             "squealing_segmentation/specimen_0001_cracks.png",
                             "silent_segmentation/cells.csv",
                             "correlation/correlation.json",
                             "correlation/report.html"})
      check(fs::file_size(results + file) > 0, file);
    const Table damage = read_csv(results + "damage/damage.csv");
    check(damage.n_rows() == 121, "121 contact nodes");
    // Where the silent pad does not touch there is nothing to compare with.
    Worst largest;
    for (const double ratio : damage.reals("ratio_damage_m3_per_s"))
      if (std::isfinite(ratio))
        largest.add(ratio);
    check(largest.largest() > 1. && largest.largest() < 1e20,
          "ratios are those of nodes that touch: at most " +
            std::to_string(largest.largest()));
    check(read_csv(results + "silent_transient/transient.csv")
              .text(0, "limit_cycle") == "no",
          "the silent transient has no limit cycle");
    const Table totals = read_csv(results + "damage/totals.csv");
    for (const char *m : {"m3", "m5", "m10"})
      {
        const std::string column = std::string("mean_damage_") + m + "_per_s";
        check(totals.real(0, column) > totals.real(1, column),
              "the squealing transient does more damage, slope " +
                std::string(m));
      }
    const std::string report = text_of(results + "correlation/report.html");
    check(report.find("made, not photographed") != std::string::npos,
          "the report says that the images are made");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 3 || argc == 4, "two or three arguments");
  program           = argv[1];
  transient_program = argc == 4 ? argv[3] : "";
  const fs::path study(argv[2]);
  // The results of the shipped files are relative to the working directory,
  // what they read to the files.
  fs::remove_all("study");
  fs::create_directories("study/prm");
  fs::copy(
    study.parent_path(), "study/prm/tribobrake", fs::copy_options::recursive);
  fs::current_path("study");
  const std::string        name  = study.filename();
  const std::string        place = "prm/tribobrake/" + name + "/";
  std::vector<std::string> files;
  for (const auto &entry : fs::directory_iterator(place))
    files.push_back(entry.path().filename());
  std::sort(files.begin(), files.end());
  for (const std::string &file : files)
    run({place + file});
  const std::string results = "output/tribobrake/" + name + "/";
  if (argc == 4)
    {
      check_files(results);
      verdicts(results + "correlation");
      return 0;
    }
  auto found = verdicts(results + "correlation");
  check(verdicts(results + "correlation", "verdict_without").at(1) ==
          "synthetic: supported",
        "cracks that follow the damage, if nothing else could be the cause");
  check(found.at(1) == "synthetic: undecided",
        "beside the leading edge, which would do as well: " + found.at(1));
  double leading_edge = 0.;
  for (const auto &link :
       nlohmann::json::parse(text_of(results + "correlation/correlation.json"))
         .at("links"))
    if (link.at("pad") == 1 && link.at("index") == "damage_m3_per_s" &&
        link.at("feature") == "crack_density_per_m")
      {
        leading_edge = link.at("leading_edge_correlation");
        check(leading_edge > .85 && link.at("pearson").get<double>() > .85,
              "a map that knows only the leading edge reaches as much");
      }
  check(found.at(2) != "synthetic: supported",
        "the silent pad shows no link: " + found.at(2));
  const std::string report = text_of(results + "correlation/report.html");
  for (const std::string &text : {std::string("In short"),
                                  std::string("What was done"),
                                  "any map that concentrates at the leading "
                                  "edge, lowest y, would reach r = " +
                                    rounded_text(leading_edge, 2),
                                  std::string("data:image/png"),
                                  std::string("made, not photographed")})
    check(report.find(text) != std::string::npos, "the report has: " + text);
  check(report.find("src=\"http") == std::string::npos &&
          report.find("href=\"http") == std::string::npos,
        "the report needs no network");

  // The same chain with cracks anywhere, of which the expected values are not.
  const std::string anywhere = "prm/tribobrake/fatigue_study/anywhere.prm";
  write_text(anywhere, "include 9_correlation.prm\ndrop Result checks\n");
  for (const std::string seed : {"21", "22", "23"})
    {
      run({"--set",
           "Synthetic specimen/Link strength = 0",
           "--set",
           "Synthetic specimen/Damage table =",
           "--set",
           "Synthetic specimen/Damage column =",
           "--set",
           "Synthetic specimen/Seed = " + seed,
           "prm/tribobrake/fatigue_study/5_squealing_images.prm"});
      run({"--set",
           "Images = " + fs::absolute(results + "squealing_images/specimen_00" +
                                      seed + ".png")
                           .string(),
           "prm/tribobrake/fatigue_study/7_squealing_segmentation.prm"});
      run({anywhere});
      found = verdicts(results + "correlation");
      check(found.at(1) != "synthetic: supported",
            "no link, seed " + seed + ": " + found.at(1));
    }
  return 0;
}
