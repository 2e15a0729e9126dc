// SPDX-License-Identifier: LGPL-2.1-or-later

// The life of a repeating history by the damage curves of Manson and Halford,
// against adding cycle after cycle until failure.
#include <squeal/base/number_text.h>
#include <squeal/tribology/fatigue/damage_counter.h>

#include <algorithm>
#include <random>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  constexpr double closed = 1e-9;

  /** The rule as it was published, cycle by cycle, with a reference life. */
  class ByTheCycle
  {
  public:
    explicit ByTheCycle(const double reference_life)
      : reference_life(reference_life)
    {
    }

    void
    add(const double n, const double life)
    {
      logarithm = std::log(used(life) + n / life) / power(life);
    }

    /** Part of the life of a level that is used. */
    double
    used(const double life) const
    {
      return std::exp(logarithm * power(life));
    }

  private:
    double
    power(const double life) const
    {
      return std::pow(reference_life / life, .4);
    }

    double reference_life;
    double logarithm = -INFINITY; /**< of the damage */
  };



  /** Some cycles of one life after the other. */
  using Block = std::vector<std::array<double, 2>>;

  /** Repetitions of @p block until failure, cycle by cycle; of the last one the
   * part of its cycles that was done. */
  double
  repetitions_by_the_cycle(const Block &block)
  {
    double n_cycles = 0.;
    for (const auto &[n, life] : block)
      n_cycles += n;
    ByTheCycle damage(1e4);
    for (unsigned int repetition = 0;; ++repetition)
      {
        double done = 0.;
        for (const auto &[n, life] : block)
          for (double i = 0.; i < n; i += 1.)
            {
              damage.add(1., life);
              done += 1.;
              if (damage.used(life) >= 1.)
                return repetition + done / n_cycles;
            }
      }
  }



  double
  repetitions(const Block &block)
  {
    MansonHalford rule;
    for (const auto &[n, life] : block)
      rule.add(n, 1. / life);
    return 1. / rule.share();
  }



  /** Share of the life of what a history repeats. */
  double
  share(const FatigueParameters &f, const std::vector<double> &stresses)
  {
    const CountingRules rules = counting_rules(f);
    DamageCounter       counter(rules);
    counter.add(stresses.data(), stresses.size());
    counter.finish();
    return counter.damages()[0];
  }



  /** Ten cycles from 0 to 4 MPa and fifty to 1 MPa, some times over. */
  std::vector<double>
  two_levels(const unsigned int n_times)
  {
    std::vector<double> stresses;
    for (unsigned int i = 0; i < n_times; ++i)
      {
        for (unsigned int k = 0; k < 10; ++k)
          stresses.insert(stresses.end(), {0., 4e6});
        for (unsigned int k = 0; k < 50; ++k)
          stresses.insert(stresses.end(), {0., 1e6});
      }
    return stresses;
  }



  FatigueParameters
  damage_curves()
  {
    FatigueParameters f;
    f.exponents    = {3.};
    f.constants    = {1e6};
    f.residue      = FatigueParameters::Residue::repeating;
    f.accumulation = FatigueParameters::Accumulation::manson_halford;
    return f;
  }



  void
  published_numbers()
  {
    ByTheCycle high(1e3), low(1e5);
    high.add(.5e3, 1e3);
    low.add(.5e5, 1e5);
    check(std::abs(1. - high.used(1e5) - 0.1040372) <= 5.1e-8,
          "high then low: what is left of the low level");
    check(std::abs(1. - low.used(1e3) - 0.9873925) <= 5.1e-8,
          "low then high: what is left of the high level");
    check_close(high.used(1e5),
                std::pow(.5, std::pow(.01, .4)),
                closed,
                "high then low in closed form");
  }



  void
  one_level()
  {
    for (const double life : {3., 2e3, 7e6, 1e15, 1e60})
      check_close(repetitions({{1., life}}),
                  life,
                  closed,
                  "one level lives its " + rounded_text(life, 3) + " cycles");
    check_close(repetitions({{.5, 2e3}, {20., 2e3}}),
                2e3 / 20.5,
                closed,
                "half cycles are halves");
    FatigueParameters   f = damage_curves(), miner = f;
    std::vector<double> sine;
    for (unsigned int i = 0; i < 160; ++i)
      sine.push_back(2e6 * std::sin(2. * M_PI * (i % 16) / 16.));
    miner.accumulation = FatigueParameters::Accumulation::miner;
    check_close(share(miner, sine), 10. / 125e3, closed, "Miner's sum");
    check_close(share(f, sine), 10. / 125e3, closed, "is met by damage curves");
    MansonHalford rule;
    check(rule.share() == 0., "no cycles take nothing");
    rule.add(5., 0.);
    check(rule.share() == 0., "cycles that do nothing take nothing");
    rule.add(1., INFINITY);
    check(std::isinf(rule.share()), "one that breaks leaves no life");
  }



  /** Within a repetition, whatever the order, for lives that differ much. */
  void
  against_cycle_by_cycle()
  {
    for (const double n : {1., 5., 40.})
      for (const double low : {2e3, 1e5})
        {
          const Block  block = {{n, 1e3}, {20. * n, low}};
          const Block  turned(block.rbegin(), block.rend());
          const double life = repetitions(block);
          check_close(repetitions(turned), life, closed, "order is left out");
          for (const Block &b : {block, turned})
            {
              const double expected = repetitions_by_the_cycle(b);
              check(std::abs(life - expected) <= 1.,
                    std::to_string(life) + " repetitions, cycle by cycle " +
                      std::to_string(expected));
            }
          check(life < 1. / (n / 1e3 + 20. * n / low),
                "blocks fail earlier than Miner's sum says");
        }
    // scattered lives share levels: within one of some thousand repetitions
    std::mt19937_64                        generator(3);
    std::uniform_real_distribution<double> uniform;
    Block                                  block;
    for (unsigned int i = 0; i < 200; ++i)
      block.push_back({{1., std::pow(10., 5.5 + 2. * uniform(generator))}});
    const double expected = repetitions_by_the_cycle(block);
    check(expected > 2e3, "the scattered block repeats often");
    check_close(repetitions(block),
                expected,
                5e-4,
                "two hundred lives, cycle by cycle " +
                  std::to_string(expected));
  }



  void
  ways_to_write_a_curve()
  {
    FatigueParameters f        = damage_curves();
    const double      expected = share(f, two_levels(1));
    check(expected > 0., "two levels do damage");
    for (const auto &[stress, constant] :
         {std::pair{2e6, 1.25e5}, {.5e6, 8e6}, {1e3, 1e15}})
      {
        f.reference_stress = stress;
        f.constants        = {constant};
        check_close(share(f, two_levels(1)),
                    expected,
                    closed,
                    "the same curve through " + std::to_string(stress) +
                      " Pa: the same damage");
      }
  }



  void
  length_of_a_history()
  {
    const FatigueParameters f        = damage_curves();
    const double            expected = share(f, two_levels(1));
    for (const unsigned int n : {4u, 64u})
      check_close(share(f, two_levels(n)) / n,
                  expected,
                  closed,
                  "a history " + std::to_string(n) +
                    " times: the same damage per second");
  }



  void
  mean_stress()
  {
    FatigueParameters f = damage_curves();
    f.ultimate_strength = 20e6;
    using Kind          = FatigueParameters::MeanStress;
    for (const Kind kind : {Kind::none, Kind::goodman, Kind::gerber, Kind::swt})
      {
        f.mean_stress = kind;
        const MeanStressCorrection correction(f);
        const SnCurve              curve = sn_curves(f)[0];
        MansonHalford              rule;
        for (const auto &[n, half] : {std::pair{10., 2e6}, {50., .5e6}})
          rule.add(n,
                   curve.damage(correction.equivalent_amplitude(half, half)));
        check_close(share(f, two_levels(1)),
                    rule.share(),
                    closed,
                    "the amplitudes are those corrected for mean stress");
        for (const unsigned int n : {4u, 64u})
          check_close(share(f, two_levels(n)) / n,
                      rule.share(),
                      closed,
                      "and so are those of " + std::to_string(n) +
                        " repetitions");
      }
  }
} // namespace



int
main()
{
  published_numbers();
  one_level();
  against_cycle_by_cycle();
  ways_to_write_a_curve();
  length_of_a_history();
  mean_stress();
}
