// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      void
      declare_point(Schema &schema, MeasuredPointParameters &p)
      {
        schema.add("Body", p.body, Allowed::text(), "Body that it is on.");
        schema.add(
          "Position", p.position, Allowed::vector(), "Where it is.", "m");
        schema.add("Direction",
                   p.direction,
                   Allowed::direction(),
                   "Direction of the force or of the motion that is observed; "
                   "its length does not matter.");
        schema.add("Node",
                   p.node,
                   Allowed::integer(0),
                   "Number of the node in UFF files; 0: place in the list of "
                   "points, from 1.");
      }



      void
      declare_measurement(Schema &schema, MeasurementParameters &m)
      {
        schema.enter_section("Measurement",
                             "Points of 'Analysis = frequency response' and "
                             "what was measured on the real brake.");
        schema.add("Shapes file",
                   m.shapes_file,
                   Allowed::file(),
                   "Measured shapes that are compared by MAC: a UFF file with "
                   "datasets 55, or a CSV file with the columns shape, "
                   "frequency_hz, point, real and imag; empty: none.");
        schema.add("Frequencies file",
                   m.frequencies_file,
                   Allowed::file(),
                   "CSV file with the columns name, frequency_hz and weight "
                   "that 'Analysis = updating' fits.");
        declare_list(schema, family_named("Points"));
        declare_members(
          schema, family_named("Points"), m.points, &declare_point);
        schema.leave_section();
      }



      void
      declare_frequency_response(Schema &schema, FrequencyResponseParameters &f)
      {
        schema.enter_section("Frequency response",
                             "Responses of 'Analysis = frequency response' "
                             "over the band of section Eigenvalues. Wherever "
                             "that begins, the scene must be held: modes from "
                             "0 Hz on are superposed, and a free motion has no "
                             "bounded response there.");
        schema.add("Quantity",
                   f.quantity,
                   "Displacement, velocity or acceleration over force.");
        schema.add("Excitations",
                   f.excitations,
                   Allowed::list(Allowed::text()),
                   "Points of section Measurement where a force acts; empty: "
                   "all.");
        schema.add("Responses",
                   f.responses,
                   Allowed::list(Allowed::text()),
                   "Points of section Measurement that are observed; empty: "
                   "all.");
        schema.add("Contact states",
                   f.states,
                   Allowed::list(Allowed::one_of({"full", "stick"})),
                   "Contact states of all pairs, one after the other; empty: "
                   "those of the scene.");
        schema.add("Number",
                   f.number,
                   Allowed::integer(2, 1000000),
                   "Frequencies from the lower to the upper edge of the band.");
        schema.add("Scale",
                   f.scale,
                   "Equal steps or equal ratios between the frequencies.");
        schema.add("Margin",
                   f.margin,
                   Allowed::number(1., 10.),
                   "All modes up to this factor times the upper edge of the "
                   "band are superposed.");
        schema.add("Residual",
                   f.residual,
                   "What is added for the modes above: nothing, their "
                   "flexibility (exact at 0 Hz), or that and their inertia "
                   "(exact also at the upper edge of the band).");
        schema.add("Checks",
                   f.checks,
                   Allowed::integer(0, 1000),
                   "Frequencies inside the band at which the full problem is "
                   "solved directly and compared.");
        schema.add("Check tolerance",
                   f.check_tolerance,
                   Allowed::positive(1.),
                   "Largest error there, relative to the largest response at "
                   "that frequency and to the size of each response itself, "
                   "beyond which the run warns.");
        schema.leave_section();
      }



      void
      declare_number(Schema &schema, UpdatedNumberParameters &n)
      {
        schema.add("Entries",
                   n.entries,
                   Allowed::list(Allowed::text()),
                   "Numbers of the scene, such as 'Scene/Body pad/Young "
                   "modulus'; all are multiplied by the same factor.");
        schema.add("Lower",
                   n.lower,
                   Allowed::number(0.),
                   "Smallest value of the first entry, above 0.",
                   "those of the entry");
        schema.add("Upper",
                   n.upper,
                   Allowed::number(0.),
                   "Largest value of the first entry.",
                   "those of the entry");
      }



      void
      declare_updating(Schema &schema, UpdatingParameters &u)
      {
        schema.enter_section("Updating",
                             "Numbers of the scene that 'Analysis = updating' "
                             "fits to measured frequencies.");
        schema.add("Pairing",
                   u.pairing,
                   "How modes are paired with measured ones at the start: by "
                   "their names (where a name is empty, by the nearest "
                   "frequency), or by MAC with the measured shapes. After that "
                   "they are followed by their shapes.");
        schema.add("Minimum MAC",
                   u.minimum_mac,
                   Allowed::number(0., 1.),
                   "MAC, with the measured shape and with the mode it was "
                   "followed from, below which a pair counts as doubtful and "
                   "is warned of.");
        schema.add("Tolerance",
                   u.tolerance,
                   Allowed::positive(0.1),
                   "Relative change of all numbers below which the fit ends.");
        schema.add("Maximum evaluations",
                   u.maximum_evaluations,
                   Allowed::integer(1, 10000),
                   "Complex eigenvalue analyses after which it ends in any "
                   "case.");
        schema.add("Confidence",
                   u.confidence_percent,
                   Allowed::number(50., 99.99),
                   "Probability of the confidence intervals.",
                   "percent");
        declare_list(schema, family_named("Numbers"));
        declare_members(
          schema, family_named("Numbers"), u.numbers, &declare_number);
        schema.leave_section();
      }
    } // namespace



    void
    declare_response(Schema &schema, Parameters &parameters)
    {
      declare_measurement(schema, parameters.measurement);
      declare_frequency_response(schema, parameters.frequency_response);
      declare_updating(schema, parameters.updating);
    }
  } // namespace prm
} // namespace squeal
