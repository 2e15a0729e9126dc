// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_wav_file_h
#define squeal_results_wav_file_h

#include <string>
#include <vector>

namespace squeal
{
  /**
   * A record made long enough to be heard: itself, then its second half over
   * and over until @p seconds are full, each time faded into the next.
   *
   * @param samples of evenly spaced times
   * @param rate    samples a second
   */
  std::vector<double> prolonged(const std::vector<double> &samples,
                                const double               rate,
                                const double               seconds);

  /**
   * Writes one channel of 16-bit PCM, scaled so that the largest sample has
   * 0.8 of full scale; silence stays silent. Throws InputError where it cannot
   * be written.
   */
  void write_wav(const std::string         &path,
                 const std::vector<double> &samples,
                 const double               rate);
} // namespace squeal

#endif
