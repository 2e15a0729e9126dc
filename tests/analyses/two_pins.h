// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_analyses_two_pins_h
#define squeal_tests_analyses_two_pins_h

#include <string>

namespace squeal
{
  namespace testing
  {
    /** Two pins on two sides of a beam, each with its own friction. */
    inline const std::string two_pins = R"(subsection Scene
  set Name     = two pins
  set Bodies   = beam, upper, lower
  set Supports = left, right, up_back, up_sides, low_back, low_sides
  set Loads    = press_up, press_low
  set Contacts = above, below
  subsection Body beam
    set Shape         = block
    set Size          = 0.020, 0.160, 0.010
    set Position      = 0, 0.016, -0.010
    set Cells         = 2, 16, 1
    set Young modulus = 210e9
    set Density       = 7800
  end
  subsection Body upper
    set Shape         = block
    set Size          = 0.010, 0.010, 0.020
    set Position      = 0, 0, 0
    set Cells         = 2, 2, 4
    set Young modulus = 2e9
    set Density       = 1200
  end
  subsection Body lower
    set Shape         = block
    set Size          = 0.010, 0.010, 0.020
    set Position      = 0, 0, -0.030
    set Cells         = 2, 2, 4
    set Young modulus = 2e9
    set Density       = 1200
  end
  subsection Support left
    set Body = beam
    set Face = y_min
  end
  subsection Support right
    set Body = beam
    set Face = y_max
  end
  subsection Support up_back
    set Body = upper
    set Face = z_max
    set Kind = guided
  end
  subsection Support up_sides
    set Body       = upper
    set Face       = z_max
    set Kind       = components
    set Components = x, y
  end
  subsection Support low_back
    set Body = lower
    set Face = z_min
    set Kind = guided
  end
  subsection Support low_sides
    set Body       = lower
    set Face       = z_min
    set Kind       = components
    set Components = x, y
  end
  subsection Load press_up
    set Body  = upper
    set Face  = z_max
    set Force = 0, 0, -50
  end
  subsection Load press_low
    set Body  = lower
    set Face  = z_min
    set Force = 0, 0, 50
  end
  subsection Contact above
    set Source body          = upper
    set Source face          = z_min
    set Target body          = beam
    set Target face          = z_max
    set Formulation          = mortar
    set Contact state        = preload
    set Friction coefficient = 0.3
    set Transverse slip term = true
    set Sliding speed        = 0.05
    set Normal force         = 50
  end
  subsection Contact below
    set Source body          = lower
    set Source face          = z_max
    set Target body          = beam
    set Target face          = z_min
    set Formulation          = mortar
    set Contact state        = preload
    set Friction coefficient = 0.2
    set Transverse slip term = true
    set Sliding speed        = 0.05
    set Normal force         = 50
  end
  subsection Damping
    set Model             = whole model
    set Stiffness damping = 1e-7
  end
end
subsection Discretization
  set Degree         = 2
  set Estimate error = false
end
subsection Eigenvalues
  set Lowest frequency  = 500
  set Highest frequency = 15000
end
subsection Transient
  set Disturbance     = 1e-6
  set Cut-off         = 60e3
  set Time step       = 1e-6
  set Sample interval = 1e-5
  set End time        = 0.004
  set History start   = 0.001
end
subsection Output
  set Plots = false
  set Shapes = none
end
)";
  } // namespace testing
} // namespace squeal

#endif
