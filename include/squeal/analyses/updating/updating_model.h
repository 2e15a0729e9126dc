// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_updating_updating_model_h
#define squeal_analyses_updating_updating_model_h

#include <squeal/model/measured_points.h>
#include <squeal/model/mode_solution.h>
#include <squeal/run/run_context.h>

#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /** One measured frequency. */
  struct MeasuredFrequency
  {
    std::string name;           /**< of the mode; may be empty */
    double      frequency = 0.; /**< Hz */
    double      weight    = 1.; /**< of its squared relative error */
  };

  /** Reads a CSV with the columns name, frequency_hz and weight. Throws
   * InputError "file:line: ..." for frequencies or weights that are not above
   * 0, and for a file without rows. */
  std::vector<MeasuredFrequency> read_measured_frequencies(
    const std::string &path);

  /** The model at one set of numbers, as far as the measurement sees it. */
  struct UpdatingEvaluation
  {
    Eigen::VectorXd logarithms;     /**< of the factors on the numbers */
    Eigen::VectorXd frequencies;    /**< Hz, one a measured frequency */
    Eigen::VectorXd residuals;      /**< sqrt(weight) (f / f_measured - 1) */
    Eigen::MatrixXd jacobian;       /**< d residuals / d logarithms */
    std::vector<std::string> names; /**< of the modes */
    Eigen::VectorXd mac; /**< with the modes at the last better point; 1 at the
                            start */
    /** With the measured shapes that the modes are paired with; empty where
     * they are paired by name. */
    Eigen::VectorXd mac_measured;

    /** Half the sum of squared residuals. */
    double objective() const;
  };

  /**
   * Frequencies of paired modes as functions of the numbers that are fitted:
   * each evaluation is a certified complex eigenvalue analysis, and each
   * derivative that of the eigenvalue by its left and right vector.
   */
  class UpdatingModel
  {
  public:
    /** Throws InputError for numbers that change the operators themselves or
     * nothing, for fewer frequencies than numbers, and for frequencies far
     * outside the band. */
    explicit UpdatingModel(RunContext &context);

    unsigned int                          n_numbers() const;
    const std::vector<MeasuredFrequency> &measured() const;
    const Model                          &model() const;

    /** Value of an entry of a number in the file. */
    double start_value(const unsigned int number,
                       const unsigned int entry = 0) const;
    /** Bounds of the logarithm of the factor. */
    double lower(const unsigned int number) const;
    double upper(const unsigned int number) const;

    /** Pairs by names or measured shapes the first time, by shapes later.
     * Throws InputError where a measured mode has no partner at the start. */
    UpdatingEvaluation evaluate(const Eigen::VectorXd &logarithms);

  private:
    std::vector<int> first_pairing(const ComplexPairs             &pairs,
                                   const std::vector<std::string> &names) const;
    std::vector<int> next_pairing(const Pencil       &pencil,
                                  const ComplexPairs &pairs,
                                  Eigen::VectorXd    &mac) const;
    /** MAC of each measured shape with the mode paired with it. */
    Eigen::VectorXd mac_of(const ComplexPairs &pairs) const;
    /** Warns of pairs that are alike by less than 'Minimum MAC'. */
    void warn_of_first(const UpdatingEvaluation &first) const;
    /** d lambda / d logarithms of the pairs: pairs x numbers. */
    Eigen::MatrixXcd       derivatives(const Pencil          &pencil,
                                       const ComplexPairs    &pairs,
                                       const Eigen::VectorXd &logarithms);
    const SceneParameters &scene(const Eigen::VectorXd &logarithms);

    RunContext                      &context;
    Parameters                       current;
    std::vector<MeasuredFrequency>   data;
    std::vector<MeasuredShape>       shapes; /**< one for each of data */
    std::unique_ptr<Model>           full;
    std::unique_ptr<MeasuredPoints>  points;
    std::unique_ptr<NumberSetter>    setter;
    std::vector<std::vector<double>> starts; /**< of all entries */
    bool                             is_first = true;
    double                           best     = 0.;
    ComplexBlock                     reference; /**< shapes at the best point */
  };

  /** What the fit says of one number. */
  struct FittedNumber
  {
    double start, value, lower, upper; /**< of the first entry */
    /** Ends of the confidence interval; NaN where the data do not say. */
    double interval_lower, interval_upper;
    double sensitivity; /**< norm of d residuals / d ln value */
    /** Whether the data hold nothing of it, and whether they say how well it is
     * known: neither where as many frequencies as numbers leave no error. */
    bool   is_unknown, is_identified;
    bool   is_at_bound;
    int    partner;     /**< number most correlated with it, or -1 */
    double correlation; /**< with that */
  };

  struct UpdatingFit
  {
    UpdatingEvaluation              first, best;
    std::vector<UpdatingEvaluation> history;
    std::vector<FittedNumber>       numbers;
    std::string                     ended; /**< why, in words */
    /** As many frequencies as numbers: nothing is left to tell the errors of
     * the data by. */
    bool has_no_spare  = false;
    bool has_converged = false;
  };

  /** Bounded least squares by NLopt (SLSQP) and its statistics. */
  UpdatingFit fit_numbers(UpdatingModel            &model,
                          const UpdatingParameters &parameters,
                          RunLog                   &log);
} // namespace squeal

#endif
