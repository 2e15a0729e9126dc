// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/cycle/active_contact.h>

namespace squeal
{
  ActiveContact::ActiveContact(const std::vector<int> &rows,
                               const unsigned int      n_nodes)
    : weight_before(Eigen::VectorXd::Ones(n_nodes))
    , weight_after(weight_before)
  {
    for (const int row : rows)
      unknowns.push_back({static_cast<unsigned int>(row / 3),
                          Eigen::Vector3d::Unit(row % 3),
                          Eigen::Vector3d::Unit(row % 3),
                          0.,
                          false});
  }

  ActiveContact::ActiveContact(const std::vector<ContactStatus> &status,
                               const Eigen::VectorXd            &forces,
                               const Eigen::VectorXd            &slip,
                               const Eigen::VectorXd            &friction)
    : weight_before(Eigen::VectorXd::Ones(status.size()))
    , weight_after(weight_before)
  {
    for (unsigned int j = 0; j < status.size(); ++j)
      switch (status[j])
        {
        case ContactStatus::open:
          break;
        case ContactStatus::stick:
          for (unsigned int c = 0; c < 3; ++c)
            unknowns.push_back({j,
                                Eigen::Vector3d::Unit(c),
                                Eigen::Vector3d::Unit(c),
                                0.,
                                c > 0});
          break;
        case ContactStatus::slip:
          add_slipping(
            j, forces[3 * j], slip.segment<2>(3 * j + 1), friction[j]);
          break;
        }
  }

  void
  ActiveContact::add_slipping(const unsigned int     j,
                              const double           normal,
                              const Eigen::Vector2d &slip,
                              const double           mu)
  {
    const double          size = slip.norm();
    const Eigen::Vector2d d =
      size > 0. ? Eigen::Vector2d(slip / size) : Eigen::Vector2d(1., 0.);
    unknowns.push_back(
      {j, {1., mu * d[0], mu * d[1]}, Eigen::Vector3d::Unit(0), 0., false});
    if (mu > 0. && normal > 0.)
      unknowns.push_back(
        {j, {0., -d[1], d[0]}, {0., -d[1], d[0]}, size / (mu * normal), true});
  }

  void
  ActiveContact::locate(const ChangesInStep              &changes,
                        const std::vector<ContactStatus> &status,
                        const Eigen::MatrixXd            &flexibility)
  {
    std::vector<std::pair<unsigned int, double>> changed;
    for (unsigned int j = 0; j < status.size(); ++j)
      if (const auto share = changes.share(j, status[j]))
        {
          changed.emplace_back(j, *share);
          if (const double at = changes.origin(j).share;
              at > 0. && status[j] != ContactStatus::open)
            origins.push_back({j, at, changes.slip_over_gap(j)});
        }
    if (changed.empty())
      return;
    for (unsigned int j = 0; j < status.size(); ++j)
      {
        // Where several nodes change, each share counts by how much its node
        // moves this one.
        double sum = 0., weight = 0.;
        for (const auto &[k, share] : changed)
          {
            const double w =
              k == j ? 1e6
                     : flexibility.block<3, 3>(3 * j, 3 * k).squaredNorm() /
                         flexibility.block<3, 3>(3 * k, 3 * k).squaredNorm();
            sum += w * share;
            weight += w;
          }
        const double share = weight > 0. ? sum / weight : .5;
        weight_before[j]   = 2. * share;
        weight_after[j]    = 2. * (1. - share);
      }
  }



  Eigen::MatrixXd
  ActiveContact::times_forces(const Eigen::MatrixXd &A) const
  {
    Eigen::MatrixXd result(A.rows(), size());
    for (Eigen::Index i = 0; i < size(); ++i)
      result.col(i) = A.middleCols<3>(3 * unknowns[i].node) * unknowns[i].force;
    return result;
  }

  Eigen::MatrixXd
  ActiveContact::rows_of(const Eigen::MatrixXd &A) const
  {
    Eigen::MatrixXd result(size(), A.cols());
    for (Eigen::Index i = 0; i < size(); ++i)
      result.row(i) =
        unknowns[i].row.transpose() * A.middleRows<3>(3 * unknowns[i].node);
    return result;
  }

  Eigen::VectorXd
  ActiveContact::row_of_forces(const unsigned int     node,
                               const Eigen::Vector3d &row) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(size());
    for (Eigen::Index i = 0; i < size(); ++i)
      if (unknowns[i].node == node)
        result[i] = row.dot(unknowns[i].force);
    return result;
  }

  Eigen::MatrixXd
  ActiveContact::forces(const Eigen::MatrixXd &x) const
  {
    Eigen::MatrixXd result =
      Eigen::MatrixXd::Zero(3 * weight_before.size(), x.cols());
    for (Eigen::Index i = 0; i < size(); ++i)
      result.middleRows<3>(3 * unknowns[i].node) +=
        unknowns[i].force * x.row(i);
    return result;
  }
} // namespace squeal
