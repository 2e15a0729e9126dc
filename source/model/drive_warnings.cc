// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/base/run_log.h>
#include <squeal/model/drive_warnings.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    void
    warn_of_early_trigger(const std::string &entry,
                          const double       time,
                          const double       longest,
                          RunLog            &log)
    {
      if (time < longest)
        log.warning("'" + entry + "' = " + rounded_text(time, 4) +
                    " s is before the end of the longest 'Ramp time', " +
                    rounded_text(longest, 4) +
                    " s: what follows the trigger is not told from what the "
                    "load does that comes on");
    }
  } // namespace



  void
  warn_of_drive(const Parameters &p, RunLog &log)
  {
    const TransientParameters &t       = p.transient;
    double                     longest = 0.;
    for (const auto &load : p.scene.loads)
      longest = std::max(longest, load.ramp_time);
    if (t.start != TransientParameters::Start::ramp)
      return;
    if (!t.hammer.body.empty())
      warn_of_early_trigger(
        "Transient/Hammer/Time", t.hammer.time, longest, log);
    if (t.friction_impulse != 0.)
      warn_of_early_trigger("Transient/Friction impulse time",
                            t.friction_impulse_time,
                            longest,
                            log);
  }
} // namespace squeal
