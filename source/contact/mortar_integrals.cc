// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/face_overlap.h>
#include <squeal/contact/mortar_integrals.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cstdio>
#include <map>

namespace squeal
{
  namespace
  {
    /** int phi_a phi_b over points of a source face, phi_b taken at the source
     * or at the target coordinates. */
    Eigen::MatrixXd
    products(const FaceBasis                 &basis,
             const SurfaceFace               &face,
             const std::vector<OverlapPoint> &points,
             dealii::Point<2> OverlapPoint::*side)
    {
      Eigen::MatrixXd result =
        Eigen::MatrixXd::Zero(basis.n_nodes(), basis.n_nodes());
      for (const auto &point : points)
        result += point.weight * face.frame(point.source).area_vector().norm() *
                  basis.evaluate(point.source).value *
                  basis.evaluate(point.*side).value.transpose();
      return result;
    }

    /** Adds up masses and covered shares of all ranks. */
    void
    sum_over_ranks(std::vector<SourceIntegrals> &faces, const MPI_Comm comm)
    {
      std::vector<double> packed;
      for (const auto &face : faces)
        {
          packed.insert(packed.end(),
                        face.mass.data(),
                        face.mass.data() + face.mass.size());
          packed.push_back(face.covered);
        }
      MPI_Allreduce(MPI_IN_PLACE,
                    packed.data(),
                    static_cast<int>(packed.size()),
                    MPI_DOUBLE,
                    MPI_SUM,
                    comm);
      const double *p = packed.data();
      for (auto &face : faces)
        {
          std::copy(p, p + face.mass.size(), face.mass.data());
          p += face.mass.size();
          face.covered = *p++;
        }
    }
  } // namespace



  SourceIntegrals
  integrals_of_segments(const FaceBasis                &basis,
                        const SurfaceFace              &source,
                        const std::vector<TargetFace>  &targets,
                        const std::vector<std::size_t> &near,
                        const MeetingLimits            &limits)
  {
    SourceIntegrals sum;
    sum.mass = Eigen::MatrixXd::Zero(basis.n_nodes(), basis.n_nodes());
    for (const std::size_t t : near)
      {
        const auto points = face_overlap(
          source, targets[t].geometry, basis.degree(), limits.reach);
        if (points.empty())
          continue;
        for (const auto &point : points)
          sum.covered += point.weight;
        sum.mass += products(basis, source, points, &OverlapPoint::source);
        sum.shared.push_back(
          {static_cast<unsigned int>(t),
           products(basis, source, points, &OverlapPoint::target)});
      }
    return sum;
  }

  std::vector<SourceIntegrals>
  integrals_of_all_faces(const FaceBasis               &basis,
                         const std::vector<SourceFace> &sources,
                         const std::vector<TargetFace> &targets,
                         const MeetingLimits           &limits,
                         const MPI_Comm                 comm)
  {
    std::vector<dealii::BoundingBox<3>> boxes;
    for (const auto &target : targets)
      boxes.push_back(bounding_box(target.geometry));
    const auto tree = dealii::pack_rtree_of_indices(boxes);

    std::vector<SourceIntegrals> result;
    for (const auto &source : sources)
      {
        std::vector<std::size_t> near;
        tree.query(
          boost::geometry::index::intersects(bounding_box(source.geometry)),
          std::back_inserter(near));
        std::sort(near.begin(), near.end());
        result.push_back(
          integrals_of_segments(basis, source.geometry, targets, near, limits));
      }
    sum_over_ranks(result, comm);
    return result;
  }

  std::vector<SourceIntegrals>
  integrals_of_whole_faces(const FaceBasis               &basis,
                           const std::vector<SourceFace> &sources)
  {
    std::vector<SourceIntegrals> result;
    for (const auto &source : sources)
      result.push_back({products(basis,
                                 source.geometry,
                                 whole_face(source.geometry, basis.degree()),
                                 &OverlapPoint::source),
                        1.,
                        {}});
    return result;
  }



  void
  check_covered(const std::vector<SourceFace>      &sources,
                const std::vector<SourceIntegrals> &integrals,
                const std::string                  &where,
                const MeetingLimits                &limits)
  {
    std::size_t worst = 0;
    for (std::size_t e = 0; e < sources.size(); ++e)
      if (std::abs(integrals[e].covered - 1.) >
          std::abs(integrals[worst].covered - 1.))
        worst = e;
    const double missing = 1. - integrals[worst].covered;
    if (std::abs(missing) <= limits.beside)
      return;
    const auto x = sources[worst].geometry.point({.5, .5});
    char       text[200];
    std::snprintf(text,
                  sizeof text,
                  ": the faces do not meet at (%g, %g, %g) m: %.3g %% of the "
                  "cell's face there %s",
                  x[0],
                  x[1],
                  x[2],
                  100. * std::abs(missing),
                  missing > 0. ? "has no target opposite"
                               : "has more than one target opposite");
    throw InputError(where + text);
  }



  // The shape functions add up to one.
  DualMap::DualMap(const SourceIntegrals &face)
    : areas(face.mass.rowwise().sum())
    , factor(face.mass.ldlt())
  {
  }

  Eigen::MatrixXd
  DualMap::operator()(const SharedIntegrals &shared) const
  {
    return areas.asDiagonal() * factor.solve(shared.products);
  }

  const Eigen::VectorXd &
  DualMap::weights() const
  {
    return areas;
  }



  std::vector<std::vector<unsigned int>>
  number_nodes(const std::vector<SourceFace>            &sources,
               std::vector<dealii::Point<3>>            &points,
               std::vector<std::array<unsigned int, 3>> &rows)
  {
    std::map<unsigned int, unsigned int>   number;
    std::vector<std::vector<unsigned int>> nodes;
    for (const auto &source : sources)
      {
        nodes.emplace_back();
        for (std::size_t a = 0; a < source.keys.size(); ++a)
          {
            const auto [it, is_new] =
              number.emplace(source.keys[a], points.size());
            if (is_new)
              {
                points.push_back(source.geometry.nodes()[a]);
                rows.push_back(source.rows[a]);
              }
            nodes.back().push_back(it->second);
          }
      }
    return nodes;
  }
} // namespace squeal
