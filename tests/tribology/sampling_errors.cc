// SPDX-License-Identifier: LGPL-2.1-or-later

// How well a history knows the damage of the vibration that it is a sample of:
// stated standard errors are the scatter of many such histories, small for an
// even vibration, nothing for a whole period, not known for a few samples, and
// large where the vibration grows or comes in bursts.
#include <squeal/tribology/damage/history_damage.h>
#include <squeal/tribology/damage/sampling_error.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <random>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  FatigueParameters
  plain()
  {
    FatigueParameters f;
    f.exponents        = {3., 5.};
    f.averaging_length = 0.;
    f.spectral         = false;
    return f;
  }

  /** A vibration of 9 samples a period whose amplitude wanders, forgetting
   * itself within @p memory samples. */
  std::vector<double>
  wandering(const std::size_t n,
            const double      memory,
            std::mt19937_64  &generator)
  {
    std::normal_distribution<double> normal;
    const double                     kept  = std::exp(-1. / memory);
    const double                     added = std::sqrt(1. - kept * kept);
    double              cosine = normal(generator), sine = normal(generator);
    std::vector<double> stress;
    for (std::size_t i = 0; i < n; ++i)
      {
        const double phase = 2. * M_PI * i / 9.;
        stress.push_back(1e6 *
                         (cosine * std::cos(phase) + sine * std::sin(phase)));
        cosine = kept * cosine + added * normal(generator);
        sine   = kept * sine + added * normal(generator);
      }
    return stress;
  }

  void
  of_many_histories(const double memory)
  {
    constexpr std::size_t n = 8000, n_runs = 150;
    const CountingRules   rules = counting_rules(plain());
    std::mt19937_64       generator(3);
    std::vector<double>   sum(2, 0.), squares(2, 0.), stated(2, 0.);
    for (std::size_t run = 0; run < n_runs; ++run)
      {
        const std::vector<double> stress = wandering(n, memory, generator);
        DamageCounter             counter(rules);
        SamplingError             sampling(n, 1, 2);
        sampling.count(0, stress.data(), n, counter);
        counter.finish();
        const std::vector<double> error = sampling.of_node(0, counter);
        for (std::size_t c = 0; c < 2; ++c)
          {
            const double damage = counter.damages()[c];
            sum[c] += damage;
            squares[c] += damage * damage;
            stated[c] += std::pow(error[c] * damage, 2);
          }
      }
    for (std::size_t c = 0; c < 2; ++c)
      {
        const double mean      = sum[c] / n_runs;
        const double scatter   = std::sqrt(squares[c] / n_runs - mean * mean);
        const double ratio     = std::sqrt(stated[c] / n_runs) / scatter;
        const std::string name = ": " + std::to_string(ratio) + " of " +
                                 std::to_string(scatter / mean) +
                                 ", memory of " + std::to_string(memory) +
                                 " samples, curve " + std::to_string(c);
        check(scatter > .03 * mean, "the histories differ" + name);
        check(ratio > .8 && ratio < 1.6, "by their standard error" + name);
      }
  }



  HistoryDamage
  count(const std::vector<double> &pressure,
        const unsigned int         chunk = 4096,
        const FatigueParameters   &rules = plain())
  {
    HistoryLayout layout;
    layout.points     = {{{0., 0., 0.}}, {{1e-3, 0., 0.}}};
    layout.areas      = {1e-6, 2e-6};
    layout.has_status = layout.has_gap = layout.has_resultants = false;
    HistorySamples s;
    for (std::size_t i = 0; i < pressure.size(); ++i)
      {
        const double p = pressure[i];
        s.time.push_back(1e-3 * i);
        s.pressure.insert(s.pressure.end(), {p, .5 * p});
        s.traction.insert(s.traction.end(), {0., .5 * p, 0., .25 * p});
        s.slip_rate.insert(s.slip_rate.end(), {0., 1., 0., 1.});
      }
    std::filesystem::remove("history.h5");
    {
      HistoryWriter writer("history.h5", layout);
      writer.append(s);
      writer.finish();
    }
    const HistoryReader reader("history.h5");
    HistoryParameters   h;
    h.chunk = chunk;
    return count_history(reader, h, rules, {}, ContactGrid(reader.layout()));
  }

  /** Pressures of a vibration about 10 MPa. */
  std::vector<double>
  vibration(const std::size_t                            n,
            const std::function<double(const double i)> &amplitude)
  {
    std::vector<double> pressure;
    for (std::size_t i = 0; i < n; ++i)
      pressure.push_back(1e7 + amplitude(i) * std::sin(2. * M_PI * i / 20.));
    return pressure;
  }

  bool
  is_said(const HistoryDamage &damage)
  {
    for (const std::string &note : damage.notes)
      if (note.find("sample of a vibration that goes on") != std::string::npos)
        return true;
    return false;
  }

  void
  of_a_history()
  {
    const HistoryDamage even =
      count(vibration(4011, [](const double) { return 1e6; }));
    check(even.sampling_error[0] > 0. && even.sampling_error[0] < .02 &&
            !is_said(even),
          "an even vibration is known to some period of 200");
    FatigueParameters repeating = plain();
    repeating.residue           = FatigueParameters::Residue::repeating;
    const HistoryDamage whole =
      count(vibration(4001, [](const double) { return 1e6; }), 4096, repeating);
    check(whole.sampling_error == std::vector<double>{0., 0.} &&
            whole.nodes[1].sampling_error == whole.sampling_error,
          "whole periods have no sampling error");
    const auto growing =
      vibration(4011, [](const double i) { return 1e5 * std::exp(i / 1e3); });
    const HistoryDamage grown = count(growing);
    check(grown.sampling_error[0] > .5 && is_said(grown),
          "one that grows is no sample of what goes on");
    check_close(grown.least_peak,
                1e7 + 1e5 * std::exp(.99),
                5e-3,
                "the calmest quarter is the first");
    const HistoryDamage bursts = count(vibration(
      4011, [](const double i) { return i > 1500. && i < 1800. ? 1e6 : 1e4; }));
    check(bursts.sampling_error[0] > .7, "a single burst is its own error");
    const HistoryDamage pieces = count(growing, 7);
    check(pieces.sampling_error == grown.sampling_error &&
            pieces.nodes[0].damage == grown.nodes[0].damage &&
            pieces.least_peak == grown.least_peak,
          "pieces: the same bits");
    const HistoryDamage few =
      count(vibration(70, [](const double) { return 1e6; }));
    check(std::isnan(few.sampling_error[0]) && std::isnan(few.least_peak) &&
            !is_said(few),
          "of a few samples it is not known");
    const HistoryDamage none =
      count(vibration(4011, [](const double) { return 0.; }));
    check(none.sampling_error[0] == 0., "no damage has none");
  }
} // namespace

int
main()
{
  of_many_histories(20.);
  of_many_histories(200.);
  of_a_history();
}
