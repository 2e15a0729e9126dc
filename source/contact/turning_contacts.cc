// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/turning_contacts.h>

#include <cmath>
#include <set>

namespace squeal
{
  TurningContacts::TurningContacts(std::shared_ptr<TurningContact> pair)
  {
    pairs.push_back({"", std::move(pair), 1., {}});
  }



  TurningContacts::TurningContacts(const Discretization         &discretization,
                                   const ContactNodes           &nodes,
                                   const TurningContact::Reduce &reduce,
                                   const unsigned int            knots_per_cell)
  {
    const Functionals B         = nodes.relative_motion();
    const double      reference = nodes.speed();
    for (const ContactPair &pair : nodes.pairs())
      {
        Pair entry;
        entry.name = pair.name();
        if (pair.slides())
          {
            entry.turning     = std::make_shared<TurningContact>(discretization,
                                                             pair.parameters,
                                                             pair.geometry,
                                                             reduce,
                                                             knots_per_cell);
            entry.speed_ratio = pair.parameters.sliding_speed / reference;
          }
        else
          entry.still = {B.rows().begin() + 3 * pair.first,
                         B.rows().begin() + 3 * (pair.first + pair.n_nodes())};
        pairs.push_back(std::move(entry));
      }
    require_one_rate();
  }



  void
  TurningContacts::require_one_rate() const
  {
    for (const Pair &a : pairs)
      for (const Pair &b : pairs)
        if (a.turning && b.turning &&
            a.turning->target_body() == b.turning->target_body())
          {
            const double rate_a = a.turning->angle(a.speed_ratio),
                         rate_b = b.turning->angle(b.speed_ratio);
            if (!(std::abs(rate_a - rate_b) <= 1e-6 * std::abs(rate_a)))
              throw InputError(
                "Scene/Contact " + b.name + "/Sliding speed: body '" +
                b.turning->target_body() +
                "' would turn at another rate than by contact '" + a.name +
                "': speeds of one disc are as the distances of the pads from "
                "its axis, and of one sense");
          }
  }



  std::map<std::string, double>
  TurningContacts::rates() const
  {
    std::map<std::string, double> result;
    for (const Pair &pair : pairs)
      if (pair.turning)
        result[pair.turning->target_body()] =
          pair.turning->angle(pair.speed_ratio);
    return result;
  }



  std::shared_ptr<const Functionals>
  TurningContacts::relative_motion(const double way)
  {
    std::vector<Functionals::Row>   rows;
    std::shared_ptr<const RowSpace> space;
    for (Pair &pair : pairs)
      if (pair.turning)
        {
          const auto B = pair.turning->relative_motion(
            pair.turning->angle(way * pair.speed_ratio));
          rows.insert(rows.end(), B->rows().begin(), B->rows().end());
          space = B->space_pointer();
        }
      else
        rows.insert(rows.end(), pair.still.begin(), pair.still.end());
    return std::make_shared<const Functionals>(space, std::move(rows));
  }



  std::vector<unsigned int>
  TurningContacts::unknowns() const
  {
    std::set<unsigned int> all;
    for (const Pair &pair : pairs)
      {
        if (pair.turning)
          {
            const auto some = pair.turning->unknowns();
            all.insert(some.begin(), some.end());
          }
        for (const auto &row : pair.still)
          for (const auto &[unknown, weight] : row)
            all.insert(unknown);
      }
    return {all.begin(), all.end()};
  }
} // namespace squeal
