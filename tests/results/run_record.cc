// SPDX-License-Identifier: LGPL-2.1-or-later
// run.json says all about a run, is read back, and refuses what it is not.
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/results/run_record.h>

#include <filesystem>
#include <fstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const std::string path = "run_record_test.json";

  RunRecord
  example()
  {
    RunRecord record;
    record.versions       = {{"squeal", "0.1.0"}, {"deal.II", "9.4.1"}};
    record.analysis       = "cea";
    record.scene          = "tribobrake";
    record.parameter_file = "prm/tribobrake/cea.prm";
    record.parameters     = {{"Scene/Friction coefficient", "0.5"},
                             {"Analysis", "cea"}};
    record.figures        = {{"unstable pairs", "2"}};
    record.n_dofs         = 55123;
    record.dofs_of_bodies = {{"disc", 50000}, {"pad", 5123}};
    record.n_ranks        = 2;
    record.settings       = {"Scene/Body pad/Density = 2600"};
    record.void_checks    = {"growth"};
    record.void_cause     = record.settings[0];
    record.warnings       = {"a \"quoted\" warning"};
    record.files          = {"modes.csv"};
    ResultCheck good, bad;
    good.name      = "first";
    good.passed    = true;
    good.has_value = true;
    good.got       = 3520.01;
    good.expected  = 3520.;
    good.tolerance = 7.;
    good.n_rows    = 1;
    bad.name       = "second";
    bad.reason     = "no row";
    record.checks  = {good, bad};
    Timers timers;
    {
      Timers::Section section(timers, "Solve: modes");
    }
    record.take_timings(timers);
    return record;
  }

  void
  refused(const std::string &content,
          const std::string &message,
          const std::string &claim)
  {
    std::ofstream(path) << content;
    check_throws<InputError>([] { read_run_record(path); }, message, claim);
  }
} // namespace

int
main()
{
  const RunRecord written = example();
  write_run_record(written, path);
  const std::string text = read_file(path);
  const RunRecord   read = read_run_record(path);
  write_run_record(read, path);
  check(read_file(path) == text, "a record that is read back writes the same");
  check(read.parameters == written.parameters &&
          read.versions == written.versions && read.n_dofs == 55123 &&
          read.dofs_of_bodies == written.dofs_of_bodies &&
          read.warnings == written.warnings && read.n_ranks == 2,
        "entries come back in their order");
  check(read.settings == written.settings &&
          read.void_checks == written.void_checks &&
          read.void_cause == written.void_cause,
        "so do settings and the checks that they have made void");
  check(read.checks.size() == 2 && read.checks[0].got == 3520.01 &&
          read.checks[1].reason == "no row" && !read.checks[1].has_value,
        "so do the result checks");
  check(read.timings.size() == 1 && read.timings[0].name == "Solve: modes" &&
          read.peak_memory_mb > 0.5,
        "so do times and memory");

  std::string newer = text;
  newer.replace(newer.find("\"format_version\": 1"),
                std::string("\"format_version\": 1").size(),
                "\"format_version\": 99");
  refused(newer,
          "format version 99; this program reads 1",
          "a version that is not known is refused by number");
  refused("{\"format_version\": 1}",
          "is not the record of a run",
          "a record without its entries is refused");
  refused(text.substr(0, text.size() / 2),
          "is not the record of a run",
          "a truncated record is refused");
  check_throws<InputError>([] { read_run_record("no_record.json"); },
                           "No such file",
                           "a missing record is named");

  RunRecord strange  = written;
  strange.warnings   = {"bytes that are no UTF-8: \xff\xfe"};
  strange.parameters = {{"file", "\xc3"}};
  write_run_record(strange, path);
  check(read_run_record(path).warnings.size() == 1,
        "bytes that are no UTF-8 do not spoil the record");
  std::filesystem::remove(path);
}
