// SPDX-License-Identifier: LGPL-2.1-or-later

// Errors of a ladder are those of the quantity that it names: real parts in
// 1/s, frequencies in Hz, and the finest rung is the one with most unknowns,
// however long another one takes. Argument: the program.

#include <squeal/results/table.h>

#include "program.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  void
  run(const std::vector<std::string> &settings)
  {
    std::filesystem::remove_all("out");
    write_text("brake.prm", small_brake);
    std::vector<std::string> words = {
      program, "--quiet", "--set", "Eigenvalues/Highest frequency = 40000"};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("brake.prm");
    const Outcome o = run_program(words);
    check(o.code == 0, "runs: " + o.errors);
  }

  /** Ladder of degrees with the quantity and the reference. */
  Table
  ladder(const std::string &values,
         const std::string &quantity,
         const std::string &reference)
  {
    run({"Analysis = work precision",
         "Work precision/Ladders = degree",
         "Work precision/Values = " + values,
         "Work precision/Quantity = " + quantity,
         "Work precision/Reference = " + reference});
    return read_csv("out/work_precision.csv");
  }

  std::string
  listed(const std::vector<double> &values, const double factor = 1.)
  {
    std::ostringstream text;
    text.precision(17);
    for (std::size_t i = 0; i < values.size(); ++i)
      text << (i == 0 ? "" : ", ") << factor * values[i];
    return text.str();
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "usage: test_analyses_work_precision PROGRAM");
  program = argv[1];
  run({"Discretization/Degree = 1", "Discretization/Estimate error = false"});
  const Table               pairs = read_csv("out/eigenvalues.csv");
  const std::vector<double> sigma = pairs.reals("sigma_per_s");
  check(sigma.size() > 2, "some pairs are in the band");
  const Table same = ladder("1", "sigma", listed(sigma));
  check(same.real(0, "error_rel") < 1e-6,
        "real parts that are those of the rung have no error: " +
          std::to_string(same.real(0, "error_rel")));
  const Table larger = ladder("1", "sigma", listed(sigma, 1.1));
  check(std::abs(larger.real(0, "error_rel") - .1 / 1.1) < 1e-6,
        "a tenth more is the largest error over the largest real part: " +
          std::to_string(larger.real(0, "error_rel")));

  run({"Analysis = modes",
       "Discretization/Degree = 1",
       "Discretization/Estimate error = false"});
  const std::vector<double> f = read_csv("out/modes.csv").reals("frequency_hz");
  const Table higher          = ladder("1", "frequency", listed(f, 1.0001));
  check(std::abs(higher.real(0, "error_rel") - 1e-4 / 1.0001) < 1e-9,
        "frequencies are given in Hz: " +
          std::to_string(higher.real(0, "error_rel")));

  const Table own = ladder("2, 1", "eigenvalue", "");
  check(own.real(0, "error_rel") == 0. && own.real(1, "error_rel") > 1e-3,
        "the finest rung stands for the truth, wherever it stands");
}
