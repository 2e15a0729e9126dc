// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/turning_inertia.h>

namespace squeal
{
  TurningInertia::TurningInertia(const Discretization                &d,
                                 const std::map<std::string, double> &rates,
                                 const Map &from_system,
                                 const Map &to_system)
    : expand(from_system)
    , restrict_forces(to_system)
  {
    for (unsigned int b = 0; b < d.scene().bodies.size(); ++b)
      if (const auto rate = rates.find(d.scene().bodies[b].name);
          rate != rates.end())
        bodies.push_back(
          {turning_axes(d, b), d.scene().bodies[b].density, rate->second});
  }



  Eigen::VectorXd
  TurningInertia::forces(const Eigen::VectorXd &displacements,
                         const Eigen::VectorXd &velocities,
                         const double           speed) const
  {
    Block motion(displacements.size(), 2);
    motion << displacements, velocities;
    const Block full = expand ? expand(motion) : motion;
    Block       f    = Block::Zero(full.rows(), 1);
    for (const Body &body : bodies)
      {
        const double omega = body.rate * speed;
        f += body.density *
             (omega * omega * body.axes.centrifugal->multiply(full.col(0)) -
              2. * omega * body.axes.coriolis->multiply(full.col(1)));
      }
    return restrict_forces ? restrict_forces(f) : f;
  }
} // namespace squeal
