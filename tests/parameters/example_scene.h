// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_parameters_example_scene_h
#define squeal_tests_parameters_example_scene_h

#include "prm_test.h"

namespace squeal
{
  namespace testing
  {
    /** A disc, a pad and its support with everything a scene can have but
     * lumped masses and matrix parts. */
    inline const char *
    example_scene()
    {
      return R"(# Disc, pad and support
subsection Scene
  set Name     = example
  set Bodies   = disc, pad, support
  set Ties     = pad_support
  set Springs  = row_entry, row_exit, \
                 guide
  set Supports = hub
  set Loads    = top
  set Contacts = pad_disc

  subsection Body disc
    set Shape        = annulus
    set Position     = 0, 0, -0.01
    set Inner radius = 0.05
    set Outer radius = 0.12
    set Height       = 0.01
    set Cells        = 24, 4, 1 # circumference, radius, height
  end
  subsection Body pad
    set Shape         = block
    set Position      = 0.1075, 0, 0
    set Size          = 0.01, 0.01, 0.01
    set Young modulus = 10^10.4
    set Density       = 2500
  end
  subsection Body support
    set Shape    = block
    set Position = 0.1075, 0, 0.01
    set Size     = 0.01, 0.01, 0.1
  end

  subsection Tie pad_support
    set Source body = pad
    set Source face = z_max
    set Target body = support
    set Target face = z_min
  end

  subsection Spring row_entry
    set Body        = support
    set First point = 0.1025, -0.005, 0.035
    set Last point  = 0.1125, -0.005, 0.035
    set Number      = 11
    set Direction   = 0, 1, 0
    set Stiffness   = 8.422e6
  end
  subsection Spring row_exit
    set Body        = support
    set First point = 0.1025, 0.005, 0.035
    set Last point  = 0.1125, 0.005, 0.035
    set Number      = 11
    set Direction   = 0, 1, 0
    set Stiffness   = 8.422e6
  end
  subsection Spring guide
    set Kind      = area
    set Body      = support
    set Face      = z_max
    set Direction = 3, 0, 4
    set Stiffness = 2e8
  end

  subsection Support hub
    set Body = disc
    set Face = inner
  end

  subsection Load top
    set Body  = support
    set Face  = z_max
    set Force = 0, 0, -100
  end

  subsection Contact pad_disc
    set Source body          = pad
    set Source face          = z_min
    set Target body          = disc
    set Target face          = top
    set Friction coefficient = 0.5
  end

  subsection Damping
    set Model             = whole model
    set Mass damping      = 0.02
    set Stiffness damping = 1e-7
  end
end

subsection Eigenvalues
  set Lowest frequency  = 900
  set Highest frequency = 20e3
end
)";
    }

    /** Writes the example to example.prm and returns that name. */
    inline std::string
    write_example()
    {
      write_text("example.prm", example_scene());
      return "example.prm";
    }
  } // namespace testing
} // namespace squeal

#endif
