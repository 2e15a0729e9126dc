// SPDX-License-Identifier: LGPL-2.1-or-later

// Mosaics with element maps, and sections, through the program. Argument: the
// program.
#include "../analyses/program.h"

#include <squeal/results/table.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/specimen.h>

#include <nlohmann/json.hpp>

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <filesystem>

#include "tribology/straight_scenes.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  std::string program;

  void
  run(const std::string &text)
  {
    write_text("test.prm",
               "set Analysis = segmentation\nset Overwrite = true\n" + text);
    const Outcome outcome = run_program({program, "test.prm"});
    check(outcome.code == 0, "the program ends well: " + outcome.errors);
  }



  nlohmann::json
  record_of(const std::string &directory)
  {
    return nlohmann::json::parse(text_of(directory + "/segmentation.json"));
  }



  double
  crack_length(const nlohmann::json &record)
  {
    return record.at("images").at(0).at("cracks").at("length_mm");
  }



  /** Four frames of one picture, their stage positions a few um wrong, give
   * what the whole picture gives. */
  void
  check_mosaic()
  {
    SpecimenSettings settings;
    settings.seed       = 31;
    settings.data_bar   = false;
    const cv::Mat whole = make_specimen(settings).image;
    const auto    save =
      [&](const std::string &name, const cv::Rect &part, const cv::Point &off) {
        const cv::Point2d centre =
          cv::Point2d(part.x + 0.5 * part.width + off.x - 512.,
                      part.y + 0.5 * part.height + off.y - 384.);
        write_png(name,
                  whole(part),
                  "Kind = synthetic specimen\nPixel size = 1 um\nStage x = " +
                    std::to_string(centre.x) +
                    " um\nStage y = " + std::to_string(centre.y) + " um\n");
      };
    save("whole.png", {0, 0, 1024, 768}, {0, 0});
    save("frame_1.png", {0, 0, 580, 440}, {0, 0});
    save("frame_2.png", {444, 0, 580, 440}, {3, -2});
    save("frame_3.png", {0, 328, 580, 440}, {-2, 3});
    save("frame_4.png", {444, 328, 580, 440}, {2, 2});
    // An element that becomes more frequent to the right.
    cv::Mat iron(192, 256, CV_8U);
    for (int x = 0; x < iron.cols; ++x)
      iron.col(x).setTo(x);
    write_png("iron.png", iron);
    const std::string pad =
      "subsection Segmentation\n  set Registration = stage\n"
      "  set Pad size = 1.024, 0.768\n  set Cells = 4, 3\n"
      "  set Element maps = iron.png\n";
    run("set Images = whole.png\nset Output directory = whole\n" + pad +
        "end\n");
    run("set Images = frame_?.png\nset Output directory = mosaic\n" + pad +
        "  set Mosaic = true\nend\n");
    write_png("narrow.png", cv::Mat(64, 256, CV_8U, cv::Scalar(9)));
    write_text("narrow.prm",
               "include test.prm\nset Output directory = narrow\n"
               "subsection Segmentation\n"
               "  set Element maps = narrow.png\nend\n");
    const Outcome narrow = run_program({program, "narrow.prm"});
    check(narrow.code != 0 &&
            narrow.errors.find("has its shape") != std::string::npos,
          "a map of another shape is refused: " + narrow.errors);
    // A map of the picture above a data bar that is lower than the tolerance.
    cv::Mat height(756, 1024, CV_8U);
    for (int y = 0; y < height.rows; ++y)
      height.row(y).setTo(y / 3);
    write_png("height.png", height);
    run("set Images = whole.png\nset Output directory = bar\n"
        "subsection Segmentation\n  set Cells = 1, 3\n"
        "  set Data bar = 12\n  set Element maps = height.png\nend\n");
    for (unsigned int i = 0; i < 3; ++i)
      check_close(read_csv("bar/cells.csv").real(i, "height"),
                  41.5 + 84. * i,
                  1e-3,
                  "a map of the picture without its data bar");
    const cv::Mat joined = read_grey("mosaic/mosaic.png");
    check(std::abs(joined.cols - 1024) <= 1 && std::abs(joined.rows - 768) <= 1,
          "the mosaic has the size of the picture");
    const auto a = record_of("whole"), b = record_of("mosaic");
    check(b.at("synthetic").get<bool>(),
          "a mosaic of made images is synthetic");
    check(b.at("mosaic").at("pairs_refined") == 6, "all pairs are aligned");
    check_close(crack_length(b), crack_length(a), 0.05, "length of cracks");
    const auto &cracks = a.at("images").at(0).at("cracks");
    for (const auto &[value, deviation] :
         {std::pair("length_mm", "length_error_mm"),
          std::pair("area_fraction", "area_fraction_error"),
          std::pair("mean_width_um", "mean_width_error_um")})
      check(cracks.at(deviation) > 0. && cracks.at(deviation).get<double>() <
                                           0.3 * cracks.at(value).get<double>(),
            std::string(value) + " carries its error");
    check_close(
      read_csv("whole/segmentation.csv").real(0, "crack_length_error_m"),
      1e-3 * cracks.at("length_error_mm").get<double>(),
      1e-2,
      "the same error in the table");
    const Table cells = read_csv("mosaic/cells.csv"),
                other = read_csv("whole/cells.csv");
    check(cells.n_rows() == 12 && cells.text(0, "image") == "pad",
          "cells of the pad");
    check(cells.integer(0, "synthetic") == 1 &&
            cells.real(0, "sliding_x") == 0. &&
            cells.real(0, "sliding_y") == 1.,
          "they say that the image is made and what angles are against");
    double difference = 0., sum = 0.;
    for (std::size_t i = 0; i < 12; ++i)
      {
        check(std::abs(cells.real(i, "iron") - (32. + 64. * (i % 4))) < 2.,
              "element map of cell " + std::to_string(i));
        difference += std::abs(cells.real(i, "crack_density_per_m") -
                               other.real(i, "crack_density_per_m"));
        sum += other.real(i, "crack_density_per_m");
      }
    check(difference < 0.1 * sum, "cracks lie in the same cells");
  }



  /** Images and made specimens have a report, in units that are read at a
   * glance, with its pictures inside. */
  void
  check_reports()
  {
    const auto shows = [](const std::string              &directory,
                          const std::vector<std::string> &texts) {
      const std::string report = text_of(directory + "/report.html");
      for (const std::string &text : texts)
        check(report.find(text) != std::string::npos,
              "the report of " + directory + " has '" + text + "'");
    };
    shows("whole",
          {"mm per mm^2",
           "How sure the figures are",
           "What was left out",
           "data:image/png;base64,",
           "whole (made)"});
    write_text("made.prm",
               "set Analysis = synthetic specimen\nset Overwrite = true\n"
               "set Output directory = made\nsubsection Synthetic specimen\n"
               "  set Field = 300, 200\nend\n");
    const Outcome outcome = run_program({program, "made.prm"});
    check(outcome.code == 0, "specimens are made: " + outcome.errors);
    shows("made", {"not photographed", "crack length", "data:image/png"});
    write_text("quiet.prm",
               "include made.prm\nset Output directory = quiet\n"
               "subsection Output\n  set Report = false\nend\n");
    check(run_program({program, "quiet.prm"}).code == 0, "or without a report");
    check(!std::filesystem::exists("quiet/report.html"), "which is not there");
  }



  /** Resin, a bright layer of 40 um, bulk, and cracks 100 um deep. */
  void
  check_section()
  {
    cv::Mat grey(500, 640, CV_32F, cv::Scalar(110.));
    for (int x = 0; x < grey.cols; ++x)
      {
        const int surface = 80 + cvRound(10. * std::sin(x / 60.));
        grey(cv::Rect(x, surface, 1, 40)).setTo(170.);
        grey(cv::Rect(x, 0, 1, surface)).setTo(15.);
      }
    double length = 0.;
    for (int x = 60; x < 640; x += 80)
      {
        const int                top = 80 + cvRound(10. * std::sin(x / 60.));
        std::vector<cv::Point2d> line;
        for (int i = 0; i <= 25; ++i)
          line.emplace_back(x + 5. * std::sin(0.45 * i), top + 4. * i);
        for (int i = 0; i < 25; ++i)
          {
            cv::line(grey, line[i], line[i + 1], 40., 2);
            length += cv::norm(line[i + 1] - line[i]);
          }
      }
    cv::Mat noise(grey.size(), CV_32F);
    cv::RNG(3).fill(noise, cv::RNG::NORMAL, 0., 6.);
    cv::Mat bytes;
    cv::Mat(grey + noise).convertTo(bytes, CV_8U);
    write_png("cut.png", bytes);
    run("set Images = cut.png\nset Pixel size = 1\n"
        "set Output directory = section\nsubsection Segmentation\n"
        "  set View = section\n  set Depth band = 25\nend\n");
    const auto record = record_of("section");
    check(!record.at("synthetic").get<bool>(), "nothing says it is synthetic");
    check_close(
      record.at("images").at(0).at("third_body_layer_um").at(1).get<double>(),
      40.,
      0.05,
      "thickness of the layer");
    const Table depths = read_csv("section/cut_depth.csv");
    double      above = 0., below = 0.;
    for (std::size_t i = 0; i < depths.n_rows(); ++i)
      (depths.real(i, "depth_m") < 125e-6 ? above : below) +=
        depths.real(i, "crack_length_m");
    check_close(above, 1e-6 * length, 0.15, "length of cracks by depth");
    check(below < 0.03 * above, "no crack deeper than they go");
    double area = 0.;
    for (std::size_t i = 0; i < depths.n_rows(); ++i)
      area += depths.real(i, "area_m2");
    const auto &image = record.at("images").at(0);
    check_close(image.at("observed_area_mm2").get<double>(),
                1e6 * area,
                1e-3,
                "the resin is no part of the specimen");
    check_close(image.at("cracks").at("length_density_per_mm").get<double>(),
                1e-3 * (above + below) / area,
                0.02,
                "nor of what lengths are over");
    check(image.at("exfoliation").at("without_rim_fraction") < 0.02,
          "nor is it a dark place");
    const Table cells = read_csv("section/cells.csv");
    double      seen  = 0.;
    for (std::size_t i = 0; i < cells.n_rows(); ++i)
      seen += cells.real(i, "coverage") / double(cells.n_rows());
    check_close(seen * 640. * 500. * 1e-12, area, 0.02, "cells cover as much");
  }



  /** A straight line from border to border may be a groove. */
  void
  check_line_through_the_image()
  {
    for (const bool is_through : {true, false})
      {
        cv::RNG random(910000U);
        cv::Mat grey = grainy_surface(random), bytes;
        darken_line(grey,
                    {is_through ? -20. : 120., 240.},
                    {is_through ? 532. : 420., 260.},
                    4.,
                    70.);
        grey.convertTo(bytes, CV_8U);
        write_png("line.png", bytes);
        run("set Images = line.png\nset Pixel size = 1\n"
            "set Output directory = line\n"
            "subsection Segmentation\n  set Data bar = 0\nend\n");
        check(crack_length(record_of("line")) > 0.25, "the line is found");
        const std::string log = unbroken(text_of("line/run.log"));
        check((log.find("straight lines from border to border") !=
               std::string::npos) == is_through,
              is_through ? "it may be a groove, which is said"
                         : "one that ends inside has no warning");
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program = argv[1];
  cv::setNumThreads(1);
  check_mosaic();
  check_reports();
  check_section();
  check_line_through_the_image();
  return 0;
}
