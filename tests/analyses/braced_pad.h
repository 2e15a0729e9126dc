// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_analyses_braced_pad_h
#define squeal_tests_analyses_braced_pad_h

#include <string>

namespace squeal
{
  namespace testing
  {
    /** A pad on a slab that slides, and beside it a stop, whose pair is at
     * rest. */
    inline const std::string braced_pad = R"(
set Analysis         = cea
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = slab, pad, stop
  set Springs  = under, back, hold
  set Contacts = c, a
  subsection Body slab
    set Size          = 0.03, 0.03, 0.02
    set Position      = 0, 0, -0.02
    set Cells         = 1, 1, 1
    set Young modulus = 70e9
  end
  subsection Body pad
    set Size          = 0.02, 0.02, 0.015
    set Cells         = 1, 1, 3
    set Young modulus = 2e9
    set Density       = 2000
  end
  subsection Body stop
    set Size          = 0.016, 0.01, 0.005
    set Position      = 0.001, 0.015, 0.005
    set Cells         = 1, 1, 1
    set Young modulus = 5e9
  end
  subsection Spring under
    set Kind        = area
    set Body        = slab
    set Face        = z_min
    set Stiffnesses = 3e10, 2e10, 4e10
  end
  subsection Spring back
    set Kind        = area
    set Body        = pad
    set Face        = z_max
    set Direction   = 0, -1, 0.7
    set Stiffness   = 5e9
    set Stiffnesses = 1e10, 3e8, 0
  end
  subsection Spring hold
    set Kind        = area
    set Body        = stop
    set Face        = y_max
    set Stiffnesses = 3e10, 6e10, 2e10
  end
  subsection Contact c
    set Formulation          = mortar
    set Source body          = pad
    set Source face          = z_min
    set Target body          = slab
    set Target face          = z_max
    set Sliding speed        = 0.5
    set Friction coefficient = 0.5
  end
  subsection Contact a
    set Formulation          = mortar
    set Source body          = stop
    set Source face          = y_min
    set Target body          = pad
    set Target face          = y_max
    set Sliding speed        = 0
    set Friction direction   = given
    set Sliding direction    = 1, 0, 0
    set Friction coefficient = 0.6
  end
end
subsection Measurement
  set Points = p
  subsection Point p
    set Body      = pad
    set Position  = 0.01, 0.01, 0.015
    set Direction = 0, 0, 1
  end
end
subsection Frequency response
  set Number = 5
end
subsection Discretization
  set Degree         = 1
  set Estimate error = false
end
subsection Eigenvalues
  set Highest frequency = 9000
end
subsection Output
  set Plots  = false
  set Report = false
  set Shapes = none
end
)";
  } // namespace testing
} // namespace squeal

#endif
