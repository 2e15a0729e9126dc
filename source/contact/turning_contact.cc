// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/turning_contact.h>

#include <cmath>
#include <set>

namespace squeal
{
  namespace
  {
    using Row = Functionals::Row;

    void
    append(const double factor, const Row &part, Row &sum)
    {
      if (factor != 0.)
        for (const auto &[column, weight] : part)
          sum.emplace_back(column, factor * weight);
    }

    /** Displacements of all source and target nodes as functionals. */
    std::shared_ptr<const Functionals>
    node_motions(const Discretization         &d,
                 const TurningMortar          &mortar,
                 const TurningContact::Reduce &reduce)
    {
      std::vector<Row> rows;
      for (const auto &node : mortar.source_rows())
        for (const unsigned int row : node)
          rows.push_back(row == -1u ? Row{} : Row{{row, 1.}});
      for (const auto &node : mortar.target_dofs())
        for (const auto dof : node)
          rows.push_back(d.expansion(dof));
      const auto all =
        std::make_shared<const Functionals>(d.space(), std::move(rows));
      return reduce ? reduce(*all) : all;
    }

    Row
    interpolate(const Row &a, const Row &b, const double share)
    {
      Row  result;
      auto i = a.begin(), j = b.begin();
      while (i != a.end() || j != b.end())
        if (j == b.end() || (i != a.end() && i->first < j->first))
          {
            result.emplace_back(i->first, (1. - share) * i->second);
            ++i;
          }
        else if (i == a.end() || j->first < i->first)
          {
            result.emplace_back(j->first, share * j->second);
            ++j;
          }
        else
          {
            result.emplace_back(i->first,
                                (1. - share) * i->second + share * j->second);
            ++i;
            ++j;
          }
      return result;
    }
  } // namespace



  TurningContact::TurningContact(const Discretization    &d,
                                 const ContactParameters &contact,
                                 const ContactGeometry   &geometry,
                                 const Reduce            &reduce,
                                 const unsigned int       knots_per_cell)
    : turning(d,
              face_id(d.coarse_mesh(),
                      d.scene(),
                      contact.source_body,
                      contact.source_face),
              body_index(d.scene(), contact.target_body),
              "Scene/Contact " + contact.name)
    , start(geometry)
    , target(contact.target_body)
    , motions(node_motions(d, turning, reduce))
  {
    AssertDimension(turning.nodes().size(), geometry.points.size());
    const auto &axis = d.scene()
                         .bodies[body_index(d.scene(), contact.target_body)]
                         .centre_of_rotation();
    double radius = 0., sense = 0.;
    for (std::size_t j = 0; j < geometry.points.size(); ++j)
      {
        const double x  = geometry.points[j][0] - axis[0],
                     y  = geometry.points[j][1] - axis[1];
        const double tx = geometry.frames[j].sliding[0],
                     ty = geometry.frames[j].sliding[1];
        radius += std::hypot(x, y) / geometry.points.size();
        sense += (x * ty - y * tx) / std::hypot(x, y) / geometry.points.size();
      }
    if (!(std::abs(std::abs(sense) - 1.) < 1e-9))
      throw InputError("Scene/Contact " + contact.name +
                       "/Friction direction: must be slip where the target's "
                       "mesh turns");
    angle_per_way = std::copysign(1., sense) / radius;
    spacing =
      knots_per_cell > 0 ? turning.narrowest() / (radius * knots_per_cell) : 0.;
  }



  const std::vector<Row> &
  TurningContact::at_knot(const long number)
  {
    const auto found = knots.find(number);
    if (found != knots.end())
      return found->second;
    while (knots.size() > 2)
      knots.erase(std::abs(knots.begin()->first - number) >
                      std::abs(knots.rbegin()->first - number)
                    ? knots.begin()
                    : std::prev(knots.end()));
    return knots.emplace(number, turning.rows(number * spacing)).first->second;
  }

  std::vector<Row>
  TurningContact::weights(const double angle)
  {
    if (spacing == 0.)
      return turning.rows(angle);
    const double place = angle / spacing;
    const long   first = static_cast<long>(std::floor(place));
    const double share = place - first;
    const auto  &a = at_knot(first), &b = share > 0. ? at_knot(first + 1) : a;
    std::vector<Row> result;
    for (std::size_t j = 0; j < a.size(); ++j)
      result.push_back(share > 0. ? interpolate(a[j], b[j], share) : a[j]);
    return result;
  }



  std::array<std::vector<Row>, 3>
  TurningContact::parts(const double angle)
  {
    const std::vector<Row>          M = weights(angle);
    const double                    c = std::cos(angle), s = std::sin(angle);
    const auto                     &u = motions->rows();
    const std::size_t               n = M.size();
    std::array<std::vector<Row>, 3> result;
    for (auto &part : result)
      part.resize(n);
    for (std::size_t j = 0; j < n; ++j)
      {
        const ContactFrame &frame     = start.frames[j];
        const auto         *source    = &u[3 * j];
        unsigned int        component = 0;
        for (const auto &d : {frame.normal, frame.sliding, frame.transverse})
          {
            Row &row = result[component++][j];
            // The direction in the axes of the target.
            const std::array<double, 3> turned = {
              {d[0] * c + d[1] * s, d[1] * c - d[0] * s, d[2]}};
            for (const auto &[b, weight] : M[j])
              for (unsigned int k = 0; k < 3; ++k)
                append(weight * turned[k], u[3 * (n + b) + k], row);
            for (unsigned int k = 0; k < 3; ++k)
              append(-d[k], source[k], row);
          }
      }
    return result;
  }



  std::shared_ptr<const Functionals>
  TurningContact::relative_motion(const double angle)
  {
    auto             part = parts(angle);
    std::vector<Row> rows;
    for (std::size_t j = 0; j < part[0].size(); ++j)
      for (auto &list : part)
        rows.push_back(std::move(list[j]));
    return std::make_shared<const Functionals>(motions->space_pointer(),
                                               std::move(rows));
  }

  ContactGeometry
  TurningContact::geometry(const double angle)
  {
    auto            part   = parts(angle);
    ContactGeometry result = start;
    const auto      make   = [&](std::vector<Row> &rows) {
      return std::make_shared<const Functionals>(motions->space_pointer(),
                                                 std::move(rows));
    };
    result.normal     = make(part[0]);
    result.tangential = make(part[1]);
    result.transverse = make(part[2]);
    return result;
  }

  double
  TurningContact::angle(const double way) const
  {
    return angle_per_way * way;
  }

  const std::string &
  TurningContact::target_body() const
  {
    return target;
  }

  std::vector<unsigned int>
  TurningContact::unknowns() const
  {
    std::set<unsigned int> all;
    for (const auto &row : motions->rows())
      for (const auto &[unknown, weight] : row)
        all.insert(unknown);
    return std::vector<unsigned int>(all.begin(), all.end());
  }

  const TurningMortar &
  TurningContact::mortar() const
  {
    return turning;
  }
} // namespace squeal
