// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/cycle_columns.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/output/judged_force.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** Of a number that a cycle has, if there is one. */
    template <typename Value>
    std::function<Cell(const CycleRow &)>
    of_cycle(const Value value)
    {
      return [value](const CycleRow &row) {
        return row.is_found ? Cell(value(row)) : Cell();
      };
    }

    /** Of its figures. */
    template <typename Number, typename Figures>
    std::function<Cell(const CycleRow &)>
    figure(Number Figures::*number)
    {
      return of_cycle(
        [number](const CycleRow &row) { return row.figures.*number; });
    }

    const std::vector<ColumnOf<CycleRow>> &
    common_columns()
    {
      static const std::vector<ColumnOf<CycleRow>> columns = {
        {{"frequency_hz", Type::real, "Hz", "1/period", 8},
         figure(&CycleFigures::frequency)},
        {{"dominant_line_hz",
          Type::real,
          "Hz",
          "largest harmonic of the normal force"},
         of_cycle([](const CycleRow &row) {
           return row.figures.largest_harmonic * row.figures.frequency;
         })},
        {{"mean_normal_n", Type::real, "N", "mean normal force"},
         figure(&CycleFigures::mean_normal)},
        {{"rms_normal_n",
          Type::real,
          "N",
          "of the normal force about its mean"},
         figure(&CycleFigures::rms_normal)},
        {judged_force_column("judged_force"),
         [](const CycleRow &row) {
           return judged_force_cell(row.is_found ? row.figures.judged_force
                                                 : "");
         }},
        {{"rms_tangential_n",
          Type::real,
          "N",
          "of the tangential force about its mean"},
         figure(&CycleFigures::rms_tangential)},
        {{"n_opening", Type::integer, "", "nodes that open in a period"},
         figure(&CycleFigures::n_opening)},
        {{"n_sticking", Type::integer, "", "nodes that stick in a period"},
         figure(&CycleFigures::n_sticking)},
        {{"stability", Type::text, "", "by the Floquet multipliers"},
         of_cycle(
           [](const CycleRow &row) { return row.multipliers.stability(); })},
        {{"largest_multiplier",
          Type::real,
          "",
          "in size, of those beside the trivial one"},
         of_cycle([](const CycleRow &row) { return row.multipliers.largest; })},
        {{"largest_multiplier_error",
          Type::real,
          "",
          "the larger of what the trivial one is off and of the difference to "
          "half the steps, along a branch that of its start",
          3},
         of_cycle(
           [](const CycleRow &row) { return row.multipliers.uncertainty(); })},
        {{"trivial_multiplier_error",
          Type::real,
          "",
          "what the multiplier of the motion itself is off 1",
          3},
         of_cycle([](const CycleRow &row) {
           return std::abs(row.multipliers.trivial - 1.);
         })},
        {{"residual",
          Type::real,
          "",
          "what the state misses after a period, over the motion, with the "
          "changes of status located on it",
          3},
         [](const CycleRow &row) { return or_missing(row.residual); }},
        {{"n_iterations",
          Type::integer,
          "",
          "of Newton's method, where a cycle is sought with half the steps as "
          "well"},
         [](const CycleRow &row) { return Cell(row.n_iterations); }}};
      return columns;
    }
  } // namespace



  CycleRow
  cycle_row(const CycleResult &c)
  {
    const PeriodicMotion &furthest =
      c.motion.history.empty() ? c.coarse : c.motion;
    return {c.figures,
            c.multipliers,
            furthest.history.empty()
              ? std::numeric_limits<double>::quiet_NaN()
              : std::max(furthest.residual, furthest.left_open.residual),
            c.coarse.iterations + c.motion.iterations,
            c.has_converged()};
  }

  CycleRow
  cycle_row(const BranchPoint &x)
  {
    return {x.figures,
            x.multipliers,
            std::max(x.motion.residual, x.motion.left_open.residual),
            x.motion.iterations,
            true};
  }



  std::string
  judged_force_text(const CycleFigures             &figures,
                    const std::vector<std::string> &pairs)
  {
    return (figures.judged_force.empty() ? "normal force"
                                         : figures.judged_force) +
           (pairs.empty() ? "" : " of " + pairs[figures.loudest]);
  }

  std::string
  text_of_moment(const CycleFigures             &figures,
                 const std::vector<std::string> &pairs)
  {
    if (figures.judged_force.empty())
      return "";
    return "the " + judged_force_text(figures, pairs) + " vibrates by " +
           rounded_text(figures.rms_normal, 3) +
           " N rms over the radius of gyration of the face, their sum by " +
           rounded_text(figures.rms_of_sum, 3) +
           " N: rms, lines, harmonics and repetition are those of the former";
  }



  std::vector<std::string>
  names_of_pairs(const SceneParameters &scene)
  {
    std::vector<std::string> result;
    if (scene.contacts.size() > 1)
      for (const ContactParameters &contact : scene.contacts)
        result.push_back(contact.name);
    return result;
  }

  const std::vector<PairColumn> &
  columns_of_pairs()
  {
    const auto of_forces = [](double ForceFigures::*number) {
      return [number](const CycleFigures &, const ForceFigures &pair) {
        return Cell(pair.*number);
      };
    };
    static const std::vector<PairColumn> columns = {
      {{"dominant_line_hz",
        Type::real,
        "Hz",
        "largest harmonic of the normal force"},
       [](const CycleFigures &cycle, const ForceFigures &pair) {
         return Cell(pair.largest_harmonic * cycle.frequency);
       }},
      {{"mean_normal_n", Type::real, "N", "mean normal force"},
       of_forces(&ForceFigures::mean_normal)},
      {{"rms_normal_n", Type::real, "N", "of the normal force about its mean"},
       of_forces(&ForceFigures::rms_normal)},
      {judged_force_column("judged_force"),
       [](const CycleFigures &, const ForceFigures &pair) {
         return judged_force_cell(pair.judged_force);
       }},
      {{"min_normal_n", Type::real, "N", "least normal force"},
       of_forces(&ForceFigures::min_normal)},
      {{"max_normal_n", Type::real, "N", "largest normal force"},
       of_forces(&ForceFigures::max_normal)},
      {{"rms_tangential_n",
        Type::real,
        "N",
        "of the tangential force about its mean"},
       of_forces(&ForceFigures::rms_tangential)}};
    return columns;
  }



  const ColumnOf<CycleRow> &
  common_cycle_column(const std::string &name)
  {
    const auto &all  = common_columns();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto &c) {
      return c.declaration.name == name;
    });
    AssertThrow(found != all.end(), dealii::ExcMessage("no column " + name));
    return *found;
  }
} // namespace squeal
