// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/schema.h>
#include <squeal/tribology/setup/damage_parameters.h>

namespace squeal::tribology
{
  using prm::Allowed;

  namespace
  {
    void
    declare_strength(prm::Schema &schema, FatigueParameters &f)
    {
      schema.add("Exponents",
                 f.exponents,
                 Allowed::list(Allowed::positive(100.), 1, 8),
                 "Slopes m of the S-N curves N = C (S_ref / S_a)^m, one map "
                 "each.");
      schema.add("Constants",
                 f.constants,
                 Allowed::list(Allowed::positive(), 0, 8),
                 "Cycles to failure C at an amplitude of 'Reference stress', "
                 "one for each exponent; empty: C = 1, and what comes out is "
                 "called an index.",
                 "cycles");
      schema.add("Reference stress",
                 f.reference_stress,
                 Allowed::positive(),
                 "Stress S_ref of the S-N curves.",
                 "Pa");
      schema.add("Model",
                 f.model,
                 "One straight S-N line, or two that meet at 'Knee stress'.");
      schema.add("Knee stress",
                 f.knee_stress,
                 Allowed::number(0.),
                 "Amplitude below which 'Second exponent' holds.",
                 "Pa");
      schema.add("Second exponent",
                 f.second_exponent,
                 Allowed::number(0., 1000.),
                 "Slope of the bilinear S-N curve below the knee.");
      schema.add("Endurance limit",
                 f.endurance_limit,
                 Allowed::number(0.),
                 "Amplitudes up to this do no damage.",
                 "Pa");
      schema.add("Mean stress",
                 f.mean_stress,
                 "Correction of the amplitude for the mean of the cycle, "
                 "tension positive; none for tractions, which are no normal "
                 "stress.");
      schema.add("Ultimate strength",
                 f.ultimate_strength,
                 Allowed::number(0.),
                 "Tensile strength, for Goodman and Gerber.",
                 "Pa");
      schema.add("Strength coefficient",
                 f.strength_coefficient,
                 Allowed::number(0.),
                 "Fatigue strength coefficient sigma_f', for Morrow.",
                 "Pa");
      schema.add("Walker exponent",
                 f.walker_exponent,
                 Allowed::number(0., 1.),
                 "Exponent gamma; 0.5 is Smith-Watson-Topper.");
    }
  } // namespace



  void
  declare_fatigue(prm::Schema &schema, FatigueParameters &f)
  {
    schema.enter_section("Fatigue", "Counting of cycles and their damage.");
    schema.add("Quantity", f.quantity, "What is counted at each contact node.");
    schema.add("Residue",
               f.residue,
               "What remains uncounted at the end (ASTM E1049): half cycles, "
               "or full cycles of a history that repeats. Its period is the "
               "time from the first to the last sample, and a mean interval "
               "more unless these two agree.");
    declare_strength(schema, f);
    schema.add("Accumulation",
               f.accumulation,
               "Linear sum of Palmgren and Miner, or the life of the "
               "repeating history by the damage curves of Manson and Halford, "
               "by which cycles of different height do more together than "
               "alone.");
    schema.add(
      "Averaging length",
      f.averaging_length,
      Allowed::number(0.),
      "Length over which stresses are averaged, with normal weights of "
      "deviation length/4; 0: none, "
      "and the result depends on the mesh at the pad's edges.",
      "m");
    schema.add("Application time",
               f.application_time,
               Allowed::positive(),
               "Seconds of squeal in one brake application.",
               "s");
    schema.add("Classes",
               f.n_classes,
               Allowed::integer(2, 512),
               "Classes of range and of mean in the matrices.");
    schema.add("Largest range",
               f.largest_range,
               Allowed::number(0.),
               "Upper end of the classes; larger ranges go to the last one; "
               "0: from the data, in a pass of its own.",
               "Pa");
    schema.add("Spectral",
               f.spectral,
               "Estimate the damage from the spectrum too (Dirlik, narrow "
               "band) and report the difference.");
    schema.add("Plateau factor",
               f.plateau_factor,
               Allowed::number(1., 1000.),
               "Pressure of a contact plateau over the pressure of its node; "
               "all stresses are multiplied by it.");
    schema.leave_section();
  }



