// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/parameters/checks.h>
#include <squeal/parameters/choices.h>
#include <squeal/tribology/driver/analyses.h>
#include <squeal/tribology/driver/finding_doubts.h>
#include <squeal/tribology/driver/image_report.h>
#include <squeal/tribology/driver/segmentation_input.h>
#include <squeal/tribology/images/cell_grid.h>
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/element_map.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/mosaic.h>
#include <squeal/tribology/images/section_profile.h>
#include <squeal/tribology/images/segmentation_record.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace squeal::tribology
{
  namespace
  {
    using R = SegmentationParameters::Registration;
    using V = SegmentationParameters::View;

    /** Two octaves reach nine pixels, six 144. */
    constexpr int most_octaves = 6;

    /** Pixels. The judge of lines knows no wider cracks, whatever the filters
     * reach. */
    constexpr double widest_found = 10.;

    /** Pixels: how far a line may lie from a straight one, on the mean, and its
     * ends from the border. */
    constexpr double straight  = 2.;
    constexpr int    at_border = 8;

    SegmentationSettings
    settings_of(const SegmentationParameters &p, const double pixel_size)
    {
      SegmentationSettings s;
      const double         width = p.largest_width / pixel_size;
      while (s.n_octaves < most_octaves &&
             width > width_of_octaves(s.n_octaves))
        ++s.n_octaves;
      if (p.smallest_area > 0.)
        s.areas.smallest_area = p.smallest_area / (pixel_size * pixel_size);
      return s;
    }



    /** Grows a map of the frame to the whole image: the data bar has no
     * feature. */
    cv::Mat
    whole(const cv::Mat &map, const Micrograph &m)
    {
      cv::Mat full = cv::Mat::zeros(m.grey.size(), map.type());
      map.copyTo(full(m.frame));
      return full;
    }



    /** The analysis of one list of images. */
    class Run
    {
    public:
      explicit Run(Context &context)
        : context(context)
        , p(context.parameters.segmentation)
        , sliding(p.sliding_direction * CV_PI / 180.)
        , input(read_segmentation_input(context))
        , images(input.images)
      {
      }

      void
      operator()()
      {
        if (p.mosaic)
          join();
        if (p.registration != R::none)
          for (const Micrograph &m : images)
            check_place(m, placement_of(m), context);
        read_element_maps();
        if (p.mosaic)
          write_png(context.output.file("mosaic.png"), picture_of(images[0]));
        if (p.registration != R::none)
          pad.emplace(cv::Size2d(1e3 * p.pad_size[0], 1e3 * p.pad_size[1]),
                      p.cells[0],
                      p.cells[1]);
        for (std::size_t i = 0; i < images.size(); ++i)
          process(i);
        if (pad)
          {
            append(*pad, "pad");
            record.seen_once = pad->seen_once();
          }
        context.write_table("cells.csv", cells);
        write_segmentation_record(record,
                                  context.output.file("segmentation.json"));
        context.write_table("segmentation.csv", summary_table(record));
        std::ostringstream text;
        summary_table(record).print(text);
        context.log.heading("Images");
        context.log.info(text.str());
        for (const std::string &line : areas_in_words(record))
          context.log.warning(line);
        const std::string found = cracks_in_words(record);
        context.record.figures  = {{"found", found}};
        HtmlReport report("Images" + (context.parameters.name.empty()
                                        ? ""
                                        : ": " + context.parameters.name),
                          "cracks, exfoliations and plateaus");
        report.set_verdict(
          HtmlReport::Verdict::neutral, found, context.record.figures);
        const bool writes = context.parameters.output.report;
        if (writes)
          fill_image_report(report, record, context);
        context.finish(writes ? &report : nullptr, "");
      }

    private:
      /** Masks instead of what squeal found, or beside it. */
      void
      rate(const std::size_t i,
           const cv::Mat    &picture,
           Segmentation     &found,
           SegmentedImage   &entry)
      {
        const Micrograph &m = images[i];
        RatingSettings    settings;
        settings.is_beside =
          p.mask_use == SegmentationParameters::MaskUse::beside;
        settings.tolerance = p.mask_tolerance;
        settings.smallest_area =
          settings_of(p, m.pixel_size).areas.smallest_area;
        settings.placement = placement_of(m);
        entry.tolerance    = p.mask_tolerance;
        if (!input.crack_marks[i].empty())
          entry.crack_rating =
            rate_cracks(picture,
                        input.crack_marks[i],
                        settings,
                        settings_of(p, m.pixel_size).n_octaves,
                        found);
        if (entry.crack_rating)
          for (const std::string &warning : entry.crack_rating->warnings)
            context.log.warning(m.path + ": " + warning);
        if (!input.area_marks[i].empty())
          entry.area_rating = rate_areas(input.area_marks[i], settings, found);
        if ((entry.crack_rating && !entry.crack_rating->deviation) ||
            (entry.area_rating && !entry.area_rating->deviation))
          context.log.warning(
            m.path + ": with one mask nothing tells how far raters differ: "
                     "errors are those of measuring what is drawn");
        if (!settings.is_beside)
          for (const auto *rating : {&entry.crack_rating, &entry.area_rating})
            if (*rating)
              for (const std::string &line : disagreements(**rating))
                context.log.warning(m.path + ": " + line);
      }

      void
      join()
      {
        const Mosaic mosaic =
          join_frames(images, context.parameters.images.largest_image);
        for (const std::string &warning : mosaic.warnings)
          context.log.warning(warning);
        Micrograph  m = images[0];
        cv::Point2d centre(0., 0.);
        for (const Micrograph &other : images)
          m.metadata.is_synthetic =
            m.metadata.is_synthetic || other.metadata.is_synthetic;
        m.stem         = "mosaic";
        m.path         = "mosaic";
        m.grey         = mosaic.grey;
        m.seen         = mosaic.seen;
        m.frame        = {{0, 0}, mosaic.grey.size()};
        const double s = m.pixel_size;
        m.metadata.stage =
          *m.metadata.stage - 0.5 * s * cv::Point2d(images[0].frame.size()) -
          s * mosaic.shifts[0] + 0.5 * s * cv::Point2d(m.frame.size());
        if (!m.seen.empty())
          context.log.info("  the images fill " +
                           rounded_text(100. * cv::countNonZero(m.seen) /
                                          double(m.seen.total()),
                                        3) +
                           " % of the rectangle around them: all figures are "
                           "of what they show");
        record.mosaic_refined    = mosaic.n_refined;
        record.mosaic_tried      = mosaic.n_tried;
        record.mosaic_correction = mosaic.correction * s;
        images                   = {m};
      }

      /** Of the first image, or of all joined. */
      void
      read_element_maps()
      {
        for (const std::string &path : p.element_maps)
          element_maps.push_back(element_map_over(
            images[0], path, context.parameters.images.largest_image));
      }

      /** Of 8 bit, black where nothing is seen. */
      static cv::Mat
      picture_of(const Micrograph &m)
      {
        cv::Mat picture;
        m.grey.convertTo(picture, CV_8U);
        keep_seen(picture, m.seen);
        return picture;
      }

      Placement
      placement_of(const Micrograph &m) const
      {
        return input.placement_of(m, p);
      }

      /** Whether the cracks of image @p i are those of masks. */
      bool
      is_drawn(const std::size_t i) const
      {
        return !p.mosaic && !input.crack_marks[i].empty() &&
               p.mask_use == SegmentationParameters::MaskUse::instead;
      }

      /** The darkest groove of a surface may look like a straight crack. */
      void
      warn_of_straight_lines(const std::size_t i, const cv::Mat &line) const
      {
        const Micrograph &m = images[i];
        const cv::Rect    inner(at_border,
                             at_border,
                             line.cols - 2 * at_border,
                             line.rows - 2 * at_border);
        const double      shortest = 0.5 * std::min(line.cols, line.rows);
        double            length   = 0.;
        for (const LinePiece &piece : line_pieces(line))
          if (const double chord =
                cv::norm(piece.axis.front() - piece.axis.back());
              chord > shortest && !inner.contains(piece.axis.front()) &&
              !inner.contains(piece.axis.back()) && piece.waviness() < straight)
            length += chord;
        if (!is_drawn(i) && length > 0.)
          context.log.warning(
            m.path + ": " + rounded_text(length * m.pixel_size, 3) +
            " um of the cracks are straight lines from border to border, as "
            "grooves are, and the error of the length does not contain that "
            "they are grooves: look at them in the overlay");
      }

      /** Of the finding of image @p i, where it is stated. */
      void
      warn_of_width(const std::size_t i) const
      {
        const Micrograph &m = images[i];
        if (!is_drawn(i) && p.largest_width > widest_found * m.pixel_size)
          context.log.warning(
            m.path + ": cracks wider than about " +
            rounded_text(widest_found * m.pixel_size, 3) + " um (" +
            rounded_text(widest_found, 3) +
            " pixels) are mostly not found, although 'Largest crack width' "
            "is " +
            rounded_text(p.largest_width, 3) +
            " um, and the error of the length does not contain them: give the "
            "image with larger pixels, or mark them in 'Masks'");
      }

      /** The frame of an image and what is seen of it, of a section without
       * its resin. */
      SectionView
      specimen_in(const Micrograph &m) const
      {
        SectionView shown;
        shown.grey = m.grey(m.frame);
        if (!m.seen.empty())
          shown.seen = m.seen(m.frame).clone();
        if (p.view != V::section)
          return shown;
        shown = below_face(shown.grey, shown.seen);
        if (shown.grey.empty())
          throw InputError(m.path +
                           " shows no specimen under the resin of a section: "
                           "the worn face must be at the top");
        return shown;
      }

      void
      process(const std::size_t i)
      {
        const Micrograph &m = images[i];
        SegmentedImage    entry;
        Segmentation      found;
        warn_of_width(i);
        {
          Timers::Section   section(context.timers, "Solve: segment images");
          const SectionView shown = specimen_in(m);
          found                   = segment(shown.grey,
                          settings_of(p, m.pixel_size),
                          LineJudge::standard(),
                          shown.seen);
          if (!p.mosaic)
            rate(i, shown.grey, found, entry);
          for (const std::string &doubt : doubts_of(found, m.pixel_size))
            context.log.warning(m.path + ": " + doubt);
          if (!is_drawn(i))
            for (const std::string &doubt :
                 doubts_of_focus(found.cracks, shown.grey, m.pixel_size))
              context.log.warning(m.path + ": " + doubt);
          warn_of_straight_lines(i, found.cracks.centre_line);
        }
        entry.stem         = m.stem;
        entry.path         = m.path;
        entry.size         = m.grey.size();
        entry.pixel_size   = m.pixel_size;
        entry.scale_source = m.scale_source;
        entry.is_synthetic = m.metadata.is_synthetic;
        entry.stage        = m.metadata.stage;
        entry.residual     = p.registration == R::points
                               ? std::optional<double>(input.by_points.residual)
                               : std::nullopt;
        entry.statistics   = measure(found, placement_of(m), sliding);
        entry.excluded     = found.excluded;
        for (const ExcludedLine &line : found.excluded)
          entry.excluded_lengths.push_back(
            length_on_pad(line.pixels, placement_of(m)));
        entry.missed   = found.cracks.doubt.missed;
        entry.invented = found.cracks.doubt.invented;
        add_deviations(entry.crack_rating, entry.area_rating, entry.statistics);
        if (p.view == V::section)
          section_table(m, found, entry);
        Timers::Section section(context.timers, "Write: maps");
        Segmentation    full    = found;
        full.cracks.area        = whole(found.cracks.area, m);
        full.cracks.centre_line = whole(found.cracks.centre_line, m);
        full.areas.exfoliation  = whole(found.areas.exfoliation, m);
        full.areas.plateau      = whole(found.areas.plateau, m);
        if (!found.areas.unsettled.empty())
          full.areas.unsettled = whole(found.areas.unsettled, m);
        const auto file = [&](const std::string &end) {
          return context.output.file(m.stem + end);
        };
        write_png(file("_cracks.png"), full.cracks.area);
        write_png(file("_exfoliation.png"), full.areas.exfoliation);
        write_png(file("_plateaus.png"), full.areas.plateau);
        const cv::Mat overlay = draw_overlay(picture_of(m), full);
        write_png(file("_overlay.png"), overlay);
        if (pad)
          write_png(file("_on_pad.png"),
                    in_axes_of_pad(overlay(m.frame), placement_of(m)).image);
        gather(m, found, i == 0);
        record.images.push_back(entry);
      }

      void
      gather(const Micrograph   &m,
             const Segmentation &found,
             const bool          is_first)
      {
        const Placement placement = placement_of(m);
        CellGrid        own(
          cv::Size2d(m.frame.size()) * m.pixel_size, p.cells[0], p.cells[1]);
        CellGrid &grid = pad ? *pad : own;
        grid.add(found, placement, sliding, m.metadata.is_synthetic);
        if (is_first)
          for (const ElementMap &map : element_maps)
            grid.add_covariate(
              map.name, map.values, placement, both_seen(found.seen, map.seen));
        if (!pad)
          append(own, m.stem);
      }

      void
      append(const CellGrid &grid, const std::string &image)
      {
        Table part(grid.columns());
        grid.append_rows(part, image);
        if (cells.columns().empty())
          {
            cells = part;
            return;
          }
        for (std::size_t r = 0; r < part.n_rows(); ++r)
          {
            // Later images have no element maps.
            std::vector<Cell> row;
            for (std::size_t c = 0; c < cells.columns().size(); ++c)
              row.push_back(c < part.columns().size() ? part.cell(r, c)
                                                      : Cell());
            cells.add_row(row);
          }
      }

      void
      section_table(const Micrograph   &m,
                    const Segmentation &found,
                    SegmentedImage     &entry)
      {
        const double         s = m.pixel_size;
        const SectionProfile profile =
          profile_section(m.grey(m.frame),
                          found.cracks.centre_line,
                          std::max(1., p.depth_band / s),
                          found.seen);
        for (const std::string &doubt : profile.doubts)
          context.log.warning(m.path + ": " + doubt);
        using T = Table::Type;
        Table table({{"depth_m", T::real, "m", "mean of what is seen"},
                     {"area_m2", T::real, "m^2", "area that is seen"},
                     {"crack_length_m", T::real, "m", "length in the band"},
                     {"crack_density_per_m", T::real, "1/m", "over area"}});
        for (std::size_t b = 0; b < profile.band_area.size(); ++b)
          {
            const double area   = 1e-12 * s * s * profile.band_area[b];
            const double length = 1e-6 * s * profile.crack_length[b];
            if (area > 0.)
              table.add_row({1e-6 * s * profile.band_depth[b],
                             area,
                             length,
                             length / area});
          }
        context.write_table(m.stem + "_depth.csv", table);
        entry.layer = std::array<double, 3>{{s * profile.layer_10,
                                             s * profile.layer_median,
                                             s * profile.layer_90}};
      }

      Context                      &context;
      const SegmentationParameters &p;
      const double                  sliding;
      const SegmentationInput       input;
      std::vector<Micrograph>       images; // those of the input, or all joined
      std::optional<CellGrid>       pad;
      std::vector<ElementMap>       element_maps;
      Table                         cells;
      SegmentationRecord            record;
    };
  } // namespace



  void
  run_segmentation(Context &context)
  {
    Run run(context);
    run();
  }
} // namespace squeal::tribology
