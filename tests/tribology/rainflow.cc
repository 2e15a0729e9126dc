// SPDX-License-Identifier: LGPL-2.1-or-later

// Rainflow counting gives the cycles of ASTM E1049, by either rule for the
// residue, and the same to the last bit however the history is cut in pieces.
#include <squeal/tribology/fatigue/damage_counter.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  using Cycle   = std::array<double, 3>; // range, mean, count
  using Residue = RainflowCounter::Residue;

  const std::vector<double> astm = {-2, 1, -3, 5, -1, 3, -4, 4, -2};

  std::vector<Cycle>
  count(const std::vector<double> &history,
        const Residue              residue,
        const std::size_t          piece = 1000000)
  {
    std::vector<Cycle> cycles;
    const auto         sink =
      [&](const double range, const double mean, const double n) {
        cycles.push_back({{range, mean, n}});
      };
    RainflowCounter counter(residue);
    for (std::size_t i = 0; i < history.size(); i += piece)
      counter.add(&history[i], std::min(piece, history.size() - i), 1, sink);
    counter.finish(sink);
    return cycles;
  }

  double
  power_sum(const std::vector<Cycle> &cycles, const double m)
  {
    double sum = 0.;
    for (const Cycle &c : cycles)
      sum += c[2] * std::pow(c[0], m);
    return sum;
  }

  std::vector<double>
  noise(const std::size_t n, const unsigned int seed)
  {
    std::mt19937_64                  generator(seed);
    std::normal_distribution<double> normal;
    std::vector<double>              values(n);
    for (double &v : values)
      v = normal(generator);
    return values;
  }

  void
  example_of_astm()
  {
    std::vector<Cycle>       cycles   = count(astm, Residue::half_cycles);
    const std::vector<Cycle> expected = {{{3, -.5, .5}},
                                         {{4, -1, .5}},
                                         {{4, 1, 1}},
                                         {{8, 1, .5}},
                                         {{9, .5, .5}},
                                         {{8, 0, .5}},
                                         {{6, 1, .5}}};
    check(cycles == expected, "ASTM E1049: range, mean and count in order");
    std::map<double, double> table;
    for (const Cycle &c : cycles)
      table[c[0]] += c[2];
    check(table == std::map<double, double>(
                     {{3, .5}, {4, 1.5}, {6, .5}, {8, 1.}, {9, .5}}),
          "ASTM E1049: its table of ranges");
    check(power_sum(cycles, 1) == 23 && power_sum(cycles, 3) == 1094 &&
            power_sum(cycles, 5) == 67838,
          "sums of n range^m: 23, 1094, 67838");

    cycles = count(astm, Residue::repeating);
    std::vector<double> ranges;
    for (const Cycle &c : cycles)
      {
        check(c[2] == 1., "a repeating history has full cycles only");
        ranges.push_back(c[0]);
      }
    std::sort(ranges.begin(), ranges.end());
    check(ranges == std::vector<double>({3, 4, 7, 9}),
          "repeating: ranges 3, 4, 7, 9");
    check(power_sum(cycles, 1) == 23 && power_sum(cycles, 3) == 1163 &&
            power_sum(cycles, 5) == 77123,
          "repeating: sums 23, 1163, 77123");

    RainflowCounter counter(Residue::repeating);
    cycles.clear();
    const auto sink =
      [&](const double range, const double mean, const double n) {
        cycles.push_back({{range, mean, n}});
      };
    counter.add(astm.data(), astm.size(), 1, sink);
    check(cycles == std::vector<Cycle>({{{4, 1, 1}}}),
          "four-point: the cycle (-1, 3) closes");
    std::vector<double> open = counter.open_points();
    open.push_back(astm.back()); // known as a turning point at the end only
    check(open == std::vector<double>({-2, 1, -3, 5, -4, 4, -2}),
          "four-point: the residue");
  }

  void
  special_histories()
  {
    for (const Residue residue : {Residue::half_cycles, Residue::repeating})
      {
        check(count({}, residue).empty() && count({3.}, residue).empty() &&
                count({3., 3., 3.}, residue).empty(),
              "no history, one value, a constant: no cycle");
      }
    check(count({0, 1}, Residue::half_cycles) ==
            std::vector<Cycle>({{{1, .5, .5}}}),
          "one rise: half a cycle");
    check(count({0, 1}, Residue::repeating) ==
            std::vector<Cycle>({{{1, .5, 1}}}),
          "one rise, repeating: a cycle");
    check(count({0, 0, 1, 1, 1, 0, 0}, Residue::half_cycles) ==
            count({0, 1, 0}, Residue::half_cycles),
          "values that repeat change nothing");
    check(count({0, 1e-310, 0, 1e-310, 0}, Residue::half_cycles).size() == 4,
          "ranges whose product underflows turn too");

    std::vector<double> swing;
    for (unsigned int i = 0; i < 1000; ++i)
      swing.push_back(i % 2 == 0 ? 1. : -1.);
    for (const Residue residue : {Residue::half_cycles, Residue::repeating})
      {
        const std::vector<Cycle> cycles = count(swing, residue);
        double                   n      = 0.;
        for (const Cycle &c : cycles)
          n += c[2];
        check(n == (residue == Residue::repeating ? 500. : 499.5),
              "a steady swing of 1000 values: " + std::to_string(n) +
                " cycles");
      }
  }

  /** A slow count straight from the text of the standard. */
  std::vector<Cycle>
  by_the_book(std::vector<double> v)
  {
    std::vector<double> points;
    for (std::size_t i = 0; i < v.size(); ++i)
      if (i == 0 || i + 1 == v.size() ||
          (v[i] - v[i - 1]) * (v[i + 1] - v[i]) < 0.)
        points.push_back(v[i]);
    std::vector<Cycle>  cycles;
    std::vector<double> read;
    for (const double point : points)
      {
        read.push_back(point);
        while (read.size() >= 3)
          {
            const std::size_t n = read.size();
            const double      x = std::abs(read[n - 1] - read[n - 2]);
            const double      y = std::abs(read[n - 2] - read[n - 3]);
            if (x < y)
              break;
            const double mean = .5 * (read[n - 2] + read[n - 3]);
            if (n == 3)
              {
                cycles.push_back({{y, mean, .5}});
                read.erase(read.begin());
              }
            else
              {
                cycles.push_back({{y, mean, 1.}});
                read.erase(read.end() - 3, read.end() - 1);
              }
          }
      }
    for (std::size_t i = 0; i + 1 < read.size(); ++i)
      cycles.push_back(
        {{std::abs(read[i] - read[i + 1]), .5 * (read[i] + read[i + 1]), .5}});
    return cycles;
  }

  void
  noise_in_pieces()
  {
    for (unsigned int seed = 0; seed < 20; ++seed)
      {
        const std::vector<double> v = noise(5000 + 7 * seed, seed);
        check(count(v, Residue::half_cycles) == by_the_book(v),
              "noise " + std::to_string(seed) + ": as the standard says");
        for (const Residue residue : {Residue::half_cycles, Residue::repeating})
          for (const std::size_t piece : {1ul, 2ul, 3ul, 1000ul, 1025ul})
            if (count(v, residue, piece) != count(v, residue))
              check(false, "pieces of " + std::to_string(piece));
      }
    check(true, "pieces of 1 to 1025 values: the same cycles");
  }

  void
  damage_in_pieces()
  {
    FatigueParameters f;
    f.exponents        = {3., 5., 10., 4.7};
    f.reference_stress = 1.;
    for (const auto mean : {FatigueParameters::MeanStress::none,
                            FatigueParameters::MeanStress::walker})
      for (const auto residue : {FatigueParameters::Residue::half_cycles,
                                 FatigueParameters::Residue::repeating})
        {
          f.mean_stress                   = mean;
          f.residue                       = residue;
          const CountingRules       rules = counting_rules(f);
          const std::size_t         n     = 200000;
          const std::vector<double> v     = noise(2 * n, 5);
          DamageCounter             whole(rules);
          whole.add(v.data(), n, 2);
          whole.finish();
          for (const std::size_t piece : {1ul, 777ul, 4096ul})
            {
              DamageCounter pieces(rules);
              for (std::size_t i = 0; i < n; i += piece)
                pieces.add(&v[2 * i], std::min(piece, n - i), 2);
              pieces.finish();
              check(pieces.damages() == whole.damages() &&
                      pieces.n_cycles() == whole.n_cycles(),
                    "damage in pieces of " + std::to_string(piece) +
                      ": the same to the last bit");
            }
          check(whole.deepest() < 200,
                "200000 values leave " + std::to_string(whole.deepest()) +
                  " points");
        }
    const CountingRules rules = counting_rules(f);
    std::size_t         depths[2];
    for (unsigned int k = 0; k < 2; ++k)
      {
        DamageCounter counter(rules);
        for (unsigned int i = 0; i < (k == 0 ? 10u : 1000u); ++i)
          {
            const std::vector<double> v = noise(1000, 3);
            counter.add(v.data(), v.size());
          }
        depths[k] = counter.deepest();
      }
    check(depths[1] <= depths[0] + 8,
          "a hundred times longer: " + std::to_string(depths[0]) + " and " +
            std::to_string(depths[1]) + " points kept");
  }

  void
  matrices()
  {
    FatigueParameters f;
    CountingRules     rules = counting_rules(f);
    rules.empty_matrix.emplace(10, 10., -5., 5.);
    DamageCounter counter(rules);
    counter.add(astm.data(), astm.size());
    counter.finish();
    const RangeMeanMatrix &m = *counter.matrix();
    // ranges 3, 4, 4, 8, 9, 8, 6; a value on a border belongs to the upper
    // class
    check(m.count(3, 4) == .5 && m.count(4, 4) == .5 && m.count(4, 6) == 1. &&
            m.count(8, 6) == .5 && m.count(9, 5) == .5 && m.count(8, 5) == .5 &&
            m.count(6, 6) == .5,
          "the range-mean matrix of the example");
    double sum = 0.;
    for (const double c : m.values())
      sum += c;
    check(sum == counter.n_cycles() && sum == 4., "it holds all 4 cycles");
  }
} // namespace



int
main()
{
  example_of_astm();
  special_histories();
  noise_in_pieces();
  damage_in_pieces();
  matrices();
}
