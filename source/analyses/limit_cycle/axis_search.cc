// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/axis_search.h>
#include <squeal/analyses/limit_cycle/pairs_to_follow.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/model/reduced_motions.h>
#include <squeal/results/column_of.h>
#include <squeal/run/run_context.h>

#include <cmath>
#include <map>

namespace squeal
{
  namespace
  {
    constexpr std::size_t last_status =
      static_cast<std::size_t>(CycleStatus::aperiodic);
    /** More than any band has, so that a damaged number is told. */
    constexpr std::size_t most_pairs = 1000000;

    std::shared_ptr<const BranchModel>
    find_model(const BranchModels &models, const double coordinate)
    {
      try
        {
          return models.at(coordinate);
        }
      catch (const ComputationError &)
        {
          return nullptr;
        }
    }

    /** Where a pair grows and a motion was followed. */
    Cell
    of_run(const AxisSearch &x, const double value)
    {
      return x.rms_normal > 0. ? Cell(value) : Cell();
    }
  } // namespace



  std::string
  AxisSearch::outcome() const
  {
    return !slides          ? "no steady sliding"
           : n_growing == 0 ? "no growing pair"
                            : cycle_status_text(found);
  }

  NamedNumbers
  AxisSearch::memory() const
  {
    NamedNumbers result;
    result.set("parameter", parameter);
    result.set("slides", slides ? 1. : 0.);
    result.set("n_growing", n_growing);
    result.set("pair", std::vector<double>{pair.real(), pair.imag()});
    result.set("found", static_cast<double>(found));
    result.set("run", std::vector<double>{rms_normal, line, repetition});
    result.set("branch", branch);
    result.set("starts_branch", starts_branch ? 1. : 0.);
    return result;
  }

  AxisSearch
  AxisSearch::from_memory(const NamedNumbers &memory)
  {
    AxisSearch result;
    result.parameter = memory.number("parameter");
    result.slides    = memory.count("slides", 1) == 1;
    result.n_growing = memory.count("n_growing", most_pairs);
    const auto &pair = memory.get("pair", 2);
    result.pair      = {pair[0], pair[1]};
    result.found = static_cast<CycleStatus>(memory.count("found", last_status));
    const auto &run      = memory.get("run", 3);
    result.rms_normal    = run[0];
    result.line          = run[1];
    result.repetition    = run[2];
    result.branch        = memory.count("branch", most_pairs);
    result.starts_branch = memory.count("starts_branch", 1) == 1;
    return result;
  }



  std::optional<CycleResult>
  search_at(RunContext         &context,
            const BranchModels &models,
            const double        coordinate,
            AxisSearch         &search)
  {
    const Parameters &p     = context.parameters;
    const auto        model = find_model(models, coordinate);
    search.slides           = model != nullptr;
    if (!model)
      return {};
    const LinearizedMotion          linear = motions_about(model->about);
    const std::vector<Eigen::Index> pairs =
      pairs_to_follow(linear, p.eigen, p.limit_cycle);
    search.n_growing = growing_pairs(linear, p.eigen).size();
    for (const Eigen::Index k : pairs)
      {
        CycleResult result = find_cycle(
          model->map, model->about.sliding, linear, k, p.limit_cycle);
        if (!result.broken_off.empty())
          context.log.warning(p.sweep.axes.front().name + " = " +
                              rounded_text(search.parameter, 6) + ": " +
                              result.broken_off);
        if (k != pairs.front() && !result.has_converged())
          continue;
        search.pair       = result.pair;
        search.found      = result.found();
        search.rms_normal = result.run.rms_normal;
        search.line       = result.run.line;
        search.repetition = result.run.repetition;
        if (result.has_converged())
          return result;
      }
    return {};
  }



  Table
  search_table(const std::vector<AxisSearch> &searches)
  {
    using Type   = Table::Type;
    using Column = ColumnOf<AxisSearch>;
    const std::vector<Column> columns{
      {{"parameter", Type::real, "", "number that the branches run over", 8},
       [](const AxisSearch &x) { return Cell(x.parameter); }},
      {{"outcome", Type::text, "", "what the search has ended with"},
       [](const AxisSearch &x) { return Cell(x.outcome()); }},
      {{"branch",
        Type::integer,
        "",
        "of the cycle that was found; empty: none"},
       [](const AxisSearch &x) {
         return x.branch > 0 ? Cell(x.branch) : Cell();
       }},
      {{"starts_branch",
        Type::integer,
        "",
        "1: no branch had come to that cycle"},
       [](const AxisSearch &x) { return Cell(x.starts_branch ? 1 : 0); }},
      {{"n_growing", Type::integer, "", "pairs of the band that grow"},
       [](const AxisSearch &x) { return Cell(x.n_growing); }},
      {{"pair_frequency_hz", Type::real, "Hz", "of the pair it starts from"},
       [](const AxisSearch &x) {
         return x.n_growing > 0 ? Cell(x.pair.imag() / (2. * M_PI)) : Cell();
       }},
      {{"pair_sigma_per_s", Type::real, "1/s", "growth rate of that pair"},
       [](const AxisSearch &x) {
         return x.n_growing > 0 ? Cell(x.pair.real()) : Cell();
       }},
      {{"run_rms_normal_n",
        Type::real,
        "N",
        "of the normal force in the motion that was followed"},
       [](const AxisSearch &x) { return of_run(x, x.rms_normal); }},
      {{"run_line_hz", Type::real, "Hz", "its largest line"},
       [](const AxisSearch &x) { return of_run(x, x.line); }},
      {{"run_repetition", Type::real, "", "how well it repeats itself"},
       [](const AxisSearch &x) { return of_run(x, x.repetition); }}};
    return table_of(columns, searches);
  }



  std::string
  searches_sentence(const std::vector<AxisSearch> &searches)
  {
    if (searches.empty())
      return "";
    std::map<std::string, std::size_t> outcomes;
    for (const AxisSearch &x : searches)
      ++outcomes[x.outcome()];
    std::string text;
    for (const auto &[outcome, n] : outcomes)
      text += (text.empty() ? "" : ", ") + outcome + ": " + std::to_string(n);
    return std::to_string(searches.size()) +
           " searches along the axis: " + text;
  }
} // namespace squeal
