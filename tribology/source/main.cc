// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/blas_kernels.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/memory.h>
#include <squeal/base/standard_streams.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/run/command_line.h>
#include <squeal/tribology/driver/analyses.h>

#include <deal.II/base/mpi.h>

#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>

#include <cstdlib>
#include <iostream>
#include <memory>

namespace
{
  using namespace squeal;
  using namespace squeal::tribology;

  const char *const usage =
    "usage: squeal-tribology [--quiet] [--set 'Section/Entry = value']... "
    "FILE.prm\n"
    "       squeal-tribology --validate FILE.prm...\n"
    "       squeal-tribology --print-defaults | --print-documentation | "
    "--version | --help\n";

  const std::vector<std::string> actions = {"--validate",
                                            "--print-defaults",
                                            "--print-documentation",
                                            "--version",
                                            "--help"};

  /** Of the damage analyses, only those in a block factorise in parallel. */
  bool
  needs_mpi(const TribologyParameters &p)
  {
    return p.analysis == TribologyParameters::Analysis::damage &&
           p.subsurface.compute && p.subsurface.pad_thickness > 0.;
  }



  void
  run_file(const CommandLine &line, int argc, char **argv)
  {
    if (line.files.size() != 1)
      throw InputError("give one parameter file; see squeal-tribology --help");
    const TribologyParameters parameters =
      read_tribology_parameters(line.files[0], line.overrides);
    parameters.check();
    std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
    if (needs_mpi(parameters))
      mpi = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(
        argc, argv, 1);
    Context context(parameters, {line.overrides, line.is_quiet});
    switch (parameters.analysis)
      {
      case TribologyParameters::Analysis::damage:
        return run_damage(context);
      case TribologyParameters::Analysis::segmentation:
        return run_segmentation(context);
      case TribologyParameters::Analysis::correlation:
        return run_correlation(context);
      case TribologyParameters::Analysis::synthetic_specimen:
        return run_synthetic_specimen(context);
      case TribologyParameters::Analysis::recorded_history:
        return run_recorded_history(context);
      }
    unknown_choice("analysis");
  }

  void
  act(const CommandLine &line, int argc, char **argv)
  {
    if (line.action == "--help")
      std::cout << usage;
    else if (line.action == "--version")
      {
        print_version("squeal-tribology");
        std::cout << "  OpenCV " << CV_VERSION << "\n";
      }
    else if (line.action == "--print-defaults")
      print_tribology_defaults(std::cout);
    else if (line.action == "--print-documentation")
      print_tribology_documentation(std::cout);
    else if (line.action == "--validate")
      {
        if (line.files.empty())
          throw InputError("--validate needs a parameter file");
        for (const auto &file : line.files)
          {
            read_tribology_parameters(file, line.overrides).check();
            std::cout << file << ": valid\n";
          }
      }
    else
      run_file(line, argc, argv);
    require_printed(line.action == "run" ? "; run.log has every line" : "");
  }
} // namespace



int
main(int argc, char **argv)
{
  occupy_closed_streams();
  blas_kernels::start_again_with_widest(argv);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  keep_freed_memory();
  return run_guarded(true, [&]() {
    // They never multiply with other work on the machine.
    const int n_threads = threads_of_rank();
    blas_kernels::start_threads(n_threads);
    cv::setNumThreads(n_threads);
    act(read_command_line(argc, argv, actions), argc, argv);
  });
}
