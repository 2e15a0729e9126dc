// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_sweep_continued_h
#define squeal_tests_sweep_continued_h

#include <squeal/sweep/exceptional_point.h>

namespace squeal
{
  namespace testing
  {
    /** A problem whose matrices @p at are known at every complex coordinate and
     * whose vectors are those of the pairs. */
    template <typename Function>
    Continuation
    continued(const Function &at)
    {
      return [at](const double x) {
        const Eigen::Index n = at(x).mass.rows();
        return std::vector<ContinuedPencil>{
          {[at](const std::complex<double> z) {
             return std::optional<ContinuedMatrices>(at(z));
           },
           Eigen::MatrixXd::Identity(n, n)}};
      };
    }
  } // namespace testing
} // namespace squeal

#endif
