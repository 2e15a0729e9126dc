// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Sound of a record: header, scale and pitch.
#include <squeal/base/files.h>
#include <squeal/results/wav_file.h>

#include "check.h"
#include "worst.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  unsigned int
  number(const std::string &text, const std::size_t at, const unsigned int n)
  {
    unsigned int result = 0;
    for (unsigned int b = 0; b < n; ++b)
      result += static_cast<unsigned char>(text[at + b]) << (8 * b);
    return result;
  }
} // namespace

int
main()
{
  const double        rate = 50000., frequency = 3430.;
  std::vector<double> tone;
  for (unsigned int i = 0; i < 4000; ++i)
    tone.push_back(1e3 * std::sin(2. * M_PI * frequency * i / rate));
  const auto   sound    = prolonged(tone, rate, 2.);
  unsigned int n_rising = 0;
  Worst        loudest;
  for (std::size_t i = 1; i < sound.size(); ++i)
    {
      n_rising += sound[i - 1] < 0. && sound[i] >= 0.;
      loudest.add(std::abs(sound[i]));
    }
  check(sound.size() >= 100000, "two seconds");
  check_close(n_rising * rate / sound.size(),
              frequency,
              0.01 * frequency,
              "the pitch stays");
  check(loudest.largest() < 1e3 * (1. + 1e-9), "fades are not louder");
  write_wav("tone.wav", sound, rate);
  const std::string file = read_file("tone.wav");
  check(file.substr(0, 4) == "RIFF" && file.substr(8, 8) == "WAVEfmt ",
        "a RIFF file of format WAVE");
  check(number(file, 24, 4) == 50000 && number(file, 22, 2) == 1 &&
          number(file, 34, 2) == 16,
        "one channel, 50 kHz, 16 bits");
  check(file.size() == 44 + 2 * sound.size() &&
          number(file, 40, 4) == 2 * sound.size(),
        "with all samples");
  Worst largest;
  for (std::size_t i = 44; i < file.size(); i += 2)
    largest.add(
      std::abs(static_cast<int>(static_cast<short>(number(file, i, 2)))));
  check(largest.largest() == 26214., "at 0.8 of full scale");
  write_wav("silence.wav", std::vector<double>(10, 0.), rate);
  check(number(read_file("silence.wav"), 44, 2) == 0, "silence stays silent");
}
