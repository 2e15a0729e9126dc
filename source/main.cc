// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/analyses.h>
#include <squeal/base/blas_kernels.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/memory.h>
#include <squeal/base/standard_streams.h>
#include <squeal/parameters/check_ranks.h>
#include <squeal/results/compare.h>
#include <squeal/run/command_line.h>
#include <squeal/scene/check_meshes.h>
#include <squeal/scene/mesh_materials.h>
#include <squeal/scene/modulus_table.h>
#include <squeal/scene/unit_notes.h>

#include <deal.II/base/mpi.h>

#include <iostream>

namespace
{
  using namespace squeal;

  const char *const usage =
    "usage: squeal [--quiet] [--set 'Section/Entry = value']... FILE.prm\n"
    "       squeal --validate FILE.prm...\n"
    "       squeal --compare RUN_A RUN_B [--all]\n"
    "       squeal --print-defaults | --print-documentation | --version | "
    "--help\n"
    "On N ranks: mpirun -np N squeal FILE.prm\n";

  const std::vector<std::string> actions = {"--validate",
                                            "--compare",
                                            "--print-defaults",
                                            "--print-documentation",
                                            "--version",
                                            "--help"};

  void
  run_file(const CommandLine &line, const bool is_root)
  {
    Parameters parameters = read_parameters(line.files[0], line.overrides);
    take_mesh_materials(parameters);
    parameters.check();
    take_modulus_tables(parameters);
    note_units(parameters);
    check_ranks(parameters,
                dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
    RunContext context(parameters, is_root, {line.overrides, line.is_quiet});
    run_analysis(context);
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
          print_version("squeal");
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
          compare_runs(line.files[0], line.files[1], std::cout, line.shows_all);
      }
    else if (line.action == "--validate")
      {
        if (line.files.empty())
          throw InputError("--validate needs a parameter file");
        for (const auto &file : line.files)
          {
            Parameters parameters = read_parameters(file, line.overrides);
            take_mesh_materials(parameters);
            parameters.check();
            take_modulus_tables(parameters);
            check_meshes(parameters.scene);
            note_units(parameters);
            if (is_root)
              {
                std::cout << file << ": valid\n";
                for (const std::string &note : parameters.notes)
                  std::cout << "  " << note << '\n';
              }
          }
      }
    else
      {
        if (line.files.size() != 1)
          throw InputError("give one parameter file; see squeal --help");
        run_file(line, is_root);
      }
    if (is_root)
      require_printed(line.action == "run" ? "; run.log has every line" : "");
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
  occupy_closed_streams();
  blas_kernels::start_again_with_widest(argv);
  keep_single_processes_apart();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const bool                               is_root =
    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  keep_freed_memory();
  return run_guarded(
    is_root,
    [&]() {
      // They never multiply with ranks or other work on the machine.
      blas_kernels::start_threads(threads_of_rank());
      act(read_command_line(argc, argv, actions), is_root);
    },
    []() {
      int n_ranks = 1;
      MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
      if (n_ranks > 1)
        MPI_Abort(MPI_COMM_WORLD, 1);
    });
}
