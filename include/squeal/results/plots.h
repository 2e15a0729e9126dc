// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_plots_h
#define squeal_results_plots_h

#include <squeal/results/plotter.h>

#include <limits>
#include <string>
#include <vector>

namespace squeal
{
  /** What the charts show of one eigenpair lambda = sigma + i omega. */
  struct PlottedPair
  {
    double      sigma     = 0.; /**< 1/s; > 0 is unstable */
    double      frequency = 0.; /**< Hz; 0 for a real eigenvalue */
    std::string name;           /**< "(0,3)+", "support 2" */
    bool        is_unstable = false;
    /** Whether the mesh leaves open that it grows, or that it decays. */
    bool   is_open  = false;
    double residual = std::numeric_limits<double>::quiet_NaN();
    /** Estimated |d lambda|/|lambda| of the reduction. */
    double error_estimate = std::numeric_limits<double>::quiet_NaN();
    /** Estimated relative frequency error of the mesh. */
    double discretisation_error = std::numeric_limits<double>::quiet_NaN();
    /** Kinetic-energy share of each body; sums to 1. */
    std::vector<double> energy_shares;
  };

  // Every function below writes path.png (and path.svg if the plotter does) and
  // returns whether the picture is there. Values that are not finite are left
  // out. @p title stands above the panel.

  /** The (sigma, f) plane: sigma on a scale that is logarithmic on both sides
   * of zero, f in kHz; unstable pairs carry their names, and so do those whose
   * growth is open, which are hollow. */
  bool plot_spectrum(const Plotter                  &plotter,
                     const std::vector<PlottedPair> &pairs,
                     const std::string              &path,
                     const std::string &title = "Complex eigenvalues");

  /**
   * The brake industry's chart: damping ratio zeta = -sigma/|lambda| in per
   * cent (negative: unstable) against frequency. A dashed line stands at
   * -@p threshold_percent: what lies below it is expected to squeal, what lies
   * between it and zero is usually held down by damping that the model lacks.
   * Real eigenvalues (no frequency) are left out.
   */
  bool plot_damping_chart(const Plotter                  &plotter,
                          const std::vector<PlottedPair> &pairs,
                          double                          threshold_percent,
                          const std::string              &path,
                          const std::string &title = "Damping ratio");

  /** Lying bars of the kinetic-energy share of each of @p bodies, one bar a
   * pair; the labels of unstable pairs are red. Of more than 60 pairs the
   * unstable ones and the lowest are shown, and the title says so. */
  bool plot_energy_shares(const Plotter                  &plotter,
                          const std::vector<std::string> &bodies,
                          const std::vector<PlottedPair> &pairs,
                          const std::string              &path,
                          const std::string &title = "Kinetic energy by body");

  /** Residual, error estimate and (where known) discretisation error of each
   * pair against frequency, with the two tolerances. A value of zero is drawn
   * at 1e-17. */
  bool plot_error_estimates(const Plotter                  &plotter,
                            const std::vector<PlottedPair> &pairs,
                            double                          residual_tolerance,
                            double                          error_tolerance,
                            const std::string              &path,
                            const std::string &title = "Error of every pair");

  /** One ladder of settings. */
  struct WorkPrecisionSeries
  {
    std::string              label;
    std::vector<double>      seconds;
    std::vector<double>      dofs;
    std::vector<double>      errors;   /**< relative */
    std::vector<std::string> settings; /**< text beside each point; or empty */
  };

  /** Error over CPU seconds and error over dofs, side by side. @p goal > 0 is drawn
   * as a line. */
  bool plot_work_precision(const Plotter                          &plotter,
                           const std::vector<WorkPrecisionSeries> &ladders,
                           double                                  goal,
                           const std::string                      &path,
                           const std::string &title = "Error against work");

  /** State of the certified reduced basis after one solve. */
  struct EnrichmentStep
  {
    unsigned int basis_size;
    double       worst_residual;
    double       worst_estimate;
  };

  /** Worst residual and estimate against the size of the basis. */
  bool plot_enrichment_decay(
    const Plotter                     &plotter,
    const std::vector<EnrichmentStep> &steps,
    double                             residual_tolerance,
    double                             error_tolerance,
    const std::string                 &path,
    const std::string                 &title = "Certified reduced basis");
} // namespace squeal

#endif
