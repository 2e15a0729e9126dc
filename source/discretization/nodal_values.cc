// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nodal_values.h"

namespace squeal
{
  Eigen::MatrixXd
  nodal_values(const Discretization &d, const Block &modes)
  {
    const Eigen::MatrixXd local = d.space()->gather(modes);
    Eigen::MatrixXd       result(d.relevant_dofs().n_elements(), modes.cols());
    for (int j = 0; j < modes.cols(); ++j)
      {
        const std::vector<double> column = d.expand(local.col(j));
        result.col(j) =
          Eigen::Map<const Eigen::VectorXd>(column.data(), column.size());
      }
    return result;
  }
} // namespace squeal
