// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/driver/image_report.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace squeal::tribology
{
  namespace
  {
    constexpr int         picture_width = 820; // pixels
    constexpr std::size_t most_pictures = 12, most_lines = 30;

    /** In the folder plots of a run. */
    std::string
    reduced_in(Context &context, const std::string &from, const std::string &to)
    {
      return reduced_picture(context.output.path() + "/" + from,
                             context.output.file("plots/" + to));
    }



    /** A share that is not excluded, per cent: none is more than the whole. */
    std::string
    up_to_text(const double share, const double error)
    {
      return rounded_text(100. * std::min(1., share + 2. * error), 2);
    }



    /** A share with its deviation, per cent. */
    std::string
    share_text(const double share, const double error)
    {
      return rounded_text(100. * share, 2) + " +- " +
             rounded_text(100. * error, 2);
    }



    /** What the image tells about exfoliations: an area, or how much it does
     * not exclude. */
    std::string
    exfoliated_in_words(const ImageStatistics &s)
    {
      return s.shows_exfoliations()
               ? share_text(s.exfoliation_fraction,
                            s.exfoliation_fraction_error)
               : "none shown, up to " +
                   up_to_text(s.exfoliation_fraction,
                              s.exfoliation_fraction_error);
    }



    /** Main figures of each image in units that are read at a glance;
     * segmentation.csv has them in SI units. */
    Table
    figures_of(const SegmentationRecord &record)
    {
      using T = Table::Type;
      Table table(
        {{"image", T::text, "", "stem of the file"},
         {"crack_length", T::real, "mm", "length of all centre lines", 3},
         {"crack_length_error", T::real, "mm", "one deviation", 2},
         {"crack_density", T::real, "mm/mm^2", "length over area", 3},
         {"crack_width", T::real, "um", "mean along the length", 2},
         {"crack_width_error", T::real, "um", "one deviation", 2},
         {"exfoliated", T::text, "%", "share of the area, one deviation"},
         {"plateaus", T::text, "%", "bright even places, one deviation"},
         {"pixel_size", T::real, "um", "edge of a pixel", 4}});
      for (const SegmentedImage &i : record.images)
        {
          const ImageStatistics &s = i.statistics;
          table.add_row(
            {i.stem + (i.is_synthetic ? " (made)" : ""),
             s.crack_length,
             s.crack_length_error,
             s.crack_density,
             s.n_cracks > 0 ? Cell(s.crack_width) : Cell(),
             s.n_cracks > 0 ? Cell(s.crack_width_error) : Cell(),
             exfoliated_in_words(s),
             share_text(s.plateau_fraction, s.plateau_fraction_error),
             i.pixel_size});
        }
      return table;
    }



    /** What the error of each length is made of. */
    Table
    doubts(const SegmentationRecord &record)
    {
      using T = Table::Type;
      Table table(
        {{"image", T::text, "", "stem of the file"},
         {"missed", T::real, "mm", "length that was probably missed", 2},
         {"invented", T::real, "mm", "found length that is probably none", 2},
         {"crack_length_error", T::real, "mm", "one deviation", 2},
         {"crack_area", T::real, "%", "share of the area", 2},
         {"crack_area_error", T::real, "%", "one deviation", 2}});
      for (const SegmentedImage &i : record.images)
        {
          const ImageStatistics &s = i.statistics;
          table.add_row({i.stem,
                         1e-3 * i.pixel_size * i.missed,
                         1e-3 * i.pixel_size * i.invented,
                         s.crack_length_error,
                         100. * s.crack_area / s.observed_area,
                         100. * s.crack_area_error / s.observed_area});
        }
      return table;
    }



    /** The likeliest of the lines that were left out. */
    Table
    left_out(const SegmentationRecord &record)
    {
      struct Line
      {
        const SegmentedImage *image;
        const ExcludedLine   *line;
        double                length; // um
      };
      std::vector<Line> lines;
      for (const SegmentedImage &i : record.images)
        for (std::size_t k = 0; k < i.excluded.size(); ++k)
          lines.push_back({&i, &i.excluded[k], i.excluded_lengths[k]});
      std::stable_sort(
        lines.begin(), lines.end(), [](const Line &a, const Line &b) {
          return a.line->probability > b.line->probability;
        });
      if (lines.size() > most_lines)
        lines.resize(most_lines);
      using T = Table::Type;
      Table table({{"image", T::text, "", "stem of the file"},
                   {"x_px", T::integer, "px", "from the left"},
                   {"y_px", T::integer, "px", "from the top"},
                   {"length", T::real, "um", "of the line", 3},
                   {"probability", T::real, "", "of a crack all the same", 2},
                   {"reason", T::text, "", "why it is left out"}});
      for (const Line &l : lines)
        {
          const PixelPath &pixels = l.line->pixels;
          table.add_row({l.image->stem,
                         pixels[pixels.size() / 2].x,
                         pixels[pixels.size() / 2].y,
                         l.length,
                         l.line->probability,
                         name_of(l.line->reason)});
        }
      return table;
    }



    /** Each pair of raters of the cracks. */
    Table
    agreements(const SegmentationRecord &record)
    {
      using T = Table::Type;
      Table table({{"image", T::text, "", "stem of the file"},
                   {"first_rater", T::text, "", "one of the pair"},
                   {"second_rater", T::text, "", "the other"},
                   {"cohen_kappa", T::real, "", "1: they agree", 3},
                   {"cohen_kappa_error", T::real, "", "one deviation", 2},
                   {"dice", T::real, "", "overlap of what both drew", 3}});
      for (const SegmentedImage &i : record.images)
        if (i.crack_rating && i.crack_rating->agreement)
          for (const PairAgreement &pair : i.crack_rating->agreement->pairs)
            table.add_row({i.stem,
                           i.crack_rating->raters[pair.first],
                           i.crack_rating->raters[pair.second],
                           pair.kappa ? Cell(pair.kappa->value) : Cell(),
                           pair.kappa ? Cell(pair.kappa->deviation) : Cell(),
                           pair.dice});
      return table;
    }



    void
    add_overlays(HtmlReport               &report,
                 const SegmentationRecord &record,
                 Context                  &context)
    {
      report.section("Overlays");
      report.paragraph(
        "Cracks are red, lines that were left out yellow, outlines of "
        "exfoliations purple, of dark places without a rim grey, of contact "
        "plateaus blue. Judge by eye whether "
        "the red lines are the cracks of this surface.");
      for (std::size_t i = 0; i < std::min(most_pictures, record.images.size());
           ++i)
        {
          const std::string &stem = record.images[i].stem;
          report.figure(reduced_in(context,
                                   stem + "_overlay.png",
                                   stem + "_overlay_reduced.png"),
                        stem,
                        true);
        }
      if (record.images.size() > most_pictures)
        report.paragraph("Shown are the first " +
                         std::to_string(most_pictures) + " of " +
                         std::to_string(record.images.size()) +
                         " images; the others are beside this report.");
    }
  } // namespace



  std::string
  reduced_picture(const std::string &from, const std::string &to)
  {
    if (!std::filesystem::exists(from))
      return "";
    const cv::Mat image = cv::imread(from, cv::IMREAD_COLOR);
    if (image.empty())
      return "";
    const double scale = std::min(1., double(picture_width) / image.cols);
    cv::Mat      small;
    cv::resize(image, small, cv::Size(), scale, scale, cv::INTER_AREA);
    cv::imwrite(to, small);
    return to;
  }



  namespace
  {
    // Of what images of a pad show, seen once: with more they are beside one
    // another.
    constexpr double beside_one_another = 0.99;
  } // namespace



  std::string
  cracks_in_words(const SegmentationRecord &record)
  {
    double            length = 0., area = 0., share = 1.;
    SummedLengthError errors;
    for (const SegmentedImage &i : record.images)
      {
        length += i.statistics.crack_length;
        errors.add(i.statistics);
        area += i.statistics.observed_area;
      }
    const std::size_t n = record.images.size();
    std::string text    = std::to_string(n) + (n == 1 ? " image" : " images");
    if (const auto &once = record.seen_once;
        once && once->share < beside_one_another)
      {
        length = 1e-3 * once->crack_length;
        area   = 1e-6 * once->area;
        share  = once->share;
        text += " that overlap, each part of the pad counted once";
      }
    const double      deviation = errors.deviation(share);
    const std::string error     = rounded_text(deviation, 2) + " mm";
    if (length == 0.)
      return "no crack found in " + text + " (0 +- " + error +
             "; cracks of up to " + rounded_text(2. * deviation, 2) +
             " mm are not excluded)";
    return "cracks of " + rounded_text(length, 3) + " +- " + error + " in " +
           text + ", " + rounded_text(length / area, 3) + " mm per mm^2";
  }



  std::vector<std::string>
  areas_in_words(const SegmentationRecord &record)
  {
    std::vector<std::string> lines;
    for (const SegmentedImage &i : record.images)
      {
        const ImageStatistics &s = i.statistics;
        if (!s.shows_exfoliations() && s.unsettled_fraction > 0.)
          lines.push_back(i.stem + ": no evidence of exfoliations: " +
                          rounded_text(100. * s.unsettled_fraction, 2) +
                          " % of the area is dark without a rim, which may be "
                          "shading or stains; an image with light from another "
                          "side, or depths, would tell");
        if (s.darker_level_fraction > 0.)
          lines.push_back(
            i.stem + ": the image has two levels of brightness; the darker " +
            "covers " + rounded_text(100. * s.darker_level_fraction, 2) +
            " % and is taken for " +
            (s.bulk_is_darker
               ? "the surface, since it has the larger part: if it came off, "
                 "that is the exfoliated share, and the error holds it"
               : "what came off, since the brighter has the larger part") +
            "; look at the overlay, or mark the areas in 'Area masks'");
        if (s.plateau_fraction > 0. && !i.is_synthetic)
          lines.push_back(
            i.stem +
            ": no evidence of contact plateaus but "
            "brightness: their area may be any up to " +
            up_to_text(s.plateau_fraction, s.plateau_fraction_error) + " %");
      }
    return lines;
  }



  void
  fill_image_report(HtmlReport               &report,
                    const SegmentationRecord &record,
                    Context                  &context)
  {
    report.section("Images");
    report.table(figures_of(record),
                 "Figures of each image (in SI units: segmentation.csv)");
    add_overlays(report, record, context);
    for (const SegmentedImage &i : record.images)
      if (i.residual)
        report.paragraph(i.stem + ": the points of its registration lie " +
                         rounded_text(*i.residual, 3) +
                         " um (rms) from where the map takes them.");
    if (record.mosaic_refined)
      report.paragraph("Of " + std::to_string(record.mosaic_tried) +
                       " overlaps of the mosaic " +
                       std::to_string(*record.mosaic_refined) +
                       " show the same and are aligned; no image was moved by "
                       "more than " +
                       rounded_text(record.mosaic_correction, 3) + " um.");
    for (const std::string &line : areas_in_words(record))
      report.paragraph(line);
    report.section("How sure the figures are");
    report.paragraph(
      "Errors are one standard deviation. That of a length holds the pixels "
      "and ends of the lines, the lengths that were probably missed and "
      "probably invented, and, where several people marked the cracks, how far "
      "they differ. A crack without contrast leaves no trace and is in no "
      "error.");
    report.table(doubts(record), "What the errors are made of");
    if (const Table raters = agreements(record); raters.n_rows() > 0)
      report.table(raters, "Agreement of raters over the cracks");
    if (const Table lines = left_out(record); lines.n_rows() > 0)
      {
        report.section("What was left out");
        report.paragraph("Dark lines that are probably no cracks, the most "
                         "doubtful first, at most " +
                         std::to_string(most_lines) +
                         "; all are in segmentation.json.");
        report.table(lines, "Lines left out");
      }
  }



  void
  fill_specimen_report(HtmlReport &report, const Table &truth, Context &context)
  {
    report.section("What was drawn");
    report.paragraph("The images are made, not photographed: what is found in "
                     "them tests the method and says nothing about a brake.");
    using T = Table::Type;
    Table table({{"image", T::text, "", "stem of the file"},
                 {"cracks", T::integer, "", "without branches"},
                 {"crack_length", T::real, "mm", "of all centre lines", 4},
                 {"crack_area", T::real, "mm^2", "covered by cracks", 3},
                 {"exfoliated_area", T::real, "mm^2", "covered by them", 3},
                 {"pixel_size", T::real, "um", "edge of a pixel", 4}});
    for (std::size_t i = 0; i < truth.n_rows(); ++i)
      table.add_row({truth.text(i, "image"),
                     int(std::lround(truth.real(i, "n_cracks"))),
                     1e3 * truth.real(i, "crack_length_m"),
                     1e6 * truth.real(i, "crack_area_m2"),
                     1e6 * truth.real(i, "exfoliated_area_m2"),
                     1e6 * truth.real(i, "pixel_size_m")});
    report.table(table, "Made specimens (in SI units: specimens.csv)");
    report.section("Pictures");
    for (std::size_t i = 0; i < std::min(most_pictures / 4, truth.n_rows());
         ++i)
      {
        const std::string stem = truth.text(i, "image");
        for (const auto &[end, caption] :
             {std::pair{"", ""},
              std::pair{"_true_cracks", ": cracks as drawn"}})
          report.figure(reduced_in(context,
                                   stem + end + ".png",
                                   stem + end + "_reduced.png"),
                        stem + caption,
                        true);
      }
  }
} // namespace squeal::tribology
