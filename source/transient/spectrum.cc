// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/transient/spectrum.h>

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>

namespace squeal
{
  namespace
  {
    /** Sum of @p weight of the frequency times density over what is no drift. */
    template <typename Weight>
    double
    sum_in_band(const Spectrum &spectrum,
                const double    lowest,
                const double    highest,
                const Weight   &weight)
    {
      double sum = 0.;
      for (std::size_t k = 0; k < spectrum.density.size(); ++k)
        if (spectrum.frequency[k] >= 0.5 * lowest &&
            spectrum.frequency[k] <= highest)
          sum += weight(spectrum.frequency[k]) * spectrum.density[k];
      return sum;
    }

    /** Complex amplitude of samples first .. first + n - 1 about their mean at
     * a frequency in turns a sample, under a Hann window. */
    std::complex<double>
    demodulated(const std::vector<double> &x,
                const std::size_t          first,
                const std::size_t          n,
                const double               frequency)
    {
      double     weights = 0., mean = 0.;
      const auto window = [n](const std::size_t i) {
        return 0.5 * (1. - std::cos(2. * M_PI * (i + 0.5) / n));
      };
      for (std::size_t i = 0; i < n; ++i)
        {
          weights += window(i);
          mean += window(i) * x[first + i];
        }
      mean /= weights;
      std::complex<double> sum = 0.;
      for (std::size_t i = 0; i < n; ++i)
        sum += window(i) * (x[first + i] - mean) *
               std::polar(1., -2. * M_PI * frequency * (first + i));
      return 2. / weights * sum;
    }
  } // namespace



  double
  Spectrum::peak(const double lowest, const double highest) const
  {
    std::size_t best = 0;
    for (std::size_t k = 1; k + 1 < density.size(); ++k)
      if (frequency[k] >= lowest && frequency[k] <= highest &&
          (best == 0 || density[k] > density[best]))
        best = k;
    if (best == 0 || !(density[best] > 0.))
      return 0.;
    const double a         = std::log(std::max(density[best - 1], 1e-300)),
                 b         = std::log(density[best]),
                 c         = std::log(std::max(density[best + 1], 1e-300));
    const double curvature = a - 2. * b + c;
    const double shift     = curvature < 0. ? 0.5 * (a - c) / curvature : 0.;
    return frequency[best] + shift * (frequency[1] - frequency[0]);
  }



  double
  Spectrum::fundamental(const double lowest, const double highest) const
  {
    const double largest = peak(lowest, highest);
    if (!(largest > 0.))
      return 0.;
    const double step = frequency[1] - frequency[0];
    // Sums over what is no drift: all of it, what lies on the multiples of f,
    // and what is in phase again after a period of f.
    const auto sum_over = [&](const auto &weight) {
      return sum_in_band(*this, lowest, highest, weight);
    };
    const double all = sum_over([](const double) { return 1.; });
    // A Hann window spreads a line over four steps; where multiples lie closer
    // than a few of those they would hold everything.
    const auto share = [&](const double f) {
      return sum_over([&](const double g) {
               return std::abs(g - f * std::round(g / f)) <= 2.5 * step ? 1.
                                                                        : 0.;
             }) /
             all;
    };
    std::vector<double> candidates{largest};
    for (unsigned int k = 2; k <= 4 && largest / k > 40. * step; ++k)
      if (largest / k >= lowest)
        candidates.push_back(largest / k);

    std::vector<double> correlations;
    for (const double f : candidates)
      correlations.push_back(correlation(f, lowest, highest));
    const double best_correlation =
      *std::max_element(correlations.begin(), correlations.end());
    if (best_correlation >= 1. - most_aperiodic)
      for (std::size_t k = 0; k < candidates.size(); ++k)
        if (correlations[k] >= best_correlation - most_aperiodic)
          return candidates[k];

    double best = largest, best_share = share(largest);
    for (const double f : candidates)
      {
        // A denser comb holds more of a broad spectrum by chance alone.
        const double s = share(f), chance = 5. * step * (1. / f - 1. / best);
        if (s > best_share + least_power_share + chance)
          {
            best       = f;
            best_share = s;
          }
      }
    return best;
  }



  double
  Spectrum::correlation(const double f,
                        const double lowest,
                        const double highest) const
  {
    // By the spectrum it is that at a lag between the samples.
    const auto in_phase = [f](const double g) {
      return std::cos(2. * M_PI * g / f);
    };
    return sum_in_band(*this, lowest, highest, in_phase) /
           sum_in_band(*this, lowest, highest, [](const double) { return 1.; });
  }

  double
  Spectrum::power(const double lowest, const double highest) const
  {
    return density.size() < 2
             ? 0.
             : (frequency[1] - frequency[0]) *
                 sum_in_band(
                   *this, lowest, highest, [](const double) { return 1.; });
  }



