// SPDX-License-Identifier: LGPL-2.1-or-later
// Axes of charts show all values and carry the ticks a person would choose.
#include <squeal/results/axis.h>

#include <cmath>
#include <limits>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using Scale = AxisSettings::Scale;

namespace
{
  AxisSettings
  settings(const Scale scale, const double linear_width = 1.)
  {
    AxisSettings s;
    s.scale        = scale;
    s.linear_width = linear_width;
    return s;
  }

  std::string
  texts(const Axis &axis)
  {
    std::string all;
    for (const Axis::Tick &tick : axis.ticks())
      if (!tick.text.empty())
        all += (all.empty() ? "" : " ") + tick.text;
    return all;
  }

  void
  test_linear()
  {
    AxisSettings s = settings(Scale::linear);
    s.lower        = 0.;
    s.upper        = 20.;
    check(texts(Axis(s, {})) == "0 5 10 15 20", "round numbers on 0 to 20");
    s.lower = -1.;
    s.upper = 1.;
    check(texts(Axis(s, {})) == "−1.0 −0.5 0.0 0.5 1.0",
          "decimals are as many as the step needs, zero has no sign");
    const Axis axis(settings(Scale::linear), {3., 7.});
    check(axis.position(3.) > 0. && axis.position(7.) < 1. &&
            axis.position(5.) == 0.5,
          "values stand inside, with room at the ends");
    const Axis one(settings(Scale::linear), {1e9});
    check(one.position(1e9) > 0.2 && one.position(1e9) < 0.8,
          "a single value makes an axis");
    check(Axis(settings(Scale::linear), {}).ticks().size() > 1 &&
            Axis(settings(Scale::linear), {NAN, INFINITY}).ticks().size() > 1,
          "so does none, and what is not finite");
  }

  void
  test_logarithmic()
  {
    AxisSettings s = settings(Scale::logarithmic);
    s.lower        = 1e-12;
    s.upper        = 1e-8;
    check(texts(Axis(s, {})) == "10⁻¹² 10⁻¹¹ 10⁻¹⁰ 10⁻⁹ 10⁻⁸",
          "decades as powers");
    s.lower = 1.;
    s.upper = 50.;
    check(texts(Axis(s, {})) == "1 2 5 10 20 50", "a short range has 1, 2, 5");
    const Axis axis(settings(Scale::logarithmic), {0., -1., 1., 100.});
    check(std::isnan(axis.position(0.)) && !axis.contains(-1.) &&
            std::abs(axis.position(10.) - 0.5) < 1e-12,
          "zero and negative values have no place");
    s.lower = 1e-30;
    s.upper = 1.;
    const Axis  long_axis(s, {});
    std::size_t n = 0;
    for (const Axis::Tick &tick : long_axis.ticks())
      n += !tick.text.empty();
    check(n >= 5 && n <= 12, "thirty decades are not all labelled");
  }

  void
  test_signed()
  {
    const Axis axis(settings(Scale::signed_logarithmic, 10.), {-1000., 1000.});
    check(texts(axis) == "−1000 −100 −10 0 10 100 1000",
          "decades on both sides of zero");
    check(std::abs(axis.position(0.) - 0.5) < 1e-12 &&
            std::abs(axis.position(-30.) + axis.position(30.) - 1.) < 1e-12,
          "the same on both sides");
    double last   = -1.;
    bool   rising = true;
    for (double x = -1000.; x <= 1000.; x += 7.)
      {
        rising = rising && axis.position(x) > last;
        last   = axis.position(x);
      }
    check(rising, "positions rise through zero");
  }

  void
  test_marks()
  {
    AxisSettings s = settings(Scale::linear);
    s.marks        = {{1., "one", false}, {0., "zero", true}};
    const Axis axis(s, {0., 1.});
    check(texts(axis) == "zero one" && axis.ticks()[0].highlighted,
          "marks replace ticks");
  }
} // namespace

int
main()
{
  test_linear();
  test_logarithmic();
  test_signed();
  test_marks();
}
