// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_frequency_response_response_solution_h
#define squeal_analyses_frequency_response_response_solution_h

#include <squeal/model/measured_points.h>
#include <squeal/output/cea_quantities.h>
#include <squeal/results/table.h>
#include <squeal/run/run_context.h>

#include <string>
#include <vector>

namespace squeal
{
  /** Which points act and which are observed, and at which frequencies: the
   * same for all contact states. */
  struct ResponseGrid
  {
    explicit ResponseGrid(const Parameters &parameters);

    std::vector<unsigned int> excitations, responses; /**< places in the list */
    std::vector<double>       frequencies;            /**< Hz */
    bool                      is_even;

    /** (i omega)^n: from receptance to the quantity that is asked for. */
    std::complex<double> factor(const double frequency) const;
    std::string          quantity; /**< "receptance" */
    std::string          unit;     /**< "m/N" */

  private:
    unsigned int power;
  };

  /** A frequency at which the full problem was solved. */
  struct ResponseCheck
  {
    double           frequency; /**< Hz */
    Eigen::MatrixXcd exact, superposed;
    /** Largest difference over the largest exact value. */
    double error() const;
  };

  /** All that one contact state gives. */
  struct StateResponse
  {
    std::string                   state; /**< "full", "stick", "scene" */
    ComplexPairs                  pairs; /**< without their vectors */
    std::vector<ModeName>         names;
    std::vector<Eigen::MatrixXcd> values; /**< responses x excitations */
    /** residues[j](i, k): of excitation j, response i, pair k. */
    std::vector<Eigen::MatrixXcd> residues;
    Eigen::MatrixXcd              shapes; /**< all points x pairs */
    std::vector<ResponseCheck>    checks;
    Eigen::MatrixXd               mac;   /**< measured shapes x pairs */
    Eigen::VectorXd               comac; /**< of all points */
    unsigned int                  n_unknowns = 0;
    /** Eigenvalues do not come in conjugates, and superposition with them is
     * not exact however many modes it has. */
    bool has_loss_factors = false;

    /** Largest difference to direct solutions over the largest response at its
     * frequency. */
    double worst_check() const;
    /** Root mean square of every function, responses x excitations, over the
     * checked frequencies; NaN where it is rounding of the largest one. */
    Eigen::MatrixXd size_of_functions() const;
    /** The function that superposition is farthest off for its own size. */
    struct WorstFunction
    {
      double       error    = 0.; /**< over its root mean square */
      Eigen::Index response = 0, excitation = 0;
    };
    WorstFunction worst_function() const;
    /** Largest difference of a single value over that value, of functions that
     * are no rounding; far above the others next to an antiresonance. */
    double worst_value() const;
    /** Whether pair @p k has no damping but rounding: its own response at its
     * frequency has no bound. */
    bool is_undamped(const unsigned int k) const;
    /** Names of pairs with sigma > 0. */
    std::string unstable() const;
  };

  /**
   * Modes, superposition, residual terms, checks and MAC of @p parameters,
   * whose contact state is called @p state. Throws InputError for a scene that
   * can move freely.
   */
  StateResponse solve_response(const Parameters                 &parameters,
                               const std::string                &state,
                               const ResponseGrid               &grid,
                               const std::vector<MeasuredShape> &measured,
                               RunContext                       &context);

  /** frequency_response.csv. */
  Table response_table(const Parameters                 &parameters,
                       const ResponseGrid               &grid,
                       const std::vector<StateResponse> &states);
  /** mode_participation.csv. */
  Table participation_table(const Parameters                 &parameters,
                            const ResponseGrid               &grid,
                            const std::vector<StateResponse> &states);
  /** direct_check.csv. */
  Table response_check_table(const Parameters                 &parameters,
                             const ResponseGrid               &grid,
                             const std::vector<StateResponse> &states);
  /** comac.csv. */
  Table comac_table(const Parameters                 &parameters,
                    const std::vector<StateResponse> &states);

  /** mac.csv. */
  Table mac_table(const std::vector<MeasuredShape> &measured,
                  const std::vector<StateResponse> &states);

  /** frequency_response.h5. */
  void write_response_hdf5(const std::string                &path,
                           const Parameters                 &parameters,
                           const ResponseGrid               &grid,
                           const std::vector<StateResponse> &states);
  /** Universal file of one state: units, nodes, functions, shapes. */
  void write_response_universal(const std::string   &path,
                                const Parameters    &parameters,
                                const ResponseGrid  &grid,
                                const StateResponse &state);
} // namespace squeal

#endif
