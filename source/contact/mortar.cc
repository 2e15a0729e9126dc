// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/contact/mortar.h>
#include <squeal/contact/mortar_integrals.h>
#include <squeal/discretization/face_quadrature.h>

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <map>

namespace squeal
{
  namespace
  {
    constexpr unsigned int ground = -1u;

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

    /** Of the target nodes that the source faces round a source node meet:
     * their weights, moments of their places with these weights, and the place
     * that int psi phi takes. */
    struct Moments
    {
      double          weight = 0.;
      Eigen::Vector3d first  = Eigen::Vector3d::Zero();
      Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
      Eigen::Vector3d place  = Eigen::Vector3d::Zero();
    };

    Eigen::Vector3d
    vector(const dealii::Tensor<1, 3> &x)
    {
      return {x[0], x[1], x[2]};
    }

    /** The matrix of v x. */
    Eigen::Matrix3d
    cross(const Eigen::Vector3d &v)
    {
      Eigen::Matrix3d result;
      result << 0., -v[2], v[1], v[2], 0., -v[0], -v[1], v[0], 0.;
      return result;
    }

    /** The shares int psi_j phi_b of this rank's target nodes, one by one, and
     * the weights sum_a |int phi_a phi_b|, the same for all nodes of a source
     * face: where nodes match, a single share is not 0. */
    class TargetShares
    {
    public:
      TargetShares(const Discretization                         &d,
                   const std::vector<TargetFace>                &targets,
                   const std::vector<SourceIntegrals>           &integrals,
                   const std::vector<std::vector<unsigned int>> &nodes)
        : d(d)
        , targets(targets)
        , integrals(integrals)
        , nodes(nodes)
      {
      }

      /** Calls @p visit(source node, share, weight, place, degrees of freedom).
       */
      template <typename Visit>
      void
      visit(const Visit &visit) const
      {
        for (std::size_t e = 0; e < integrals.size(); ++e)
          {
            const DualMap dual(integrals[e]);
            for (const auto &shared : integrals[e].shared)
              {
                const Eigen::MatrixXd M = dual(shared);
                const Eigen::VectorXd weights =
                  shared.products.cwiseAbs().colwise().sum();
                const TargetFace &target = targets[shared.target];
                for (Eigen::Index b = 0; b < M.cols(); ++b)
                  for (Eigen::Index a = 0; a < M.rows(); ++a)
                    visit(nodes[e][a],
                          M(a, b),
                          weights[b],
                          vector(target.geometry.nodes()[b]),
                          target.dofs[b]);
              }
          }
      }

      /** Of all ranks. */
      std::vector<Moments>
      moments(const std::size_t n_nodes) const
      {
        const unsigned int  n = 16;
        std::vector<double> sums(n * n_nodes, 0.);
        visit([&](const unsigned int     j,
                  const double           share,
                  const double           w,
                  const Eigen::Vector3d &x,
                  const auto &) {
          double *s = &sums[n * j];
          s[0] += w;
          Eigen::Map<Eigen::Vector3d>(s + 1) += w * x;
          Eigen::Map<Eigen::Vector3d>(s + 4) += share * x;
          Eigen::Map<Eigen::Matrix3d>(s + 7) += w * x * x.transpose();
        });
        MPI_Allreduce(MPI_IN_PLACE,
                      sums.data(),
                      static_cast<int>(sums.size()),
                      MPI_DOUBLE,
                      MPI_SUM,
                      d.space()->communicator());
        std::vector<Moments> result(n_nodes);
        for (std::size_t j = 0; j < n_nodes; ++j)
          {
            const double *s  = &sums[n * j];
            result[j].weight = s[0];
            result[j].first  = Eigen::Map<const Eigen::Vector3d>(s + 1);
            result[j].place  = Eigen::Map<const Eigen::Vector3d>(s + 4);
            result[j].second = Eigen::Map<const Eigen::Matrix3d>(s + 7);
          }
        return result;
      }

      const Combination &
      expansion(const dealii::types::global_dof_index dof) const
      {
        return d.expansion(dof);
      }

    private:
      const Discretization                         &d;
      const std::vector<TargetFace>                &targets;
      const std::vector<SourceIntegrals>           &integrals;
      const std::vector<std::vector<unsigned int>> &nodes;
    };

