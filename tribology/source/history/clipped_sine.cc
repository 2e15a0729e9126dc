// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/tribology/history/clipped_sine.h>

#include <cmath>

namespace squeal::tribology
{
  double
  ClippedSine::duty() const
  {
    return r <= 1. ? 1. : .5 + std::asin(1. / r) / M_PI;
  }



  double
  ClippedSine::mean() const
  {
    return r <= 1. ? 1. : duty() + std::sqrt(r * r - 1.) / M_PI;
  }



  double
  ClippedSine::peak() const
  {
    return 1. + r;
  }



  ClippedSineGenerator::ClippedSineGenerator(
    const RecordedHistoryParameters &parameters)
    : p(parameters)
    , generator(parameters.seed)
  {
    const bool squeals = p.run == RecordedHistoryParameters::Run::squealing;
    what.name = squeals ? "clipped sine, squealing" : "clipped sine, silent";
    const unsigned int n = p.n_nodes;
    const double       h = p.pad_length / (n - 1);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          what.points.push_back(
            {{i * h - .5 * p.pad_length, j * h - .5 * p.pad_length, 0.}});
          what.areas.push_back(h * h * (i % (n - 1) == 0 ? .5 : 1.) *
                               (j % (n - 1) == 0 ? .5 : 1.));
          const double s = double(j) / (n - 1); // 0 at the leading edge
          ratios.push_back(squeals ? 5. - 4.7 * s : 0.);
          phases.push_back(-.5 * M_PI * s);
        }
    set_means();
    modulation.assign(what.n_nodes(), 0.);
    before.assign(what.n_nodes(), 1.);
  }



  void
  ClippedSineGenerator::set_means()
  {
    double              sum = 0., area = 0.;
    std::vector<double> shape;
    for (std::size_t k = 0; k < what.n_nodes(); ++k)
      {
        const double b  = p.pad_length;
        const double xi = what.points[k][0] / (.5 * b);
        const double s  = what.points[k][1] / b + .5;
        shape.push_back(std::exp(-s / .15) * (1. - .15 * xi));
        sum += shape[k] * what.areas[k];
        area += what.areas[k];
      }
    const ClippedSine corner{5.};
    const double      at_corner =
      p.pressure * p.leading * corner.mean() / corner.peak();
    const double slope = (at_corner - p.pressure) / (shape[0] - sum / area);
    const double level = p.pressure - slope * sum / area;
    if (level < 0. || slope < 0.)
      throw InputError("'Recorded history/Leading edge factor' = " +
                       std::to_string(p.leading) +
                       " does not fit the mean pressure of the pad; use 3 to "
                       "15");
    for (const double s : shape)
      means.push_back(level + slope * s);
  }



  const HistoryLayout &
  ClippedSineGenerator::layout() const
  {
    return what;
  }



  std::uint64_t
  ClippedSineGenerator::n_samples() const
  {
    return static_cast<std::uint64_t>(std::llround(p.duration * p.rate));
  }



  double
  ClippedSineGenerator::mean_pressure(const std::size_t node) const
  {
    return means[node];
  }



  double
  ClippedSineGenerator::ratio(const std::size_t node) const
  {
    return ratios[node];
  }



  void
  ClippedSineGenerator::next(const std::size_t          n,
                             HistorySamples            &s,
                             std::vector<StatusChange> &changes)
  {
    s.clear();
    changes.clear();
    const double omega = 2. * M_PI * p.frequency;
    const double keep  = std::exp(-p.frequency / (2. * p.rate));
    const double kick  = p.noise * std::sqrt(1. - keep * keep);
    // elastic opening of a pad as thick as it is long
    const double bedding = 2.5e10 / p.pad_length;
    for (std::size_t i = 0; i < n; ++i, ++n_done)
      {
        const double          t     = n_done / p.rate;
        std::array<double, 3> force = {{0., 0., 0.}};
        for (std::size_t k = 0; k < means.size(); ++k)
          {
            modulation[k]  = keep * modulation[k] + kick * normal(generator);
            const double r = ratios[k];
            const double angle = omega * t + phases[k];
            const double level = means[k] / ClippedSine{r}.mean();
            const double swing = r * std::sin(angle) * (1. + modulation[k]);
            const double load  = 1. + swing + (r > 0. ? 0. : modulation[k]);
            const double slip = p.slip_speed * (1. + .24 * r * std::cos(angle));
            const bool   open = load <= 0., sticks = !open && slip <= 0.;
            const double pressure = open ? 0. : level * load;
            const double traction = p.friction * pressure * (sticks ? .9 : 1.);
            s.pressure.push_back(pressure);
            s.traction.insert(s.traction.end(), {0., traction});
            s.slip_rate.insert(s.slip_rate.end(), {0., sticks ? 0. : slip});
            s.gap.push_back(open ? -level * load / bedding : 0.);
            s.status.push_back(open ? 0. : sticks ? 1. : 2.);
            force[1] += traction * what.areas[k];
            force[2] += pressure * what.areas[k];
            if (n_done > 0 && (load <= 0.) != (before[k] <= 0.))
              changes.push_back({t - load / (load - before[k]) / p.rate,
                                 k,
                                 open     ? ContactStatus::open
                                 : sticks ? ContactStatus::stick
                                          : ContactStatus::slip});
            before[k] = load;
          }
        s.time.push_back(t);
        s.resultants.insert(s.resultants.end(), force.begin(), force.end());
      }
  }
} // namespace squeal::tribology
