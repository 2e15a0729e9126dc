// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/tribology/damage/damage_table.h>
#include <squeal/tribology/damage/sampling_error.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Of the mean damage, from which on an error is said. */
    constexpr double bad_enough = 0.2;

    /** Stretches of fewer samples hold no cycle that repeats. */
    constexpr std::uint64_t shortest_stretch = 8;

    /** Fewer parts of the history say little about their scatter. */
    constexpr std::size_t fewest_parts = 4;
  } // namespace



  SamplingError::SamplingError(const std::uint64_t n_samples,
                               const std::size_t   n_nodes,
                               const std::size_t   n_curves)
    : n_samples(n_samples)
    , n_curves(n_curves)
    , n_counted(n_nodes, 0)
    , closed(n_nodes)
    , peaks(n_stretches, 0.)
  {
  }

  bool
  SamplingError::is_too_short() const
  {
    return n_samples < n_stretches * shortest_stretch;
  }



  std::size_t
  SamplingError::stretch_of(const std::uint64_t sample) const
  {
    return sample * n_stretches / n_samples;
  }

  std::uint64_t
  SamplingError::end_of(const std::size_t stretch) const
  {
    // Rounded up, so that stretch_of() changes there.
    return ((stretch + 1) * n_samples + n_stretches - 1) / n_stretches;
  }



  void
  SamplingError::count(const std::size_t node,
                       const double     *stresses,
                       const std::size_t n,
                       DamageCounter    &counter)
  {
    std::uint64_t &at = n_counted[node];
    for (std::size_t done = 0; done < n;)
      {
        const std::uint64_t end  = end_of(stretch_of(at));
        const std::size_t   part = std::min<std::uint64_t>(end - at, n - done);
        counter.add(stresses + done, part);
        done += part;
        at += part;
        // Short histories have stretches without a sample.
        while (closed[node].size() < n_stretches &&
               end_of(closed[node].size()) <= at)
          closed[node].push_back(counter.closed_damages());
      }
  }

  void
  SamplingError::add_pressures(const HistorySamples &samples)
  {
    const std::size_t n_nodes = closed.size();
    for (std::size_t i = 0; i < samples.n_samples(); ++i)
      {
        const double *of_nodes = samples.pressure.data() + i * n_nodes;
        double       &peak     = peaks[stretch_of(n_pressures++)];
        peak = std::max(peak, *std::max_element(of_nodes, of_nodes + n_nodes));
      }
  }



  double
  SamplingError::relative_error(const std::vector<double> &closed,
                                const double               total) const
  {
    if (!(total > 0.))
      return 0.;
    if (is_too_short() || !std::isfinite(total))
      return NAN;
    double largest = 0.;
    for (std::size_t n = n_stretches; n >= fewest_parts; n /= 2)
      {
        const std::size_t joined = n_stretches / n;
        const double      mean   = closed.back() / n;
        double            before = 0., squares = 0.;
        for (std::size_t part = 1; part <= n; ++part)
          {
            const double until = closed[part * joined - 1];
            squares += std::pow(until - before - mean, 2);
            before = until;
          }
        largest = std::max(largest, squares * n / (n - 1.));
      }
    const double at_the_end = total - closed.back();
    return std::sqrt(largest + at_the_end * at_the_end) / total;
  }



  std::vector<double>
  SamplingError::of_node(const std::size_t    node,
                         const DamageCounter &counter) const
  {
    std::vector<double> result, sums(n_stretches);
    for (std::size_t c = 0; c < n_curves; ++c)
      {
        for (std::size_t i = 0; i < n_stretches; ++i)
          sums[i] = closed[node][i][c];
        result.push_back(relative_error(sums, counter.miner_sums()[c]));
      }
    return result;
  }



  std::vector<double>
  SamplingError::of_mean(const std::vector<DamageCounter> &counters,
                         const std::vector<double>        &areas) const
  {
    std::vector<double> result;
    for (std::size_t c = 0; c < n_curves; ++c)
      {
        double              total = 0.;
        std::vector<double> sums(n_stretches, 0.);
        for (std::size_t k = 0; k < closed.size(); ++k)
          {
            total += areas[k] * counters[k].miner_sums()[c];
            for (std::size_t i = 0; i < n_stretches; ++i)
              sums[i] += areas[k] * closed[k][i][c];
          }
        result.push_back(relative_error(sums, total));
      }
    return result;
  }



  double
  SamplingError::least_peak_of_quarters() const
  {
    if (is_too_short())
      return NAN;
    double least = INFINITY;
    for (auto first = peaks.begin(); first != peaks.end();
         first += n_stretches / 4)
      least =
        std::min(least, *std::max_element(first, first + n_stretches / 4));
    return least;
  }



  std::string
  SamplingError::note(const std::vector<double> &of_mean,
                      const std::vector<double> &exponents)
  {
    std::string known;
    for (std::size_t c = 0; c < of_mean.size(); ++c)
      if (of_mean[c] > bad_enough)
        known += (known.empty() ? "" : ", ") +
                 rounded_text(100. * of_mean[c], 2) + " % (slope " +
                 slope_name(exponents[c]) + ")";
    return known.empty()
             ? ""
             : "the cycles do not come evenly along the history: as a sample "
               "of a vibration that goes on it knows the mean damage only to "
               "+- " +
                 known + "; record more of it";
  }
} // namespace squeal::tribology
