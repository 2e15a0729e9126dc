// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/force_charts.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    constexpr double kilonewton_per_millisecond = 1e-6; /**< of 1 N/s */

    ChartSeries
    line(const std::string &label, const Ink ink)
    {
      ChartSeries s;
      s.label = label;
      s.style = ChartSeries::Style::lines;
      s.ink   = ink;
      return s;
    }

    Chart
    loop_chart(const std::string &title,
               const std::string &over,
               const ChartSeries &loop)
    {
      Chart chart;
      chart.title   = title;
      chart.x.label = "normal force in N";
      chart.y.label = over;
      chart.series  = {loop};
      chart.legend  = Chart::Legend::none;
      return chart;
    }
  } // namespace



  void
  ForceCurve::add(const double t, const double n, const double t_along)
  {
    time.push_back(t);
    normal.push_back(n);
    tangential.push_back(t_along);
  }

  ForceCurve
  ForceCurve::last(const std::size_t n) const
  {
    ForceCurve result = *this;
    for (auto *x : {&result.time, &result.normal, &result.tangential})
      x->erase(x->begin(), x->end() - std::min(n, x->size()));
    return result;
  }



  Chart
  forces_over_time(const ForceCurve &curve, const std::string &title)
  {
    Chart chart;
    chart.title            = title;
    chart.x.label          = "time in ms";
    chart.y.label          = "force in N";
    ChartSeries normal     = line("normal", Ink::blue),
                tangential = line("tangential", Ink::vermillion);
    for (const double t : curve.time)
      normal.x.push_back(1e3 * t);
    tangential.x = normal.x;
    normal.y     = curve.normal;
    tangential.y = curve.tangential;
    chart.series = {normal, tangential};
    return chart;
  }

  std::vector<Chart>
  portraits(const ForceCurve &curve)
  {
    ChartSeries friction = line("", Ink::blue), rate = friction;
    friction.x = curve.normal;
    friction.y = curve.tangential;
    for (std::size_t i = 1; i + 1 < curve.time.size(); ++i)
      {
        rate.x.push_back(curve.normal[i]);
        rate.y.push_back(kilonewton_per_millisecond *
                         (curve.normal[i + 1] - curve.normal[i - 1]) /
                         (curve.time[i + 1] - curve.time[i - 1]));
      }
    return {
      loop_chart("Friction", "tangential force in N", friction),
      loop_chart("Phase portrait", "rate of the normal force in kN/ms", rate)};
  }
} // namespace squeal
