// SPDX-License-Identifier: LGPL-2.1-or-later

// Changes that stop a squeal, and what else they wake.

#include <squeal/analyses/sweep/sweep_solution.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** Changes are looked at from this share on, each so much larger. */
    constexpr double first_change = 0.005, growth = 1.25;
    /** A pair of another frequency than this, relative, is another pair. */
    constexpr double same_frequency = 0.03;
    /** What is added to the smallest change that stabilises, so that it does
     * not stand on the edge. */
    constexpr double margin = 1.1;
    /** Direct solutions for one range at most. */
    constexpr unsigned int most_checks = 3;

    struct UnstablePair
    {
      double frequency, sigma;
    };

    /** The smallest change of one number in one direction. */
    struct Change
    {
      unsigned int number = 0;
      std::string  entry;
      double       value = 0.; /**< as it stands, SI units */
      double       share = 0.; /**< signed; 0: none stabilises */
      double       sigma = 0.; /**< the largest of the band with it, 1/s */
      double       up_to = 0.; /**< share at which a pair is unstable again,
                                    or the largest looked at */
      std::optional<UnstablePair> tuned_in; /**< the worst other on the way */
      double                      tuned_in_at = 0.; /**< signed share */

      double
      new_value() const
      {
        return value * (1. + share);
      }
    };

    /** The scene at the peak of a range with one number changed. */
    class ChangedScene
    {
    public:
      ChangedScene(const SweepModel &m, const PeakPair &p)
        : model(m)
        , peak(p)
      {
      }

      /** Unstable pairs and the largest sigma with a number multiplied by
       * 1 + @p share. */
      std::vector<UnstablePair>
      unstable(const unsigned int number,
               const double       share,
               double            &sigma) const
      {
        const ComplexPairs        pairs = solve(number, 1. + share);
        std::vector<UnstablePair> result;
        sigma = -1e300;
        for (unsigned int i = 0; i < pairs.size(); ++i)
          {
            sigma = std::max(sigma, pairs.sigma(i));
            if (pairs.sigma(i) > 0.)
              result.push_back({pairs.frequency(i), pairs.sigma(i)});
          }
        return result;
      }

      ComplexPairs
      solve_directly(const Change &change) const
      {
        return direct_pairs(
          model,
          place(change.number, 1. + change.share),
          model.grid().scene(peak.point, change.number, 1. + change.share));
      }

    private:
      /** An axis of a single entry moves the point, so that the basis of the
       * right cell is used; other numbers leave it where it is. */
      SweepPoint
      place(const unsigned int number, const double factor) const
      {
        const SweepGrid &grid  = model.grid();
        SweepPoint       point = peak.point;
        for (unsigned int a = 0, first = 0; a < grid.n_axes(); ++a)
          {
            const std::size_t n = grid.axis(a).entries.size();
            if (number == first && n == 1)
              point[a] = grid.is_logarithmic(a) ? point[a] + std::log10(factor)
                                                : point[a] * factor;
            first += n;
            point[a] =
              std::min(std::max(point[a], grid.lower(a)), grid.upper(a));
          }
        return point;
      }

      ComplexPairs
      solve(const unsigned int number, const double factor) const
      {
        return solve_point_in_cell(
          model.reduced(),
          place(number, factor),
          model.system().coefficients(
            model.grid().scene(peak.point, number, factor)),
          model.band());
      }

      const SweepModel &model;
      const PeakPair   &peak;
    };

    /** The worst pair that did not squeal before; @p known are the frequencies
     * of those that did, which are followed. */
    std::optional<UnstablePair>
    newcomer(const std::vector<UnstablePair> &pairs, std::vector<double> &known)
    {
      std::optional<UnstablePair> worst;
      for (const auto &p : pairs)
        {
          const auto near =
            std::find_if(known.begin(), known.end(), [&](const double f) {
              return std::abs(p.frequency - f) < same_frequency * f;
            });
          if (near != known.end())
            *near = p.frequency;
          else if (!worst || p.sigma > worst->sigma)
            worst = p;
        }
      return worst;
    }

    /** Raises (@p sign 1) or lowers (-1) a number until nothing squeals, and
     * on until something does again. */
    Change
    search(const ChangedScene &scene,
           const Influence    &influence,
           const double        largest,
           const double        sign)
    {
      Change change;
      change.number = influence.number;
      change.entry  = influence.entry;
      change.value  = influence.value;
      double              sigma, before = 0.;
      std::vector<double> known;
      for (const auto &p : scene.unstable(change.number, 0., sigma))
        known.push_back(p.frequency);
      for (double share = first_change;; share *= growth)
        {
          const bool is_last = share >= largest;
          share              = std::min(share, largest);
          const auto pairs = scene.unstable(change.number, sign * share, sigma);
          const auto other = newcomer(pairs, known);
          if (other &&
              (!change.tuned_in || other->sigma > change.tuned_in->sigma))
            {
              change.tuned_in    = other;
              change.tuned_in_at = sign * share;
            }
          if (change.share == 0. && pairs.empty())
            {
              double low = before, high = share, s;
              while (high - low > 1e-3 * high)
                {
                  const double middle = 0.5 * (low + high);
                  (scene.unstable(change.number, sign * middle, s).empty()
                     ? high
                     : low)           = middle;
                }
              high = std::min(margin * high, largest);
              if (scene.unstable(change.number, sign * high, s).empty())
                {
                  change.share = sign * high;
                  change.sigma = s;
                }
            }
          else if (change.share != 0. && !pairs.empty())
            {
              change.up_to = sign * share;
              return change;
            }
          change.up_to = sign * share;
          if (is_last)
            return change;
          before = share;
        }
    }

    std::string
    percent(const double share)
    {
      return (share > 0. ? "+" : "") + rounded_text(100. * share, 3) + " %";
    }

    std::string
    text_of(const UnstablePair &pair, const double share)
    {
      return rounded_text(pair.frequency, 4) + " Hz, sigma " +
             rounded_text(pair.sigma, 3) + " 1/s, at " + percent(share);
    }

    struct Target
    {
      const SweepLine     *line;
      const UnstableRange *range;
    };

    std::vector<Target>
    worst_ranges(const SweepSolution &solution, const unsigned int n)
    {
      std::vector<Target> result;
      for (const auto &line : solution.lines)
        for (const auto &range : line.ranges)
          result.push_back({&line, &range});
      std::stable_sort(
        result.begin(), result.end(), [](const auto &a, const auto &b) {
          return a.range->peak_sigma > b.range->peak_sigma;
        });
      result.resize(std::min<std::size_t>(result.size(), n));
      return result;
    }

    Table
    empty_suggestions(const SweepGrid &grid)
    {
      Table table;
      add_fixed_axes(table, grid);
      for (const Table::Column &column : std::vector<Table::Column>{
             {"branch", Type::text, "", "unstable branch"},
             {"coordinate", Type::real, "", "of its peak on the first axis", 6},
             {"frequency_hz", Type::real, "Hz", "there", 6},
             {"sigma_per_s", Type::real, "1/s", "there", 5},
             {"rank", Type::integer, "", "1: the smallest change"},
             {"entry", Type::text, "", "number of the scene"},
             {"value", Type::real, "", "as it stands, SI units", 5},
             {"new_value", Type::real, "", "that leaves no pair unstable", 5},
             {"change_percent", Type::real, "", "from one to the other", 3},
             {"largest_sigma_per_s",
              Type::real,
              "1/s",
              "of the band with it, on the basis",
              4},
             {"stable_to_percent",
              Type::real,
              "",
              "change at which a pair is unstable again, or the largest tried",
              3},
             {"direct_sigma_per_s",
              Type::real,
              "1/s",
              "the largest of a direct solution with it",
              4},
             {"direct_frequency_hz", Type::real, "Hz", "of that pair", 6},
             {"verdict", Type::text, "", "what the direct solution says"},
             {"tunes_in",
              Type::text,
              "",
              "worst other pair that is unstable on the way"}})
        table.add_column(column);
      return table;
    }

    /** Direct solution with a change; the pair of the largest sigma. */
    UnstablePair
    check(const ChangedScene &scene, const Change &change)
    {
      const ComplexPairs pairs = scene.solve_directly(change);
      UnstablePair       worst{0., -1e300};
      for (unsigned int i = 0; i < pairs.size(); ++i)
        if (pairs.sigma(i) > worst.sigma)
          worst = {pairs.frequency(i), pairs.sigma(i)};
      return worst;
    }

    std::vector<Change>
    changes_for(const ChangedScene           &scene,
                const std::vector<Influence> &numbers,
                const double                  largest)
    {
      std::vector<Change> result;
      for (const auto &number : numbers)
        {
          if (number.value == 0.)
            continue;
          const Change up   = search(scene, number, largest, 1.);
          const Change down = search(scene, number, largest, -1.);
          const bool   takes_up =
            down.share == 0. ||
            (up.share != 0. && std::abs(up.share) < std::abs(down.share));
          result.push_back(takes_up ? up : down);
        }
      std::stable_sort(
        result.begin(), result.end(), [](const auto &a, const auto &b) {
          return (a.share == 0. ? 1e300 : std::abs(a.share)) <
                 (b.share == 0. ? 1e300 : std::abs(b.share));
        });
      return result;
    }

    void
    warn(RunContext &context, const PeakPair &peak, const Change &change)
    {
      const std::string squeal =
        "the squeal at " + rounded_text(peak.frequency(), 4) + " Hz";
      if (change.tuned_in)
        context.log.warning("changing " + change.entry + " against " + squeal +
                            " tunes in another pair: " +
                            text_of(*change.tuned_in, change.tuned_in_at));
    }
  } // namespace



  Table
  suggestion_table(const SweepModel    &model,
                   const SweepSolution &solution,
                   RunContext          &context)
  {
    Timers::Section        section(context.timers, "Solve: suggestions");
    const SweepGrid       &grid    = model.grid();
    const SweepParameters &p       = context.parameters.sweep;
    Table                  table   = empty_suggestions(grid);
    const auto             targets = worst_ranges(solution, p.suggestions);
    Progress               progress(context.log, "suggestions", targets.size());
    for (const auto &[line, range] : targets)
      {
        progress.advance();
        const auto peak = peak_pair(model, *line, *range);
        if (!peak)
          continue;
        const ChangedScene scene(model, *peak);
        const auto         changes = changes_for(
          scene, influences(model, *peak, p.sensitivities), p.largest_change);
        bool is_settled = false;
        for (std::size_t k = 0; k < changes.size(); ++k)
          {
            const Change               &change = changes[k];
            const bool                  exists = change.share != 0.;
            std::optional<UnstablePair> direct;
            if (exists && !is_settled && k < most_checks)
              direct = check(scene, change);
            if (direct && direct->sigma < 0.)
              {
                is_settled = true;
                warn(context, *peak, change);
              }
            std::vector<Cell> row = fixed_values(grid, line->start);
            row.insert(
              row.end(),
              {line->branch_names[range->branch],
               range->peak_at,
               peak->frequency(),
               peak->sigma(),
               k + 1,
               change.entry,
               change.value,
               exists ? Cell(change.new_value()) : Cell(),
               exists ? Cell(100. * change.share) : Cell(),
               exists ? Cell(change.sigma) : Cell(),
               exists ? Cell(100. * change.up_to) : Cell(),
               direct ? Cell(direct->sigma) : Cell(),
               direct ? Cell(direct->frequency) : Cell(),
               direct   ? (direct->sigma < 0. ? "stable" : "still unstable")
               : exists ? "not checked"
                        : "none within Largest change",
               change.tuned_in ? text_of(*change.tuned_in, change.tuned_in_at)
                               : ""});
            table.add_row(row);
          }
        if (!is_settled)
          context.log.warning("no single change within Sweep/Largest change "
                              "stops the squeal at " +
                              rounded_text(peak->frequency(), 4) + " Hz");
      }
    return table;
  }
} // namespace squeal
