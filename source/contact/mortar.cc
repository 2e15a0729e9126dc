// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/contact/mortar.h>
#include <squeal/contact/mortar_integrals.h>
#include <squeal/discretization/face_quadrature.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/numerics/rtree.h>

#include <map>

namespace squeal
{
  namespace
  {
    constexpr unsigned int ground = -1u;

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
    integrals_of_all_faces(const FaceBasis               &basis,
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
          std::vector<std::size_t> near;
          tree.query(
            boost::geometry::index::intersects(bounding_box(source.geometry)),
            std::back_inserter(near));
          std::sort(near.begin(), near.end());
          result.push_back(
            integrals_of_segments(basis, source.geometry, targets, near));
        }
      sum_over_ranks(result, comm);
      return result;
    }



    std::vector<dealii::Tensor<1, 3>>
    nodal_normals(const FaceBasis                              &basis,
                  const std::vector<SourceFace>                &sources,
                  const std::vector<std::vector<unsigned int>> &nodes,
                  const std::size_t                             n_nodes)
    {
      std::vector<dealii::Tensor<1, 3>> result(n_nodes);
      for (std::size_t e = 0; e < sources.size(); ++e)
        for (std::size_t a = 0; a < nodes[e].size(); ++a)
          {
            const auto area =
              sources[e].geometry.frame(basis.node(a)).area_vector();
            result[nodes[e][a]] += area / area.norm();
          }
      for (auto &normal : result)
        normal /= normal.norm();
      return result;
    }



    using RowSums = std::vector<std::array<std::map<unsigned int, double>, 3>>;

    /** Adds to M what this rank's target faces give to a source face. */
    void
    add_target_rows(const Discretization            &d,
                    const std::vector<TargetFace>   &targets,
                    const SourceIntegrals           &face,
                    const std::vector<unsigned int> &nodes,
                    RowSums                         &sums)
    {
      const DualMap dual(face);
      for (const auto &shared : face.shared)
        {
          const Eigen::MatrixXd M    = dual(shared);
          const auto           &dofs = targets[shared.target].dofs;
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
      is_meshed ? integrals_of_all_faces(basis, sources, targets, comm)
                : integrals_of_whole_faces(basis, sources);
    if (is_meshed)
      check_covered(sources, integrals, where);

    MortarCoupling result;
    const auto nodes = number_nodes(sources, result.nodes, result.source_rows);
    result.weights.resize(result.nodes.size(), 0.);
    result.normals = nodal_normals(basis, sources, nodes, result.nodes.size());
    result.target_rows.resize(result.nodes.size());
    RowSums sums(result.nodes.size());
    for (std::size_t e = 0; e < sources.size(); ++e)
      {
        const Eigen::VectorXd areas = DualMap(integrals[e]).weights();
        for (std::size_t a = 0; a < nodes[e].size(); ++a)
          result.weights[nodes[e][a]] += areas[a];
        add_target_rows(d, targets, integrals[e], nodes[e], sums);
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
                         rounded_text(result.nodes[j][0], 6) + ", " +
                         rounded_text(result.nodes[j][1], 6) + ", " +
                         rounded_text(result.nodes[j][2], 6) + ") m");
    result.target_rows = target.rows;
    return result;
  }
} // namespace squeal
