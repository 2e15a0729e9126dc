// SPDX-License-Identifier: LGPL-2.1-or-later

// Growth rates of complex amplitudes and spectra of signals that are known.

#include "check.h"

#include <squeal/transient/common_period.h>
#include <squeal/transient/growth.h>
#include <squeal/transient/growth_rule.h>
#include <squeal/transient/spectrum.h>

#include <cmath>
#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  void
  rates()
  {
    std::minstd_rand                 generator(3);
    std::normal_distribution<double> noise(0., 1e-3);
    for (const double rate : {-80., 5., 400.})
      {
        std::vector<double>  times;
        std::vector<Complex> a;
        for (unsigned int i = 0; i < 2000; ++i)
          {
            times.push_back(2e-5 * i);
            a.push_back(
              std::exp(Complex(rate, 2. * M_PI * 3430.) * times.back()) *
              (1. + Complex(noise(generator), noise(generator))));
          }
        const auto      window = fit_window(a, 0, a.size(), rate < 0.);
        const GrowthFit fit = fit_growth(times, a, window.first, window.second);
        check(fit.is_valid, "a fit");
        check(std::abs(fit.rate - rate) <= 2. * fit.rate_ci,
              "the rate lies within twice its interval");
        check(fit.rate_ci < 0.1 + 0.01 * std::abs(rate), "which is narrow");
        check(std::abs(fit.frequency - 3430.) < 0.05, "frequency");
        check(std::abs(fit.e_foldings() -
                       std::abs(fit.rate) * (times[window.second - 1] -
                                             times[window.first])) < 1e-9,
              "e-foldings of the window");
      }
    check(!fit_growth({0., 1.}, {1., 1.}, 0, 2).is_valid,
          "two samples are no window");
  }

  /** Slopes of parts all over the place are no rate; decay and neutral motion
   * with narrow intervals are. Numbers of shipped scenes. */
  void
  rates_that_tell_nothing()
  {
    const auto tells = [](const double rate, const double ci) {
      GrowthFit fit;
      fit.rate      = rate;
      fit.rate_ci   = ci;
      fit.frequency = 1000.;
      fit.end       = .1;
      fit.is_valid  = true;
      return tells_a_rate(fit);
    };
    check(!tells(861.39, 1082.16) && !tells(-127.4, 1125.5) &&
            !tells(-316.71, 1063.51) && !tells(-204.77, 165.89) &&
            !tells(3., 11.),
          "intervals wider than half of the rate");
    check(tells(1220.54, 0.47) && tells(-2220.88, 246.89) &&
            tells(-5.19, 4.9) && tells(-8.21, .11) && tells(0.5, 9.),
          "rates with narrow intervals, also beside the threshold, count");
    const double nan = std::nan("");
    check(!tells(nan, 1.) && !tells(5., nan) && !tells_a_rate(GrowthFit()),
          "what is no number or no fit does not");

    // A decaying pair under the trace of a larger, growing one of nearly the
    // same frequency: parts of the window belong to the one or the other.
    std::vector<double>  times;
    std::vector<Complex> a;
    for (unsigned int i = 0; i < 2000; ++i)
      {
        const double t = 4e-6 * i;
        times.push_back(t);
        a.push_back(std::exp(Complex(-1925., 2. * M_PI * 6636.) * t) +
                    1e-3 * std::exp(Complex(1220., 2. * M_PI * 6684.) * t));
      }
    const GrowthFit mixed = fit_growth(times, a, 0, a.size());
    check(mixed.is_valid && !tells_a_rate(mixed),
          "nor does a decaying pair hidden by a growing one: " +
            std::to_string(mixed.rate) + " +- " +
            std::to_string(mixed.rate_ci));
  }

  /** The trace of another motion of one and a half times the frequency: within
   * a period its slope looks like a rate with a narrow interval; over some it
   * does not. */
  void
  rates_of_few_periods()
  {
    const Complex lambda(387., 2. * M_PI * 1429.),
      trace(0., .5 * lambda.imag());
    std::vector<double>  times;
    std::vector<Complex> a;
    for (unsigned int i = 0; i < 5000; ++i)
      {
        const double t = 2e-6 * i;
        times.push_back(t);
        a.push_back(std::exp(lambda * t) *
                    (1. + .1 * std::exp(trace * t + Complex(0., 3.51))));
      }
    const auto over = [&](const double periods) {
      const auto n =
        static_cast<std::size_t>(periods * 2. * M_PI / lambda.imag() / 2e-6);
      return fit_growth(times, a, 0, n);
    };
    const GrowthFit part = over(.6);
    check(std::abs(part.rate - 387.) > part.rate_ci &&
            part.rate_ci < .5 * std::abs(part.rate),
          "a part of a beat looks like a rate: " + std::to_string(part.rate) +
            " +- " + std::to_string(part.rate_ci));
    check(!tells_a_rate(part) && !tells_a_rate(over(.9)) &&
            !tells_a_rate(over(3.9)),
          "fewer than four periods tell no rate");
    const GrowthFit whole = over(12.);
    check(tells_a_rate(whole) && std::abs(whole.rate - 387.) < whole.rate_ci,
          "more do: " + std::to_string(whole.rate) + " +- " +
            std::to_string(whole.rate_ci));
  }

  /** A rate that goes from 200 to 160 1/s, as where the trace of another motion
   * fades away: the interval about its mean reaches to both ends. */
  void
  rate_of_a_bent_curve()
  {
    const double         end = 0.012, mean = -180., change = 40.;
    std::vector<double>  times;
    std::vector<Complex> a;
    for (unsigned int i = 0; i < 1200; ++i)
      {
        const double t = 1e-5 * i;
        times.push_back(t);
        a.push_back(std::exp(
          Complex(mean * t + .5 * change * t * (t / end - 1.), 3e4 * t)));
      }
    const GrowthFit fit = fit_growth(times, a, 0, a.size());
    check(std::abs(fit.rate - mean) < .1, "the mean rate");
    check(fit.rate_ci > .49 * change && fit.rate_ci < .6 * change,
          "its interval reaches to the ends: " + std::to_string(fit.rate_ci));
  }

  // A turning mesh shifts the steady sliding by far more than the disturbance.
  void
  rates_beside_a_drift()
  {
    const Complex        lambda(400., 2. * M_PI * 6620.);
    std::vector<double>  times;
    std::vector<Complex> a, pure;
    for (unsigned int i = 0; i < 5000; ++i)
      {
        const double t = 4e-6 * i;
        times.push_back(t);
        pure.push_back(1e-4 * std::exp(lambda * t));
        a.push_back(pure.back() +
                    Complex(1., 0.5) * (1. + 20. * t + 4e3 * t * t));
      }
    const GrowthFit drifting = fit_growth(times, a, 1667, 5000);
    check(std::abs(drifting.rate - 400.) > 100. &&
            std::abs(drifting.frequency) < 1000.,
          "the drift hides the pair");
    const GrowthFit fit = fit_growth(times, without_drift(a, 38), 1667, 5000);
    check(std::abs(fit.rate - 400.) < 0.2 && fit.rate_ci < 2.,
          "without it the rate is there");
    check(std::abs(fit.frequency - 6620.) < 0.05, "and the frequency");
    const GrowthFit alone =
      fit_growth(times, without_drift(pure, 38), 1667, 4980);
    check(std::abs(alone.rate - 400.) < 1e-8 &&
            std::abs(alone.frequency - 6620.) < 1e-9,
          "taking a drift away changes no rate and no frequency");
  }

  void
  spectra()
  {
    const double        dt = 1e-5, f = 3433.7;
    std::vector<double> x, y;
    for (unsigned int i = 0; i < 8000; ++i)
      {
        const double phase = 2. * M_PI * f * dt * i;
        x.push_back(100. + 3. * std::cos(phase) + 0.5 * std::cos(2. * phase));
        y.push_back(50. + 2. * std::cos(phase - 1.));
      }
    const Spectrum s = power_spectrum(x, dt);
    check(std::abs(s.peak(900., 40e3) - f) < 0.5, "the largest line");
    check(std::abs(s.line_rms(f, 0.02) - 3. / std::sqrt(2.)) < 0.01,
          "rms of the line");
    check(std::abs(s.line_rms(2. * f, 0.01) - 0.5 / std::sqrt(2.)) < 0.01,
          "rms of its second harmonic");
    check(s.fundamental(900., 40e3) == s.peak(900., 40e3),
          "a weaker second harmonic leaves the frequency");
    std::vector<double> z = x;
    for (unsigned int i = 0; i < z.size(); ++i)
      z[i] += 8. * std::cos(4. * M_PI * f * dt * i) +
              2. * std::cos(6. * M_PI * f * dt * i);
    const Spectrum strong = power_spectrum(z, dt);
    check(std::abs(strong.peak(900., 40e3) - 2. * f) < 0.5,
          "the second harmonic is the largest line");
    check(std::abs(strong.fundamental(900., 40e3) - f) < 0.5,
          "the period is that of the first");
    check(std::abs(strong.fundamental(4000., 40e3) - 2. * f) < 0.5,
          "no frequency below the band");
    check(std::abs(phase_difference(x, y, dt, f) + 180. / M_PI) < 0.5,
          "the second signal lags by 1 rad");
    const PhaseHistory h     = phase_history(x, y, 0.5, dt, f + 5., 1e-3);
    bool               right = h.time.size() > 20;
    for (std::size_t i = 0; i < h.time.size(); ++i)
      right = right && std::abs(h.phase[i] + 180. / M_PI) < 0.5 &&
              std::abs(h.amplitude_a[i] - 3.) < 0.01 &&
              std::abs(h.amplitude_b[i] - 2.) < 0.01;
    check(right, "the same lag and amplitudes in every window, 5 Hz beside");
    check(std::abs(h.time.front() - 0.5 - 0.5 * 20. / f) < 2. * dt,
          "the time is the middle of the window");
    check(std::isnan(phase_history(x, y, 0., dt, f, 2.5).phase.front()),
          "no phase below the gate");
    check(repetition(x, dt, f) > 0.9999, "a periodic signal repeats itself");
    std::vector<double> beating = x;
    for (unsigned int i = 0; i < x.size(); ++i)
      beating[i] +=
        3. * std::cos(2. * M_PI * 4877.3 * dt * i * (1. + 2e-5 * i));
    const double half = repetition(beating, dt, f);
    check(half > 0.4 && half < 0.75,
          "one with as much power elsewhere to about a half");
    double       sum   = 0.;
    const auto   parts = power_spectrum(x, dt, 5);
    const double df    = parts.frequency[1];
    for (const double density : parts.density)
      sum += density * df;
    check(std::abs(sum - (9. + 0.25) / 2.) < 0.05,
          "the density adds up to the variance");
  }

  // Sum of cosines of given frequencies (Hz) and amplitudes.
  std::vector<double>
  tones(const double                                  interval,
        const std::vector<std::pair<double, double>> &lines)
  {
    std::vector<double> x(8000, 0.);
    for (std::size_t i = 0; i < x.size(); ++i)
      for (const auto &[frequency, amplitude] : lines)
        x[i] += amplitude * std::cos(2. * M_PI * frequency * interval * i);
    return x;
  }

  void
  periods()
  {
    const double dt = 1e-5, f = 3433.7;
    const auto   fundamental = [&](const std::vector<double> &x) {
      return power_spectrum(x, dt).fundamental(900., 45e3);
    };
    const auto is = [](const double a, const double b) {
      return std::abs(a - b) < 0.5;
    };
    check(is(fundamental(tones(dt, {{f, 1.}})), f), "a pure tone");
    check(is(fundamental(tones(dt, {{f, 1.}, {0.5 * f, 0.01}})), f),
          "a tone with 1e-4 of its power at half its frequency repeats itself "
          "to 0.9998 with its own period");
    check(is(fundamental(tones(dt, {{f, 1.}, {0.5 * f, 0.4}})), 0.5 * f),
          "with 14 % of the power there to 0.72 only: the period is twice as "
          "long");
    check(
      is(fundamental(tones(dt, {{2. * f, 0.6}, {3. * f, 1.}, {4. * f, 0.7}})),
         f),
      "harmonics 2, 3 and 4 have the period of the first, which is absent");
    // Four lines beside the multiples, 2 % of the power each: none of them is
    // on the comb of half the largest line, and all are against its phase.
    const auto beside = tones(dt,
                              {{4. * f, 1.},
                               {1.96 * f, 0.14},
                               {2.04 * f, 0.14},
                               {5.96 * f, 0.14},
                               {6.04 * f, 0.14}});
    check(is(fundamental(beside), 2. * f),
          "twice the period where weak lines beside the multiples make it");
    check(repetition(beside, dt, 2. * f) > 0.95,
          "with which the signal repeats itself");
    const auto two = tones(dt, {{f, 1.}, {std::sqrt(2.) * f, 0.7}});
    check(is(fundamental(two), f),
          "two tones of no common period: the larger one");
    std::minstd_rand                 generator(5);
    std::normal_distribution<double> normal;
    unsigned int                     n_lines = 0;
    for (unsigned int sample = 0; sample < 20; ++sample)
      {
        std::vector<double> noise;
        for (unsigned int i = 0; i < 8000; ++i)
          noise.push_back(normal(generator));
        const Spectrum s = power_spectrum(noise, dt);
        if (s.fundamental(900., 45e3) == s.peak(900., 45e3))
          ++n_lines;
        check(repetition(noise, dt, s.fundamental(900., 45e3)) < 0.1,
              "noise does not repeat itself");
      }
    check(n_lines == 20, "and has no period other than that of its line");
  }

  /** The sum of what goes round, and both its moments; a ring beside a far
   * louder stick-slip. */
  void
  common_periods()
  {
    const double dt = 1e-5, f = 3433.7;
    const auto   period_of = [&](const std::vector<MotionSignal> &signals) {
      return common_period(signals, dt, 300., 45e3);
    };
    const MotionSignal sum{tones(dt, {{2. * f, 1.}, {4. * f, .2}})};
    const auto         moment = [&](const double size) {
      return MotionSignal{tones(dt, {{f, size}, {3. * f, .1 * size}})};
    };
    const CommonPeriod alone = period_of({sum});
    check(std::abs(alone.frequency - 2. * f) < .5, "its own period");
    for (const double size : {.5, 20.})
      {
        const CommonPeriod with = period_of({sum, moment(size), moment(size)});
        check(std::abs(with.frequency - f) < .5,
              "the period of the moments, which is twice as long: " +
                std::to_string(with.frequency));
        check(std::abs(with.largest_line - 2. * f) < .5 &&
                with.repetition > .99 && with.frequency_ci < 1.,
              "with the line of the sum");
      }
    check(period_of({sum, moment(.1)}).frequency == alone.frequency,
          "a weak one does not count");
    const MotionSignal third{tones(dt, {{3. * f, 1.}})};
    check(std::abs(period_of({third, sum}).frequency - f) < .5,
          "of lines 2 and 3 the common period is that of line 1");
    const MotionSignal other{tones(dt, {{.137 * f, 9.}})};
    const CommonPeriod none = period_of({sum, other});
    check(std::abs(none.frequency - .137 * f) < .5,
          "without a common period the loudest tells: " +
            std::to_string(none.frequency));
    check(std::abs(none.largest_line - .137 * f) < .5,
          "and the largest line is its own: " +
            std::to_string(none.largest_line));
    // As a pin on a disc has them.
    const double       beside = .0203 * f;
    const MotionSignal modulated{
      tones(dt, {{2. * f, 1.}, {2. * (f - beside), .2}, {f - beside, .15}})},
      more{tones(dt, {{f - beside, 1.}, {f + beside, .3}})};
    const CommonPeriod all = period_of({modulated, more});
    check(std::abs(all.frequency - f) < .5 &&
            std::abs(all.largest_line - 2. * f) < .5,
          "where lines lie beside the multiples the largest one is a multiple "
          "all the same: " +
            std::to_string(all.frequency) + ", " +
            std::to_string(all.largest_line));
    std::minstd_rand                 generator(7);
    std::normal_distribution<double> normal;
    MotionSignal                     noise{{}, true};
    for (unsigned int i = 0; i < 8000; ++i)
      noise.values.push_back(normal(generator));
    check(period_of({sum, noise}).frequency == alone.frequency,
          "a place that rattles on its own does not count");
  }

  void
  deviations()
  {
    const double dt = 1e-5, f = 3433.7;
    auto         x          = tones(dt, {{f, 1.}});
    const double throughout = line_deviation(x, dt, f);
    // The lines of a quarter are 50 Hz apart; a parabola through the logarithms
    // of Hann's lobe is off by up to 2 % of that.
    check(throughout < 1., "a pure tone has its line in every quarter");
    for (std::size_t i = 4000; i < 6000; ++i)
      x[i] = 0.;
    check(line_deviation(x, dt, f) <= throughout,
          "a quarter without a line does not count");
    for (std::size_t i = 0; i < 2000; ++i)
      x[i] = std::cos(2. * M_PI * (f - 30.) * dt * i);
    check(std::abs(line_deviation(x, dt, f) - 30.) < 1.5,
          "the worst of the others does");
    check(std::isnan(line_deviation(std::vector<double>(8000, 0.), dt, f)),
          "there is no deviation where no quarter has a line");
    check(std::isnan(line_deviation({x.begin(), x.begin() + 100}, dt, f)),
          "nor where the quarters are too short to tell");
  }
} // namespace

int
main()
{
  rates();
  rates_that_tell_nothing();
  rates_of_few_periods();
  rate_of_a_bent_curve();
  rates_beside_a_drift();
  spectra();
  periods();
  common_periods();
  deviations();
}
