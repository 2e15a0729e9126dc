// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/branch_output.h>
#include <squeal/analyses/limit_cycle/cycle_columns.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/text.h>
#include <squeal/results/chart.h>
#include <squeal/results/html_report.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <functional>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** Multipliers beyond this are drawn on a logarithmic axis. */
    constexpr double wide_range = 10.;

    /** Whose rms the points state. */
    std::string
    force_along(const CycleBranch &branch)
    {
      const bool has_moments = std::any_of(
        branch.points.begin(), branch.points.end(), [](const BranchPoint &x) {
          return !x.figures.judged_force.empty();
        });
      return has_moments ? "normal force or of the moment that is judged"
                         : "normal force";
    }

    /** The points of each stability over the parameter, and a line through all
     * of them. */
    Chart
    branch_chart(const CycleBranch                                &branch,
                 const AxisSettings                               &parameter,
                 const std::string                                &what,
                 const std::function<double(const BranchPoint &)> &value)
    {
      Chart chart;
      chart.x       = parameter;
      chart.y.label = what;
      ChartSeries line;
      line.style = ChartSeries::Style::lines;
      line.ink   = Ink::grey;
      for (const BranchPoint &x : branch.points)
        {
          line.x.push_back(x.parameter);
          line.y.push_back(value(x));
        }
      chart.series.push_back(line);
      const std::pair<const char *, Ink> kinds[] = {
        {"stable", Ink::blue},
        {"unstable", Ink::vermillion},
        {"at its limit", Ink::orange}};
      for (const auto &[kind, ink] : kinds)
        {
          ChartSeries points;
          points.label  = kind;
          points.ink    = ink;
          points.hollow = ink != Ink::blue;
          for (const BranchPoint &x : branch.points)
            if (x.multipliers.stability() == kind)
              {
                points.x.push_back(x.parameter);
                points.y.push_back(value(x));
              }
          if (!points.x.empty())
            chart.series.push_back(points);
        }
      return chart;
    }
  } // namespace



  Table
  branch_table(const CycleBranch &branch, const std::vector<std::string> &pairs)
  {
    using Column = ColumnOf<BranchPoint>;
    std::vector<Column> columns{
      {{"parameter", Type::real, "", "number that the branch runs over", 8},
       [](const BranchPoint &x) { return Cell(x.parameter); }}};
    for (const char *name : {"frequency_hz",
                             "dominant_line_hz",
                             "mean_normal_n",
                             "rms_normal_n",
                             "judged_force",
                             "rms_tangential_n",
                             "stability",
                             "largest_multiplier",
                             "largest_multiplier_error",
                             "trivial_multiplier_error"})
      columns.push_back(common<BranchPoint>(name));
    columns.push_back({{"largest_multiplier_angle_deg",
                        Type::real,
                        "deg",
                        "of the largest multiplier in the complex plane: 0 as "
                        "at a fold, 180 as at a period doubling",
                        4},
                       [](const BranchPoint &x) {
                         return Cell(
                           std::abs(std::arg(x.multipliers.outermost())) *
                           180. / M_PI);
                       }});
    columns.push_back(
      {{"is_fold",
        Type::integer,
        "",
        "1 where the parameter turns back and a multiplier passes 1"},
       [](const BranchPoint &x) { return Cell(x.is_fold ? 1 : 0); }});
    columns.push_back(
      {{"n_changes", Type::integer, "", "changes of status in a period"},
       [](const BranchPoint &x) { return Cell(x.n_changes); }});
    columns.push_back(
      {{"friction_turn_rad",
        Type::real,
        "rad",
        "largest angle that the friction of a slipping node "
        "turns by in a period",
        4},
       [](const BranchPoint &x) { return Cell(x.friction_turn); }});
    for (const char *name :
         {"n_opening", "n_sticking", "residual", "n_iterations"})
      columns.push_back(common<BranchPoint>(name));
    const std::vector<Column> of_pairs = of_each_pair<BranchPoint>(
      pairs, [](const BranchPoint &x) { return &x.figures; });
    columns.insert(columns.end(), of_pairs.begin(), of_pairs.end());
    return table_of(columns, branch.points);
  }



  std::string
  branch_sentence(const CycleBranch &branch, const std::string &parameter)
  {
    const auto [low, high] = std::minmax_element(
      branch.points.begin(),
      branch.points.end(),
      [](const auto &a, const auto &b) { return a.parameter < b.parameter; });
    const auto count = [&](const std::string &kind) {
      return std::to_string(std::count_if(
        branch.points.begin(), branch.points.end(), [&](const auto &x) {
          return x.multipliers.stability() == kind;
        }));
    };
    const auto folds = std::count_if(branch.points.begin(),
                                     branch.points.end(),
                                     [](const auto &x) { return x.is_fold; }),
               turns = std::count_if(
                 branch.points.begin(), branch.points.end(), [](const auto &x) {
                   return x.turns_back && !x.is_fold;
                 });
    const auto span = [&](const auto &value) {
      const auto [least, most] = std::minmax_element(
        branch.points.begin(),
        branch.points.end(),
        [&](const auto &a, const auto &b) { return value(a) < value(b); });
      return rounded_text(value(*least), 4) + " to " +
             rounded_text(value(*most), 4);
    };
    return "limit cycles from " + parameter + " = " +
           rounded_text(low->parameter, 5) + " to " +
           rounded_text(high->parameter, 5) + ": " +
           span([](const BranchPoint &x) { return x.figures.rms_normal; }) +
           " N rms of the " + force_along(branch) + " at " +
           span([](const BranchPoint &x) { return x.figures.frequency; }) +
           " Hz; " + std::to_string(branch.points.size()) + " points, " +
           count("stable") + " stable, " + count("unstable") + " unstable, " +
           std::to_string(folds) + " folds" +
           (turns > 0 ? ", and " + std::to_string(turns) +
                          " turns at which no multiplier passes 1"
                      : "") +
           "; ends: " + branch_end_text(branch.first_end) + ", " +
           branch_end_text(branch.last_end);
  }



  std::string
  text_of_hidden_folds(const CycleBranch &branch, const std::string &parameter)
  {
    std::vector<std::string> places;
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i)
      if (branch.points[i].hides_folds)
        places.push_back(rounded_text(branch.points[i].parameter, 7) + " to " +
                         rounded_text(branch.points[i + 1].parameter, 7));
    return places.empty()
             ? ""
             : "a multiplier passes 1 from " + parameter + " = " +
                 prm::join(places, ", ") +
                 ", where the branch goes on the same way: it may turn back "
                 "and "
                 "forth between these points, with two stable cycles beside "
                 "each other";
  }



  void
  draw_branch(RunContext                &context,
              const CycleBranch         &branch,
              const SweepAxisParameters &axis,
              HtmlReport                &report)
  {
    AxisSettings parameter;
    parameter.label = axis_title(axis.entries, context.parameters.scene);
    if (axis.scale == SweepAxisParameters::Scale::logarithmic)
      parameter.scale = AxisSettings::Scale::logarithmic;
    Chart amplitude =
            branch_chart(branch,
                         parameter,
                         "rms of the " + force_along(branch) + ", N",
                         [](const auto &x) { return x.figures.rms_normal; }),
          frequency =
            branch_chart(branch,
                         parameter,
                         "frequency, Hz",
                         [](const auto &x) { return x.figures.frequency; }),
          multiplier = branch_chart(
            branch, parameter, "largest multiplier", [](const auto &x) {
              return x.multipliers.largest;
            });
    // Near a grazing contact one point may have hundreds.
    if (std::any_of(
          branch.points.begin(), branch.points.end(), [](const BranchPoint &x) {
            return x.multipliers.largest > wide_range;
          }))
      multiplier.y.scale = AxisSettings::Scale::logarithmic;
    amplitude.title  = "Limit cycles along the branch";
    frequency.legend = multiplier.legend = Chart::Legend::none;
    ReferenceLine one;
    one.value        = 1.;
    multiplier.lines = {one};
    context.output.file("plots/branch.png");
    const std::string path = context.output.path() + "/plots/branch";
    context.plotter.draw(
      draw_charts({amplitude, frequency, multiplier}, 1400, 1500), path);
    report.figure(path + ".png",
                  "Amplitude, frequency and the largest Floquet multiplier "
                  "along the branch");
  }
} // namespace squeal
