// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/transient_run.h>

namespace squeal
{
  std::vector<double>
  TransientRecord::times() const
  {
    std::vector<double> result;
    for (const auto &sample : samples)
      result.push_back(sample.time);
    return result;
  }

  std::vector<std::complex<double>>
  TransientRecord::branch(const unsigned int k, const unsigned int n) const
  {
    std::vector<std::complex<double>> result;
    for (std::size_t i = k; i < amplitudes.size(); i += n)
      result.push_back(amplitudes[i]);
    return result;
  }

  unsigned int
  TransientRecord::n_pairs() const
  {
    return samples.empty() ? 0 : pairs.size() / samples.size();
  }

  std::vector<double>
  TransientRecord::forces_of(const unsigned int i,
                             double PairSample::*const force) const
  {
    std::vector<double> result;
    for (std::size_t k = 0; k < samples.size(); ++k)
      result.push_back(pair(k, i).*force);
    return result;
  }

  std::vector<ForceStatistics>
  TransientRecord::stretches_of(const unsigned int i) const
  {
    if (pair_stretches.empty())
      return stretches;
    const auto first = pair_stretches.begin() + i * n_force_stretches;
    return {first, first + n_force_stretches};
  }

  std::vector<ForceStatistics>
  TransientRecord::trigger_stretches_of(const unsigned int i) const
  {
    if (trigger_stretches.empty())
      return {};
    const auto first = trigger_stretches.begin() + i * n_trigger_stretches;
    return {first, first + n_trigger_stretches};
  }

  const PairSample &
  TransientRecord::pair(const std::size_t k, const unsigned int i) const
  {
    return pairs[k * n_pairs() + i];
  }
} // namespace squeal
