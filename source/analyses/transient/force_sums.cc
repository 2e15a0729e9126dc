// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/force_sums.h>
#include <squeal/contact/contact_resultant.h>
#include <squeal/contact/pressure_moments.h>
#include <squeal/contact/summed_pairs.h>

#include <array>
#include <cmath>

namespace squeal
{
  namespace
  {
    void
    set_moments(const Eigen::Vector2d &moments, StepSums &sums)
    {
      sums.first_moment  = moments[0];
      sums.second_moment = moments[1];
    }
  } // namespace



  ForceSums::ForceSums(const ContactNodes &nodes)
  {
    all                  = Eigen::MatrixXd::Zero(3 * nodes.n_nodes(), 6);
    double         area  = 0.;
    Eigen::Array2d edges = Eigen::Array2d::Zero(); // leading and trailing
    for (const ContactPair &pair : nodes.pairs())
      {
        const Eigen::MatrixXd both = sum_rows(pair.geometry);
        Eigen::MatrixXd rows = resultant_rows(pair.geometry).bottomRows<2>();
        // Pressure on a curved face has a part along the mean sliding, too.
        if (!is_flat(pair.geometry))
          rows.row(0) = both.row(1);
        pairs.push_back({3 * static_cast<Eigen::Index>(pair.first),
                         rows,
                         pressure_moments(pair.geometry).rows});
        if (!is_summed(nodes, pair))
          continue;
        all.block(3 * pair.first, 4, 3 * pair.n_nodes(), 2) = both.transpose();
        all.block(3 * pair.first, 0, 3 * pair.n_nodes(), 2) = rows.transpose();
        const std::array<std::vector<bool>, 2> is_at        = {
                 {leading_edge(pair.geometry), trailing_edge(pair.geometry)}};
        for (std::size_t j = 0; j < pair.n_nodes(); ++j)
          {
            area += pair.geometry.areas[j];
            for (unsigned int e = 0; e < 2; ++e)
              if (is_at[e][j])
                {
                  edges[e] += pair.geometry.areas[j];
                  all(3 * (pair.first + j), 2 + e) = 1.;
                }
          }
      }
    // Not known where no pair has such an edge.
    for (unsigned int e = 0; e < 2; ++e)
      all.col(2 + e) *=
        edges[e] > 0. ? area / edges[e] : std::nan("no edge of that kind");
  }



  StepSums
  ForceSums::of(const Eigen::VectorXd &forces, const bool backwards) const
  {
    const Eigen::VectorXd sums = all.transpose() * forces;
    StepSums              now;
    now.tangential = sums[0];
    now.normal     = sums[1];
    now.edge       = backwards ? sums[3] : sums[2];
    now.pressing   = sums[4];
    now.friction   = sums[5];
    if (pairs.size() == 1)
      set_moments(moments(0, forces), now);
    return now;
  }

  Eigen::Vector2d
  ForceSums::moments(const std::size_t i, const Eigen::VectorXd &forces) const
  {
    return pairs[i].moments *
           forces.segment(pairs[i].first, pairs[i].moments.cols());
  }

  std::vector<StepSums>
  ForceSums::of_pairs(const Eigen::VectorXd &forces) const
  {
    std::vector<StepSums> result(pairs.size() > 1 ? pairs.size() : 0);
    for (std::size_t i = 0; i < result.size(); ++i)
      {
        const Eigen::Vector2d sum =
          pairs[i].rows * forces.segment(pairs[i].first, pairs[i].rows.cols());
        result[i].tangential = sum[0];
        result[i].normal     = sum[1];
        set_moments(moments(i, forces), result[i]);
      }
    return result;
  }
} // namespace squeal
