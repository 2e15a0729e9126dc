// SPDX-License-Identifier: LGPL-2.1-or-later

// A disc whose mesh turns under a pad is drawn turned: its points have moved by
// the angle of the frame, and the dent is under the pad. Argument: the program.

#include <squeal/results/table.h>

#include "../results/read_vtu.h"
#include "program.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double pi    = 3.14159265358979323846;
  constexpr double speed = 20., end_time = 4e-3, pad_radius = .1;

  const std::string disc_scene = R"(set Analysis         = transient
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = disc, pad
  set Supports = inner, sides
  set Springs  = bed
  set Loads    = press
  set Contacts = c
  subsection Body disc
    set Shape        = annulus
    set Inner radius = 0.05
    set Outer radius = 0.12
    set Height       = 0.01
    set Position     = 0, 0, -0.01
    set Cells        = 16, 3, 1
  end
  subsection Body pad
    set Size          = 0.03, 0.03, 0.015
    set Position      = 0.1, 0, 0.0
    set Cells         = 2, 2, 1
    set Young modulus = 5e9
    set Density       = 2500
  end
  subsection Support inner
    set Body = disc
    set Face = inner
  end
  subsection Support sides
    set Body       = pad
    set Face       = z_max
    set Kind       = components
    set Components = x, y
  end
  subsection Spring bed
    set Kind      = area
    set Body      = pad
    set Face      = z_max
    set Stiffness = 1e9
    set Dashpot   = 1e5
  end
  subsection Load press
    set Body  = pad
    set Face  = z_max
    set Force = 0, 0, -500
  end
  subsection Contact c
    set Source body          = pad
    set Source face          = z_min
    set Target body          = disc
    set Target face          = top
    set Formulation          = mortar
    set Contact state        = preload
    set Friction direction   = slip
    set Sliding speed        = 20
    set Friction coefficient = 0.3
  end
  subsection Damping
    set Model             = whole model
    set Stiffness damping = 1e-6
  end
end
subsection Discretization
  set Degree         = 1
  set Estimate error = false
end
subsection Eigenvalues
  set Highest frequency = 10000
end
subsection Transient
  set Integrator       = implicit
  set Disc frame       = corotating
  set Cut-off          = 20e3
  set Time step        = 8e-6
  set End time         = 4e-3
  set Sample interval  = 4e-5
  set Disturbance      = 0
  set Animation frames = 3
end
subsection Output
  set Plots = false
end
)";

  /** Points and displacements of one frame. */
  struct Frame
  {
    explicit Frame(const unsigned int k)
    {
      const std::string vtu =
        text_of("out/frames/motion_000" + std::to_string(k) + ".vtu");
      time      = vtu_number(vtu, "time_s");
      points    = vtu_array<float>(vtu, "Points");
      motion    = vtu_array<float>(vtu, "displacement");
      deviation = vtu_array<float>(vtu, "deviation");
    }

    bool
    is_of_disc(const std::size_t p) const
    {
      return points[3 * p + 2] < -1e-6;
    }

    double
    radius(const std::size_t p) const
    {
      return std::hypot(points[3 * p], points[3 * p + 1]);
    }

    double
    angle(const std::size_t p) const
    {
      return std::atan2(points[3 * p + 1], points[3 * p]);
    }

    double             time;
    std::vector<float> points, motion, deviation;
  };

  /** Of the point of the disc that the load moves most along z. */
  std::size_t
  dent(const Frame &frame)
  {
    std::size_t best  = 0;
    double      depth = -1.;
    for (std::size_t p = 0; 3 * p < frame.points.size(); ++p)
      if (const double size = std::abs(frame.motion[3 * p + 2]);
          frame.is_of_disc(p) && size > depth)
        {
          best  = p;
          depth = size;
        }
    return best;
  }

  /** By how much the disc's points have turned since @p before. */
  Worst
  turned_by(const Frame &before, const Frame &after)
  {
    Worst turned;
    for (std::size_t p = 0; 3 * p < after.points.size(); ++p)
      if (after.is_of_disc(p))
        {
          turned.add(std::remainder(after.angle(p) - before.angle(p), 2. * pi));
          check_close(after.radius(p), before.radius(p), 1e-5, "same radius");
        }
      else if (after.points[3 * p + 2] > 1e-3)
        check(after.points[3 * p] == before.points[3 * p],
              "the pad stands still");
    return turned;
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 2, "one argument: the program");
  write_text("disc.prm", disc_scene);
  const Outcome o = run_program({argv[1], "disc.prm"});
  check(o.code == 0, "runs: " + o.errors);
  const Frame first(0), last(2);
  const Worst turned = turned_by(first, last);
  // The mean radius of four by four quadrature points or three by three nodes
  // of the face differs from that of its middle by less than two per cent.
  const double expected = speed * (last.time - first.time) / pad_radius;
  check_close(turned.smallest(), expected, .03, "turned by V t / r");
  check_close(turned.largest(), turned.smallest(), 1e-3, "as a whole");
  for (const Frame *frame : {&first, &last})
    {
      const std::size_t p = dent(*frame);
      check(std::abs(frame->angle(p)) < pi / 8. && frame->radius(p) > .08,
            "the dent is under the pad: at " +
              std::to_string(frame->angle(p) * 180. / pi) +
              " deg, r = " + std::to_string(frame->radius(p)) + " m");
    }
  check(std::abs(last.time - end_time) < 1e-9, "the end of the run");
}
