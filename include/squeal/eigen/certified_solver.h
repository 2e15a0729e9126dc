// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_certified_solver_h
#define squeal_eigen_certified_solver_h

#include <squeal/eigen/complex_pairs.h>
#include <squeal/eigen/reduced_basis.h>
#include <squeal/eigen/sliding_inverse.h>

#include <functional>
#include <memory>
#include <vector>

namespace squeal
{
  struct CertifiedOptions
  {
    double       lowest_frequency    = 0.;   /**< Hz */
    double       highest_frequency   = 20e3; /**< Hz */
    double       residual_tolerance  = 1e-8;
    double       error_tolerance     = 1e-8; /**< |d lambda| / |lambda| */
    unsigned int maximum_enrichments = 30;
  };

  /**
   * Finds the pairs of a reduced pencil whose coefficients are not the same for
   * all of them.
   */
  class PairFinder
  {
  public:
    virtual ~PairFinder() = default;

    /** Right and left vectors of the pairs in the band and a little beyond it,
     * one of each conjugate pair; in @p parts the pencil at one frequency. To
     * be called again for bases that hold the last one. */
    virtual DensePairs solve(const std::vector<ReducedPart> &parts) = 0;

    /** Whether what the last solve() has found for these parts is all there is.
     * If not, the next solve() starts anew. */
    virtual bool is_complete(const std::vector<ReducedPart> &parts) = 0;

    /** The coefficients of the parts of a pair. */
    virtual std::vector<TermCoefficients> coefficients(
      const std::complex<double> lambda) const = 0;
  };

  /** One row of the convergence history of the basis. */
  struct BasisEnrichment
  {
    unsigned int basis_size;
    double       worst_residual;
    double       worst_estimate; /**< of this basis, from the next one */
  };

  /**
   * The complex eigenvalue analysis in a certified reduced space.
   *
   * The space starts from the undamped modes below sqrt(2) times the shift
   * frequency. Every pair is lifted and its full residual evaluated; the
   * residuals of right and left vectors, compressed and solved with the one
   * real factor at hand and friction as its low-rank change, enrich the space,
   * until residual and error estimate of every pair in the band are below the
   * tolerances or at the rounding floor. The error of a pair is the change of
   * lambda by the next enrichment: it holds an adjoint part outside the space,
   * without which the estimate would vanish identically (y^T r = 0 for y in the
   * space). A space whose last growth changed no eigenvalue by more than 1e-11
   * takes that change as the bound of what is left. Nearly coalesced pairs are
   * compared by mean and squared half-difference, which depend smoothly on
   * perturbations.
   *
   * Where the moduli follow the frequency of each pair, a PairFinder takes the
   * place of the dense solver; residuals and estimates are of the coefficients
   * of every pair.
   */
  class CertifiedSolver
  {
  public:
    CertifiedSolver(const Pencil         &pencil,
                    const ShiftedInverse &inverse,
                    const UndampedModes  &modes,
                    PairFinder           *finder   = nullptr,
                    const BasisProducts   products = BasisProducts::kept);

    /** Of a pencil that differs from that of @p other, which must live as long,
     * in the strength of its non-symmetric terms alone: with its factor and
     * friction responses. The space starts from the undamped modes, which both
     * have in common, and from the right and left vectors of @p pairs of the
     * other pencil: friction of the opposite sign about exchanges them. */
    CertifiedSolver(const Pencil          &pencil,
                    const CertifiedSolver &other,
                    const UndampedModes   &modes,
                    const ComplexPairs    &pairs);

    /** Adds directions to the space before it is solved in. */
    void extend(const Block &directions);

    /** Lets every enrichment answer the residuals with the frictionless inverse
     * of other moduli, too; it is kept. One inverse alone would take a round
     * for each part that the moduli of a pair are away from its own. */
    void answer_with(std::shared_ptr<const ShiftedInverse> other);

    /** To be called once. The pairs that is_of_band() tells (real eigenvalues
     * where the band starts at 0). Throws ComputationError where the tolerance
     * is not met within the allowed enrichments; where that is so of pairs that
     * grow beyond the band, these are left out first (growth_left_out()), and
     * the others are tried without them. */
    ComplexPairs solve(
      const CertifiedOptions                             &options,
      const std::function<void(const BasisEnrichment &)> &report = {});

    const std::vector<BasisEnrichment> &history() const;
    const ReducedBasis                 &basis() const;

    /** After solve(), without a PairFinder: the eigenvalue of the last space
     * whose frequency is below the band and whose real part is the largest,
     * 1/s; real where it diverges. 0 where none grows by more than rounding,
     * 1e-4 of the upper edge of the band. It is not certified. */
    std::complex<double> growth_below_band() const;

    /** After solve(): of the pairs that grow beyond the band
     * (grows_beyond_band()) and are left out since no basis certifies them, the
     * one of the largest real part, 1/s; 0 where none is left out. */
    std::complex<double> growth_left_out() const;

  private:
    /** Pairs of the band with their coordinates in the basis. */
    struct Candidates
    {
      ComplexPairs     pairs;
      Eigen::MatrixXcd right, left;
    };
    Candidates candidates(const DensePairs       &dense,
                          const CertifiedOptions &options) const;

    struct Residuals
    {
      PairResiduals right, left; /**< left where it is still needed */
      bool          met;         /**< all right ones below the tolerance */
    };

    DensePairs solve_reduced();
    void       look_below_band(const DensePairs       &dense,
                               const CertifiedOptions &options);
    /** Leaves out from now on what grows beyond the band, whose highest
     * frequency is in Hz; false where there is nothing more to leave out. */
    bool leave_out_growth(const ComplexPairs &pairs, const double highest);
    /** Of the parts for every pair. */
    std::vector<std::vector<TermCoefficients>> coefficients(
      const Eigen::VectorXcd &lambda) const;

    /** Fills in the residuals of the pairs. */
    Residuals evaluate_residuals(Candidates             &candidates,
                                 const CertifiedOptions &options);

    /** Adds what the residuals ask for, whose vectors are freed; returns how
     * many vectors were new. */
    unsigned int enrich(const ComplexPairs     &pairs,
                        Residuals             &&residuals,
                        const CertifiedOptions &options);

    const Pencil        &pencil;
    const SlidingInverse inverse;
    PairFinder          *finder;
    /** Of other moduli. */
    std::vector<std::shared_ptr<const ShiftedInverse>> others;
    ReducedBasis                                       reduced;
    /** || |K| |x| || of the pairs, in units of the modes' scaling; vectors of
     * one scene hardly change it from one basis to the next. */
    Eigen::VectorXd              rounding_sizes;
    bool                         left_met     = false;
    std::complex<double>         growth_below = 0., growth_not_certified = 0.;
    std::vector<BasisEnrichment> steps;
  };

  /** Fills error_estimate of @p pairs from the eigenvalues of a better basis;
   * also finds the partners of nearly coalesced ones. */
  void estimate_errors(ComplexPairs &pairs, const Eigen::VectorXcd &better);
} // namespace squeal

#endif
