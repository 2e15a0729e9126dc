// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Parameter files that would never end, and long ones: refused by one line or
// read at once.
#include <squeal/base/timers.h>

#include <squeal/parameters/prm_tree.h>

#include "prm_test.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string
  text_with_entries(const unsigned int n)
  {
    std::string text;
    for (unsigned int i = 0; i < n; ++i)
      text += "set Entry" + std::to_string(i) + " = 1\n";
    return text;
  }



  void
  doubling_includes()
  {
    // 2^40 times the last one without a limit
    for (int i = 0; i < 40; ++i)
      {
        const std::string next = "include d" + std::to_string(i + 1) + ".prm\n";
        write_text("d" + std::to_string(i) + ".prm",
                   "subsection A\n" + next + "end\nsubsection B\n" + next +
                     "end\n");
      }
    write_text("d40.prm", "set E = 1\n");
    check_refused([]() { prm::read_prm_file("d0.prm"); },
                  {"more than 32 files that include each other"},
                  "a chain of 40 includes");
    check_refused([]() { prm::read_prm_file("d15.prm"); },
                  {"more than 200000 lines"},
                  "includes that double 25 times");
    check(prm::read_prm_file("d35.prm").entries.size() == 32,
          "32 copies are read");
  }



  void
  nested_sections()
  {
    std::string deep, path = "set ";
    for (unsigned int i = 0; i < 100000; ++i)
      {
        deep += "subsection A\n";
        path += "a/";
      }
    write_text("deep.prm", deep);
    check_refused([]() { prm::read_prm_file("deep.prm"); },
                  {"deep.prm:34: more than 32 sections"},
                  "sections that are never closed");
    write_text("path.prm", path + "a = 1\n");
    check_refused([]() { prm::read_prm_file("path.prm"); },
                  {"path.prm:1: more than 32 sections"},
                  "a name of a hundred thousand sections");
  }



  void
  long_files()
  {
    write_text("long.prm", text_with_entries(160000));
    const double       start = cpu_seconds();
    const prm::PrmTree tree  = prm::read_prm_file("long.prm");
    const double       time  = cpu_seconds() - start;
    check(tree.entries.size() == 160000, "160 000 entries");
    // 0.5 s in Release; where each entry looked at all before it, a minute
    check(time < 15., "read in " + std::to_string(time) + " s of CPU");
    write_text("longer.prm", text_with_entries(200001));
    check_refused([]() { prm::read_prm_file("longer.prm"); },
                  {"longer.prm: more than 200000 lines"},
                  "a file beyond the limit");
  }



  void
  long_names()
  {
    write_text("name.prm", "set " + std::string(3000000, 'x') + " = 1\n");
    const double start = cpu_seconds();
    check_refused([]() { read_parameters("name.prm"); },
                  {"name.prm:1: unknown entry 'xxx"},
                  "a name of three million letters");
    check(cpu_seconds() - start < 15., "is refused at once");
  }
} // namespace



int
main()
{
  doubling_includes();
  nested_sections();
  long_files();
  long_names();
}
