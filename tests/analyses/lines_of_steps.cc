// SPDX-License-Identifier: LGPL-2.1-or-later

// Lines of a force above those that the samples of a transient tell, found in
// its steps: of the pair and of the force that are judged, in the second half
// of the run.

#include "check.h"

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/analyses/transient/transient_verdict.h>

#include <cmath>
#include <functional>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double       step = 5e-7;                             // s
  constexpr double       high = 46.9e3, low = 3e3, lowest = 500.; // Hz
  constexpr unsigned int length = 12345;

  using Force = std::function<double(double)>;

  double
  line(const double time, const double frequency)
  {
    return std::sin(2. * M_PI * frequency * time);
  }

  /** A run of two pairs. */
  TransientRecord
  run_of(const Force &normal, const Force &tangential)
  {
    TransientRecord record;
    record.samples.resize(1);
    record.pairs.resize(2);
    record.n_steps = length;
    for (unsigned int k = 1; k <= length; ++k)
      {
        const double t = k * step;
        record.last_steps.push_back({t, 100. + line(t, low), 30.});
        record.last_steps.push_back({t, normal(t), tangential(t)});
      }
    return record;
  }

  void
  judged_force()
  {
    // A slow drift and a smaller slow line are no reason to trust samples.
    const TransientRecord record = run_of(
      [](const double t) {
        return 50. + 4e3 * t + line(t, high) + .7 * line(t, low);
      },
      [](const double t) { return line(t, low) + .7 * line(t, high); });
    const auto beyond = [&](const JudgedPair &pair, const double interval) {
      return line_beyond_samples(record, pair, lowest, interval);
    };
    const JudgedPair quiet{0, "quiet", JudgedForce::normal, "normal force"},
      loud{1, "loud", JudgedForce::normal, "normal force"},
      sticks{1, "loud", JudgedForce::tangential, "tangential force"};
    for (const double interval : {1e-5, 1.1e-5, 9.7e-6})
      check_close(
        beyond(loud, interval), high, 2e-3, "a line that samples fold down");
    check(beyond(loud, 9.5e-6) == 0. && beyond(loud, step) == 0.,
          "shorter samples tell it");
    check(beyond(quiet, 1e-5) == 0., "another pair has another line");
    check(beyond(sticks, 1e-5) == 0., "and another force");
    check(line_beyond_samples(TransientRecord(), loud, lowest, 1e-5) == 0.,
          "a run without steps has no line");
  }

  void
  second_half()
  {
    const double middle = .5 * length * step;
    for (const bool is_high_first : {true, false})
      {
        const TransientRecord record = run_of(
          [&](const double t) {
            return (t < middle) == is_high_first ? 10. * line(t, high)
                                                 : line(t, low);
          },
          [](const double) { return 0.; });
        check((line_beyond_samples(record,
                                   {1, "", JudgedForce::normal, "normal force"},
                                   lowest,
                                   1e-5) > 0.) == !is_high_first,
              "the first half of a run does not count");
      }
  }

  void
  words()
  {
    TransientFigures f;
    f.has_limit_cycle    = true;
    f.beyond_samples     = high;
    f.is_beyond_in_steps = true;
    check(
      limit_cycle_text(f) ==
        "a frequency that its samples do not tell, as the force vibrates at "
        "46900 Hz in the steps",
      "the limit cycle: " + limit_cycle_text(f));
    const std::string text = text_of_sampling(high, 1e-5, true);
    check(text.find("in the steps, at 46900 Hz") != std::string::npos &&
            text.find("no line above 45000 Hz") != std::string::npos &&
            text.find("neither sound nor spectrum") != std::string::npos,
          "the warning: " + text);
  }
} // namespace

int
main()
{
  judged_force();
  second_half();
  words();
}
