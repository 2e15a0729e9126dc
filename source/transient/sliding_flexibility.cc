// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sliding_flexibility.h"

namespace squeal
{
  SlidingFlexibility::SlidingFlexibility(const ContactNodes &nodes)
    : n_rows(3 * nodes.n_nodes())
  {
    for (const ContactPair &pair : nodes.pairs())
      for (unsigned int j = pair.first; j < pair.first + pair.n_nodes(); ++j)
        {
          solved.push_back(3 * j);
          if (pair.slides())
            sliding.push_back(j);
          else
            solved.insert(solved.end(), {3 * j + 1, 3 * j + 2});
        }
  }

  Eigen::MatrixXd
  SlidingFlexibility::forces() const
  {
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(n_rows, solved.size());
    for (std::size_t k = 0; k < solved.size(); ++k)
      unit(solved[k], k) = 1.;
    return unit;
  }

  Eigen::MatrixXd
  SlidingFlexibility::complete(const Eigen::MatrixXd &columns) const
  {
    Eigen::MatrixXd G          = Eigen::MatrixXd::Zero(n_rows, n_rows);
    G(Eigen::all, solved)      = columns;
    G(solved, Eigen::all)      = columns.transpose();
    const Eigen::MatrixXd both = columns(solved, Eigen::all);
    G(solved, solved)          = 0.5 * (both + both.transpose());
    for (const unsigned int i : sliding)
      for (const unsigned int j : sliding)
        for (const unsigned int along : {1, 2})
          G(3 * i + along, 3 * j + along) = G(3 * i, 3 * j);
    return G;
  }
} // namespace squeal
