// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_history_contradictions_h
#define squeal_tribology_damage_history_contradictions_h

#include <squeal/tribology/damage/surface.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** What no contact does, in a history that comes in pieces: pulling, carrying
   * a pressure while it is open or none while it is closed, sticking while it
   * slips, giving energy to the sliding, slipping (or,
   * where slip rates are not known, being dragged) another way than the history
   * says that the target slides. */
  class HistoryContradictions
  {
  public:
    /** @p stick_speed: m/s, slower slip is rounding. */
    HistoryContradictions(const HistoryLayout &layout,
                          const double         stick_speed);

    void add(const HistorySamples &samples);

    /** A line for a run on each, nothing where rounding says it all.
     * @p sums are those of the nodes over the same history. */
    std::vector<std::string> notes(const std::vector<SurfaceSums> &sums) const;

  private:
    void add_way(double x, double y);
    void add_status(const HistorySamples &samples, std::size_t i);
    /** Of the status against pressures and slip rates. */
    std::vector<std::string> notes_of_status() const;
    std::string              note_of_direction() const;

    HistoryLayout layout;
    double        stick_speed;                    /**< m/s */
    std::size_t   n_tension = 0, lowest_node = 0; /**< values; of the lowest */
    std::size_t   n_open = 0, n_values = 0; /**< open under pressure, all */
    std::size_t   n_closed = 0, n_closed_without = 0; /**< pressure */
    std::size_t   n_stick = 0;
    double        fastest = 0.,
           stick_rates    = 0.; /**< m/s; of values that stick, sum */
    double lowest = 0., highest = 0., highest_open = 0.; /**< Pa */
    /** Sums of pressure times slip rate or, without these, of the tractions of
     * the target on the pad: of the components and the size. */
    double way_x = 0., way_y = 0., way_size = 0.;
  };
} // namespace squeal::tribology

#endif
