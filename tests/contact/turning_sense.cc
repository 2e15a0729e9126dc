// SPDX-License-Identifier: LGPL-2.1-or-later

// A disc that turns against its own friction is refused whatever the law of
// friction is, and one that turns along with it, or rubs nowhere, is not.

#include "scenes.h"

#include <squeal/base/exceptions.h>
#include <squeal/contact/contact_faces.h>

#include <deal.II/base/mpi.h>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Law = ContactParameters::FrictionLaw;

  /** @p speed of the disc, rad/s; a table and an exponential law have the
   * friction that a constant one has by @p mu, from 0 for tables. */
  ContactParameters
  contact_of(const Law law, const double sign, const double mu)
  {
    ContactParameters c  = coarse_brake(sign * mu).contacts[0];
    c.friction_direction = ContactParameters::FrictionDirection::slip;
    c.friction_law       = law;
    c.sliding_speed      = 1.075; // of 10 rad/s, m/s
    if (law == Law::constant)
      return c;
    c.friction_coefficient        = sign < 0. ? -1e-3 : 0.;
    c.static_friction_coefficient = law == Law::exponential ? mu : 0.;
    c.decay_speed                 = law == Law::exponential ? 1. : 0.;
    if (law == Law::table)
      {
        c.friction_speeds       = {0., 10.};
        c.friction_coefficients = {mu, mu};
      }
    return c;
  }

  bool
  is_refused(const ContactParameters &contact, const double speed)
  {
    SceneParameters scene          = coarse_brake(0.);
    scene.contacts                 = {contact};
    scene.bodies[0].rotation_speed = speed;
    const Discretization d(scene, Model::parameters(0), 1, MPI_COMM_SELF);
    try
      {
        check_contact_faces(d);
      }
    catch (const InputError &e)
      {
        check(std::string(e.what()).find("slides the other way") !=
                std::string::npos,
              std::string("for its sense: ") + e.what());
        return true;
      }
    return false;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  for (const Law law : {Law::constant, Law::exponential, Law::table})
    {
      const std::string name =
        "law " + std::to_string(static_cast<int>(law)) + ": ";
      check(is_refused(contact_of(law, 1., .5), -10.),
            name + "turning against the friction");
      check(!is_refused(contact_of(law, 1., .5), 10.), name + "along with it");
      check(is_refused(contact_of(law, -1., .5), 10.),
            name + "forwards with a backward friction");
      check(!is_refused(contact_of(law, -1., .5), -10.),
            name + "backwards with it");
      check(!is_refused(contact_of(law, 1., 0.), -10.),
            name + "nothing rubs, nothing is asked");
    }
}
