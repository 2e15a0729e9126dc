// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_slow_part_h
#define squeal_transient_slow_part_h

#include <vector>

namespace squeal
{
  /** Consecutive values of a signal at equal distances, without the values. */
  struct SignalPiece
  {
    double n    = 0.; /**< number of values */
    double mean = 0.;
    /** Sum of the values less their mean, times their numbers in the piece. */
    double moment = 0.;
    double square = 0.; /**< sum of the squares of the values less their mean */
  };

  /** Degree of the polynomial that a signal of many periods drifts along. Of a
   * line with n periods it takes a share of the power of 70 / (pi n)^2 at most,
   * which is a hundredth at 27 periods. */
  constexpr unsigned int slow_degree = 5;

  /**
   * What a signal vibrates by while it drifts: roots of the mean squares about
   * the polynomial of @p degree that is nearest to the whole signal, which is
   * taken as straight within each of its @p pieces.
   *
   * @param pieces    one after another
   * @param n_groups  which the pieces are cut into, a whole number of pieces in
   *                  each
   * @return one value for each group, in the unit of the signal; 0 for a group
   *         without values
   */
  std::vector<double> rms_beside_slow_part(
    const std::vector<SignalPiece> &pieces,
    const unsigned int              n_groups,
    const unsigned int              degree = slow_degree);

  /** The values of @p signal less the polynomial of @p degree that is nearest
   * to them; of a lower one where there are fewer than eight values for each
   * coefficient. */
  std::vector<double> without_slow_part(
    const std::vector<double> &signal,
    const unsigned int         degree = slow_degree);
} // namespace squeal

#endif
