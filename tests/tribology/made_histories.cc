// SPDX-License-Identifier: LGPL-2.1-or-later

// Made histories: the generator has the published factors, and damage at the
// edge of a flat punch depends on the mesh unless its stress is averaged.
#include <squeal/base/exceptions.h>
#include <squeal/tribology/damage/history_damage.h>
#include <squeal/tribology/history/clipped_sine.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  void
  closed_forms()
  {
    struct Row
    {
      double r, duty, mean, ratio;
    };
    for (const Row &row : {Row{2., .6666667, 1.2179956, 2.4630632},
                           Row{5., .5640942, 2.1234878, 2.8255401}})
      {
        const ClippedSine c{row.r};
        const auto        is = [](const double a, const double b) {
          return std::abs(a - b) <= 5.1e-8;
        };
        check(is(c.duty(), row.duty) && is(c.mean(), row.mean) &&
                is(c.peak() / c.mean(), row.ratio),
              "clipped sine, r = " + std::to_string(row.r));
        double mean = 0., duty = 0.;
        for (unsigned int i = 0; i < 1000000; ++i)
          {
            const double p = 1. + row.r * std::sin(2. * M_PI * (i + .5) / 1e6);
            mean += std::max(0., p) / 1e6;
            duty += (p > 0.) / 1e6;
          }
        check_close(mean, c.mean(), 1e-9, "its mean, summed");
        check_close(duty, c.duty(), 1e-5, "its duty, summed");
      }
    Worst largest;
    for (double r = .1; r < 1e4; r *= 1.1)
      largest.add(ClippedSine{r}.peak() / ClippedSine{r}.mean());
    check(largest.largest() < M_PI && largest.largest() > 3.14,
          "peak over mean stays below pi");
  }

  void
  generator()
  {
    RecordedHistoryParameters p;
    p.noise    = 0.;
    p.duration = 20. / p.frequency;
    p.rate     = 200. * p.frequency;
    ClippedSineGenerator      g(p);
    HistoryWriter             writer("sine.h5", g.layout());
    HistorySamples            s;
    std::vector<StatusChange> changes;
    for (std::uint64_t done = 0; done < g.n_samples(); done += 1000)
      {
        g.next(std::min<std::uint64_t>(1000, g.n_samples() - done), s, changes);
        writer.append(s);
        writer.append(changes);
      }
    // one more sample closes the last period
    g.next(1, s, changes);
    writer.append(s);
    writer.finish();

    const HistoryReader reader("sine.h5");
    const ContactGrid   grid(reader.layout());
    FatigueParameters   f;
    f.spectral         = false;
    f.averaging_length = 0.;
    HistoryParameters h;
    h.chunk                    = 777;
    const HistoryDamage damage = count_history(reader, h, f, {}, grid);
    double              force = 0., area = 0., peak = 0.;
    std::size_t         highest = 0;
    for (std::size_t k = 0; k < grid.n_nodes(); ++k)
      {
        const SurfaceSums &sums = damage.nodes[k].surface;
        force += sums.mean_pressure() * grid.area(k);
        area += grid.area(k);
        if (sums.peak_pressure > peak)
          {
            peak    = sums.peak_pressure;
            highest = k;
          }
        // 200 samples a period
        const ClippedSine form{g.ratio(k)};
        if (!(std::abs(sums.duty() - form.duty()) <= 6e-3 &&
              std::abs(sums.mean_pressure() / g.mean_pressure(k) - 1.) <= 1e-3))
          check(false, "duty and mean of node " + std::to_string(k));
        if (!(std::abs(sums.impacts - (form.r > 1. ? 20. : 0.)) <= 1.))
          check(false, "an impact a period at node " + std::to_string(k));
      }
    check(grid.is_grid() && grid.n_nodes() == 121, "11 x 11 nodes");
    check_close(area, 1e-4, 1e-12, "areas add up to the face");
    check_close(force / area, 1e6, 1e-3, "mean pressure of the pad 1 MPa");
    check_close(peak, 15e6, 1e-3, "15 times the mean at the most loaded node");
    check(highest == 0, "at the leading inner corner");
    check(g.mean_pressure(0) > 4.77e6,
          "whose mean exceeds 4.77 times the pad's");
    const SurfaceSums &corner   = damage.nodes[0].surface;
    const SurfaceSums &trailing = damage.nodes[120].surface;
    check(corner.stick_slip >= 19. && trailing.stick_slip == 0.,
          "stick-slip at the leading edge only");
    // trailing corner: r = 0.3, always slipping; energy mu p v with both
    // swinging, v a quarter period ahead: the mean of the product is mu p0 v
    check_close(trailing.friction_energy,
                .5 * g.mean_pressure(120) * p.slip_speed * damage.duration,
                1e-3,
                "friction energy mu p0 mean v T");
    check_close(trailing.pressure_slip * .5,
                trailing.friction_energy,
                1e-6,
                "Archard's sum is the energy over mu");
    // one amplitude for ever: a cycle a period
    check(std::abs(damage.nodes[60].cycles - 20.) <= 1.5,
          "a cycle a period: " + std::to_string(damage.nodes[60].cycles));

    for (const unsigned int chunk : {1000u, 100000u})
      {
        h.chunk                    = chunk;
        f.averaging_length         = 2e-3;
        h.chunk                    = 777;
        const HistoryDamage first  = count_history(reader, h, f, {}, grid);
        h.chunk                    = chunk;
        const HistoryDamage second = count_history(reader, h, f, {}, grid);
        bool                same   = true;
        for (std::size_t k = 0; k < grid.n_nodes(); ++k)
          {
            const HistoryDamage::Node &a = first.nodes[k], &b = second.nodes[k];
            same = same && a.damage == b.damage && a.averaged == b.averaged &&
                   a.surface.friction_energy == b.surface.friction_energy &&
                   a.surface.impulse == b.surface.impulse;
          }
        check(same, "chunks of " + std::to_string(chunk) + ": the same bits");
      }
    h.start_time = 5. / p.frequency;
    h.end_time   = 10. / p.frequency;
    check_close(count_history(reader, h, f, {}, grid).duration,
                5. / p.frequency,
                1e-2,
                "a window of time");
    h.start_time = 1e3;
    h.end_time   = 2e3;
    check_throws<InputError>([&] { count_history(reader, h, f, {}, grid); },
                             "fewer than two samples",
                             "an empty window");
  }

  /** A contact that pulls is counted, and said. */
  void
  tension()
  {
    HistoryLayout layout;
    layout.points        = {{{0., 0., 0.}}, {{1e-3, 0., 0.}}};
    layout.areas         = {1e-6, 1e-6};
    layout.has_slip_rate = layout.has_gap = layout.has_status = false;
    layout.has_resultants                                     = false;
    FatigueParameters f;
    f.spectral = false;
    for (const double lowest : {-2e5, -1e-5, 0.})
      {
        HistorySamples s;
        for (unsigned int t = 0; t < 8; ++t)
          {
            s.time.push_back(t);
            s.pressure.insert(s.pressure.end(),
                              {1e6 * (t % 2), t == 5 ? lowest : 1e6});
          }
        s.traction.assign(2 * s.pressure.size(), 0.);
        HistoryWriter writer("tension.h5", layout);
        writer.append(s);
        writer.finish();
        const HistoryReader      reader("tension.h5");
        std::vector<std::string> notes =
          count_history(reader, {}, f, {}, ContactGrid(reader.layout())).notes;
        // Two samples a pulse: what they miss has a note of its own.
        const auto of_peaks = [](const std::string &note) {
          return note.find("the samples do not show the peaks") == 0;
        };
        notes.erase(std::remove_if(notes.begin(), notes.end(), of_peaks),
                    notes.end());
        check(lowest < -1.
                ? notes.size() == 1 &&
                    notes[0].find("negative in 1 values, down to ") !=
                      std::string::npos &&
                    notes[0].find("at node 1") != std::string::npos
                : notes.empty(),
              "pressure down to " + std::to_string(lowest) +
                " Pa: " + (notes.empty() ? "no word" : notes[0]));
      }
  }

  /** A flat punch: its pressure is singular at the edges. */
  void
  edges()
  {
    FatigueParameters f;
    f.spectral         = false;
    f.averaging_length = 2e-3;
    std::vector<double> local, averaged;
    for (const unsigned int n : {11u, 21u, 41u})
      {
        HistoryLayout  layout;
        const double   a = 5e-3, step = 2. * a / (n - 1);
        HistorySamples s;
        layout.has_slip_rate = layout.has_gap = layout.has_status = false;
        layout.has_resultants                                     = false;
        const auto load = [&](const double x) {
          return std::asin(std::min(1., std::max(-1., x / a))) / M_PI;
        };
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int i = 0; i < n; ++i)
            {
              layout.points.push_back({{i * step - a, j * step - a, 0.}});
              layout.areas.push_back(step * step *
                                     (i % (n - 1) == 0 ? .5 : 1.) *
                                     (j % (n - 1) == 0 ? .5 : 1.));
            }
        for (unsigned int t = 0; t < 9; ++t)
          {
            s.time.push_back(t);
            for (unsigned int j = 0; j < n; ++j)
              for (unsigned int i = 0; i < n; ++i)
                {
                  const double x  = i * step - a;
                  const double lo = std::max(-a, x - step / 2.);
                  const double hi = std::min(a, x + step / 2.);
                  // nodal force over tributary area
                  s.pressure.push_back(t % 2 == 0
                                         ? 0.
                                         : 1e6 * 2. * a *
                                             (load(hi) - load(lo)) / (hi - lo));
                }
          }
        s.traction.assign(2 * s.pressure.size(), 0.);
        HistoryWriter writer("punch.h5", layout);
        writer.append(s);
        writer.finish();
        const HistoryReader reader("punch.h5");
        const ContactGrid   grid(reader.layout());
        const HistoryDamage damage = count_history(reader, {}, f, {}, grid);
        FatigueParameters   narrow = f;
        narrow.averaging_length    = step;
        for (const auto &[fatigue, is_said] :
             {std::pair(f, false), std::pair(narrow, true)})
          {
            bool is_found = false;
            for (const std::string &note :
                 count_history(reader, {}, fatigue, {}, grid).notes)
              is_found = is_found ||
                         note.find("'Averaging length'") != std::string::npos;
            check(is_found == is_said,
                  "a length of the distance of nodes averages nothing");
          }
        const std::size_t edge = n * (n / 2);
        local.push_back(damage.nodes[edge].damage[1]);
        averaged.push_back(damage.nodes[edge].averaged[1]);
        std::cout << n << " nodes: damage at the edge " << local.back()
                  << ", of the averaged stress " << averaged.back() << "\n";
      }
    // p ~ d^-1/2: nodal pressure doubles in square for half the width
    check(local[1] / local[0] > 4. && local[2] / local[1] > 4.,
          "damage of a single edge node grows with refinement");
    check(std::abs(averaged[2] / averaged[1] - 1.) < .1,
          "that of the averaged stress does not: " +
            std::to_string(averaged[1] / averaged[0]) + ", " +
            std::to_string(averaged[2] / averaged[1]));
  }
} // namespace



int
main()
{
  closed_forms();
  generator();
  tension();
  edges();
}
