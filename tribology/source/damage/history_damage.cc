// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/tribology/damage/history_contradictions.h>
#include <squeal/tribology/damage/history_damage.h>
#include <squeal/tribology/damage/sample_spacing.h>
#include <squeal/tribology/damage/sampling_error.h>
#include <squeal/tribology/fatigue/open_contact.h>
#include <squeal/tribology/fatigue/spectral.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    using RowMajor =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /** Windows of the spectra: samples. */
    constexpr std::size_t n_window = 1024;

    /** Part of an average that is the node's own stress from which on nothing
     * is averaged: where nodes are about as far apart as the averaging length
     * is long. */
    constexpr double own_alone = 0.95;



    /** "" where the averages of @p weights reach the neighbours. */
    std::string
    note_of_averaging(const RowMajor &weights, const double length)
    {
      const double own = weights.diagonal().mean();
      if (weights.rows() < 2 || length <= 0. || own < own_alone)
        return "";
      return "'Averaging length', " + rounded_text(1e3 * length, 3) +
             " mm, does not reach from node to node: " +
             rounded_text(100. * own, 3) +
             " % of each average is the stress of the node itself, and the "
             "columns 'averaged' depend on the mesh as the others do; take at "
             "least twice the distance of the nodes";
    }



    /** Stress of all nodes: a row for each node. What is not above @p none, Pa
     * and >= 0, in size is 0: an open contact has no cycles. */
    RowMajor
    stresses(const HistorySamples    &s,
             const std::size_t        n_nodes,
             const FatigueParameters &fatigue,
             const double             none)
    {
      using Q = FatigueParameters::Quantity;
      RowMajor          result(n_nodes, s.n_samples());
      const std::size_t step   = fatigue.quantity == Q::pressure ? 1 : 2;
      const std::size_t offset = fatigue.quantity == Q::traction_y ? 1 : 0;
      const double     *values =
        fatigue.quantity == Q::pressure ? s.pressure.data() : s.traction.data();
      const double factor =
        fatigue.plateau_factor * (fatigue.quantity == Q::pressure ? -1. : 1.);
      // in squares, so that both sides stay in the cache
      const std::size_t edge = 32;
      for (std::size_t i = 0; i < s.n_samples(); i += edge)
        for (std::size_t k = 0; k < n_nodes; k += edge)
          for (std::size_t a = i; a < std::min(i + edge, s.n_samples()); ++a)
            for (std::size_t b = k; b < std::min(k + edge, n_nodes); ++b)
              {
                const double value =
                  factor * values[(a * n_nodes + b) * step + offset];
                result(b, a) = std::abs(value) > none ? value : 0.;
              }
      return result;
    }



    /** Lowest and highest stress of the history. */
    std::array<double, 2>
    stress_bounds(const HistoryReader     &reader,
                  const HistoryWindow     &window,
                  const std::size_t        n_chunk,
                  const FatigueParameters &fatigue)
    {
      double lowest = 1e300, highest = -1e300;
      for_each_chunk(reader, window, n_chunk, [&](const HistorySamples &s) {
        const RowMajor stress =
          stresses(s, reader.layout().n_nodes(), fatigue, 0.);
        lowest  = std::min(lowest, stress.minCoeff());
        highest = std::max(highest, stress.maxCoeff());
      });
      return {{lowest, highest}};
    }



    /** Samples per second, on the mean. */
    double
    mean_rate(const HistoryReader &reader, const HistoryWindow &window)
    {
      HistorySamples first, last;
      reader.read(window.first, 1, first);
      reader.read(window.first + window.n - 1, 1, last);
      return (window.n - 1) / (last.time[0] - first.time[0]);
    }

    std::string
    no_spectra(const std::size_t n_least)
    {
      return "no spectral estimate: it needs evenly spaced times and at "
             "least " +
             std::to_string(n_least) + " samples";
    }



    /** The lines that a spectral estimate follows: without knee and limit. */
    std::vector<SnCurve>
    straight_lines(std::vector<SnCurve> curves)
    {
      for (SnCurve &curve : curves)
        {
          curve.knee_stress     = 0.;
          curve.endurance_limit = 0.;
        }
      return curves;
    }



    /**
     * Whether a history that repeats ends with the sample with which it begins:
     * @p first and @p last hold the stresses of all nodes, @p bounds the lowest
     * and the highest stress there is, Pa.
     */
    bool
    is_closed(const FatigueParameters     &fatigue,
              const Eigen::VectorXd       &first,
              const Eigen::VectorXd       &last,
              const std::array<double, 2> &bounds)
    {
      // the latter is what 32-bit numbers round to
      constexpr double repeated = 1e-6, rounding_of_file = 2e-7;
      const double     alike =
        repeated * (bounds[1] - bounds[0]) +
        rounding_of_file * std::max(std::abs(bounds[0]), std::abs(bounds[1]));
      return fatigue.residue == FatigueParameters::Residue::repeating &&
             (last - first).cwiseAbs().maxCoeff() <= alike;
    }



    /** Time that the cycles of a history take, s. One that repeats begins anew
     * an interval behind its last sample, unless it is closed. */
    double
    counted_time(const HistoryDamage     &result,
                 const FatigueParameters &fatigue,
                 const bool               closed)
    {
      return fatigue.residue == FatigueParameters::Residue::repeating && !closed
               ? result.duration * result.samples / (result.samples - 1.)
               : result.duration;
    }



    /** A line for a run whose history is so much of the life that the order of
     * its cycles matters (MansonHalford); "" elsewhere. */
    std::string
    note_of_order(const HistoryDamage &result, const FatigueParameters &fatigue)
    {
      double largest = 0.;
      for (const HistoryDamage::Node &node : result.nodes)
        for (const double share : node.damage)
          largest = std::max(largest, share);
      if (fatigue.accumulation !=
            FatigueParameters::Accumulation::manson_halford ||
          largest < 0.01)
        return "";
      return "the history takes up to " + rounded_text(largest, 2) +
             " of the life at a node: 'Accumulation = manson halford' takes "
             "its cycles as mixed, and their order changes the life by up to "
             "about one repetition of the history";
    }



    /** Whether the rule for mean stresses divides by what a strength leaves of
     * them, which makes the damage infinite at the strength. */
    bool
    has_strength(const FatigueParameters::MeanStress rule)
    {
      using Rule = FatigueParameters::MeanStress;
      switch (rule)
        {
        case Rule::goodman:
        case Rule::gerber:
        case Rule::morrow:
          return true;
        case Rule::none:
        case Rule::swt:
        case Rule::walker:
          return false;
        }
      unknown_choice("mean stress");
    }



    /** @p largest is the largest stress of the history. */
    void
    require_finite(const HistoryDamage     &result,
                   const FatigueParameters &fatigue,
                   const double             largest)
    {
      for (std::size_t k = 0; k < result.nodes.size(); ++k)
        for (std::size_t i = 0; i < result.nodes[k].damage.size(); ++i)
          {
            if (std::isfinite(result.nodes[k].damage[i]))
              continue;
            if (has_strength(fatigue.mean_stress))
              throw InputError(
                "a mean stress of the history exceeds 'Fatigue/Ultimate "
                "strength' or 'Strength coefficient': raise it or choose "
                "another 'Mean stress'");
            throw InputError(
              "the damage of 'Fatigue/Exponents' " +
              shortest_text(fatigue.exponents[i]) + " at node " +
              std::to_string(k) +
              " is beyond the numbers: raise 'Fatigue/Reference stress', or "
              "look at the largest stress of the history, " +
              rounded_text(largest, 3) + " Pa");
          }
    }



    /** A line for changes of status that no sample reaches; "" without. */
    std::string
    note_of_changes(const std::vector<StatusChange> &changes,
                    const HistoryReader             &reader)
    {
      // squeal's own may lie behind the last sample, by less than one spacing.
      // Those long before the first one say nothing where others lie within: a
      // recording may begin after the motion does.
      const auto [first, last] = reader.time_range();
      const double spacing     = (last - first) / (reader.n_samples() - 1.);
      std::size_t  n_before = 0, n_behind = 0;
      for (const StatusChange &change : changes)
        {
          n_before += change.time < first - spacing;
          n_behind += change.time > last + spacing;
        }
      if (n_behind == 0 && n_before < changes.size())
        return "";
      return changes.empty()
               ? ""
               : std::to_string(n_before + n_behind) + " of " +
                   std::to_string(changes.size()) +
                   " times in 'status_changes/time' are not between the first "
                   "sample and the last one, " +
                   rounded_text(first, 6) + " to " + rounded_text(last, 6) +
                   " s: those behind are not counted; are they in seconds, and "
                   "from the same start?";
    }
  } // namespace



  std::size_t
  HistoryDamage::worst_node(const std::size_t curve) const
  {
    std::size_t worst = 0;
    for (std::size_t k = 1; k < nodes.size(); ++k)
      if (nodes[k].damage[curve] > nodes[worst].damage[curve])
        worst = k;
    return worst;
  }



  HistoryWindow
  history_window(const HistoryReader &reader, const HistoryParameters &p)
  {
    HistoryWindow       window;
    const std::uint64_t end =
      p.end_time >= reader.time_range()[1]
        ? reader.n_samples()
        : reader.sample_at(std::nextafter(p.end_time, 1e300));
    window.first = reader.sample_at(p.start_time);
    window.n     = end > window.first ? end - window.first : 0;
    if (window.n < 2)
      throw InputError("'" + reader.path() +
                       "' has fewer than two samples between 'History/Start "
                       "time' and 'End time'");
    return window;
  }



  void
  for_each_chunk(const HistoryReader                               &reader,
                 const HistoryWindow                               &window,
                 const std::size_t                                  n_chunk,
                 const std::function<void(const HistorySamples &)> &action)
  {
    HistorySamples samples;
    for (std::uint64_t done = 0; done < window.n;)
      {
        const std::uint64_t n =
          std::min<std::uint64_t>(n_chunk, window.n - done);
        reader.read(window.first + done, n, samples);
        action(samples);
        done += n;
      }
  }



  HistoryDamage
  count_history(const HistoryReader                    &reader,
                const HistoryParameters                &history,
                const FatigueParameters                &fatigue,
                const SurfaceParameters                &surface,
                const ContactGrid                      &grid,
                const std::function<void(std::size_t)> &progress)
  {
    const std::size_t           n      = reader.layout().n_nodes();
    const HistoryWindow         window = history_window(reader, history);
    const std::array<double, 2> bounds =
      stress_bounds(reader, window, history.chunk, fatigue);
    const auto [lowest, highest] = bounds;
    const double none =
      rest_of_none * std::max(std::abs(lowest), std::abs(highest));
    const CountingRules plain = counting_rules(fatigue);
    CountingRules       rules = plain;
    const double        largest =
      fatigue.largest_range > 0. ? fatigue.largest_range : highest - lowest;
    rules.empty_matrix.emplace(fatigue.n_classes,
                               std::max(largest, 1e-300),
                               lowest,
                               std::max(highest, lowest + 1e-300));
    HistoryDamage result;
    result.has_slip_rate = reader.layout().has_slip_rate;
    result.has_stick_slip =
      reader.layout().has_slip_rate || reader.layout().has_status;
    std::vector<WelchEstimator> spectra;
    if (fatigue.spectral && window.n >= n_window)
      {
        spectra.assign(n, WelchEstimator(n_window, mean_rate(reader, window)));
        rules.straight_curves = straight_lines(rules.curves);
      }
    else if (fatigue.spectral)
      result.notes.push_back(no_spectra(n_window));

    std::vector<DamageCounter> counters(n, DamageCounter(rules));
    std::vector<DamageCounter> averaged(n, DamageCounter(plain));
    const RowMajor  weights = grid.averaging(fatigue.averaging_length);
    const auto      changes = reader.layout().has_status
                                ? reader.status_changes()
                                : std::vector<StatusChange>();
    SurfaceSummer   summer(reader.layout(), surface, changes);
    PeakLoss        loss(fatigue, n);
    SamplingError   sampling(window.n, n, rules.curves.size());
    Eigen::VectorXd begin; // stresses of the first sample
    bool            closed = false;

    HistoryContradictions contradictions(reader.layout(), surface.stick_speed);
    SampleSpacing         spacing;
    double                first = 0., last = 0.;
    for_each_chunk(reader, window, history.chunk, [&](const HistorySamples &s) {
      if (result.samples == 0)
        first = s.time[0];
      last = s.time.back();
      contradictions.add(s);
      sampling.add_pressures(s);
      spacing.add(s.time);
      result.samples += s.n_samples();
      RowMajor stress = stresses(s, n, fatigue, none);
      if (begin.size() == 0)
        begin = stress.col(0);
      if (result.samples == window.n)
        closed = is_closed(fatigue, begin, stress.rightCols(1), bounds);
      // What the two differ by is rounding, no cycle.
      if (closed)
        stress.rightCols(1) = begin;
      for (std::size_t k = 0; k < n; ++k)
        {
          sampling.count(k, stress.row(k).data(), s.n_samples(), counters[k]);
          loss.add(k, stress.row(k).data(), s.n_samples());
          if (!spectra.empty())
            spectra[k].add(stress.row(k).data(), s.n_samples());
        }
      if (fatigue.averaging_length > 0.)
        {
          // sample by sample: the sums do not depend on the length of a piece
          RowMajor mean(n, s.n_samples());
          for (std::size_t i = 0; i < s.n_samples(); ++i)
            mean.col(i) = weights * stress.col(i);
          for (std::size_t k = 0; k < n; ++k)
            averaged[k].add(mean.row(k).data(), s.n_samples());
        }
      summer.add(s);
      if (progress)
        progress(s.n_samples());
    });
    if (!spectra.empty() && !spacing.is_even())
      {
        spectra.clear();
        result.notes.push_back(no_spectra(n_window));
      }
    result.duration = last - first;
    result.period   = counted_time(result, fatigue, closed);
    result.nodes.resize(n);
    std::vector<double> damages, areas;
    for (std::size_t k = 0; k < n; ++k)
      {
        HistoryDamage::Node &node = result.nodes[k];
        counters[k].finish();
        averaged[k].finish();
        node.damage         = counters[k].damages();
        node.sampling_error = closed
                                ? std::vector<double>(node.damage.size(), 0.)
                                : sampling.of_node(k, counters[k]);
        node.averaged =
          fatigue.averaging_length > 0. ? averaged[k].damages() : node.damage;
        damages.push_back(node.damage[loss.exponent()]);
        areas.push_back(grid.area(k));
        node.cycles        = counters[k].n_cycles();
        node.largest_range = counters[k].largest_range();
        node.surface       = summer.sums()[k];
        result.deepest     = std::max(result.deepest, counters[k].deepest());
        result.matrices.push_back(*counters[k].matrix());
        if (!spectra.empty())
          {
            const std::array<double, 5> moments =
              spectra[k].spectrum().moments();
            for (const SnCurve &curve : rules.curves)
              node.dirlik.push_back(dirlik_damage(moments, curve));
            node.straight = counters[k].straight_damages();
          }
      }
    require_finite(
      result, fatigue, std::max(std::abs(lowest), std::abs(highest)));
    result.lost           = loss.finish(damages, areas);
    result.sampling_error = sampling.of_mean(counters, areas);
    result.least_peak     = sampling.least_peak_of_quarters();
    // A whole period is no sample.
    if (closed)
      result.sampling_error.assign(rules.curves.size(), 0.);
    for (const std::string &note : contradictions.notes(summer.sums()))
      result.notes.push_back(note);
    for (const std::string &note :
         {note_of_averaging(weights, fatigue.averaging_length),
          spacing.note(),
          note_of_changes(changes, reader),
          note_of_order(result, fatigue),
          SamplingError::note(result.sampling_error, fatigue.exponents),
          PeakLoss::note(result.lost, fatigue.exponents[loss.exponent()])})
      if (!note.empty())
        result.notes.push_back(note);
    return result;
  }
} // namespace squeal::tribology
