// SPDX-License-Identifier: LGPL-2.1-or-later

// 121 nodes with a million samples of noise each are counted, with damage for
// three slopes, in at most 1.6 CPU seconds, and memory does not grow with the
// length.
#include <squeal/base/timers.h>
#include <squeal/tribology/fatigue/damage_counter.h>

#include <cstdlib>
#include <random>

#include "check.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

int
main(int argc, char **argv)
{
  const double        limit   = argc > 1 ? std::atof(argv[1]) : 1.6;
  const unsigned int  n_nodes = 121, n_chunk = 4096, n_samples = 1000000;
  std::vector<double> values(n_nodes * n_chunk);
  std::mt19937_64     generator(1);
  std::normal_distribution<double> normal;
  for (double &v : values)
    v = normal(generator);

  FatigueParameters   f; // slopes 3, 5, 10
  const CountingRules rules = counting_rules(f);
  Worst               seconds;
  double              memory = 0.;
  Worst               deepest;
  for (unsigned int run = 0; run < 3; ++run)
    {
      std::vector<DamageCounter> counters(n_nodes, DamageCounter(rules));
      const double               start = cpu_seconds();
      for (unsigned int done = 0; done < n_samples;)
        {
          const unsigned int n = std::min(n_chunk, n_samples - done);
          for (unsigned int node = 0; node < n_nodes; ++node)
            // other values each time, or the processor learns the branches
            counters[node].add(
              &values[(node * 31 + done / n_chunk * 57) % n_nodes * n_chunk],
              n);
          done += n;
          if (run == 0 && done == 10 * n_chunk)
            memory = peak_memory_mb();
        }
      for (DamageCounter &c : counters)
        {
          c.finish();
          deepest.add(double(c.deepest()));
        }
      seconds.add(cpu_seconds() - start);
      check(counters[0].n_cycles() > 3.2e5 && counters[0].n_cycles() < 3.4e5,
            "noise: a third of the samples close a cycle");
    }
  std::cout << seconds.smallest() << " CPU s, " << deepest.largest()
            << " points kept, " << peak_memory_mb() << " MB\n";
  check(seconds.smallest() <= limit, "counted in time");
  check(peak_memory_mb() < memory + 8., "25 times longer: no more memory");
}
