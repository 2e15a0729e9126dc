// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      void
      declare_fates(Schema &schema, TriggersParameters &t)
      {
        schema.add("Window",
                   t.window,
                   Allowed::positive(),
                   "Motions are judged by windows of this length: many "
                   "periods of what is expected.",
                   "s");
        schema.add("Hold time",
                   t.hold,
                   Allowed::positive(),
                   "What a motion does has to last so long before it is "
                   "judged: no node leaves its status in steady sliding, "
                   "no friction turns from that of steady sliding by more than "
                   "0.02 rad and the vibration falls (it comes back), or the "
                   "forces of a window stay within 5 % of those that the "
                   "largest impulse "
                   "ends in (it squeals).",
                   "s");
        schema.add("Longest time",
                   t.longest,
                   Allowed::positive(),
                   "A motion that has done neither by then is undecided; the "
                   "one after the largest impulse goes on until then. Where "
                   "pairs decay slowly and friction turns within the face, "
                   "several times the inverse of the slowest rate.",
                   "s");
      }
    } // namespace



    void
    declare_triggers(Schema &schema, TriggersParameters &t)
    {
      schema.enter_section("Triggers",
                           "Smallest impulses that lead from a stable steady "
                           "sliding to squeal, and the motion on the edge "
                           "between both, of 'Analysis = triggers'. With axes "
                           "in 'Sweep' at each of their points. Steps are "
                           "those of 'Transient/Time step'; the cycles are "
                           "sought with 'Steps per period', 'Iterations' and "
                           "'Tolerance' of 'Limit cycle'.");
      schema.add("Points",
                 t.points,
                 Allowed::list(Allowed::text()),
                 "Names of 'Measurement/Points' that are struck, each along "
                 "its direction; empty: all.");
      schema.add("Impulses",
                 t.impulses,
                 Allowed::list(Allowed::positive(), 0, 100),
                 "Impulses that are tried first, ascending; the threshold is "
                 "sought below the smallest of them that leads to squeal. The "
                 "largest has to, and more than one change of what a motion "
                 "ends in is reported.",
                 "N s");
      schema.add("Duration",
                 t.duration,
                 Allowed::positive(),
                 "Of the blow, whose force is a half sine: its top is pi/2 of "
                 "the impulse over the duration.",
                 "s");
      schema.add("Tolerance",
                 t.tolerance,
                 Allowed::positive(0.5),
                 "The threshold is bisected until the bracket is this small, "
                 "relative to its upper end.");
      declare_fates(schema, t);
      schema.add("Edge time",
                 t.edge_time,
                 Allowed::number(0.),
                 "How long the motion on the edge is followed from the blow on "
                 "before the unstable cycle is sought from it; 0: it is not.",
                 "s");
      schema.add("Halvings",
                 t.halvings,
                 Allowed::integer(1, 50),
                 "How often the way between two motions either side of the "
                 "edge is halved, each time that they have gone apart.");
      schema.leave_section();
    }
  } // namespace prm
} // namespace squeal
