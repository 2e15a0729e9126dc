// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_transient_sound_h
#define squeal_analyses_transient_transient_sound_h

#include <squeal/analyses/transient/transient_results.h>

namespace squeal
{
  /** Writes pad.wav, or <contact>.wav of each of several pairs: the
   * acceleration of the source's centre along the normal of the pair, or along
   * its sliding where the tangential force of the loudest is judged
   * (JudgedPair::force), or the moment of the normal forces where that is, as
   * the centre of a body that wobbles hardly moves; prolonged to some seconds.
   * Of a run in which nothing vibrates by more than noise the files are silent,
   * and the log says so. Nothing is written where the samples would sound of
   * another frequency (TransientFigures::beyond_samples). */
  void write_sounds(RunContext              &context,
                    const PreparedTransient &prepared,
                    const TransientRecord   &record,
                    const TransientFigures  &figures);
} // namespace squeal

#endif
