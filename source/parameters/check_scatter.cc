// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <cmath>
#include <utility>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      /** Least share of a normal distribution between the ends of its axis. */
      constexpr double least_weight = 1e-3;

      /** Refuses a distribution that hardly reaches between the ends: values
       * would be drawn for ever. */
      void
      require_weight(const SweepAxisParameters &a, const std::string &section)
      {
        const bool is_log  = a.scale == SweepAxisParameters::Scale::logarithmic;
        const bool is_list = a.scale == SweepAxisParameters::Scale::list;
        double     low     = is_list ? a.values.front() : a.from[0];
        double     high    = is_list ? a.values.back() : a.to[0];
        if (is_log)
          {
            low  = std::log10(low);
            high = std::log10(high);
          }
        if (low > high)
          std::swap(low, high);
        const double unit   = std::sqrt(2.) * a.deviation;
        const double weight = low == high
                                ? 0.
                                : 0.5 * (std::erfc((low - a.mean) / unit) -
                                         std::erfc((high - a.mean) / unit));
        if (weight < least_weight)
          refuse_entry(section,
                       "Mean",
                       "= " + format_number(a.mean) +
                         " with 'Deviation = " + format_number(a.deviation) +
                         "' leaves less than 0.1 % of the distribution between "
                         "the ends " +
                         format_number(low) + " and " + format_number(high) +
                         (is_log ? ", the common logarithms of this "
                                   "logarithmic axis"
                                 : ""));
      }
    } // namespace



    void
    check_scatter(const SweepParameters &s, const SweepAxisParameters &a)
    {
      const std::string section = "Sweep/Axis " + a.name;
      if (a.distribution == SweepAxisParameters::Distribution::uniform)
        {
          for (const auto &[name, value] :
               {std::make_pair("Mean", a.mean),
                std::make_pair("Deviation", a.deviation)})
            if (value != 0.)
              refuse_entry(section,
                           name,
                           "= " + format_number(value) +
                             " is of 'Distribution = normal', but this axis "
                             "has 'uniform'");
          return;
        }
      if (a.deviation == 0. && a.mean != 0.)
        refuse_entry(section,
                     "Mean",
                     "= " + format_number(a.mean) +
                       " needs a 'Deviation' above 0: without it a sixth of "
                       "the range about its middle is taken");
      if (a.deviation > 0. && s.scatter_samples > 0)
        require_weight(a, section);
    }
  } // namespace prm
} // namespace squeal
