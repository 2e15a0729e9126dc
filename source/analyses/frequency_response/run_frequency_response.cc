// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/analyses.h>
#include <squeal/analyses/frequency_response/response_solution.h>
#include <squeal/base/worst_of.h>
#include <squeal/output/headlines.h>
#include <squeal/parameters/choices.h>
#include <squeal/results/chart.h>
#include <squeal/results/frequency_unit.h>
#include <squeal/results/universal_file.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>

namespace squeal
{
  namespace
  {
    /** Pictures of the first pairs of points only. */
    constexpr unsigned int most_pictures = 12;

    const Ink inks[] = {Ink::vermillion, Ink::blue, Ink::green, Ink::orange};

    /** Magnitude over phase, a line for each contact state. */
    Drawing
    response_drawing(const ResponseGrid               &grid,
                     const std::vector<StateResponse> &states,
                     const unsigned int                i,
                     const unsigned int                j,
                     const std::string                &title)
    {
      std::vector<Chart> charts(2);
      charts[0].title   = title;
      charts[0].y.label = grid.quantity + " in " + grid.unit;
      charts[0].y.scale = AxisSettings::Scale::logarithmic;
      charts[1].y.label = "phase in degrees";
      charts[1].y.lower = -180.;
      charts[1].y.upper = 180.;
      charts[1].legend  = Chart::Legend::none;
      const FrequencyUnit unit(grid.frequencies.back());
      for (auto &chart : charts)
        {
          chart.x.label = unit.label;
          if (!grid.is_even)
            chart.x.scale = AxisSettings::Scale::logarithmic;
        }
      for (std::size_t s = 0; s < states.size(); ++s)
        {
          ChartSeries magnitude, phase;
          magnitude.label = states[s].state;
          magnitude.ink = phase.ink = inks[s % 4];
          magnitude.style           = ChartSeries::Style::lines;
          // A line would jump across the panel where the phase wraps.
          phase.style       = ChartSeries::Style::points;
          phase.marker_size = 0.35;
          for (std::size_t k = 0; k < grid.frequencies.size(); ++k)
            {
              const std::complex<double> h = states[s].values[k](i, j);
              const double               x = unit.factor * grid.frequencies[k];
              if (std::abs(h) > 0.)
                {
                  magnitude.x.push_back(x);
                  magnitude.y.push_back(std::abs(h));
                }
              phase.x.push_back(x);
              phase.y.push_back(180. / M_PI * std::arg(h));
            }
          charts[0].series.push_back(magnitude);
          charts[1].series.push_back(phase);
        }
      return draw_charts(charts, 1400, 1200, 1);
    }

    void
    draw(RunContext                       &context,
         const ResponseGrid               &grid,
         const std::vector<StateResponse> &states,
         HtmlReport                       &report)
    {
      if (!context.is_root)
        return;
      const auto           &points = context.parameters.measurement.points;
      unsigned int          n      = 0;
      std::set<std::string> names;
      report.section("Responses");
      for (unsigned int j = 0; j < grid.excitations.size(); ++j)
        for (unsigned int i = 0; i < grid.responses.size(); ++i)
          {
            if (++n > most_pictures)
              continue;
            // Points "a" and "a_a" make "a_a_a" of two pairs.
            std::string name = points[grid.responses[i]].name + "_" +
                               points[grid.excitations[j]].name;
            if (!names.insert(name).second)
              name += "_" + std::to_string(n);
            context.output.file("plots/" + name + ".png");
            const std::string path = context.output.path() + "/plots/" + name;
            const std::string title =
              "Motion of " + points[grid.responses[i]].name + ", force at " +
              points[grid.excitations[j]].name;
            context.plotter.draw(response_drawing(grid, states, i, j, title),
                                 path);
            report.figure(path + ".png", title, true);
          }
      if (n > most_pictures)
        context.log.info("  pictures of the first " +
                         std::to_string(most_pictures) + " of " +
                         std::to_string(n) + " pairs of points");
    }

