// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_sweep_sweep_model_h
#define squeal_analyses_sweep_sweep_model_h

#include <squeal/analyses/sweep/sweep_scenes.h>
#include <squeal/model/mode_solution.h>
#include <squeal/run/fingerprint.h>
#include <squeal/run/run_context.h>
#include <squeal/sweep/basis_builder.h>
#include <squeal/sweep/branch_tracker.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * The certified reduced model of a sweep, built or read from the file of an
   * earlier run, with all that the results need of the full model: energies,
   * names, contact motions, discretisation errors.
   */
  class SweepModel
  {
  public:
    /** Assembles number @p i of the scenes of a sweep, which must outlive the
     * model, and builds or reads the basis. If given, @p vectors are what a
     * basis that is built starts with, see BasisBuilder, and become its common
     * basis. */
    SweepModel(RunContext                    &context,
               const std::vector<SweepScene> &scenes,
               const std::size_t              i,
               Block                         *vectors = nullptr);

    const Model            &model() const;
    const Parameters       &run_parameters() const;
    const SceneParameters  &scene() const;
    const SweepGrid        &grid() const;
    const ParametricSystem &system() const;
    const ReducedModel     &reduced() const;
    Band                    band() const;
    /** Whether the basis comes from an earlier run. */
    bool is_reused() const;
    /** How the basis was built, in whichever run. */
    const std::vector<BasisRound> &history() const;
    unsigned int                   n_factors() const;
    /** CPU seconds that building the basis took, in whichever run. */
    double basis_seconds() const;

    /** Whether each point of the grid has its own contact state. */
    bool has_contact_states() const;
    /** The contact state that is held there, one list of one state a pair,
     * empty for pairs without states of their own. */
    std::vector<ContactStates> contact_at(const SweepPoint &point) const;
    /** Contact points that are closed there; with contact states only. */
    unsigned int n_closed(const SweepPoint &point) const;
    /** Whether the contact state changes there along the first axis, to 1e-4
     * of a decade or of the length of the axis. */
    bool is_at_contact_change(const SweepPoint &point) const;

    /** Pairs in the band at a point, with estimates unless told otherwise. */
    ComplexPairs solve(const SweepPoint &point,
                       const bool        with_estimates = true) const;

    /** With estimates within the tolerances: enlarges the small basis where
     * they are not, throws ComputationError where that does not help. The
     * largest estimates are entered in @p worst. */
    ComplexPairs solve_certified(const SweepPoint &point, WorstError &worst);

    /** Whether the estimates of pairs of solve() are within the tolerances. */
    bool is_certified(const ComplexPairs &pairs, const SweepPoint &point) const;

    /** Within a hundred times the tolerances, the small basis being left alone:
     * for points that only steer, many of them next to a coalescence. */
    ComplexPairs solve_between(const SweepPoint &point) const;

    /** residual_rel of pairs of solve(), from inner products of the products
     * of all parts with the basis; empty where contact states change. */
    Eigen::VectorXd residuals(const SweepPoint   &point,
                              const ComplexPairs &pairs) const;

    /** Undamped modes at a point and their names and mesh errors. */
    struct Modes
    {
      ReducedModes          modes;
      std::vector<ModeName> names;
      std::vector<double>   mesh_errors; /**< NaN where not known */
    };
    Modes undamped(const SweepPoint &point) const;

    /** Shares of the kinetic energy: bodies x vectors. */
    Eigen::MatrixXd energy_shares(const SweepPoint       &point,
                                  const Eigen::MatrixXcd &vectors) const;
    /** @p eigenvalues: of the vectors, in 1/s. */
    std::vector<ModeName>    names(const Eigen::MatrixXcd &vectors,
                                   const Eigen::MatrixXd  &energy_shares,
                                   const Eigen::VectorXcd &eigenvalues) const;
    const std::vector<bool> &symmetric_parts() const;

  private:
    void build(RunContext &context, Block *vectors);
    bool read(RunContext &context);
    void add_quantities(RunContext &context, const Block &basis);
    void add_mesh_errors(RunContext &context, const Block &basis);
    /** Where the basis is kept, in the output directory. */
    static std::string basis_file(RunContext &context, const std::string &name);
    /** Everything that the basis depends on. */
    Fingerprint fingerprint() const;
    /** @name The history of the basis among the numbers of the model */
    //@{
    void put_rounds();
    void take_rounds();
    //@}
    bool is_within(const WorstError &worst, const double factor) const;
    /** Enlarges the small basis at @p point; false when it holds all. */
    bool enlarge(const SweepPoint &point);

    const Parameters          &parameters;
    SweepGrid                  sweep_grid;
    std::vector<ContactStates> contact_states; /**< of pairs, if they change */
    Model                      full;
    ParametricSystem           parts;
    ReducedModel               small;
    std::vector<bool>          symmetric;
    std::vector<BasisRound>    rounds;
    /** Those of the vectors of a cell, when first needed. */
    mutable std::map<std::size_t, std::vector<Eigen::MatrixXd>> cell_grams;
    std::string                                                 file;
    unsigned int                                                factors = 0;
    bool                                                        reused  = false;
  };
} // namespace squeal

#endif
