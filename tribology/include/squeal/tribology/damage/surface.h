// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_damage_surface_h
#define squeal_tribology_damage_surface_h

#include <squeal/results/contact_history.h>
#include <squeal/tribology/setup/damage_parameters.h>

#include <vector>

namespace squeal::tribology
{
  /** What happens on the face at one node, summed over a history. */
  struct SurfaceSums
  {
    double duration        = 0.; /**< s */
    double contact_time    = 0.; /**< s */
    double pressure_time   = 0.; /**< Pa s, integral of the pressure */
    double peak_pressure   = 0.; /**< Pa, negative if always in tension */
    double friction_energy = 0.; /**< J/m^2, integral of traction . slip */
    double pressure_slip   = 0.; /**< Pa m, integral of p |v|: Archard */
    double impacts         = 0.; /**< closures after separation */
    double closures        = 0.; /**< those that two samples show */
    double impulse         = 0.; /**< Pa s, from these to the first maximum */
    double stick_slip      = 0.; /**< changes between stick and slip */

    double duty() const;          /**< part of the time in contact */
    double mean_pressure() const; /**< Pa */
  };

  /**
   * Sums the surface figures of all nodes over a history that comes in pieces,
   * by the trapezoidal rule between samples. Impacts, changes between stick and
   * slip and the time in contact follow the recorded changes of status where a
   * history has them, which may lie between the samples, and the status of the
   * samples where they do not tell how it came about. The sums do not depend on
   * the pieces.
   */
  class SurfaceSummer
  {
  public:
    /** @p changes: those of a history with status, in any order. */
    SurfaceSummer(const HistoryLayout      &layout,
                  const SurfaceParameters  &rules,
                  std::vector<StatusChange> changes = {});

    void add(const HistorySamples &samples);

    const std::vector<SurfaceSums> &sums() const;

  private:
    /** One node at one time. */
    struct Moment
    {
      double        pressure = 0., power = 0., pressure_slip = 0.;
      ContactStatus status    = ContactStatus::open;
      bool          is_closed = false; /**< in the sample */
    };

    /** Takes the changes up to a time, s. */
    void take_changes(double until);

    Moment moment(const HistorySamples &s,
                  std::size_t           i,
                  std::size_t           node) const;

    HistoryLayout             layout;
    SurfaceParameters         rules;
    std::vector<SurfaceSums>  result;
    std::vector<Moment>       last;
    std::vector<char>         is_loading;    /**< closed and still rising */
    std::vector<StatusChange> changes;       /**< by time */
    std::size_t               n_changes = 0; /**< that have been taken */
    std::vector<double>       changed_at; /**< s, of the last one of a node */
    double                    last_time = 0.;
    bool                      has_last  = false;
  };
} // namespace squeal::tribology

#endif
