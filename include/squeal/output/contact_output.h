// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_contact_output_h
#define squeal_output_contact_output_h

#include <squeal/contact/contact_geometry.h>
#include <squeal/results/contact_map.h>
#include <squeal/results/table.h>
#include <squeal/transient/steady_sliding.h>

#include <array>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * The direction t of the sliding of the target's surface at the pad: the mean
   * of that of the points over the face, which is Omega x r at the centre of a
   * face that is symmetric about its radius. Unit vector, x and y; +y where
   * points slide all round, in no common direction.
   */
  std::array<double, 2> sliding_direction(const ContactGeometry &geometry);

  /** It in words: "+y", or "(0.5, 0.866)" where it is along no axis. */
  std::string sliding_text(const ContactGeometry &geometry);

  /** Resultant of nodal forces by the target on the source, N: along s = t x n
   * (radially outwards under a disc that turns about +z), along t =
   * sliding_direction(), normal, compression positive. It does not change when
   * the scene is turned about the axis. */
  std::array<double, 3> resultant_force(const ContactGeometry &geometry,
                                        const Eigen::VectorXd &forces);

  /** The resultant of nodal forces on the contact face and where it acts. */
  struct ContactResultant
  {
    std::array<double, 3> force;  /**< resultant_force(), N */
    std::array<double, 2> centre; /**< of pressure, from the centre of the face,
                                     m: along s and t; NaN without contact */
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
