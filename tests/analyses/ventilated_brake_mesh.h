// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_analyses_ventilated_brake_mesh_h
#define squeal_tests_analyses_ventilated_brake_mesh_h

#include "program.h"

namespace squeal
{
  namespace testing
  {
    /** Writes brake.msh by the generator in @p folder, with as few cells as the
     * ventilated brake can do with. */
    inline void
    make_coarse_brake(const std::string &python, const std::string &folder)
    {
      const std::vector<std::string> words = {python,
                                              folder + "/make_mesh.py",
                                              "--output",
                                              "brake.msh",
                                              "--rings",
                                              "1,1",
                                              "--hat",
                                              "1,1",
                                              "--flange",
                                              "1,1,1",
                                              "--hole",
                                              "5,3,1",
                                              "--pads",
                                              "6,1,1"};
      check(run_program(words).code == 0, "made a coarse mesh");
    }
  } // namespace testing
} // namespace squeal

#endif
