// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/turning_mortar.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace squeal
{
  namespace
  {
    /** Faces that cover less of a source face are not all that meet it. */
    constexpr double all_but_rounding = 1e-9;

    double
    width_of(const SurfaceFace &face)
    {
      const auto centre = face.frame({.5, .5});
      return std::min(centre.tangent[0].norm(), centre.tangent[1].norm());
    }

    double
    distance_to_axis(const dealii::Point<3> &x, const dealii::Point<3> &axis)
    {
      return std::hypot(x[0] - axis[0], x[1] - axis[1]);
    }
  } // namespace



  TurningMortar::TurningMortar(const Discretization &d,
                               const unsigned int    source_face_id,
                               const unsigned int    target_body,
                               const std::string    &text)
    : where(text)
    , basis(d.degree())
    , sources(source_faces(d, basis, source_face_id, where))
  {
    if (d.space()->n_ranks() > 1)
      throw InputError(where + ": a target that turns runs on one rank");
    const auto &position = d.scene().bodies[target_body].centre_of_rotation();
    axis                 = {position[0], position[1], position[2]};
    source_nodes         = number_nodes(sources, source_points, rows_of_source);
    find_targets(d, target_body);
    number_targets();
  }



  void
  TurningMortar::find_targets(const Discretization &d, const unsigned int body)
  {
    double low = 1e300, high = 0., margin = 0., bottom = 1e300, top = -1e300;
    width = 1e300;
    for (const auto &source : sources)
      {
        width  = std::min(width, width_of(source.geometry));
        margin = std::max(margin, source.geometry.diameter());
        for (const auto &x : source.geometry.nodes())
          {
            low    = std::min(low, distance_to_axis(x, axis));
            high   = std::max(high, distance_to_axis(x, axis));
            bottom = std::min(bottom, x[2]);
            top    = std::max(top, x[2]);
          }
      }
    reach = high;
    const dealii::Tensor<1, 3> half({high + margin, high + margin, margin});
    dealii::Point<3>           centre(axis);
    centre[2] = .5 * (bottom + top);
    const dealii::BoundingBox<3> ring({centre - half, centre + half});
    for (auto &target : target_faces(d, basis, body, ring))
      {
        const auto &face = target.geometry;
        const bool  faces_it =
          std::any_of(sources.begin(), sources.end(), [&](const auto &s) {
            return s.geometry.normal() * face.normal() <= -.5;
          });
        const double r = distance_to_axis(face.point({.5, .5}), axis);
        if (!faces_it || r + face.diameter() < low - margin ||
            r - face.diameter() > high + margin)
          continue;
        width = std::min(width, width_of(face));
        boxes.push_back(bounding_box(face));
        targets.push_back(std::move(target));
      }
    all.resize(targets.size());
    std::iota(all.begin(), all.end(), 0);
  }



  void
  TurningMortar::number_targets()
  {
    std::map<dealii::types::global_dof_index, unsigned int> number;
    std::vector<std::vector<std::size_t>>                   faces_at;
    for (std::size_t t = 0; t < targets.size(); ++t)
      {
        target_nodes.emplace_back();
        for (unsigned int a = 0; a < basis.n_nodes(); ++a)
          {
            const auto [it, is_new] =
              number.emplace(targets[t].dofs[a][2], dofs.size());
            if (is_new)
              {
                dofs.push_back(targets[t].dofs[a]);
                points.push_back(targets[t].geometry.nodes()[a]);
                faces_at.emplace_back();
              }
            target_nodes.back().push_back(it->second);
            faces_at[it->second].push_back(t);
          }
      }
    for (const auto &nodes : target_nodes)
      {
        std::set<std::size_t> round;
        for (const unsigned int node : nodes)
          round.insert(faces_at[node].begin(), faces_at[node].end());
        neighbours.emplace_back(round.begin(), round.end());
      }
  }



  std::vector<std::size_t>
  TurningMortar::close_to(const SurfaceFace              &source,
                          const std::vector<std::size_t> &candidates) const
  {
    const auto               box = bounding_box(source);
    std::vector<std::size_t> result;
    for (const std::size_t t : candidates)
      if (box.get_neighbor_type(boxes[t]) !=
          dealii::NeighborType::not_neighbors)
        result.push_back(t);
    return result;
  }



  dealii::Point<3>
  TurningMortar::turned_back(const dealii::Point<3> &x,
                             const double            angle) const
  {
    const double c = std::cos(angle), s = std::sin(angle);
    const double dx = x[0] - axis[0], dy = x[1] - axis[1];
    return {axis[0] + c * dx + s * dy, axis[1] - s * dx + c * dy, x[2]};
  }



  std::vector<Functionals::Row>
  TurningMortar::rows(const double angle)
  {
    // Less than half a cell away the neighbours hold all that can meet.
    const bool is_near =
      !met.empty() && std::abs(angle - last_angle) * reach < .5 * width;
    std::vector<SourceIntegrals> integrals;
    for (std::size_t e = 0; e < sources.size(); ++e)
      {
        // The same segments as with the target turned forwards.
        std::vector<dealii::Point<3>> turned;
        for (const auto &x : sources[e].geometry.nodes())
          turned.push_back(turned_back(x, angle));
        const SurfaceFace source(basis, turned);
        const auto        integrate = [&](const auto &candidates) {
          const auto near = close_to(source, candidates);
          n_tried += near.size();
          return integrals_of_segments(basis, source, targets, near);
        };
        SourceIntegrals face;
        if (is_near)
          {
            std::set<std::size_t> round;
            for (const std::size_t t : met[e])
              round.insert(neighbours[t].begin(), neighbours[t].end());
            face =
              integrate(std::vector<std::size_t>(round.begin(), round.end()));
          }
        if (face.covered < 1. - all_but_rounding)
          face = integrate(all);
        integrals.push_back(std::move(face));
      }
    check_covered(sources, integrals, where);

    std::vector<double>                         weights(nodes().size(), 0.);
    std::vector<std::map<unsigned int, double>> sums(nodes().size());
    met.assign(sources.size(), {});
    for (std::size_t e = 0; e < sources.size(); ++e)
      {
        const DualMap dual(integrals[e]);
        for (std::size_t a = 0; a < source_nodes[e].size(); ++a)
          weights[source_nodes[e][a]] += dual.weights()[a];
        for (const auto &shared : integrals[e].shared)
          {
            const Eigen::MatrixXd M = dual(shared);
            for (Eigen::Index b = 0; b < M.cols(); ++b)
              for (Eigen::Index a = 0; a < M.rows(); ++a)
                sums[source_nodes[e][a]][target_nodes[shared.target][b]] +=
                  M(a, b);
            met[e].push_back(shared.target);
          }
      }
    last_angle = angle;
    std::vector<Functionals::Row> result(sums.size());
    for (std::size_t j = 0; j < sums.size(); ++j)
      for (const auto &[b, weight] : sums[j])
        if (std::abs(weight) > 1e-14 * weights[j])
          result[j].emplace_back(b, weight / weights[j]);
    return result;
  }



  const std::vector<dealii::Point<3>> &
  TurningMortar::nodes() const
  {
    return source_points;
  }

  const std::vector<std::array<unsigned int, 3>> &
  TurningMortar::source_rows() const
  {
    return rows_of_source;
  }

  const std::vector<std::array<dealii::types::global_dof_index, 3>> &
  TurningMortar::target_dofs() const
  {
    return dofs;
  }

  const std::vector<dealii::Point<3>> &
  TurningMortar::target_points() const
  {
    return points;
  }

  double
  TurningMortar::narrowest() const
  {
    return width;
  }

  unsigned int
  TurningMortar::n_pairs_tried() const
  {
    return n_tried;
  }
} // namespace squeal
