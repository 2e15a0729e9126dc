// SPDX-License-Identifier: LGPL-2.1-or-later

// The brake whose matrices CalculiX stores: the first thirty frequencies are
// those that CalculiX computes itself; steady sliding, eigenvalues about it, a
// transient and its damage run, and the transient grows at the rate of its
// linearisation. Arguments: squeal, squeal-tribology, the folder of parameter
// files.

#include "exported_scenes.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** The eigenvalues that the transient would compare itself with are those of
   * another of the runs. */
  void
  run(const std::string &program, const std::string &file)
  {
    const std::string        name = std::filesystem::path(file).stem().string();
    std::vector<std::string> words = {program};
    for (const std::string &setting :
         {std::string("Output/Plots = false"), "Output directory = " + name})
      words.insert(words.end(), {"--set", setting});
    if (name == "transient")
      words.insert(words.end(),
                   {"--set", "Transient/Compare with CEA = false"});
    words.push_back(file);
    const Outcome o = run_program(words);
    check(o.code == 0, file + ": " + o.errors);
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 4, "arguments: squeal, squeal-tribology, prm");
  const std::string program = argv[1],
                    folder  = std::string(argv[3]) + "/calculix/";
  for (const char *name : {"modes", "preload", "cea", "transient"})
    run(program, folder + name + ".prm");

  const Table own      = read_csv("modes/modes.csv"),
              calculix = read_csv(folder + "brake/frequencies.csv");
  check(calculix.n_rows() == 30 && own.n_rows() == 30, "thirty frequencies");
  Worst error;
  for (std::size_t i = 0; i < 30; ++i)
    error.add(std::abs(
      own.real(i, "frequency_hz") / calculix.real(i, "frequency_hz") - 1.));
  // CalculiX prints seven digits of the square.
  check(error.largest() <= 1e-6,
        "frequencies differ by " + std::to_string(error.largest() / 1e-9) +
          "e-9");

  // The pads carry the pressure of 1 MPa on 24 cm^2 each but for what the seals
  // of the pistons take, 25 springs of 10 N/mm.
  const Table preload = read_csv("preload/preload.csv");
  for (const char *pad : {"upper", "lower"})
    {
      const double force =
        preload.real(preload.n_rows() - 1, std::string(pad) + "_normal_n");
      check(force > 2390. && force < 2400.,
            "normal force " + std::to_string(force));
    }

  const Table  transient = read_csv("transient/transient.csv");
  const double rate      = transient.real(0, "growth_rate_per_s"),
               bounds    = transient.real(0, "growth_rate_ci_per_s"),
               linear    = transient.real(0, "sigma_linear_per_s");
  check(linear > 0. && std::abs(rate - linear) <= bounds,
        "growth rate " + std::to_string(rate) + " +- " +
          std::to_string(bounds) + ", linearised " + std::to_string(linear));
  write_text("damage.prm",
             "set Analysis = damage\nset Output directory = damage\n"
             "set Overwrite = true\n"
             "subsection History\n"
             "  set File = transient/contact_history.h5\nend\n"
             "subsection Subsurface\n  set Compute = false\nend\n"
             "subsection Output\n  set Plots = false\nend\n");
  const Outcome o = run_program({argv[2], "damage.prm"});
  check(o.code == 0, "damage: " + o.errors);
  for (const char *pad : {"upper", "lower"})
    {
      const Table map = read_csv("damage/damage_" + std::string(pad) + ".csv");
      check(map.n_rows() == 24, "a map of all points");
      Worst damage;
      for (std::size_t i = 0; i < map.n_rows(); ++i)
        damage.add(map.real(i, "damage_m5_per_s"));
      check(damage.smallest() > 0., "damage everywhere");
    }
}
