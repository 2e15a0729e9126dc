// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/base/packing.h>
#include <squeal/base/worst_of.h>
#include <squeal/sweep/contact_cells.h>
#include <squeal/sweep/continued_pencils.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace squeal
{
  namespace
  {
    /** Calls @p function with every member, to pack or to unpack. */
    template <typename Pairs, typename Function>
    void
    for_each_member(Pairs &pairs, const Function &function)
    {
      function(pairs.lambda);
      function(pairs.right);
      function(pairs.left);
      function(pairs.residual);
      function(pairs.left_residual);
      function(pairs.error_estimate);
      function(pairs.noise_floor);
      function(pairs.condition);
      function(pairs.pair_partner);
    }

    void
    put(Packer &packer, const ComplexPairs &pairs)
    {
      for_each_member(pairs, [&](const auto &member) { packer.put(member); });
    }

    void
    get(Unpacker &unpacker, ComplexPairs &pairs)
    {
      for_each_member(pairs, [&](auto &member) { unpacker.get(member); });
    }

    void
    put(Packer &packer, const SweepLine &line)
    {
      packer.put(line.start);
      packer.put(line.points.size());
      for (const auto &point : line.points)
        {
          packer.put(point.coordinate);
          packer.put(point.asked);
          packer.put(point.branch);
          put(packer, point.pairs);
        }
      packer.put(line.branch_names);
      packer.put(line.ranges);
      packer.put(line.exceptional);
      packer.put(line.mesh_errors_of_edges);
    }

    void
    get(Unpacker &unpacker, SweepLine &line)
    {
      unpacker.get(line.start);
      std::size_t n;
      unpacker.get(n);
      line.points.resize(n);
      for (auto &point : line.points)
        {
          unpacker.get(point.coordinate);
          unpacker.get(point.asked);
          unpacker.get(point.branch);
          get(unpacker, point.pairs);
        }
      unpacker.get(line.branch_names);
      unpacker.get(line.ranges);
      unpacker.get(line.exceptional);
      unpacker.get(line.mesh_errors_of_edges);
    }



    /** Names from the two far ends of every branch. */
    std::vector<std::string>
    branch_names(const SweepModel &model, const SweepLine &line)
    {
      struct Ends
      {
        std::string first, last;
      };
      std::map<int, Ends> ends;
      const auto          visit = [&](const std::size_t p) {
        const TrackedPoint &point  = line.points[p];
        bool                is_end = false;
        for (const int b : point.branch)
          {
            const bool first = p == 0 || line.points[p - 1].pair_of(b) < 0;
            const bool last =
              p + 1 == line.points.size() || line.points[p + 1].pair_of(b) < 0;
            is_end = is_end || first || last;
          }
        if (!is_end)
          return;
        SweepPoint at = line.start;
        at[0]         = point.coordinate;
        const auto names =
          model.names(point.pairs.right,
                      model.energy_shares(at, point.pairs.right),
                      point.pairs.lambda);
        for (std::size_t i = 0; i < point.branch.size(); ++i)
          {
            const int b = point.branch[i];
            if (p == 0 || line.points[p - 1].pair_of(b) < 0)
              ends[b].first = names[i].text;
            if (p + 1 == line.points.size() ||
                line.points[p + 1].pair_of(b) < 0)
              ends[b].last = names[i].text;
          }
      };
      for (std::size_t p = 0; p < line.points.size(); ++p)
        visit(p);
      std::vector<std::string>   names(ends.empty() ? 0
                                                  : ends.rbegin()->first + 1);
      std::map<std::string, int> seen;
      for (const auto &[b, e] : ends)
        {
          names[b] = e.first == e.last ? e.first : e.first + " > " + e.last;
          if (const int n = ++seen[names[b]]; n > 1)
            names[b] += " #" + std::to_string(n);
        }
      return names;
    }

    /** The exceptional point of the range's branch that is nearest to @p edge,
     * or none. */
    const ExceptionalPoint *
    nearest_exceptional_point(const SweepLine &line,
                              const int        branch,
                              const double     edge)
    {
      const ExceptionalPoint *nearest  = nullptr;
      double                  distance = 1e300;
      for (const auto &e : line.exceptional)
        if (e.branch_1 == branch || e.branch_2 == branch)
          if (const double d = std::abs(e.coordinate.real() - edge);
              d < distance)
            {
              distance = d;
              nearest  = &e;
            }
      return nearest;
    }

    /** Slope of the squared split of two branches at an exceptional point,
     * (1/s)^2 a unit of the coordinate, of the parabola through the three
     * points nearest to it: the split is one in the detuning. NaN where less
     * than three have both branches. */
    double
    slope_of_split(const SweepLine &line, const ExceptionalPoint &e)
    {
      const double x = e.coordinate.real();
      struct Sample
      {
        double distance, split;
      };
      std::vector<Sample> samples;
      for (const auto &point : line.points)
        {
          const int i = point.pair_of(e.branch_1),
                    j = point.pair_of(e.branch_2);
          if (i >= 0 && j >= 0)
            samples.push_back(
              {point.coordinate - x, squared_split(point.pairs, i, j)});
        }
      if (samples.size() < 3)
        return std::nan("");
      std::partial_sort(samples.begin(),
                        samples.begin() + 3,
                        samples.end(),
                        [](const Sample &a, const Sample &b) {
                          return std::abs(a.distance) < std::abs(b.distance);
                        });
      const auto &[a, f] = samples[0];
      const auto &[b, g] = samples[1];
      const auto &[c, h] = samples[2];
      return std::abs(-f * (b + c) / ((a - b) * (a - c)) -
                      g * (a + c) / ((b - a) * (b - c)) -
                      h * (a + b) / ((c - a) * (c - b)));
    }

    /** Of the two undamped modes nearest in frequency to an exceptional point,
     * which are the partners. */
    struct Detuning
    {
      double distance = 0.; /**< of their frequencies, rad/s */
      double error    = 0.; /**< of that distance by the mesh, rad/s; NaN: not
                               known */
    };

    /** Of two modes that are nearer to each other than their errors and whose
     * errors are as alike as this, the mesh shifts both together: a doublet,
     * whose distance is better known than either frequency. */
    constexpr double alike = 0.8;
    /** Of the error of either, what the estimate leaves open of the difference.
     */
    constexpr double open_share = 0.3;

    /** Of the difference of two frequencies at @p distance of each other, all
     * relative: the larger one of both errors, less for a doublet. */
    double
    error_of_difference(const double distance, const double a, const double b)
    {
      const double larger = worst_of(a, b), smaller = std::min(a, b);
      const bool   is_doublet = distance < larger && smaller > alike * larger;
      return is_doublet ? larger - smaller + open_share * larger : larger;
    }

    Detuning
    detuning_at(const SweepModel::Modes &modes, const double omega)
    {
      std::vector<std::pair<double, Eigen::Index>> by_gap;
      const auto                                   frequency =
        modes.modes.omega_squared.cwiseMax(0.).cwiseSqrt().eval();
      for (Eigen::Index m = 0; m < frequency.size(); ++m)
        by_gap.emplace_back(std::abs(frequency[m] - omega), m);
      if (by_gap.size() < 2)
        return {0., std::nan("")};
      std::partial_sort(by_gap.begin(), by_gap.begin() + 2, by_gap.end());
      const Eigen::Index i = by_gap[0].second, j = by_gap[1].second;
      const double       distance = std::abs(frequency[i] - frequency[j]);
      return {distance,
              omega * error_of_difference(distance / omega,
                                          modes.mesh_errors[i],
                                          modes.mesh_errors[j])};
    }

    /** An error of the difference of the two partners' frequencies moves the
     * edge: the squared split is (detuning^2 - coupling^2) / 4, and both are
     * equal at the exceptional point. The coupling is at most twice the
     * distance of the peak from the damping of the two, less where it grows
     * along the axis, as it does with friction. The square of the error counts,
     * too: partners may be nearer to each other than their errors, and a
     * doublet has hardly any detuning. */
    double
    mesh_error_of_edge(const SweepModel    &model,
                       const SweepLine     &line,
                       const UnstableRange &range,
                       const double         edge)
    {
      const ExceptionalPoint *e =
        nearest_exceptional_point(line, range.branch, edge);
      if (!e)
        return std::nan("");
      // It may lie a little beyond the ends of the sweep.
      SweepPoint at = line.start;
      at[0]         = std::clamp(
        e->coordinate.real(), model.grid().lower(0), model.grid().upper(0));
      const Detuning detuning =
        detuning_at(model.undamped(at), 2. * M_PI * e->frequency);
      const double coupling =
        std::min(2. * (range.peak_sigma - e->sigma), detuning.distance);
      const double slope = slope_of_split(line, *e);
      return slope > 0. ? (0.5 * coupling + 0.25 * detuning.error) *
                            detuning.error / slope
                        : std::nan("");
    }

    /** The larger one of both edges; an end of the line or of the band is none.
     * NaN for a range of divergence, at whose edges nothing coalesces with a
     * partner. */
    double
    mesh_error_of_edges(const SweepModel    &model,
                        const SweepLine     &line,
                        const UnstableRange &range)
    {
      if ((!range.has_lower_edge() && !range.has_upper_edge()) ||
          range.peak_frequency == 0.)
        return std::nan("");
      double error = 0.;
      if (range.has_lower_edge())
        error =
          worst_of(error, mesh_error_of_edge(model, line, range, range.lower));
      if (range.has_upper_edge())
        error =
          worst_of(error, mesh_error_of_edge(model, line, range, range.upper));
      return error;
    }
  } // namespace



  TrackingOptions
  tracking_options(const SweepModel &model)
  {
    TrackingOptions  options;
    const SweepGrid &grid     = model.grid();
    const double     length   = grid.upper(0) - grid.lower(0);
    const double     unit     = grid.is_logarithmic(0) ? 1. : length;
    options.lowest_frequency  = model.band().lowest;
    options.highest_frequency = model.band().highest;
    options.smallest_step     = 1e-7 * std::max(unit, 1e-300);
    options.touch_tolerance   = 1e-4 * std::max(unit, 1e-300);
    LocalModel probe;
    probe.parts   = model.reduced().parts;
    probe.n_basis = 1;
    for (auto &part : probe.parts)
      part = Eigen::MatrixXd::Zero(1, 1);
    options.real =
      PointMatrices(probe, model.system().coefficients(grid.point(0)), 1)
        .rayleigh;
    return options;
  }



  namespace
  {
    using CertifiedPairs = std::map<double, ComplexPairs>;

    /** A line whose points are solved. */
    SweepLine
    follow_line(SweepModel           &model,
                const SweepPoint     &start,
                const CertifiedPairs &certified,
                RunContext           &context,
                std::size_t          &n_solved)
    {
      const SweepGrid       &grid    = model.grid();
      const SweepParameters &p       = context.parameters.sweep;
      const TrackingOptions  options = tracking_options(model);
      const double           length  = grid.upper(0) - grid.lower(0);
      const double           tolerance =
        p.edge_tolerance * (grid.is_logarithmic(0) ? 1. : length);
      SweepLine line;
      line.start        = start;
      const auto solver = [&](const double x) {
        SweepPoint point = line.start;
        point[0]         = x;
        ++n_solved;
        return model.solve_between(point);
      };
      {
        Timers::Section     section(context.timers, "Solve: points, branches");
        std::vector<double> coordinates;
        for (const auto &[x, pairs] : certified)
          coordinates.push_back(x);
        BranchTracker tracker(
          [&](const double x) {
            const auto known = certified.find(x);
            return known == certified.end() ? solver(x) : known->second;
          },
          options);
        line.points = tracker.track(coordinates);
      }
      Timers::Section     section(context.timers, "Solve: edges and peaks");
      const LineStability stability(
        solver, options, tolerance, [&](const double x) {
          SweepPoint point = line.start;
          point[0]         = x;
          return has_known_contact(grid, point);
        });
      line.branch_names = branch_names(model, line);
      line.ranges       = stability.ranges(line.points);
      if (p.exceptional_points)
        line.exceptional = stability.exceptional_points(
          line.points, continuation_of(model.system(), model.reduced(), start));
      if (model.has_contact_states())
        line.exceptional.erase(
          std::remove_if(line.exceptional.begin(),
                         line.exceptional.end(),
                         [&](const ExceptionalPoint &e) {
                           SweepPoint at = start;
                           at[0]         = e.coordinate.real();
                           return model.is_at_contact_change(at);
                         }),
          line.exceptional.end());
      for (const auto &range : line.ranges)
        line.mesh_errors_of_edges.push_back(
          mesh_error_of_edges(model, line, range));
      return line;
    }

    /** Certified pairs of all points, each rank solving its share. Points at
     * which a small basis has to grow come last, in order and on all ranks, so
     * that all have the same bases. */
    std::vector<ComplexPairs>
    solve_points(SweepModel                    &model,
                 const std::vector<SweepPoint> &points,
                 WorstError                    &worst)
    {
      const unsigned int rank =
        dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const unsigned int n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      std::vector<ComplexPairs> result(points.size());
      Packer                    packer;
      for (std::size_t i = rank; i < points.size(); i += n_ranks)
        {
          result[i] = model.solve(points[i]);
          if (n_ranks > 1)
            {
              packer.put(i);
              put(packer, result[i]);
            }
        }
      if (n_ranks > 1)
        for (const auto &bytes : gather_on_all(MPI_COMM_WORLD, packer.bytes()))
          for (Unpacker unpacker(bytes); !unpacker.is_empty();)
            {
              std::size_t i;
              unpacker.get(i);
              get(unpacker, result[i]);
            }
      for (std::size_t i = 0; i < points.size(); ++i)
        if (model.is_certified(result[i], points[i]))
          add_to_worst(result[i], points[i], worst);
        else
          result[i] = model.solve_certified(points[i], worst);
      return result;
    }
  } // namespace



  SweepLine
  solve_line(SweepModel       &model,
             const SweepPoint &start,
             RunContext       &context,
             SweepSolution    &solution)
  {
    CertifiedPairs certified;
    {
      Timers::Section section(context.timers, "Solve: points, branches");
      for (const double x : model.grid().coordinates(0))
        {
          SweepPoint point = start;
          point[0]         = x;
          certified[x]     = model.solve_certified(point, solution.worst);
          ++solution.n_solved;
        }
    }
    return follow_line(model, start, certified, context, solution.n_solved);
  }



  SweepSolution
  solve_sweep(SweepModel &model, RunContext &context)
  {
    const SweepGrid        &grid = model.grid();
    const std::size_t       n    = grid.coordinates(0).size();
    SweepSolution           solution;
    std::vector<SweepPoint> points;
    for (std::size_t i = 0; i < grid.n_points(); ++i)
      points.push_back(grid.point(i));
    solution.n_solved = points.size();
    std::vector<ComplexPairs> pairs;
    {
      Timers::Section section(context.timers, "Solve: points, branches");
      pairs = solve_points(model, points, solution.worst);
    }
    const unsigned int rank =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const unsigned int n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    solution.lines.resize(points.size() / n);
    Packer      packer;
    std::size_t n_solved = 0;
    for (std::size_t l = rank; l < solution.lines.size(); l += n_ranks)
      {
        CertifiedPairs certified;
        for (std::size_t i = l * n; i < (l + 1) * n; ++i)
          certified[points[i][0]] = std::move(pairs[i]);
        solution.lines[l] =
          follow_line(model, points[l * n], certified, context, n_solved);
        if (n_ranks > 1)
          {
            packer.put(l);
            put(packer, solution.lines[l]);
          }
      }
    if (n_ranks > 1)
      {
        Timers::Section section(context.timers, "Solve: exchange of lines");
        for (const auto &bytes : gather_on_all(MPI_COMM_WORLD, packer.bytes()))
          for (Unpacker unpacker(bytes); !unpacker.is_empty();)
            {
              std::size_t l;
              unpacker.get(l);
              get(unpacker, solution.lines[l]);
            }
      }
    solution.n_solved += dealii::Utilities::MPI::sum(n_solved, MPI_COMM_WORLD);
    return solution;
  }
} // namespace squeal
