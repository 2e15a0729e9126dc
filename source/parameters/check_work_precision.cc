// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/unknown_choice.h>

#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <cmath>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      using Ladder  = WorkPrecisionParameters::Ladder;
      using Problem = WorkPrecisionParameters::Problem;

      const char *const ladder_section = "Work precision";

      /** What a rung of @p ladder must be; empty if @p value is that. */
      std::string
      fault_of_rung(const Ladder ladder, const double value)
      {
        const bool is_whole = value == std::floor(value);
        switch (ladder)
          {
          case Ladder::degree:
            return is_whole && value >= 1. && value <= 8.
                     ? ""
                     : "a whole number from 1 to 8";
          case Ladder::refinement:
            return is_whole && value >= 0. && value <= 10.
                     ? ""
                     : "a whole number from 0 to 10";
          case Ladder::cells:
            return value > 0. && value <= 100.
                     ? ""
                     : "a number greater than 0 and at most 100";
          case Ladder::adaptive:
          case Ladder::basis:
            return value > 0. && value <= 1.
                     ? ""
                     : "a number greater than 0 and at most 1";
          case Ladder::cut_off:
          case Ladder::time_step:
            return value > 0. ? "" : "a number greater than 0";
          }
        unknown_choice("ladder");
      }

      /** The entry that has the rungs of @p ladder. */
      std::string
      entry_of(const WorkPrecisionParameters &w, const Ladder ladder)
      {
        switch (ladder)
          {
          case Ladder::cut_off:
            return "Cut-offs";
          case Ladder::time_step:
            return "Time steps";
          case Ladder::adaptive:
            return w.adaptive_values.empty() ? "Values" : "Adaptive values";
          case Ladder::degree:
          case Ladder::refinement:
          case Ladder::cells:
          case Ladder::basis:
            return "Values";
          }
        unknown_choice("ladder");
      }

      /** The ladders that a problem has. */
      std::string
      ladders_of(const Problem problem)
      {
        switch (problem)
          {
          case Problem::eigenvalues:
            return "degree, refinement, cells, adaptive, basis";
          case Problem::steady_sliding:
            return "degree, refinement, cells";
          case Problem::transient:
            return "degree, refinement, cells, cut-off, time step";
          }
        unknown_choice("problem");
      }

      bool
      has_ladder(const Problem problem, const Ladder ladder)
      {
        switch (ladder)
          {
          case Ladder::degree:
          case Ladder::refinement:
          case Ladder::cells:
            return true;
          case Ladder::adaptive:
          case Ladder::basis:
            return problem == Problem::eigenvalues;
          case Ladder::cut_off:
          case Ladder::time_step:
            return problem == Problem::transient;
          }
        unknown_choice("ladder");
      }

      /** Of a scene: matrices have no cells, bodies from files have theirs. */
      void
      check_mesh_of_ladder(const SceneParameters &scene, const Ladder ladder)
      {
        const bool is_of_mesh = ladder != Ladder::basis &&
                                ladder != Ladder::cut_off &&
                                ladder != Ladder::time_step;
        if (scene.kind == SceneParameters::Kind::matrices && is_of_mesh)
          refuse_entry(ladder_section,
                       "Ladders",
                       "contains '" + choice_name(ladder) +
                         "', but imported matrices have no mesh; use basis, "
                         "cut-off or time step");
        if (ladder == Ladder::cells)
          for (const BodyParameters &body : scene.bodies)
            if (body.has_mesh_file())
              refuse_entry(ladder_section,
                           "Ladders",
                           "contains 'cells', but body " +
                             in_quotes(body.name) +
                             " has the cells of a file; use refinement");
      }

      void
      check_ladder(const Parameters &parameters, const Ladder ladder)
      {
        const WorkPrecisionParameters &w = parameters.work_precision;
        if (!has_ladder(w.problem, ladder))
          refuse_entry(ladder_section,
                       "Ladders",
                       "contains '" + choice_name(ladder) +
                         "', which 'Problem = " + choice_name(w.problem) +
                         "' does not have; it has " + ladders_of(w.problem));
        check_mesh_of_ladder(parameters.scene, ladder);
        const std::string entry = entry_of(w, ladder);
        if (w.rungs(ladder).empty())
          refuse_entry(ladder_section,
                       entry,
                       "is empty: the ladder '" + choice_name(ladder) +
                         "' needs its rungs");
        if (w.problem != Problem::eigenvalues && w.rungs(ladder).size() < 2)
          refuse_entry(ladder_section,
                       entry,
                       "has one rung: the finest one is the reference of its "
                       "ladder, so that at least two are needed");
        for (const double value : w.rungs(ladder))
          {
            const std::string fault = fault_of_rung(ladder, value);
            if (!fault.empty())
              refuse_entry(ladder_section,
                           entry,
                           "contains " + format_number(value) +
                             ": a rung of the ladder '" + choice_name(ladder) +
                             "' is " + fault);
          }
      }

      /** Steady sliding and transients have figures and references of their
       * own, and are checked as the analyses that they are. */
      void
      check_problem(const Parameters &parameters)
      {
        const WorkPrecisionParameters &w = parameters.work_precision;
        if (!w.reference.empty())
          refuse_entry(ladder_section,
                       "Reference",
                       "is for 'Problem = eigenvalues': each ladder of '" +
                         choice_name(w.problem) +
                         "' is compared with its own finest rung");
        if (w.quantity != WorkPrecisionParameters().quantity)
          refuse_entry(ladder_section,
                       "Quantity",
                       "is for 'Problem = eigenvalues': ladders of '" +
                         choice_name(w.problem) + "' show all their figures");
        for (const Ladder ladder : w.ladders)
          if (ladder == Ladder::cut_off &&
              parameters.transient.integrator !=
                TransientParameters::Integrator::reduced)
            refuse_entry(ladder_section,
                         "Ladders",
                         "contains 'cut-off', but 'Transient/Integrator' has "
                         "all unknowns: take the reduced one");
        Parameters single = parameters;
        single.analysis   = w.problem == Problem::transient
                              ? Parameters::Analysis::transient
                              : Parameters::Analysis::preload;
        check_transient(single);
        if (!parameters.transient.tops.empty() ||
            !parameters.transient.integrators.empty() ||
            !parameters.sweep.axes.empty())
          refuse_entry("Transient",
                       "Tops",
                       "and 'Integrators' and 'Sweep/Axes' make several runs, "
                       "of which a ladder has one a rung: remove them");
      }
    } // namespace



    void
    check_work_precision(const Parameters &parameters)
    {
      const WorkPrecisionParameters &w = parameters.work_precision;
      if (parameters.analysis != Parameters::Analysis::work_precision)
        return;
      if (w.ladders.empty())
        refuse_entry(ladder_section,
                     "Ladders",
                     "is empty: list at least one of " + ladders_of(w.problem));
      for (const Ladder ladder : w.ladders)
        check_ladder(parameters, ladder);
      if (w.problem != Problem::eigenvalues)
        check_problem(parameters);
    }
  } // namespace prm
} // namespace squeal
