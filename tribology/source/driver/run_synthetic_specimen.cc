// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/parameters/checks.h>
#include <squeal/results/table.h>
#include <squeal/tribology/driver/analyses.h>
#include <squeal/tribology/driver/image_report.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/specimen.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <sstream>

namespace squeal::tribology
{
  namespace
  {
    /** Relative crack rate over the pad from a column of a damage table: the
     * value of the nearest node over the mean, blended with 1. */
    std::function<double(double, double)>
    linked_rate(const SpecimenParameters &p)
    {
      if (p.damage_table.empty() || p.link_strength == 0.)
        return {};
      prm::require_file(
        p.damage_table, "Synthetic specimen", "Damage table", true);
      const Table               table = read_csv(p.damage_table);
      const std::vector<double> x = table.reals("x_m"), y = table.reals("y_m"),
                                values = table.reals(p.damage_column);
      double sum                       = 0.;
      for (const double v : values)
        {
          if (!std::isfinite(v) || v < 0.)
            throw InputError(p.damage_table + ": column '" + p.damage_column +
                             "' has values that are no positive numbers: a "
                             "crack rate needs them");
          sum += v;
        }
      if (values.empty() || sum == 0.)
        throw InputError(p.damage_table + ": column '" + p.damage_column +
                         "' has no damage: 'Link strength' needs some");
      const double mean   = sum / double(values.size());
      const auto [x0, x1] = std::minmax_element(x.begin(), x.end());
      const auto [y0, y1] = std::minmax_element(y.begin(), y.end());
      const double left = *x0, width = std::max(1e-12, *x1 - *x0), top = *y0,
                   height = std::max(1e-12, *y1 - *y0);
      const double s      = p.link_strength;
      return [=](const double u, const double v) {
        std::size_t nearest  = 0;
        double      distance = -1.;
        for (std::size_t i = 0; i < x.size(); ++i)
          {
            const double d =
              std::hypot(left + u * width - x[i], top + v * height - y[i]);
            if (distance < 0. || d < distance)
              {
                distance = d;
                nearest  = i;
              }
          }
        return 1. - s + s * values[nearest] / mean;
      };
    }



    SpecimenSettings
    settings_of(const TribologyParameters &parameters)
    {
      const SpecimenParameters &p = parameters.specimen;
      SpecimenSettings          s;
      s.width  = p.field[0];
      s.height = p.field[1];
      s.pixel_size =
        parameters.images.pixel_size > 0. ? parameters.images.pixel_size : 1.;
      s.feature_size  = p.feature_size;
      s.crack_density = p.crack_density;
      s.exfoliated    = p.exfoliated;
      s.plateaus      = p.plateaus;
      s.noise         = p.noise;
      s.shading       = p.shading;
      s.data_bar      = p.data_bar;
      s.rate          = linked_rate(p);
      return s;
    }



    /** What read_metadata() finds again. */
    std::string
    metadata_text(const SpecimenSettings &s)
    {
      std::ostringstream text;
      text << "Kind = synthetic specimen\nPixel size = "
           << shortest_text(s.pixel_size) << " um\nStage x = 0 um\nStage y = 0 "
           << "um\nSeed = " << s.seed << "\n";
      return text.str();
    }
  } // namespace



  void
  run_synthetic_specimen(Context &context)
  {
    const SpecimenParameters &p        = context.parameters.specimen;
    SpecimenSettings          settings = settings_of(context.parameters);
    using T                            = Table::Type;
    Table truth(
      {{"image", T::text, "", "stem of the file"},
       {"synthetic", T::integer, "", "always 1"},
       {"seed", T::integer, "", "seed of the image"},
       {"pixel_size_m", T::real, "m", "edge of a pixel"},
       {"n_cracks", T::integer, "", "without branches"},
       {"crack_length_m", T::real, "m", "of all centre lines in the view"},
       {"crack_area_m2", T::real, "m^2", "covered by cracks"},
       {"exfoliated_area_m2", T::real, "m^2", "covered by exfoliations"},
       {"link_strength", T::real, "", "0: cracks do not follow the damage"}});
    for (unsigned int i = 0; i < p.n_images; ++i)
      {
        settings.seed = p.seed + i;
        Specimen made;
        {
          Timers::Section section(context.timers, "Solve: draw specimens");
          made = make_specimen(settings);
        }
        Timers::Section section(context.timers, "Write: specimens");
        char            stem[32];
        std::snprintf(stem, sizeof stem, "specimen_%04u", settings.seed);
        const std::string name = stem;
        const auto        file = [&](const std::string &end) {
          return context.output.file(name + end);
        };
        write_png(file(".png"), made.image, metadata_text(settings));
        write_png(file("_true_cracks.png"), made.cracks);
        write_png(file("_true_exfoliation.png"), made.exfoliation);
        write_png(file("_true_plateaus.png"), made.plateau);
        truth.add_row({name,
                       1,
                       settings.seed,
                       1e-6 * settings.pixel_size,
                       made.n_cracks,
                       1e-6 * made.crack_length,
                       1e-12 * made.crack_area,
                       1e-12 * made.exfoliated_area,
                       p.link_strength});
      }
    context.write_table("specimens.csv", truth);
    std::ostringstream text;
    truth.print(text);
    context.log.heading("Synthetic specimens");
    context.log.info(text.str());
    long   n_cracks = 0;
    double length   = 0.;
    for (std::size_t i = 0; i < truth.n_rows(); ++i)
      {
        n_cracks += std::lround(truth.real(i, "n_cracks"));
        length += truth.real(i, "crack_length_m");
      }
    // What a segmentation has to find.
    context.record.figures = {
      {"synthetic images", std::to_string(p.n_images)},
      {"cracks drawn",
       std::to_string(n_cracks) + ", together " +
         rounded_text(1e3 * length, 3) + " mm, " +
         (p.link_strength > 0. ? "where the damage is" : "anywhere")}};
    HtmlReport report(
      "Synthetic specimens" +
        (context.parameters.name.empty() ? "" : ": " + context.parameters.name),
      "made images with known cracks");
    report.set_verdict(HtmlReport::Verdict::neutral,
                       context.record.figures[1].first + ": " +
                         context.record.figures[1].second,
                       context.record.figures);
    const bool writes = context.parameters.output.report;
    if (writes)
      fill_specimen_report(report, truth, context);
    context.finish(writes ? &report : nullptr, "");
  }
} // namespace squeal::tribology
