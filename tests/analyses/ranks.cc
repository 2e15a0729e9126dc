// SPDX-License-Identifier: LGPL-2.1-or-later

// The program on one and on two ranks writes the same eigenvalues, and refuses
// on two what one rank does alone, before any work. Arguments: mpirun, the
// program.

#include "program.h"

using namespace squeal::testing;

namespace
{
  /** Columns of a CSV file that are asked for, row by row. */
  std::vector<std::vector<double>>
  columns(const std::string &file, const std::vector<std::string> &names)
  {
    std::istringstream               text(text_of(file));
    std::vector<unsigned int>        wanted;
    std::vector<std::vector<double>> rows;
    for (std::string line; std::getline(text, line);)
      {
        if (line.empty() || line[0] == '#')
          continue;
        std::vector<std::string> cells;
        std::istringstream       row(line);
        for (std::string cell; std::getline(row, cell, ',');)
          cells.push_back(cell);
        if (wanted.empty())
          {
            for (const std::string &name : names)
              for (unsigned int i = 0; i < cells.size(); ++i)
                if (cells[i].substr(0, name.size()) == name)
                  wanted.push_back(i);
            check(wanted.size() == names.size(), "columns of " + file);
            continue;
          }
        rows.emplace_back();
        for (const unsigned int i : wanted)
          rows.back().push_back(std::stod(cells[i]));
      }
    return rows;
  }

  /** What only one rank does ends with the name of its entry, and without a
   * folder of results. */
  void
  refused_before_any_work(const std::string              &mpirun,
                          const std::string              &program,
                          const std::string              &entry,
                          const std::vector<std::string> &settings)
  {
    const std::string        folder  = "refused";
    std::vector<std::string> command = {
      mpirun, "-np", "2", program, "--set", "Output directory = " + folder};
    for (const std::string setting :
         {"Scene/Loads = press",
          "Scene/Load press/Body = pad",
          "Scene/Load press/Face = z_max",
          "Scene/Load press/Force = 0, 0, -100",
          "Scene/Contact pad_disc/Sliding speed = 1",
          "Scene/Contact pad_disc/Formulation = mortar",
          "Discretization/Mass = lumped",
          "Discretization/Estimate error = false"})
      command.insert(command.end(), {"--set", setting});
    for (const std::string &setting : settings)
      command.insert(command.end(), {"--set", setting});
    command.push_back("brake.prm");
    const Outcome o = run_program(command);
    check(o.code != 0 && o.errors.find(entry) != std::string::npos &&
            o.errors.find("without mpirun") != std::string::npos,
          "refused on two ranks: " + o.errors);
    check(!std::filesystem::exists(folder), "before any work: " + entry);
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 3, "arguments: mpirun, program");
  std::vector<std::vector<std::vector<double>>> results;
  write_text("brake.prm", small_brake);
  for (const std::string ranks : {"1", "2"})
    {
      const Outcome o = run_program({argv[1],
                                     "-np",
                                     ranks,
                                     argv[2],
                                     "--set",
                                     "Overwrite = true",
                                     "--set",
                                     "Discretization/Degree = 2",
                                     "--set",
                                     "Output directory = ranks_" + ranks,
                                     "brake.prm"});
      check(o.code == 0, "runs on " + ranks + " ranks: " + o.errors);
      results.push_back(columns("ranks_" + ranks + "/eigenvalues.csv",
                                {"frequency_hz", "sigma_per_s"}));
    }
  for (const std::string integrator : {"implicit", "explicit"})
    refused_before_any_work(
      argv[1],
      argv[2],
      "Transient/Integrator",
      {"Analysis = transient", "Transient/Integrator = " + integrator});
  refused_before_any_work(
    argv[1],
    argv[2],
    "Output/Export matrices",
    {"Analysis = preload", "Output/Export matrices = true"});
  const auto &one = results[0], &two = results[1];
  check(one.size() == two.size() && one.size() >= 4,
        "pairs: " + std::to_string(one.size()));
  for (unsigned int i = 0; i < one.size(); ++i)
    {
      const double size = std::hypot(2. * M_PI * one[i][0], one[i][1]);
      const double difference =
        std::hypot(2. * M_PI * (one[i][0] - two[i][0]), one[i][1] - two[i][1]);
      std::ostringstream text;
      text << "pair at " << one[i][0] << " Hz differs by " << difference / size;
      check(difference < 1e-8 * size, text.str());
    }

  // What is wrong is said once, by the first rank.
  const Outcome bad = run_program({argv[1],
                                   "-np",
                                   "2",
                                   argv[2],
                                   "--set",
                                   "Discretization/Degree = 99",
                                   "brake.prm"});
  check(bad.code != 0, "bad input on two ranks is refused");
  const auto first = bad.errors.find("squeal: ");
  check(first != std::string::npos &&
          bad.errors.find("squeal: ", first + 1) == std::string::npos,
        "and said once");
}
