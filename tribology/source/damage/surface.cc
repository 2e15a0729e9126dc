// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/damage/surface.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace squeal::tribology
{
  namespace
  {
    bool
    is_closed(const ContactStatus status)
    {
      return status != ContactStatus::open;
    }

    void
    count_change(SurfaceSums        &sum,
                 const ContactStatus before,
                 const ContactStatus now)
    {
      if (is_closed(now) && !is_closed(before))
        sum.impacts += 1.;
      if (is_closed(now) && is_closed(before) && now != before)
        sum.stick_slip += 1.;
    }
  } // namespace



  double
  SurfaceSums::duty() const
  {
    return duration > 0. ? contact_time / duration : 0.;
  }



  double
  SurfaceSums::mean_pressure() const
  {
    return duration > 0. ? pressure_time / duration : 0.;
  }



  SurfaceSummer::SurfaceSummer(const HistoryLayout      &layout,
                               const SurfaceParameters  &rules,
                               std::vector<StatusChange> all_changes)
    : layout(layout)
    , rules(rules)
    , result(layout.n_nodes())
    , last(layout.n_nodes())
    , is_loading(layout.n_nodes(), 0)
    , changes(std::move(all_changes))
    , changed_at(layout.n_nodes(), -std::numeric_limits<double>::infinity())
  {
    std::stable_sort(changes.begin(),
                     changes.end(),
                     [](const StatusChange &a, const StatusChange &b) {
                       return a.time < b.time;
                     });
  }



  SurfaceSummer::Moment
  SurfaceSummer::moment(const HistorySamples &s,
                        const std::size_t     i,
                        const std::size_t     node) const
  {
    const std::size_t k = i * layout.n_nodes() + node;
    Moment            m;
    m.pressure   = s.pressure[k];
    double speed = 0.;
    if (layout.has_slip_rate)
      {
        const double vx = s.slip_rate[2 * k], vy = s.slip_rate[2 * k + 1];
        speed           = std::hypot(vx, vy);
        m.power         = s.traction[2 * k] * vx + s.traction[2 * k + 1] * vy;
        m.pressure_slip = m.pressure * speed;
      }
    if (layout.has_status)
      m.status = static_cast<ContactStatus>(s.status[k]);
    else if (m.pressure > rules.contact_pressure)
      m.status = layout.has_slip_rate && speed < rules.stick_speed
                   ? ContactStatus::stick
                   : ContactStatus::slip;
    m.is_closed = is_closed(m.status);
    return m;
  }



  void
  SurfaceSummer::take_changes(const double until)
  {
    for (; n_changes < changes.size() && changes[n_changes].time <= until;
         ++n_changes)
      {
        const auto &[time, node, status] = changes[n_changes];
        if (!has_last) // the first sample knows them
          continue;
        Moment      &before = last[node];
        SurfaceSums &sum    = result[node];
        if (is_closed(before.status))
          sum.contact_time += time - std::max(changed_at[node], last_time);
        count_change(sum, before.status, status);
        changed_at[node] = time;
        before.status    = status;
      }
  }



  void
  SurfaceSummer::add(const HistorySamples &s)
  {
    for (std::size_t i = 0; i < s.n_samples(); ++i)
      {
        const double dt = has_last ? s.time[i] - last_time : 0.;
        take_changes(s.time[i]);
        for (std::size_t node = 0; node < last.size(); ++node)
          {
            const Moment now    = moment(s, i, node);
            Moment      &before = last[node];
            SurfaceSums &sum    = result[node];
            // Of a history under tension it is negative.
            sum.peak_pressure = has_last
                                  ? std::max(sum.peak_pressure, now.pressure)
                                  : now.pressure;
            if (has_last)
              {
                const double push = .5 * dt * (before.pressure + now.pressure);
                const bool   closed_before = is_closed(before.status);
                sum.duration += dt;
                sum.contact_time +=
                  changed_at[node] > last_time
                    ? closed_before * (s.time[i] - changed_at[node])
                    : .5 * dt * (closed_before + now.is_closed);
                sum.pressure_time += push;
                sum.friction_energy += .5 * dt * (before.power + now.power);
                sum.pressure_slip +=
                  .5 * dt * (before.pressure_slip + now.pressure_slip);
                count_change(sum, before.status, now.status);
                if (now.is_closed && !before.is_closed)
                  {
                    sum.closures += 1.;
                    is_loading[node] = 1;
                  }
                if (is_loading[node] && now.pressure < before.pressure)
                  is_loading[node] = 0;
                if (is_loading[node])
                  sum.impulse += push;
              }
            before = now;
          }
        last_time = s.time[i];
        has_last  = true;
      }
  }



  const std::vector<SurfaceSums> &
  SurfaceSummer::sums() const
  {
    return result;
  }
} // namespace squeal::tribology
