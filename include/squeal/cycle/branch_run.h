// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_cycle_branch_run_h
#define squeal_cycle_branch_run_h

#include <squeal/base/named_numbers.h>
#include <squeal/cycle/cycle_branch.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace squeal
{
  /**
   * The branch of follow_branch() point by point, first towards smaller numbers
   * from the start and then towards larger ones. What it has found can be kept
   * and gone on from, with the same bits as without a stop, and with more
   * or fewer points than before.
   */
  class BranchRun
  {
  public:
    BranchRun(PeriodMaps            maps,
              const PeriodicMotion &start,
              const double          parameter,
              const BranchSettings &settings);

    /** From the start_memory() of a branch of the same settings. Throws
     * InputError where it is not that of a periodic motion of these maps. */
    BranchRun(PeriodMaps            maps,
              const NamedNumbers   &start,
              const BranchSettings &settings);

    /** Called after each point with their number; true: stop. */
    using Watch = std::function<bool(const std::size_t n_points)>;

    /** Goes on to both ends; false where @p watch has stopped it. */
    bool advance(const Watch &watch = {});

    /** What has been found; an end that has not been reached is `points`. */
    CycleBranch        branch() const;
    std::size_t        n_points() const;
    const BranchPoint &start() const;

    /** @name What a later run goes on from: the starts of all periods */
    //@{
    NamedNumbers memory() const;
    NamedNumbers start_memory() const; /**< of the first point, not in it */
    /** Runs every period once. Throws InputError where sizes are not those of
     * this branch; it must not go on then. */
    void restore(const NamedNumbers &memory);
    //@}

  private:
    /** From the start to one end. */
    struct Side
    {
      double                   sign;
      std::vector<BranchPoint> points;
      /** Of the step beyond each point; 0: as long as the one before. */
      std::vector<double> steps = {0.};
      bool is_lost = false; /**< the iterations have not converged */
      bool turns   = false; /**< the branch turns too sharply */
    };

    std::optional<BranchEnd>   end_of(const Side &side) const;
    void                       add_point(Side &side) const;
    BranchPoint                point_of(const PeriodMap &map,
                                        PeriodicMotion   motion,
                                        const double     parameter) const;
    std::optional<BranchPoint> neighbour(const BranchPoint &start,
                                         const double       sign) const;
    std::optional<BranchPoint> point_at(const BranchPoint &start,
                                        const double       parameter) const;
    std::optional<BranchPoint> within_range(BranchPoint point) const;
    /** A step beyond the last point of @p side, whose members say where it
     * goes no further; sets the length of the next step. */
    std::optional<BranchPoint> step_along(Side &side) const;
    BranchPoint                point_from(const NamedNumbers &numbers) const;

    const PeriodMaps     maps;
    const BranchSettings settings;
    std::array<Side, 2>  sides;
  };
} // namespace squeal

#endif
