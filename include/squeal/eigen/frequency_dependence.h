// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_frequency_dependence_h
#define squeal_eigen_frequency_dependence_h

#include <squeal/eigen/certified_solver.h>
#include <squeal/eigen/consistent_frequencies.h>

#include <functional>
#include <vector>

namespace squeal
{
  /**
   * Pairs of a reduced pencil whose coefficients depend on the frequency of the
   * pair: Q(lambda; omega) x = 0 with omega = Im lambda, none lost and none
   * double.
   *
   * At fixed omega the pencil is an ordinary one. Its eigenvalues in ascending
   * order of Im lambda are continuous functions of omega, each of which crosses
   * omega where a pair is consistent: between two frequencies as many times, up
   * and down counted apart, as the number of eigenvalues below them differs.
   *
   * The band is divided into windows. The pencil is solved at the middle of
   * each; in the space of the right vectors about it, tested with the left
   * ones, every order is followed to where it crosses. Each pair found is
   * improved by inverse iteration with its own pencil, the neighbours together,
   * so that doublets and coalescing pairs are no special case. The sum is
   * compared with the count at the ends of the band; where they differ there
   * are twice as many windows. For a larger basis the last pairs are the start
   * and only the count is repeated.
   */
  class FrequencyDependentPairs : public PairFinder
  {
  public:
    /** Coefficients of the parts at omega > 0, rad/s. */
    using Coefficients =
      std::function<std::vector<TermCoefficients>(const double)>;

    /** Pairs from @p lowest to @p highest, Hz, and 1 % beyond. */
    FrequencyDependentPairs(const Coefficients &coefficients,
                            const double        lowest,
                            const double        highest);

    /** Throws ComputationError where the count is not met in the end. */
    DensePairs solve(const std::vector<ReducedPart> &parts) override;
    bool       is_complete(const std::vector<ReducedPart> &parts) override;
    std::vector<TermCoefficients> coefficients(
      const std::complex<double> lambda) const override;

    /** Full searches so far. */
    unsigned int n_searches() const;

    /** From where on pairs are sought, Hz: @p lowest of the constructor, or a
     * thousandth of @p highest where that is more. */
    double lowest_frequency() const;

    /** The fastest growing motion below that, by the last basis and with the
     * moduli there, divergence included, 1/s; 0 where none grows. */
    std::complex<double> growth_below() const;

  private:
    /** Pairs with the sense in which each crosses. */
    struct Found
    {
      DensePairs       pairs;
      std::vector<int> sense;
      unsigned int
      size() const
      {
        return sense.size();
      }
    };

    Found search(const std::vector<ReducedPart> &parts);
    Found window(const std::vector<ReducedPart> &parts,
                 const double                    lower,
                 const double                    upper) const;
    /** Improves pairs together; false where they did not stay as many or their
     * residuals do not fall. */
    bool improve(const std::vector<ReducedPart> &parts, Found &found) const;
    bool follow(const std::vector<ReducedPart> &parts);
    int  count(const std::vector<ReducedPart> &parts) const;
    bool has_doubles() const;

    void look_below(const std::vector<ReducedPart> &parts);

    const Coefficients   at;
    std::complex<double> growth = 0.;     /**< growth_below() */
    const double         lowest, highest; /**< rad/s, with what lies beyond */
    Found                last;
    bool                 starts_anew = true;
    unsigned int         n_windows   = 0;
    unsigned int         searches    = 0;
  };
} // namespace squeal

#endif
