// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_setup_damage_parameters_h
#define squeal_tribology_setup_damage_parameters_h

#include <squeal/parameters/choices.h>

#include <string>
#include <vector>

namespace squeal
{
  namespace prm
  {
    class Schema;
  }

  namespace tribology
  {
    /** Contact histories that are read, section "History". */
    struct HistoryParameters
    {
      std::string file;        /**< the squealing run */
      std::string silent_file; /**< the run it is compared with; may be empty */
      std::string pair;        /**< of a history with several; empty: all */
      double      start_time = -1e9; /**< s */
      double      end_time   = 1e9;  /**< s */
      unsigned int chunk     = 4096; /**< samples in memory at a time */
    };

    /** A history that is made or imported, section "Recorded history". */
    struct RecordedHistoryParameters
    {
      enum class Source
      {
        clipped_sine, /**< generator with the factors of the thesis */
        csv           /**< table of samples */
      };
      enum class Run
      {
        squealing,
        silent
      };
      Source       source     = Source::clipped_sine;
      Run          run        = Run::squealing;
      std::string  file       = "history.h5"; /**< in the output directory */
      std::string  samples    = "";           /**< CSV of samples */
      std::string  nodes      = "";           /**< CSV of nodes */
      double       duration   = 0.1;          /**< s */
      double       rate       = 68600.;       /**< samples per second */
      double       frequency  = 3430.;        /**< Hz */
      double       pressure   = 1e6;          /**< Pa, mean of the pad */
      double       leading    = 15.; /**< peak at the leading edge over mean */
      double       slip_speed = 0.1126; /**< m/s */
      double       friction   = 0.5;
      double       noise      = 0.02; /**< rms of the modulation */
      double       pad_length = 0.01; /**< m, edge of the square face */
      unsigned int n_nodes    = 11;   /**< per edge */
      unsigned int seed       = 1;
    };

    /** Counting and damage, section "Fatigue". */
    struct FatigueParameters
    {
      enum class Residue
      {
        half_cycles,
        repeating
      };
      enum class Quantity
      {
        pressure,
        traction_x,
        traction_y
      };
      enum class Model
      {
        basquin,
        bilinear
      };
      enum class MeanStress
      {
        none,
        goodman,
        gerber,
        morrow,
        swt,
        walker
      };
      enum class Accumulation
      {
        miner,
        manson_halford
      };
      Residue             residue   = Residue::half_cycles;
      Quantity            quantity  = Quantity::pressure;
      std::vector<double> exponents = {3., 5., 10.};
      /** Cycles to failure at the reference stress, one for each exponent;
       * empty: the damage is an index. */
      std::vector<double> constants;
      double              reference_stress     = 1e6; /**< Pa */
      Model               model                = Model::basquin;
      double              knee_stress          = 0.; /**< Pa */
      double              second_exponent      = 0.;
      double              endurance_limit      = 0.; /**< Pa */
      MeanStress          mean_stress          = MeanStress::none;
      double              ultimate_strength    = 0.; /**< Pa */
      double              strength_coefficient = 0.; /**< Pa */
      double              walker_exponent      = 0.65;
      Accumulation        accumulation         = Accumulation::miner;
      double              averaging_length     = 2e-3;  /**< m */
      double              application_time     = 1200.; /**< s of squeal */
      unsigned int        n_classes            = 32;
      double              largest_range        = 0.; /**< Pa; 0: found */
      bool                spectral             = true;
      double              plateau_factor       = 1.;
    };

    /** Wear and impacts, section "Surface". */
    struct SurfaceParameters
    {
      double wear_coefficient = 0.;   /**< 1/Pa; 0: an index */
      double contact_pressure = 1.;   /**< Pa, more is contact */
      double stick_speed      = 1e-6; /**< m/s, less is stick */
    };

    /** Stress below the face, section "Subsurface". */
    struct SubsurfaceParameters
    {
      enum class Criterion
      {
        dang_van,
        crossland,
        findley,
        sines,
        swt,
        fatemi_socie,
        rankine,
        drucker_prager
      };
      bool                   compute   = true;
      std::vector<double>    depths    = {1e-6, 1e-5, 1e-4, 2e-4, 4e-4, 1e-3};
      std::vector<Criterion> criteria  = {Criterion::dang_van,
                                          Criterion::crossland,
                                          Criterion::findley,
                                          Criterion::rankine};
      unsigned int           n_samples = 256;
      double                 youngs_modulus = 2.5e10; /**< Pa */
      double                 poisson_ratio  = 0.3;
      double                 pad_thickness  = 0.;   /**< m; 0: half-space */
      double                 finest_cell    = 2e-4; /**< m, of the block */
      double                 axial_limit    = 0.;   /**< Pa; 0: an index */
      double torsion_ratio        = 0.6333; /**< torsion over axial limit */
      double repeated_limit       = 0.; /**< Pa, Sines; 0: the axial limit */
      double yield_stress         = 0.; /**< Pa, Fatemi-Socie */
      double fatemi_socie_k       = 0.3;
      double tensile_strength     = 0.; /**< Pa */
      double compressive_strength = 0.; /**< Pa */
      double plane_step           = 5.; /**< degrees */
    };

