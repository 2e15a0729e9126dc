// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/base/exceptions.h>
#include <squeal/eigen/mode_naming.h>

#include <boost/algorithm/string/split.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** Below it the disc goes along with a vibration of other bodies. */
    constexpr double smallest_disc_share = 0.25;

    /** n, m of a bending doublet of the disc. */
    using Doublet = std::pair<int, int>;

    /** The bending doublets in a name and which of the members, 0 for + and 1
     * for -; both where the nodal lines turn. */
    std::map<Doublet, std::set<int>>
    members_in(const std::string &name)
    {
      std::map<Doublet, std::set<int>> result;
      std::vector<std::string>         alternatives;
      boost::split(alternatives, name, [](const char c) { return c == '|'; });
      for (const std::string &text : alternatives)
        {
          int  n = 0, m = 0;
          char parity = ' ';
          if (std::sscanf(text.c_str(), "(%d,%d%c)", &n, &m, &parity) == 3 &&
              (parity == '+' || parity == '-'))
            result[{n, m}].insert(parity == '+' ? 0 : 1);
        }
      return result;
    }

    /** The pair of one member with the largest sigma. */
    struct Loudest
    {
      Cell sigma, at, frequency, share;
      bool is_unstable = false, turns = false;
    };

    /** Both members of a doublet along one line. */
    struct Members
    {
      Loudest             of[2];
      std::vector<double> splits; /**< of the points that have both, Hz */
    };

    /** The member of a doublet at one point: that with most of the disc. */
    struct Frequencies
    {
      double hz[2]    = {0., 0.};
      double share[2] = {0., 0.};
    };

    double
    median(std::vector<double> values)
    {
      std::sort(values.begin(), values.end());
      const std::size_t n = values.size();
      return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
    }

    std::string
    verdict(const Members &members)
    {
      const Loudest &plus = members.of[0], &minus = members.of[1];
      if (!plus.is_unstable && !minus.is_unstable)
        return "none";
      const bool is_plus =
        !minus.is_unstable ||
        (plus.is_unstable && std::get<double>(plus.sigma.value) >=
                               std::get<double>(minus.sigma.value));
      return (is_plus ? plus : minus).turns ? "both" : is_plus ? "+" : "-";
    }

    Table
    empty_table(const SweepGrid &grid)
    {
      Table table;
      add_fixed_axes(table, grid);
      for (const Table::Column &column : std::vector<Table::Column>{
             {"doublet", Type::text, "", "nodal circles, nodal diameters"},
             {"squeals",
              Type::text,
              "",
              "the member with the largest sigma; both: its nodal lines turn; "
              "none: no pair that counts is unstable"}})
        table.add_column(column);
      for (const Table::Column &column : std::vector<Table::Column>{
             {"sigma_plus_per_s", Type::real, "1/s", "largest of +", 5},
             {"at_plus", Type::real, "", "where, on the first axis", 5},
             {"frequency_plus_hz", Type::real, "Hz", "there", 6},
             {"disc_share_plus", Type::real, "", "of the energy, there", 3},
             {"sigma_minus_per_s", Type::real, "1/s", "largest of -", 5},
             {"at_minus", Type::real, "", "where, on the first axis", 5},
             {"frequency_minus_hz", Type::real, "Hz", "there", 6},
             {"disc_share_minus", Type::real, "", "of the energy, there", 3}})
        table.add_column(column);
      table.add_column({"split_hz",
                        Type::real,
                        "Hz",
                        "frequency of + minus that of -, median over the line",
                        4});
      return table;
    }

    void
    add_row(const Doublet           &doublet,
            const Members           &members,
            const std::vector<Cell> &fixed,
            Table                   &table)
    {
      std::vector<Cell> row = fixed;
      row.emplace_back("(" + std::to_string(doublet.first) + "," +
                       std::to_string(doublet.second) + ")");
      row.emplace_back(verdict(members));
      for (const Loudest &l : members.of)
        row.insert(row.end(), {l.sigma, l.at, l.frequency, l.share});
      row.push_back(members.splits.empty() ? Cell()
                                           : Cell(median(members.splits)));
      table.add_row(row);
    }
  } // namespace



  namespace
  {
    using DoubletMembers = std::map<Doublet, Members>;

    /** What a row of eigenvalues.csv or a peak says of the doublets. */
    struct NamedPair
    {
      std::string name;
      double      sigma, at, frequency, share;
      bool        is_unstable;
    };

    void
    enter(const NamedPair &pair, DoubletMembers &line)
    {
      if (pair.share < smallest_disc_share)
        return;
      for (const auto &[doublet, members] : members_in(pair.name))
        for (const int member : members)
          {
            Loudest &loudest = line[doublet].of[member];
            if (!loudest.sigma.is_missing() &&
                std::get<double>(loudest.sigma.value) >= pair.sigma)
              continue;
            loudest = {pair.sigma,
                       pair.at,
                       pair.frequency,
                       pair.share,
                       pair.is_unstable,
                       members.size() == 2};
          }
    }

    /** Unstable ranges are narrow: their peaks lie between the points. */
    void
    enter_peaks(const SweepModel  &model,
                const SweepLine   &line,
                const unsigned int disc,
                DoubletMembers    &members)
    {
      for (const UnstableRange &range : line.ranges)
        if (const auto peak = peak_pair(model, line, range))
          {
            const auto shares =
              model.energy_shares(peak->point, peak->pairs.right);
            const auto names =
              model.names(peak->pairs.right, shares, peak->pairs.lambda);
            enter({names[peak->index].text,
                   peak->sigma(),
                   model.grid().value(0, peak->point[0]),
                   peak->frequency(),
                   shares(disc, peak->index),
                   peak->sigma() > 0.},
                  members);
          }
    }

    /** + minus - of the doublets of one point, where both have a name of their
     * own: of the pairs with most of the disc. */
    void
    enter_splits(const std::vector<NamedPair> &point, DoubletMembers &line)
    {
      std::map<Doublet, Frequencies> found;
      for (const NamedPair &pair : point)
        for (const auto &[doublet, members] : members_in(pair.name))
          if (members.size() == 1)
            {
              const int    member = *members.begin();
              Frequencies &f      = found[doublet];
              if (pair.share > std::max(f.share[member], smallest_disc_share))
                {
                  f.share[member] = pair.share;
                  f.hz[member]    = pair.frequency;
                }
            }
      for (const auto &[doublet, f] : found)
        if (f.share[0] > 0. && f.share[1] > 0.)
          line[doublet].splits.push_back(f.hz[0] - f.hz[1]);
    }
  } // namespace



  Table
  doublet_table(const SweepModel    &model,
                const SweepSolution &solution,
                const Table         &eigenvalues)
  {
    const unsigned int disc = model.model().namer().disc();
    if (disc == -1u || model.model().namer().n_coordinates() == 0)
      return {};
    const SweepGrid  &grid  = model.grid();
    const std::string share = "ke_share_" + model.scene().bodies[disc].name;
    Table             table = empty_table(grid);
    std::size_t       row   = 0;
    for (const SweepLine &line : solution.lines)
      {
        DoubletMembers members;
        for (const TrackedPoint &at : line.points)
          {
            if (!at.asked)
              continue;
            std::vector<NamedPair> point;
            for (unsigned int j = 0; j < at.pairs.size(); ++j, ++row)
              point.push_back({eigenvalues.text(row, "name"),
                               eigenvalues.real(row, "sigma_per_s"),
                               grid.value(0, at.coordinate),
                               eigenvalues.real(row, "frequency_hz"),
                               eigenvalues.real(row, share),
                               eigenvalues.integer(row, "unstable") == 1});
            for (const NamedPair &pair : point)
              enter(pair, members);
            enter_splits(point, members);
          }
        enter_peaks(model, line, disc, members);
        for (const auto &[doublet, both] : members)
          add_row(doublet, both, fixed_values(grid, line.start), table);
      }
    return table;
  }
} // namespace squeal
