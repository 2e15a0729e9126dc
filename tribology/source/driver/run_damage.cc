// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/text.h>
#include <squeal/tribology/driver/analyses.h>
#include <squeal/tribology/driver/damage_figures.h>
#include <squeal/tribology/driver/damage_study.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Of the face of two histories of one contact mesh; areas of mortar
     * elements change a little as the bodies deform. */
    constexpr double alike_areas = 0.1;

    /** Of the angle from which on two histories slide other ways. */
    constexpr double least_cosine = 0.5;



    void
    count(Context &context, DamageStudy &study, const std::string &name)
    {
      const TribologyParameters &p = context.parameters;
      Timers::Section            section(context.timers, "Count: " + name);
      Progress progress(context.log, name + " history", study.window.n);
      study.damage = count_history(
        study.reader,
        p.history,
        p.fatigue,
        p.surface,
        study.grid,
        [&progress](const std::size_t n) { progress.advance(n); });
      for (const std::string &note : study.damage.notes)
        context.log.warning(study.reader.path() + ": " + note);
    }



    double
    total_area(const ContactGrid &grid)
    {
      double area = 0.;
      for (std::size_t k = 0; k < grid.n_nodes(); ++k)
        area += grid.area(k);
      return area;
    }



    /** Two histories are compared node by node: of runs that slide other ways
     * the leading edge of one would be held against another edge of the
     * other. */
    void
    require_same_sliding_of_runs(const DamageStudy &a, const DamageStudy &b)
    {
      const std::array<double, 2> &s = a.grid.sliding(), &t = b.grid.sliding();
      if (std::hypot(s[0], s[1]) > 0. && std::hypot(t[0], t[1]) > 0. &&
          s[0] * t[0] + s[1] * t[1] < least_cosine)
        throw InputError(
          "'" + b.reader.path() + "' slides along (" + rounded_text(t[0], 2) +
          ", " + rounded_text(t[1], 2) + ") by 'nodes/sliding', '" +
          a.reader.path() + "' along (" + rounded_text(s[0], 2) + ", " +
          rounded_text(s[1], 2) +
          "): their leading edges differ; compare runs that slide the same "
          "way");
    }



    void
    require_same_nodes(const DamageStudy &a, const DamageStudy &b)
    {
      bool same = a.grid.n_nodes() == b.grid.n_nodes();
      for (std::size_t k = 0; same && k < a.grid.n_nodes(); ++k)
        same = std::hypot(a.grid.place(k)[0] - b.grid.place(k)[0],
                          a.grid.place(k)[1] - b.grid.place(k)[1]) <
               1e-3 * std::sqrt(a.grid.area(k));
      same = same && std::abs(total_area(b.grid) / total_area(a.grid) - 1.) <=
                       alike_areas;
      if (!same)
        throw InputError("'" + b.reader.path() +
                         "' has other contact nodes than '" + a.reader.path() +
                         "', or other areas of them: compare runs of the same "
                         "contact mesh");
      require_same_sliding_of_runs(a, b);
    }



    /** Which of two histories @p study is; of one that is compared with none
     * nobody knows whether it squeals: its own name, or nothing. */
    Cell
    name_of_run(const DamageStudy                      &study,
                const std::vector<const DamageStudy *> &studies)
    {
      if (studies.size() > 1)
        return &study == studies[0] ? "squealing" : "silent";
      const std::string &name = study.reader.layout().name;
      return name.empty() ? Cell() : Cell(name);
    }



    /** Totals over the face, one row for each history. */
    Table
    totals(const TribologyParameters              &p,
           const std::vector<const DamageStudy *> &studies)
    {
      Table table(
        {{"run", Table::Type::text, "", "history"},
         {"seconds", Table::Type::real, "s", "length", 5},
         {"mean_pressure_pa", Table::Type::real, "Pa", "over the face", 5},
         {"friction_power_w", Table::Type::real, "W", "over the face", 5},
         {"impacts_per_s", Table::Type::real, "1/s", "of all nodes", 5}});
      for (const double m : p.fatigue.exponents)
        {
          table.add_column({"mean_damage_" + slope_name(m) + "_per_s",
                            Table::Type::real,
                            "1/s",
                            "area mean of the damage",
                            5});
          table.add_column({"mean_damage_" + slope_name(m) + "_error_per_s",
                            Table::Type::real,
                            "1/s",
                            "its standard error by the scatter along the "
                            "history",
                            2});
        }
      for (const DamageStudy *study : studies)
        {
          double area = 0., pressure = 0., power = 0., impacts = 0.;
          std::vector<double> damage(p.fatigue.exponents.size(), 0.);
          for (std::size_t k = 0; k < study->grid.n_nodes(); ++k)
            {
              const HistoryDamage::Node &node = study->damage.nodes[k];
              const double               a    = study->grid.area(k);
              const double               t    = node.surface.duration;
              area += a;
              pressure += a * node.surface.mean_pressure();
              power += a * node.surface.friction_energy / t;
              impacts += node.surface.impacts / t;
              for (std::size_t c = 0; c < damage.size(); ++c)
                damage[c] += a * node.damage[c] / study->damage.period;
            }
          std::vector<Cell> row = {name_of_run(*study, studies),
                                   study->damage.duration,
                                   pressure / area,
                                   study->damage.has_slip_rate ? Cell(power)
                                                               : Cell(),
                                   impacts};
          for (std::size_t c = 0; c < damage.size(); ++c)
            {
              row.push_back(damage[c] / area);
              row.push_back(
                or_missing(study->damage.sampling_error[c] * damage[c] / area));
            }
          table.add_row(row);
        }
      return table;
    }



    void
    warn_of_what_is_missing(Context &context, const DamageStudy &study)
    {
      if (!study.grid.is_grid() && context.parameters.subsurface.compute)
        context.log.warning("the contact nodes stand on no rectangular grid: "
                            "stresses under the face take the nodal cells as "
                            "squares of their area");
      if (!study.grid.is_grid() &&
          context.parameters.subsurface.pad_thickness > 0.)
        context.log.warning("stresses under the face are those of a "
                            "half-space, in spite of 'Pad thickness'");
    }



    void
    warn_of_history(Context &context, const DamageStudy &study)
    {
      const HistoryLayout &layout = study.reader.layout();
      const std::string    doubt = doubt_of_length(layout, study.reader.path());
      if (!doubt.empty())
        context.log.warning(doubt);
      if (!layout.has_slip_rate)
        context.log.warning(
          study.reader.path() + ": the history has no slip rate: " +
          (layout.has_status ? "friction power and wear"
                             : "friction power, wear and stick-slip") +
          " are not known");
    }



    /** Entries that nothing of this history takes. */
    void
    warn_of_unused_entries(Context &context, const DamageStudy &study)
    {
      const HistoryLayout     &layout = study.reader.layout();
      const SurfaceParameters &set    = context.parameters.surface, otherwise;
      const auto               warn   = [&](const std::string &entry) {
        context.log.warning(study.reader.path() + ": 'Surface/" + entry +
                            "' is set but not used: " +
                            (layout.has_status
                                               ? "the status of the history tells contact, "
                                                 "stick and slip"
                                               : "the history has no slip rate"));
      };
      if (layout.has_status &&
          set.contact_pressure != otherwise.contact_pressure)
        warn("Contact pressure");
      if ((layout.has_status || !layout.has_slip_rate) &&
          set.stick_speed != otherwise.stick_speed)
        warn("Stick speed");
    }



    void
    evaluate_below_the_face(Context &context, DamageStudy &study)
    {
      const TribologyParameters &p = context.parameters;
      Timers::Section   section(context.timers, "Evaluate: subsurface");
      const std::string note = note_on_subsurface_window(
        study.reader, study.window, p.subsurface, p.history.chunk);
      if (!note.empty())
        context.log.warning(study.reader.path() + ": " + note);
      Progress progress(context.log, "subsurface", study.grid.n_nodes());
      study.subsurface = evaluate_subsurface(
        study.reader,
        study.window,
        p.subsurface,
        p.fatigue,
        study.grid,
        [&progress](const std::size_t n) { progress.advance(n); });
    }



    void
    write_maps(Context &context, const DamageStudy &study, const Table &table)
    {
      if (!study.subsurface.empty())
        context.write_table("subsurface" + study.suffix() + ".csv",
                            subsurface_table(context.parameters.subsurface,
                                             study.grid,
                                             study.subsurface));
      const std::string name = "damage" + study.suffix();
      write_damage_hdf5(context.output.file(name + ".h5"), table, study.damage);
      write_damage_vtu(context.output.file(name + ".vtu"), table, study.grid);
    }



    /** The pairs that are looked at; one without a name of a history that has
     * but one. */
    std::vector<std::string>
    pairs_asked_for(const HistoryParameters &history)
    {
      if (!history.pair.empty())
        return {history.pair};
      const auto pairs = HistoryReader::pairs_of(history.file);
      return pairs.empty() ? std::vector<std::string>{""} : pairs;
    }

    /** What is found on one pair. */
    struct PairDamage
    {
      std::unique_ptr<DamageStudy> study, silent; /**< the latter may be null */
      Table                        table, sums;
      RunRecord::Pairs             figures;
      std::string                  headline;
    };

    /** Computes it and writes its tables, maps and pictures. */
    PairDamage
    damage_of_pair(Context &context, const std::string &pair)
    {
      const TribologyParameters &p = context.parameters;
      PairDamage                 r;
      r.study = std::make_unique<DamageStudy>(p.history.file, pair, p.history);
      if (!p.history.silent_file.empty())
        {
          r.silent = std::make_unique<DamageStudy>(
            p.history.silent_file, pair, p.history);
          require_same_nodes(*r.study, *r.silent);
        }
      warn_of_what_is_missing(context, *r.study);
      for (const DamageStudy *study : {r.study.get(), r.silent.get()})
        if (study)
          {
            warn_of_history(context, *study);
            warn_of_unused_entries(context, *study);
          }
      const std::string of = pair.empty() ? pair : ", " + pair;
      count(context, *r.study, (r.silent ? "squealing" : "contact") + of);
      if (r.silent)
        count(context, *r.silent, "silent" + of);
      if (p.subsurface.compute)
        evaluate_below_the_face(context, *r.study);
      r.table = damage_table(p,
                             r.study->grid,
                             r.study->damage,
                             r.silent ? &r.silent->damage : nullptr,
                             r.study->subsurface);
      context.write_table("damage" + r.study->suffix() + ".csv", r.table);
      std::vector<const DamageStudy *> studies = {r.study.get()};
      if (r.silent)
        studies.push_back(r.silent.get());
      r.sums = totals(p, studies);
      write_maps(context, *r.study, r.table);
      if (p.output.plots && context.plotter.is_available())
        draw_damage_pictures(context, *r.study, r.table, r.silent != nullptr);
      r.figures  = damage_figures(*r.study, r.table, p.fatigue.exponents);
      r.headline = damage_headline(*r.study, r.table, r.sums, p.fatigue);
      if (r.silent)
        r.headline += "; the face takes " +
                      ratios_to_silent(r.sums, p.fatigue.exponents, r.figures) +
                      " times the silent run's";
      return r;
    }

    /** Totals of all pairs, with their names where there are several. */
    Table
    all_totals(const std::vector<PairDamage> &pairs)
    {
      Table all;
      for (const PairDamage &pair : pairs)
        {
          Table sums = pair.sums;
          if (pairs.size() > 1)
            {
              sums.add_column({"pair", Table::Type::text, "", "contact"});
              for (std::size_t i = 0; i < sums.n_rows(); ++i)
                sums.set(i, "pair", pair.study->reader.layout().pair);
            }
          all.append(sums);
        }
      return all;
    }
  } // namespace



  void
  run_damage(Context &context)
  {
    const TribologyParameters &p = context.parameters;
    prm::require_file(p.history.file, "History", "File", true);
    prm::require_file(p.history.silent_file, "History", "Silent file", false);
    std::vector<PairDamage> pairs;
    for (const std::string &pair : pairs_asked_for(p.history))
      pairs.push_back(damage_of_pair(context, pair));
    context.write_table("totals.csv", all_totals(pairs));

    RunRecord::Pairs &figures = context.record.figures;
    std::string       headline, open_this;
    for (const PairDamage &pair : pairs)
      {
        const std::string &name = pair.study->reader.layout().pair;
        for (auto figure : pair.figures)
          {
            if (pairs.size() > 1)
              figure.first = name + ": " + figure.first;
            figures.push_back(figure);
          }
        headline += (headline.empty() ? "" : "; ") + pair.headline;
        if (open_this.empty())
          open_this = "damage" + pair.study->suffix() + ".vtu";
      }
    HtmlReport report("Damage" + (p.name.empty() ? "" : " of " + p.name),
                      p.history.file);
    report.set_verdict(HtmlReport::Verdict::neutral, headline, figures);
    for (const PairDamage &pair : pairs)
      report_damage(
        report, context, pair.table, pair.sums, *pair.study, pair.silent.get());
    context.finish(p.output.report ? &report : nullptr, open_this);
  }
} // namespace squeal::tribology
