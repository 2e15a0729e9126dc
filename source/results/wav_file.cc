// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/files.h>
#include <squeal/results/wav_file.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>

namespace squeal
{
  namespace
  {
    /** Of the time in which one repetition gives way to the next. */
    constexpr double fade_seconds = 5e-3;

    constexpr double loudness = 0.8 * 32767.;

    /** Little endian, whatever the machine is. */
    void
    put(std::ostream &out, const std::uint32_t value, const unsigned int bytes)
    {
      for (unsigned int b = 0; b < bytes; ++b)
        out.put(static_cast<char>((value >> (8 * b)) & 0xff));
    }
  } // namespace



  std::vector<double>
  prolonged(const std::vector<double> &samples,
            const double               rate,
            const double               seconds)
  {
    std::vector<double> result = samples;
    const std::size_t   wanted = std::lround(seconds * rate),
                      half = samples.size() / 2, n = samples.size() - half;
    const std::size_t fade =
      std::min<std::size_t>(std::lround(fade_seconds * rate), n / 2);
    if (n <= fade)
      return result;
    while (result.size() < wanted)
      {
        const std::size_t start = result.size() - fade;
        for (std::size_t i = 0; i < n; ++i)
          if (i < fade)
            {
              const double share = (i + 0.5) / fade;
              result[start + i] =
                (1. - share) * result[start + i] + share * samples[half + i];
            }
          else
            result.push_back(samples[half + i]);
      }
    return result;
  }



  void
  write_wav(const std::string         &path,
            const std::vector<double> &samples,
            const double               rate)
  {
    double largest = 0.;
    for (const double x : samples)
      largest = std::max(largest, std::abs(x));
    const double        factor = largest > 0. ? loudness / largest : 0.;
    const std::uint32_t size = 2 * samples.size(), hertz = std::lround(rate);
    write_atomically(path, [&](std::ostream &out) {
      out << "RIFF";
      put(out, 36 + size, 4);
      out << "WAVEfmt ";
      put(out, 16, 4);
      put(out, 1, 2); // PCM
      put(out, 1, 2); // one channel
      put(out, hertz, 4);
      put(out, 2 * hertz, 4);
      put(out, 2, 2);
      put(out, 16, 2);
      out << "data";
      put(out, size, 4);
      for (const double x : samples)
        put(out,
            static_cast<std::uint16_t>(
              static_cast<std::int16_t>(std::lround(factor * x))),
            2);
    });
  }
} // namespace squeal