  void
  declare_surface(prm::Schema &schema, SurfaceParameters &s)
  {
    schema.enter_section("Surface", "Friction, wear and impacts of the face.");
    schema.add("Wear coefficient",
               s.wear_coefficient,
               Allowed::number(0.),
               "Archard's k/H: wear depth over pressure and sliding distance; "
               "0: 1, and what comes out is called an index.",
               "1/Pa");
    schema.add("Contact pressure",
               s.contact_pressure,
               Allowed::number(0.),
               "A node with a higher pressure is in contact, where the history "
               "has no status.",
               "Pa");
    schema.add("Stick speed",
               s.stick_speed,
               Allowed::number(0.),
               "A node in contact that slips slower sticks, where the history "
               "has no status.",
               "m/s");
    schema.leave_section();
  }



  void
  declare_subsurface(prm::Schema &schema, SubsurfaceParameters &s)
  {
    schema.enter_section("Subsurface",
                         "Stress below the face by half-space kernels, in a "
                         "block with finite elements, and multiaxial "
                         "criteria.");
    schema.add("Compute", s.compute, "Whether it is computed.");
    schema.add("Depths",
               s.depths,
               Allowed::list(Allowed::positive(1.), 1, 100),
               "Depths under the face.",
               "m");
    schema.add("Criteria",
               s.criteria,
               Allowed::list(prm::Schema::allowed_choices(
                 SubsurfaceParameters::Criterion::dang_van)),
               "Multiaxial criteria that are evaluated.");
    schema.add("Samples",
               s.n_samples,
               Allowed::integer(8, 100000),
               "Last samples of the history that the criteria look at: some "
               "periods of the limit cycle.",
               "samples");
    schema.add("Young modulus",
               s.youngs_modulus,
               Allowed::positive(),
               "Of the pad, for strains. Values over their limits, which is "
               "what tables hold, do not depend on it.",
               "Pa");
    schema.add("Poisson ratio",
               s.poisson_ratio,
               Allowed::number(0., 0.4999),
               "Of the pad.");
    schema.add("Pad thickness",
               s.pad_thickness,
               Allowed::number(0., 1.),
               "Of a rectangular pad that is held at its back: adds what a "
               "half-space lacks, by finite elements; 0: half-space only, and "
               "points near the edges are flagged.",
               "m");
    schema.add("Finest cell",
               s.finest_cell,
               Allowed::positive(1.),
               "Of the finite elements, at the rim of the face: points nearer "
               "to it than two cells are flagged.",
               "m");
    schema.add("Axial limit",
               s.axial_limit,
               Allowed::number(0.),
               "Fatigue limit in fully reversed tension; 0: "
               "'Fatigue/Reference stress', and what comes out is called an "
               "index.",
               "Pa");
    schema.add("Torsion ratio",
               s.torsion_ratio,
               Allowed::number(0.5, 0.8660254),
               "Fatigue limit in fully reversed torsion over the axial one.");
    schema.add("Repeated limit",
               s.repeated_limit,
               Allowed::number(0.),
               "Fatigue limit (amplitude) in repeated bending, for Sines; 0: "
               "5/6 of the axial limit.",
               "Pa");
    schema.add("Yield stress",
               s.yield_stress,
               Allowed::number(0.),
               "For Fatemi-Socie; 0: the axial limit.",
               "Pa");
    schema.add("Fatemi Socie factor",
               s.fatemi_socie_k,
               Allowed::number(0., 10.),
               "Factor k of the largest normal stress s_n,max in Fatemi-Socie, "
               "(dgamma/2) (1 + k max(s_n,max, 0)/s_y): a plane that is always "
               "pressed counts its shear strain alone.");
    schema.add("Tensile strength",
               s.tensile_strength,
               Allowed::number(0.),
               "For Rankine and Drucker-Prager; 0: the axial limit.",
               "Pa");
    schema.add("Compressive strength",
               s.compressive_strength,
               Allowed::number(0.),
               "For Drucker-Prager; 0: ten times the tensile one.",
               "Pa");
    schema.add("Plane step",
               s.plane_step,
               Allowed::number(0.5, 30.),
               "Angle between the planes that are searched before the best one "
               "is refined.",
               "degrees");
    schema.leave_section();
  }
} // namespace squeal::tribology
