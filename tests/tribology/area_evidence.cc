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

#include <algorithm>
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



  /** An even floor of pits has the higher peak of the histogram also where it
   * is the smaller part: the brighter level is the surface. Where it is the
   * larger part, the error holds that it came off. */
  void
  check_large_pits()
  {
    check_shown(disc({200, 150}, 122), "a pit of 39 % of the image");
    cv::Mat pits = cv::Mat::zeros(size, CV_8U);
    for (int y = 30; y < size.height; y += 60)
      for (int x = 25; x < size.width; x += 50)
        cv::circle(pits, {x, y}, 20, 255, cv::FILLED);
    check_shown(pits, "many pits of 42 % of the image");
    const cv::Mat         pit = disc({200, 150}, 145);
    const ImageStatistics s   = measure(segmentation_of(pit, 0.4, 1.), 1., {});
    const double          is  = cv::countNonZero(pit) / double(pit.total());
    std::printf("a pit of %.1f %%: stated %.1f +- %.1f %%\n",
                100. * is,
                100. * s.exfoliation_fraction,
                100. * s.exfoliation_fraction_error);
    check(s.bulk_is_darker && std::abs(s.darker_level_fraction - is) < 0.02,
          "the darker of two levels with the larger part is known");
    check(!s.shows_exfoliations() &&
            s.exfoliation_fraction + 2. * s.exfoliation_fraction_error >= is,
          "and the error holds that it came off");
    const ImageStatistics shade =
      measure(segmentation_of(disc({200, 150}, 120), 0.4, 30.), 1., {});
    check(shade.darker_level_fraction == 0.,
          "a large shade has no rim and makes no two levels");
  }



  /** A dark band may be a crack too wide to be found, what lies along the
   * border and what is as wide as long are none. */
  void
  check_bands()
  {
    const auto band_of = [](const cv::Mat &mask) {
      const Segmentation s = segmentation_of(mask, 0.4, 1.);
      ExcludedLine       band;
      for (const ExcludedLine &line : s.excluded)
        if (line.reason == Exclusion::wide)
          band = line;
      const double error = 1e3 * measure(s, 1., {}).crack_length_error;
      std::printf("dark band %.1f px wide, %zu px long, error of the length "
                  "%.0f px\n",
                  band.width,
                  band.pixels.size(),
                  error);
      return std::pair(band, error);
    };
    const auto [crack, error] = band_of(bar({60, 140, 280, 14}));
    check(std::abs(crack.width - 14.) < 2., "a wide crack has its width");
    check(2. * error > 280., "and the error of the length holds it");
    check(band_of(bar({0, 0, 16, 300})).first.width == 0.,
          "the border of a specimen is no band");
    check(band_of(disc({200, 150}, 30)).first.width == 0., "nor is a pit");
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
    cv::Mat most = surface();
    darken(most, disc({200, 150}, 130), -0.2, 1.);
    run(most, "most");
    const std::string log = text_of("most/run.log");
    check(log.find("two levels of brightness") != std::string::npos,
          "two levels are stated");
    check(log.find("any up to 100 %") != std::string::npos,
          "no share is more than the whole");
    cv::Mat band = surface();
    darken(band, bar({60, 140, 280, 14}), 0.4, 1.);
    const auto lines = run(band, "band").at("cracks").at("excluded");
    check(std::any_of(lines.begin(),
                      lines.end(),
                      [](const auto &line) {
                        return line.at("reason") == "wide dark band";
                      }),
          "the record lists a dark band");
    check(text_of("band/run.log").find("a dark band 1") != std::string::npos,
          "and the log states its width");
    run(cv::Mat(size, CV_32F, cv::Scalar(255.)), "blank");
    check(text_of("blank/run.log").find("one value, 255") != std::string::npos,
          "an image of one value shows nothing");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument: the program");
  program = argv[1];
  cv::setNumThreads(1);
  check_drawn_areas();
  check_large_pits();
  check_bands();
  check_plateau();
  check_statements();
  return 0;
}
