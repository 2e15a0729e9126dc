// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_tribology_program_texts_h
#define squeal_tests_tribology_program_texts_h

#include <string>

namespace squeal
{
  namespace testing
  {
    /** A made history of a run, in a directory of its name. */
    inline std::string
    history_prm(const std::string &run)
    {
      return "set Analysis = recorded history\nset Output directory = " + run +
             "\nset Overwrite = true\nsubsection Recorded history\n  set Run "
             "= " +
             run + "\n  set Duration = 0.02\n  set Nodes per edge = 5\nend\n";
    }

    /** Damage of a squealing and a silent one. */
    inline const std::string damage_prm = R"(set Analysis = damage
set Output directory = damage
set Overwrite = true
subsection History
  set File = squealing/history.h5
  set Silent file = silent/history.h5
end
subsection Subsurface
  set Samples = 40
  set Plane step = 15
  set Criteria = dang van, crossland, findley, sines, swt, fatemi socie, rankine, drucker prager
end
subsection Output
  set Plots = false
end
)";

    /** Its correlation with features. */
    inline const std::string correlation_prm = R"(set Analysis = correlation
set Output directory = correlation
set Overwrite = true
subsection Correlation
  set Damage tables = damage/damage.csv, damage/damage.csv
  set Feature tables = features.csv, again.csv
  set Indices = damage_m3_per_s
  set Groups = squealing, silent
  set Surrogates = 99
  set Bootstraps = 99
  set Synthetic = true
end
subsection Output
  set Plots = false
end
)";
  } // namespace testing
} // namespace squeal

#endif