    /** Adds omega x (x - X) to the rows, see make_tie_coupling(). With r from
     * the weighted mean of the target nodes, omega = I^-1 sum w r x u. */
    void
    add_rotations(const TargetShares         &shares,
                  const std::vector<Moments> &moments,
                  MortarCoupling             &m,
                  RowSums                    &sums)
    {
      std::vector<Eigen::Matrix3d> factor(m.nodes.size());
      std::vector<Eigen::Vector3d> centre(m.nodes.size());
      std::vector<bool>            is_carried(m.nodes.size());
      for (std::size_t j = 0; j < m.nodes.size(); ++j)
        {
          const Moments        &t = moments[j];
          const Eigen::Vector3d arm =
            vector(m.nodes[j]) - t.place / m.weights[j];
          m.distance    = std::max(m.distance, arm.norm());
          is_carried[j] = arm.norm() > 1e-9 * std::sqrt(m.weights[j]);
          centre[j]     = t.first / t.weight;
          const Eigen::Matrix3d spread =
            t.second / t.weight - centre[j] * centre[j].transpose();
          const Eigen::Matrix3d inertia =
            spread.trace() * Eigen::Matrix3d::Identity() - spread;
          factor[j] = -m.weights[j] / t.weight * cross(arm) * inertia.inverse();
        }
      shares.visit([&](const unsigned int j,
                       const double,
                       const double           w,
                       const Eigen::Vector3d &x,
                       const auto            &dofs) {
        if (!is_carried[j])
          return;
        const Eigen::Matrix3d C = w * factor[j] * cross(x - centre[j]);
        for (unsigned int c = 0; c < 3; ++c)
          for (unsigned int k = 0; k < 3; ++k)
            for (const auto &[row, weight] : shares.expansion(dofs[k]))
              sums[j][c][row] += C(c, k) * weight;
      });
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



  namespace
  {
    /** The pieces between nodes of faces whose nodes have these numbers, in the
     * order of @p basis. */
    std::vector<std::array<unsigned int, 4>>
    quads_between(const FaceBasis                              &basis,
                  const std::vector<std::vector<unsigned int>> &nodes)
    {
      const unsigned int                       p = basis.degree();
      std::vector<std::array<unsigned int, 4>> quads;
      for (const auto &face : nodes)
        for (unsigned int j = 0; j < p; ++j)
          for (unsigned int i = 0; i < p; ++i)
            {
              const unsigned int first = i + (p + 1) * j;
              quads.push_back({{face[first],
                                face[first + 1],
                                face[first + p + 2],
                                face[first + p + 1]}});
            }
      return quads;
    }



    MortarCoupling
    make_coupling(const Discretization &d,
                  const PointEvaluator &evaluator,
                  const unsigned int    source_face_id,
                  const unsigned int    target_body,
                  const std::string    &where,
                  const bool            carries)
    {
      const MeetingLimits limits = carries ? limits_of_meshes : MeetingLimits();
      const MPI_Comm      comm   = d.space()->communicator();
      const FaceBasis     basis(d.degree());
      const auto sources = source_faces(d, basis, source_face_id, where);
      const bool is_meshed =
        target_body != ground &&
        d.scene().bodies[target_body].shape != BodyParameters::Shape::rigid;
      std::vector<TargetFace> targets;
      if (is_meshed && !sources.empty())
        targets = target_faces(d, basis, target_body, bounding_box(sources));
      const auto integrals =
        is_meshed
          ? integrals_of_all_faces(basis, sources, targets, limits, comm)
          : integrals_of_whole_faces(basis, sources);
      if (is_meshed)
        check_covered(sources, integrals, where, limits);

      MortarCoupling result;
      const auto     nodes =
        number_nodes(sources, result.nodes, result.source_rows);
      result.quads = quads_between(basis, nodes);
      result.weights.resize(result.nodes.size(), 0.);
      result.normals =
        nodal_normals(basis, sources, nodes, result.nodes.size());
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
        for (const auto &face : integrals)
          result.beside = std::max(result.beside, std::abs(1. - face.covered));
      if (is_meshed && carries)
        {
          const TargetShares shares(d, targets, integrals, nodes);
          add_rotations(
            shares, shares.moments(result.nodes.size()), result, sums);
        }
      if (is_meshed)
        gather_rows(sums, comm, result);
      else if (target_body != ground)
        // A rigid motion is linear: int psi_j u = D_j u(x_j).
        result.target_rows =
          evaluator.displacements(target_body, result.nodes).rows;
      return result;
    }
  } // namespace



  MortarCoupling
  make_mortar_coupling(const Discretization &d,
                       const PointEvaluator &evaluator,
                       const unsigned int    source_face_id,
                       const unsigned int    target_body,
                       const std::string    &where)
  {
    return make_coupling(
      d, evaluator, source_face_id, target_body, where, false);
  }

  MortarCoupling
  make_tie_coupling(const Discretization &d,
                    const PointEvaluator &evaluator,
                    const unsigned int    tie)
  {
    const auto &scene = d.scene();
    const auto &t     = scene.ties[tie];
    return make_coupling(
      d,
      evaluator,
      face_id(d.coarse_mesh(), scene, t.source_body, t.source_face),
      body_index(scene, t.target_body),
      "Scene/Tie " + t.name,
      true);
  }

  std::vector<std::string>
  remarks_on_ties(const Discretization &d)
  {
    std::vector<std::string> remarks;
    const auto              &ties = d.scene().ties;
    if (std::count(d.coarse_mesh().tie_is_conforming.begin(),
                   d.coarse_mesh().tie_is_conforming.end(),
                   false) == 0)
      return remarks;
    const PointEvaluator evaluator(d);
    for (unsigned int i = 0; i < ties.size(); ++i)
      if (!d.coarse_mesh().tie_is_conforming[i])
        {
          const auto   tie = make_tie_coupling(d, evaluator, i);
          const double area =
            *std::max_element(tie.weights.begin(), tie.weights.end());
          if (tie.distance > 1e-6 * std::sqrt(area) || tie.beside > 1e-6)
            remarks.push_back(
              "tie " + ties[i].name +
              ": the two meshes of the face differ, by " +
              rounded_text(1e3 * tie.distance, 3) + " mm at most, and up to " +
              rounded_text(100. * tie.beside, 3) +
              " % of a cell's face lies beside the other: rigid motions pass "
              "exactly, stiffness as between these meshes");
        }
    return remarks;
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
