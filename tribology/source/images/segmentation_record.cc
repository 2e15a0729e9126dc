// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/json_file.h>
#include <squeal/tribology/images/segmentation_record.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace squeal::tribology
{
  namespace
  {
    using Json = nlohmann::ordered_json;



    /** Numbers of areas from 10 um^2 on, three classes to a decade. */
    std::vector<double>
    size_classes(const std::vector<double> &areas, std::vector<double> &lower)
    {
      lower = {0.};
      for (double decade = 10.; decade < 1e6; decade *= 10.)
        for (const double step : {1., 2., 5.})
          lower.push_back(step * decade);
      lower.push_back(1e6);
      std::vector<double> counts(lower.size(), 0.);
      for (const double a : areas)
        counts[std::upper_bound(lower.begin(), lower.end(), a) - lower.begin() -
               1] += 1.;
      return counts;
    }



    Json
    areas_json(const double               fraction,
               const double               error,
               const std::vector<double> &areas)
    {
      std::vector<double>       lower;
      const std::vector<double> counts = size_classes(areas, lower);
      return {{"area_fraction", fraction},
              {"area_fraction_error", error},
              {"count", areas.size()},
              {"areas_um2", areas},
              {"size_class_lower_um2", lower},
              {"size_class_count", counts}};
    }



    /** Dark lines that are no cracks: length, a place on each, why. */
    Json
    excluded_json(const SegmentedImage &i)
    {
      Json list = Json::array();
      for (std::size_t k = 0; k < i.excluded.size(); ++k)
        {
          const ExcludedLine &line = i.excluded[k];
          const cv::Point    &p    = line.pixels[line.pixels.size() / 2];
          list.push_back({{"x_px", p.x},
                          {"y_px", p.y},
                          {"length_um", i.excluded_lengths[k]},
                          {"probability", line.probability},
                          {"reason", name_of(line.reason)}});
        }
      return list;
    }



    Json
    kappa_json(const std::optional<Kappa> &kappa)
    {
      return kappa
               ? Json{{"value", kappa->value}, {"deviation", kappa->deviation}}
               : Json();
    }



    /** @p factor takes um or um^2 to what the name says. */
    Json
    rating_json(const Rating &rating, const std::string &name, double factor)
    {
      Json amounts = Json::array();
      for (const double a : rating.amounts)
        amounts.push_back(factor * a);
      Json json = {
        {"raters", rating.raters},
        {name, amounts},
        {"deviation",
         rating.deviation ? Json(factor * *rating.deviation) : Json()}};
      if (!rating.agreement)
        return json;
      json["fleiss_kappa"] = kappa_json(rating.agreement->fleiss);
      json["pairs"]        = Json::array();
      for (const PairAgreement &pair : rating.agreement->pairs)
        json["pairs"].push_back({{"first", rating.raters[pair.first]},
                                 {"second", rating.raters[pair.second]},
                                 {"cohen_kappa", kappa_json(pair.kappa)},
                                 {"dice", pair.dice}});
      return json;
    }



    Json
    image_json(const SegmentedImage &i)
    {
      const ImageStatistics &s    = i.statistics;
      Json                   json = {{"image", i.path},
                                     {"stem", i.stem},
                                     {"width_px", i.size.width},
                                     {"height_px", i.size.height},
                                     {"pixel_size_um", i.pixel_size},
                                     {"scale_source", i.scale_source},
                                     {"synthetic", i.is_synthetic}};
      if (i.stage)
        json["stage_um"] = {i.stage->x, i.stage->y};
      if (i.residual)
        json["registration_residual_um"] = *i.residual;
      if (i.layer)
        json["third_body_layer_um"] = *i.layer;
      // Where no crack is found nothing has a width.
      const auto if_any = [&s](const double value) {
        return s.n_cracks > 0 ? Json(value) : Json();
      };
      json["observed_area_mm2"] = s.observed_area;
      json["cracks"]            = {
                   {"count", s.n_cracks},
                   {"length_mm", s.crack_length},
                   {"length_density_per_mm", s.crack_density},
                   {"area_fraction", s.crack_area / s.observed_area},
                   {"mean_width_um", if_any(s.crack_width)},
                   {"length_error_mm", s.crack_length_error},
                   {"length_common_error_mm", s.crack_length_common_error},
                   {"area_fraction_error", s.crack_area_error / s.observed_area},
                   {"mean_width_error_um", if_any(s.crack_width_error)},
                   {"orientation_share_15deg", s.orientation}};
      json["exfoliation"] = areas_json(s.exfoliation_fraction,
                                       s.exfoliation_fraction_error,
                                       s.exfoliation_areas);
      json["exfoliation"]["without_rim_fraction"]  = s.unsettled_fraction;
      json["exfoliation"]["darker_level_fraction"] = s.darker_level_fraction;
      json["exfoliation"]["is_shown"]              = s.shows_exfoliations();
      json["plateaus"]                             = areas_json(
        s.plateau_fraction, s.plateau_fraction_error, s.plateau_areas);
      json["cracks"]["expected_missed_mm"]   = 1e-3 * i.pixel_size * i.missed;
      json["cracks"]["expected_invented_mm"] = 1e-3 * i.pixel_size * i.invented;
      json["cracks"]["excluded"]             = excluded_json(i);
      if (i.crack_rating)
        {
          json["cracks"]["rating"] =
            rating_json(*i.crack_rating, "lengths_mm", 1e-3);
          json["cracks"]["rating"]["tolerance_px"] = i.tolerance;
        }
      if (i.area_rating)
        json["exfoliation"]["rating"] =
          rating_json(*i.area_rating, "areas_um2", 1.);
      return json;
    }
  } // namespace



  void
  write_segmentation_record(const SegmentationRecord &record,
                            const std::string        &path)
  {
    bool is_synthetic = false;
    Json images       = Json::array();
    for (const SegmentedImage &i : record.images)
      {
        is_synthetic = is_synthetic || i.is_synthetic;
        images.push_back(image_json(i));
      }
    Json json = {{"format_version", SegmentationRecord::format_version},
                 {"synthetic", is_synthetic}};
    if (record.mosaic_refined)
      json["mosaic"] = {{"pairs_tried", record.mosaic_tried},
                        {"pairs_refined", *record.mosaic_refined},
                        {"largest_correction_um", record.mosaic_correction}};
    json["images"] = images;
    write_json(path, json);
  }



  Table
  summary_table(const SegmentationRecord &record)
  {
    using T = Table::Type;
    Table table(
      {{"image", T::text, "", "stem of the file"},
       {"crack_length_m", T::real, "m", "length of all centre lines", 4},
       {"crack_length_error_m", T::real, "m", "deviation of found lines", 2},
       {"crack_density_per_m", T::real, "1/m", "length over area", 4},
       {"crack_width_m",
        T::real,
        "m",
        "mean along the length; empty: no crack",
        3},
       {"crack_width_error_m", T::real, "m", "deviation", 2},
       {"exfoliation_fraction", T::real, "", "share of the area", 3},
       {"exfoliation_fraction_error",
        T::real,
        "",
        "deviation; shares below twice of it show no exfoliation",
        2},
       {"without_rim_fraction",
        T::real,
        "",
        "dark places without a rim: shading, stains or exfoliations",
        2},
       {"plateau_fraction", T::real, "", "bright even places", 3},
       {"plateau_fraction_error",
        T::real,
        "",
        "deviation; only their brightness speaks for plateaus",
        2},
       {"synthetic", T::integer, "", "1: a made image"}});
    for (const SegmentedImage &i : record.images)
      {
        const ImageStatistics &s          = i.statistics;
        const bool             has_cracks = s.n_cracks > 0;
        table.add_row({i.stem,
                       1e-3 * s.crack_length,
                       1e-3 * s.crack_length_error,
                       1e3 * s.crack_density,
                       has_cracks ? Cell(1e-6 * s.crack_width) : Cell(),
                       has_cracks ? Cell(1e-6 * s.crack_width_error) : Cell(),
                       s.exfoliation_fraction,
                       s.exfoliation_fraction_error,
                       s.unsettled_fraction,
                       s.plateau_fraction,
                       s.plateau_fraction_error,
                       int(i.is_synthetic)});
      }
    return table;
  }
} // namespace squeal::tribology
