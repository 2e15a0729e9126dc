// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/limit_cycle/cycle_columns.h>
#include <squeal/analyses/limit_cycle/limit_cycle_output.h>
#include <squeal/output/force_charts.h>
#include <squeal/output/judged_force.h>
#include <squeal/results/html_report.h>
#include <squeal/run/run_context.h>

#include <cmath>
#include <tuple>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** Multipliers below this size are gone after a period. */
    constexpr double smallest_multiplier = 1e-3;

    using CycleColumn = ColumnOf<CycleResult>;

    /** Of a cycle that has been found; else nothing. */
    CycleColumn
    found(const Table::Column                              &declaration,
          const std::function<double(const CycleResult &)> &value)
    {
      return {declaration, [value](const CycleResult &c) {
                return c.has_converged() ? Cell(value(c)) : Cell();
              }};
    }

    std::vector<CycleColumn>
    pair_columns()
    {
      return {
        {{"pair_frequency_hz", Type::real, "Hz", "of the growing pair"},
         [](const CycleResult &c) {
           return Cell(c.pair.imag() / (2. * M_PI));
         }},
        {{"pair_sigma_per_s", Type::real, "1/s", "its growth rate"},
         [](const CycleResult &c) { return Cell(c.pair.real()); }},
        {{"cycle_status", Type::text, "", "what the search has ended with"},
         [](const CycleResult &c) { return Cell(c.status()); }}};
    }

    /** Of a number of the normal force. */
    CycleColumn
    force_error(const char *name, double ForceFigures::*number)
    {
      return found(
        {name, Type::real, "N", "twice the difference to half the steps", 3},
        [number](const CycleResult &c) { return c.force_error(number); });
    }

    std::vector<CycleColumn>
    force_columns()
    {
      return {common<CycleResult>("stability"),
              common<CycleResult>("frequency_hz"),
              found({"frequency_error_hz",
                     Type::real,
                     "Hz",
                     "twice the difference to half the steps",
                     3},
                    [](const CycleResult &c) { return c.frequency_error(); }),
              common<CycleResult>("dominant_line_hz"),
              common<CycleResult>("mean_normal_n"),
              force_error("mean_normal_error_n", &ForceFigures::mean_normal),
              common<CycleResult>("rms_normal_n"),
              found({"rms_normal_error_n",
                     Type::real,
                     "N",
                     "twice the difference of the harmonics to half the steps",
                     3},
                    [](const CycleResult &c) { return c.rms_normal_error(); }),
              common<CycleResult>("judged_force"),
              found({"min_normal_n", Type::real, "N", "least normal force"},
                    [](const CycleResult &c) { return c.figures.min_normal; }),
              force_error("min_normal_error_n", &ForceFigures::min_normal),
              found({"max_normal_n", Type::real, "N", "largest normal force"},
                    [](const CycleResult &c) { return c.figures.max_normal; }),
              force_error("max_normal_error_n", &ForceFigures::max_normal)};
    }

    std::vector<CycleColumn>
    step_columns(const unsigned int n_harmonics)
    {
      return {
        {{"n_steps", Type::integer, "", "of a period"},
         [](const CycleResult &c) { return Cell(c.motion.orbit.n_steps()); }},
        found({"penetration_m",
               Type::real,
               "m",
               "largest depth in the middle of a step",
               3},
              [](const CycleResult &c) { return c.figures.penetration; }),
        found({"gap_range_m", Type::real, "m", "largest change of a gap", 3},
              [](const CycleResult &c) { return c.figures.gap_range; }),
        found({"share_beyond_harmonics",
               Type::real,
               "",
               "rms of the normal force beyond the harmonics written, over its "
               "rms",
               3},
              [n_harmonics](const CycleResult &c) {
                return c.figures.beyond(n_harmonics);
              })};
    }

    std::vector<CycleColumn>
    energy_columns()
    {
      const auto energy = [](double EnergyLedger::*work) {
        return
          [work](const CycleResult &c) { return c.motion.orbit.ledger.*work; };
      };
      return {
        found({"damping_work_j", Type::real, "J", "lost in damping a period"},
              energy(&EnergyLedger::damping)),
        found({"friction_work_j", Type::real, "J", "lost in slip a period"},
              energy(&EnergyLedger::friction)),
        found(
          {"driving_work_j", Type::real, "J", "given by the targets a period"},
          energy(&EnergyLedger::driving)),
        found(
          {"imbalance",
           Type::real,
           "",
           "of energy over the work of a period and the energy at its start",
           3},
          [](const CycleResult &c) {
            return c.motion.orbit.ledger.imbalance();
          }),
        {{"first_change_sqrt_j",
          Type::real,
          "sqrt(J)",
          "amplitude of the pair at which the first node opens or sticks"},
         [](const CycleResult &c) { return Cell(c.first_change); }},
        {{"recurrence",
          Type::real,
          "",
          "distance to the motion a period before at the end of the run, over "
          "the mean one",
          3},
         [](const CycleResult &c) { return Cell(c.recurrence); }}};
    }

    /** Of the run before; nothing without one. */
    CycleColumn
    of_run(const Table::Column &declaration, double RunFigures::*number)
    {
      return {declaration, [number](const CycleResult &c) {
                return c.run.time > 0. ? Cell(c.run.*number) : Cell();
              }};
    }

    std::vector<CycleColumn>
    run_columns()
    {
      return {
        of_run({"run_time_s", Type::real, "s", "of the run before the search"},
               &RunFigures::time),
        of_run({"run_line_hz",
                Type::real,
                "Hz",
                "largest line of the normal force at its end"},
               &RunFigures::line),
        of_run({"run_rms_normal_n",
                Type::real,
                "N",
                "of the normal force in its last part"},
               &RunFigures::rms_normal),
        {judged_force_column("run_judged_force"),
         [](const CycleResult &c) {
           return judged_force_cell(c.run.judged_force);
         }},
        of_run({"run_repetition",
                Type::real,
                "",
                "of the normal force in its last three parts",
                3},
               &RunFigures::repetition),
        of_run({"run_recurrence",
                Type::real,
                "",
                "its nearest return over the mean distance",
                3},
               &RunFigures::recurrence)};
    }

    /** What does not follow from a search in which nothing was found, and what
     * would tell. */
    std::string
    caveat_of(const CycleResult &c)
    {
      const std::string tells_nothing =
        ", which says nothing about whether there is a limit cycle";
      if (c.may_settle())
        return tells_nothing + "; the motion may still be settling: raise " +
               (c.settling_time > c.run.time
                  ? "'Limit cycle/Run time' to " +
                      rounded_text(c.settling_time, 2) + " s"
                  : "'Limit cycle/Run time' and 'Steps per period'");
      if (c.status() == "aperiodic")
        return ", by a motion of " + rounded_text(c.run.time, 2) +
               " s: other motions may have a limit cycle";
      return c.status() == "not converged" ? tells_nothing : "";
    }

    /** What unstable cycles are left by. */
    std::string
    way_of_leaving(const FloquetMultipliers &multipliers)
    {
      const std::complex<double> m = multipliers.outermost();
      if (m.imag() != 0.)
        return "disturbances grow with a second frequency: a pair of "
               "multipliers "
               "of size " +
               rounded_text(std::abs(m), 4) + " at +-" +
               rounded_text(std::abs(std::arg(m)) * 180. / M_PI, 3) +
               " degrees (torus)";
      const std::string number = "a multiplier of " + rounded_text(m.real(), 4);
      return m.real() < 0.
               ? "disturbances change their sign every period: " + number +
                   " (period doubling); a longer 'Limit cycle/Run time' may "
                   "lead "
                   "to a cycle of twice the period"
               : "disturbances grow to one side: " + number +
                   ", as beyond a fold";
    }
  } // namespace



  Table
  cycle_table(const std::vector<CycleResult> &cycles,
              const unsigned int              n_harmonics,
              const std::vector<std::string> &pairs)
  {
    std::vector<CycleColumn> columns = pair_columns();
    const auto               add = [&](const std::vector<CycleColumn> &more) {
      columns.insert(columns.end(), more.begin(), more.end());
    };
    add(force_columns());
    for (const char *name : {"rms_tangential_n",
                             "n_opening",
                             "n_sticking",
                             "largest_multiplier",
                             "largest_multiplier_error",
                             "trivial_multiplier_error",
                             "residual",
                             "n_iterations"})
      columns.push_back(common<CycleResult>(name));
    add(step_columns(n_harmonics));
    add(energy_columns());
    add(run_columns());
    add(of_each_pair<CycleResult>(pairs, [](const CycleResult &c) {
      return c.has_converged() ? &c.figures : nullptr;
    }));
    return table_of(columns, cycles);
  }



  Table
  period_table(const CycleResult &cycle, const std::vector<std::string> &pairs)
  {
    const CycleFigures &figures = cycle.figures;
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
        Eigen::Vector3d f = Eigen::Vector3d::Zero();
        if (figures.pairs.empty())
          f = figures.resultants.col(i).head<3>();
        for (const ForceFigures &pair : figures.pairs)
          f += pair.resultants.col(i).head<3>();
        table.add_row({(i + 1) * orbit.step,
                       f[0],
                       f[1],
                       f[2],
                       n_open,
                       n_stick,
                       .5 * orbit.states[i + 1].velocities.squaredNorm()});
      }
    for (std::size_t p = 0; p < pairs.size(); ++p)
      for (const auto &[name, text, row] :
           {std::make_tuple("normal_n", "normal force", 0),
            std::make_tuple("tangential_n", "along the sliding", 1),
            std::make_tuple("radial_n", "across the sliding", 2)})
        {
          const std::string column = pairs[p] + "_" + name;
          table.add_column({column, Type::real, "N", text});
          for (unsigned int i = 0; i < orbit.n_steps(); ++i)
            table.set(i, column, figures.pairs[p].resultants(row, i));
        }
    return table;
  }



  Table
  harmonic_table(const CycleResult              &cycle,
                 const unsigned int              n_harmonics,
                 const std::vector<std::string> &pairs)
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
    using Harmonics = std::vector<double> ForceFigures::*;
    for (std::size_t p = 0; p < pairs.size(); ++p)
      for (const auto &[name, text, harmonics] :
           {std::make_tuple("normal_n",
                            "amplitude, normal force",
                            Harmonics(&ForceFigures::normal_harmonics)),
            std::make_tuple("tangential_n",
                            "amplitude, along",
                            Harmonics(&ForceFigures::tangential_harmonics))})
        {
          const std::string column = pairs[p] + "_" + name;
          table.add_column({column, Type::real, "N", text});
          for (std::size_t k = 0; k < table.n_rows(); ++k)
            table.set(k, column, (f.pairs[p].*harmonics)[k]);
        }
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
  cycle_sentence(const CycleResult &c, const std::vector<std::string> &pairs)
  {
    if (!c.has_converged())
      return "from the pair at " +
             rounded_text(c.pair.imag() / (2. * M_PI), 6) +
             " Hz: " + c.status() + caveat_of(c);
    const CycleFigures &f = c.figures;
    const std::string   kind =
      c.multipliers.stability() == "at its limit"
          ? "a limit cycle whose stability the multipliers leave open at "
          : (c.multipliers.stability() == "stable" ? "a stable" : "an unstable") +
            std::string(" limit cycle at ");
    return kind + with_error(f.frequency, c.frequency_error()) +
           " Hz, rms of the " + judged_force_text(f, pairs) + " " +
           with_error(f.rms_normal, c.rms_normal_error()) +
           " N (errors of the time steps; mesh and cut-off not estimated)" +
           (c.multipliers.is_unstable() ? "; " + way_of_leaving(c.multipliers)
                                        : "");
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
         std::string(f.pairs.empty()
                       ? "Resultants, every step"
                       : "Resultants of the pair whose vibration is largest, "
                         "every step") +
           (f.judged_force.empty() ? "" : "; the motion cancels in them"));
    // Where a moment is judged the portrait of the sums is not of the motion.
    // The rate at the ends of the period needs the steps around them.
    if (f.judged_force.empty())
      draw("limit_cycle", portraits(steps(n + 2)), "Every step of the period");
  }
} // namespace squeal
