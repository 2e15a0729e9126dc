// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_transient_transient_results_h
#define squeal_analyses_transient_transient_results_h

#include <squeal/analyses/transient/transient_run.h>
#include <squeal/eigen/complex_pairs.h>
#include <squeal/model/growth_outside.h>
#include <squeal/output/force_charts.h>
#include <squeal/results/table.h>
#include <squeal/transient/growth.h>
#include <squeal/transient/linearized_motion.h>
#include <squeal/transient/spectrum.h>

#include <complex>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  class RunContext;
  class RunLog;
  class HtmlReport;

  /** All that a transient is started from. */
  struct PreparedTransient
  {
    PressedModel     pressed;
    SteadySliding    steady;
    LinearizedMotion linear;
    /** What the motions above the cut-off would add to its eigenvalues, 1/s. */
    Eigen::VectorXcd          reduction_errors;
    GrowthOutside             outside;
    std::vector<unsigned int> branches; /**< pairs within the band */

    PreparedTransient(const PressedModel &pressed,
                      const Parameters   &parameters,
                      Timers             &timers);

    /** motions_of_run() of `linear`. */
    LinearizedMotion motions(const Parameters &parameters) const;

  private:
    PreparedTransient(const SteadyModel &model,
                      const Parameters  &parameters,
                      Timers            &timers);
  };

  /** One pair about steady sliding and what the motion makes of it. */
  struct BranchResult
  {
    double sigma     = 0.;           /**< of the reduced model, 1/s */
    double frequency = 0.;           /**< Hz */
    double sigma_cea, frequency_cea; /**< of the whole model; NaN if not
                                        computed */
    /** What the reduced model leaves out adds to `sigma` and `frequency`,
     * estimated: the model of all unknowns less this one, 1/s and Hz. */
    double    sigma_reduction = 0., frequency_reduction = 0.;
    GrowthFit fit;
    double    last_amplitude = 0.; /**< rms over the second half of the run,
                                      sqrt(J) */
  };

  /** A pair whose forces are judged. */
  struct JudgedPair
  {
    unsigned int number = 0;
    std::string  name; /**< empty: it is the only one of the scene */
    /** The one whose vibration is judged: the tangential force where the normal
     * one is steady or vibrates by far less, as in pure stick-slip; a moment of
     * the normal forces where it vibrates by far more than that one, as in a
     * wobble that goes round; that of a node where sums and moments are steady,
     * as in a wave with several wave lengths round a ring. */
    JudgedForce force = JudgedForce::normal;
    /** What it is called in a sentence. */
    std::string force_name = "normal force";
    MomentParts parts{{1., 0.}}; /**< of a moment that is judged */
    std::size_t watched = 0; /**< the node that is judged, in WatchedNodes */
    /** What the force has of the mean normal force of the pair, against which
     * its vibration is large or noise: of a node one part of as many as there
     * are, else all. */
    double share = 1.;

    bool is_by_moment() const;
    /** A moment or a node is judged. */
    bool is_beside_sums() const;
  };

  /** The force of @p pair that is judged in every sample, N. */
  std::vector<double> samples_of(const TransientRecord &record,
                                 const JudgedPair      &pair);

  /** " of the pair upper"; empty where it is the only one. */
  std::string of_judged(const JudgedPair &pair);

  /** What comes out of a transient. */
  struct TransientFigures
  {
    std::vector<BranchResult> branches;
    int                       leading = -1; /**< branch of the largest sigma */
    /** stable, unstable, undecided: of the band, but not stable where a motion
     * outside it grows. */
    std::string verdict;
    /** That motion in words, text_of_growth_outside(); empty where there is
     * none that is of the run. */
    std::string growing_outside;
    /** The run has growth of the reduced model alone that is faster than all
     * that the bodies have or may have: what vibrates in it tells nothing of
     * them. */
    bool vibrates_by_reduction = false;
    /** The run moves all unknowns, and motions above the cut-off are not among
     * those that are linearised: they may grow. */
    bool   has_unseen_motions = false;
    double linear_start = 0., linear_end = 0.; /**< of the linear phase, s */

    /** @name Over the second half of the run */
    //@{
    /** Those that slide (all where none does) and carry more than a thousandth
     * of what the one with the largest mean normal force does. */
    std::vector<JudgedPair> judged;
    /** The one of them whose force vibrates most over its own mean normal
     * force, the first of equal ones: vibration, its lines and its phase are
     * those of its forces. In sums over all pairs pads that move against each
     * other cancel. */
    JudgedPair loudest;
    /** The vibration keeps its size and is none that only dies out slowly. */
    bool has_limit_cycle = false;
    /** No status other than that of steady sliding, about which every motion
     * decays: what still vibrates dies out, however slowly. */
    bool   dies_out  = false;
    bool   vibrates  = false;             /**< more than noise, to stay */
    double least_rms = 0., most_rms = 0.; /**< of its four quarters, N, beside
                                             what the force drifts by */
    /** No force of any pair that is judged vibrates by more than noise, in the
     * first half of the run either. */
    bool is_silent = false;
    /** What the rms about the slow part changes by from the first half of that
     * time to the second: of the force of `rms_normal`, N, and of the force
     * that is judged, as a share of the larger one. */
    double rms_change = 0., rms_change_share = 0.;
    /** Of the motion, Hz: of the force that is judged and, with it, of sums,
     * moments and loudest node (common_period()); 0: not known. */
    double frequency = 0.;
    /** Of the motion that grows fastest about steady sliding, or of the largest
     * line of the force in the last steps, Hz, where samples are too far apart
     * for it: what lines they have may be other ones folded down, and
     * frequencies, harmonics, repetition and phase are left empty, sound and
     * spectrum are not written. 0: they are not. */
    double beyond_samples = 0.;
    /** It is that of the steps. */
    bool is_beyond_in_steps = false;
    /** Largest deviation of its quarters, Hz; NaN if none has a line. */
    double              frequency_ci = std::numeric_limits<double>::quiet_NaN();
    double              largest_line = 0.; /**< as in CommonPeriod, Hz */
    std::vector<double> harmonics;         /**< rms of its multiples 1.., N */
    double              repetition  = 0.;  /**< as in CommonPeriod */
    double              mean_normal = 0.;  /**< N */
    double rms_normal = 0.; /**< N, about the mean; of the moment or the node
                               where that is judged */
    /** What the quarters of the sum of the normal forces vibrate by at most,
     * as `most_rms`, N. */
    double most_rms_of_sum = 0.;
    double min_normal = 0., max_normal = 0.;
    /** N, of `mean_normal` and `rms_normal`: what the last period of a limit
     * cycle, which the end of the run cuts, makes at most. NaN where nothing
     * repeats, the second where a moment or a node is judged. */
    double mean_normal_error = std::numeric_limits<double>::quiet_NaN(),
           rms_normal_error  = std::numeric_limits<double>::quiet_NaN();
    double mean_tangential = 0., rms_tangential = 0.;
    double mean_normal_of_all   = 0.; /**< of the sum over pairs, N */
    double macroscopic_friction = 0.; /**< mean friction over mean normal of
                                         that sum */
    double phase = 0.; /**< of the tangential against the normal force at the
                          largest line, deg; NaN where a moment or a node is
                          judged */
    bool   separates            = false; /**< all nodes open at a time */
    double stick_fraction       = 0.;    /**< of closed node-time */
    double max_slip_speed_ratio = 0.;
    double rms_acceleration     = 0.; /**< of a source's centre, the largest
                                         of all pairs, m/s^2 */
    double       mean_leading_edge_factor = 0.;
    double       peak_pressure            = 0.; /**< Pa */
    unsigned int n_never = 0, n_slip = 0, n_sticking = 0, n_stick_slip = 0,
                 n_separating = 0;
    //@}

    double worst_imbalance = 0.; /**< of the ledger, over the work of the run */
    double steps_per_second = 0., iterations_per_step = 0., n_inversions = 0.;
  };

  TransientFigures evaluate_transient(const PreparedTransient &prepared,
                                      const TransientRecord   &record,
                                      const Parameters        &parameters,
                                      const ComplexPairs      *cea = nullptr);

  /** The highest line that values @p interval, s, apart tell, Hz: half their
   * rate less a margin for lines that are no sharp ones. */
  double highest_line(const double interval);

  /** The largest line, above @p lowest, Hz, of the force of @p pair that is
   * judged in the steps of the second half of the run that the record has one
   * by one; 0 where samples @p interval, s, apart tell it. It sees every motion,
   * those above the cut-off and those that the linearised model does not have
   * among them. */
  double line_beyond_samples(const TransientRecord &record,
                             const JudgedPair      &pair,
                             const double           lowest,
                             const double           interval);

  /** The eigenvalues of @p linear as far as a run has them: a run of all
   * unknowns has what the bodies do instead of what the reduced model does.
   * Without vectors. */
  LinearizedMotion motions_of_run(const LinearizedMotion    &linear,
                                  const GrowthOutside       &growth,
                                  const TransientParameters &t);

  /** That of the bodies, and that of the reduction in its own integrator. */
  GrowthOutside growth_of_run(const GrowthOutside       &growth,
                              const TransientParameters &t);

  /** The frequency of fastest_growth(), Hz, where samples @p interval, s, apart
   * do not tell it (highest_line()) and the motion has the time to become
   * large, else 0. */
  double frequency_beyond_samples(const LinearizedMotion    &linear,
                                  const TransientParameters &t,
                                  const double               interval);

  /** Repetition from which on a vibration has a period. */
  constexpr double least_repetition = 0.9;

  /** Errors of mean and rms of the force that is judged over @p time, s, whose
   * last period is cut: lines and forces are known. */
  void evaluate_cut(const double time, TransientFigures &f);

  /** Fills in what TransientFigures says of the forces over the second half of
   * the run, but for lines and phase. */
  void evaluate_forces(const ContactNodes    &nodes,
                       const TransientRecord &record,
                       TransientFigures      &figures);

  /** Rms about its mean, N, of the normal force of a pair; of the node where
   * that is judged, of the moment that vibrates most there where one is: in the
   * stretch number @p first up to the one before @p end, of the same force in
   * every stretch of a run. */
  double rms_of_pressure(const JudgedPair      &pair,
                         const TransientRecord &record,
                         const unsigned int     first,
                         const unsigned int     end);

  /** The one of @p pairs with the largest rms_of_pressure() over its share of
   * its mean normal force, in the stretch number @p first up to the one before @p end; the first
   * of equal ones. */
  JudgedPair loudest_in(const std::vector<JudgedPair> &pairs,
                        const TransientRecord         &record,
                        const unsigned int             first,
                        const unsigned int             end);

  /** Whether the force that is judged is steady, but for a drift and noise,
   * over the second half of the run. */
  bool nothing_vibrates(const TransientFigures &figures);

  /** What a trigger, hammer or friction impulse, has made of a run. Roots of
   * mean squares, N, of the force that is judged (JudgedPair::force), or of a
   * moment that the trigger leaves by far more of, about the parabola that is
   * nearest to it: a load that comes on is no vibration. Of several pairs those
   * of the one with the most lasting outcome. */
  struct TriggerOutcome
  {
    double before = 0.; /**< over the last quarter of the time before it */
    double after  = 0.; /**< over the tenth of the run that follows it */
    double end    = 0.; /**< over the last tenth of the run */
    /** Time from the end of the trigger to the last window of a hundredth of
     * the run in which the vibration exceeds 10 % of the mean force, s. */
    double lasting = 0.;
    /** `squeal by itself`: it lasts to the end and is there before the trigger,
     * above 1 % of the mean normal force, or steady sliding is unstable, so
     * that it would have come without the trigger; `squeal after the trigger`:
     * it lasts to the end; `temporary after the trigger`: it decays;
     * `none`: no vibration above 1 % follows; `run too short`: less than a
     * tenth of the run follows; empty: no trigger. */
    std::string text;
    JudgedPair  pair; /**< that it is the outcome of */
  };

  /** Whether a hammer or a friction impulse is there. */
  bool           has_trigger(const TransientParameters &parameters);
  TriggerOutcome evaluate_trigger(const TransientRecord     &record,
                                  const TransientFigures    &figures,
                                  const TransientParameters &parameters);

  /** Largest real part in the band with the whole face of every sliding pair
   * closed under an even pressure, whatever the steady sliding, 1/s. */
  double sigma_with_full_contact(const PreparedTransient &prepared,
                                 const Parameters        &parameters);

  /** Pairs of the whole model about contact states, one list a pair. */
  ComplexPairs whole_model_pairs(const Parameters                 &parameters,
                                 const std::vector<ContactStates> &states,
                                 RunLog                           &log,
                                 Timers                           &timers);

  /** @name Tables and files of one run */
  //@{
  Table transient_table(const TransientFigures &figures);
  Table branch_table(const TransientFigures &figures);
  Table force_table(const PreparedTransient &prepared,
                    const TransientRecord   &record);
  /** The ledger; of several pairs what each loses in its slip as well. */
  Table energy_table(const PreparedTransient &prepared,
                     const TransientRecord   &record);
  Table probe_table(const PreparedTransient &prepared,
                    const TransientRecord   &record);
  /** Phase between tangential and normal force of the loudest pair at the
   * largest line of the run, over time; none where a moment or a node is
   * judged, whose amplitude stands for that of the normal force. */
  Table phase_table(const TransientRecord  &record,
                    const TransientFigures &figures);
  Table zone_table(const PreparedTransient &prepared,
                   const TransientRecord   &record);
  /** Vibration and friction over the sliding speed of a run whose speed
   * changes: means over equal stretches of it. */
  Table speed_table(const PreparedTransient &prepared,
                    const TransientRecord   &record,
                    const TransientFigures  &figures,
                    const Parameters        &parameters);
  /** transient.json; @p explanation: the verdict in words, which says what
   * stands beside stable steady sliding. */
  void write_transient_json(const TransientFigures &figures,
                            const std::string      &explanation,
                            const std::string      &path);
  /** Of the nodes that TransientRun hands over, beside the @p checkpoint. */
  std::unique_ptr<HistoryStream> make_history_stream(
    const ContactNodes &nodes,
    const std::string  &checkpoint);
  void write_contact_history(const PreparedTransient &prepared,
                             const HistoryStream     &history,
                             const std::string       &name,
                             const std::string       &path);
  /** The last steps of a run, six periods of @p frequency (Hz; 0: no period), as
   * far as the record has them, of pair @p pair. */
  ForceCurve last_periods(const TransientRecord &record,
                          const double           frequency,
                          const unsigned int     pair = 0);
  void       draw_transient(RunContext              &context,
                            const PreparedTransient &prepared,
                            const TransientRecord   &record,
                            const TransientFigures  &figures,
                            const HistoryStream     &history,
                            HtmlReport              &report);
  void       draw_speeds(RunContext  &context,
                         const Table &speeds,
                         HtmlReport  &report);
  /** Amplitudes and phases of phase tables, each with its label. */
  void draw_phases(RunContext                                       &context,
                   const std::vector<std::pair<std::string, Table>> &runs,
                   HtmlReport                                       &report);
  //@}

  /** One run for each point of the axes of `Sweep` and each top. */
  void run_campaign(RunContext &context);
} // namespace squeal

#endif
