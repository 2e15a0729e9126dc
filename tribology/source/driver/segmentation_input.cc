// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/tribology/driver/segmentation_input.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/rater_masks.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace squeal::tribology
{
  namespace
  {
    using R = SegmentationParameters::Registration;
    using T = SegmentationParameters::Transform;

    /** Two statements of the size of a pixel may differ by so much. */
    constexpr double scale_agreement = 0.05;

    /** Pixels of which length and width differ by less pass for squares: their
     * lengths are not known any better. */
    constexpr double square_agreement = 0.02;

    /** Rms distance of registration points over the edge of a cell, from where
     * on cracks come into wrong cells. */
    constexpr double largest_residual = 0.25;

    /** Degrees of stage and scan that pass for none: a tenth of a millimetre on
     * a pad of a centimetre. */
    constexpr double least_rotation = 0.5;

    /** Share of an image beside the pad that is worth a warning. */
    constexpr double least_outside = 0.01;

    std::vector<cv::Point2d>
    points_of(const std::vector<double> &numbers, const double factor)
    {
      std::vector<cv::Point2d> points;
      for (std::size_t i = 0; i + 1 < numbers.size(); i += 2)
        points.emplace_back(factor * numbers[i], factor * numbers[i + 1]);
      return points;
    }



    /** A bar that is drawn into the picture is dark or bright, and no part of
     * the specimen. */
    void
    leave_scale_bar(Micrograph &m)
    {
      const cv::Rect bar = m.scale_bar & m.frame;
      if (bar.empty())
        return;
      if (m.seen.empty())
        m.seen = cv::Mat(m.grey.size(), CV_8U, cv::Scalar(255));
      m.seen(bar).setTo(0);
      m.notes.push_back("the scale bar and its label, " +
                        size_text(bar.size()) + " pixels from column " +
                        std::to_string(bar.x) + " and row " +
                        std::to_string(bar.y) +
                        ", are left out: draw 'Scale bar box' around the whole "
                        "label if more of it is to be");
    }



    /** Notes what of @p m is not seen: transparent pixels, black borders but
     * where the resin of a section may be black, and the scale bar. */
    void
    note_unseen(Micrograph &m, const bool is_section)
    {
      if (is_section && !m.seen.empty())
        throw InputError(m.path + " is transparent in part: cut a section "
                                  "to the rectangle that is seen");
      const SeenPixels inside =
        is_section ? SeenPixels() : inside_black_border(m.grey(m.frame));
      if (!inside.empty())
        {
          if (m.seen.empty())
            m.seen = cv::Mat(m.grey.size(), CV_8U, cv::Scalar(255));
          cv::Mat frame = m.seen(m.frame);
          frame &= inside;
          m.warnings.push_back(
            "black areas at its edge (" +
            rounded_text(100. - 100. * cv::countNonZero(inside) /
                                  double(inside.total()),
                         2) +
            " % of the picture) are taken for a border and not for the "
            "specimen: cut or brighten the image if they belong to it");
        }
      leave_scale_bar(m);
      if (m.seen.empty())
        return;
      const int n = cv::countNonZero(m.seen(m.frame));
      if (n == 0)
        throw InputError(m.path + " shows nothing: it is black or transparent "
                                  "everywhere");
      m.notes.push_back(rounded_text(100. * n / double(m.frame.area()), 3) +
                        " % of the picture are seen, and all figures are of "
                        "these");
    }



    /** Rows of that name are those of all images laid on the pad. */
    void
    require_no_pad(const std::string &file)
    {
      if (std::filesystem::path(file).stem() == "pad")
        throw InputError(file + ": the image 'pad' of cells.csv is what all "
                                "images show of the pad, and one by itself "
                                "would pass for it: rename the file");
    }



    class Reader
    {
    public:
      explicit Reader(Context &context)
        : context(context)
        , p(context.parameters.segmentation)
      {
      }

      SegmentationInput
      operator()()
      {
        read_images();
        check_rotations();
        check_pixel_sizes();
        if (p.registration == R::points)
          place_by_points();
        require_square_pixels();
        read_masks(p.masks, "Masks", input.crack_marks);
        read_masks(p.area_masks, "Area masks", input.area_marks);
        if (p.registration == R::stage)
          for (const Micrograph &m : input.images)
            place_by_stage(m);
        return input;
      }

    private:
      void
      read_images()
      {
        ScaleBar bar;
        bar.length = p.scale_bar_length;
        if (p.scale_bar_box.size() == 4)
          bar.box = {p.scale_bar_box[0],
                     p.scale_bar_box[1],
                     p.scale_bar_box[2],
                     p.scale_bar_box[3]};
        const std::vector<std::string> &names =
          context.parameters.images.images;
        const std::vector<std::string> files = expand_wildcards(names);
        for (const std::string &line : missed_images(names, files))
          context.log.warning(line);
        const auto read = [&](const std::string &file, const int least_bits) {
          return read_micrograph(file,
                                 context.parameters.images.pixel_size,
                                 bar,
                                 context.parameters.images.largest_image,
                                 p.data_bar,
                                 least_bits);
        };
        int most_bits = 0;
        for (const std::string &file : files)
          {
            require_no_pad(file);
            input.images.push_back(read(file, 8));
            most_bits = std::max(most_bits, input.images.back().bits);
          }
        // The images of a mosaic have one exposure and need one range.
        if (p.mosaic)
          for (Micrograph &m : input.images)
            if (m.bits > 0 && m.bits < most_bits)
              m = read(m.path, most_bits);
        for (Micrograph &m : input.images)
          {
            note_unseen(m, p.view == SegmentationParameters::View::section);
            if (const int n = m.grey.rows - m.frame.height; n > 0)
              m.notes.push_back("the last " + std::to_string(n) + " of " +
                                std::to_string(m.grey.rows) +
                                " rows are a data bar and left out");
            for (const std::string &note : m.notes)
              context.log.info("  " + m.path + ": " + note);
            for (const std::string &warning : m.warnings)
              context.log.warning(m.path + ": " + warning);
          }
      }

      /** Nothing turns an image by the angles of stage and scan, whose signs
       * differ from maker to maker. */
      void
      check_rotations() const
      {
        if (p.registration == R::points && !p.mosaic)
          return;
        const bool by_stage = p.mosaic || p.registration == R::stage;
        for (const Micrograph &m : input.images)
          for (const auto &[angle, name] :
               {std::pair(m.metadata.stage_rotation, "stage"),
                std::pair(m.metadata.scan_rotation, "scan")})
            {
              if (std::abs(angle) < least_rotation)
                continue;
              const std::string text =
                m.path + ": by its metadata the " + name + " was turned by " +
                rounded_text(angle, 3) + " degrees (" + m.metadata.source + ")";
              if (by_stage)
                throw InputError(
                  text + ", so that its rows need not run along the axis of "
                         "the stage positions: turn the image upright and "
                         "save it without that angle, or take 'Registration = "
                         "points' without 'Mosaic'");
              context.log.warning(text +
                                  ", which is not allowed for: 'Sliding "
                                  "direction' is taken in the image as it is");
            }
      }

      /** What is stated beside the metadata goes before it. */
      void
      check_pixel_sizes() const
      {
        for (const Micrograph &m : input.images)
          if (const auto &size = m.metadata.pixel_size;
              size && !(std::abs(m.pixel_size / *size - 1.) <= scale_agreement))
            context.log.warning(m.path + ": a pixel is " +
                                rounded_text(m.pixel_size, 4) + " um (" +
                                m.scale_source + "), but by its metadata " +
                                rounded_text(*size, 4) + " um (" +
                                m.metadata.source + "): the first is taken");
      }

      /** Tells how far the points are from where they should be. */
      void
      check_residual(const std::vector<cv::Point2d> &pixels,
                     const std::vector<cv::Point2d> &pad) const
      {
        std::size_t worst = 0;
        const auto  error = [&](const std::size_t i) {
          return cv::norm(input.by_points(pixels[i]) - pad[i]);
        };
        for (std::size_t i = 1; i < pixels.size(); ++i)
          if (error(i) > error(worst))
            worst = i;
        const std::string text =
          "the points of the registration lie " +
          rounded_text(input.by_points.residual, 3) +
          " um (rms) from where 'Transform' takes them, point " +
          std::to_string(worst + 1) + " of " + std::to_string(pixels.size()) +
          " the farthest with " + rounded_text(error(worst), 3) + " um";
        const double cell = 1e3 * std::min(p.pad_size[0] / p.cells[0],
                                           p.pad_size[1] / p.cells[1]);
        if (input.by_points.residual > largest_residual * cell)
          context.log.warning(text +
                              ": cracks come into wrong cells, which "
                              "are " +
                              rounded_text(cell, 3) +
                              " um wide; check 'Image points' and 'Pad "
                              "points'");
        else
          context.log.info("  " + text);
      }

      /** One set of points belongs to one image, and both ways to tell the
       * size of a pixel have to agree. */
      void
      place_by_points()
      {
        const std::vector<Micrograph> &images = input.images;
        if (images.size() > 1 && !p.mosaic)
          throw InputError(
            "Segmentation/Registration = points: one set of 'Image points' is "
            "for one image, and there are " +
            std::to_string(images.size()) +
            ": run each by itself, or take 'Registration = stage'");
        const auto pixels = points_of(p.image_points, 1.),
                   pad    = points_of(p.pad_points, 1e3);
        input.by_points   = fit_placement(pixels, pad, p.transform);
        check_residual(pixels, pad);
        const double by_registration = std::sqrt(middle_pixel().area());
        const double stated          = images[0].pixel_size;
        if (!(std::abs(by_registration / stated - 1.) <= scale_agreement))
          throw InputError(images[0].path + ": a pixel is " +
                           rounded_text(stated, 4) + " um (" +
                           images[0].scale_source +
                           "), but by 'Image points' and 'Pad points' " +
                           rounded_text(by_registration, 4) +
                           " um: one of them is wrong (pixels, mm on the pad)");
      }

      /** By points, at the middle of the image. */
      PixelOnPad
      middle_pixel() const
      {
        return {input.by_points,
                0.5 * cv::Point2d(input.images[0].frame.size())};
      }

      /** Only points tell the shape of pixels that are no squares. */
      void
      require_square_pixels() const
      {
        const bool has_shape =
          p.registration == R::points && p.transform != T::similarity;
        for (const Micrograph &m : input.images)
          if (const double aspect = m.metadata.aspect;
              !has_shape && aspect != 1.)
            throw InputError(
              m.path + ": its pixels are " + rounded_text(aspect, 4) +
              " times as high as wide (" + m.metadata.source +
              "): scale the picture to square pixels, or take 'Registration = "
              "points' with 'Transform = affine'");
        if (!has_shape)
          return;
        const double stretch = middle_pixel().stretch();
        if (stretch - 1. < square_agreement)
          return;
        const std::string text = input.images[0].path +
                                 ": by 'Image points' its pixels are no "
                                 "squares but stretched by " +
                                 rounded_text(stretch, 3);
        if (p.view == SegmentationParameters::View::section)
          throw InputError(text + ", which the depths of a section do not "
                                  "allow for: scale the picture to square "
                                  "pixels");
        context.log.info("  " + text + ": all figures are those on the pad");
      }

      /** The marks of each image. */
      void
      read_masks(const std::vector<std::string>  &names,
                 const std::string               &entry,
                 std::vector<std::vector<Marks>> &marks) const
      {
        std::vector<std::string> paths;
        for (const Micrograph &m : input.images)
          paths.push_back(m.path);
        const auto assigned = assign_masks(expand_names(names, entry), paths);
        marks.resize(paths.size());
        for (std::size_t i = 0; i < paths.size(); ++i)
          {
            for (const RaterMask &mask : assigned[i])
              marks[i].push_back({mask.rater, marks_of(mask, i)});
            if (!names.empty() && marks[i].empty())
              context.log.warning(paths[i] + " has no file among '" + entry +
                                  "': what is stated is squeal's own finding");
          }
      }

      cv::Mat
      marks_of(const RaterMask &mask, const std::size_t i) const
      {
        const Micrograph &image = input.images[i];
        const cv::Mat     marks =
          read_mask(mask.path,
                    image,
                    p.mask_value,
                    context.parameters.images.largest_image);
        context.log.info("  " + mask.path + ": marks of '" + mask.rater +
                         "' in " + image.path);
        if (cv::countNonZero(marks) == 0)
          context.log.warning(mask.path +
                              ": nothing is marked in it, which is taken for "
                              "'there is none'");
        return marks;
      }

      Context                      &context;
      const SegmentationParameters &p;
      SegmentationInput             input;
    };
  } // namespace



  Placement
  SegmentationInput::placement_of(const Micrograph             &m,
                                  const SegmentationParameters &p) const
  {
    if (p.registration == R::points)
      return by_points;
    if (p.registration == R::stage)
      return place_by_stage(m);
    const double s = m.pixel_size;
    return {cv::Matx33d(s,
                        0.,
                        -0.5 * s * m.frame.width,
                        0.,
                        s,
                        -0.5 * s * m.frame.height,
                        0.,
                        0.,
                        1.),
            0.};
  }



  SegmentationInput
  read_segmentation_input(Context &context)
  {
    Timers::Section section(context.timers, "Setup: read images");
    return Reader(context)();
  }



  void
  check_place(const Micrograph &m, const Placement &placement, Context &context)
  {
    const std::vector<double> &edges = context.parameters.segmentation.pad_size;
    const double               share =
      share_on_pad(m.frame.size(), placement, {1e3 * edges[0], 1e3 * edges[1]});
    if (share <= 0.)
      {
        const cv::Point2d middle = placement(0.5 * cv::Point2d(m.frame.size()));
        throw InputError(m.path + " lies off the pad, its middle at " +
                         rounded_text(1e-3 * middle.x, 4) + ", " +
                         rounded_text(1e-3 * middle.y, 4) +
                         " mm: the pad has its middle at 0, 0 and the edges "
                         "of 'Segmentation/Pad size'; check that and the "
                         "registration");
      }
    if (1. - share > least_outside)
      context.log.warning(m.path + ": " + rounded_text(100. - 100. * share, 2) +
                          " % of the image lie outside the pad of 'Pad size' "
                          "and are in no cell");
  }
} // namespace squeal::tribology
