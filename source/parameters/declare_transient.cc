// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      void
      declare_triggers(Schema &schema, TransientParameters &t)
      {
        schema.add("Friction impulse",
                   t.friction_impulse,
                   Allowed::number(-5., 5.),
                   "What is added to the friction coefficient of every pair "
                   "that slides for a while, as a half sine: a trigger. It is "
                   "added to the size of a coefficient, whatever its sign, and "
                   "must not take one below 0.");
        schema.add("Friction impulse time",
                   t.friction_impulse_time,
                   Allowed::number(0.),
                   "When it starts.",
                   "s");
        schema.add("Friction impulse duration",
                   t.friction_impulse_duration,
                   Allowed::positive(),
                   "How long it lasts.",
                   "s");
        schema.enter_section("Hammer",
                             "A short force on a face, as a half sine: a "
                             "trigger.");
        schema.add("Body",
                   t.hammer.body,
                   Allowed::text(),
                   "Body that is struck; empty: none.");
        schema.add("Face", t.hammer.face, Allowed::text(), "Its face.");
        schema.add("Force",
                   t.hammer.force,
                   Allowed::vector(),
                   "Largest force, spread evenly over the face.",
                   "N");
        schema.add(
          "Time", t.hammer.time, Allowed::number(0.), "When it starts.", "s");
        schema.add("Duration",
                   t.hammer.duration,
                   Allowed::positive(),
                   "How long it lasts.",
                   "s");
        schema.leave_section();
      }



      void
      declare_integrator(Schema &schema, TransientParameters &t)
      {
        schema.add("Integrator",
                   t.integrator,
                   "Of the modes of the bodies with a contact without mass "
                   "(reduced), or of all unknowns of the finite elements: "
                   "trapezoidal rule with contact velocities (implicit), "
                   "beta-2 scheme with forward multipliers (explicit, needs "
                   "'Discretization/Mass = lumped').");
        schema
          .add("Cut-off",
               t.cut_off,
               Allowed::positive(),
               "Modes of the bodies up to this frequency move in the "
               "reduced integrator; those above follow without inertia.",
               "Hz")
          .resolution();
        schema.add(
          "Cut-off damping",
          t.cut_off_damping,
          Allowed::number(0., 1.),
          "Damping ratio at 'Cut-off' of the reduced integrator and "
          "above it, which falls as the eighth power of the frequency "
          "below it: takes the ringing of impacts at 1.2 times the cut-off "
          "away (0.2 does). The log says how far it shifts the "
          "growing pairs of the band.");
        schema
          .add("Interface cut-off",
               t.interface_cut_off,
               Allowed::number(0.),
               "The motions above 'Cut-off' that the contact excites "
               "itself (Ritz vectors of its flexibility) move with mass "
               "and damping up to this frequency; 0: none of them.",
               "Hz")
          .resolution();
        schema.add("Beta 2",
                   t.beta_2,
                   Allowed::number(0.5, 1.),
                   "Of the explicit integrator; 0.5 is central differences, "
                   "more damps high frequencies.");
        schema.add("Explicit time step",
                   t.explicit_step,
                   Allowed::number(0.),
                   "Time step of the explicit integrator where a campaign "
                   "runs others as well; 0: 'Time step'. A step above the "
                   "critical one is refused.",
                   "s");
        schema.add("Disc frame",
                   t.disc_frame,
                   "The target's mesh stands still and its surface moves, the "
                   "contact's matrices being those of the start (eulerian: for "
                   "an axisymmetric disc), or it turns with the disc, the "
                   "contact being integrated anew in every step (corotating: "
                   "for a disc with features; implicit and explicit "
                   "integrators).");
        schema.add("Contact method",
                   t.contact_method,
                   "How the contact of a step is solved: Newton iterations, or "
                   "projected Gauss-Seidel sweeps alone.");
      }



      void
      declare_campaign(Schema &schema, TransientParameters &t)
      {
        schema.add(
          "Tops",
          t.tops,
          Allowed::list(Allowed::one_of({"free", "guided", "held"}), 0, 3),
          "Kinds of the support 'Top support' that are gone through, "
          "beside the axes of 'Sweep'; empty: that of the scene.");
        schema.add(
          "Integrators",
          t.integrators,
          Allowed::list(
            Allowed::one_of({"reduced", "implicit", "explicit"}), 0, 3),
          "Integrators that a campaign goes through; empty: "
          "'Integrator'.");
        schema.add("Top support",
                   t.top_support,
                   Allowed::text(),
                   "Support that 'Tops' is about.");
        schema.add("Compare with CEA",
                   t.compare_with_cea,
                   "Solve the eigenvalue problem of the whole model about the "
                   "same steady sliding and set its growth rates and "
                   "frequencies beside those of the motion.");
        schema.add("Campaign table",
                   t.campaign_table,
                   Allowed::text(),
                   "Name of the table with one row for each point of the axes "
                   "of 'Sweep' and each top, in the output directory.");
        schema.add("Threads",
                   t.threads,
                   Allowed::integer(1, 256),
                   "Runs of a campaign at a time.");
      }
    } // namespace



    void
    declare_preload(Schema &schema, PreloadParameters &p)
    {
      schema.enter_section("Preload",
                           "Steady sliding under the loads, of 'Analysis = "
                           "preload'.");
      schema.add("Load steps",
                 p.load_steps,
                 Allowed::integer(1, 10000),
                 "Equal shares of the load at which the contact is solved: "
                 "the contact stiffness over the load; at 'Sliding speed = 0' "
                 "the way on which nodes stick or slip.");
      schema.add("Tolerance",
                 p.tolerance,
                 Allowed::positive(1e-2),
                 "Largest violation of the contact law, relative to the mean "
                 "force of a contact node.");
      schema.add("Run-in",
                 p.run_in,
                 "Flat faces, or faces worn by Archard's law until the wear no "
                 "longer changes the pressure: what steady sliding leaves "
                 "open then closes.");
      schema.add("Stiffness entry",
                 p.stiffness_entry,
                 Allowed::text(),
                 "A number of the scene, such as 'Scene/Body pad/Young "
                 "modulus', over which the contact stiffness is computed; "
                 "empty: none.");
      schema.add("Stiffness values",
                 p.stiffness_values,
                 Allowed::list(Allowed::number()),
                 "Its values.",
                 "those of the entry");
      schema.leave_section();
    }



    void
    declare_transient(Schema &schema, TransientParameters &t)
    {
      schema.enter_section("Transient",
                           "Motion in time, of 'Analysis = transient'. With "
                           "axes in 'Sweep' one run for each of their points.");
      schema.add("Start",
                 t.start,
                 "Steady sliding under the full loads with a small "
                 "disturbance, or rest, the loads growing by their 'Ramp "
                 "time'.");
      declare_integrator(schema, t);
      schema.add("Disturbance",
                 t.disturbance,
                 Allowed::number(0.),
                 "Kinetic energy at the start, of an impulse spread at random "
                 "over points of all bodies.",
                 "J");
      schema
        .add("Time step",
             t.time_step,
             Allowed::positive(),
             "Time step. Where friction falls with the slip rate, with "
             "'Integrator = reduced', it has to be longer than the flexibility "
             "of a contact node times its normal force times that fall; a "
             "warning names the shortest.",
             "s")
        .resolution();
      schema.add(
        "End time", t.end_time, Allowed::positive(), "Simulated time.", "s");
      schema
        .add("Tolerance",
             t.tolerance,
             Allowed::positive(1e-2),
             "Largest violation of the contact law in a step, relative to "
             "the mean force of a contact node.")
        .resolution();
      schema.add("Sample interval",
                 t.sample_interval,
                 Allowed::positive(),
                 "Time between two samples of the results, rounded to whole "
                 "steps. Means, rms values and extremes are those of every "
                 "step; frequencies and phases are found in the samples, which "
                 "see nothing above half their rate.",
                 "s");
      schema.add("History start",
                 t.history_start,
                 Allowed::number(0.),
                 "Time from which the fields of the contact nodes and their "
                 "changes of status are kept in contact_history.h5.",
                 "s");
      schema.add("Animation frames",
                 t.animation_frames,
                 Allowed::integer(0, 10000),
                 "The last samples whose motion of the bodies and contact "
                 "fields are written for ParaView, as motion.pvd and "
                 "contact.pvd; 0: none.");
      schema.add("Final speed ratio",
                 t.final_speed_ratio,
                 Allowed::number(),
                 "Sliding speed at the end over that at the start; linear in "
                 "time, negative values reverse it.");
      schema.add("Checkpoint file",
                 t.checkpoint_file,
                 Allowed::text(),
                 "HDF5 file that a stopped run continues from, in the output "
                 "directory; empty: 'checkpoint.h5'. The one before it is kept "
                 "as well, with '_before' at the end of its name.");
      schema.add("Checkpoint interval",
                 t.checkpoint_interval,
                 Allowed::number(0.),
                 "Time between two checkpoints; 0: only when the run is "
                 "stopped by a signal.",
                 "s of wall time");
      schema.add("Resume",
                 t.resume,
                 "Continue from the checkpoint file if it belongs to the same "
                 "run (doc/resume.md says what may differ); a campaign leaves "
                 "out the runs it has finished.");
      declare_campaign(schema, t);
      declare_triggers(schema, t);
      schema.leave_section();
    }
  } // namespace prm
} // namespace squeal
