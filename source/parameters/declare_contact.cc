// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      void
      declare_faces(Schema &schema, ContactParameters &c)
      {
        schema.add("Source body",
                   c.source_body,
                   Allowed::text(),
                   "Body on the pad's side; contact points or multipliers "
                   "are on its face.");
        schema.add("Source face",
                   c.source_face,
                   Allowed::text(),
                   "Its face; empty for a rigid body.");
        schema.add("Contact point",
                   c.contact_point,
                   Allowed::vector(),
                   "Where a rigid source body touches, from its centre of "
                   "gravity; 0, 0, 0 for a meshed one.",
                   "m");
        schema.add("Target body",
                   c.target_body,
                   Allowed::text(),
                   "Body on the disc's side, or 'ground' under a rigid "
                   "source body.");
        schema.add("Target face",
                   c.target_face,
                   Allowed::text(),
                   "Its face; empty for a rigid body or the ground.");
      }



      void
      declare_normal_contact(Schema &schema, ContactParameters &c)
      {
        schema.add("Formulation",
                   c.formulation,
                   "Springs between the faces, no penetration in the dual "
                   "mortar sense, or of the source face's nodes.");
        schema.add("Spring layout",
                   c.layout,
                   "Where the springs are: a grid over the source face or "
                   "the quadrature points of its cells.");
        schema.add("Grid",
                   c.grid,
                   Allowed::list(Allowed::integer(1, 1000), 2, 2),
                   "Point pairs along the two edges of the source face, edges "
                   "included.");
        schema
          .add("Normal stiffness",
               c.normal_stiffness,
               Allowed::positive(),
               "Normal stiffness of each point pair of a grid.",
               "N/m")
          .affine();
        schema
          .add("Tangential stiffness",
               c.tangential_stiffness,
               Allowed::number(),
               "Tangential stiffness of what sticks: of each point pair with "
               "'Spring layout = grid', per area of the face with "
               "'quadrature', as the normal stiffness of that layout; "
               "negative: equal to it.",
               "N/m")
          .affine()
          .per_area("N/m^3");
        schema
          .add("Normal stiffness per area",
               c.normal_stiffness_per_area,
               Allowed::positive(),
               "Normal stiffness of the layout 'quadrature'.",
               "N/m^3")
          .affine();
        schema.add("Contact state",
                   c.state,
                   "The whole face slips (full) or sticks (stick); 'preload': "
                   "the open, sticking and slipping parts of the steady "
                   "sliding; in a sweep those of every point of the grid. "
                   "Where 'Sliding speed = 0' nothing slides: with 'full' the "
                   "face sticks if it has friction at rest, and without it is "
                   "free along itself.");
      }



      void
      declare_friction_law(Schema &schema, ContactParameters &c)
      {
        schema.add("Friction law",
                   c.friction_law,
                   "How the coefficient depends on the slip rate; linearised "
                   "analyses take its value and slope at the sliding "
                   "speed, those of a constant one the 'Friction slope'. Where "
                   "it falls, 'Transient/Time step' must not be too short.");
        schema.add("Static friction coefficient",
                   c.static_friction_coefficient,
                   Allowed::number(0., 5.),
                   "Exponential law: the coefficient at rest, from which it "
                   "falls to the 'Friction coefficient'.");
        schema.add("Decay speed",
                   c.decay_speed,
                   Allowed::number(0.),
                   "Exponential law: slip rate at which the difference has "
                   "fallen to 1/e; 0: the static coefficient holds what "
                   "sticks, the other one all that slips.",
                   "m/s");
        schema.add("Friction speeds",
                   c.friction_speeds,
                   Allowed::list(Allowed::number(0.)),
                   "Law by a table: slip rates, ascending from 0.",
                   "m/s");
        schema.add("Friction coefficients",
                   c.friction_coefficients,
                   Allowed::list(Allowed::number(0., 5.)),
                   "Law by a table: the coefficient at each of them, the last "
                   "one beyond.");
      }
    } // namespace



    void
    declare_contact(Schema &schema, ContactParameters &c)
    {
      declare_faces(schema, c);
      declare_normal_contact(schema, c);
      schema
        .add("Friction coefficient",
             c.friction_coefficient,
             Allowed::number(-5., 5.),
             "Coefficient of friction; negative: the target turns "
             "backwards.")
        .friction()
        .affine();
      declare_friction_law(schema, c);
      schema.add("Friction direction",
                 c.friction_direction,
                 "Friction along +y everywhere, along the local velocity of "
                 "the target's surface that turns about its 'Rotation axis', "
                 "or along a given 'Sliding direction'.");
      schema.add("Sliding direction",
                 c.sliding_direction,
                 Allowed::vector(),
                 "Direction, of any length, in which the target slides along "
                 "the source everywhere; with 'Friction direction = given' "
                 "only.");
      schema.add("Transverse slip term",
                 c.transverse_slip_term,
                 "Add the friction force that turns with the slip direction: "
                 "mu p0/|V| times the slip rate across the sliding "
                 "direction.");
      schema
        .add("Sliding speed",
             c.sliding_speed,
             Allowed::number(0.),
             "Speed |V| of the target's surface, in the mean over the "
             "contact points of the source face; 0: a pair at rest, whose "
             "nodes stick until "
             "they are pushed, such as a pad in its abutment. Where a body of "
             "a pair with terms of the slip rate has a 'Rotation speed', it is "
             "the speed of that, to a tenth.",
             "m/s")
        .affine();
      schema
        .add("Normal force",
             c.normal_force,
             Allowed::number(0.),
             "Resultant of the contact pressure p0 in steady sliding, which "
             "the terms of the slip rate have with 'Contact state = full', "
             "whatever 'Loads' press; with 'preload' the loads give it.",
             "N")
        .affine();
      schema
        .add("Friction slope",
             c.friction_slope,
             Allowed::number(),
             "Slope of the coefficient of friction over the sliding "
             "speed; negative values feed energy into vibrations. 0 in a pair "
             "at rest.",
             "s/m")
        .affine();
      schema
        .add("Stiffness damping",
             c.stiffness_damping,
             Allowed::number(0.),
             "Damping over stiffness of the contact; with "
             "'Scene/Damping/Model = per part' only.",
             "s")
        .affine();
      schema
        .add("Structural damping",
             c.structural_damping,
             Allowed::number(0., 2.),
             "Loss factor of the contact; with 'Scene/Damping/Model = per "
             "part' only.")
        .affine();
    }
  } // namespace prm
} // namespace squeal
