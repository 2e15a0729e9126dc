// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/branch_output.h>
#include <squeal/analyses/limit_cycle/cycle_columns.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/text.h>
#include <squeal/results/chart.h>
#include <squeal/results/html_report.h>
#include <squeal/results/marked_series.h>
#include <squeal/run/run_context.h>

#include <algorithm>
#include <functional>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** Multipliers beyond this are drawn on a logarithmic axis. */
    constexpr double  wide_range = 10.;
    const std::string no_growth  = "no pair grows";

    /** All points, branch after branch. */
    std::vector<const BranchPoint *>
    all_points(const BranchDiagram &diagram)
    {
      std::vector<const BranchPoint *> result;
      for (const CycleBranch &branch : diagram.branches)
        for (const BranchPoint &point : branch.points)
          result.push_back(&point);
      return result;
    }

    /** Whose rms the points state. */
    std::string
    force_along(const std::vector<const BranchPoint *> &points)
    {
      const bool has_moments =
        std::any_of(points.begin(), points.end(), [](const BranchPoint *x) {
          return !x->figures.judged_force.empty();
        });
      return has_moments ? "normal force or of the moment that is judged"
                         : "normal force";
    }

    /** "0.4431 to 0.4517" of a number of the points. */
    std::string
    span_text(const std::vector<const BranchPoint *>           &points,
              const std::function<double(const BranchPoint &)> &value,
              const unsigned int                                digits)
    {
      const auto [least, most] = std::minmax_element(
        points.begin(), points.end(), [&](const auto *a, const auto *b) {
          return value(*a) < value(*b);
        });
      return rounded_text(value(**least), digits) + " to " +
             rounded_text(value(**most), digits);
    }

    /** "mu = 0.44 to 0.45: 4.9 to 16 N rms of ..., 2 folds" */
    std::string
    points_text(const std::vector<const BranchPoint *> &points,
                const std::string                      &parameter)
    {
      const auto count = [&](const auto &is) {
        return std::to_string(std::count_if(
          points.begin(), points.end(), [&](const auto *x) { return is(*x); }));
      };
      const auto stable = [&](const std::string &kind) {
        return count([&](const BranchPoint &x) {
          return x.multipliers.stability() == kind;
        });
      };
      const std::string turns =
        count([](const BranchPoint &x) { return x.turns_back && !x.is_fold; });
      return parameter + " = " +
             span_text(
               points, [](const BranchPoint &x) { return x.parameter; }, 5) +
             ": " +
             span_text(
               points,
               [](const BranchPoint &x) { return x.figures.rms_normal; },
               4) +
             " N rms of the " + force_along(points) + " at " +
             span_text(
               points,
               [](const BranchPoint &x) { return x.figures.frequency; },
               4) +
             " Hz; " + std::to_string(points.size()) + " points, " +
             stable("stable") + " stable, " + stable("unstable") +
             " unstable, " +
             count([](const BranchPoint &x) { return x.is_fold; }) + " folds" +
             (turns != "0"
                ? ", and " + turns + " turns at which no multiplier passes 1"
                : "");
    }

    /** The points of each stability over the parameter, and a line through all
     * of each branch. */
    Chart
    branch_chart(const BranchDiagram                              &diagram,
                 const AxisSettings                               &parameter,
                 const std::string                                &what,
                 const std::function<double(const BranchPoint &)> &value)
    {
      Chart chart;
      chart.x       = parameter;
      chart.y.label = what;
      for (const CycleBranch &branch : diagram.branches)
        {
          ChartSeries line;
          line.style = ChartSeries::Style::lines;
          line.ink   = Ink::grey;
          for (const BranchPoint &x : branch.points)
            {
              line.x.push_back(x.parameter);
              line.y.push_back(value(x));
            }
          chart.series.push_back(line);
        }
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
          for (const BranchPoint *x : all_points(diagram))
            if (x->multipliers.stability() == kind)
              {
                points.x.push_back(x->parameter);
                points.y.push_back(value(*x));
              }
          if (!points.x.empty())
            chart.series.push_back(points);
        }
      return chart;
    }

    /** What searches without a cycle have come to: nothing that grows, or a
     * motion of that size. */
    void
    add_searches(Chart                                           &chart,
                 const std::vector<AxisSearch>                   &searches,
                 const std::function<double(const AxisSearch &)> &value)
    {
      const auto add = [&](const std::string        &label,
                           const ChartSeries::Marker marker,
                           const auto               &counts) {
        ChartSeries points =
          marked_series(label, marker, 1.2, Ink::grey, label != no_growth);
        for (const AxisSearch &x : searches)
          if (counts(x))
            {
              points.x.push_back(x.parameter);
              points.y.push_back(value(x));
            }
        if (!points.x.empty())
          chart.series.push_back(points);
      };
      add(no_growth, ChartSeries::Marker::square, [](const AxisSearch &x) {
        return x.slides && x.n_growing == 0;
      });
      add(
        "motion without a cycle found",
        ChartSeries::Marker::triangle,
        [](const AxisSearch &x) { return x.branch == 0 && x.rms_normal > 0.; });
    }
  } // namespace



  Table
  branch_table(const BranchDiagram            &diagram,
               const std::vector<std::string> &pairs)
  {
    using Column               = ColumnOf<BranchPoint>;
    unsigned int        number = 0; // of the branch at hand
    std::vector<Column> columns{
      {{"branch", Type::integer, "", "number of the branch"},
       [&number](const BranchPoint &) { return Cell(number); }},
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
    Table table = table_of(columns, {});
    for (const CycleBranch &branch : diagram.branches)
      {
        ++number;
        table.append(table_of(columns, branch.points));
      }
    return table;
  }



  std::string
  branch_sentence(const CycleBranch &branch, const std::string &parameter)
  {
    std::vector<const BranchPoint *> points;
    for (const BranchPoint &point : branch.points)
      points.push_back(&point);
    return "limit cycles from " + points_text(points, parameter) +
           "; ends: " + branch_end_text(branch.first_end) + ", " +
           branch_end_text(branch.last_end);
  }

  std::string
  diagram_sentence(const BranchDiagram &diagram, const std::string &parameter)
  {
    const std::string beside = searches_sentence(diagram.searches);
    const std::string more   = beside.empty() ? "" : "; " + beside;
    if (diagram.branches.empty())
      return "no limit cycle found" + more;
    if (diagram.branches.size() == 1)
      return branch_sentence(diagram.branches.front(), parameter) + more;
    return std::to_string(diagram.branches.size()) +
           " branches of limit cycles from " +
           points_text(all_points(diagram), parameter) + more;
  }



  std::string
  text_of_hidden_folds(const BranchDiagram &diagram,
                       const std::string   &parameter)
  {
    std::vector<std::string> places;
    for (const CycleBranch &branch : diagram.branches)
      for (std::size_t i = 0; i + 1 < branch.points.size(); ++i)
        if (branch.points[i].hides_folds)
          places.push_back(rounded_text(branch.points[i].parameter, 7) +
                           " to " +
                           rounded_text(branch.points[i + 1].parameter, 7));
    return places.empty()
             ? ""
             : "a multiplier passes 1 from " + parameter + " = " +
                 prm::join(places, ", ") +
                 ", where the branch goes on the same way: it may turn back "
                 "and forth between these points, with two stable cycles "
                 "beside each other";
  }



  void
  draw_branches(RunContext                &context,
                const BranchDiagram       &diagram,
                const SweepAxisParameters &axis,
                HtmlReport                &report)
  {
    AxisSettings parameter;
    parameter.label = axis_title(axis.entries, context.parameters.scene);
    if (axis.scale == SweepAxisParameters::Scale::logarithmic)
      parameter.scale = AxisSettings::Scale::logarithmic;
    if (!diagram.searches.empty())
      {
        // All panels have the axis of the searches.
        parameter.lower = axis.from.front();
        parameter.upper = axis.to.front();
      }
    const std::vector<const BranchPoint *> points = all_points(diagram);
    Chart                                  amplitude =
            branch_chart(diagram,
                         parameter,
                         "rms of the " + force_along(points) + ", N",
                         [](const auto &x) { return x.figures.rms_normal; }),
          frequency =
            branch_chart(diagram,
                         parameter,
                         "frequency, Hz",
                         [](const auto &x) { return x.figures.frequency; }),
          multiplier = branch_chart(
            diagram, parameter, "largest multiplier", [](const auto &x) {
              return x.multipliers.largest;
            });
    add_searches(amplitude, diagram.searches, [](const AxisSearch &x) {
      return x.rms_normal;
    });
    // Near a grazing contact one point may have hundreds.
    if (std::any_of(points.begin(), points.end(), [](const BranchPoint *x) {
          return x->multipliers.largest > wide_range;
        }))
      multiplier.y.scale = AxisSettings::Scale::logarithmic;
    amplitude.title  = "Limit cycles along the axis";
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
                  "along the axis");
  }
} // namespace squeal