    std::vector<StateResponse>
    solve_states(RunContext                       &context,
                 const ResponseGrid               &grid,
                 const std::vector<MeasuredShape> &measured)
    {
      const Parameters          &p = context.parameters;
      std::vector<StateResponse> states;
      if (p.frequency_response.states.empty())
        states.push_back(solve_response(p, "scene", grid, measured, context));
      for (const auto state : p.frequency_response.states)
        {
          Parameters changed = p;
          for (auto &contact : changed.scene.contacts)
            contact.state = state;
          changed.check();
          states.push_back(solve_response(
            changed, choice_name(state), grid, measured, context));
        }
      return states;
    }

    /** What brings superposed responses nearer to direct ones: pairs whose
     * residues are off by their residuals are no better with more of them. */
    std::string
    advice(const Parameters &p)
    {
      constexpr double loose     = 1e-5;
      const double     tolerance = p.eigen.residual_tolerance;
      return (tolerance > loose ? "lower 'Eigenvalues/Residual tolerance' (" +
                                    rounded_text(tolerance, 2) + "), and then "
                                : "") +
             std::string("raise 'Frequency response/Margin'");
    }

    /** Warns of a response that is far smaller than others, for which their
     * differences to direct solutions say nothing. */
    void
    warn_of_weak_functions(RunContext          &context,
                           const StateResponse &state,
                           const ResponseGrid  &grid)
    {
      const auto &p     = context.parameters;
      const auto  worst = state.worst_function();
      if (worst.error <= p.frequency_response.check_tolerance)
        return;
      const auto &points = p.measurement.points;
      context.log.warning(
        "contact state " + state.state + ": the weak response of '" +
        points[grid.responses[worst.response]].name + "' to a force at '" +
        points[grid.excitations[worst.excitation]].name +
        "' differs from direct solutions by " + rounded_text(worst.error, 2) +
        " of its root mean square over the checked frequencies "
        "(difference_of_own_rel in direct_check.csv): " +
        advice(p));
    }

    /** Warns of peaks that have no bound and stay empty. */
    void
    warn_of_undamped_modes(RunContext          &context,
                           const StateResponse &state,
                           const ResponseGrid  &grid)
    {
      unsigned int n = 0;
      std::string  first;
      for (unsigned int k = 0; k < state.pairs.size(); ++k)
        if (const double f = state.pairs.frequency(k);
            state.is_undamped(k) && f >= grid.frequencies.front() &&
            f <= grid.frequencies.back() && ++n == 1)
          first = state.names[k].text + " at " + rounded_text(f, 5) + " Hz";
      if (n > 0)
        context.log.warning(
          "contact state " + state.state + ": " + std::to_string(n) +
          (n == 1 ? " mode of the band has" : " modes of the band have") +
          " no damping (" + (n == 1 ? "" : "the first: ") + first +
          "): peak and share in mode_participation.csv stay empty, and near "
          "these frequencies responses grow without bound: see "
          "'Scene/Damping/Model'");
    }

    void
    warn(RunContext                       &context,
         const ResponseGrid               &grid,
         const std::vector<StateResponse> &states)
    {
      const auto &p = context.parameters;
      for (const auto &state : states)
        {
          if (const std::string text = state.unstable(); !text.empty())
            context.log.warning("contact state " + state.state +
                                " is unstable (" + text +
                                "): its responses are those of the linear "
                                "problem, no steady vibration reaches them");
          if (!(state.worst_check() <= p.frequency_response.check_tolerance))
            context.log.warning(
              "contact state " + state.state +
              ": superposition and direct solution differ by " +
              rounded_text(state.worst_check(), 2) +
              " of the largest response: " +
              (state.has_loss_factors
                 ? "with loss factors ('Structural damping', modulus tables) "
                   "pairs have no conjugates, and no 'Margin' takes away what "
                   "their partners are off by; take 'Stiffness damping', or "
                   "direct_check.csv at more 'Checks'"
                 : advice(p)));
          else
            warn_of_weak_functions(context, state, grid);
          warn_of_undamped_modes(context, state, grid);
        }
      for (const auto &point : p.measurement.points)
        if (universal_direction(point.direction) == 0)
          context.log.warning("Measurement/Point " + point.name +
                              "/Direction is along no axis: UFF58 files call "
                              "it 0, a scalar");
    }
  } // namespace



