// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/spring_stiffness.h>

namespace squeal
{
  bool
  is_per_area(const ContactParameters &contact)
  {
    return contact.layout == ContactParameters::SpringLayout::quadrature;
  }

  double
  normal_stiffness(const ContactParameters &contact)
  {
    return is_per_area(contact) ? contact.normal_stiffness_per_area
                                : contact.normal_stiffness;
  }

  double
  tangential_stiffness(const ContactParameters &contact)
  {
    return contact.tangential_stiffness >= 0. ? contact.tangential_stiffness
                                              : normal_stiffness(contact);
  }



  Eigen::VectorXd
  spring_compliance(const ContactParameters &contact,
                    const ContactGeometry   &geometry)
  {
    const std::size_t n      = geometry.points.size();
    Eigen::VectorXd   result = Eigen::VectorXd::Zero(3 * n);
    if (contact.formulation != ContactParameters::Formulation::springs)
      return result;
    const double normal     = normal_stiffness(contact),
                 tangential = tangential_stiffness(contact);
    if (!(tangential > 0.))
      throw InputError("Scene/Contact " + contact.name +
                       "/Tangential stiffness: must not be 0, nodes that "
                       "stick could not carry friction");
    for (std::size_t j = 0; j < n; ++j)
      {
        const double area = is_per_area(contact) ? geometry.areas[j] : 1.;
        result[3 * j]     = 1. / (normal * area);
        result[3 * j + 1] = result[3 * j + 2] = 1. / (tangential * area);
      }
    return result;
  }
} // namespace squeal
