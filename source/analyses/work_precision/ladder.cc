// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/work_precision/ladder.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/numbers.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Ladder  = WorkPrecisionParameters::Ladder;
    using Problem = WorkPrecisionParameters::Problem;

    /** Thin bodies keep one cell through their thickness. */
    void
    scale_cells(std::vector<BodyParameters> &bodies, const double factor)
    {
      for (BodyParameters &body : bodies)
        for (unsigned int &n : body.cells)
          if (n > 1)
            n = static_cast<unsigned int>(std::max(1., std::round(factor * n)));
    }

    void
    refine(Parameters &p, const double value)
    {
      p.discretization.refinements = static_cast<unsigned int>(value);
      p.discretization.refinement =
        DiscretizationParameters::Refinement::uniform;
      if (p.work_precision.refinement_degree > 0)
        p.discretization.degree = p.work_precision.refinement_degree;
    }

    void
    set_time_step(TransientParameters &t, const double step)
    {
      t.time_step = step;
      if (t.explicit_step > 0.)
        t.explicit_step = step;
    }

    /** Sets what @p ladder varies. */
    void
    set_rung(Parameters &p, const Ladder ladder, const double value)
    {
      switch (ladder)
        {
        case Ladder::degree:
          p.discretization.degree = static_cast<unsigned int>(value);
          break;
        case Ladder::refinement:
          refine(p, value);
          break;
        case Ladder::cells:
          scale_cells(p.scene.bodies, value);
          break;
        case Ladder::adaptive:
          p.discretization.refinement =
            DiscretizationParameters::Refinement::eigenvalue_error;
          p.discretization.tolerance = value;
          break;
        case Ladder::basis:
          p.eigen.residual_tolerance = p.eigen.error_tolerance = value;
          break;
        case Ladder::cut_off:
          p.transient.cut_off = value;
          break;
        case Ladder::time_step:
          set_time_step(p.transient, value);
          break;
        }
    }
  } // namespace



  Parameters
  parameters_of_rung(const Parameters &all,
                     const Ladder      ladder,
                     const double      value)
  {
    Parameters p                    = all;
    p.discretization.estimate_error = false;
    set_rung(p, ladder, value);
    // Checked as the analysis that is run; a ladder has no rungs of its own.
    if (all.work_precision.problem == Problem::steady_sliding)
      p.analysis = Parameters::Analysis::preload;
    else if (all.work_precision.problem == Problem::transient)
      p.analysis = Parameters::Analysis::transient;
    p.check();
    return p;
  }

  std::string
  setting_text(const Ladder ladder, const double value)
  {
    return choice_name(ladder) + " = " + prm::format_number(value);
  }
} // namespace squeal
