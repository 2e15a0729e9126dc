// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      void
      declare_axis(Schema &schema, SweepAxisParameters &a)
      {
        schema.add("Entries",
                   a.entries,
                   Allowed::list(Allowed::text()),
                   "Numbers of the scene that are swept, such as 'Scene/Body "
                   "pad/Young modulus'; several move together. A "
                   "campaign of transients also changes how finely it is "
                   "computed: Discretization/Degree and Refinements, "
                   "Transient/Time step, Cut-off, Interface cut-off and "
                   "Tolerance.");
        schema.add("Scale",
                   a.scale,
                   "Equal ratios or equal steps between From and To, or a list "
                   "of values.");
        schema.add("From",
                   a.from,
                   Allowed::list(Allowed::number()),
                   "First value: one for all entries, or one for each.",
                   "those of the entries");
        schema.add("To",
                   a.to,
                   Allowed::list(Allowed::number()),
                   "Last value: one for all entries, or one for each.",
                   "those of the entries");
        schema.add("Number",
                   a.number,
                   Allowed::integer(1, 1000000),
                   "Values from From to To, both included.");
        schema.add("Values",
                   a.values,
                   Allowed::list(Allowed::number()),
                   "Values of the scale 'list', ascending, the same for all "
                   "entries.",
                   "those of the entries");
        schema.add("Entry values",
                   a.entry_values,
                   Allowed::list(Allowed::number()),
                   "What the entries are at these values, where they follow "
                   "each a law of its own: all values of the first entry, then "
                   "all of the second; straight between them. Empty: the "
                   "values themselves.",
                   "those of the entries");
        schema.add("Distribution",
                   a.distribution,
                   "How the axis scatters between its ends, for Scatter "
                   "samples: in the logarithm on a logarithmic axis.");
        schema.add("Mean",
                   a.mean,
                   Allowed::number(),
                   "Of a normal distribution, with a Deviation: of the value, "
                   "or of its common logarithm on a logarithmic axis.",
                   "as the axis");
        schema.add("Deviation",
                   a.deviation,
                   Allowed::number(0., 1e30),
                   "Standard deviation of a normal distribution, in decades on "
                   "a logarithmic axis; 0: a sixth of the range, about its "
                   "middle.",
                   "as the axis");
        schema.add("Shown as",
                   a.shown_as,
                   "What tables and charts of a campaign of transients show: "
                   "the value, its common logarithm, or the value with a "
                   "prefix of its unit (mega: MPa for Pa).");
      }
    } // namespace



    void
    declare_sweep(Schema &schema, SweepParameters &s)
    {
      schema.enter_section("Sweep",
                           "Ranges of parameters of 'Analysis = sweep', a "
                           "certified basis for all of them.");
      schema.add("Frequency tolerance",
                 s.frequency_tolerance,
                 Allowed::positive(1e-2),
                 "Largest estimated error of every frequency by the basis, "
                 "relative.");
      schema.add("Sigma tolerance",
                 s.sigma_tolerance,
                 Allowed::positive(),
                 "Largest estimated error of every sigma by the basis.",
                 "1/s");
      schema.add("Maximum basis",
                 s.maximum_basis,
                 Allowed::integer(1, 100000),
                 "Vectors in the basis beyond which the run ends with an "
                 "error.");
      schema.add("Basis file",
                 s.basis_file,
                 Allowed::text(),
                 "HDF5 file that keeps the basis for later runs of the same "
                 "scene, in the output directory; empty: 'basis.h5'.");
      schema.add("Reuse basis",
                 s.reuse_basis,
                 "Use the basis of an earlier run if its scene, band, ranges "
                 "and tolerances are those of this run (doc/resume.md says "
                 "what may differ).");
      schema.add("Edge tolerance",
                 s.edge_tolerance,
                 Allowed::positive(0.1),
                 "Width to which edges of unstable ranges are bracketed.",
                 "decades on a logarithmic axis, else share of the range");
      schema.add("Exceptional points",
                 s.exceptional_points,
                 "Locate the complex parameters at which pairs coalesce, next "
                 "to every lock-in.");
      schema.add("Boundary tolerance",
                 s.boundary_tolerance,
                 Allowed::number(0., 0.5),
                 "Trace the boundary of the unstable regions of two axes to "
                 "this share of their ranges; 0: leave it out.");
      schema.add("Direct checks",
                 s.direct_checks,
                 Allowed::integer(0, 1000),
                 "Points at which the full problem is solved directly and "
                 "compared, a third of them beside lock-ins.");
      schema.add("Compare",
                 s.compare,
                 "Time direct solutions of a few points and solve the sweep on "
                 "frictionless modes alone, for comparison.");
      schema.add("Sensitivities",
                 s.sensitivities,
                 Allowed::list(Allowed::text()),
                 "Numbers of the scene whose influence on every unstable pair "
                 "is reported, with the contact as it is there; empty: none.");
      schema.add("Suggestions",
                 s.suggestions,
                 Allowed::integer(0, 1000),
                 "Unstable ranges, those of the largest sigma first, for which "
                 "the smallest change of one of the Sensitivities that leaves "
                 "no pair unstable is sought and checked by a direct "
                 "solution; 0: none, as it must be with 'Contact state = "
                 "preload'.");
      schema.add("Largest change",
                 s.largest_change,
                 Allowed::positive(0.99),
                 "Share by which a suggestion may raise or lower a number.");
      schema.add("Scatter samples",
                 s.scatter_samples,
                 Allowed::integer(0, 100000000),
                 "Random scenes of the box, as the axes scatter, of which the "
                 "share that squeals is counted; 0: none.");
      schema.add("Scatter seed",
                 s.scatter_seed,
                 Allowed::integer(0, 2000000000),
                 "Start of the random numbers.");
      declare_list(schema, family_named("Axes"));
      declare_members(schema, family_named("Axes"), s.axes, &declare_axis);
      schema.leave_section();
    }
  } // namespace prm
} // namespace squeal
