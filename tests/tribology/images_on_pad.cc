// SPDX-License-Identifier: LGPL-2.1-or-later

// What the metadata of images say of their place, scale and range, through the
// program. Argument: the program.
#include "../analyses/program.h"

#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/specimen.h>

#include <opencv2/core.hpp>

#include <fstream>

#include "tiff_file.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  std::string program;

  /** Writes a TIFF of 16 bit with pixels of 1 um and tags of FEI. */
  void
  write_tiff(const std::string &name,
             const cv::Mat     &values,
             const cv::Point2d &stage,
             const std::string &more = "")
  {
    std::ofstream(name, std::ios::binary)
      << tiff_file({{values,
                     1,
                     0,
                     34682,
                     "[Stage]\r\nStageX=" + std::to_string(1e-6 * stage.x) +
                       "\r\nStageY=" + std::to_string(1e-6 * stage.y) +
                       "\r\n[Scan]\r\nPixelWidth=1e-6\r\n" + more}});
  }



  Outcome
  outcome_of(const std::string &images, const std::string &more)
  {
    write_text("test.prm",
               "set Analysis = segmentation\nset Overwrite = true\n"
               "set Output directory = out\nset Images = " +
                 images + "\n" + more);
    return run_program({program, "test.prm"});
  }



  void
  check_refused(const std::string &images,
                const std::string &more,
                const std::string &word)
  {
    const Outcome outcome = outcome_of(images, more);
    check(outcome.code != 0 && outcome.errors.find(word) != std::string::npos,
          images + " is refused with '" + word + "': " + outcome.errors);
  }



  /** Runs and looks for a word in the warnings of the log. */
  void
  check_warning(const std::string &images,
                const std::string &more,
                const std::string &word,
                const bool         is_there = true)
  {
    const Outcome outcome = outcome_of(images, more);
    check(outcome.code == 0, images + " is read: " + outcome.errors);
    const std::string log = unbroken(text_of("out/run.log"));
    check((log.find(word) != std::string::npos) == is_there,
          images + (is_there ? " has" : " has not") + " the warning '" + word +
            "'");
  }



  const char *const on_pad = "subsection Segmentation\n"
                             "  set Registration = stage\n"
                             "  set Pad size = 0.4, 0.3\n  set Cells = 4, 3\n";



  void
  check_places(const cv::Mat &picture)
  {
    const std::string pad = std::string(on_pad) + "end\n";
    write_tiff("on.tif", picture, {0., 0.});
    check_warning("on.tif", pad, "outside the pad", false);
    write_tiff("partly.tif", picture, {100., 0.});
    check_warning("partly.tif", pad, "25 % of the image lie outside the pad");
    write_tiff("off.tif", picture, {50000., 20000.});
    check_refused("off.tif", pad, "off.tif lies off the pad");
  }



  void
  check_turned(const cv::Mat &picture)
  {
    for (const std::string key : {"StageR", "ScanRotation"})
      {
        write_tiff("turned.tif", picture, {0., 0.}, key + "=1.5708\r\n");
        check_refused("turned.tif",
                      std::string(on_pad) + "end\n",
                      "was turned by 90.0 degrees");
        check_warning("turned.tif", "", "was turned by 90.0 degrees");
      }
  }



  void
  check_scale()
  {
    check_warning(
      "on.tif", "set Pixel size = 2\n", "but by its metadata 1.000 um");
    check_warning(
      "on.tif", "set Pixel size = 1.02\n", "by its metadata", false);
  }



  /** Points of an affine map that one point does not fit: of the four residuals
   * of a least-squares fit each is a quarter of its error. */
  void
  check_residual()
  {
    const std::string points =
      "subsection Segmentation\n  set Registration = points\n"
      "  set Transform = affine\n  set Pad size = 0.4, 0.3\n"
      "  set Image points = 0, 0, 400, 0, 0, 300, 400, 300\n"
      "  set Pad points = -0.2, -0.15, 0.2, -0.15, -0.2, 0.15, 0.2, 0.11\n";
    check_warning("on.tif",
                  points + "  set Cells = 4, 3\nend\n",
                  "cracks come into wrong cells",
                  false);
    check(unbroken(text_of("out/run.log")).find("lie 10.0 um (rms)") !=
            std::string::npos,
          "the residual is in the log");
    check_warning("on.tif",
                  points + "  set Cells = 16, 12\nend\n",
                  "cracks come into wrong cells");
  }



  /** Two frames of one exposure, of which one alone has a bright spot that
   * takes a bit more. */
  void
  check_exposure(const cv::Mat &picture)
  {
    cv::Mat bright = picture.clone();
    bright(cv::Rect(20, 20, 9, 9)).setTo(4000);
    const cv::Rect left(0, 0, 260, 300), right(140, 0, 260, 300);
    write_tiff("frame_1.tif", bright(left), {130., 150.});
    write_tiff("frame_2.tif", bright(right), {270., 150.});
    check_warning("frame_?.tif",
                  "subsection Segmentation\n  set Mosaic = true\nend\n",
                  "times as bright",
                  false);
    const cv::Mat joined = read_grey("out/mosaic.png");
    check(joined.size() == picture.size(), "the size of the picture");
    cv::Mat expected;
    bright.convertTo(expected, CV_32F, 1. / 16.);
    check(cv::norm(joined, expected, cv::NORM_INF) <= 1.,
          "both frames have the range of 12 bits");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program = argv[1];
  cv::setNumThreads(1);
  SpecimenSettings settings;
  settings.data_bar = false;
  cv::Mat picture;
  // 11 bits of 16.
  make_specimen(settings)
    .image(cv::Rect(0, 0, 400, 300))
    .convertTo(picture, CV_16U, 8.);
  check_places(picture);
  check_turned(picture);
  check_scale();
  check_residual();
  check_exposure(picture);
  return 0;
}
