// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/choices.h>
#include <squeal/parameters/declarations.h>
#include <squeal/run/run_context.h>

#include <mpi.h>

namespace squeal
{
  namespace
  {
    RunDescription
    description_of(const Parameters &p, const RunOptions &options)
    {
      int n_ranks;
      MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
      return {choice_name(p.analysis),
              p.scene.name,
              p.file,
              p.used,
              p.notes,
              p.result_checks,
              p.output.directory,
              p.output.overwrite,
              static_cast<unsigned int>(n_ranks),
              options};
    }
  } // namespace



  RunContext::RunContext(const Parameters &p,
                         const bool        root,
                         const RunOptions &options)
    : RunSession(description_of(p, options), *prm::GenericSchema(), root)
    , parameters(p)
  {
  }
} // namespace squeal
