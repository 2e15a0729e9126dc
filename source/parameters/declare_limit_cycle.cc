// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>

namespace squeal
{
  namespace prm
  {
    void
    declare_limit_cycle(Schema &schema, LimitCycleParameters &l)
    {
      schema.enter_section("Limit cycle",
                           "Periodic motions of the reduced model of "
                           "'Transient', of 'Analysis = limit cycle'. With one "
                           "linear or logarithmic axis in 'Sweep' the cycle is "
                           "followed over it from the scene's own value, to "
                           "either side by at most 'Number' points.");
      schema.add("Pair frequency",
                 l.frequency,
                 Allowed::number(0.),
                 "The cycle is sought from the growing pair nearest to this "
                 "frequency; 0: from the one that grows fastest.",
                 "Hz");
      schema.add("Every growing pair",
                 l.every_pair,
                 "One cycle for each growing pair of the band of "
                 "'Eigenvalues', in competition.csv.");
      schema.add(
        "Campaign",
        l.campaign,
        "The cycles of every growing pair at each point of the axes of "
        "'Sweep' and for each of 'Transient/Tops' instead of one "
        "branch: competition.csv has a row for each pair and "
        "campaign.csv one for each point, with what is left of "
        "them.");
      schema.add("Start amplitude",
                 l.start,
                 Allowed::positive(1e3),
                 "Amplitude of the pair at the start, over the one at which "
                 "half of the closed nodes would open or stick if the motion "
                 "stayed linear. From a large one the motion may come to "
                 "another cycle than what a small disturbance grows to: "
                 "'Starts' tells.");
      schema.add("Run time",
                 l.run_time,
                 Allowed::number(0.),
                 "How long the motion is followed from there at most before "
                 "Newton's method looks for the periodic one: less where it "
                 "comes back to where it was before.",
                 "s");
      schema.add("Run steps per period",
                 l.run_steps,
                 Allowed::integer(16, 4096),
                 "Time steps of a period of the pair in that run; more "
                 "are taken where these would be unstable.");
      schema.add(
        "Starts",
        l.starts,
        Allowed::integer(0, 100),
        "Motions from so many starts are followed for "
        "two 'Run time' at most, longer where the multiplier may be "
        "above 1, beside the limit cycle, or with 'Campaign' beside that of "
        "every point which can be heard, to see whether they end in it, and "
        "one more from the cycle itself, to see whether it stays: "
        "starts.csv. The first is what a small disturbance of steady sliding "
        "grows to, the next go on from the runs of the growing pairs, the "
        "others begin with impulses at points of all bodies.");
      schema.add(
        "Searches along axis",
        l.searches,
        Allowed::integer(0, 1000),
        "At so many even values of the axis of a branch, its ends among "
        "them, a cycle is sought anew, and each that lies on no branch yet "
        "starts one of its own: branch_searches.csv says what each has come "
        "to. At least 2; 0: the branch of the scene's own value alone.");
      schema.add("Steps per period",
                 l.steps,
                 Allowed::integer(32, 8192),
                 "Time steps of the periodic motion, more where these would "
                 "be unstable; it is sought with half of them as well, and "
                 "the difference is the error that is printed.");
      schema.add("Harmonics",
                 l.harmonics,
                 Allowed::integer(1, 1000),
                 "Harmonics of the forces that are written; the log says what "
                 "share of them is beyond.");
      schema.add("Iterations",
                 l.iterations,
                 Allowed::integer(1, 1000),
                 "Newton iterations after which a cycle counts as not "
                 "converged.");
      schema.add("Tolerance",
                 l.tolerance,
                 Allowed::positive(1e-2),
                 "What a periodic motion may miss its start by after a "
                 "period, in the energy of the motion.");
      schema.leave_section();
    }
  } // namespace prm
} // namespace squeal
