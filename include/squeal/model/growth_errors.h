// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_growth_errors_h
#define squeal_model_growth_errors_h

#include <squeal/model/pair_errors.h>

namespace squeal
{
  class RunLog;
  class SecondSolutions;
  class Timers;

  /** Whether pair @p k grows by more than what the solver and rounding leave of
   * a growth rate of 0. */
  bool grows(const ComplexPairs &pairs, const unsigned int k);

  /** Pairs of a coarser model of the same coarse mesh. */
  struct CoarserPairs
  {
    Eigen::VectorXcd lambda;
    Eigen::MatrixXcd
      shapes; /**< at the corners of the coarse mesh, of norm 1 */
  };

  /** Those of @p model, for a finer one. */
  CoarserPairs coarser_pairs(const Model &model, const ComplexPairs &pairs);

  /**
   * Errors of the growth rates of the pairs that grow, from those of a second
   * solution, that of a coarser mesh or of the same mesh with one degree less.
   *
   * The growth rate of two modes that lock in hangs on the small difference of
   * what the mesh does to the one and to the other. Estimates of cells know
   * each to some five percent, which is far more than their difference; two
   * solutions know the difference itself. What the finer one has changed,
   * sigma_h - sigma_H, has the same sign as what is left, and is longer by the
   * factor that the frequency of the pair tells, whose error the cells do know:
   *
   *   sigma - sigma_h = (sigma_h - sigma_H) |f - f_h| / |f_h - f_H|,
   *
   * where the ratio is kept between @p least_ratio and 1: below, the frequency
   * hardly moves and says nothing; above, the solutions do not converge yet.
   * Where the frequency has moved against what its cells say is left, the two
   * solutions differ in more than their meshes, as contact states do that are
   * found anew: all of the change may be left, of the frequency as well.
   * The error is no smaller than twice that of the frequency, both relative:
   * the lowest degrees are far from converging, and their growth rates may be
   * alike by chance (doc/verification.md has pairs with 2.3 to 3 times it).
   *
   * A pair is found again by its shape at the corners of the coarse mesh
   * (squared cosine): of the coarser pairs that share 0.3 of it and 0.6 of what
   * the most alike does, the one that grows fastest.
   *
   * @param pairs  right vectors are used
   * @param errors of the pairs, for the frequencies
   * @return of lambda, 1/s, one a pair: NaN for those that do not grow, see
   * grows(), or are not found again. Of bodies that hardly
   * change their volume those of
   * @p errors, see pair_errors_with_locking().
   */
  Eigen::VectorXcd growth_errors(const Model        &model,
                                 const ComplexPairs &pairs,
                                 const PairErrors   &errors,
                                 const CoarserPairs &coarser,
                                 const double        least_ratio);

  /** The error @p growth of the growth rate of @p lambda, 1/s, no smaller than
   * twice that of its frequency, @p frequency in rad/s, both relative. */
  double at_least_by_frequency(const double               growth,
                               const double               frequency,
                               const std::complex<double> lambda);

  /** By one degree less, solved by @p second, with a ratio of at least 1/10; with
   * linear elements there, whose errors are tens of times larger, 1/100. Pairs
   * that linear elements do not have within 0.15 of their frequency are sought
   * again up to 2.5 times it, with a ratio of at least 1/6. NaN for all where
   * the degree is 1. */
  Eigen::VectorXcd growth_errors_by_lower_degree(const Model        &model,
                                                 const ComplexPairs &pairs,
                                                 const PairErrors   &errors,
                                                 SecondSolutions    &second,
                                                 Timers             &timers);

  /**
   * pair_mesh_errors(), and where a body hardly changes its volume, so that its
   * cells do not know the errors of the pairs, in the place of those what a
   * solution of the same mesh with one degree more changes, times (p + 1)/2, as
   * errors_by_next_degree() of the modes. The shares of the cells stay.
   *
   * A pair is found again by its shape as in growth_errors(), one that does not
   * grow by the largest likeness. Errors that are not known are NaN, and @p log
   * warns of them.
   */
  PairErrors pair_errors_with_locking(const Model        &model,
                                      const Pencil       &pencil,
                                      const ComplexPairs &pairs,
                                      RunLog             &log,
                                      Timers             &timers);
} // namespace squeal

#endif
