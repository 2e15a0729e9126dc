// SPDX-License-Identifier: LGPL-2.1-or-later

// What an image does not show is no area without cracks: holes of a mosaic,
// transparent pixels and black borders. Argument: the program.
#include "../analyses/program.h"

#include <squeal/results/table.h>
#include <squeal/tribology/images/areas.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/seen_pixels.h>
#include <squeal/tribology/images/specimen.h>

#include <nlohmann/json.hpp>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  std::string program;

  nlohmann::json
  run(const std::string &text)
  {
    write_text("test.prm",
               "set Analysis = segmentation\nset Overwrite = true\n"
               "set Output directory = out\n" +
                 text);
    const Outcome outcome = run_program({program, "test.prm"});
    check(outcome.code == 0, "the program ends well: " + outcome.errors);
    return nlohmann::json::parse(text_of("out/segmentation.json"))
      .at("images")
      .at(0);
  }



  cv::Mat
  worn_surface()
  {
    SpecimenSettings settings;
    settings.seed          = 3;
    settings.width         = 512.;
    settings.height        = 400.;
    settings.crack_density = 40.;
    settings.data_bar      = false;
    return make_specimen(settings).image;
  }



  /** The same surface, of which a picture shows more than there is. */
  void
  check_same(const nlohmann::json &found,
             const nlohmann::json &whole,
             const std::string    &name)
  {
    const double area = whole.at("observed_area_mm2");
    check_close(found.at("observed_area_mm2").get<double>(),
                area,
                0.02,
                name + ": the area that is seen");
    const auto &a = found.at("cracks"), &b = whole.at("cracks");
    check_close(a.at("length_density_per_mm").get<double>(),
                b.at("length_density_per_mm").get<double>(),
                0.05,
                name + ": length over area");
    const auto &pits = found.at("exfoliation"), &all = whole.at("exfoliation");
    // A pit at the edge counts or not by the share of its outline there.
    check(std::abs(pits.at("area_fraction").get<double>() -
                   all.at("area_fraction").get<double>()) <
            2. * std::hypot(pits.at("area_fraction_error").get<double>(),
                            all.at("area_fraction_error").get<double>()),
          name + ": share of exfoliations");
    const Table  cells   = read_csv("out/cells.csv");
    unsigned int n_wrong = 0;
    for (std::size_t i = 0; i < cells.n_rows(); ++i)
      n_wrong += cells.is_missing(i, "crack_density_per_m") !=
                 (cells.real(i, "coverage") == 0.);
    check(n_wrong == 0, name + ": a density where something is seen, no other");
  }



  void
  check_borders(const cv::Mat &image)
  {
    write_png("whole.png", image);
    const std::string scale = "set Pixel size = 1\n";
    const auto        whole = run("set Images = whole.png\n" + scale);
    cv::Mat           wide  = cv::Mat::zeros(400, 768, CV_8U);
    image.copyTo(wide(cv::Rect(0, 0, 512, 400)));
    write_png("black.png", wide);
    check_same(run("set Images = black.png\n" + scale), whole, "black border");
    check(unbroken(text_of("out/run.log")).find("taken for a border") !=
            std::string::npos,
          "a black border has a warning");
    cv::Mat alpha = cv::Mat::zeros(wide.size(), CV_8U);
    alpha(cv::Rect(0, 0, 512, 400)).setTo(255);
    cv::Mat white = wide.clone(), layers;
    white.setTo(255, ~alpha);
    cv::merge(std::vector<cv::Mat>{white, white, white, alpha}, layers);
    cv::imwrite("transparent.png", layers);
    check_same(
      run("set Images = transparent.png\n" + scale), whole, "transparent");
    const cv::Mat turn = cv::getRotationMatrix2D({256., 200.}, 20., 1.) +
                         (cv::Mat_<double>(2, 3) << 0., 0., 60., 0., 0., 80.);
    cv::Mat turned;
    cv::warpAffine(image, turned, turn, cv::Size(640, 560));
    write_png("turned.png", turned);
    check_same(run("set Images = turned.png\n" + scale), whole, "turned");
  }



  /** Of a strip that is narrower than the cells of the shading nothing tells
   * it, and it is measured all the same. */
  void
  check_strips()
  {
    cv::Mat grey(330, 400, CV_32F, cv::Scalar(120.));
    cv::RNG(7).fill(grey, cv::RNG::NORMAL, 120., 5.);
    SeenPixels strip = cv::Mat::zeros(grey.size(), CV_8U);
    cv::line(strip, {0, 100}, {399, 130}, 255, 3);
    check(cv::checkRange(flatten_illumination(grey, strip)),
          "no shading of a strip");
    const AreaMap map =
      find_areas(grey, cv::Mat::zeros(grey.size(), CV_8U), {}, strip);
    check(cv::countNonZero(map.exfoliation & ~strip) == 0 &&
            std::isfinite(map.exfoliation_error),
          "nor areas beside it");
    cv::Mat layers, bytes, alpha = strip;
    grey.convertTo(bytes, CV_8U);
    cv::merge(std::vector<cv::Mat>{bytes, bytes, bytes, alpha}, layers);
    cv::imwrite("strip.png", layers);
    check_close(run("set Images = strip.png\nset Pixel size = 1\n")
                  .at("observed_area_mm2")
                  .get<double>(),
                1e-6 * cv::countNonZero(strip),
                1e-9,
                "the area of a strip");
  }



  /** Two views that touch at a corner. */
  void
  check_mosaic(const cv::Mat &image)
  {
    const auto save = [](const std::string &name,
                         const cv::Mat     &view,
                         const std::string &x,
                         const std::string &y) {
      write_png(name,
                view,
                "Pixel size = 1 um\nStage x = " + x + " um\nStage y = " + y +
                  " um\n");
    };
    cv::Mat other;
    cv::rotate(image, other, cv::ROTATE_180);
    save("view_1.png", image, "-256", "-200");
    save("view_2.png", other, "256", "200");
    const std::string text =
      "set Images = view_?.png\nset Pixel size = 0\n"
      "subsection Segmentation\n"
      "  set Registration = stage\n"
      "  set Pad size = 1.024, 0.8\n  set Cells = 8, 8\n";
    run(text + "end\n");
    const Table apart  = read_csv("out/cells.csv");
    const auto  joined = run(text + "  set Mosaic = true\nend\n");
    const Table cells  = read_csv("out/cells.csv");
    check_close(joined.at("observed_area_mm2").get<double>(),
                2. * 0.512 * 0.4,
                1e-9,
                "the holes of a mosaic are no area");
    check(joined.at("plateaus").at("area_fraction") < 0.1,
          "and lend their darkness to no plateaus");
    double       sum = 0., sum_apart = 0.;
    unsigned int n_other = 0;
    for (std::size_t i = 0; i < cells.n_rows(); ++i)
      {
        n_other += cells.real(i, "coverage") != apart.real(i, "coverage") ||
                   cells.is_missing(i, "crack_density_per_m") !=
                     apart.is_missing(i, "crack_density_per_m");
        if (apart.is_missing(i, "crack_density_per_m"))
          continue;
        sum += cells.real(i, "crack_density_per_m");
        sum_apart += apart.real(i, "crack_density_per_m");
      }
    check(n_other == 0,
          "the same coverage as view by view, no density where it is none");
    check_close(sum, sum_apart, 0.05, "the same density as view by view");
  }



  void
  check_black_parts()
  {
    cv::Mat grey(200, 300, CV_32F, cv::Scalar(100.));
    grey(cv::Rect(0, 90, 300, 5)).setTo(0.);
    grey(cv::Rect(100, 20, 40, 40)).setTo(0.);
    check(inside_black_border(grey).empty(),
          "neither a black crack nor a black pit inside is a border");
    grey(cv::Rect(250, 0, 50, 200)).setTo(0.);
    const SeenPixels seen = inside_black_border(grey);
    check(!seen.empty() && seen.at<uchar>(40, 120) != 0 &&
            seen.at<uchar>(10, 200) != 0 && seen.at<uchar>(10, 260) == 0,
          "a black strip at the edge is one, and nothing else");
    cv::Mat1f ramp(40, 60);
    for (int x = 0; x < ramp.cols; ++x)
      ramp.col(x).setTo(float(x));
    SeenPixels left(ramp.size(), CV_8U, cv::Scalar(255));
    left.colRange(40, 60).setTo(0);
    const cv::Mat1f filled = mirrored_beyond(ramp, left);
    check(filled(20, 45) == 33.F && filled(20, 30) == 30.F,
          "what is not seen is the mirror image of what is");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program = argv[1];
  cv::setNumThreads(1);
  check_black_parts();
  check_strips();
  const cv::Mat image = worn_surface();
  check_mosaic(image);
  check_borders(image);
  return 0;
}
