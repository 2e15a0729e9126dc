// SPDX-License-Identifier: LGPL-2.1-or-later

// The size of pixels by scale bars, and by metadata of a picture of another
// size.
#include "../analyses/program.h"

#include <squeal/base/exceptions.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/micrograph.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>

#include "tiff_file.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  /** A bar of 200 pixels, 6 high, in a data bar: bright on dark or dark on
   * bright, as long as the box holds its ends. */
  void
  check_scale_bars()
  {
    for (const bool bright : {true, false})
      {
        cv::Mat grey(512, 640, CV_32F, cv::Scalar(100.));
        grey.rowRange(480, 512).setTo(bright ? 10. : 250.);
        grey(cv::Rect(100, 500, 200, 6)).setTo(bright ? 250. : 10.);
        const std::string claim =
          std::string(bright ? "bright bar on dark" : "dark bar on bright");
        check_close(
          scale_bar_pixels(grey, {80, 490, 240, 20}, "a"), 200., 1e-12, claim);
        for (const cv::Rect &box : {cv::Rect(150, 490, 100, 20),
                                    cv::Rect(150, 490, 240, 20),
                                    cv::Rect(60, 490, 240, 20)})
          check_throws<InputError>([&]() { scale_bar_pixels(grey, box, "a"); },
                                   "border",
                                   claim + " that the box cuts");
        check_throws<InputError>(
          [&]() {
            scale_bar_pixels(grey, {400, 490, 200, 20}, "a");
          },
          "no bar",
          "no bar where there is none");
      }
  }

  /** A bar of 200 pixels from tick to tick whose label stands between its
   * halves; several bars beside one another are none. */
  void
  check_labelled_scale_bars()
  {
    const cv::Rect box(80, 484, 260, 26);
    const auto     bar = [](const int left, const int right) {
      cv::Mat grey(512, 640, CV_32F, cv::Scalar(100.));
      grey.rowRange(480, 512).setTo(10.);
      grey(cv::Rect(100, 496, left, 2)).setTo(250.);
      grey(cv::Rect(300 - right, 496, right, 2)).setTo(250.);
      for (const int tick : {100, 299})
        grey(cv::Rect(tick, 490, 1, 14)).setTo(250.);
      return grey;
    };
    for (const int right : {61, 66})
      {
        cv::Mat grey = bar(61, right);
        check_throws<InputError>([&]() { scale_bar_pixels(grey, box, "a"); },
                                 "several bars",
                                 "two bars without a label between them");
        cv::putText(grey, "100 um", {170, 501}, 0, 0.4, 250.);
        check_close(scale_bar_pixels(grey, box, "a"),
                    200.,
                    1e-12,
                    "a bar with its label inside");
      }
    for (const int right : {25, 40})
      {
        cv::Mat grey = bar(61, right);
        cv::putText(grey, "100 um", {170, 501}, 0, 0.4, 250.);
        check_throws<InputError>([&]() { scale_bar_pixels(grey, box, "a"); },
                                 "several bars",
                                 "bars of two lengths");
      }
    cv::Mat below = bar(100, 100);
    cv::putText(below, "100 um", {170, 509}, 0, 0.3, 250.);
    check_close(scale_bar_pixels(below, box, "a"),
                200.,
                1e-12,
                "a whole bar over its label");
  }



  /** An image that is half as large as its metadata say has pixels of twice
   * the size, one with fewer rows alone or cut out has none. */
  void
  check_size_in_metadata()
  {
    for (const char *maker : {"JEOL", "FEI", "Zeiss"})
      {
        const bool is_jeol        = std::string(maker) == "JEOL",
                   is_fei         = std::string(maker) == "FEI";
        const std::string name    = is_jeol ? "sized.png" : "sized.tif";
        const auto        read_of = [&](const cv::Size &size) {
          cv::Mat values(size, CV_8U, cv::Scalar(90));
          values.row(0) = 91; // one value alone would be warned of
          write_text("sized.txt",
                     "$CM_FULL_SIZE 640 480\r\n$$SM_MICRON_BAR 100\r\n"
                            "$$SM_MICRON_MARKER 100um\r\n");
          if (is_jeol)
            write_png(name, values);
          else
            write_text(
              name,
              tiff_file({{values,
                          1,
                          0,
                          is_fei ? 34682u : 34118u,
                          is_fei ? "[Image]\r\nResolutionX=640\r\n"
                                          "ResolutionY=480\r\n[Scan]\r\n"
                                          "PixelWidth=1e-6\r\n"
                                        : "AP_IMAGE_PIXEL_SIZE\r\n"
                                          "Image Pixel Size = 1 um\r\n"
                                          "DP_IMAGE_STORE\r\n"
                                          "Store resolution = 640 * 480\r\n"}}));
          return read_micrograph(name, 0.);
        };
        for (const cv::Size &size :
             {cv::Size(640, 480), cv::Size(640, 512), cv::Size(640, 400)})
          {
            const Micrograph m = read_of(size);
            check_close(m.pixel_size, 1., 1e-12, name + ": as it was taken");
            check(m.warnings.empty(), "without a warning");
          }
        for (const cv::Size &size : {cv::Size(320, 240), cv::Size(213, 160)})
          {
            const Micrograph m = read_of(size);
            check_close(m.pixel_size,
                        640. / size.width,
                        1e-12,
                        name + ": pixels of a reduced image");
            check(*m.metadata.pixel_size == m.pixel_size &&
                    m.warnings.size() == 1 &&
                    m.warnings[0].find("640 x 480") != std::string::npos,
                  "which is told");
          }
        check_throws<InputError>(
          [&]() {
            read_of({500, 450});
          },
          "no smaller or larger copy",
          name + ": a part of an image is refused");
        check_close(read_micrograph(name, 2.).pixel_size,
                    2.,
                    1e-12,
                    "unless its pixel size is given");
      }
  }

  /** What is no picture about a scale bar: the bar with the text beside it, or
   * the whole label that both stand in, but not the surface around. */
  void
  check_place_of_scale_bar()
  {
    for (const bool has_label : {false, true})
      for (const bool is_bright : {false, true})
        {
          cv::RNG random(3);
          cv::Mat grey(600, 800, CV_32F);
          random.fill(grey, cv::RNG::NORMAL, 120., 8.);
          const cv::Rect box(592, 560, 197, 22), label(590, 530, 201, 61);
          if (has_label)
            grey(label).setTo(is_bright ? 0. : 255.);
          const double ink = is_bright ? 255. : 0.;
          grey(cv::Rect(600, 568, 180, 4)).setTo(ink);
          cv::putText(grey, "100 um", {640, 551}, 0, 0.4, ink);
          const cv::Rect place = scale_bar_place(grey, box),
                         all =
                           has_label ? label : box | cv::Rect(640, 541, 45, 10);
          check((place & all) == all, "bar and text are left out");
          check(place.area() < 1.4 * all.area(), "and little more");
        }
    cv::Mat even(600, 800, CV_32F, cv::Scalar(120.));
    even(cv::Rect(600, 568, 180, 4)).setTo(0.);
    check(scale_bar_place(even, {592, 560, 197, 22}).area() < 203 * 29,
          "an even surface is no label");
  }



  /** Where metadata state no size, that is noted. */
  void
  check_note_of_no_size()
  {
    const auto n_notes = [](const std::string &size) {
      write_text("unsized.tif",
                 tiff_file({{cv::Mat(480, 640, CV_8U, cv::Scalar(90)),
                             1,
                             0,
                             34118u,
                             "Image Pixel Size = 1 um\r\n" + size}}));
      const Micrograph m = read_micrograph("unsized.tif", 0.);
      check_close(m.pixel_size, 1., 1e-12, "the size of its pixels is taken");
      unsigned int n = 0;
      for (const std::string &note : m.notes)
        n += note.find("do not state how many pixels") != std::string::npos;
      return n;
    };
    check(n_notes("") == 1 && n_notes("Store resolution = high\r\n") == 1 &&
            n_notes("Store resolution = 640 * 480\r\n") == 0,
          "the log tells where nothing tells copies");
  }



  /** The length of a bar of 100 pixels in a JEOL text, whose unit may stand
   * apart; one in a unit that is not known is no scale, which is told. */
  void
  check_units_of_jeol()
  {
    cv::Mat values(64, 64, CV_8U, cv::Scalar(90));
    values.row(0) = 91;
    write_png("units.png", values);
    const auto size_by = [](const std::string &marker) {
      write_text("units.txt",
                 "$CM_FORMAT JEOL\r\n$$SM_MICRON_BAR 100\r\n"
                 "$$SM_MICRON_MARKER " +
                   marker + "\r\n$CM_MAG 500\r\n");
      return read_micrograph("units.png", 0.).pixel_size;
    };
    const std::pair<const char *, double> known[] = {{"100 nm", 1e-3},
                                                     {"100nm", 1e-3},
                                                     {"500pm", 5e-6},
                                                     {"100", 1.},
                                                     {"0,5um", 5e-3},
                                                     {"50\xb5m", 0.5},
                                                     {"50 \xc2\xb5m", 0.5},
                                                     {"50\xce\xbcm", 0.5},
                                                     {"2 mm", 20.},
                                                     {"2cm", 200.}};
    for (const auto &[marker, size] : known)
      check_close(size_by(marker), size, 1e-12, marker);
    for (const char *marker : {"100NM", "1e2A", "100 inch", "um", ""})
      check_throws<InputError>([&]() { size_by(marker); },
                               "of its JEOL text is no length",
                               std::string("no scale by ") + marker);
    check_close(read_micrograph("units.png", 2.).pixel_size,
                2.,
                1e-12,
                "unless the pixel size is given");
  }



  /** All numbers of a JEOL text may have decimal commas. */
  void
  check_commas_of_jeol()
  {
    cv::Mat values(64, 64, CV_8U, cv::Scalar(90));
    values.row(0) = 91;
    write_png("commas.png", values);
    const auto read_with = [](std::string text) {
      write_text("commas.txt", text);
      const Micrograph m = read_micrograph("commas.png", 0.);
      check(m.metadata.stage.has_value() && m.metadata.size.has_value(),
            "stage and size of the picture");
      return m;
    };
    const std::string text   = "$CM_FULL_SIZE 64 64\r\n"
                               "$CM_STAGE_POS -1.25 2.5 10.5 0 0 0\r\n"
                               "$$SM_SCAN_ROTATION 0.5\r\n"
                               "$$SM_MICRON_BAR 100.5\r\n"
                               "$$SM_MICRON_MARKER 50.25um\r\n";
    std::string       commas = text;
    std::replace(commas.begin(), commas.end(), '.', ',');
    for (const std::string &written : {text, commas})
      {
        const Micrograph m = read_with(written);
        check_close(m.pixel_size, 0.5, 1e-12, "the size of a pixel, um");
        check_close(m.metadata.scan_rotation, 0.5, 1e-12, "the scan, degrees");
        check_close(m.metadata.stage->x, -1250., 1e-12, "the stage, um");
        check_close(m.metadata.stage->y, 2500., 1e-12, "the stage, um");
        check(*m.metadata.size == cv::Size(64, 64), "the size of the picture");
      }
  }



  Micrograph
  with_fei_tags(const std::string &tags, const double pixel_size)
  {
    cv::Mat values(64, 64, CV_8U, cv::Scalar(90));
    values.row(0) = 91;
    write_text("height.tif", tiff_file({{values, 1, 0, 34682u, tags}}));
    return read_micrograph("height.tif", pixel_size);
  }

  /** A height of pixels that is stated and no length leaves their shape
   * open. */
  void
  check_heights_of_fei()
  {
    const std::string width = "[Scan]\r\nPixelWidth=1e-6\r\nPixelHeight=";
    for (const char *height : {"nan", "-1e-6", "0", "inf", "square"})
      {
        check_throws<InputError>(
          [&]() { with_fei_tags(width + height + "\r\n", 0.); },
          "'PixelHeight=" + std::string(height) + "' of its FEI tags",
          std::string("no scale by a height of ") + height);
        check_close(with_fei_tags(width + height + "\r\n", 2.).pixel_size,
                    2.,
                    1e-12,
                    "unless the pixel size is given");
      }
    check_close(with_fei_tags(width + "\r\n", 0.).pixel_size,
                1.,
                1e-12,
                "none is stated");
    check_close(
      with_fei_tags(width + "4e-6\r\n", 0.).metadata.aspect, 4., 1e-12, "high");
  }

  /** Pixels of 1 m come from a wrong unit. */
  void
  check_wide_views()
  {
    const auto warnings_of = [](const std::string &width) {
      return with_fei_tags("[Scan]\r\nPixelWidth=" + width + "\r\n", 0.)
        .warnings;
    };
    check(warnings_of("1e-3").empty(), "a view of 64 mm");
    const auto warnings = warnings_of("1");
    check(warnings.size() == 1 &&
            warnings[0].find("it shows 64.0 m, more than any brake has, by "
                             "pixels of 1.000e+06 um (FEI tags)") == 0,
          "a view of 64 m is warned of: " +
            (warnings.empty() ? "" : warnings[0]));
  }
} // namespace



int
main()
{
  check_units_of_jeol();
  check_commas_of_jeol();
  check_heights_of_fei();
  check_wide_views();
  check_scale_bars();
  check_labelled_scale_bars();
  check_place_of_scale_bar();
  check_size_in_metadata();
  check_note_of_no_size();
  return 0;
}
