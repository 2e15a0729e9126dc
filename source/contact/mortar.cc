// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/face_overlap.h>
#include <squeal/contact/mortar.h>
#include <squeal/contact/mortar_faces.h>
#include <squeal/discretization/face_quadrature.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/numerics/rtree.h>

#include <Eigen/Dense>

#include <cstdio>
#include <map>

namespace squeal
{
  namespace
  {
    constexpr unsigned int ground = -1u;

    /** Share of a source face that may lie beside the target: meshes of one
     * curved edge that differ leave slivers. */
    constexpr double allowed_gap = 1e-4;

    /** int phi_a phi_b of a source face with a target face of this rank. */
    struct SharedIntegrals
    {
      unsigned int    target;
      Eigen::MatrixXd products; /**< source nodes x target nodes, m^2 */
    };

    struct SourceIntegrals
    {
      Eigen::MatrixXd              mass;         /**< int phi_a phi_b, m^2 */
      double                       covered = 0.; /**< share of the face */
      std::vector<SharedIntegrals> shared;
    };



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



    dealii::BoundingBox<3>
    box_round(const std::vector<SourceFace> &sources)
    {
      dealii::BoundingBox<3> box = bounding_box(sources.front().geometry);
      for (const auto &source : sources)
        box.merge_with(bounding_box(source.geometry));
      return box;
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

    /** Every source face with the target faces of this rank, segment by
     * segment; masses over all ranks. */
    std::vector<SourceIntegrals>
    integrals_of_segments(const FaceBasis               &basis,
                          const std::vector<SourceFace> &sources,
                          const std::vector<TargetFace> &targets,
                          const MPI_Comm                 comm)
    {
      std::vector<dealii::BoundingBox<3>> boxes;
      for (const auto &target : targets)
        boxes.push_back(bounding_box(target.geometry));
      const auto tree = dealii::pack_rtree_of_indices(boxes);

      std::vector<SourceIntegrals> result;
      for (const auto &source : sources)
        {
          SourceIntegrals sum;
          sum.mass = Eigen::MatrixXd::Zero(basis.n_nodes(), basis.n_nodes());
          std::vector<std::size_t> near;
          tree.query(
            boost::geometry::index::intersects(bounding_box(source.geometry)),
            std::back_inserter(near));
          std::sort(near.begin(), near.end());
          for (const std::size_t t : near)
            {
              const auto points = face_overlap(
                source.geometry, targets[t].geometry, basis.degree());
              if (points.empty())
                continue;
              for (const auto &point : points)
                sum.covered += point.weight;
              sum.mass +=
                products(basis, source.geometry, points, &OverlapPoint::source);
              sum.shared.push_back(
                {static_cast<unsigned int>(t),
                 products(
                   basis, source.geometry, points, &OverlapPoint::target)});
            }
          result.push_back(std::move(sum));
        }
      sum_over_ranks(result, comm);
      return result;
    }

    void
    check_covered(const std::vector<SourceFace>      &sources,
                  const std::vector<SourceIntegrals> &integrals,
                  const std::string                  &where)
    {
      std::size_t worst = 0;
      for (std::size_t e = 0; e < sources.size(); ++e)
        if (std::abs(integrals[e].covered - 1.) >
            std::abs(integrals[worst].covered - 1.))
          worst = e;
      const double missing = 1. - integrals[worst].covered;
      if (std::abs(missing) <= allowed_gap)
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



    /** Numbers the nodes of all source faces. */
    std::vector<std::vector<unsigned int>>
    number_nodes(const std::vector<SourceFace> &sources, MortarCoupling &result)
    {
      std::map<unsigned int, unsigned int>   number;
      std::vector<std::vector<unsigned int>> nodes;
      for (const auto &source : sources)
        {
          nodes.emplace_back();
          for (std::size_t a = 0; a < source.keys.size(); ++a)
            {
              const auto [it, is_new] =
                number.emplace(source.keys[a], result.nodes.size());
              if (is_new)
                {
                  result.nodes.push_back(source.geometry.nodes()[a]);
                  result.source_rows.push_back(source.rows[a]);
                }
              nodes.back().push_back(it->second);
            }
        }
      return nodes;
    }

    using RowSums = std::vector<std::array<std::map<unsigned int, double>, 3>>;

    /** Adds to M what this rank's target faces give to a source face. */
    void
    add_target_rows(const Discretization            &d,
                    const std::vector<TargetFace>   &targets,
                    const SourceIntegrals           &face,
                    const Eigen::VectorXd           &integrals,
                    const std::vector<unsigned int> &nodes,
                    RowSums                         &sums)
    {
      const auto factor = face.mass.ldlt();
      for (const auto &shared : face.shared)
        {
          // The dual functions are psi = D_e M_e^-1 phi.
          const Eigen::MatrixXd M =
            integrals.asDiagonal() * factor.solve(shared.products);
          const auto &dofs = targets[shared.target].dofs;
          for (Eigen::Index b = 0; b < M.cols(); ++b)
            for (unsigned int c = 0; c < 3; ++c)
              for (const auto &[row, weight] : d.expansion(dofs[b][c]))
                for (Eigen::Index a = 0; a < M.rows(); ++a)
                  sums[nodes[a]][c][row] += M(a, b) * weight;
        }
    }

    /** Adds up the rows of all ranks over the weights D_j. What is rounding
     * only is left out: matching nodes follow one another alone. */
    void
    gather_rows(const RowSums &mine, const MPI_Comm comm, MortarCoupling &m)
    {
      std::vector<double> packed;
      for (std::size_t j = 0; j < mine.size(); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          for (const auto &[row, weight] : mine[j][c])
            packed.insert(packed.end(),
                          {double(j), double(c), double(row), weight});
      const std::vector<double> all = all_gather(packed, comm);
      RowSums                   sums(m.nodes.size());
      for (std::size_t k = 0; k < all.size(); k += 4)
        sums[static_cast<std::size_t>(all[k])][static_cast<std::size_t>(
          all[k + 1])][static_cast<unsigned int>(all[k + 2])] += all[k + 3];
      for (std::size_t j = 0; j < sums.size(); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          for (const auto &[row, weight] : sums[j][c])
            if (std::abs(weight) > 1e-14 * m.weights[j])
              m.target_rows[j][c].emplace_back(row, weight / m.weights[j]);
    }
  } // namespace



  MortarCoupling
  make_mortar_coupling(const Discretization &d,
                       const PointEvaluator &evaluator,
                       const unsigned int    source_face_id,
                       const unsigned int    target_body,
                       const std::string    &where)
  {
    const MPI_Comm  comm = d.space()->communicator();
    const FaceBasis basis(d.degree());
    const auto      sources = source_faces(d, basis, source_face_id, where);
    const bool      is_meshed =
      target_body != ground &&
      d.scene().bodies[target_body].shape != BodyParameters::Shape::rigid;
    std::vector<TargetFace> targets;
    if (is_meshed && !sources.empty())
      targets = target_faces(d, basis, target_body, box_round(sources));
    const auto integrals =
      is_meshed ? integrals_of_segments(basis, sources, targets, comm)
                : integrals_of_whole_faces(basis, sources);
    if (is_meshed)
      check_covered(sources, integrals, where);

    MortarCoupling result;
    const auto     nodes = number_nodes(sources, result);
    result.weights.resize(result.nodes.size(), 0.);
    result.target_rows.resize(result.nodes.size());
    RowSums sums(result.nodes.size());
    for (std::size_t e = 0; e < sources.size(); ++e)
      {
        // The shape functions add up to one.
        const Eigen::VectorXd areas = integrals[e].mass.rowwise().sum();
        for (std::size_t a = 0; a < nodes[e].size(); ++a)
          result.weights[nodes[e][a]] += areas[a];
        add_target_rows(d, targets, integrals[e], areas, nodes[e], sums);
      }
    if (is_meshed)
      gather_rows(sums, comm, result);
    else if (target_body != ground)
      // A rigid motion is linear: int psi_j u = D_j u(x_j).
      result.target_rows =
        evaluator.displacements(target_body, result.nodes).rows;
    return result;
  }



  MortarCoupling
  make_node_coupling(const Discretization &d,
                     const PointEvaluator &evaluator,
                     const unsigned int    source_face_id,
                     const unsigned int    target_body,
                     const std::string    &where)
  {
    MortarCoupling result =
      make_mortar_coupling(d, evaluator, source_face_id, ground, where);
    if (target_body == ground)
      return result;
    const auto target =
      evaluator.displacements(target_body, result.nodes, 1e-4);
    for (std::size_t j = 0; j < result.nodes.size(); ++j)
      if (!target.found[j])
        throw InputError(where + ": the faces do not meet at (" +
                         std::to_string(result.nodes[j][0]) + ", " +
                         std::to_string(result.nodes[j][1]) + ", " +
                         std::to_string(result.nodes[j][2]) + ") m");
    result.target_rows = target.rows;
    return result;
  }
} // namespace squeal
