// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_analyses_updating_scenes_h
#define squeal_tests_analyses_updating_scenes_h

#include <squeal/results/table.h>

#include <cmath>

namespace squeal
{
  namespace testing
  {
    /** Of a number in updated_numbers.csv; NaN: not there. */
    inline double
    value(const Table       &table,
          const std::string &number,
          const std::string &column)
    {
      for (std::size_t r = 0; r < table.n_rows(); ++r)
        if (table.text(r, "number") == number)
          return table.real(r, column);
      return std::nan("");
    }

    /** A mass of 1 kg on a spring: (2 pi f)^2 m along each axis. */
    const std::string mass_on_spring = R"(set Output directory = out
subsection Scene
  set Bodies   = mass
  set Supports = turns
  set Springs  = spring
  subsection Body mass
    set Shape = rigid
    set Mass  = 1
  end
  subsection Support turns
    set Body       = mass
    set Kind       = components
    set Components = rx, ry, rz
  end
  subsection Spring spring
    set Body        = mass
    set Stiffnesses = 1e6, 2e6, 3e6
  end
end
subsection Eigenvalues
  set Lowest frequency  = 20
  set Highest frequency = 900
end
subsection Measurement
  set Frequencies file = measured.csv
end
subsection Updating
  set Numbers = plane, across
  subsection Number plane
    set Entries = Scene/Spring spring/Stiffnesses[1], Scene/Spring spring/Stiffnesses[2]
    set Lower   = 1e5
    set Upper   = 1e8
  end
  subsection Number across
    set Entries = Scene/Spring spring/Stiffnesses[3]
    set Lower   = 1e5
    set Upper   = 1e8
  end
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
