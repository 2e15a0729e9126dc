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

    void
    enter(const Table       &pairs,
          const std::size_t  row,
          const std::string &axis,
          const double       share,
          const bool         turns,
          Loudest           &loudest)
    {
      const double sigma = pairs.real(row, "sigma_per_s");
      if (!loudest.sigma.is_missing() &&
          std::get<double>(loudest.sigma.value) >= sigma)
        return;
      loudest = {sigma,
                 pairs.real(row, axis),
                 pairs.real(row, "frequency_hz"),
                 share,
                 pairs.integer(row, "unstable") == 1,
                 turns};
    }

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
              "none: neither is unstable"}})
        table.add_column(column);
      for (const char *member : {"plus", "minus"})
        for (const Table::Column &column : std::vector<Table::Column>{
               {"sigma_", Type::real, "1/s", "largest on the line", 5},
               {"at_", Type::real, "", "where, on the first axis", 5},
               {"frequency_", Type::real, "Hz", "there", 6},
               {"disc_share_",
                Type::real,
                "",
                "of the disc in the kinetic energy there",
                3}})
          {
            const std::string unit = column.unit == "1/s"  ? "_per_s"
                                     : column.unit == "Hz" ? "_hz"
                                                           : "";
            table.add_column({column.name + member + unit,
                              column.type,
                              column.unit,
                              column.description,
                              column.n_digits});
          }
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



  Table
  doublet_table(const SweepModel &model, const Table &eigenvalues)
  {
    const unsigned int disc = main_disc(model.scene());
    if (disc == -1u || model.model().namer().n_coordinates() == 0)
      return {};
    const SweepGrid  &grid  = model.grid();
    const std::string axis  = grid.axis(0).name;
    const std::string share = "ke_share_" + model.scene().bodies[disc].name;
    using Line              = std::vector<double>;
    std::map<Line, std::map<Doublet, Members>> lines;
    std::vector<Line>                          order;
    std::map<Doublet, Frequencies>             at_point;
    const auto end_point = [&](std::map<Doublet, Members> &line) {
      for (const auto &[doublet, f] : at_point)
        if (f.share[0] > 0. && f.share[1] > 0.)
          line[doublet].splits.push_back(f.hz[0] - f.hz[1]);
      at_point.clear();
    };
    for (std::size_t i = 0; i < eigenvalues.n_rows(); ++i)
      {
        Line key;
        for (unsigned int a = 1; a < grid.n_axes(); ++a)
          key.push_back(eigenvalues.real(i, grid.axis(a).name));
        if (order.empty() || order.back() != key)
          order.push_back(key);
        auto        &line = lines[key];
        const double part = eigenvalues.real(i, share);
        if (part >= smallest_disc_share)
          for (const auto &[doublet, members] :
               members_in(eigenvalues.text(i, "name")))
            for (const int member : members)
              {
                enter(eigenvalues,
                      i,
                      axis,
                      part,
                      members.size() == 2,
                      line[doublet].of[member]);
                Frequencies &f = at_point[doublet];
                if (members.size() == 1 && part > f.share[member])
                  {
                    f.share[member] = part;
                    f.hz[member]    = eigenvalues.real(i, "frequency_hz");
                  }
              }
        if (i + 1 == eigenvalues.n_rows() ||
            eigenvalues.integer(i + 1, "point") !=
              eigenvalues.integer(i, "point"))
          end_point(line);
      }
    Table table = empty_table(grid);
    for (const Line &key : order)
      for (const auto &[doublet, members] : lines.at(key))
        add_row(doublet, members, {key.begin(), key.end()}, table);
    return table;
  }
} // namespace squeal
