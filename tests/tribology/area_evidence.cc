// SPDX-License-Identifier: LGPL-2.1-or-later

// Areas that an image shows, and areas that rest on nothing but brightness:
// drawn ones, and what the program states of both. Argument: the program.
#include "../analyses/program.h"

#include <squeal/results/table.h>
#include <squeal/tribology/images/area_evidence.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/statistics.h>

#include <nlohmann/json.hpp>

#include <opencv2/imgproc.hpp>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  std::string program;

  const cv::Size size(400, 300);

  /** A surface of brightness 128 with fine grain. */
  cv::Mat
  surface()
  {
    cv::Mat grey(size, CV_32F, cv::Scalar(128.)), grain(size, CV_32F);
    cv::RNG(11).fill(grain, cv::RNG::NORMAL, 0., 4.);
    return grey + grain;
  }



  /** Darkens @p grey by a share where @p mask (CV_8U) is set, its edge smoothed
   * by a deviation in pixels. */
  void
  darken(cv::Mat       &grey,
         const cv::Mat &mask,
         const double   share,
         const double   edge)
  {
    cv::Mat weight;
    mask.convertTo(weight, CV_32F, share / 255.);
    cv::GaussianBlur(weight, weight, cv::Size(), edge);
    grey -= grey.mul(weight);
  }



  cv::Mat
  disc(const cv::Point &centre, const int radius)
  {
    cv::Mat mask = cv::Mat::zeros(size, CV_8U);
    cv::circle(mask, centre, radius, 255, cv::FILLED);
    return mask;
  }



  cv::Mat
  bar(const cv::Rect &box)
  {
    cv::Mat mask = cv::Mat::zeros(size, CV_8U);
    mask(box).setTo(255);
    return mask;
  }



  Segmentation
  segmentation_of(const cv::Mat &mask, const double share, const double edge)
  {
    cv::Mat grey = surface();
    darken(grey, mask, share, edge);
    return segment(grey);
  }



  /** An area with a rim is found, and its error holds the true one. */
  void
  check_shown(const cv::Mat &mask, const std::string &what)
  {
    const ImageStatistics s  = measure(segmentation_of(mask, 0.4, 1.), 1., {});
    const double          is = cv::countNonZero(mask) / double(mask.total());
    std::printf("%s: %.3f %%, stated %.3f +- %.3f %%\n",
                what.c_str(),
                100. * is,
                100. * s.exfoliation_fraction,
                100. * s.exfoliation_fraction_error);
    check(s.shows_exfoliations(), what + " is found");
    check(std::abs(s.exfoliation_fraction - is) <=
            2. * s.exfoliation_fraction_error,
          "and has its area within two deviations");
  }



  /** A dark place that may be anything is stated as no area, but counts. */
  void
  check_not_shown(const cv::Mat     &mask,
                  const double       share,
                  const double       edge,
                  const std::string &what)
  {
    const ImageStatistics s =
      measure(segmentation_of(mask, share, edge), 1., {});
    std::printf("%s: stated %.3f +- %.3f %%, dark without a rim %.3f %%\n",
                what.c_str(),
                100. * s.exfoliation_fraction,
                100. * s.exfoliation_fraction_error,
                100. * s.unsettled_fraction);
    check(!s.shows_exfoliations(), what + " is no exfoliation");
    check(s.unsettled_fraction > 0.01, "but a dark place of some share");
    check(s.exfoliation_fraction_error >= 0.25 * s.unsettled_fraction,
          "which the error of the area holds");
  }



  void
  check_drawn_areas()
  {
    check_shown(disc({200, 150}, 30), "a pit");
    check_shown(disc({120, 100}, 18) | disc({280, 200}, 24), "two pits");
    check_not_shown(disc({200, 150}, 45), 0.5, 20., "a place in the shade");
    check_not_shown(bar({60, 140, 280, 14}), 0.4, 1., "a band of grooves");
    check_not_shown(bar({0, 0, 16, 300}), 0.4, 1., "the border of a specimen");
    const ImageStatistics none = measure(segment(surface()), 1., {});
    check(none.exfoliation_fraction == 0. && !none.shows_exfoliations() &&
            none.exfoliation_fraction_error > 0.,
          "nothing is 0, but not for certain");
  }



  /** A bright even place is stated with an error as large as itself. */
  void
  check_plateau()
  {
    const ImageStatistics s =
      measure(segmentation_of(disc({200, 150}, 50), -0.2, 1.), 1., {});
    check(s.plateau_fraction > 0.05, "a bright place is listed");
    check(s.plateau_fraction_error >= s.plateau_fraction,
          "with an error that holds that it is none");
  }



  nlohmann::json
  run(const cv::Mat &grey, const std::string &name)
  {
    cv::Mat bytes;
    grey.convertTo(bytes, CV_8U);
    write_png(name + ".png", bytes);
    write_text("test.prm",
               "set Analysis = segmentation\nset Overwrite = true\n"
               "set Pixel size = 1\nset Images = " +
                 name + ".png\nset Output directory = " + name + "\n");
    const Outcome outcome = run_program({program, "test.prm"});
    check(outcome.code == 0, "the program ends well: " + outcome.errors);
    return nlohmann::json::parse(text_of(name + "/segmentation.json"))
      .at("images")
      .at(0);
  }



  /** Log, table, record and report state that there is no evidence, and up to
   * which length a crack is not excluded. */
  void
  check_statements()
  {
    cv::Mat shaded = surface();
    darken(shaded, disc({200, 150}, 45), 0.5, 20.);
    const auto record = run(shaded, "shaded");
    check(!record.at("exfoliation").at("is_shown").get<bool>(),
          "the record states that none is shown");
    const Table  table = read_csv("shaded/segmentation.csv");
    const double dark  = table.real(0, "without_rim_fraction");
    check(dark > 0.01 && table.real(0, "exfoliation_fraction") == 0. &&
            table.real(0, "exfoliation_fraction_error") >= 0.25 * dark,
          "the table has no area with a small error");
    for (const char *file : {"report.html", "run.log"})
      {
        const std::string text = text_of(std::string("shaded/") + file);
        check(text.find("shaded: no evidence of exfoliations") !=
                std::string::npos,
              std::string(file) + " states that there is no evidence");
      }
    const std::string report = text_of("shaded/report.html");
    check(report.find("none shown, up to") != std::string::npos,
          "figures of the report state what is not excluded");
    check(report.find("no crack found in 1 image (0 +- ") !=
              std::string::npos &&
            report.find("mm are not excluded") != std::string::npos,
          "nor are short cracks");
    cv::Mat pit = surface();
    darken(pit, disc({200, 150}, 30), 0.4, 1.);
    check(run(pit, "pit").at("exfoliation").at("is_shown").get<bool>() &&
            text_of("pit/run.log").find("no evidence of exfoliations") ==
              std::string::npos,
          "a pit is stated as one");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument: the program");
  program = argv[1];
  cv::setNumThreads(1);
  check_drawn_areas();
  check_plateau();
  check_statements();
  return 0;
}
