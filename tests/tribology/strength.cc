// SPDX-License-Identifier: LGPL-2.1-or-later

// S-N curves, mean stress and spectral damage against closed forms.
#include <squeal/base/exceptions.h>
#include <squeal/tribology/fatigue/damage_counter.h>
#include <squeal/tribology/fatigue/spectral.h>

#include <functional>
#include <random>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  using Kind = FatigueParameters::MeanStress;

  /** Closed forms are met to rounding; 1e-9 is what is asked for. */
  constexpr double closed = 1e-9;

  double
  corrected(const Kind kind, const double constant, const double mean)
  {
    return MeanStressCorrection(kind, constant)
      .equivalent_amplitude(100., mean);
  }

  void
  mean_stress()
  {
    // one unit of the last printed digit: Walker's 115.2476134 is printed as
    // 115.247614
    const double printed = 1e-6;
    const auto   is =
      [&](const double a, const double b, const std::string &name) {
        check(std::abs(a - b) <= printed, name + " " + std::to_string(a));
      };
    is(corrected(Kind::goodman, 400., 50.), 114.285714, "Goodman");
    is(corrected(Kind::gerber, 400., 50.), 101.587302, "Gerber");
    is(corrected(Kind::morrow, 700., 50.), 107.692308, "Morrow");
    is(corrected(Kind::swt, 0., 50.), 122.474487, "SWT");
    is(corrected(Kind::walker, .65, 50.), 115.247614, "Walker");
    is(corrected(Kind::goodman, 400., -50.), 88.888889, "Goodman, compression");
    is(corrected(Kind::swt, 0., -50.), 70.710678, "SWT, compression");
    is(corrected(Kind::walker, .65, -50.), 78.458410, "Walker, compression");
    check(corrected(Kind::gerber, 400., -50.) == 100.,
          "Gerber stays 100 under compression");
    check_close(
      corrected(Kind::goodman, 400., 50.), 800. / 7., closed, "Goodman");
    check_close(corrected(Kind::walker, .65, 50.),
                100. * std::pow(1.5, .35),
                closed,
                "Walker in closed form");
    check_close(corrected(Kind::walker, .5, 50.),
                corrected(Kind::swt, 0., 50.),
                closed,
                "Walker with 1/2 is SWT");
    check(corrected(Kind::swt, 0., -150.) == 0. &&
            std::isinf(corrected(Kind::goodman, 400., 400.)),
          "closed cracks do not grow; the strength is the end");
  }

  void
  curves()
  {
    SnCurve c;
    c.exponent         = 5.;
    c.constant         = 1e12;
    c.reference_stress = 1.;
    const double n     = 3437. * 1200.;
    check(n == 4124400., "a sine of 3437 Hz has 4124400 cycles in 1200 s");
    check_close(
      n * c.damage(7.5), 0.0978739453125, closed, "sine of amplitude 7.5");
    // the same by counting: whole cycles from peak to peak
    FatigueParameters f;
    f.exponents               = {5.};
    f.constants               = {1e12};
    f.reference_stress        = 1.;
    f.residue                 = FatigueParameters::Residue::repeating;
    const CountingRules rules = counting_rules(f);
    DamageCounter       counter(rules);
    std::vector<double> sine;
    for (unsigned int i = 0; i < 16 * 1000; ++i)
      sine.push_back(7.5 * std::sin(2. * M_PI * (i % 16) / 16.));
    counter.add(sine.data(), sine.size());
    counter.finish();
    check_close(counter.damages()[0] * n / 1000.,
                0.0978739453125,
                closed,
                "the same counted");

    for (const double m : {3., 4.25, 10.})
      {
        c.exponent = m;
        check_close(c.damage(7.5) * std::pow(7.5, -m) * 1e12,
                    1.,
                    closed,
                    "power " + std::to_string(m));
      }
    c.exponent        = 5.;
    c.knee_stress     = 4.;
    c.second_exponent = 9.;
    check_close(c.life(4.), 1e12 / 1024., closed, "bilinear: at the knee");
    check_close(
      c.life(2.), 1e12 / 1024. * 512., closed, "bilinear: below the knee");
    check_close(c.life(8.), 1e12 / 32768., closed, "bilinear: above the knee");
    c.endurance_limit = 2.;
    check(std::isinf(c.life(2.)) && !std::isinf(c.life(2.0001)),
          "endurance limit");
    std::vector<double> amplitudes(2000), damages(2000);
    for (unsigned int i = 0; i < 2000; ++i)
      amplitudes[i] = .01 * i;
    c.damage(amplitudes.data(), amplitudes.size(), damages.data());
    for (unsigned int i = 0; i < 2000; ++i)
      if (damages[i] != c.damage(amplitudes[i]))
        check(false, "many at once are as one by one");
  }

  void
  check_spectrum(const double                 density,
                 const double                 from,
                 const double                 to,
                 const SnCurve               &curve,
                 const std::array<double, 4> &moments,
                 const double                 dirlik,
                 const double                 dirlik_digits,
                 const double                 narrow,
                 const std::string           &name)
  {
    Spectrum           s;
    const unsigned int n = 50;
    for (unsigned int i = 0; i <= n; ++i)
      {
        s.frequency.push_back(from + (to - from) * i / n);
        s.density.push_back(density);
      }
    const std::array<double, 5> m = s.moments();
    for (const auto &[got, expected] : {std::pair{m[0], moments[0]},
                                        {m[1], moments[1]},
                                        {m[2], moments[2]},
                                        {m[4], moments[3]}})
      check(std::abs(got - expected) <= std::max(closed * expected, 5.1e-4),
            name + ": moment " + std::to_string(expected));
    check_close(m[2],
                density * (to * to * to - from * from * from) / 3.,
                closed,
                name + ": second moment in closed form");
    check(std::abs(dirlik_damage(m, curve) - dirlik) <= dirlik_digits,
          name + ": Dirlik " + std::to_string(dirlik_damage(m, curve)));
    check(std::abs(narrow_band_damage(m, curve) - narrow) <= 5.1e-11,
          name + ": narrow band " +
            std::to_string(narrow_band_damage(m, curve)));
  }

  void
  spectra()
  {
    SnCurve c;
    c.reference_stress = 1.;
    c.exponent         = 5.;
    c.constant         = 1e10;
    check_spectrum(1.,
                   0.,
                   100.,
                   c,
                   {{100., 5000., 333333.333, 2e9}},
                   0.00804970285,
                   5.1e-12,
                   0.0108540188,
                   "flat to 100 Hz");
    c.exponent = 3.;
    c.constant = 1e8;
    // Dirlik's formula gives 0.01041856871, printed as 0.0104185686
    check_spectrum(2.,
                   50.,
                   150.,
                   c,
                   {{200., 2e4, 2166666.667, 3.025e10}},
                   0.0104185686,
                   1.2e-10,
                   0.0110689708,
                   "flat from 50 to 150 Hz");
    check(dirlik_damage({{0., 0., 0., 0., 0.}}, c) == 0. &&
            narrow_band_damage({{0., 0., 0., 0., 0.}}, c) == 0.,
          "no power, no damage");

    // Welch: a sine keeps its variance, noise its level
    const double        rate = 1024.;
    WelchEstimator      welch(256, rate);
    std::vector<double> v;
    for (unsigned int i = 0; i < 20000; ++i)
      v.push_back(5. + 3. * std::sin(2. * M_PI * 100. * i / rate));
    welch.add(v.data(), 777);
    welch.add(&v[777], v.size() - 777);
    const std::array<double, 5> m = welch.spectrum().moments();
    check_close(m[0], 4.5, 1e-6, "Welch: variance of a sine");
    check_close(std::sqrt(m[2] / m[0]), 100., 2e-3, "Welch: its frequency");
    std::mt19937_64                  generator(1);
    std::normal_distribution<double> normal;
    WelchEstimator                   flat(256, rate);
    for (unsigned int i = 0; i < 400000; ++i)
      {
        const double x = normal(generator);
        flat.add(&x, 1);
      }
    // 3124 half-overlapping windows of 129 lines: 0.3 % of spread
    check_close(
      flat.spectrum().moments()[0], 1., 1.5e-2, "Welch: variance of noise");
  }

  /** What belongs to another model, rule or criterion is not passed over. */
  void
  unused_entries()
  {
    using F = FatigueParameters;
    using S = SubsurfaceParameters;
    using C = S::Criterion;
    check_fatigue(F());
    check_subsurface(S());
    const std::vector<std::pair<std::string, std::function<void(F &)>>>
      of_fatigue = {
        {"Knee stress", [](F &f) { f.knee_stress = 5e6; }},
        {"Second exponent", [](F &f) { f.second_exponent = 30.; }},
        {"Ultimate strength", [](F &f) { f.ultimate_strength = 1e7; }},
        {"Strength coefficient", [](F &f) { f.strength_coefficient = 1e7; }},
        {"Walker exponent", [](F &f) { f.walker_exponent = .5; }}};
    for (const auto &[entry, set] : of_fatigue)
      {
        F f;
        set(f);
        check_throws<InputError>([&f]() { check_fatigue(f); },
                                 "'Fatigue/" + entry + "' is set but not used",
                                 entry + " without its rule");
      }
    F used;
    used.model             = F::Model::bilinear;
    used.knee_stress       = 5e6;
    used.second_exponent   = 30.;
    used.mean_stress       = Kind::gerber;
    used.ultimate_strength = 1e7;
    check_fatigue(used);
    used.quantity = F::Quantity::traction_y;
    check_throws<InputError>([&used]() { check_fatigue(used); },
                             "'Fatigue/Mean stress' is for normal stresses",
                             "a mean stress of a traction");
    used          = F();
    used.quantity = F::Quantity::traction_y;
    check_fatigue(used);
    const std::vector<std::pair<std::string, std::function<void(S &)>>>
      of_criteria = {
        {"Torsion ratio", [](S &s) { s.torsion_ratio = .6; }},
        {"Repeated limit", [](S &s) { s.repeated_limit = 1e7; }},
        {"Yield stress", [](S &s) { s.yield_stress = 1e7; }},
        {"Fatemi Socie factor", [](S &s) { s.fatemi_socie_k = 1.; }},
        {"Tensile strength", [](S &s) { s.tensile_strength = 1e7; }},
        {"Compressive strength", [](S &s) { s.compressive_strength = 1e7; }},
        {"Plane step", [](S &s) { s.plane_step = 10.; }},
        {"Finest cell", [](S &s) { s.finest_cell = 1e-4; }}};
    for (const auto &[entry, set] : of_criteria)
      {
        S s;
        s.criteria = {entry == "Tensile strength" ||
                          entry == "Compressive strength" ||
                          entry == "Plane step"
                        ? C::crossland
                        : C::rankine};
        set(s);
        check_throws<InputError>([&s]() { check_subsurface(s); },
                                 "'Subsurface/" + entry +
                                   "' is set but not used",
                                 entry + " without its criterion");
        s.compute = false;
        check_subsurface(s);
        s.compute       = true;
        s.pad_thickness = .01;
        s.criteria      = {C::sines, C::fatemi_socie, C::drucker_prager};
        check_subsurface(s);
      }
  }

  /** Counting agrees with Dirlik for the process he fitted. */
  void
  counted_noise()
  {
    FatigueParameters f;
    f.exponents                            = {3., 5.};
    f.reference_stress                     = 1.;
    const CountingRules              rules = counting_rules(f);
    DamageCounter                    counter(rules);
    WelchEstimator                   welch(1024, 1000.);
    std::mt19937_64                  generator(7);
    std::normal_distribution<double> normal;
    double                           a = 0., b = 0., e = 0.;
    const unsigned int               n = 2000000;
    for (unsigned int i = 0; i < n; ++i)
      {
        // low-pass noise, sampled 20 times over its band
        a += .1 * (normal(generator) - a);
        b += .1 * (a - b);
        e += .1 * (b - e);
        counter.add(&e, 1);
        welch.add(&e, 1);
      }
    counter.finish();
    const std::array<double, 5> m = welch.spectrum().moments();
    for (unsigned int c = 0; c < 2; ++c)
      {
        const double counted = counter.damages()[c] / (n / 1000.);
        const double dirlik  = dirlik_damage(m, rules.curves[c]);
        check_close(dirlik,
                    counted,
                    .15,
                    "Gaussian noise, m = " +
                      std::to_string(int(rules.curves[c].exponent)) +
                      ": Dirlik over counting " +
                      std::to_string(dirlik / counted));
        check(narrow_band_damage(m, rules.curves[c]) > counted,
              "the narrow band is on the safe side");
      }
  }
} // namespace



int
main()
{
  mean_stress();
  curves();
  spectra();
  unused_entries();
  counted_noise();
}
