// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_analyses_matrix_scene_h
#define squeal_tests_analyses_matrix_scene_h

// What parameter files of small scenes of matrices share.

#include <string>

namespace squeal
{
  namespace testing
  {
    /** Limit cycles, written to `out`, of the files M.mtx, K.mtx, nodes.csv and
     * contact.csv under the load `press`. @p contacts: their names; @p more: what
     * else stands in the section "Scene". */
    inline std::string
    matrix_scene(const std::string &contacts, const std::string &more)
    {
      return R"(set Analysis         = limit cycle
set Output directory = out
set Overwrite        = true
subsection Scene
  set Kind                 = matrices
  set Matrix parts         = mass, stiffness
  set Loads                = press
  set Contact pattern file = contact.csv
  set Node table file      = nodes.csv
  subsection Matrix part mass
    set File = M.mtx
    set Role = mass
  end
  subsection Matrix part stiffness
    set File = K.mtx
    set Role = stiffness
  end
  subsection Load press
    set Ramp time = 0
  end
  set Contacts = )" +
             contacts + "\n" + more + R"(end
subsection Output
  set Plots  = false
  set Report = false
end
)";
    }
  } // namespace testing
} // namespace squeal

#endif
