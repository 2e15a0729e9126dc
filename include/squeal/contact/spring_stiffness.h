// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_spring_stiffness_h
#define squeal_contact_spring_stiffness_h

#include <squeal/contact/contact_geometry.h>

#include <Eigen/Dense>

namespace squeal
{
  /** Whether the stiffnesses below are those of a unit of area. */
  bool is_per_area(const ContactParameters &contact);

  /** Of a pair's springs, N/m each or N/m^3. */
  double normal_stiffness(const ContactParameters &contact);

  /** Of those that stick; the normal one where none is given. */
  double tangential_stiffness(const ContactParameters &contact);

  /**
   * What the springs of a pair give way, m/N, three a point (normal, along and
   * across the sliding); zero for a pair without springs. Throws InputError
   * where the tangential stiffness is 0: nodes that stick could not carry
   * friction.
   */
  Eigen::VectorXd spring_compliance(const ContactParameters &contact,
                                    const ContactGeometry   &geometry);
} // namespace squeal

#endif
