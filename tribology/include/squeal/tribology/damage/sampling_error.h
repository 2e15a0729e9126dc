// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_sampling_error_h
#define squeal_tribology_damage_sampling_error_h

#include <squeal/results/contact_history.h>
#include <squeal/tribology/fatigue/damage_counter.h>

#include <cstdint>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /**
   * How well a history that is a sample of a vibration that goes on knows its
   * damage: standard errors by the scatter between stretches of equal numbers
   * of samples. A cycle counts in the stretch that closes it. Neighbouring
   * stretches are joined, to halve their number, as bursts may be longer than
   * they, and the largest of the errors counts; what is closed at the end alone
   * has happened once, so that it is its own error. Changes slower than the
   * history are not seen. Shares are by Miner's sum, whatever accumulates.
   */
  class SamplingError
  {
  public:
    static constexpr std::size_t n_stretches = 16;

    /** Of a history of @p n_samples samples. */
    SamplingError(std::uint64_t n_samples,
                  std::size_t   n_nodes,
                  std::size_t   n_curves);

    /** Hands the next @p n stresses (Pa, tension positive) of @p node to its
     * @p counter, stretch by stretch. */
    void count(std::size_t    node,
               const double  *stresses,
               std::size_t    n,
               DamageCounter &counter);

    /** Adds the next samples, of whose pressures the peaks are. */
    void add_pressures(const HistorySamples &samples);

    /** Standard error of the damage of @p node over that damage, for each
     * curve; 0 where there is none, NaN where the stretches are too short to
     * tell. @p counter has finished. */
    std::vector<double> of_node(std::size_t          node,
                                const DamageCounter &counter) const;

    /** The same of the mean of the face; @p areas of the nodes, m^2. */
    std::vector<double> of_mean(const std::vector<DamageCounter> &counters,
                                const std::vector<double>        &areas) const;

    /** The largest pressure of the face, Pa, in that quarter of the history in
     * which it is least; NaN as above. */
    double least_peak_of_quarters() const;

    /** A line for a run whose mean damage, with the relative standard errors
     * @p of_mean, is known badly; "" for others. */
    static std::string note(const std::vector<double> &of_mean,
                            const std::vector<double> &exponents);

  private:
    /** Too few samples for stretches. */
    bool is_too_short() const;
    /** The stretch of sample number @p sample. */
    std::size_t stretch_of(std::uint64_t sample) const;
    /** The first sample behind it. */
    std::uint64_t end_of(std::size_t stretch) const;
    /** Relative standard error of a sum of @p total, @p closed of which have
     * been closed by the end of each stretch. */
    double relative_error(const std::vector<double> &closed,
                          double                     total) const;

    std::uint64_t n_samples;
    std::size_t   n_curves;
    /** Of each node, and of the face. */
    std::vector<std::uint64_t> n_counted;
    std::uint64_t              n_pressures = 0;
    /** For each node and stretch. */
    std::vector<std::vector<std::vector<double>>> closed;
    std::vector<double> peaks; /**< Pa, of each stretch */
  };
} // namespace squeal::tribology

#endif