    /** What both maps of a pad follow without a link between them. */
    enum class SharedCause
    {
      position, /**< along and across the sliding direction */
      rim,      /**< distance to the rim */
      edges     /**< leading, trailing and side edges */
    };

    /** Where the disc enters under the pad. */
    enum class LeadingEdge
    {
      automatic, /**< from the sliding direction of the damage table */
      lowest_y,
      highest_y,
      lowest_x,
      highest_x
    };

    /** What the maps of the self test share although there is no link. */
    enum class SharedPattern
    {
      none,
      trend,        /**< along the sliding direction, 4 deviations in all */
      rim,          /**< the outermost cells are 2 deviations higher */
      leading_edge, /**< 2 deviations, decaying over 1.5 cells */
      mask,   /**< plateaus, which are measured, are 2 deviations lower; part of
                 the pad was not looked at */
      streaks /**< nothing; the random parts are bands along the sliding */
    };

    /** Maps against maps, section "Correlation". */
    struct CorrelationParameters
    {
      /** Fewer resamplings make no interval. */
      static constexpr unsigned int least_bootstraps = 20;

      std::vector<std::string> damage_tables;  /**< one for each pad */
      std::vector<std::string> feature_tables; /**< one for each pad */
      std::vector<std::string> indices;  /**< columns of the damage tables */
      std::vector<std::string> features; /**< columns of the feature tables */
      std::vector<std::string> groups;   /**< of the pads: silent, squealing */
      std::vector<std::string> runs;     /**< directories that led here */
      double                   level         = 0.05;
      unsigned int             n_surrogates  = 999;
      unsigned int             n_bootstraps  = 999;
      unsigned int             seed          = 1;
      double                   wanted_power  = 0.8;
      double                   relevant_link = 0.3; /**< |r| worth finding */
      std::vector<SharedCause> shared_causes = {SharedCause::position,
                                                SharedCause::rim,
                                                SharedCause::edges};
      LeadingEdge              leading_edge  = LeadingEdge::automatic;
      std::vector<std::string> covariates; /**< columns of either table */
      double                   least_coverage = 0.1; /**< of a cell in links */
      bool                     is_synthetic   = false;
      bool                     self_test      = false;
      unsigned int             n_test_pairs   = 1000;
      std::vector<double>      test_lengths   = {0., 1.5, 3., 5., 8.};

      std::vector<SharedPattern> test_patterns = {SharedPattern::none,
                                                  SharedPattern::trend,
                                                  SharedPattern::rim,
                                                  SharedPattern::leading_edge,
                                                  SharedPattern::mask,
                                                  SharedPattern::streaks};
    };

    /** @name Choices in parameter files */
    //@{
    Choices<RecordedHistoryParameters::Source> choices(
      RecordedHistoryParameters::Source);
    Choices<RecordedHistoryParameters::Run> choices(
      RecordedHistoryParameters::Run);
    Choices<FatigueParameters::Residue>    choices(FatigueParameters::Residue);
    Choices<FatigueParameters::Quantity>   choices(FatigueParameters::Quantity);
    Choices<FatigueParameters::Model>      choices(FatigueParameters::Model);
    Choices<FatigueParameters::MeanStress> choices(
      FatigueParameters::MeanStress);
    Choices<FatigueParameters::Accumulation> choices(
      FatigueParameters::Accumulation);
    Choices<SubsurfaceParameters::Criterion> choices(
      SubsurfaceParameters::Criterion);
    Choices<SharedCause>   choices(SharedCause);
    Choices<LeadingEdge>   choices(LeadingEdge);
    Choices<SharedPattern> choices(SharedPattern);
    //@}

    /** @name Declarations of the sections */
    //@{
    void declare_history(prm::Schema &schema, HistoryParameters &history);
    void declare_recorded_history(prm::Schema               &schema,
                                  RecordedHistoryParameters &recorded);
    void declare_fatigue(prm::Schema &schema, FatigueParameters &fatigue);
    void declare_surface(prm::Schema &schema, SurfaceParameters &surface);
    void declare_subsurface(prm::Schema          &schema,
                            SubsurfaceParameters &subsurface);
    void declare_correlation(prm::Schema           &schema,
                             CorrelationParameters &correlation);
    //@}

    /** @name Checks that span several entries; each throws InputError. Files
     * need not be there yet: a run before may write them. */
    //@{
    void check_history(const HistoryParameters &history);
    void check_recorded_history(const RecordedHistoryParameters &recorded);
    void check_fatigue(const FatigueParameters &fatigue);
    void check_subsurface(const SubsurfaceParameters &subsurface);
    void check_correlation(const CorrelationParameters &correlation);
    //@}
  } // namespace tribology
} // namespace squeal

#endif
