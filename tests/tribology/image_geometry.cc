// SPDX-License-Identifier: LGPL-2.1-or-later

// Registration, mosaics, sections and length of lines against known answers.
#include <squeal/base/exceptions.h>
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/frame_overlap.h>
#include <squeal/tribology/images/mosaic.h>
#include <squeal/tribology/images/section_profile.h>
#include <squeal/tribology/images/specimen.h>

#include <opencv2/imgproc.hpp>

#include <array>
#include <cmath>

#include "check.h"
#include "cut_frames.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  using T = SegmentationParameters::Transform;

  /** A dark spot of an image lies in the picture where the pad has it: x to
   * the right, y upwards, as in maps. */
  void
  check_axes_of_pad()
  {
    const double c = std::cos(0.4), s = std::sin(0.4);
    const std::pair<std::string, cv::Matx33d> cases[] = {
      {"by stage, y downwards", {2., 0., -80., 0., 2., 50., 0., 0., 1.}},
      {"y upwards", {2., 0., -80., 0., -2., 50., 0., 0., 1.}},
      {"a quarter turn", {0., 2., 10., -2., 0., 50., 0., 0., 1.}},
      {"mirrored on a diagonal", {0., 2., 10., 2., 0., 50., 0., 0., 1.}},
      {"upside down", {-2., 0., 10., 0., -2., 50., 0., 0., 1.}},
      {"turned by 23 degrees",
       {2. * c, -2. * s, 0., 2. * s, 2. * c, 0., 0., 0., 1.}}};
    for (const auto &[name, matrix] : cases)
      {
        const Placement placement{matrix, 0.};
        cv::Mat1b       image(60, 100, uchar(200));
        const cv::Rect  spot(12, 7, 5, 5);
        image(spot).setTo(0);
        const PadView view = in_axes_of_pad(image, placement);
        check(std::abs(view.pixel_size - 2.) < 1e-12, name + ": pixels");
        cv::Mat1b         dark = view.image < 100;
        const cv::Moments m    = cv::moments(dark, true);
        check(m.m00 > 15. && m.m00 < 36., name + ": one spot");
        const cv::Point2d found(
          view.upper_left.x + view.pixel_size * (m.m10 / m.m00 + 0.5),
          view.upper_left.y - view.pixel_size * (m.m01 / m.m00 + 0.5));
        check(cv::norm(found - placement({14.5, 9.5})) < 0.3,
              name + ": its place in the picture is that on the pad");
      }
    cv::Mat1b corner(60, 100, uchar(200));
    corner(cv::Rect(0, 0, 10, 10)).setTo(0);
    const cv::Mat1b view =
      in_axes_of_pad(corner, {{2., 0., -80., 0., 2., 50., 0., 0., 1.}, 0.})
        .image;
    check(view(view.rows - 1, 0) == 0 && view(0, 0) == 200,
          "what a stage with y downwards has above is below in maps");
  }



  void
  check_transforms()
  {
    const std::vector<cv::Point2d> pixels = {
      {10., 20.}, {900., 40.}, {880., 700.}, {30., 650.}, {400., 300.}};
    const cv::Matx33d turned(1.2, -0.3, 50., 0.3, 1.2, -70., 0., 0., 1.);
    const cv::Matx33d mirrored(1.2, 0.3, 50., 0.3, -1.2, -70., 0., 0., 1.);
    const cv::Matx33d skewed(1.2, 0.2, 50., 0.1, 0.9, -70., 0., 0., 1.);
    const cv::Matx33d tilted(1.2, 0.2, 50., 0.1, 0.9, -70., 1e-5, 2e-5, 1.);
    const std::tuple<T, cv::Matx33d, std::string> cases[] = {
      {T::similarity, turned, "similarity"},
      {T::similarity, mirrored, "mirrored similarity"},
      {T::affine, skewed, "affine"},
      {T::homography, tilted, "homography"}};
    for (const auto &[kind, matrix, name] : cases)
      {
        std::vector<cv::Point2d> pad;
        for (const cv::Point2d &p : pixels)
          pad.push_back(Placement{matrix, 0.}(p));
        // The homography is iterated; a nanometre on the pad is nothing.
        const Placement found = fit_placement(pixels, pad, kind);
        check(found.residual < 1e-3, name + ": no residual");
        check(cv::norm(found({123., 456.}) -
                       Placement{matrix, 0.}({123., 456.})) < 1e-3,
              name + ": another point");
        pad[0].x += 10.;
        check(fit_placement(pixels, pad, kind).residual > 0.5,
              name + ": a wrong point shows in the residual");
      }
    const std::vector<cv::Point2d> line = {
      {0., 0.}, {10., 10.}, {20., 20.}, {35., 35.}};
    for (const T kind : {T::similarity, T::affine, T::homography})
      check_throws<InputError>([&]() { fit_placement(line, line, kind); },
                               "collinear",
                               "points on a line are refused");
    // pixels and, um on the pad, upright with the middle one read 10 um too low
    const std::vector<cv::Point2d> flat = {{10., 100.},
                                           {200., 106.},
                                           {390., 98.}},
                                   read = {{-190., 0.}, {0., 3.}, {190., 2.}};
    for (const T kind : {T::similarity, T::affine})
      check_throws<InputError>([&]() { fit_placement(flat, read, kind); },
                               "nearly so",
                               "so are points nearly on a line");
    // one wrong point of three leaves both ways to lay the image
    const std::vector<cv::Point2d> wide = {{10., 100.},
                                           {200., 160.},
                                           {390., 98.}},
                                   off  = {{-190., 0.}, {0., 20.}, {190., 0.}};
    check_throws<InputError>(
      [&]() { fit_placement(wide, off, T::similarity); },
      "its mirror image alike",
      "points that fit a mirrored image as well are refused");
    check_throws<InputError>(
      [&]() {
        fit_placement({{0., 0.}}, {{0., 0.}}, T::affine);
      },
      "at least 3",
      "one point is refused");
  }



  /** Frames that do not show the same are no mosaic. */
  void
  check_mismatch(const cv::Mat &grey)
  {
    const cv::Size               size(600, 460);
    const std::vector<cv::Point> corners = {
      {0, 0}, {420, 0}, {0, 300}, {420, 300}};
    check(
      join_frames(frames_of(grey, size, corners, {1., 1.})).warnings.empty(),
      "frames that match have no warning");
    for (const auto &[stage, word] :
         {std::pair(cv::Point2d(1., -1.), "stage position in y,"),
          std::pair(cv::Point2d(-1., -1.), "stage position in x and y,")})
      check_throws<InputError>(
        [&, stage = stage]() {
          join_frames(frames_of(grey, size, corners, stage));
        },
        word,
        "an axis of the stage that runs against the images");
    auto mirrored = frames_of(grey, size, corners, {1., 1.});
    cv::flip(mirrored[3].grey, mirrored[3].grey, 1);
    const Mosaic one = join_frames(mirrored);
    check(one.n_tried == 6 && one.n_refined == 3 && one.warnings.size() == 3,
          "one mirrored frame of four fits none of the others: " +
            std::to_string(one.n_refined) + " of " +
            std::to_string(one.n_tried));
    for (const std::string &warning : one.warnings)
      check(warning.find("a3 and a") == 0, "and is named: " + warning);
    check(one.warnings[1].find("a3 and a1 do not show the same") == 0,
          "on its largest overlap, too");
    for (Micrograph &m : mirrored)
      cv::flip(m.grey, m.grey, 1);
    check_throws<InputError>([&]() { join_frames(mirrored); },
                             "mirrored",
                             "mirrored frames are refused");
    auto plain = frames_of(grey, size, corners, {1., 1.});
    for (Micrograph &m : plain)
      m.grey.setTo(90.);
    const Mosaic flat = join_frames(plain);
    check(flat.n_refined == 0 && flat.warnings.size() == 3 &&
            flat.warnings[0].find("nothing to align") != std::string::npos,
          "frames that show nothing lie by their stage positions");
    auto dark = frames_of(grey, size, corners, {1., 1.});
    dark[1].grey *= 0.7;
    const Mosaic uneven = join_frames(dark);
    check(uneven.warnings.size() == 3 &&
            uneven.warnings[0].find("a1 is 0.70 times as bright as a0") == 0,
          "a darker frame is named");
  }



  /** A stage whose scale is 3 % wrong is wrong by 4 px from each frame to the
   * next, however many there are. */
  void
  check_drift(const cv::Mat &grey)
  {
    std::vector<cv::Point> corners;
    for (int k = 0; k < 7; ++k)
      corners.emplace_back(133 * k, 0);
    const Mosaic mosaic =
      join_frames(frames_of(grey, {200, 700}, corners, {1.03, 1.}));
    check(mosaic.n_refined == 6, "all frames of a row are aligned");
    for (int k = 1; k < 7; ++k)
      check(cv::norm(mosaic.shifts[k] - mosaic.shifts[0] -
                     cv::Point2d(corners[k])) < 0.5,
            "frame " + std::to_string(k) + " of the row");
    check_close(
      mosaic.correction, 0.03 * 133. * 6., 0.03, "the last moves most");
  }



  /** Frames of a row are aligned and judged by all their seams, in whatever
   * order they are named. */
  void
  check_order_of_frames(const cv::Mat &grey)
  {
    std::vector<cv::Point> row, named;
    for (int k = 0; k < 5; ++k)
      row.emplace_back(133 * k, 0);
    // As f1, f10, f11, f2, f3: the third and the fourth overlap only frames
    // that are named after them.
    for (const int k : {0, 3, 4, 1, 2})
      named.push_back(row[k]);
    const Mosaic mosaic =
      join_frames(frames_of(grey, {200, 700}, named, {1.03, 1.}));
    check(mosaic.n_tried == 4 && mosaic.n_refined == 4 &&
            mosaic.warnings.empty(),
          "four seams of five frames");
    for (int k = 1; k < 5; ++k)
      check(cv::norm(mosaic.shifts[k] - mosaic.shifts[0] -
                     cv::Point2d(named[k])) < 0.5,
            "frame " + std::to_string(k) + " as named");
    for (const auto &order : {std::array{0, 1, 2}, std::array{0, 2, 1}})
      {
        std::vector<cv::Point> corners;
        for (const int k : order)
          corners.push_back(row[k]);
        auto frames = frames_of(grey, {200, 700}, corners, {1., 1.});
        for (Micrograph &m : frames)
          if (m.metadata.stage->x == 2. * row[2].x)
            cv::flip(m.grey, m.grey, 0);
        const Mosaic one = join_frames(frames);
        check(one.warnings.size() == 1 && one.n_tried == 2 &&
                one.warnings[0].find("do not show the same") !=
                  std::string::npos,
              "a seam that does not match has its warning");
      }
  }



  /** Three frames about a corner: the seam that places no frame is held against
   * the two that do. */
  void
  check_seam_that_places_none(const cv::Mat &grey)
  {
    const std::vector<cv::Point> corners = {{0, 0}, {300, 0}, {100, 300}};
    const cv::Size               size(400, 400);
    auto         frames = frames_of(grey, size, corners, {1., 1.});
    const Mosaic right  = join_frames(frames);
    check(right.n_tried == 3 && right.n_refined == 3 && right.warnings.empty(),
          "three seams fit");
    // What the second one shows near the third lies elsewhere.
    grey(cv::Rect(304, 303, 396, 97))
      .copyTo(frames[1].grey(cv::Rect(0, 300, 396, 97)));
    const Mosaic moved = join_frames(frames);
    check(moved.n_tried == 3 && moved.n_refined == 2 &&
            moved.warnings.size() == 1 &&
            moved.warnings[0].find("a2 and a1 ") == 0 &&
            moved.warnings[0].find("pixels beside") != std::string::npos,
          "one seam does not: " +
            (moved.warnings.empty() ? "" : moved.warnings[0]));
  }



  /** Squares on a pad of 4 x 2 um. */
  void
  check_share_on_pad()
  {
    const auto share = [](const double x, const double y, const double edge) {
      return share_on_pad(
        {10, 10},
        {{edge / 10., 0., x, 0., edge / 10., y, 0., 0., 1.}, 0.},
        {4., 2.});
    };
    check_close(share(-1., -1., 2.), 1., 1e-12, "a square on the pad");
    check_close(share(1., -1., 2.), 0.5, 1e-12, "half beside it");
    check_close(share(1., 0., 2.), 0.25, 1e-12, "over a corner");
    check_close(share(-5., -5., 10.), 0.08, 1e-12, "over all of the pad");
    check(share(50., 0., 2.) == 0. && share(0., -9., 2.) == 0., "off the pad");
    // A square of diagonal 4 about the middle loses two tips of height 1.
    const Placement turned{{0.2, -0.2, 0., 0.2, 0.2, -2., 0., 0., 1.}, 0.};
    check_close(
      share_on_pad({10, 10}, turned, {4., 2.}), 0.75, 1e-12, "a turned square");
  }



  /** Four frames cut from one picture, their stage positions wrong by up to
   * 5 pixels. */
  void
  check_mosaic()
  {
    SpecimenSettings settings;
    settings.data_bar = false;
    cv::Mat grey;
    make_specimen(settings).image.convertTo(grey, CV_32F);
    std::vector<Micrograph> frames;
    const cv::Point         error[] = {{0, 0}, {4, -3}, {-2, 5}, {3, 3}};
    std::vector<cv::Point>  corners = {{0, 0}, {420, 0}, {0, 300}, {420, 300}};
    for (int i = 0; i < 4; ++i)
      {
        Micrograph m;
        m.path       = "frame";
        m.grey       = grey(cv::Rect(corners[i], cv::Size(600, 460))).clone();
        m.frame      = {0, 0, 600, 460};
        m.pixel_size = 2.;
        m.metadata.stage =
          2. * cv::Point2d(corners[i] + cv::Point(300, 230) + error[i]);
        frames.push_back(m);
      }
    const Mosaic mosaic = join_frames(frames);
    check(mosaic.n_tried == 6 && mosaic.n_refined == 6,
          "the frames are aligned on every overlap");
    for (int i = 1; i < 4; ++i)
      check(cv::norm(mosaic.shifts[i] - mosaic.shifts[0] -
                     cv::Point2d(corners[i] - corners[0])) < 0.1,
            "frame " + std::to_string(i) + " within a tenth of a pixel");
    const cv::Mat flat(200, 200, CV_32F, cv::Scalar(50.));
    check(!refine_shift(flat, flat, {10., 0.}),
          "frames without structure are not aligned");
    frames[1].metadata.stage.reset();
    check_throws<InputError>([&]() { join_frames(frames); },
                             "stage",
                             "a frame without stage position is refused");
    check_mismatch(grey);
    check_drift(grey);
    check_order_of_frames(grey);
    check_seam_that_places_none(grey);
  }



  /** Resin, a bright layer whose thickness is known, bulk, cracks that end at
   * a known depth. */
  void
  check_section()
  {
    cv::Mat grey(500, 640, CV_32F, cv::Scalar(110.));
    cv::Mat line = cv::Mat::zeros(grey.size(), CV_8U);
    for (int x = 0; x < grey.cols; ++x)
      {
        const int surface = 80 + cvRound(10. * std::sin(x / 60.));
        grey(cv::Rect(x, surface, 1, 40)).setTo(170.);
        grey(cv::Rect(x, 0, 1, surface)).setTo(15.);
        if (x % 40 == 20)
          line(cv::Rect(x, surface, 1, 100)).setTo(255);
      }
    cv::Mat noise(grey.size(), CV_32F);
    cv::RNG(3).fill(noise, cv::RNG::NORMAL, 0., 6.);
    const SectionProfile p = profile_section(grey + noise, line, 20.);
    check_close(p.layer_median, 40., 0.05, "thickness of the layer");
    for (int b = 0; b < 8; ++b)
      {
        const double density  = p.crack_length[b] / p.band_area[b];
        const double expected = b < 5 ? 1. / 40. : 0.;
        // The surface is a median over columns: it moves by a pixel.
        check(std::abs(density - expected) < 0.004,
              "crack density in band " + std::to_string(b));
      }
    check(p.doubts.empty(), "nothing is left open");
  }



  /** Strata of 40 and 30 rows above a bulk; the first or the second is left out
   * where its thickness is 0. */
  SectionProfile
  profile_of_strata(const double first,
                    const int    n_first,
                    const double second,
                    const double bulk)
  {
    cv::Mat grey(300, 400, CV_32F, cv::Scalar(bulk)), noise(300, 400, CV_32F);
    grey.rowRange(0, n_first + 30).setTo(second);
    grey.rowRange(0, n_first).setTo(first);
    cv::RNG(5).fill(noise, cv::RNG::NORMAL, 0., 3.);
    return profile_section(
      grey + noise, cv::Mat::zeros(grey.size(), CV_8U), 20.);
  }



  /** Bands hold all that is seen under the face, the last one what is left of
   * it; nothing of the resin is part of the specimen. */
  void
  check_bands()
  {
    cv::Mat grey(300, 400, CV_32F, cv::Scalar(120.)), noise(300, 400, CV_32F);
    grey.rowRange(0, 40).setTo(8.);
    cv::RNG(5).fill(noise, cv::RNG::NORMAL, 0., 3.);
    grey += noise;
    cv::Mat line = cv::Mat::zeros(grey.size(), CV_8U);
    line(cv::Rect(200, 50, 1, 250)).setTo(255);
    for (const double band : {100., 130., 250., 1000.})
      {
        const SectionProfile p      = profile_section(grey, line, band);
        const double         height = 300. - p.surface[200];
        check(std::abs(height - 260.) < 2., "height under the face");
        double      area = 0., length = 0.;
        std::size_t n_bands = 0;
        for (std::size_t b = 0; b < p.band_area.size(); ++b)
          if (p.band_area[b] > 0.)
            {
              const double upper = band * double(b),
                           lower = std::fmin(height, upper + band);
              check_close(p.band_depth[b],
                          0.5 * (upper + lower),
                          0.01,
                          "middle of what is seen of a band");
              area += p.band_area[b];
              length += p.crack_length[b];
              ++n_bands;
            }
        check(n_bands == std::size_t(std::ceil(height / band)),
              "bands down to the lower edge");
        check_close(area, 400. * height, 1e-3, "area of all bands");
        check_close(length, 250., 0.01, "length of the crack in them");
        const SectionView shown = below_face(grey);
        check(cv::countNonZero(shown.seen) == int(area),
              "the same area is seen");
        check(cv::mean(shown.grey.rowRange(0, 42))[0] > 115.,
              "and no resin is");
      }
    SeenPixels left(grey.size(), CV_8U, cv::Scalar(255));
    left.colRange(100, 300).setTo(0);
    const SectionProfile half = profile_section(grey, line, 100., left);
    check_close(half.band_area[1], 2e4, 1e-9, "bands are of what is seen");
    check(half.crack_length[1] == 0., "and so are their cracks");
    check(cv::countNonZero(
            below_face(grey, left).seen(cv::Rect(100, 0, 200, 300))) == 0,
          "of the specimen, too");
  }



  /** What brightness decides is right, what it does not is said. */
  void
  check_strata()
  {
    const SectionProfile dark = profile_of_strata(20., 40, 80., 170.);
    check_close(dark.layer_10, 30., 0.05, "a dark layer under darker resin");
    check_close(dark.layer_90, 30., 0.05, "in every column");
    check(std::abs(dark.surface[200] - 40.) < 2., "which the face is above");
    check(dark.doubts.empty(), "nothing is left open by two dark strata");
    const auto is_open = [](const SectionProfile &p, const std::string &word) {
      return p.doubts.size() == 1 &&
             p.doubts[0].find(word) != std::string::npos;
    };
    check(is_open(profile_of_strata(0., 0, 80., 170.), "no layer is found"),
          "a dark layer without resin may be resin");
    check(is_open(profile_of_strata(220., 40, 120., 60.), "no dark resin"),
          "bright resin may be a layer");
    check(is_open(profile_of_strata(90., 40, 170., 120.),
                  "of the brightness of the material"),
          "resin that is hardly darker than the material may be a layer");
  }

} // namespace



int
main()
{
  check_axes_of_pad();
  check_transforms();
  check_share_on_pad();
  check_mosaic();
  check_section();
  check_bands();
  check_strata();
  return 0;
}
