// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Settings of an analysis that contradict each other are refused by a line
// that names the entry; so are imported models that are not complete.
#include "example_scene.h"

#include <squeal/parameters/checks.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  void
  check_change_refused(const std::vector<std::string> &overrides,
                       const std::vector<std::string> &parts)
  {
    check_override_refused("example.prm", overrides, parts, overrides.back());
  }



  void
  band()
  {
    check_change_refused({"Eigenvalues/Highest frequency = 800"},
                         {"example.prm: 'Eigenvalues/Lowest frequency' = 900",
                          "below 'Highest frequency' = 800"});
    check_change_refused({"Eigenvalues/Highest frequency = 900"},
                         {"'Eigenvalues/Lowest frequency'"});
    check_change_refused(
      {"Analysis = sweep", "Discretization/Refinement = eigenvalue error"},
      {"= eigenvalue error would be ignored by 'Analysis = "
       "sweep'"});
    check_change_refused({"Discretization/Refinements = 2"},
                         {"'Discretization/Refinements' = 2", "'uniform'"});
    check_change_refused({"Output directory ="}, {"'Output directory'"});
  }



  /** Every analysis that does not write its matrices says so. */
  void
  exported_matrices()
  {
    const std::string entry = "Output/Export matrices = true";
    for (const char *analysis : {"sweep",
                                 "frequency response",
                                 "updating",
                                 "angles",
                                 "limit cycle",
                                 "operating matrix",
                                 "triggers"})
      {
        const Parameters p = read_parameters(
          "example.prm", {entry, std::string("Analysis = ") + analysis});
        check_refused([&]() { prm::check_export(p); },
                      {"'Output/Export matrices' = true would be ignored",
                       std::string("'Analysis = ") + analysis,
                       "'modes', 'cea', 'preload'"},
                      std::string("matrices of ") + analysis);
      }
    for (const char *analysis :
         {"modes", "cea", "preload", "work precision", "transient"})
      prm::check_export(read_parameters(
        "example.prm", {entry, std::string("Analysis = ") + analysis}));
    Parameters campaign =
      read_parameters("example.prm", {entry, "Analysis = transient"});
    campaign.transient.tops = {"clamped"};
    check_refused([&]() { prm::check_export(campaign); },
                  {"'Output/Export matrices'", "over several runs"},
                  "matrices of a campaign");
    check_change_refused({"Analysis = angles",
                          "Angles/Turning bodies = disc",
                          "Angles/To = 10",
                          entry},
                         {"'Output/Export matrices'"});
  }



  void
  ladders()
  {
    const std::string analysis = "Analysis = work precision";
    const std::string degrees  = "Work precision/Ladders = degree";
    check_change_refused({analysis}, {"'Work precision/Ladders' is empty"});
    check_change_refused({analysis, degrees},
                         {"'Work precision/Values' is empty", "'degree'"});
    check_change_refused({analysis, degrees, "Work precision/Values = 1, 1.5"},
                         {"contains 1.5", "whole number from 1 to 8"});
    check_change_refused({analysis,
                          "Work precision/Ladders = basis, degree",
                          "Work precision/Values = 1, 2"},
                         {"contains 2", "'basis'"});
    read_parameters("example.prm",
                    {analysis, degrees, "Work precision/Values = 1, 2, 3"})
      .check();

    const std::string cells = "Work precision/Ladders = cells";
    check_change_refused({analysis, cells, "Work precision/Values = 1, 0"},
                         {"contains 0", "'cells'", "at most 100"});
    write_text("pad.msh", "");
    check_change_refused({analysis,
                          cells,
                          "Work precision/Values = 1",
                          "Scene/Body pad/Shape = gmsh",
                          "Scene/Body pad/Mesh file = pad.msh"},
                         {"'Work precision/Ladders'", "'pad'", "refinement"});
    read_parameters("example.prm",
                    {analysis, cells, "Work precision/Values = 0.5, 1, 1.6"})
      .check();
  }



  /** A target whose mesh turns. */
  void
  disc_frame()
  {
    const std::vector<std::string> turning = {
      "Analysis = transient",
      "Scene/Contact pad_disc/Formulation = mortar",
      "Scene/Contact pad_disc/Friction direction = slip",
      "Discretization/Mass = lumped",
      "Discretization/Estimate error = false",
      "Transient/Disc frame = corotating"};
    const auto with = [&](const std::string &change) {
      std::vector<std::string> result = turning;
      result.push_back("Transient/Integrator = explicit");
      result.push_back(change);
      return result;
    };
    read_parameters("example.prm", with("Transient/Integrator = implicit"))
      .check();
    check_change_refused(with("Transient/Integrator = reduced"),
                         {"'Transient/Disc frame'",
                          "the reduced model holds the disc's flexibility"});
    check_change_refused(with("Scene/Contact pad_disc/Formulation = node to "
                              "surface"),
                         {"'Transient/Disc frame'", "Formulation = mortar"});
    check_change_refused(
      with("Scene/Contact pad_disc/Friction direction = fixed y"),
      {"'Transient/Disc frame'", "Friction direction = slip"});
    check_change_refused(with("Scene/Body disc/Rotation speed = 3"),
                         {"'Transient/Disc frame'", "Rotation speed = 0"});
    check_change_refused(with("Scene/Spring row_exit/Other body = disc"),
                         {"'Transient/Disc frame'", "joins it"});
    Parameters loaded =
      read_parameters("example.prm", with("Transient/Integrator = implicit"));
    LumpedMassParameters mass;
    mass.name = "weight";
    mass.body = "disc";
    loaded.scene.lumped_masses.push_back(mass);
    check_refused([&]() { prm::check_transient(loaded); },
                  {"'Transient/Disc frame'", "weight", "Coriolis"},
                  "a lumped mass on a disc whose mesh turns");
  }



  /** The contact of an updating is that of its start. */
  void
  updating_about_preload()
  {
    Parameters p = read_parameters("example.prm", {"Analysis = updating"});
    UpdatedNumberParameters number;
    number.name               = "modulus";
    number.entries            = {"Scene/Body pad/Young modulus"};
    p.updating.numbers        = {number};
    p.scene.contacts[0].state = ContactParameters::State::preload;
    check_refused([&]() { prm::check_response(p); },
                  {"Contact state", "= preload", "start"},
                  "updating about a contact that the numbers change");
  }



  /** What has no motion in time is refused before any work. */
  void
  damping_in_time()
  {
    const std::vector<std::string> transient = {
      "Analysis = transient",
      "Scene/Contact pad_disc/Formulation = mortar",
      "Discretization/Mass = lumped",
      "Discretization/Estimate error = false"};
    const auto whole = [&](std::vector<std::string> more) {
      more.insert(more.begin(), transient.begin(), transient.end());
      return more;
    };
    const auto parts = [&](const std::string &entry) {
      return whole({"Scene/Damping/Model = per part",
                    "Scene/Damping/Mass damping = 0",
                    "Scene/Damping/Stiffness damping = 0",
                    entry});
    };
    check_change_refused(whole({"Scene/Damping/Structural damping = 0.1"}),
                         {"'Scene/Damping/Structural damping'", "viscous"});
    check_change_refused(parts("Scene/Body pad/Structural damping = 0.1"),
                         {"'Scene/Body pad/Structural damping'", "viscous"});
    check_change_refused(
      parts("Scene/Contact pad_disc/Stiffness damping = 1e-7"),
      {"'Scene/Contact pad_disc/Stiffness damping'", "must be 0"});
    read_parameters("example.prm",
                    parts("Scene/Body pad/Stiffness damping = 1e-7"))
      .check();
  }



  /** All unknowns have no cut-off to damp. */
  void
  cut_off_damping()
  {
    const auto with = [](const std::string &integrator) {
      return std::vector<std::string>{
        "Analysis = transient",
        "Scene/Contact pad_disc/Formulation = mortar",
        "Discretization/Mass = lumped",
        "Discretization/Estimate error = false",
        "Transient/Cut-off damping = 0.2",
        integrator};
    };
    read_parameters("example.prm", with("Transient/Integrator = reduced"))
      .check();
    for (const std::string integrator :
         {"Transient/Integrator = implicit",
          "Transient/Integrator = explicit",
          "Transient/Integrators = reduced, explicit"})
      check_change_refused(
        with(integrator),
        {"'Transient/Cut-off damping'", "the reduced integrator"});
  }



  void
  limit_cycles()
  {
    const std::vector<std::string> scene = {
      "Analysis = limit cycle",
      "Scene/Contact pad_disc/Formulation = mortar",
      "Scene/Contact pad_disc/Transverse slip term = true",
      "Scene/Contact pad_disc/Sliding speed = 0.1"};
    const auto refuse = [&](const std::string              &change,
                            const std::vector<std::string> &parts) {
      std::vector<std::string> all = scene;
      all.push_back(change);
      check_change_refused(all, parts);
    };
    read_parameters("example.prm", scene).check();
    refuse("Scene/Contact pad_disc/Friction law = exponential",
           {"'Scene/Contact pad_disc/Friction law'", "must be constant"});
    refuse("Scene/Contact pad_disc/Sliding speed = 0",
           {"'Scene/Contact pad_disc/Sliding speed' = 0", "pairs that slide"});
    refuse("Transient/Integrator = implicit",
           {"'Transient/Integrator'", "must be reduced"});
    refuse("Limit cycle/Steps per period = 8",
           {"'Limit cycle/Steps per period' = '8'", "from 32 to"});
    refuse("Scene/Contact pad_disc/Contact state = stick",
           {"'Scene/Contact pad_disc/Contact state' = stick", "full"});
    refuse("Transient/Friction impulse = 0.3",
           {"'Transient/Friction impulse'", "must be 0"});
    refuse("Transient/Hammer/Body = pad",
           {"'Transient/Hammer/Body'", "must be empty"});
    refuse("Transient/Animation frames = 10",
           {"'Transient/Animation frames'", "must be 0"});
    refuse("Transient/Compare with CEA = true",
           {"'Transient/Compare with CEA'", "must be false"});
    refuse("Transient/Start = ramp",
           {"'Transient/Start'", "must be steady sliding"});
    refuse("Transient/Final speed ratio = 0.5",
           {"'Transient/Final speed ratio'", "must be 1"});
    const auto branch = [&](const std::string &entry, const std::string &from) {
      std::vector<std::string> all = scene;
      all.insert(all.end(),
                 {"Sweep/Axes = mu",
                  "Sweep/Axis mu/Entries = " + entry,
                  "Sweep/Axis mu/From = " + from,
                  "Sweep/Axis mu/To = 0.6"});
      return all;
    };
    const std::string mu = "Scene/Contact pad_disc/Friction coefficient";
    read_parameters("example.prm", branch(mu, "0.1")).check();
    read_parameters("example.prm",
                    branch("Scene/Body pad/Young modulus", "0.1"))
      .check();
    check_change_refused(branch(mu, "-0.1"),
                         {"'Sweep/Axis mu/From'", "direction of sliding"});
    check_change_refused(branch("Scene/Contact pad_disc/Sliding speed", "0"),
                         {"'Sweep/Axis mu/From'", "direction of sliding"});
    check_change_refused(branch(mu, "0.7"), {"'Sweep/Axis mu/From'", "below"});
    auto with_starts = branch(mu, "0.1");
    with_starts.push_back("Limit cycle/Starts = 3");
    check_change_refused(with_starts, {"'Limit cycle/Starts'", "'Campaign'"});
    refuse("Limit cycle/Starts = 101", {"'Limit cycle/Starts'", "100"});
  }



  /** Blows of 'Analysis = triggers' and how motions are judged. */
  void
  triggers()
  {
    const auto with = [](const std::vector<std::string> &changes) {
      std::vector<std::string> all = {
        "Analysis = triggers",
        "Scene/Contact pad_disc/Formulation = mortar",
        "Scene/Contact pad_disc/Transverse slip term = true",
        "Scene/Contact pad_disc/Sliding speed = 0.1",
        "Measurement/Points = here",
        "Measurement/Point here/Body = pad",
        "Triggers/Impulses = 0.1, 0.2"};
      all.insert(all.end(), changes.begin(), changes.end());
      return all;
    };
    read_parameters("example.prm", with({})).check();
    const std::pair<std::string, std::vector<std::string>> faults[] = {
      {"Triggers/Impulses =", {"'Triggers/Impulses'", "is empty"}},
      {"Triggers/Impulses = 0.2, 0.1", {"'Triggers/Impulses'", "ascend"}},
      {"Triggers/Points = there",
       {"'Triggers/Points'", "'there'", "'Measurement/Points'"}},
      {"Triggers/Points = here, here", {"'Triggers/Points'", "twice"}},
      {"Triggers/Window = 1e-6", {"'Triggers/Window'", "ten"}},
      {"Triggers/Duration = 1e-6", {"'Triggers/Duration'", "ten"}},
      {"Triggers/Hold time = 2e-3", {"'Triggers/Hold time'", "two 'Window'"}},
      {"Triggers/Longest time = 0.02",
       {"'Triggers/Longest time'", "twice 'Hold time'"}},
      {"Triggers/Tolerance = 0.6", {"'Triggers/Tolerance'"}},
      {"Transient/Friction impulse = 0.1",
       {"'Transient/Friction impulse'", "must be 0"}},
      {"Transient/Final speed ratio = 0.5",
       {"'Transient/Final speed ratio'", "must be 1"}},
      {"Transient/Start = ramp",
       {"'Transient/Start'", "must be steady sliding"}},
      {"Scene/Contact pad_disc/Contact state = stick",
       {"'Scene/Contact pad_disc/Contact state' = stick", "steady sliding"}},
      {"Transient/Integrator = implicit",
       {"'Transient/Integrator'", "must be reduced"}}};
    for (const auto &[change, parts] : faults)
      check_change_refused(with({change}), parts);
  }



  /** Eigenvalues and transient are compared with the same terms only. */
  void
  comparison_with_eigenvalues()
  {
    const std::vector<std::string> alike = {
      "Analysis = transient",
      "Scene/Contact pad_disc/Formulation = mortar",
      "Scene/Contact pad_disc/Transverse slip term = true",
      "Discretization/Estimate error = false",
      "Transient/Compare with CEA = true"};
    const auto with = [&](const std::string &change) {
      std::vector<std::string> result = alike;
      result.push_back(change);
      return result;
    };
    read_parameters("example.prm", alike).check();
    check_change_refused(
      with("Scene/Contact pad_disc/Transverse slip term = false"),
      {"'Scene/Contact pad_disc/Transverse slip term'",
       "'Transient/Compare with CEA'"});
    check_change_refused(
      with("Transient/Final speed ratio = 2"),
      {"'Transient/Compare with CEA'", "Final speed ratio = 1"});
    check_change_refused(
      with("Transient/Start = ramp"),
      {"'Transient/Compare with CEA'", "Start = steady sliding"});
  }



  void
  result_checks()
  {
    write_text("checks.prm",
               std::string(example_scene()) +
                 "subsection Result checks\n"
                 "  set Checks = f\n"
                 "  subsection Check f\n"
                 "    set Table = modes.csv\n"
                 "    set Where = name = (0,4)+ and frequency_hz > 900\n"
                 "    set Nearest = frequency_hz = 4992\n"
                 "    set Column = frequency_hz\n"
                 "    set Expected = 4992\n"
                 "    set Relative tolerance = 0.01\n"
                 "  end\n"
                 "end\n");
    const Parameters p = read_parameters("checks.prm");
    p.check();
    check(p.result_checks.size() == 1 &&
            p.result_checks[0].where ==
              "name = (0,4)+ and frequency_hz > 900" &&
            p.result_checks[0].nearest == "frequency_hz = 4992",
          "conditions keep their commas and signs");

    const std::string f       = "Result checks/Check f/";
    const auto        refused = [&](const std::string &override_text,
                             const std::string &part) {
      check_override_refused(
        "checks.prm", {override_text}, {"'" + f, part}, override_text);
    };
    refused(f + "Table =", "Table' is empty");
    refused(f + "Column =", "Column' is empty");
    refused(f + "Where = name", "column = value");
    refused(f + "Where = name == (0,4)+", "the comparisons are");
    refused(f + "Where = index >< 4", "the comparisons are");
    refused(f + "Where = name = \"(0,4)+\"", "without quotes");
    refused(f + "Where = name = (0,4)+ AND index = 1", "write 'and'");
    refused(f + "Where = name = (0,4)+ and index", "column = value");
    refused(f + "Nearest = frequency_hz", "column = number");
    refused(f + "Nearest = name = x", "column = number");
    refused(f + "Relative tolerance = 0", "both 0");
  }



  void
  imported_models()
  {
    write_text("k.mtx", "");
    write_text("m.mtx", "");
    write_text("matrices.prm",
               "subsection Scene\n"
               "  set Kind = matrices\n"
               "  set Matrix parts = m, k\n"
               "  subsection Matrix part m\n"
               "    set File = m.mtx\n    set Role = mass\n  end\n"
               "  subsection Matrix part k\n"
               "    set File = k.mtx\n    set Role = stiffness\n  end\n"
               "end\n");
    const std::string file = "matrices.prm";
    read_parameters(file).check();
    check_override_refused(file,
                           {"Scene/Matrix part m/Role = damping"},
                           {"'Scene/Matrix parts'", "Role = mass"},
                           "no mass");
    check_override_refused(file,
                           {"Scene/Matrix part k/Role = friction"},
                           {"Role = stiffness"},
                           "no stiffness");
    check_override_refused(file,
                           {"Scene/Matrix part k/File = none.mtx"},
                           {"'Scene/Matrix part k/File'", "no such file"},
                           "missing matrix");
    check_override_refused(file,
                           {"Scene/Matrix part k/File = ."},
                           {"is a directory"},
                           "folder instead of a matrix");
    check_override_refused(file,
                           {"Scene/Contact pattern file = m.mtx"},
                           {"'Scene/Contact normal stiffness'"},
                           "contact pattern without a stiffness");
    check_override_refused(file,
                           {"Analysis = work precision",
                            "Work precision/Ladders = degree",
                            "Work precision/Values = 1"},
                           {"'Work precision/Ladders'", "no mesh"},
                           "degrees of matrices");
    check_override_refused("example.prm",
                           {"Scene/Kind = matrices"},
                           {"'Scene/Bodies'", "Kind = bodies"},
                           "bodies in a scene of matrices");
  }
} // namespace

int
main()
{
  write_example();
  band();
  exported_matrices();
  ladders();
  disc_frame();
  updating_about_preload();
  comparison_with_eigenvalues();
  cut_off_damping();
  damping_in_time();
  limit_cycles();
  triggers();
  result_checks();
  imported_models();
}
