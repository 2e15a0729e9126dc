// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_contact_output_h
#define squeal_output_contact_output_h

#include <squeal/contact/contact_nodes.h>
#include <squeal/contact/contact_resultant.h>
#include <squeal/results/contact_map.h>
#include <squeal/results/table.h>
#include <squeal/transient/steady_sliding.h>

#include <array>
#include <string>
#include <vector>

namespace squeal
{
  /** The direction in which the target's surface slides, in words: "+y", or
   * "(0.5, 0.866, 0)" where it is along no axis. */
  std::string sliding_text(const ContactGeometry &geometry);

  /** Node by node: place, area, status, pressure, tractions, gap. */
  Table contact_table(const ContactGeometry            &geometry,
                      const Eigen::VectorXd            &forces,
                      const Eigen::VectorXd            &motion,
                      const Eigen::VectorXd            &initial_gap,
                      const std::vector<ContactStatus> &status);

  /** The face as its maps draw it: along FaceAxes. */
  ContactMap contact_map(const ContactGeometry &geometry);

  /** A pressure, Pa, as maps show it: in MPa, NaN where there is none. */
  double pressure_on_map(const double pressure);

  /** Of the values of ContactStatus: "open", "stick", "slip". */
  std::vector<std::string> status_names();

  std::vector<std::array<double, 3>> node_points(
    const ContactGeometry &geometry);
} // namespace squeal

#endif
