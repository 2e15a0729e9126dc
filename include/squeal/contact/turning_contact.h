// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_turning_contact_h
#define squeal_contact_turning_contact_h

#include <squeal/contact/contact_geometry.h>
#include <squeal/contact/turning_mortar.h>

#include <functional>
#include <map>

namespace squeal
{
  /**
   * The relative motion B(theta) u of a mortar contact whose target turns: the
   * target's unknowns are displacements in axes that turn with it, R(theta)
   * takes them to those of the source,
   *   B(theta) u = D^-1 M(theta) R(theta) u_target - u_source,
   * three rows a node: normal, along and across the sliding.
   *
   * M changes with the place on the mesh alone: with @p knots_per_cell > 0 it
   * is integrated at angles that are this share of the narrowest cell apart and
   * linear in between, which keeps what it gives to constants; R is that of the
   * angle itself.
   */
  class TurningContact
  {
  public:
    using Reduce =
      std::function<std::shared_ptr<const Functionals>(const Functionals &)>;

    /** @p geometry: of the start; its sliding directions tell which way the
     * target turns. @p reduce: from unknowns of the discretisation to those of
     * the system; null: the same. Throws InputError where the sliding is not
     * that of a turning target. */
    TurningContact(const Discretization    &discretization,
                   const ContactParameters &contact,
                   const ContactGeometry   &geometry,
                   const Reduce            &reduce         = {},
                   const unsigned int       knots_per_cell = 0);

    /** B at an angle, rad, counterclockwise about z. */
    std::shared_ptr<const Functionals> relative_motion(const double angle);
    /** The geometry of the start with the functionals of an angle. */
    ContactGeometry geometry(const double angle);
    /** The angle where the target's surface has moved by @p way at the centre
     * of the source face, m. */
    double             angle(const double way) const;
    const std::string &target_body() const;

    /** All unknowns that some angle has to do with, ascending. */
    std::vector<unsigned int> unknowns() const;

    const TurningMortar &mortar() const;

  private:
    /** D^-1 M at an angle. */
    std::vector<Functionals::Row>                weights(const double angle);
    const std::vector<Functionals::Row>         &at_knot(const long number);
    std::array<std::vector<Functionals::Row>, 3> parts(const double angle);

    TurningMortar   turning;
    ContactGeometry start;
    std::string     target;
    double          angle_per_way; /**< rad/m */
    double          spacing;       /**< of knots, rad; 0: none */
    /** Unknowns of the nodes: x, y, z of all sources, then of all targets. */
    std::shared_ptr<const Functionals>            motions;
    std::map<long, std::vector<Functionals::Row>> knots;
  };
} // namespace squeal

#endif
