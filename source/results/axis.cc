// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/axis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace squeal
{
  namespace
  {
    using Scale = AxisSettings::Scale;

    /** A step of 1, 2 or 5 times a power of ten, at least @p smallest. */
    double
    round_step(const double smallest)
    {
      const double decade = std::pow(10., std::floor(std::log10(smallest)));
      for (const double factor : {1., 2., 5.})
        if (factor * decade >= smallest * (1. - 1e-9))
          return factor * decade;
      return 10. * decade;
    }

    /** Decimals that a multiple of @p step needs. */
    int
    decimals_of(const double step)
    {
      return std::max(0,
                      static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    }

    std::string
    decade_text(const int exponent, const bool as_power)
    {
      if (as_power)
        return power_of_ten(exponent);
      return plain_number(std::pow(10., exponent), std::max(0, -exponent));
    }
  } // namespace



  std::string
  plain_number(const double value, const int n_decimals)
  {
    char text[64];
    std::snprintf(text, sizeof(text), "%.*f", n_decimals, std::abs(value));
    const bool is_zero =
      std::string(text).find_first_not_of("0.") == std::string::npos;
    return (value < 0. && !is_zero ? "\u2212" : "") + std::string(text);
  }



  std::string
  power_of_ten(const int exponent)
  {
    static const std::array<const char *, 10> digits = {{"\u2070",
                                                         "\u00b9",
                                                         "\u00b2",
                                                         "\u00b3",
                                                         "\u2074",
                                                         "\u2075",
                                                         "\u2076",
                                                         "\u2077",
                                                         "\u2078",
                                                         "\u2079"}};
    std::string text = exponent < 0 ? "10\u207b" : "10";
    for (const char c : std::to_string(std::abs(exponent)))
      text += digits[c - '0'];
    return text;
  }



  Axis::Axis(const AxisSettings &settings, const std::vector<double> &values)
    : settings(settings)
  {
    choose_range(values);
    if (!settings.marks.empty())
      for (const AxisSettings::Mark &mark : settings.marks)
        add_tick(mark.value, mark.text, mark.highlighted);
    else if (settings.scale == Scale::linear)
      add_linear_ticks();
    else if (settings.scale == Scale::logarithmic)
      add_logarithmic_ticks();
    else
      add_signed_ticks();
    std::stable_sort(
      tick_list.begin(), tick_list.end(), [](const Tick &a, const Tick &b) {
        return a.position < b.position;
      });
  }



  double
  Axis::transformed(const double value) const
  {
    if (settings.scale == Scale::logarithmic)
      return std::log10(value);
    if (settings.scale == Scale::signed_logarithmic)
      return std::asinh(value / settings.linear_width);
    return value;
  }



  void
  Axis::choose_range(const std::vector<double> &values)
  {
    std::vector<double> seen;
    for (const double value : values)
      if (std::isfinite(value) &&
          (value > 0. || settings.scale != Scale::logarithmic))
        seen.push_back(transformed(value));
    for (const auto &limit : {settings.lower, settings.upper})
      if (limit)
        seen.push_back(transformed(*limit));
    if (seen.empty())
      seen.push_back(0.);
    lower = *std::min_element(seen.begin(), seen.end());
    upper = *std::max_element(seen.begin(), seen.end());

    const double smallest_span =
      settings.scale == Scale::linear
        ? std::max(1e-9 * std::max(std::abs(lower), std::abs(upper)), 1e-300)
        : 0.5;
    if (upper - lower < smallest_span)
      {
        const double widening =
          settings.scale == Scale::linear
            ? std::max(0.05 * std::max(std::abs(lower), std::abs(upper)), 0.5)
            : 0.5;
        lower -= widening;
        upper += widening;
      }
    // room for the marker and its name
    const double room = 0.06 * (upper - lower);
    lower = settings.lower ? transformed(*settings.lower) : lower - room;
    upper = settings.upper ? transformed(*settings.upper) : upper + room;
    if (!(upper > lower))
      upper = lower + 1.;
  }



  double
  Axis::position(const double value) const
  {
    if (settings.scale == Scale::logarithmic && !(value > 0.))
      return std::numeric_limits<double>::quiet_NaN();
    return (transformed(value) - lower) / (upper - lower);
  }



  bool
  Axis::contains(const double value) const
  {
    const double place = position(value);
    return place > -1e-9 && place < 1. + 1e-9;
  }



  const std::vector<Axis::Tick> &
  Axis::ticks() const
  {
    return tick_list;
  }



  void
  Axis::add_tick(const double       value,
                 const std::string &text,
                 const bool         highlighted)
  {
    if (contains(value))
      tick_list.push_back({position(value), text, highlighted});
  }



  void
  Axis::add_linear_ticks()
  {
    const double step  = round_step((upper - lower) / 8.);
    const long   first = std::lround(std::ceil(lower / step - 1e-9));
    const long   last  = std::lround(std::floor(upper / step + 1e-9));
    for (long i = first; i <= last; ++i)
      add_tick(i * step, plain_number(i * step, decimals_of(step)));
  }



  void
  Axis::add_logarithmic_ticks()
  {
    const int  first    = static_cast<int>(std::floor(lower + 1e-9));
    const int  last     = static_cast<int>(std::ceil(upper - 1e-9));
    const int  skip     = std::max(1, (last - first) / 10 + 1);
    const bool as_power = lower < -3.01 || upper > 4.01;
    // within two decades the powers alone would leave the reader guessing
    const bool label_steps = upper - lower < 2. && !as_power;
    for (int exponent = first; exponent <= last; ++exponent)
      {
        const double decade = std::pow(10., exponent);
        if (exponent % skip == 0)
          add_tick(decade, decade_text(exponent, as_power));
        for (int factor = 2; factor < 10 && skip == 1; ++factor)
          add_tick(factor * decade,
                   label_steps && (factor == 2 || factor == 5)
                     ? plain_number(factor * decade, std::max(0, -exponent))
                     : "");
      }
  }



  void
  Axis::add_signed_ticks()
  {
    add_tick(0., "0");
    const double largest =
      settings.linear_width *
      std::sinh(std::max(std::abs(lower), std::abs(upper)));
    const int first =
      static_cast<int>(std::lround(std::log10(settings.linear_width)));
    const int  last = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
    const bool as_power = first < -3 || last > 4;
    for (const int sign : {-1, 1})
      for (int exponent = first; exponent <= last; ++exponent)
        {
          const double decade = sign * std::pow(10., exponent);
          add_tick(decade,
                   (sign < 0 ? "\u2212" : "") +
                     decade_text(exponent, as_power));
          for (int factor = 2; factor < 10; ++factor)
            add_tick(factor * decade, "");
        }
  }
} // namespace squeal