  void
  run_frequency_response(RunContext &context)
  {
    const auto                      &p = context.parameters;
    const ResponseGrid               grid(p);
    const std::vector<MeasuredShape> measured =
      p.measurement.shapes_file.empty()
        ? std::vector<MeasuredShape>()
        : read_measured_shapes(p.measurement, context.log);
    const std::vector<StateResponse> states =
      solve_states(context, grid, measured);
    warn(context, grid, states);

    const Table participation = participation_table(p, grid, states);
    const Table checks        = response_check_table(p, grid, states);
    const Table assurance     = mac_table(measured, states);
    const Table by_point      = comac_table(p, states);
    {
      Timers::Section section(context.timers, "Write: tables");
      context.write_table("frequency_response.csv",
                          response_table(p, grid, states));
      context.write_table("mode_participation.csv", participation);
      context.write_table("direct_check.csv", checks);
      if (!measured.empty())
        {
          context.write_table("mac.csv", assurance);
          context.write_table("comac.csv", by_point);
        }
      if (context.is_root)
        {
          write_response_hdf5(
            context.output.file("frequency_response.h5"), p, grid, states);
          for (const auto &state : states)
            write_response_universal(
              context.output.file("frequency_response_" + state.state + ".uff"),
              p,
              grid,
              state);
        }
    }

    double       worst = 0., worst_of_own = 0., worst_value = 0.;
    std::size_t  n_checks   = 0;
    unsigned int n_modes    = 0;
    std::string  state_list = "";
    for (const auto &state : states)
      {
        worst        = worst_of(worst, state.worst_check());
        worst_of_own = worst_of(worst_of_own, state.worst_function().error);
        worst_value  = worst_of(worst_value, state.worst_value());
        n_checks += state.checks.size();
        n_modes = std::max(n_modes, state.pairs.size());
        state_list += (state_list.empty() ? "" : ", ") + state.state;
      }
    context.record.figures = {
      {"contact states", state_list},
      {"responses",
       std::to_string(grid.responses.size() * grid.excitations.size())},
      {"frequencies", std::to_string(grid.frequencies.size())},
      {"modes superposed", std::to_string(n_modes)},
      {"direct checks", std::to_string(n_checks)},
      {"worst difference to them",
       n_checks
         ? rounded_text(worst, 2) + " of the largest response, " +
             rounded_text(worst_of_own, 2) +
             " of the rms of a response over the checked frequencies, " +
             rounded_text(worst_value, 2) + " of a single value of a response"
         : "-"},
      {"unknowns", std::to_string(states.front().n_unknowns)}};

    HtmlReport report("Frequency responses of " + p.scene.name,
                      grid.quantity + " in " + grid.unit);
    report.set_verdict(
      worst_of(worst, worst_of_own) <= p.frequency_response.check_tolerance
        ? HtmlReport::Verdict::good
        : HtmlReport::Verdict::bad,
      resonance_headline(participation, grid.unit) + "; " +
        (n_checks ? "superposition within " +
                      rounded_text(worst_of(worst, worst_of_own), 2) +
                      " of direct solutions, over the largest response and "
                      "over the rms of each; mesh error not estimated"
                  : "not checked by direct solutions"),
      context.record.figures);
    if (p.output.plots)
      {
        Timers::Section section(context.timers, "Write: charts");
        draw(context, grid, states, report);
      }
    if (!measured.empty())
      {
        report.section("Measured shapes");
        report.table(assurance, "MAC of measured and computed shapes");
        report.table(by_point, "COMAC: agreement at every point");
      }
    report.section("Direct check");
    report.table(checks, "Superposition beside direct solutions");
    report.section("Modes");
    report.table(participation, "Participation of the modes");
    if (states.front().names.empty() || states.front().names[0].body != -1u)
      report.paragraph(explanation_of_names());
    context.finish(p.output.report ? &report : nullptr, "");
  }
} // namespace squeal
