// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/check_ranks.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/parameters.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** Whether a motion in time has all unknowns of the finite elements. */
    bool
    moves_all_unknowns(const Parameters &p)
    {
      using Integrator             = TransientParameters::Integrator;
      const TransientParameters &t = p.transient;
      if (p.analysis == Parameters::Analysis::work_precision)
        {
          if (p.work_precision.problem !=
              WorkPrecisionParameters::Problem::transient)
            return false;
        }
      else if (p.analysis != Parameters::Analysis::transient)
        return false;
      const std::string reduced = choice_name(Integrator::reduced);
      return t.integrators.empty() ? t.integrator != Integrator::reduced
                                   : std::any_of(t.integrators.begin(),
                                                 t.integrators.end(),
                                                 [&](const std::string &name) {
                                                   return name != reduced;
                                                 });
    }

    /** Whether matrices of a scene with open contacts are written. */
    bool
    writes_open_contacts(const Parameters &p)
    {
      return p.output.export_matrices &&
             (p.analysis == Parameters::Analysis::preload ||
              p.analysis == Parameters::Analysis::transient);
    }
  } // namespace

  void
  check_ranks(const Parameters &parameters, const unsigned int n_ranks)
  {
    if (n_ranks == 1)
      return;
    const std::string more = ", and there are " + std::to_string(n_ranks) +
                             ": start squeal without "
                             "mpirun";
    if (moves_all_unknowns(parameters))
      throw InputError("Transient/Integrator: implicit and explicit run on one "
                       "rank" +
                       more + ", or take the reduced one");
    if (writes_open_contacts(parameters))
      throw InputError("Output/Export matrices: a scene with open contacts is "
                       "written by one rank" +
                       more);
  }
} // namespace squeal
