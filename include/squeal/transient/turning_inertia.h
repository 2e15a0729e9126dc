// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_turning_inertia_h
#define squeal_transient_turning_inertia_h

#include <squeal/discretization/assembly.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * Coriolis and centrifugal forces on bodies whose displacements u are those
   * along axes that turn with them about z: rho (-2 Omega e_z x u' + Omega^2
   * u_xy). The load rho Omega^2 r of the body at rest and the stiffness by its
   * stress, of the relative size (Omega / omega)^2, are left out, as they are
   * in the fixed frame.
   */
  class TurningInertia
  {
  public:
    using Map = std::function<Block(const Block &)>;

    /** @p rates as TurningContacts::rates(), @p expand and @p restrict_forces
     * as those of LinearizedSystem. */
    TurningInertia(const Discretization                &discretization,
                   const std::map<std::string, double> &rates,
                   const Map                           &expand,
                   const Map                           &restrict_forces);

    /** Forces on the unknowns of the system, N, at @p displacements, m, and
     * @p velocities, m/s, while the drive goes at @p speed, m/s. */
    Eigen::VectorXd forces(const Eigen::VectorXd &displacements,
                           const Eigen::VectorXd &velocities,
                           const double           speed) const;

  private:
    struct Body
    {
      TurningAxes axes;
      double      density; /**< kg/m^3 */
      double      rate;    /**< rad per metre of the drive's way */
    };

    std::vector<Body> bodies;
    Map               expand, restrict_forces;
  };
} // namespace squeal

#endif
