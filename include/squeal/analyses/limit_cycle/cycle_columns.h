// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_limit_cycle_cycle_columns_h
#define squeal_analyses_limit_cycle_cycle_columns_h

#include <squeal/cycle/cycle_branch.h>
#include <squeal/parameters/scene_parameters.h>
#include <squeal/results/column_of.h>

#include <functional>
#include <string>
#include <vector>

namespace squeal
{
  /** What limit cycles have in common wherever they are listed. */
  struct CycleRow
  {
    const CycleFigures       &figures;
    const FloquetMultipliers &multipliers;
    double                    residual; /**< NaN: no iteration has begun */
    unsigned int              n_iterations;
    bool is_found; /**< else the cells of what is not there are empty */
  };

  CycleRow cycle_row(const CycleResult &cycle);
  CycleRow cycle_row(const BranchPoint &point);

  /** The common column @p name. */
  const ColumnOf<CycleRow> &common_cycle_column(const std::string &name);

  /** "moment of the normal forces about x of above": what rms and line of @p
   * figures are of; @p pairs: as names_of_pairs(). */
  std::string judged_force_text(const CycleFigures             &figures,
                                const std::vector<std::string> &pairs);

  /** Where a moment of the normal forces is judged: that it is, and by how much
   * their plain sum vibrates; else empty. */
  std::string text_of_moment(const CycleFigures             &figures,
                             const std::vector<std::string> &pairs);

  /** The contact pairs of @p scene where there are several. */
  std::vector<std::string> names_of_pairs(const SceneParameters &scene);

  /** What tables state of each of several pairs, behind its name. */
  struct PairColumn
  {
    Table::Column                                                   declaration;
    std::function<Cell(const CycleFigures &, const ForceFigures &)> value;
  };

  const std::vector<PairColumn> &columns_of_pairs();

  /** These columns of all pairs of @p names, and the name of the one that the
   * columns without a name are of; @p cycle: of a row, null where there is
   * none. */
  template <typename Row>
  std::vector<ColumnOf<Row>>
  of_each_pair(const std::vector<std::string>                         &names,
               const std::function<const CycleFigures *(const Row &)> &cycle)
  {
    std::vector<ColumnOf<Row>> result;
    if (names.empty())
      return result;
    result.push_back({{"loudest_pair",
                       Table::Type::text,
                       "",
                       "whose force that is judged has the largest rms"},
                      [names, cycle](const Row &row) {
                        const CycleFigures *f = cycle(row);
                        return f ? Cell(names[f->loudest]) : Cell();
                      }});
    for (std::size_t p = 0; p < names.size(); ++p)
      for (const PairColumn &column : columns_of_pairs())
        {
          Table::Column declaration = column.declaration;
          declaration.name          = names[p] + "_" + declaration.name;
          result.push_back(
            {declaration, [p, cycle, value = column.value](const Row &row) {
               const CycleFigures *f = cycle(row);
               return f ? value(*f, f->pairs[p]) : Cell();
             }});
        }
    return result;
  }

  /** The common column @p name for rows of another kind. */
  template <typename Row>
  ColumnOf<Row>
  common(const std::string &name)
  {
    const ColumnOf<CycleRow> &column = common_cycle_column(name);
    return {column.declaration,
            [&column](const Row &row) { return column.value(cycle_row(row)); }};
  }
} // namespace squeal

#endif
