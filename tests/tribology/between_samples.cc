// SPDX-License-Identifier: LGPL-2.1-or-later

// What a history does between its samples: the damage of peaks that they miss,
// changes of status that it records, and the interval behind its last sample
// where it repeats.
#include <squeal/tribology/damage/history_damage.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr double interval = 1e-3; // s

  /** Two nodes with the pressure @p p(i) at sample i, under a disc that slides;
   * with a status, slip at all samples but @p stuck, if @p changes are given. */
  void
  write_history(const std::size_t                         n,
                const std::function<double(std::size_t)> &p,
                const std::vector<StatusChange>          &changes = {},
                const std::size_t                         stuck   = 1000000)
  {
    HistoryLayout layout;
    layout.points     = {{{0., 0., 0.}}, {{1e-3, 0., 0.}}};
    layout.areas      = {1e-6, 2e-6};
    layout.has_status = !changes.empty();
    layout.has_gap = layout.has_resultants = false;
    HistorySamples s;
    for (std::size_t i = 0; i < n; ++i)
      {
        s.time.push_back(interval * i);
        s.pressure.insert(s.pressure.end(), {p(i), p(i)});
        s.traction.insert(s.traction.end(), {0., .5 * p(i), 0., .5 * p(i)});
        s.slip_rate.insert(s.slip_rate.end(), {0., 1., 0., 1.});
        if (layout.has_status)
          s.status.insert(s.status.end(), {i == stuck ? 1. : 2., 2.});
      }
    std::filesystem::remove("history.h5");
    HistoryWriter writer("history.h5", layout);
    writer.append(s);
    writer.append(changes);
    writer.finish();
  }

  HistoryDamage
  count(const FatigueParameters &f, const unsigned int chunk = 4096)
  {
    const HistoryReader reader("history.h5");
    HistoryParameters   h;
    h.chunk = chunk;
    return count_history(reader, h, f, {}, ContactGrid(reader.layout()));
  }

  FatigueParameters
  plain()
  {
    FatigueParameters f;
    f.exponents        = {10., 3.};
    f.averaging_length = 0.;
    f.spectral         = false;
    return f;
  }

  bool
  says_it(const HistoryDamage &damage)
  {
    for (const std::string &note : damage.notes)
      if (note.find("% of the mean damage of slope m10 is lost") !=
          std::string::npos)
        return true;
    return false;
  }

  bool
  loses_nothing()
  {
    const LostDamage lost = count(plain()).lost;
    return lost.is_known && lost.share == 0.;
  }

  bool
  says_unknown(const HistoryDamage &damage)
  {
    for (const std::string &note : damage.notes)
      if (note.find("it is not known how much is lost") != std::string::npos)
        return PeakLoss::figure(damage.lost).rfind("not known", 0) == 0;
    return false;
  }

  /** A sine of amplitude 1 MPa: damage 1 a period, for all slopes. */
  void
  lost_peaks()
  {
    constexpr std::size_t n = 8000;
    for (const double period : {50.19, 9.13, 7.07, 5.018, 4.04, 3.31})
      for (const double mean : {1.1, 3.})
        {
          write_history(n, [&](const std::size_t i) {
            return 1e6 * (mean + std::sin(2. * M_PI * i / period + .3));
          });
          const HistoryDamage damage = count(plain());
          const double        lost =
            1. - damage.nodes[0].damage[0] / ((n - 1) / period);
          const std::string name = " of " + std::to_string(period) +
                                   " samples a period about " +
                                   std::to_string(mean) + " MPa";
          check_close(damage.lost.share, lost, .02, "lost peaks" + name, .2);
          check(says_it(damage) == (lost > .05), "are said" + name);
          check(damage.lost.is_known, "and known" + name);
        }
    const HistoryDamage whole = count(plain()), pieces = count(plain(), 7);
    check(whole.lost.share == pieces.lost.share, "pieces: the same bits");
    write_history(
      n, [&](const std::size_t i) { return 1e6 * (i % 7 < 3 ? 0. : 2.); });
    check(loses_nothing(), "steps lose nothing");
    write_history(n, [](std::size_t) { return 1e6; });
    check(loses_nothing(), "nor does a steady pressure");
  }

  /** Pulses of a contact that opens: what of a sine of 1 MPa is above @p cut.
   * The share of the damage that is lost, by the height of the pulses. */
  double
  write_pulses(const double period, const double cut)
  {
    constexpr std::size_t n = 4000;
    write_history(n, [&](const std::size_t i) {
      return 1e6 * std::max(0., std::sin(2. * M_PI * i / period + .3) - cut);
    });
    const double damage =
      std::pow(.5 * (1. - cut), 10.) * double(n - 1) / period;
    return 1. - count(plain()).nodes[0].damage[0] / damage;
  }

  /** What is lost of short pulses is right or not known. */
  void
  lost_pulses()
  {
    for (const double cut : {-.3, 0., .3, .6, .8})
      for (const double period :
           {3.07, 4.13, 5.31, 6.47, 7.77, 10.3, 15.3, 20.3})
        {
          const double        lost    = write_pulses(period, cut);
          const HistoryDamage damage  = count(plain());
          const double        samples = std::acos(cut) / M_PI * period;
          const std::string   name    = " of " + std::to_string(samples) +
                                   " samples above " + std::to_string(cut);
          check(damage.lost.is_known != says_unknown(damage),
                "what is not known is said: pulses" + name);
          if (samples < 2.1)
            check(!damage.lost.is_known,
                  "nobody knows the top of pulses" + name);
          if (samples >= 3.2)
            check(damage.lost.is_known, "known is that of pulses" + name);
          if (damage.lost.is_known)
            check_close(
              damage.lost.share, lost, .1, "lost of pulses" + name, 1.);
        }
    const std::size_t n = 700;
    write_history(n, [](const std::size_t i) {
      return 1e6 * (1. + .1 * std::sin(.3 * double(i)) + (i % 70 == 0));
    });
    check(says_unknown(count(plain())), "nor of spikes of a single sample");
    write_history(n, [](const std::size_t i) { return 1e6 * (i % 5 < 2); });
    check(says_unknown(count(plain())), "nor of two equal samples");
  }

  bool
  says(const HistoryDamage &damage, const std::string &part)
  {
    for (const std::string &note : damage.notes)
      if (note.find(part) != std::string::npos)
        return true;
    return false;
  }

  /** Half waves of 120 samples, 1 MPa high, 100 open samples apart: what a
   * contact law leaves of an open contact is no cycle, and larger noise of it
   * does not make the waves shorter. */
  void
  rests_of_open_contacts()
  {
    constexpr std::size_t n      = 4400;
    const auto            damage = [](const double rest) {
      write_history(n, [&](const std::size_t i) {
        const std::size_t k = i % 220;
        return k < 120 ? 1e6 * std::sin(M_PI * (k + .5) / 120.)
                          : k % 3 ? 0.
                                  : (k % 2 ? -rest : rest);
      });
      return count(plain());
    };
    const HistoryDamage clean = damage(0.), small = damage(.005),
                        large = damage(500.);
    check_close(clean.nodes[0].cycles, 20., 1e-12, "a cycle a wave", .51);
    check(small.nodes[0].cycles == clean.nodes[0].cycles &&
            small.nodes[0].damage == clean.nodes[0].damage,
          "rests of 5e-9 of the waves change nothing");
    check(!says(small, "cannot pull"), "and are no tension");
    check(says(large, "cannot pull"), "those of 5e-4 are");
    for (const HistoryDamage &d : {clean, small, large})
      {
        check(d.lost.is_known, "waves of 120 samples show their tops");
        check_close(d.lost.share, 0., 1., "and next to nothing is lost", 5e-3);
      }
  }

  /** A recording that begins after the motion. */
  void
  changes_before_the_first_sample()
  {
    const auto notes_of = [](const std::vector<double> &times) {
      std::vector<StatusChange> changes;
      for (const double time : times)
        changes.push_back({interval * time, 0, ContactStatus::slip});
      write_history(
        11, [](std::size_t) { return 1e6; }, changes);
      return says(count(plain()), "are not between the first sample");
    };
    check(!notes_of({-50., -5., 4.5}), "changes before it are passed over");
    check(notes_of({-50., -5.}), "not where none is among the samples");
    check(notes_of({-5., 4.5, 50.}), "nor where some are behind the last one");
  }

  /** Node 0 opens for a fifth of each interval; node 1 stays. */
  void
  recorded_changes()
  {
    constexpr std::size_t     n = 11, stuck = 4;
    std::vector<StatusChange> changes;
    const auto                add =
      [&changes](const double time, const std::size_t node, const int status) {
        changes.push_back(
          {interval * time, node, static_cast<ContactStatus>(status)});
      };
    add(-.5, 1, 0); // before the first sample and behind the last one
    add(12., 1, 0);
    for (std::size_t i = 0; i + 1 < n; ++i)
      {
        add(i + .3, 0, 0);
        add(i + .5, 0, 2);
      }
    // one that sticks and slips within an interval; one at a sample
    add(6.2, 1, 1);
    add(6.7, 1, 2);
    add(8., 1, 1);
    add(8.1, 1, 2);
    write_history(
      n, [](std::size_t) { return 1e6; }, changes, stuck);
    for (const unsigned int chunk : {4096u, 3u})
      {
        const HistoryDamage damage = count(plain(), chunk);
        const SurfaceSums  &open   = damage.nodes[0].surface,
                          &shut    = damage.nodes[1].surface;
        check(open.impacts == n - 1. && open.closures == 0.,
              "closures between samples are impacts");
        check_close(open.duty(), .8, 1e-12, "they are open in between");
        check(open.stick_slip == 1.,
              "a change that no record tells is that of the sample");
        check(shut.impacts == 0. && shut.stick_slip == 4.,
              "stick-slip between samples and at one");
        check_close(shut.duty(), 1., 1e-12, "a node that stays shut");
      }
  }

  /** A period with its end and without: the same motion. */
  void
  period()
  {
    FatigueParameters f = plain();
    f.residue           = FatigueParameters::Residue::repeating;
    for (const double mean : {2., 2000.})
      for (const std::size_t n : {16, 17, 32, 33})
        {
          write_history(n, [mean](const std::size_t i) {
            return 1e6 * (mean + std::sin(2. * M_PI * i / 16.));
          });
          const HistoryDamage damage = count(f);
          const std::string   name   = std::to_string(n) + " samples";
          check_close(damage.nodes[0].cycles / damage.period,
                      1. / (16. * interval),
                      1e-12,
                      "cycles per second of " + name);
          check_close(damage.duration,
                      interval * (n - 1),
                      1e-12,
                      "they last to the last sample: " + name);
        }
    for (const double rounding : {-2e-9, -1e-10, 2e-9, 1e-3})
      for (const double phase : {0., 1., 3., 5.})
        for (const unsigned int chunk : {7, 4096})
          {
            write_history(33, [&](const std::size_t i) {
              return 1e6 + 5e5 * std::sin(2. * M_PI * (i % 16) / 16. + phase) +
                     (i == 32 ? rounding : 0.);
            });
            const HistoryDamage ended = count(f, chunk);
            check_close(ended.nodes[0].cycles / ended.period,
                        1. / (16. * interval),
                        1e-12,
                        "an end beside the beginning by rounding is no cycle");
          }
    write_history(20, [](std::size_t) { return 1e6; });
    const HistoryDamage steady = count(f);
    check(steady.period == steady.duration, "a steady load ends as it begins");
    write_history(16, [](const std::size_t i) {
      return 1e6 * (2. + std::sin(2. * M_PI * i / 16.));
    });
    const HistoryDamage once = count(plain());
    check(once.period == once.duration, "half cycles: no interval is added");
  }
} // namespace



int
main()
{
  lost_peaks();
  lost_pulses();
  rests_of_open_contacts();
  changes_before_the_first_sample();
  recorded_changes();
  period();
}
