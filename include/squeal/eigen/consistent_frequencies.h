// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_consistent_frequencies_h
#define squeal_eigen_consistent_frequencies_h

#include <squeal/eigen/dense_quadratic.h>

#include <functional>
#include <vector>

namespace squeal
{
  /**
   * A pencil whose coefficients depend on frequency, in the small space of some
   * right vectors X and tested with as many left ones Y: Y^T A X of every part.
   */
  class LocalPencil
  {
  public:
    LocalPencil(
      const std::vector<ReducedPart>                                   &parts,
      const Eigen::MatrixXcd                                           &X,
      const Eigen::MatrixXcd                                           &Y,
      const std::function<std::vector<TermCoefficients>(const double)> &at);

    /** A pair with omega = Im lambda. */
    struct Pair
    {
      std::complex<double> lambda;
      Eigen::VectorXcd     right, left; /**< in the vectors X and Y */
      int sense; /**< 1: its order comes from above omega, -1: from below */
    };

    /** The consistent pairs between two frequencies, rad/s, ascending: where
     * the k-th of the eigenvalues in the order of Im lambda crosses omega, for
     * every k; once each, which ModulusTable sees to. */
    std::vector<Pair> pairs_between(const double lower,
                                    const double upper) const;

  private:
    /** Pairs at one frequency with Im lambda > 0, descending. */
    DensePairs at_frequency(const double omega) const;
    double     crossing(const Eigen::Index order,
                        const double       lower,
                        const double       upper,
                        const double       at_lower,
                        const double       at_upper) const;

    std::vector<Eigen::MatrixXcd>                              projected;
    std::function<std::vector<TermCoefficients>(const double)> coefficients;
  };
} // namespace squeal

#endif
