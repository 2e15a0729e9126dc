// SPDX-License-Identifier: LGPL-2.1-or-later

// How likely a brake squeals whose numbers scatter.

#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/eigen/unstable_pair.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/sweep/contact_cells.h>
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
      double unknown   = 0.; /**< that or what rounding makes of sigma */
      /** Whether all points of the grid round it have one contact state. */
      bool is_known = true;

      bool
      squeals() const
      {
        return sigma > unknown;
      }
      bool
      has_pair() const
      {
        return std::isfinite(sigma);
      }
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
        Sample result{-std::numeric_limits<double>::infinity(), 0., 0., 0.};
        for (unsigned int i = 0; i < pairs.size(); ++i)
          {
            const Sample own{pairs.sigma(i),
                             pairs.frequency(i),
                             pairs.error_estimate[i] *
                               std::abs(pairs.lambda[i]),
                             sigma_error(pairs, i)};
            // One that grows for certain before one that may.
            if (own.squeals() == result.squeals() ? own.sigma > result.sigma
                                                  : own.squeals())
              result = own;
          }
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
      std::vector<double> values(4 * points.size(), 0.);
      // the root's own: the first ranks have one more where they do not divide
      Progress progress(
        context.log, "scatter", (points.size() + n_ranks - 1) / n_ranks);
      for (std::size_t i = rank; i < points.size(); i += n_ranks)
        {
          const Sample s    = worst_pair(model, points[i]);
          values[4 * i]     = s.sigma;
          values[4 * i + 1] = s.frequency;
          values[4 * i + 2] = s.error;
          values[4 * i + 3] = s.unknown;
          progress.advance();
        }
      dealii::Utilities::MPI::sum(values, MPI_COMM_WORLD, values);
      std::vector<Sample> samples;
      for (std::size_t i = 0; i < points.size(); ++i)
        samples.push_back({values[4 * i],
                           values[4 * i + 1],
                           values[4 * i + 2],
                           values[4 * i + 3],
                           has_known_contact(model.grid(), points[i])});
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
        if (s.squeals())
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

    /** Counts of an event among the samples. */
    struct Count
    {
      double squeal = 0.; /**< by the contact state that is held */
      /** At least and at most, whatever the contact state that is not known. */
      double surely = 0., perhaps = 0.;
      double undecided = 0., held = 0.;
      double sigma = 0.; /**< the largest, 1/s */
    };

    Count
    count_between(const std::vector<Sample> &samples,
                  const double               low,
                  const double               high)
    {
      Count count;
      for (const Sample &s : samples)
        {
          const bool is_here = s.frequency >= low && s.frequency <= high,
                     squeals = is_here && s.squeals();
          count.squeal += squeals;
          count.surely += squeals && s.is_known;
          count.perhaps += squeals || !s.is_known;
          count.held += !s.is_known;
          count.undecided +=
            !s.is_known || (is_here && std::abs(s.sigma) <= s.error);
          if (is_here)
            count.sigma = std::max(count.sigma, s.sigma);
        }
      return count;
    }

    Table
    probability_table(const SweepModel          &model,
                      const std::vector<Sample> &samples)
    {
      Table table(
        {{"event", Type::text, "", "what happens"},
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
      if (model.has_contact_states())
        table.add_column({"undecided_contact",
                          Type::real,
                          "",
                          "share of samples between points of different "
                          "contact states, undecided and in the interval",
                          3});
      const double n = samples.size();
      const auto   add_row =
        [&](const std::string &event, const double low, const double high) {
          const Count       c = count_between(samples, low, high);
          std::vector<Cell> row{event,
                                low,
                                high,
                                samples.size(),
                                c.squeal / n,
                                interval(c.surely / n, n).first,
                                interval(c.perhaps / n, n).second,
                                c.undecided / n,
                                c.sigma};
          if (model.has_contact_states())
            row.emplace_back(c.held / n);
          table.add_row(row);
        };
      add_row("any squeal", model.band().lowest, model.band().highest);
      for (const auto &[low, high] : frequency_groups(samples))
        add_row("loudest pair in this range", low, high);
      return table;
    }

    void
    warn_of_samples(const std::vector<Sample> &samples, RunContext &context)
    {
      const std::string of = " of " + std::to_string(samples.size());
      const auto        n_held =
                   std::count_if(samples.begin(),
                                 samples.end(),
                                 [](const Sample &s) { return !s.is_known; }),
                 n_without =
                   std::count_if(samples.begin(),
                                 samples.end(),
                                 [](const Sample &s) { return !s.has_pair(); });
      if (n_held > 0)
        context.log.warning(
          std::to_string(n_held) + of +
          " samples lie between points of the sweep whose contact states "
          "differ, where that of the nearest point is held: they are "
          "undecided, and the interval of the probability counts them both "
          "ways; give the axes more points (Number)");
      if (n_without > 0)
        context.log.warning(
          std::to_string(n_without) + of +
          " samples have no pair in the band of Eigenvalues: they do not "
          "squeal, and index_sigma is that of the others");
    }

    /** Of the largest sigma, of the samples that have one. */
    double
    index_of_sigma(const std::vector<double> &x,
                   const std::vector<Sample> &samples)
    {
      std::vector<double> own, sigma;
      for (std::size_t i = 0; i < samples.size(); ++i)
        if (samples[i].has_pair())
          {
            own.push_back(x[i]);
            sigma.push_back(samples[i].sigma);
          }
      return first_order_index(own, sigma);
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
    warn_of_samples(samples, context);

    ScatterTables result;
    result.probabilities = probability_table(model, samples);
    std::vector<double> unstable;
    for (const auto &s : samples)
      unstable.push_back(s.squeals() ? 1. : 0.);
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
          {a, first_order_index(x, unstable), index_of_sigma(x, samples)});
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
       {"index_sigma",
        Type::real,
        "",
        "the same of the largest sigma, of samples with a pair in the band",
        3}});
    for (std::size_t i = 0; i < drivers.size(); ++i)
      result.drivers.add_row({i + 1,
                              grid.axis(drivers[i].axis).name,
                              grid.axis(drivers[i].axis).entries[0],
                              or_missing(drivers[i].squeal),
                              or_missing(drivers[i].sigma)});
    return result;
  }
} // namespace squeal
