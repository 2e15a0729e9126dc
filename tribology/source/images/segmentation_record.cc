// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/segmentation_record.h>

#include <ostream>

namespace squeal::tribology
{
  namespace
  {
    std::string
    in_quotes(const std::string &text)
    {
      std::string result = "\"";
      for (const char c : text)
        {
          if (c == '"' || c == '\\')
            result += '\\';
          if (static_cast<unsigned char>(c) >= 0x20)
            result += c;
        }
      return result + "\"";
    }



    std::string
    list(const std::vector<double> &values)
    {
      std::string result = "[";
      for (const double v : values)
        result += (result.size() > 1 ? ", " : "") + shortest_text(v);
      return result + "]";
    }



    /** Numbers of areas from 10 um^2 on, three classes to a decade. */
    std::vector<double>
    size_classes(const std::vector<double> &areas, std::vector<double> &lower)
    {
      std::vector<double> counts;
      double              edge = 10.;
      for (const double factor :
           {2., 2.5, 2., 2., 2.5, 2., 2., 2.5, 2., 2., 2.5, 2., 2., 2.5, 2.})
        {
          lower.push_back(edge);
          double n = 0.;
          for (const double a : areas)
            n += a >= edge && a < factor * edge;
          counts.push_back(n);
          edge *= factor;
        }
      return counts;
    }



    void
    write_areas(std::ostream              &out,
                const std::string         &name,
                const double               fraction,
                const std::vector<double> &areas)
    {
      std::vector<double>       lower;
      const std::vector<double> counts = size_classes(areas, lower);
      out << "      " << in_quotes(name)
          << ": {\"area_fraction\": " << shortest_text(fraction)
          << ", \"count\": " << areas.size()
          << ",\n        \"areas_um2\": " << list(areas)
          << ",\n        \"size_class_lower_um2\": " << list(lower)
          << ",\n        \"size_class_count\": " << list(counts) << "}";
    }



    void
    write_image(std::ostream &out, const SegmentedImage &i)
    {
      const ImageStatistics &s = i.statistics;
      out << "    {\n      \"image\": " << in_quotes(i.path)
          << ",\n      \"stem\": " << in_quotes(i.stem)
          << ",\n      \"width_px\": " << i.size.width
          << ",\n      \"height_px\": " << i.size.height
          << ",\n      \"pixel_size_um\": " << shortest_text(i.pixel_size)
          << ",\n      \"scale_source\": " << in_quotes(i.scale_source)
          << ",\n      \"synthetic\": " << (i.is_synthetic ? "true" : "false");
      if (i.stage)
        out << ",\n      \"stage_um\": " << list({i.stage->x, i.stage->y});
      if (i.residual)
        out << ",\n      \"registration_residual_um\": "
            << shortest_text(*i.residual);
      if (i.layer)
        out << ",\n      \"third_body_layer_um\": "
            << list({(*i.layer)[0], (*i.layer)[1], (*i.layer)[2]});
      out << ",\n      \"observed_area_mm2\": "
          << shortest_text(s.observed_area)
          << ",\n      \"cracks\": {\"count\": " << s.n_cracks
          << ", \"length_mm\": " << shortest_text(s.crack_length)
          << ", \"length_density_per_mm\": " << shortest_text(s.crack_density)
          << ", \"area_fraction\": "
          << shortest_text(s.crack_area / s.observed_area)
          << ", \"mean_width_um\": " << shortest_text(s.crack_width)
          << ",\n        \"length_error_mm\": "
          << shortest_text(s.crack_length_error)
          << ", \"area_fraction_error\": "
          << shortest_text(s.crack_area_error / s.observed_area)
          << ", \"mean_width_error_um\": " << shortest_text(s.crack_width_error)
          << ",\n        \"orientation_share_15deg\": " << list(s.orientation)
          << "},\n";
      write_areas(
        out, "exfoliation", s.exfoliation_fraction, s.exfoliation_areas);
      out << ",\n";
      write_areas(out, "plateaus", s.plateau_fraction, s.plateau_areas);
      out << "\n    }";
    }
  } // namespace



  void
  write_segmentation_record(const SegmentationRecord &record, std::ostream &out)
  {
    bool is_synthetic = false;
    for (const SegmentedImage &i : record.images)
      is_synthetic = is_synthetic || i.is_synthetic;
    out << "{\n  \"format_version\": " << SegmentationRecord::format_version
        << ",\n  \"synthetic\": " << (is_synthetic ? "true" : "false");
    if (record.mosaic_refined)
      out << ",\n  \"mosaic\": {\"pairs_refined\": " << *record.mosaic_refined
          << ", \"largest_correction_um\": "
          << shortest_text(record.mosaic_correction) << "}";
    out << ",\n  \"images\": [";
    const char *separator = "\n";
    for (const SegmentedImage &i : record.images)
      {
        out << separator;
        write_image(out, i);
        separator = ",\n";
      }
    out << "\n  ]\n}\n";
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
       {"crack_width_m", T::real, "m", "mean along the length", 3},
       {"crack_width_error_m", T::real, "m", "deviation", 2},
       {"exfoliation_fraction", T::real, "", "share of the area", 3},
       {"plateau_fraction", T::real, "", "share of the area", 3},
       {"synthetic", T::integer, "", "1: a made image"}});
    for (const SegmentedImage &i : record.images)
      {
        const ImageStatistics &s = i.statistics;
        table.add_row({i.stem,
                       1e-3 * s.crack_length,
                       1e-3 * s.crack_length_error,
                       1e3 * s.crack_density,
                       1e-6 * s.crack_width,
                       1e-6 * s.crack_width_error,
                       s.exfoliation_fraction,
                       s.plateau_fraction,
                       int(i.is_synthetic)});
      }
    return table;
  }
} // namespace squeal::tribology
