// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/memory.h>
#include <squeal/base/version.h>
#include <squeal/driver/analyses.h>
#include <squeal/results/compare.h>

#include <deal.II/base/mpi.h>

#include <cblas.h>

#include <iostream>

namespace
{
  using namespace squeal;

  const char *const usage =
    "usage: squeal [--set 'Section/Entry = value']... FILE.prm\n"
    "       squeal --validate FILE.prm...\n"
    "       squeal --compare RUN_A RUN_B\n"
    "       squeal --print-defaults | --print-documentation | --version | "
    "--help\n"
    "On N ranks: mpirun -np N squeal FILE.prm\n";

  struct CommandLine
  {
    std::string              action = "run";
    std::vector<std::string> files, overrides;
  };

  CommandLine
  read_command_line(const int argc, char **argv)
  {
    CommandLine line;
    for (int i = 1; i < argc; ++i)
      {
        const std::string word = argv[i];
        if (word == "--set")
          {
            if (++i == argc)
              throw InputError("--set needs 'Section/Entry = value'");
            line.overrides.push_back(argv[i]);
          }
        else if (word == "-h")
          line.action = "--help";
        else if (word == "--validate" || word == "--compare" ||
                 word == "--print-defaults" ||
                 word == "--print-documentation" || word == "--version" ||
                 word == "--help")
          line.action = word;
        else if (word.size() > 1 && word[0] == '-')
          throw InputError("unknown option '" + word + "'; see squeal --help");
        else
          line.files.push_back(word);
      }
    return line;
  }

  void
  run_file(const std::string              &file,
           const std::vector<std::string> &overrides,
           const bool                      is_root)
  {
    const Parameters parameters = read_parameters(file, overrides);
    parameters.check();
    RunContext context(parameters, is_root);
    switch (parameters.analysis)
      {
      case Parameters::Analysis::modes:
        return run_modes(context);
      case Parameters::Analysis::cea:
        return run_cea(context);
      case Parameters::Analysis::sweep:
        return run_sweep(context);
      case Parameters::Analysis::work_precision:
        return run_work_precision(context);
      }
  }

  void
  act(const CommandLine &line, const bool is_root)
  {
    if (line.action == "--help")
      {
        if (is_root)
          std::cout << usage;
      }
    else if (line.action == "--version")
      {
        if (is_root)
          {
            std::cout << "squeal " << version::program << " ("
                      << version::revision << ")\n";
            for (const auto &[name, number] : version::libraries)
              std::cout << "  " << name << " " << number << "\n";
          }
      }
    else if (line.action == "--print-defaults")
      {
        if (is_root)
          print_defaults(std::cout);
      }
    else if (line.action == "--print-documentation")
      {
        if (is_root)
          print_parameter_documentation(std::cout);
      }
    else if (line.action == "--compare")
      {
        if (line.files.size() != 2)
          throw InputError("--compare needs two output directories");
        if (is_root)
          compare_runs(line.files[0], line.files[1], std::cout);
      }
    else if (line.action == "--validate")
      {
        if (line.files.empty())
          throw InputError("--validate needs a parameter file");
        for (const auto &file : line.files)
          {
            read_parameters(file, line.overrides).check();
            if (is_root)
              std::cout << file << ": valid\n";
          }
      }
    else
      {
        if (line.files.size() != 1)
          throw InputError("give one parameter file; see squeal --help");
        run_file(line.files[0], line.overrides, is_root);
      }
  }

  /** Prints on the root rank only: every rank fails alike on bad input. */
  int
  fail(const bool is_root, const std::string &text, const int code)
  {
    if (is_root)
      std::cerr << "squeal: " << text << std::endl;
    return code;
  }

  /**
   * Before MPI starts: a process that no launcher started leaves no files for
   * others to find. Open MPI's directory of them is common to all processes of
   * a user, and one that ends removes it while another one makes its own there:
   * of 180 runs, three at a time, one failed to start.
   */
  void
  keep_single_processes_apart()
  {
    for (const char *launched :
         {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "PMI_FD"})
      if (std::getenv(launched))
        return;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
  }
} // namespace



int
main(int argc, char **argv)
{
  keep_single_processes_apart();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                               is_root =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  // Threads of the BLAS never multiply with ranks or other work on the machine.
  const char *threads = std::getenv("SQUEAL_THREADS");
  openblas_set_num_threads(threads ? std::max(1, std::atoi(threads)) : 1);
  keep_freed_memory();
  try
    {
      act(read_command_line(argc, argv), is_root);
    }
  catch (const InputError &e)
    {
      return fail(is_root, e.what(), 2);
    }
  catch (const ComputationError &e)
    {
      return fail(is_root, e.what(), 3);
    }
  catch (const CheckError &e)
    {
      return fail(is_root, e.what(), 4);
    }
  catch (const std::exception &e)
    {
      std::cerr << "squeal: internal error: " << e.what() << std::endl;
      MPI_Abort(MPI_COMM_WORLD, 1);
      return 1;
    }
  return 0;
}
