// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      void
      declare_discretization(Schema &schema, DiscretizationParameters &d)
      {
        schema.enter_section("Discretization",
                             "Finite element space and mesh refinement.");
        schema
          .add("Degree",
               d.degree,
               Allowed::integer(1, 8),
               "Polynomial degree of the hexahedral elements and of their "
               "curved geometry.")
          .resolution();
        schema.add("Mass",
                   d.mass,
                   "Mass of the elements: integrated as the stiffness is, or "
                   "lumped into a diagonal by collocation at the Gauss-Lobatto "
                   "nodes, as the explicit integrator needs it.");
        schema.add("Refinement",
                   d.refinement,
                   "How the coarse mesh is refined: not at all, 'Refinements' "
                   "times everywhere, or adaptively where the modes of the "
                   "band need it, or where the growth rates of the complex "
                   "pairs do (contact error, of 'Analysis = cea').");
        schema
          .add("Refinements",
               d.refinements,
               Allowed::integer(0, 10),
               "Uniform refinements; each divides a cell into eight. With "
               "'Refinement = eigenvalue error' they come first.")
          .resolution();
        schema.add("Tolerance",
                   d.tolerance,
                   Allowed::positive(1.),
                   "Adaptive refinement stops when the estimated relative "
                   "error of every frequency in the band is below.");
        schema.add("Growth rate tolerance",
                   d.growth_rate_tolerance,
                   Allowed::positive(),
                   "'Refinement = contact error' stops when the estimated "
                   "error by the mesh of the growth rate of the loudest pair "
                   "is below, and that of every frequency below 'Tolerance'.",
                   "1/s");
        schema.add("Maximum cycles",
                   d.maximum_cycles,
                   Allowed::integer(1, 100),
                   "Adaptive cycles after which refinement stops in any case.");
        schema.add("Maximum dofs",
                   d.maximum_dofs,
                   Allowed::integer(1),
                   "Number of unknowns beyond which no adaptive cycle "
                   "starts.");
        schema.add("Estimate error",
                   d.estimate_error,
                   "Estimate the discretisation error of every mode; costs a "
                   "solution of one degree less where no adaptive cycle gives "
                   "it.");
        schema.leave_section();
      }



      void
      declare_eigenvalues(Schema &schema, EigenParameters &e)
      {
        schema.enter_section("Eigenvalues",
                             "Frequency band and eigenvalue solvers.");
        schema.add("Lowest frequency",
                   e.lowest_frequency,
                   Allowed::number(0.),
                   "Lower edge of the band.",
                   "Hz");
        schema.add("Highest frequency",
                   e.highest_frequency,
                   Allowed::positive(),
                   "Upper edge of the band.",
                   "Hz");
        schema.add("Mode tolerance",
                   e.mode_tolerance,
                   Allowed::positive(1e-2),
                   "Relative error of 1/(omega^2 - shift) of the undamped "
                   "modes, as the Krylov space bounds it.");
        schema.add("Solver",
                   e.solver,
                   "Complex eigenvalues from a reduced basis that is enriched "
                   "until every pair is certified, or from a direct "
                   "shift-invert solution of the full problem.");
        schema.add("Linear solver",
                   e.linear_solver,
                   "Where the factors of the matrices are kept: 'direct' in "
                   "memory, 'out of core' on disk, in the output directory as "
                   "long as they are needed, with the products of the reduced "
                   "basis computed whenever they are needed; 'automatic' takes "
                   "the disk only where the memory does not suffice.");
        schema.add("Residual tolerance",
                   e.residual_tolerance,
                   Allowed::positive(1.),
                   "Largest relative residual of a certified pair.");
        schema.add("Error tolerance",
                   e.error_tolerance,
                   Allowed::positive(1.),
                   "Largest estimated error of a certified eigenvalue, "
                   "relative to its modulus.");
        schema.add("Maximum enrichments",
                   e.maximum_enrichments,
                   Allowed::integer(0, 1000),
                   "Enrichment rounds of the reduced basis after which the "
                   "run ends with an error.");
        schema.add("Direct shift frequency",
                   e.direct_shift_frequency,
                   Allowed::number(),
                   "Frequency the direct solver searches around; negative: "
                   "the centre of the band.",
                   "Hz");
        schema.add("Number of pairs",
                   e.number_of_pairs,
                   Allowed::integer(0, 10000),
                   "Eigenvalues the direct solver looks for; 0: all of the "
                   "band.");
        schema.add("Damping threshold",
                   e.damping_threshold_percent,
                   Allowed::number(0., 100.),
                   "Line in the damping chart below which a mode counts as "
                   "weakly damped.",
                   "percent of critical damping");
        schema.add("Compare with direct",
                   e.compare_direct,
                   "Run the direct solver as well and report the largest "
                   "difference.");
        schema.leave_section();
      }



      void
      declare_angles(Schema &schema, AnglesParameters &a)
      {
        schema.enter_section("Angles",
                             "Angles of the rotor at which 'Analysis = angles' "
                             "repeats the complex eigenvalue analysis.");
        schema.add("Turning bodies",
                   a.bodies,
                   Allowed::list(Allowed::text()),
                   "Bodies that turn together, each about its 'Rotation axis', "
                   "from its own 'Angle' on: one and all that ties glue to it. "
                   "Rigid bodies are turned as meshed ones are, layers with "
                   "what they lie on. The axes of orthotropic materials and "
                   "springs between two of the bodies turn with them; other "
                   "springs, supports and loads stay where they are.");
        schema.add("From",
                   a.from,
                   Allowed::number(),
                   "First angle, added to the 'Angle' of each body.",
                   "deg");
        schema.add("To",
                   a.to,
                   Allowed::number(),
                   "End of the range, one pitch of the vanes or bolts behind "
                   "'From'; it repeats the first angle and is left out.",
                   "deg");
        schema.add("Number",
                   a.number,
                   Allowed::integer(1, 10000),
                   "Equally spaced angles.");
        schema.leave_section();
      }



      void
      declare_operating_matrix(Schema &schema, OperatingMatrixParameters &m)
      {
        const Allowed list = Allowed::list(Allowed::positive(), 0, 100);
        schema.enter_section("Operating matrix",
                             "Conditions at which 'Analysis = operating "
                             "matrix' asks which pairs squeal: all "
                             "combinations.");
        schema.add("Pressures",
                   m.pressures,
                   list,
                   "Pressures of all loads that have one; empty: that of each "
                   "load.",
                   "Pa");
        schema.add("Temperatures",
                   m.temperatures,
                   Allowed::list(Allowed::number(-273.15, 5000.), 0, 100),
                   "Temperatures of all bodies with a 'Modulus table file'; "
                   "empty: that of each body.",
                   "degrees Celsius");
        schema.add("Speeds",
                   m.speeds,
                   list,
                   "Sliding speeds of all contacts; empty: that of each "
                   "contact.",
                   "m/s");
        schema.add("Both directions",
                   m.both_directions,
                   "Let the targets turn backwards, too: the signs of all "
                   "'Friction coefficient' and 'Rotation speed' are reversed.");
        schema.leave_section();
      }



      void
      declare_work_precision(Schema &schema, WorkPrecisionParameters &w)
      {
        schema.enter_section("Work precision",
                             "Ladder of settings of 'Analysis = work "
                             "precision'.");
        schema.add("Problem",
                   w.problem,
                   "What is solved on every rung: the eigenvalues of the "
                   "band (undamped or complex: 'Quantity'), steady sliding "
                   "under the full load as 'Analysis = "
                   "preload', or one run of 'Analysis = transient'.");
        schema.add(
          "Ladders",
          w.ladders,
          Allowed::list(
            Schema::allowed_choices(WorkPrecisionParameters::Ladder::degree)),
          "Settings that are varied, one after the other: element "
          "degree, uniform refinements, factor on the numbers of "
          "cells of all bodies (a direction with one cell keeps it), "
          "tolerance of the adaptive refinement and residual tolerance "
          "of the reduced basis (both of eigenvalues), cut-off of the "
          "modes and time step (both of a transient).");
        schema.add("Values",
                   w.values,
                   Allowed::list(Allowed::number(0.)),
                   "Rungs of the ladders: degrees, refinements, factors or "
                   "tolerances.");
        schema.add("Adaptive values",
                   w.adaptive_values,
                   Allowed::list(Allowed::number(0.)),
                   "Tolerances of the ladder 'adaptive', beside ladders with "
                   "other rungs; empty: 'Values'.");
        schema.add("Cut-offs",
                   w.cut_offs,
                   Allowed::list(Allowed::positive()),
                   "Rungs of the ladder 'cut-off', for 'Transient/Cut-off'.",
                   "Hz");
        schema.add("Time steps",
                   w.time_steps,
                   Allowed::list(Allowed::positive()),
                   "Rungs of the ladder 'time step', for 'Transient/Time step' "
                   "or, where that is set, 'Transient/Explicit time step'.",
                   "s");
        schema.add("Refinement degree",
                   w.refinement_degree,
                   Allowed::integer(0, 8),
                   "Element degree of the ladder 'refinement'; 0: "
                   "'Discretization/Degree'.");
        schema.add("Quantity",
                   w.quantity,
                   Allowed::one_of({"frequency", "sigma", "eigenvalue"}),
                   "What is compared with the reference, of eigenvalues: the "
                   "frequencies, each "
                   "relative to its own; the real parts of the eigenvalues, "
                   "relative to the largest one in size; or the eigenvalues, "
                   "each relative to its own. Frequencies are those of the "
                   "undamped modes without friction, as 'Analysis = modes' "
                   "has them; with 'basis' among the ladders they are those of "
                   "the complex pairs, as 'Analysis = cea' has them, on every "
                   "rung. Real parts and eigenvalues are always those of "
                   "complex pairs.");
        schema.add("Reference",
                   w.reference,
                   Allowed::list(Allowed::number()),
                   "Exact frequencies or real parts of the band, of the modes "
                   "or pairs that 'Quantity' names; "
                   "empty: the finest rung, the one with most unknowns, is the "
                   "reference, and rungs of other ladders than 'basis' on its "
                   "mesh are left out of cost_at_error.csv. Of other problems "
                   "each ladder has its own "
                   "finest rung as reference.",
                   "Hz or 1/s");
        schema.leave_section();
      }



      void
      declare_output(Schema &schema, OutputParameters &o)
      {
        schema.enter_section("Output", "What is written.");
        schema.add("Shapes",
                   o.shapes,
                   "Mode shapes written for ParaView: none, those of unstable "
                   "modes, or all.");
        schema.add("Animation frames",
                   o.animation_frames,
                   Allowed::integer(0, 360),
                   "Frames over one period of each mode; 0: real and "
                   "imaginary part only.");
        schema.add("Plots", o.plots, "Write diagrams as PNG files.");
        schema.add("Report", o.report, "Write report.html.");
        schema.add("Export matrices",
                   o.export_matrices,
                   "Write M, C and K, the parts they are sums of and the "
                   "complex eigenvalues and vectors as MatrixMarket files to "
                   "the folder matrices; 'Analysis = work precision' writes no "
                   "parts, and a folder for each rung. For 'modes', 'cea', "
                   "'preload', 'work precision' and a single 'transient'.");
        schema.add("Display scale",
                   o.slip_display_scale,
                   Allowed::positive(1.),
                   "Largest drawn displacement relative to the size of the "
                   "scene.");
        schema.leave_section();
      }



      void
      declare_check(Schema &schema, ResultCheckParameters &c)
      {
        schema.add("Table",
                   c.table,
                   Allowed::text(),
                   "Result table, for example 'modes.csv'.");
        schema.add("Where",
                   c.where,
                   Allowed::text(),
                   "Rows of the table, as 'column = value', also with !=, <, "
                   "<=, >, >= and several joined by ' and '; empty: all "
                   "rows.");
        schema.add("Nearest",
                   c.nearest,
                   Allowed::text(),
                   "Of those the row whose value is nearest, as 'column = "
                   "number'; empty: every row is compared.");
        schema.add("Column",
                   c.column,
                   Allowed::text(),
                   "Column that is compared; 'count' is the number of rows.");
        schema.add("Expected",
                   c.expected,
                   Allowed::number(),
                   "Expected value.",
                   "those of the column");
        schema.add("Relative tolerance",
                   c.relative_tolerance,
                   Allowed::number(0.),
                   "Difference that is accepted, relative to the expected "
                   "value.");
        schema.add("Absolute tolerance",
                   c.absolute_tolerance,
                   Allowed::number(0.),
                   "Difference that is accepted; of the two tolerances the "
                   "larger counts.",
                   "those of the column");
      }
    } // namespace



    void
    declare_result_checks(Schema                             &schema,
                          std::vector<ResultCheckParameters> &checks)
    {
      schema.enter_section("Result checks",
                           "Expected values; a run whose results miss one "
                           "ends with exit code 4.");
      declare_list(schema, family_named("Checks"));
      declare_members(schema, family_named("Checks"), checks, &declare_check);
      schema.leave_section();
    }



    void
    declare_analysis(Schema &schema, Parameters &parameters)
    {
      declare_discretization(schema, parameters.discretization);
      declare_eigenvalues(schema, parameters.eigen);
      declare_sweep(schema, parameters.sweep);
      declare_preload(schema, parameters.preload);
      declare_transient(schema, parameters.transient);
      declare_limit_cycle(schema, parameters.limit_cycle);
      declare_triggers(schema, parameters.triggers);
      declare_work_precision(schema, parameters.work_precision);
      declare_angles(schema, parameters.angles);
      declare_operating_matrix(schema, parameters.operating_matrix);
      declare_response(schema, parameters);
      declare_output(schema, parameters.output);

      declare_result_checks(schema, parameters.result_checks);
    }



    void
    declare_parameters(Schema &schema, Parameters &parameters)
    {
      schema.add(
        "Analysis",
        parameters.analysis,
        "What is computed: undamped modes, complex eigenvalues with "
        "friction, the same over ranges of parameters, steady "
        "sliding under the loads, motion in time, periodic motions, error "
        "against time "
        "over a ladder of settings, frequency responses, or numbers of "
        "the scene fitted to measured frequencies.");
      schema.add("Output directory",
                 parameters.output.directory,
                 Allowed::text(),
                 "Folder of all results, relative to the working directory.");
      schema.add("Overwrite",
                 parameters.output.overwrite,
                 "Replace the results of an earlier run in that folder.");
      declare_scene(schema, parameters.scene);
      declare_analysis(schema, parameters);
    }
  } // namespace prm
} // namespace squeal
