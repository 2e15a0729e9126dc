// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_analysis_parameters_h
#define squeal_parameters_analysis_parameters_h

#include <string>
#include <vector>

namespace squeal
{
  /** Finite element space and mesh adaptation, section "Discretization". */
  struct DiscretizationParameters
  {
    enum class Refinement
    {
      none,
      uniform,          /**< `refinements` global steps */
      eigenvalue_error, /**< adaptive, driven by the modes in the band */
      contact_error /**< adaptive, driven by the growth rates of the pairs */
    };
    enum class Mass
    {
      consistent,
      lumped /**< diagonal, by collocation at the Gauss-Lobatto nodes */
    };
    unsigned int degree      = 3;
    Mass         mass        = Mass::consistent;
    unsigned int refinements = 0; /**< initial global refinements */
    Refinement   refinement  = Refinement::none;
    double       tolerance   = 1e-3; /**< estimated relative frequency error */
    /** Of the loudest pair, 1/s, with `contact_error`. */
    double       growth_rate_tolerance = 5.;
    unsigned int maximum_cycles        = 8;
    unsigned int maximum_dofs          = 200000;
    /** Estimate the discretisation error of every mode (costs a solve of one
     * degree less on the same mesh where no adaptive cycle provides it). */
    bool estimate_error = true;
  };

  /** Band and eigen-solver settings, section "Eigenvalues". */
  struct EigenParameters
  {
    enum class Solver
    {
      certified, /**< reduced basis with residual enrichment */
      direct     /**< sparse shift-invert Arnoldi, the check */
    };
    /** Where the factors of the matrices are kept, and whether the reduced
     * basis keeps its products with them. */
    enum class LinearSolver
    {
      automatic,  /**< in memory where it suffices */
      direct,     /**< in memory */
      out_of_core /**< on disk */
    };
    double lowest_frequency    = 0.;    /**< Hz, lower edge of the band */
    double highest_frequency   = 20e3;  /**< Hz, upper edge of the band */
    double mode_tolerance      = 1e-10; /**< relative residual of the Lanczos */
    Solver solver              = Solver::certified;
    LinearSolver linear_solver = LinearSolver::automatic;
    double       residual_tolerance = 1e-8; /**< residual_rel of every pair */
    double       error_tolerance = 1e-8; /**< estimated |d lambda| / |lambda| */
    unsigned int maximum_enrichments    = 30;
    double       direct_shift_frequency = -1.; /**< Hz; negative: band centre */
    unsigned int number_of_pairs        = 0;  /**< direct; 0: all of the band */
    double damping_threshold_percent    = 1.; /**< line in the damping chart */
    bool   compare_direct = false; /**< run the direct solver as well */
  };

  /** Rotor angles of "Analysis = angles", section "Angles". */
  struct AnglesParameters
  {
    std::vector<std::string> bodies;             /**< that turn together */
    double                   from = 0., to = 0.; /**< deg, the last left out */
    unsigned int             number = 12;        /**< of angles */
  };

  /** Conditions of "Analysis = operating matrix", section "Operating matrix".
   * Of empty lists the one condition is that of the scene. */
  struct OperatingMatrixParameters
  {
    std::vector<double> pressures;    /**< of all loads that press, Pa */
    std::vector<double> temperatures; /**< of all modulus tables, deg C */
    std::vector<double> speeds;       /**< of all contacts that slide, m/s */
    bool both_directions = false;     /**< targets turn backwards, too */
  };

  /** Ladder of "Analysis = work precision", section "Work precision". */
  struct WorkPrecisionParameters
  {
    /** What is solved on every rung. */
    enum class Problem
    {
      eigenvalues,    /**< undamped modes or pairs of the band */
      steady_sliding, /**< as "Analysis = preload" under the full load */
      transient       /**< one run of "Analysis = transient" */
    };
    enum class Ladder
    {
      degree,     /**< FE degree */
      refinement, /**< uniform refinement */
      cells,      /**< numbers of cells of the bodies, by a factor */
      adaptive,   /**< tolerance of the adaptive refinement */
      basis,      /**< residual tolerance of the certified basis */
      cut_off,    /**< of the modes of a transient */
      time_step   /**< of a transient */
    };
    Problem             problem = Problem::eigenvalues;
    std::vector<Ladder> ladders;
    std::vector<double> values; /**< settings of the ladder */
    /** Settings of the ladder `adaptive`; empty: `values`. */
    std::vector<double> adaptive_values;
    std::vector<double> cut_offs;   /**< of the ladder `cut_off`, Hz */
    std::vector<double> time_steps; /**< of the ladder `time_step`, s */
    /** Degree of the ladder `refinement`; 0: that of the discretization. */
    unsigned int refinement_degree = 0;
    /** frequency | sigma | eigenvalue; of `eigenvalues` */
    std::string         quantity = "frequency";
    std::vector<double> reference; /**< exact values; empty: finest rung */

    /** The settings that @p ladder climbs. */
    const std::vector<double> &
    rungs(const Ladder ladder) const
    {
      switch (ladder)
        {
        case Ladder::adaptive:
          return adaptive_values.empty() ? values : adaptive_values;
        case Ladder::cut_off:
          return cut_offs;
        case Ladder::time_step:
          return time_steps;
        case Ladder::degree:
        case Ladder::refinement:
        case Ladder::cells:
        case Ladder::basis:
          break;
        }
      return values;
    }
  };

  /** What is written, section "Output". */
  struct OutputParameters
  {
    enum class Shapes
    {
      none,
      unstable,
      all
    };
    std::string  directory = "output";
    bool         overwrite = false;
    Shapes       shapes    = Shapes::all; /**< modes written as PVD/VTU */
    unsigned int animation_frames = 12;
    bool         plots            = true;
    bool         report           = true;
    bool         export_matrices  = false; /**< MatrixMarket files of M, C, K */
    double slip_display_scale = 0.05; /**< largest drawn displacement over the
                                         scene's size */
  };

  /** One expected value, section "Result checks/Check <name>". */
  struct ResultCheckParameters
  {
    std::string name;
    std::string table;   /**< e.g. "modes.csv" */
    std::string where;   /**< "column = value" (also != < <= > >=, joined by
                            " and ") that selects rows; may be empty */
    std::string nearest; /**< "column = number": the nearest selected row */
    std::string column;  /**< column checked; "count" = number of rows */
    double      expected           = 0.;
    double      relative_tolerance = 0.;
    double      absolute_tolerance = 0.;
  };
} // namespace squeal

#endif
