// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_sweep_sweep_solution_h
#define squeal_analyses_sweep_sweep_solution_h

#include <squeal/analyses/sweep/sweep_model.h>
#include <squeal/results/chart.h>
#include <squeal/sweep/stability.h>

#include <optional>
#include <string>
#include <vector>

namespace squeal
{
  struct DirectPairs;

  /** The sweep along the first axis at fixed values of the others. */
  struct SweepLine
  {
    SweepPoint                    start; /**< its first coordinate is free */
    std::vector<TrackedPoint>     points;
    std::vector<std::string>      branch_names;
    std::vector<UnstableRange>    ranges;
    std::vector<ExceptionalPoint> exceptional;
    /** Errors of the edges of every range by the mesh, in the coordinate; NaN
     * where not known. */
    std::vector<double> mesh_errors_of_edges;
  };

  struct SweepSolution
  {
    std::vector<SweepLine> lines;
    WorstError             worst; /**< over all points */
    std::size_t            n_solved = 0;
  };

  /** Solves all points, follows the branches, finds ranges, edges, peaks and
   * exceptional points. Ranks share the points, then the lines, and all of them
   * end with all results, which do not depend on their number. Enlarges the
   * small bases where an estimate exceeds its tolerance; throws
   * ComputationError where that does not help. */
  SweepSolution solve_sweep(SweepModel &model, RunContext &context);

  TrackingOptions tracking_options(const SweepModel &model);

  /** Warns of branches, ranges and edges that the lines leave in doubt. */
  void warn_of_doubts(const SweepModel    &model,
                      const SweepSolution &solution,
                      RunContext          &context);

  /** One line of it, along the first axis; counts its solutions and worst error
   * in @p solution. */
  SweepLine solve_line(SweepModel       &model,
                       const SweepPoint &start,
                       RunContext       &context,
                       SweepSolution    &solution);

  /** boundary.csv: edges of the unstable ranges of two axes on lines that are
   * added between those of the grid until a straight line between neighbours
   * is good to Sweep/Boundary tolerance. */
  Table boundary_table(SweepModel          &model,
                       const SweepSolution &solution,
                       RunContext          &context);

  /** The unstable pair at the peak of a range, with vectors good enough for
   * derivatives. */
  struct PeakPair
  {
    SweepPoint   point;
    ComplexPairs pairs; /**< of the band */
    unsigned int index = 0;

    double
    frequency() const
    {
      return pairs.frequency(index);
    }
    double
    sigma() const
    {
      return pairs.sigma(index);
    }
  };
  /** Nothing where no pair is left there. */
  std::optional<PeakPair> peak_pair(const SweepModel    &model,
                                    const SweepLine     &line,
                                    const UnstableRange &range);

  /** What one per cent more of one number of the scene does to a pair. */
  struct Influence
  {
    unsigned int number; /**< through entries() and other_entries() */
    std::string  entry;
    double       value;     /**< SI units */
    double       sigma;     /**< 1/s */
    double       frequency; /**< Hz */
  };
  /** Of the entries @p wanted, the strongest on sigma first. */
  std::vector<Influence> influences(const SweepModel               &model,
                                    const PeakPair                 &peak,
                                    const std::vector<std::string> &wanted);

  /** suggestions.csv: for the worst unstable ranges the smallest change of
   * each of Sweep/Sensitivities, up or down, that leaves no pair of the band
   * unstable, nor one that was unstable before and has left the band; the best
   * ones are checked by direct solutions until one holds. Pairs that the change
   * tunes in are named, and warned of. */
  Table suggestion_table(const SweepModel    &model,
                         const SweepSolution &solution,
                         RunContext          &context);

  /** Pairs by the direct solver on the full matrices of @p scene, which differs
   * from that at @p point in numbers: all whose lambda is within 1.25 times
   * half of @p band, Hz, of its centre, or as far as the farthest of the
   * @p stated eigenvalues, 1/s, as DirectSolver::solve_within() can; and some
   * more, of other frequencies and of the lower half-plane, too. */
  DirectPairs direct_pairs(const SweepModel       &model,
                           const SweepPoint       &point,
                           const SceneParameters  &scene,
                           const Band             &band,
                           const Eigen::VectorXcd &stated = {});

  /** sensitivities.csv: derivatives of every unstable pair at its peak by the
   * numbers in Sweep/Sensitivities, the most influential first. */
  Table sensitivity_table(const SweepModel    &model,
                          const SweepSolution &solution,
                          RunContext          &context);

  /** @name Columns and cells of the axes that are fixed on a line */
  //@{
  void              add_fixed_axes(Table &table, const SweepGrid &grid);
  std::vector<Cell> fixed_values(const SweepGrid  &grid,
                                 const SweepPoint &start);
  //@}

  /** eigenvalues.csv of the points asked for. */
  Table sweep_eigenvalue_table(const SweepModel    &model,
                               const SweepSolution &solution);

  /** unstable_ranges.csv. */
  Table unstable_range_table(const SweepModel    &model,
                             const SweepSolution &solution);

  /**
   * doublets.csv: which member of each doublet (n,m) of the main disc squeals
   * on a line, of the rows of @p eigenvalues (eigenvalues.csv) and the peaks of
   * the unstable ranges that name it and in which the disc holds at least a
   * quarter of the kinetic energy. Without columns where no disc gives names.
   */
  Table doublet_table(const SweepModel    &model,
                      const SweepSolution &solution,
                      const Table         &eigenvalues);

  /** exceptional_points.csv. */
  Table exceptional_point_table(const SweepModel    &model,
                                const SweepSolution &solution);

  /** direct_check.csv: pairs of points, a third of them beside lock-ins, by
   * the direct solver on the full matrices. */
  Table direct_check_table(SweepModel          &model,
                           const SweepSolution &solution,
                           RunContext          &context);

  struct ScatterTables
  {
    Table              probabilities; /**< scatter.csv */
    Table              drivers;       /**< scatter_drivers.csv */
    std::vector<Chart> charts;        /**< one an axis */
  };

  /** The share of random scenes that squeals, with the error of the sampling
   * and of the basis, and which axis decides. Ranks share the samples. */
  ScatterTables scatter_tables(SweepModel &model, RunContext &context);

  /** comparison.csv: this sweep beside repeated direct solutions and one
   * frictionless modal basis. */
  Table comparison_table(const SweepModel    &model,
                         const SweepSolution &solution,
                         RunContext          &context);

  /** Charts that belong together, one picture. */
  struct ChartGroup
  {
    std::string        name, caption;
    std::vector<Chart> charts;
  };

  /** Edges of boundary.csv in the plane of the two axes. */
  Chart boundary_chart(const SweepModel &model, const Table &boundary);

  /** Charts in plots/, @p others among them; @p scene is appended to the names
   * of their files and @p title to their captions. */
  void draw_sweep(const SweepModel              &model,
                  const SweepSolution           &solution,
                  const std::vector<ChartGroup> &others,
                  const std::string             &scene,
                  const std::string             &title,
                  RunContext                    &context,
                  HtmlReport                    &report);
} // namespace squeal

#endif
