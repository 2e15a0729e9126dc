// SPDX-License-Identifier: LGPL-2.1-or-later

// How likely a brake squeals whose numbers scatter.

#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/sweep/first_order_index.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace squeal
{
  namespace
  {
    using Type         = Table::Type;
    using Distribution = SweepAxisParameters::Distribution;

    /** Standard deviations of the 95 per cent interval. */
    constexpr double z = 1.959963984540054;

    /** What counts of one sample. */
    struct Sample
    {
      double sigma     = 0.; /**< the largest, 1/s */
      double frequency = 0.; /**< of that pair, Hz */
      double error     = 0.; /**< estimated, of sigma */
    };

    std::vector<SweepPoint>
    draw(const SweepGrid &grid, const SweepParameters &p)
    {
      std::mt19937_64                        generator(p.scatter_seed);
      std::uniform_real_distribution<double> uniform;
      std::normal_distribution<double>       normal;
      std::vector<SweepPoint>                points;
      for (unsigned int i = 0; i < p.scatter_samples; ++i)
        {
          SweepPoint point(grid.n_axes());
          for (unsigned int a = 0; a < grid.n_axes(); ++a)
            {
              const auto  &axis = grid.axis(a);
              const double low = grid.lower(a), high = grid.upper(a);
              if (axis.distribution == Distribution::uniform)
                {
                  point[a] = low + (high - low) * uniform(generator);
                  continue;
                }
              const bool   is_given = axis.deviation > 0.;
              const double mean     = is_given ? axis.mean : 0.5 * (low + high);
              const double deviation =
                is_given ? axis.deviation : (high - low) / 6.;
              do
                point[a] = mean + deviation * normal(generator);
              while (point[a] < low || point[a] > high);
            }
          points.push_back(point);
        }
      return points;
    }

    /** Largest sigma of the band; certified where it is not clearly negative.
     */
    Sample
    worst_pair(SweepModel &model, const SweepPoint &point)
    {
      const auto largest = [](const ComplexPairs &pairs) {
        Sample result{-std::numeric_limits<double>::infinity(), 0., 0.};
        for (unsigned int i = 0; i < pairs.size(); ++i)
          if (pairs.sigma(i) > result.sigma)
            result = {pairs.sigma(i),
                      pairs.frequency(i),
                      pairs.error_estimate[i] * std::abs(pairs.lambda[i])};
        return result;
      };
      const Sample quick = largest(model.solve(point, false));
      if (quick.sigma < -1.)
        return quick;
      WorstError worst;
      return largest(model.solve_certified(point, worst));
    }

    /** Every rank takes its share of the points. */
    std::vector<Sample>
    solve_samples(SweepModel                    &model,
                  const std::vector<SweepPoint> &points,
                  RunContext                    &context)
    {
      const unsigned int rank =
        dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const unsigned int n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      std::vector<double> values(3 * points.size(), 0.);
      // the root's own: the first ranks have one more where they do not divide
      Progress progress(
        context.log, "scatter", (points.size() + n_ranks - 1) / n_ranks);
      for (std::size_t i = rank; i < points.size(); i += n_ranks)
        {
          const Sample s    = worst_pair(model, points[i]);
          values[3 * i]     = s.sigma;
          values[3 * i + 1] = s.frequency;
          values[3 * i + 2] = s.error;
          progress.advance();
        }
      dealii::Utilities::MPI::sum(values, MPI_COMM_WORLD, values);
      std::vector<Sample> samples;
      for (std::size_t i = 0; i < points.size(); ++i)
        samples.push_back(
          {values[3 * i], values[3 * i + 1], values[3 * i + 2]});
      return samples;
    }

    /** Wilson's interval of a share. */
    std::pair<double, double>
    interval(const double share, const double n)
    {
      const double centre = (share + z * z / (2. * n)) / (1. + z * z / n);
      const double half =
        z / (1. + z * z / n) *
        std::sqrt(share * (1. - share) / n + z * z / (4. * n * n));
      return {std::max(0., centre - half), std::min(1., centre + half)};
    }

    /** Ranges of frequency in which unstable pairs lie, apart by 2 per cent. */
    std::vector<std::pair<double, double>>
    frequency_groups(const std::vector<Sample> &samples)
    {
      std::vector<double> unstable;
      for (const auto &s : samples)
        if (s.sigma > 0.)
          unstable.push_back(s.frequency);
      std::sort(unstable.begin(), unstable.end());
      std::vector<std::pair<double, double>> groups;
      for (const double f : unstable)
        if (groups.empty() || f > 1.02 * groups.back().second)
          groups.emplace_back(f, f);
        else
          groups.back().second = f;
      return groups;
    }

    std::vector<double>
    coordinates(const std::vector<SweepPoint> &points, const unsigned int a)
    {
      std::vector<double> x;
      for (const auto &p : points)
        x.push_back(p[a]);
      return x;
    }

    Chart
    probability_chart(const SceneParameters         &scene,
                      const SweepGrid               &grid,
                      const unsigned int             a,
                      const std::vector<SweepPoint> &points,
                      const std::vector<double>     &unstable)
    {
      Chart       chart;
      ChartSeries series;
      series.style = ChartSeries::Style::lines_points;
      for (const SampleClass &found :
           classes_of(coordinates(points, a), unstable))
        {
          series.x.push_back(found.x);
          series.y.push_back(found.mean);
        }
      chart.title   = "probability of squeal";
      chart.x.label = (grid.is_logarithmic(a) ? "log10 of " : "") +
                      axis_title(grid.axis(a).entries, scene);
      chart.y.label = "share of unstable samples";
      chart.series.push_back(series);
      return chart;
    }
  } // namespace



  ScatterTables
  scatter_tables(SweepModel &model, RunContext &context)
  {
    Timers::Section  section(context.timers, "Solve: scatter");
    const SweepGrid &grid    = model.grid();
    const auto      &p       = context.parameters.sweep;
    const auto       points  = draw(grid, p);
    const auto       samples = solve_samples(model, points, context);
    const double     n       = samples.size();

    ScatterTables result;
    result.probabilities =
      Table({{"event", Type::text, "", "what happens"},
             {"lowest_frequency_hz", Type::real, "Hz", "of the pairs", 5},
             {"highest_frequency_hz", Type::real, "Hz", "of the pairs", 5},
             {"samples", Type::integer, "", "drawn"},
             {"probability", Type::real, "", "share of the samples", 5},
             {"lower_95", Type::real, "", "of the sampling, Wilson", 5},
             {"upper_95", Type::real, "", "of the sampling, Wilson", 5},
             {"undecided",
              Type::real,
              "",
              "share of samples whose sigma is below its estimated error",
              3},
             {"largest_sigma_per_s", Type::real, "1/s", "among them", 5}});
    const auto add_row =
      [&](const std::string &event, const double low, const double high) {
        double count = 0., doubt = 0., sigma = 0.;
        for (const auto &s : samples)
          if (s.frequency >= low && s.frequency <= high)
            {
              count += s.sigma > 0.;
              doubt += std::abs(s.sigma) <= s.error;
              sigma = std::max(sigma, s.sigma);
            }
        const auto bounds = interval(count / n, n);
        result.probabilities.add_row({event,
                                      low,
                                      high,
                                      samples.size(),
                                      count / n,
                                      bounds.first,
                                      bounds.second,
                                      doubt / n,
                                      sigma});
      };
    add_row("any squeal", model.band().lowest, model.band().highest);
    for (const auto &[low, high] : frequency_groups(samples))
      add_row("loudest pair in this range", low, high);

    std::vector<double> unstable, sigma;
    for (const auto &s : samples)
      {
        unstable.push_back(s.sigma > 0. ? 1. : 0.);
        sigma.push_back(s.sigma);
      }
    struct Driver
    {
      unsigned int axis;
      double       squeal, sigma;
    };
    std::vector<Driver> drivers;
    for (unsigned int a = 0; a < grid.n_axes(); ++a)
      {
        const auto x = coordinates(points, a);
        drivers.push_back(
          {a, first_order_index(x, unstable), first_order_index(x, sigma)});
        if (!classes_of(x, unstable).empty())
          result.charts.push_back(
            probability_chart(model.scene(), grid, a, points, unstable));
      }
    std::stable_sort(
      drivers.begin(), drivers.end(), [](const auto &a, const auto &b) {
        // Without an index the order is that of the axes.
        return a.squeal > b.squeal;
      });
    result.drivers = Table(
      {{"rank", Type::integer, "", "1: drives the squeal most"},
       {"axis", Type::text, "", "of the sweep"},
       {"entry", Type::text, "", "its first number"},
       {"index_squeal",
        Type::real,
        "",
        "share of the variance of 'squeals or not' that it explains alone",
        3},
       {"index_sigma", Type::real, "", "the same of the largest sigma", 3}});
    for (std::size_t i = 0; i < drivers.size(); ++i)
      result.drivers.add_row({i + 1,
                              grid.axis(drivers[i].axis).name,
                              grid.axis(drivers[i].axis).entries[0],
                              or_missing(drivers[i].squeal),
                              or_missing(drivers[i].sigma)});
    return result;
  }
} // namespace squeal
