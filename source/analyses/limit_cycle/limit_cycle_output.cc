// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/limit_cycle_output.h>
#include <squeal/output/force_charts.h>
#include <squeal/results/html_report.h>
#include <squeal/run/run_context.h>

#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    constexpr double not_known = std::numeric_limits<double>::quiet_NaN();
    /** Multipliers below this size are gone after a period. */
    constexpr double smallest_multiplier = 1e-3;

    std::vector<Table::Column>
    cycle_columns()
    {
      return {
        {"pair_frequency_hz", Type::real, "Hz", "of the growing pair"},
        {"pair_sigma_per_s", Type::real, "1/s", "its growth rate"},
        {"cycle_status", Type::text, "", "what the search has ended with"},
        {"stability", Type::text, "", "by the Floquet multipliers"},
        {"frequency_hz", Type::real, "Hz", "1/period", 8},
        {"frequency_error_hz",
         Type::real,
         "Hz",
         "difference to half the steps",
         3},
        {"dominant_line_hz",
         Type::real,
         "Hz",
         "largest harmonic of the normal force"},
        {"mean_normal_n", Type::real, "N", "mean normal force"},
        {"rms_normal_n", Type::real, "N", "of the normal force about its mean"},
        {"rms_normal_error_n",
         Type::real,
         "N",
         "difference to half the steps",
         3},
        {"min_normal_n", Type::real, "N", "least normal force"},
        {"max_normal_n", Type::real, "N", "largest normal force"},
        {"rms_tangential_n",
         Type::real,
         "N",
         "of the tangential force about its mean"},
        {"n_opening", Type::integer, "", "nodes that open in a period"},
        {"n_sticking", Type::integer, "", "nodes that stick in a period"},
        {"largest_multiplier",
         Type::real,
         "",
         "in size, of those beside the trivial one"},
        {"largest_multiplier_error",
         Type::real,
         "",
         "the larger of its difference to half the steps and of what the "
         "trivial "
         "one is off",
         3},
        {"trivial_multiplier_error",
         Type::real,
         "",
         "what the multiplier of the motion itself is off 1",
         3},
        {"residual",
         Type::real,
         "",
         "what the state misses after a period, over the motion",
         3},
        {"n_iterations", Type::integer, "", "of Newton's method, both steps"},
        {"n_steps", Type::integer, "", "of a period"},
        {"penetration_m",
         Type::real,
         "m",
         "largest depth in the middle of a step",
         3},
        {"gap_range_m", Type::real, "m", "largest change of a gap", 3},
        {"share_beyond_harmonics",
         Type::real,
         "",
         "rms of the normal force beyond the harmonics written, over its rms",
         3},
        {"damping_work_j", Type::real, "J", "lost in damping a period"},
        {"friction_work_j", Type::real, "J", "lost in slip a period"},
        {"driving_work_j", Type::real, "J", "given by the targets a period"},
        {"imbalance", Type::real, "", "of energy over the work of a period", 3},
        {"first_change_sqrt_j",
         Type::real,
         "sqrt(J)",
         "amplitude of the pair at which the first node opens or sticks"},
        {"recurrence",
         Type::real,
         "",
         "distance to the motion a period before at the end of the run, over "
         "the mean one",
         3}};
    }

    /** Of the search that has gone furthest; NaN where none has begun. */
    double
    last_residual(const CycleResult &c)
    {
      return !c.motion.history.empty()   ? c.motion.residual
             : !c.coarse.history.empty() ? c.coarse.residual
                                         : not_known;
    }

    std::string
    rounded(const double value, const double error)
    {
      const double shown  = std::max(error, 1e-12 * std::abs(value));
      const int    digits = std::max(
        3,
        1 + static_cast<int>(std::ceil(std::log10(std::abs(value) / shown))));
      return rounded_text(value, std::min(digits, 8));
    }
  } // namespace



  Table
  cycle_table(const std::vector<CycleResult> &cycles,
              const unsigned int              n_harmonics)
  {
    Table table(cycle_columns());
    for (const CycleResult &c : cycles)
      {
        const bool          found = c.has_converged();
        const CycleFigures &f     = c.figures;
        const auto          value = [&](const double x) {
          return or_missing(found ? x : not_known);
        };
        const EnergyLedger &e = c.motion.orbit.ledger;
        table.add_row(
          {c.pair.imag() / (2. * M_PI),
           c.pair.real(),
           c.status(),
           found ? Cell(c.stability()) : Cell(),
           value(f.frequency),
           value(std::abs(f.frequency - c.coarse_figures.frequency)),
           value(f.largest_harmonic * f.frequency),
           value(f.mean_normal),
           value(f.rms_normal),
           value(std::abs(f.rms_normal - c.coarse_figures.rms_normal)),
           value(f.min_normal),
           value(f.max_normal),
           value(f.rms_tangential),
           found ? Cell(f.n_opening) : Cell(),
           found ? Cell(f.n_sticking) : Cell(),
           value(c.multipliers.largest),
           value(found ? c.multipliers.uncertainty() : not_known),
           value(std::abs(c.multipliers.trivial - 1.)),
           or_missing(last_residual(c)),
           c.coarse.iterations + c.motion.iterations,
           c.motion.orbit.n_steps(),
           value(f.penetration),
           value(f.gap_range),
           value(found ? f.beyond(n_harmonics) : not_known),
           value(e.damping),
           value(e.friction),
           value(e.driving),
           value(found ? e.imbalance() : not_known),
           c.first_change,
           c.recurrence});
      }
    return table;
  }



  Table
  period_table(const CycleResult &cycle)
  {
    Table table({{"time_s", Type::real, "s", "from the start of the period"},
                 {"normal_n", Type::real, "N", "normal force"},
                 {"tangential_n", Type::real, "N", "along the sliding"},
                 {"radial_n", Type::real, "N", "across the sliding"},
                 {"n_open", Type::integer, "", "open nodes"},
                 {"n_stick", Type::integer, "", "sticking nodes"},
                 {"kinetic_j", Type::real, "J", "kinetic energy"}});
    const Orbit &orbit = cycle.motion.orbit;
    for (unsigned int i = 0; i < orbit.n_steps(); ++i)
      {
        unsigned int n_open = 0, n_stick = 0;
        for (const ContactStatus s : orbit.status[i])
          {
            n_open += s == ContactStatus::open;
            n_stick += s == ContactStatus::stick;
          }
        const auto f = cycle.figures.resultants.col(i);
        table.add_row({(i + 1) * orbit.step,
                       f[0],
                       f[1],
                       f[2],
                       n_open,
                       n_stick,
                       .5 * orbit.states[i + 1].velocities.squaredNorm()});
      }
    return table;
  }



  Table
  harmonic_table(const CycleResult &cycle, const unsigned int n_harmonics)
  {
    Table table({{"harmonic", Type::integer, "", "multiple of the frequency"},
                 {"frequency_hz", Type::real, "Hz", "its frequency"},
                 {"normal_n", Type::real, "N", "amplitude, normal force"},
                 {"tangential_n", Type::real, "N", "amplitude, along"}});
    const CycleFigures &f = cycle.figures;
    for (std::size_t k = 0;
         k < std::min<std::size_t>(n_harmonics, f.normal_harmonics.size());
         ++k)
      table.add_row({k + 1,
                     (k + 1) * f.frequency,
                     f.normal_harmonics[k],
                     f.tangential_harmonics[k]});
    return table;
  }



  Table
  multiplier_table(const CycleResult &cycle)
  {
    Table table({{"multiplier_real", Type::real, "", "real part"},
                 {"multiplier_imag", Type::real, "", "imaginary part"},
                 {"multiplier_size", Type::real, "", "size"},
                 {"sigma_per_s", Type::real, "1/s", "rate of the size"}});
    for (const std::complex<double> m : cycle.multipliers.values)
      if (std::abs(m) >= smallest_multiplier)
        table.add_row({m.real(),
                       m.imag(),
                       std::abs(m),
                       std::log(std::abs(m)) / cycle.motion.period});
    return table;
  }



  std::string
  cycle_sentence(const CycleResult &c)
  {
    if (!c.has_converged())
      return "from the pair at " +
             rounded_text(c.pair.imag() / (2. * M_PI), 6) +
             " Hz: " + c.status() +
             (c.status() == "not converged"
                ? ", which says nothing about whether there is a limit cycle"
                : "");
    const CycleFigures &f = c.figures, &g = c.coarse_figures;
    const double        df = std::abs(f.frequency - g.frequency),
                 dr        = std::abs(f.rms_normal - g.rms_normal);
    const std::string kind =
      c.stability() == "at its limit"
        ? "a limit cycle whose stability the multipliers leave open at "
        : (c.stability() == "stable" ? "a stable" : "an unstable") +
            std::string(" limit cycle at ");
    return kind + rounded(f.frequency, df) + " +- " + rounded_text(df, 2) +
           " Hz, rms of the normal force " + rounded(f.rms_normal, dr) +
           " +- " + rounded_text(dr, 2) +
           " N (errors by half the steps; mesh and cut-off not estimated)";
  }



  void
  draw_cycle(RunContext &context, const CycleResult &c, HtmlReport &report)
  {
    const CycleFigures &f     = c.figures;
    const unsigned int  n     = c.motion.orbit.n_steps();
    const auto          steps = [&](const unsigned int number) {
      ForceCurve curve;
      for (unsigned int i = 0; i <= number; ++i)
        curve.add(i * c.motion.orbit.step,
                  f.resultants(0, (i + n - 1) % n),
                  f.resultants(1, (i + n - 1) % n));
      return curve;
    };
    const auto draw = [&](const std::string        &name,
                          const std::vector<Chart> &charts,
                          const std::string        &caption) {
      context.output.file("plots/" + name + ".png");
      const std::string path = context.output.path() + "/plots/" + name;
      context.plotter.draw(draw_charts(charts, 1400, 1200), path);
      report.figure(path + ".png", caption, true);
    };
    report.section("One period");
    draw("period",
         {forces_over_time(steps(n), "One period")},
         "Resultants, every step");
    // The rate at the ends of the period needs the steps around them.
    draw("limit_cycle", portraits(steps(n + 2)), "Every step of the period");
  }
} // namespace squeal
