// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_analyses_sweep_stopping_change_h
#define squeal_source_analyses_sweep_stopping_change_h

#include <squeal/analyses/sweep/sweep_solution.h>

#include <optional>
#include <string>
#include <vector>

namespace squeal
{
  struct GrowingPair
  {
    double frequency, sigma; /**< Hz, 1/s */
  };

  /** The pair of the largest sigma, if there is any. */
  using WorstPair = std::optional<GrowingPair>;

  /** A pair that squealed before a number was changed and may leave the band as
   * it changes. */
  struct FollowedPair
  {
    double frequency = 0.; /**< Hz, where it was unstable last */
    double share     = 0.; /**< signed, of the change there */
  };

  /** The smallest change of one number in one direction that stops a squeal. */
  struct StoppingChange
  {
    unsigned int number = 0;
    std::string  entry;
    double       value = 0.; /**< as it stands, SI units */
    double       share = 0.; /**< signed; 0: none stabilises */
    WorstPair    worst;      /**< with it; nothing where no pair is left */
    double up_to = 0.; /**< share at which a pair is unstable again, or the
                            largest looked at */
    std::vector<FollowedPair> followed; /**< short of it */
    WorstPair                 tuned_in; /**< the worst other on the way */
    double                    tuned_in_at = 0.; /**< signed share */

    double
    new_value() const
    {
      return value * (1. + share);
    }
  };

  /** What a direct solution says of a change. */
  struct DirectAnswer
  {
    WorstPair worst;   /**< of the band and of the pairs that are followed */
    WorstPair outside; /**< what else grows among the pairs found */
    double    rounding = 0.; /**< a growth rate that may be nothing else, 1/s */

    bool
    is_stable() const
    {
      return !worst || worst->sigma <= rounding;
    }
  };

  /** The scene at the peak of a range with one number changed. */
  class ChangedScene
  {
  public:
    /** By a share of @p largest, below 1, at most. */
    ChangedScene(const SweepModel &model,
                 const PeakPair   &peak,
                 const double      largest);

    /** Unstable pairs and the @p worst with a number multiplied by
     * 1 + @p share: of the band, and of those that are followed beyond it. */
    std::vector<GrowingPair> unstable(const unsigned int               number,
                                      const double                     share,
                                      const std::vector<FollowedPair> &followed,
                                      WorstPair &worst) const;

    DirectAnswer solve_directly(const StoppingChange &change) const;

  private:
    bool         is_in_band(const double frequency) const;
    double       rounding() const; /**< as that of the answer */
    SweepPoint   place(const unsigned int number, const double factor) const;
    ComplexPairs solve(const unsigned int number, const double factor) const;

    const SweepModel &model;
    const PeakPair   &peak;
    Band              wide; /**< what a pair of the band may reach */
  };

  /** Raises (@p sign 1) or lowers (-1) a number by a share of @p largest at most
   * until nothing squeals, and on until something does again. */
  StoppingChange smallest_change(const ChangedScene &scene,
                                 const Influence    &influence,
                                 const double        largest,
                                 const double        sign);
} // namespace squeal

#endif
