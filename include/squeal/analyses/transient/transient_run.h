// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_transient_run_h
#define squeal_analyses_transient_transient_run_h

#include <squeal/analyses/transient/force_sums.h>
#include <squeal/analyses/transient/watched_nodes.h>
#include <squeal/contact/contact_resultant.h>
#include <squeal/model/pressed_model.h>
#include <squeal/results/history_stream.h>
#include <squeal/run/fingerprint.h>
#include <squeal/transient/linearized_motion.h>
#include <squeal/transient/transient_integrator.h>

#include <complex>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /** One sample of a transient. */
  struct TransientSample
  {
    double time = 0.;
    /** Sums over the pairs that slide (over all where none does): N, along and
     * across the sliding of each and normal, target on source. */
    double tangential = 0., radial = 0., normal = 0.;
    double n_open = 0., n_stick = 0.; /**< nodes of all pairs */
    /** 1 where every status has been that of steady sliding since the sample
     * before. */
    double is_linear    = 0.;
    double leading_edge = 0.; /**< leading_edge_factor() of StepSums */
    double kinetic = 0., elastic = 0., damping = 0., friction = 0.,
           driving = 0., load = 0., numerical = 0., imbalance = 0.; /**< J */
  };

  /** Forces of a pair after one step, as in StepSums. */
  struct StepForces
  {
    double time   = 0.;                           /**< s */
    double normal = 0., tangential = 0.;          /**< N */
    double first_moment = 0., second_moment = 0.; /**< N */
  };

  /** What one pair adds to a sample. */
  struct PairSample
  {
    double tangential = 0., radial = 0.,
           normal = 0.; /**< N: as in mean_frame(),
                           target on source */
    /** Those whose phase is told, N: the sums of the nodes' normal forces and
     * of their friction on a curved face, the resultants on a flat one. */
    double pressing = 0., pulling = 0.;
    double first_moment = 0., second_moment = 0.; /**< as in StepSums, N */
    double friction        = 0.; /**< J: lost in its slip since the start */
    double position[3]     = {}; /**< of the source's centre, m */
    double acceleration[3] = {}; /**< m/s^2 */
  };

  /** What a node has done since a time. */
  struct NodeShares
  {
    double open = 0., stick = 0., slip = 0.; /**< steps */
    double fastest_slip = 0.;  /**< |v_t| over the sliding speed of its pair; 0
                                  in pairs at rest */
    double peak_pressure = 0.; /**< Pa */
  };

  /** A moment of the animation: what the motion of the bodies follows from. */
  struct MotionFrame
  {
    double          time = 0.;   /**< s */
    Eigen::VectorXd coordinates; /**< of the modes */
    Eigen::VectorXd forces;      /**< of the contact, N */
    Eigen::VectorXd unknowns;    /**< all of them, m; empty: only modes move */
  };

  /** All that a transient leaves. */
  struct TransientRecord
  {
    std::vector<TransientSample>      samples;
    std::vector<PairSample>           pairs;      /**< samples x pairs */
    std::vector<std::complex<double>> amplitudes; /**< samples x branches */
    double n_changes = 0.; /**< of status, of nodes of all pairs */
    /** Steps x pairs, after each of the last steps, at most
     * TransientRun::most_last_steps: a curve through samples cuts the corners
     * of a limit cycle. */
    std::vector<StepForces> last_steps;
    /** The last samples, as many as `Animation frames`, and the nodes of each
     * pair then. */
    std::vector<MotionFrame>    frames;
    std::vector<HistorySamples> frame_nodes;
    /** Over the second half of the run. */
    std::vector<NodeShares> nodes;
    /** Of every step; n_force_stretches of them make the run. */
    std::vector<ForceStatistics> stretches;
    /** Pairs x stretches, resultants of each of several pairs: pads that move
     * against each other cancel in the sums. Empty with one pair. */
    std::vector<ForceStatistics> pair_stretches;
    /** Pairs x n_trigger_stretches, of every step: what a trigger has made is
     * judged by them, as impacts are shorter than samples are apart. Empty
     * without a trigger. */
    std::vector<ForceStatistics> trigger_stretches;
    /** Of every step and sample; none where nodes were not looked at. */
    WatchedNodes watched;
    /** Of the source of each pair: squares of the acceleration of its centre,
     * added up over the steps of the second half of the run, (m/s^2)^2. */
    std::vector<double> square_accelerations;
    double              n_steps = 0., n_iterations = 0., n_sweeps = 0.;
    double              worst_residual = 0.;
    double              cpu_seconds    = 0.; /**< of the steps */
    double              n_inversions   = 0.;

    /** Of pair @p i, of the sums where it is the only one. */
    std::vector<ForceStatistics> stretches_of(const unsigned int i) const;
    /** Of pair @p i; none without a trigger. */
    std::vector<ForceStatistics> trigger_stretches_of(
      const unsigned int i) const;
    /** A force of pair @p i in every sample, N. */
    std::vector<double> forces_of(const unsigned int i,
                                  double PairSample::*const force) const;
    std::vector<double> times() const;
    unsigned int        n_pairs() const;
    /** What pair @p i was at sample @p k. */
    const PairSample &pair(const std::size_t k, const unsigned int i) const;
    std::vector<std::complex<double>> branch(const unsigned int k,
                                             const unsigned int n) const;
  };

  /**
   * One transient by the integrator of the parameters, from its start to its
   * end, with checkpoints.
   */
  class TransientRun
  {
  public:
    /** @p branches: the pairs of @p linear whose amplitudes are recorded. Nodes
     * and their changes of status go to @p history, if it is there; it is
     * started or restored before the first step. */
    TransientRun(const PressedModel              &pressed,
                 const SteadySliding             &steady,
                 const LinearizedMotion          &linear,
                 const std::vector<unsigned int> &branches,
                 const Parameters                &parameters,
                 HistoryStream                   *history = nullptr);

    /** Steps that the record has one by one: some ten periods of a squeal at 1
     * kHz in steps of 2e-7 s, and 1 MB a pair. */
    static constexpr unsigned int most_last_steps = 50000;

    /** Called now and then with the steps since; true: stop. */
    using Watch = std::function<bool(const unsigned int n_steps)>;

    /** Goes on to the end; false where @p watch stopped it. Throws
     * ComputationError. */
    bool advance(const Watch &watch = {});

    const TransientRecord &record() const;
    unsigned int           n_steps_left() const;

    /** @name For checkpoints: a run that continues from one gives the same
     * bits. The history has a memory of its own. */
    //@{
    NamedNumbers memory() const;
    /** Throws InputError where sizes are not those of this run; it must not go
     * on then. */
    void restore(const NamedNumbers &memory);
    //@}

    /** Enters the sizes that the memory has: nodes, modes, steps. */
    void describe(Fingerprint &fingerprint) const;

    /** Whether more moves than modes: then the state does not hang on them. */
    bool moves_all_unknowns() const;

  private:
    void take_history();
    void take_sample(const bool is_linear);
    void take_pair_samples(TransientSample &sample);
    void take_node_fields(const TransientSample       &sample,
                          std::vector<HistorySamples> &histories) const;
    void take_nodes_of(const unsigned int     pair,
                       const TransientSample &sample,
                       HistorySamples        &history) const;
    void take_frame(const TransientSample &sample);
    void take_node_shares();
    /** Sums of the forces of now. */
    StepSums force_sums() const;
    void     take_step_forces();
    void     take_trigger_forces(const std::vector<StepSums> &of_pairs);
    void     take_accelerations();
    /** Speed of the drive at the end of the last step, m/s. */
    double speed_now() const;

    const PressedModel        &pressed;
    const SteadySliding       &steady;
    const LinearizedMotion     recorded; /**< the branches only */
    const TransientParameters &settings;
    const std::vector<double>  areas;  /**< of all nodes */
    std::vector<FaceAxes>      axes;   /**< of each pair */
    std::vector<bool>          flat;   /**< is_flat(), of each pair */
    std::vector<double>        speeds; /**< of the pair of each node, m/s */
    const ForceSums            sums;
    const std::vector<double>  senses; /**< transverse_senses() */
    unsigned int               n_steps, stride;
    std::unique_ptr<TransientIntegrator> motion;
    HistoryStream                       *history;
    TransientRecord                      kept;
    std::vector<ContactStatus>           status;
    bool                                 linear_since_sample = true;
    Eigen::VectorXd                      last_motion;
  };

  /** What drives a run of these parameters. */
  TransientDrive make_drive(const PressedModel &pressed,
                            const Parameters   &parameters);

  /** The integrator of the parameters about @p steady. */
  std::unique_ptr<TransientIntegrator> make_integrator(
    const PressedModel  &pressed,
    const SteadySliding &steady,
    const Parameters    &parameters);
} // namespace squeal

#endif
