// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_driver_contact_output_h
#define squeal_driver_contact_output_h

#include <squeal/contact/contact_geometry.h>
#include <squeal/results/contact_map.h>
#include <squeal/results/table.h>
#include <squeal/transient/steady_sliding.h>

#include <array>
#include <string>
#include <vector>

namespace squeal
{
  /** The resultant of nodal forces on the contact face and where it acts. */
  struct ContactResultant
  {
    std::array<double, 3> force;  /**< N: x, y by the target on the source,
                                     normal, compression positive */
    std::array<double, 2> centre; /**< of pressure, from the centre of the face,
                                     m: x, y; NaN without contact */
    double mean_pressure = 0.;    /**< over the whole face, Pa */
    double peak_pressure = 0.;    /**< of a node, Pa */
    /** Mean pressure of the nodes on the edge where the target's surface
     * enters, over that of the face; NaN without contact. */
    double leading_edge_factor = 0.;
  };

  ContactResultant contact_resultant(const ContactGeometry &geometry,
                                     const Eigen::VectorXd &forces);

  /** Nodes on the edge where the target's surface enters. */
  std::vector<bool> leading_edge(const ContactGeometry &geometry);

  /** Tractions x and y of the target on the source at every node, Pa. */
  std::vector<double> tractions(const ContactGeometry &geometry,
                                const Eigen::VectorXd &forces);

  /** Node by node: place, area, status, pressure, tractions, gap. */
  Table contact_table(const ContactGeometry            &geometry,
                      const Eigen::VectorXd            &forces,
                      const Eigen::VectorXd            &motion,
                      const Eigen::VectorXd            &initial_gap,
                      const std::vector<ContactStatus> &status);

  ContactMap contact_map(const ContactGeometry &geometry);

  std::vector<std::array<double, 3>> node_points(
    const ContactGeometry &geometry);
} // namespace squeal

#endif
