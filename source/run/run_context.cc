// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/parameters/declarations.h>
#include <squeal/run/run_context.h>

#include <mpi.h>

namespace squeal
{
  namespace
  {
    std::string
    analysis_name(const Parameters::Analysis analysis)
    {
      switch (analysis)
        {
        case Parameters::Analysis::modes:
          return "modes";
        case Parameters::Analysis::cea:
          return "cea";
        case Parameters::Analysis::sweep:
          return "sweep";
        case Parameters::Analysis::preload:
          return "preload";
        case Parameters::Analysis::transient:
          return "transient";
        case Parameters::Analysis::work_precision:
          return "work precision";
        case Parameters::Analysis::frequency_response:
          return "frequency response";
        case Parameters::Analysis::updating:
          return "updating";
        }
      unknown_choice("analysis");
    }

    RunDescription
    description_of(const Parameters &p)
    {
      int n_ranks;
      MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
      return {analysis_name(p.analysis),
              p.scene.name,
              p.file,
              p.used,
              p.notes,
              p.result_checks,
              p.output.directory,
              p.output.overwrite,
              static_cast<unsigned int>(n_ranks)};
    }
  } // namespace



  RunContext::RunContext(const Parameters &p, const bool root)
    : RunSession(description_of(p), *prm::GenericSchema(), root)
    , parameters(p)
  {
  }
} // namespace squeal
