// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_period_equations_h
#define squeal_cycle_period_equations_h

#include <squeal/cycle/shooting.h>

#include <optional>

namespace squeal
{
  /** States at the rows of the forces that count as vectors whose entries are
   * the roots of energies. */
  class ScaledMotion
  {
  public:
    ScaledMotion(const ReducedContactModel &model,
                 const std::vector<int>    &rows,
                 const double               period);

    Eigen::VectorXd pack(const Eigen::VectorXd &q,
                         const Eigen::VectorXd &v,
                         const Eigen::VectorXd &lambda) const;
    Eigen::VectorXd difference(const MotionState &a,
                               const MotionState &b) const;
    MotionState     moved(const MotionState     &start,
                          const Eigen::VectorXd &change) const;
    Eigen::MatrixXd derivative(const Eigen::MatrixXd &D) const;

  private:
    const std::vector<int> rows;
    const Eigen::Index     n;
    Eigen::VectorXd        scale;
  };

  /** How the start of @p orbit moves along the motion, a second; forces by the
   * last step before. */
  MotionState rate_of_motion(const PeriodMap &map, const Orbit &orbit);

  /** Of a motion about its mean, the largest energy norm. */
  double motion_size(const ReducedContactModel &model, const Orbit &orbit);

  /** Whether nothing vibrates. */
  bool is_steady(const PeriodMap &map, const Orbit &orbit);

  /** The orbit of a period that starts at @p start with what it misses; false
   * where a step has no solution. @p past, @p held, @p neighbour: see
   * PeriodMap::run(). */
  bool try_orbit(const PeriodMap       &map,
                 const MotionState     &start,
                 const double           period,
                 const unsigned int     n_steps,
                 const ContactPast     &past,
                 const StepCorrections *held,
                 PeriodicMotion        &motion,
                 const Orbit           *neighbour = nullptr);

  /** @p motion, whose changes of status have been held, over its period again
   * with the changes located on it; none where a step has no solution. */
  std::optional<PeriodicMotion> located_anew(const PeriodMap      &map,
                                             const PeriodicMotion &motion);

  /** When the changes of status within steps are no longer located anew: the
   * steps jump a little where a change of one node disturbs what is told from
   * the steps before another one. */
  struct StatusChangeRule
  {
    /** Near the periodic motion, below this residual, they are held */
    static constexpr double near_enough = 1e-2;
    /** where an iteration leaves more than this share of it; */
    static constexpr double least_gain = 0.3;
    /** farther away, below this one, */
    static constexpr double farthest = 0.5;
    /** where it leaves more than this. */
    static constexpr double no_gain = 0.9;
    /** On a motion that has been found with changes held from far away they are
     * located anew, and held again where that leaves less than this share of
     * the residual that they were held at. */
    static constexpr double much_nearer = 0.5;

    static bool
    holds(const double residual, const double gain)
    {
      return residual < near_enough ? !(gain < least_gain)
                                    : residual < farthest && !(gain < no_gain);
    }
  };

  /** The equations of shooting linearised about a motion: that it is where it
   * started after a period, and that the start does not move along it. Unknowns
   * are the scaled state and the period in shares of itself. */
  class PeriodEquations
  {
  public:
    PeriodEquations(const PeriodMap        &map,
                    const PeriodicMotion   &motion,
                    const ScaledMotion     &scaled,
                    const std::vector<int> &rows,
                    const StatusChanges     changes);

    /** The change for what the motion of the equations, or one near it, misses
     * its start by, scaled: end less start. */
    Eigen::VectorXd solve(const Eigen::VectorXd &missing) const;

    /** With a number more, which moves the end of the period by @p by_number a
     * unit, and the equation @p row * change = @p value. */
    Eigen::VectorXd solve_with(const Eigen::VectorXd &by_number,
                               const Eigen::VectorXd &row,
                               const double           value) const;

  private:
    Eigen::MatrixXd                      A;
    Eigen::VectorXd                      rhs;
    Eigen::PartialPivLU<Eigen::MatrixXd> factors; /**< of A */
  };
} // namespace squeal

#endif
