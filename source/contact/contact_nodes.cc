// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/contact_nodes.h>
#include <squeal/contact/spring_stiffness.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** The same contact with sliding and transverse direction reversed. */
    void
    reverse(ContactGeometry &g)
    {
      const auto negative = [](const Functionals &all) {
        std::vector<Functionals::Row> rows = all.rows();
        for (auto &row : rows)
          for (auto &[column, weight] : row)
            weight = -weight;
        return std::make_shared<const Functionals>(all.space_pointer(),
                                                   std::move(rows));
      };
      g.tangential = negative(*g.tangential);
      g.transverse = negative(*g.transverse);
      for (auto &frame : g.frames)
        {
          frame.sliding *= -1.;
          frame.transverse *= -1.;
        }
    }
  } // namespace



  const std::string &
  ContactPair::name() const
  {
    return parameters.name;
  }

  unsigned int
  ContactPair::n_nodes() const
  {
    return geometry.points.size();
  }

  bool
  ContactPair::slides() const
  {
    return parameters.sliding_speed > 0.;
  }

  Eigen::VectorXd
  ContactPair::part(const Eigen::VectorXd &values,
                    const unsigned int     per_node) const
  {
    return values.segment(per_node * first, per_node * n_nodes());
  }

  std::vector<ContactStatus>
  ContactPair::part(const std::vector<ContactStatus> &values) const
  {
    return {values.begin() + first, values.begin() + first + n_nodes()};
  }



  ContactNodes::ContactNodes(const std::vector<ContactParameters> &contacts,
                             std::vector<ContactGeometry>          geometries)
  {
    AssertDimension(contacts.size(), geometries.size());
    unsigned int first = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i)
      {
        ContactPair pair{contacts[i], std::move(geometries[i]), first};
        if (contacts[i].friction_coefficient < 0.)
          reverse(pair.geometry);
        pair.parameters.friction_coefficient =
          std::abs(contacts[i].friction_coefficient);
        first += pair.n_nodes();
        all.push_back(std::move(pair));
      }
  }

  const std::vector<ContactPair> &
  ContactNodes::pairs() const
  {
    return all;
  }

  unsigned int
  ContactNodes::n_nodes() const
  {
    return all.empty() ? 0 : all.back().first + all.back().n_nodes();
  }

  unsigned int
  ContactNodes::pair_of(const unsigned int node) const
  {
    unsigned int i = 0;
    while (i + 1 < all.size() && node >= all[i + 1].first)
      ++i;
    return i;
  }



  double
  ContactNodes::speed() const
  {
    double largest = 0.;
    for (const ContactPair &pair : all)
      largest = std::max(largest, pair.parameters.sliding_speed);
    return largest;
  }

  Eigen::VectorXd
  ContactNodes::speed_ratio() const
  {
    const double    reference = speed();
    Eigen::VectorXd result(n_nodes());
    for (const ContactPair &pair : all)
      for (unsigned int j = 0; j < pair.n_nodes(); ++j)
        result[pair.first + j] =
          pair.geometry.speed_ratio[j] *
          (reference > 0. ? pair.parameters.sliding_speed / reference : 1.);
    return result;
  }

  std::vector<double>
  ContactNodes::areas() const
  {
    std::vector<double> result;
    for (const ContactPair &pair : all)
      result.insert(
        result.end(), pair.geometry.areas.begin(), pair.geometry.areas.end());
    return result;
  }

  Eigen::VectorXd
  ContactNodes::compliance() const
  {
    Eigen::VectorXd result(3 * n_nodes());
    for (const ContactPair &pair : all)
      result.segment(3 * pair.first, 3 * pair.n_nodes()) =
        spring_compliance(pair.parameters, pair.geometry);
    return result;
  }

  Functionals
  ContactNodes::relative_motion() const
  {
    std::vector<ContactGeometry> geometries;
    for (const ContactPair &pair : all)
      geometries.push_back(pair.geometry);
    return squeal::relative_motion(geometries);
  }

  std::vector<bool>
  ContactNodes::turned_back_from(const ContactNodes &other) const
  {
    AssertDimension(n_nodes(), other.n_nodes());
    std::vector<bool> result;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < all[i].geometry.frames.size(); ++j)
        result.push_back(all[i].geometry.frames[j].sliding *
                           other.all[i].geometry.frames[j].sliding <
                         0.);
    return result;
  }



  FrictionLaws
  ContactNodes::laws() const
  {
    Assert(!all.empty(), dealii::ExcInternalError());
    FrictionLaws result{FrictionLaw(all[0].parameters)};
    for (std::size_t i = 1; i < all.size(); ++i)
      result.append(FrictionLaw(all[i].parameters), all[i].first);
    return result;
  }

  NodalFriction
  ContactNodes::in_sliding() const
  {
    const double reference = speed();
    return laws().in_sliding(speed_ratio(), reference);
  }

  std::vector<double>
  ContactNodes::coefficients() const
  {
    std::vector<double> result;
    for (const ContactPair &pair : all)
      result.push_back(pair.parameters.friction_coefficient);
    return result;
  }

  void
  ContactNodes::set_coefficients(const std::vector<double> &coefficients)
  {
    AssertDimension(coefficients.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      {
        Assert(coefficients[i] >= 0., dealii::ExcInternalError());
        auto &p = all[i].parameters;
        if (p.friction_law == ContactParameters::FrictionLaw::table &&
            coefficients[i] != p.friction_coefficient)
          throw InputError("Scene/Contact " + p.name +
                           "/Friction coefficient: has no effect with "
                           "'Friction law = table'");
        p.friction_coefficient = coefficients[i];
      }
  }



  std::vector<double>
  friction_sizes(const std::vector<ContactParameters> &contacts)
  {
    std::vector<double> result;
    for (const auto &contact : contacts)
      result.push_back(std::abs(contact.friction_coefficient));
    return result;
  }
} // namespace squeal
