// SPDX-License-Identifier: LGPL-2.1-or-later

// The samples that the criteria below the face look at: whether they hold what
// the tractions do in the whole history.
#include <squeal/tribology/damage/subsurface.h>

#include <cmath>
#include <filesystem>
#include <functional>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr std::size_t n = 5000;

  /** The note on the last @p n_samples of a history of two nodes, whose
   * pressure at sample i is 1 MPa times one plus @p wave. */
  std::string
  note(const std::function<double(std::size_t)> &wave,
       const unsigned int                        n_samples)
  {
    HistoryLayout layout;
    layout.points = {{{0., 0., 0.}}, {{1e-3, 0., 0.}}};
    layout.areas  = {1e-6, 1e-6};
    HistorySamples s;
    for (std::size_t i = 0; i < n; ++i)
      {
        const double p = 1e6 * (1. + wave(i));
        s.time.push_back(1e-5 * i);
        s.pressure.insert(s.pressure.end(), {1e6, p});
        s.traction.insert(s.traction.end(), {0., 4e5, 0., .4 * p});
        s.slip_rate.insert(s.slip_rate.end(), {0., 1., 0., 1.});
        s.gap.insert(s.gap.end(), {0., 0.});
        s.status.insert(s.status.end(), {2., 2.});
        s.resultants.insert(s.resultants.end(), {0., 0., 0.});
      }
    std::filesystem::remove("history.h5");
    {
      HistoryWriter writer("history.h5", layout);
      writer.append(s);
      writer.finish();
    }
    const HistoryReader  reader("history.h5");
    SubsurfaceParameters p;
    p.n_samples = n_samples;
    return note_on_subsurface_window(reader, {0, n}, p, 700);
  }
} // namespace

int
main()
{
  // 400 samples a period; the history ends at a zero
  const auto slow = [](const std::size_t i) {
    return .9 * std::sin(2. * M_PI * i / 400.);
  };
  const std::string part = note(slow, 256);
  check(part.find("the last 256 of 5000 samples, in which the pressure of node "
                  "1 varies by ") != std::string::npos &&
          part.find(" of 1.80 MPa: raise 'Subsurface/Samples'") !=
            std::string::npos,
        "samples that hold no period: " + part);
  check(note(slow, 400).empty(), "a period is enough");
  check(note(slow, n).empty(), "and so are all samples");
  const auto quiet = [](const std::size_t i) {
    return i < 4500 ? .9 * std::sin(2. * M_PI * i / 20.) : 0.;
  };
  check(note(quiet, 256).find("varies by 0") != std::string::npos,
        "squeal that ends before the last samples");
  check(note(quiet, 1000).empty(), "samples that reach back to it");
}
