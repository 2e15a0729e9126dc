// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/worst_of.h>
#include <squeal/sweep/stability.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Sigma less what rounding makes of it: an undamped pair has one of either
     * sign, a few digits of its condition large. */
    double
    certain_sigma(const ComplexPairs &pairs, const int i)
    {
      return pairs.sigma(i) - 1e-14 * std::min(pairs.condition[i], 1e8) *
                                std::abs(pairs.lambda[i]);
    }

    /** At the complex @p z, of the polynomial through four points. */
    Complex
    interpolated(const double (&x)[4], const Complex (&y)[4], const Complex z)
    {
      Complex sum = 0.;
      for (int i = 0; i < 4; ++i)
        {
          Complex term = y[i];
          for (int k = 0; k < 4; ++k)
            if (k != i)
              term *= (z - x[k]) / (x[i] - x[k]);
          sum += term;
        }
      return sum;
    }

    /** The root nearest to @p start of the polynomial through four points. */
    Complex
    interpolated_root(const double (&x)[4],
                      const Complex (&y)[4],
                      Complex start)
    {
      // Divided differences.
      Complex c[4] = {y[0], y[1], y[2], y[3]};
      for (int k = 1; k < 4; ++k)
        for (int i = 3; i >= k; --i)
          c[i] = (c[i] - c[i - 1]) / (x[i] - x[i - k]);
      for (unsigned int step = 0; step < 50; ++step)
        {
          Complex value = c[3], slope = 0.;
          for (int i = 2; i >= 0; --i)
            {
              slope = slope * (start - x[i]) + value;
              value = value * (start - x[i]) + c[i];
            }
          if (slope == 0.)
            break;
          const Complex change = value / slope;
          start -= change;
          if (std::abs(change) <= 1e-15 * std::abs(start))
            break;
        }
      return start;
    }
  } // namespace



  LineStability::LineStability(const BranchTracker::Solver &s,
                               const TrackingOptions       &o,
                               const double                 t)
    : solver(s)
    , options(o)
    , tolerance(t)
  {
  }

  double
  LineStability::At::sigma() const
  {
    return pair < 0 ? std::nan("") : certain_sigma(pairs, pair);
  }

  LineStability::At
  LineStability::continue_pair(const TrackedPoint &near,
                               const int           pair,
                               const double        x) const
  {
    At result;
    result.pairs            = solver(x);
    const PairMatches match = match_pairs(near.pairs, result.pairs, options);
    result.pair             = match.to[pair];
    if (result.pair >= 0)
      return result;
    // In doubt the nearest eigenvalue, of two the one with larger sigma.
    double distance = 1e300;
    for (unsigned int i = 0; i < result.pairs.size(); ++i)
      if (const double d =
            std::abs(result.pairs.lambda[i] - near.pairs.lambda[pair]);
          d < distance)
        {
          distance    = d;
          result.pair = i;
        }
    return result;
  }



  double
  LineStability::edge(const TrackedPoint &a,
                      const TrackedPoint &b,
                      const int           branch,
                      double             &slope) const
  {
    const int i = a.pair_of(branch), j = b.pair_of(branch);
    double    x0 = a.coordinate, x1 = b.coordinate;
    double    s0 = certain_sigma(a.pairs, i), s1 = certain_sigma(b.pairs, j);
    // The end inside the range leads: the branch is distinct there.
    const TrackedPoint &inside = s0 > 0. ? a : b;
    const int           pair   = s0 > 0. ? i : j;
    for (unsigned int step = 0; std::abs(x1 - x0) > tolerance && step < 80;
         ++step)
      {
        // Secant steps kept away from the ends; every third one halves.
        double share   = s0 / (s0 - s1);
        share          = step % 3 == 2 ? 0.5 : std::clamp(share, 0.02, 0.98);
        const double x = x0 + share * (x1 - x0);
        const double value = continue_pair(inside, pair, x).sigma();
        if ((value > 0.) == (s0 > 0.))
          {
            x0 = x;
            s0 = value;
          }
        else
          {
            x1 = x;
            s1 = value;
          }
        if (s0 == s1)
          break;
      }
    slope = (s1 - s0) / (x1 - x0);
    return x0 + s0 / (s0 - s1) * (x1 - x0);
  }



  void
  LineStability::locate_peak(const std::vector<TrackedPoint> &line,
                             const std::size_t                at,
                             UnstableRange                   &range) const
  {
    const TrackedPoint &top  = line[at];
    const int           pair = top.pair_of(range.branch);
    range.peak_sigma         = top.pairs.sigma(pair);
    range.peak_at            = top.coordinate;
    range.peak_frequency     = top.pairs.frequency(pair);
    double low = at > 0 ? line[at - 1].coordinate : top.coordinate;
    double high =
      at + 1 < line.size() ? line[at + 1].coordinate : top.coordinate;
    low  = std::max(low, range.lower);
    high = std::min(high, range.upper);
    // Golden section.
    const double g = 0.5 * (3. - std::sqrt(5.));
    while (high - low > 100. * tolerance)
      {
        const bool   right = high - range.peak_at > range.peak_at - low;
        const double x     = right ? range.peak_at + g * (high - range.peak_at)
                                   : range.peak_at - g * (range.peak_at - low);
        const At     here  = continue_pair(top, pair, x);
        if (here.sigma() > range.peak_sigma)
          {
            (right ? low : high) = range.peak_at;
            range.peak_at        = x;
            range.peak_sigma     = here.sigma();
            range.peak_frequency = here.pairs.frequency(here.pair);
          }
        else
          (right ? high : low) = x;
      }
  }



  std::vector<UnstableRange>
  LineStability::ranges(const std::vector<TrackedPoint> &line) const
  {
    int n_branches = 0;
    for (const auto &point : line)
      for (const int b : point.branch)
        n_branches = std::max(n_branches, b + 1);
    std::vector<UnstableRange> result;
    for (int branch = 0; branch < n_branches; ++branch)
      {
        const auto sigma = [&](const std::size_t p) {
          const int i = line[p].pair_of(branch);
          return i < 0 ? std::nan("") : certain_sigma(line[p].pairs, i);
        };
        for (std::size_t p = 0; p < line.size(); ++p)
          {
            if (!(sigma(p) > 0.))
              continue;
            UnstableRange range;
            range.branch     = branch;
            std::size_t last = p, top = p;
            while (last + 1 < line.size() && sigma(last + 1) > 0.)
              ++last;
            for (std::size_t q = p; q <= last; ++q)
              {
                if (sigma(q) > sigma(top))
                  top = q;
                const int i = line[q].pair_of(branch);
                range.sigma_error =
                  worst_of(range.sigma_error,
                           line[q].pairs.error_estimate[i] *
                             std::abs(line[q].pairs.lambda[i]));
              }
            range.lower          = line[p].coordinate;
            range.upper          = line[last].coordinate;
            range.at_lower_limit = p == 0;
            range.at_upper_limit = last + 1 == line.size();
            range.leaves_band_below =
              !range.at_lower_limit && std::isnan(sigma(p - 1));
            range.leaves_band_above =
              !range.at_upper_limit && std::isnan(sigma(last + 1));
            if (range.has_lower_edge())
              range.lower =
                edge(line[p - 1], line[p], branch, range.lower_slope);
            if (range.has_upper_edge())
              range.upper =
                edge(line[last], line[last + 1], branch, range.upper_slope);
            locate_peak(line, top, range);
            result.push_back(range);
            p = last;
          }
      }
    std::sort(result.begin(), result.end(), [](const auto &a, const auto &b) {
      return a.lower < b.lower;
    });
    return result;
  }



  ExceptionalPoint
  LineStability::coalescence(const TrackedPoint &a,
                             const TrackedPoint &b,
                             const int           branch_1,
                             const int           branch_2) const
  {
    ExceptionalPoint result;
    result.branch_1 = branch_1;
    result.branch_2 = branch_2;
    struct Sample
    {
      double  x;
      Complex square, mean;
      double  condition;
    };
    const auto sample_of =
      [](const double x, const ComplexPairs &pairs, const int i, const int j) {
        const Complex half = 0.5 * (pairs.lambda[i] - pairs.lambda[j]);
        return Sample{x,
                      half * half,
                      0.5 * (pairs.lambda[i] + pairs.lambda[j]),
                      std::max(pairs.condition[i], pairs.condition[j])};
      };
    std::vector<Sample> samples = {
      sample_of(
        a.coordinate, a.pairs, a.pair_of(branch_1), a.pair_of(branch_2)),
      sample_of(
        b.coordinate, b.pairs, b.pair_of(branch_1), b.pair_of(branch_2))};
    // Vectors that coalesce cannot be told apart, but the mean of the two
    // eigenvalues and their squared distance are smooth in x: the two whose
    // mean and square are nearest to the straight lines from a to b.
    const auto at = [&, first = samples[0], last = samples[1]](const double x) {
      const double  share = (x - first.x) / (last.x - first.x);
      const Complex mean  = first.mean + share * (last.mean - first.mean);
      const Complex square =
        first.square + share * (last.square - first.square);
      const ComplexPairs pairs = solver(x);
      // Where there are none such, one has left the band: the lines themselves.
      Sample nearest{x, square, mean, std::nan("")};
      double lowest = 4. * (std::abs(last.square - first.square) +
                            std::norm(last.mean - first.mean));
      for (unsigned int i = 0; i < pairs.size(); ++i)
        for (unsigned int j = i + 1; j < pairs.size(); ++j)
          {
            const Sample candidate = sample_of(x, pairs, i, j);
            const double distance  = std::norm(candidate.mean - mean) +
                                    std::abs(candidate.square - square);
            if (distance < lowest)
              {
                lowest  = distance;
                nearest = candidate;
              }
          }
      return nearest;
    };
    const double h = b.coordinate - a.coordinate;
    samples.push_back(at(a.coordinate + h / 3.));
    samples.push_back(at(a.coordinate + 2. * h / 3.));
    Complex root = 0.5 * (a.coordinate + b.coordinate);
    for (unsigned int step = 0; step < 8; ++step)
      {
        // The four samples nearest to the root so far.
        std::sort(samples.begin(), samples.end(), [&](auto &p, auto &q) {
          return std::abs(p.x - root) < std::abs(q.x - root);
        });
        const double x[4] = {
          samples[0].x, samples[1].x, samples[2].x, samples[3].x};
        const Complex y[4]   = {samples[0].square,
                                samples[1].square,
                                samples[2].square,
                                samples[3].square};
        const Complex before = root;
        root                 = interpolated_root(x, y, root);
        const double reach   = 2. * h;
        if (!(std::abs(root.real() - a.coordinate - 0.5 * h) < reach))
          {
            root = before;
            break;
          }
        bool is_known = false;
        for (const auto &s : samples)
          is_known = is_known || std::abs(s.x - root.real()) <
                                   1e-9 * std::max(1., std::abs(root));
        if (is_known || std::abs(root - before) < 0.01 * tolerance)
          break;
        samples.push_back(at(root.real()));
      }
    const Sample nearest = at(root.real());
    result.coordinate    = root;
    result.is_lock_in =
      samples.empty() ||
      (b.pairs.size() > 0 &&
       squared_split(b.pairs, b.pair_of(branch_1), b.pair_of(branch_2)) <
         squared_split(a.pairs, a.pair_of(branch_1), a.pair_of(branch_2)));
    // The mean is smooth in the coordinate: its continuation to the complex one
    // is the eigenvalue there, from points as far apart as that is from the
    // axis.
    Complex lambda = nearest.mean;
    if (std::abs(root.imag()) > 1e-6 * std::abs(h))
      {
        const double reach =
          std::min(0.5, std::max(std::abs(root.imag() / h), 0.1)) * std::abs(h);
        const double low    = std::min(a.coordinate, b.coordinate) + reach,
                     high   = std::max(a.coordinate, b.coordinate) - reach;
        const double middle = std::min(std::max(root.real(), low), high);
        double       x[4];
        Complex      y[4];
        for (int k = 0; k < 4; ++k)
          {
            x[k] = middle + reach * (2. * k / 3. - 1.);
            y[k] = at(x[k]).mean;
          }
        lambda = interpolated(x, y, root);
      }
    result.frequency = lambda.imag() / (2. * M_PI);
    result.sigma     = lambda.real();
    result.condition = nearest.condition;
    return result;
  }



  std::vector<ExceptionalPoint>
  LineStability::exceptional_points(const std::vector<TrackedPoint> &line) const
  {
    std::vector<ExceptionalPoint> result;
    for (std::size_t p = 0; p + 1 < line.size(); ++p)
      for (unsigned int i = 0; i < line[p].pairs.size(); ++i)
        for (unsigned int j = i + 1; j < line[p].pairs.size(); ++j)
          {
            const int b1 = line[p].branch[i], b2 = line[p].branch[j];
            const int k = line[p + 1].pair_of(b1), l = line[p + 1].pair_of(b2);
            if (k < 0 || l < 0 || is_multiple(line[p].pairs, i, j) ||
                is_multiple(line[p + 1].pairs, k, l))
              continue;
            // A rate that passes a frequency is no coalescence.
            if (is_real(line[p].pairs, i) != is_real(line[p].pairs, j) ||
                is_real(line[p + 1].pairs, k) != is_real(line[p + 1].pairs, l))
              continue;
            const double before = squared_split(line[p].pairs, i, j);
            const double after  = squared_split(line[p + 1].pairs, k, l);
            // Two overdamped or far apart pairs do not coalesce by a sign.
            const double far = 0.01 * std::norm(line[p].pairs.lambda[i]);
            if ((before < 0.) != (after < 0.) && std::abs(before) < far &&
                std::abs(after) < far)
              result.push_back(coalescence(line[p], line[p + 1], b1, b2));
          }
    return result;
  }
} // namespace squeal
