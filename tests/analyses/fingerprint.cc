// SPDX-License-Identifier: LGPL-2.1-or-later

// What decides whether saved results are taken over: every entry but those of
// one list, the content of every file, the program.

#include <squeal/base/inputs_read.h>
#include <squeal/base/program_id.h>
#include <squeal/parameters/declarations.h>
#include <squeal/run/campaign_runs.h>
#include <squeal/run/fingerprint.h>

#include <fstream>
#include <set>
#include <sstream>

#include <mpi.h>

#include "check.h"
#include "source_directory.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Purpose = Fingerprint::Purpose;

  const std::string prm = SQUEAL_SOURCE_DIR "/prm/";

  void
  every_entry_counts_but_those_listed()
  {
    for (const auto &[file, purpose] :
         {std::pair{"tribobrake/transient.prm", Purpose::motion},
          {"tribobrake/stability_map.prm", Purpose::basis}})
      {
        Parameters        p      = read_parameters(prm + file);
        const std::string before = Fingerprint(p, purpose).text();
        unsigned int      n_left = 0, n_counted = 0;
        for (auto &[path, value] : p.used)
          {
            const std::string generic = squeal::prm::generic_path(path);
            bool              listed  = false;
            for (const LeftOut &l : left_out())
              listed =
                listed ||
                ((purpose == Purpose::motion ? l.of_motion : l.of_basis) &&
                 (l.entry.back() == '/'
                    ? generic.compare(0, l.entry.size(), l.entry) == 0
                    : generic == l.entry));
            const std::string old = value;
            value += "1";
            const bool differs = Fingerprint(p, purpose).text() != before;
            value              = old;
            if (differs == listed)
              check(false,
                    path + (listed ? " is left out" : " counts") + " in " +
                      file);
            ++(listed ? n_left : n_counted);
          }
        check(n_left > 30 && n_counted > 150,
              std::string(file) + ": " + std::to_string(n_counted) +
                " entries count, " + std::to_string(n_left) + " are left out");
      }
  }



  void
  the_list_is_that_of_the_documentation()
  {
    std::ifstream      in(SQUEAL_SOURCE_DIR "/doc/resume.md");
    std::ostringstream text;
    text << in.rdbuf();
    const squeal::prm::GenericSchema schema;
    std::set<std::string>            once;
    for (const LeftOut &l : left_out())
      {
        check(l.entry.back() == '/'
                ? schema->has_section(l.entry.substr(0, l.entry.size() - 1))
                : schema->find(l.entry) != nullptr,
              l.entry + " is there");
        check(once.insert(l.entry).second, "and stands once in the list");
        check(text.str().find("`" + l.entry + "`") != std::string::npos,
              "and in doc/resume.md");
      }
  }



  void
  contents_of_files_count()
  {
    std::ofstream("a.msh") << "one\n";
    std::ofstream("table.csv") << "x\n1\n";
    Parameters  p = read_parameters(prm + "tribobrake/transient.prm",
                                   {"Scene/Body pad/Mesh file = a.msh"});
    Fingerprint before(p, Purpose::motion);
    std::ofstream("a.msh") << "two\n";
    check(Fingerprint(p, Purpose::motion).text() == before.text(),
          "what has been read counts, not what has become of the file since");
    read_input_file("a.msh");
    const Fingerprint after(p, Purpose::motion);
    check(after.difference(before.text())
              .find("Scene/Body pad/Mesh file is 4 bytes, checksum ") == 0,
          "another content differs, and its entry is named");
    read_input_file("table.csv");
    check(Fingerprint(p, Purpose::motion)
              .difference(after.text())
              .find("file table.csv") == 0,
          "a file that no entry names counts when it has been read");
  }



  void
  programs_and_digits_count()
  {
    const Parameters  p    = read_parameters(prm + "tribobrake/transient.prm");
    const std::string text = Fingerprint(p, Purpose::motion).text();
    check(program_id().size() >= 16 &&
            text.find("build of squeal = " + program_id()) != std::string::npos,
          "the build of the program counts");
    const std::string path = "Scene/Body pad/Young modulus";
    const double      E    = get_number(p, path);
    const Fingerprint next(with_value(p, path, E * (1. + 1e-15)),
                           Purpose::motion);
    check(next.difference(text).find(path) == 0,
          "the last digit of a number counts");
    std::string other = text;
    other.replace(other.find("build of squeal = ") + 18, 4, "....");
    check(Fingerprint(p, Purpose::motion)
              .difference(other)
              .find("build of squeal is") == 0,
          "another build is named");
    other.replace(other.find(path + " = ") + path.size() + 3, 1, "9");
    check(Fingerprint(p, Purpose::motion).difference(other).find(path) == 0,
          "an entry goes before the program");
  }



  /** Two runs differ in what the file does not say alone. */
  void
  runs_of_a_campaign_differ()
  {
    const Parameters p = read_parameters(
      prm + "tribobrake/transient.prm",
      {"Sweep/Axes = mu",
       "Sweep/Axis mu/Entries = Scene/Contact pad_disc/Friction coefficient",
       "Sweep/Axis mu/Scale = list",
       "Sweep/Axis mu/Values = 0.3, 0.4",
       "Transient/Tops = free, guided",
       "Transient/Integrators = reduced, implicit"});
    std::set<std::string> texts;
    std::size_t           n = 0;
    for (const auto &group : campaign_groups(p))
      for (const CampaignRun &run : group)
        {
          texts.insert(run.fingerprint.text());
          ++n;
        }
    check(n == 8 && texts.size() == 8,
          "values, tops and integrators tell runs apart");
    const Parameters more = read_parameters(
      prm + "tribobrake/transient.prm",
      {"Sweep/Axes = mu",
       "Sweep/Axis mu/Entries = Scene/Contact pad_disc/Friction coefficient",
       "Sweep/Axis mu/Scale = list",
       "Sweep/Axis mu/Values = 0.3, 0.35, 0.4",
       "Transient/Tops = guided"});
    std::size_t n_known = 0;
    for (const auto &group : campaign_groups(more))
      for (const CampaignRun &run : group)
        n_known += texts.count(run.fingerprint.text());
    check(n_known == 2, "runs that another campaign shares are known");
  }
} // namespace



int
main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  every_entry_counts_but_those_listed();
  the_list_is_that_of_the_documentation();
  contents_of_files_count();
  programs_and_digits_count();
  runs_of_a_campaign_differ();
  MPI_Finalize();
}