  double
  Spectrum::line_rms(const double centre, const double relative_width) const
  {
    double sum = 0.;
    for (std::size_t k = 1; k < density.size(); ++k)
      if (std::abs(frequency[k] - centre) <= relative_width * centre)
        sum += density[k] * (frequency[1] - frequency[0]);
    return std::sqrt(sum);
  }



  Spectrum
  power_spectrum(const std::vector<double> &signal,
                 const double               interval,
                 const unsigned int         n_parts)
  {
    Spectrum          result;
    const std::size_t length = 2 * signal.size() / (n_parts + 1) / 2 * 2;
    if (length < 8)
      return result;
    double mean = 0.;
    for (const double x : signal)
      mean += x / signal.size();
    std::vector<double> window(length);
    double              power = 0.;
    for (std::size_t i = 0; i < length; ++i)
      {
        window[i] = 0.5 * (1. - std::cos(2. * M_PI * i / length));
        power += window[i] * window[i];
      }
    result.density.assign(length / 2 + 1, 0.);
    Eigen::FFT<double>                fft;
    std::vector<std::complex<double>> transformed;
    for (unsigned int part = 0; part < n_parts; ++part)
      {
        std::vector<double> x(length);
        const std::size_t   first = part * (length / 2);
        for (std::size_t i = 0; i < length; ++i)
          x[i] = window[i] * (signal[first + i] - mean);
        fft.fwd(transformed, x);
        for (std::size_t k = 0; k < result.density.size(); ++k)
          result.density[k] +=
            2. * std::norm(transformed[k]) * interval / power / n_parts;
      }
    for (std::size_t k = 0; k < result.density.size(); ++k)
      result.frequency.push_back(k / (length * interval));
    return result;
  }



  double
  phase_difference(const std::vector<double> &a,
                   const std::vector<double> &b,
                   const double               interval,
                   const double               frequency)
  {
    const auto A = demodulated(a, 0, a.size(), interval * frequency),
               B = demodulated(b, 0, b.size(), interval * frequency);
    return std::arg(B * std::conj(A)) * 180. / M_PI;
  }



  double
  repetition(const std::vector<double> &signal,
             const double               interval,
             const double               frequency)
  {
    const auto n = static_cast<Eigen::Index>(signal.size());
    // Sums over arrays of Eigen's own have the same bits wherever in memory
    // they are, which those over parts of a vector have not.
    const Eigen::ArrayXd all =
      Eigen::Map<const Eigen::ArrayXd>(signal.data(), n);
    const double step = 1. / (frequency * interval);
    double       best = 0.;
    for (unsigned int m = 1; m <= 20 && frequency > 0.; ++m)
      {
        const auto lag = static_cast<Eigen::Index>(std::round(m * step));
        if (2 * lag > n)
          break;
        Eigen::ArrayXd now = all.head(n - lag), later = all.tail(n - lag);
        now -= now.mean();
        later -= later.mean();
        const double size = now.matrix().norm() * later.matrix().norm();
        if (size > 0.)
          best = std::max(best, (now * later).sum() / size);
      }
    return best;
  }



  double
  line_deviation(const std::vector<double> &signal,
                 const double               interval,
                 const double               frequency)
  {
    double worst = std::nan("");
    for (unsigned int k = 0; k < 4; ++k)
      if (const double line =
            power_spectrum({signal.begin() + k * signal.size() / 4,
                            signal.begin() + (k + 1) * signal.size() / 4},
                           interval)
              .peak(0.9 * frequency, 1.1 * frequency);
          line > 0.)
        worst = std::fmax(worst, std::abs(line - frequency));
    return worst;
  }



  PhaseHistory
  phase_history(const std::vector<double> &a,
                const std::vector<double> &b,
                const double               start,
                const double               interval,
                const double               frequency,
                const double               gate,
                const double               n_periods)
  {
    PhaseHistory history;
    if (!(frequency > 0.))
      return history;
    const std::size_t n = std::lround(n_periods / frequency / interval);
    for (std::size_t first = 0; n > 1 && first + n <= a.size();
         first += std::max<std::size_t>(1, n / 2))
      {
        const auto A = demodulated(a, first, n, interval * frequency),
                   B = demodulated(b, first, n, interval * frequency);
        history.time.push_back(start + interval * (first + 0.5 * (n - 1)));
        history.amplitude_a.push_back(std::abs(A));
        history.amplitude_b.push_back(std::abs(B));
        history.phase.push_back(std::min(std::abs(A), std::abs(B)) < gate
                                  ? std::nan("")
                                  : std::arg(B * std::conj(A)) * 180. / M_PI);
      }
    return history;
  }
} // namespace squeal
