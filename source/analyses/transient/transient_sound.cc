// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/transient_sound.h>
#include <squeal/results/wav_file.h>
#include <squeal/run/run_context.h>
#include <squeal/transient/slow_part.h>

namespace squeal
{
  namespace
  {
    /** Length of the sound file, s: long enough to tell a squeal by ear. */
    constexpr double sound_seconds = 3.;

    void
    write_sound(const ContactPair      &pair,
                const unsigned int      number,
                const TransientRecord  &record,
                const TransientFigures &f,
                const std::string      &path)
    {
      const auto &samples = record.samples;
      if (samples.size() < 2)
        return;
      const ContactFrame frame = mean_frame(pair.geometry);
      const bool         beside_sums =
        f.loudest.is_beside_sums() && number == f.loudest.number;
      const auto &along = f.loudest.force == JudgedForce::tangential
                            ? frame.sliding
                            : frame.normal;
      const std::vector<double> force =
        beside_sums ? without_slow_part(samples_of(record, f.loudest))
                    : std::vector<double>();
      std::vector<double> acceleration;
      for (std::size_t k = 0; k < samples.size(); ++k)
        {
          const double *a = record.pair(k, number).acceleration;
          // A file is as loud as it can be: noise would be, too.
          acceleration.push_back(
            f.is_silent ? 0.
            // The centre of a body that wobbles or carries a wave hardly moves.
            : beside_sums
              ? force[k]
              : along[0] * a[0] + along[1] * a[1] + along[2] * a[2]);
        }
      const double rate =
        (samples.size() - 1) / (samples.back().time - samples.front().time);
      write_wav(path, prolonged(acceleration, rate, sound_seconds), rate);
    }
  } // namespace



  void
  write_sounds(RunContext              &context,
               const PreparedTransient &prepared,
               const TransientRecord   &record,
               const TransientFigures  &f)
  {
    if (f.beyond_samples > 0.)
      return;
    if (f.is_silent)
      context.log.info("  no force vibrates by more than the noise of the "
                       "solver: the sound is silence");
    const auto &pairs = prepared.pressed.nodes().pairs();
    for (unsigned int i = 0; i < pairs.size(); ++i)
      write_sound(pairs[i],
                  i,
                  record,
                  f,
                  context.output.file(
                    (pairs.size() == 1 ? "pad" : pairs[i].name()) + ".wav"));
  }
} // namespace squeal
