// SPDX-License-Identifier: LGPL-2.1-or-later

// Masks that people drew: agreement against closed forms, lengths of bars that
// were filled, and what the program
// makes of files by one rater, by two, beside squeal's own finding, and of
// wrong ones. Argument: the program.
#include "../analyses/program.h"

#include <squeal/results/table.h>
#include <squeal/tribology/images/agreement.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/mask_line.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/specimen.h>

#include <nlohmann/json.hpp>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  std::string program;

  /** A row of pixels with the given marks. */
  cv::Mat
  row(const std::vector<int> &counts, const std::vector<int> &marks)
  {
    cv::Mat mask(1, 0, CV_8U);
    for (std::size_t i = 0; i < counts.size(); ++i)
      cv::hconcat(
        mask, cv::Mat(1, counts[i], CV_8U, cv::Scalar(255 * marks[i])), mask);
    return mask;
  }



  void
  check_kappa()
  {
    // 20 both, 5 the first alone, 10 the second alone, 15 neither.
    const std::vector<int> counts = {20, 5, 10, 15};
    const cv::Mat a = row(counts, {1, 1, 0, 0}), b = row(counts, {1, 0, 1, 0});
    const PairAgreement pair = agreement_of({a, b}).pairs.at(0);
    check(pair.kappa.has_value(), "both marked some");
    check_close(pair.kappa->value, 0.4, 1e-12, "Cohen's kappa of a table");
    check_close(pair.dice, 40. / 55., 1e-12, "Dice of a table");
    check(pair.kappa->deviation > 0. && pair.kappa->deviation < 1.,
          "kappa has a deviation");
    // Four pixels marked by 3, 2, 1 and 0 of three raters: two thirds of the
    // pairs agree, a half would by chance.
    const std::vector<int> one   = {1, 1, 1, 1};
    const Agreement        three = agreement_of(
      {row(one, {1, 1, 1, 0}), row(one, {1, 1, 0, 0}), row(one, {1, 0, 0, 0})});
    check(three.fleiss.has_value(), "three raters marked some");
    check_close(three.fleiss->value, 1. / 3., 1e-12, "Fleiss' kappa");
    check(three.pairs.size() == 3, "three pairs");
    check_close(agreement_of({a, a}).pairs.at(0).kappa->value,
                1.,
                1e-12,
                "a rater agrees with himself");
    const cv::Mat none = row({50}, {0});
    check(!agreement_of({none, none}).pairs.at(0).kappa,
          "two that marked nothing agree by chance alone");
    check_close(agreement_of({a, none}).pairs.at(0).kappa->value,
                0.,
                1e-12,
                "who marked nothing agrees by chance alone");
    // Pixels that are not seen, some of which a widened line reaches.
    const std::vector<int> wider = {30, 20, 5, 10, 15, 7};
    const cv::Mat          seen  = row(wider, {0, 1, 1, 1, 1, 0});
    const Agreement        part  = agreement_of(
      {row(wider, {0, 1, 1, 0, 0, 1}), row(wider, {0, 1, 0, 1, 0, 1})}, seen);
    check_close(part.pairs.at(0).kappa->value,
                0.4,
                1e-12,
                "what nobody can see is no agreement");
    check_close(part.pairs.at(0).kappa->deviation,
                pair.kappa->deviation,
                1e-12,
                "nor a block to leave out");
    check_close(part.pairs.at(0).dice, 40. / 55., 1e-12, "nor an overlap");
    check_close(part.fleiss->value,
                agreement_of({a, b}).fleiss->value,
                1e-12,
                "of all raters either");
  }



  void
  check_consensus()
  {
    cv::Mat a = cv::Mat::zeros(60, 100, CV_8U), b = a.clone(), c = a.clone();
    cv::line(a, {10, 30}, {80, 30}, 255);
    cv::line(b, {10, 32}, {80, 32}, 255);
    cv::line(c, {10, 50}, {80, 50}, 255);
    const cv::Mat line = consensus_line({a, b, c}, 2.);
    check(cv::countNonZero(line.rowRange(29, 34)) > 60,
          "two raters of three make a line");
    check(cv::countNonZero(line.rowRange(40, 60)) == 0,
          "one of three does not");
    check(cv::countNonZero(consensus_line({a}, 2.) != a) == 0,
          "one rater's line stays as it is");
  }



  double
  length_in(const cv::Mat &line)
  {
    return cv::sum(pixel_lengths(line))[0];
  }



  /** Bars of 300 x @p width pixels, turned by @p degrees, whose outline is
   * rough by @p rough pixels. */
  cv::Mat
  filled_bar(const double width, const double degrees, const double rough)
  {
    cv::Mat      mask = cv::Mat::zeros(360, 360, CV_8U);
    cv::RNG      random(3);
    const double c = std::cos(degrees * CV_PI / 180.),
                 s = std::sin(degrees * CV_PI / 180.);
    std::array<std::vector<double>, 2> outline;
    for (std::vector<double> &side : outline)
      for (int i = 0; i <= 300; ++i)
        {
          const double jump = random.gaussian(rough);
          side.push_back(i == 0 ? jump : 0.75 * side.back() + 0.66 * jump);
        }
    for (int y = 0; y < mask.rows; ++y)
      for (int x = 0; x < mask.cols; ++x)
        {
          const double u = c * (x - 180.) + s * (y - 180.) + 150.,
                       v = c * (y - 180.) - s * (x - 180.);
          if (u >= 0. && u < 300.)
            mask.at<uchar>(y, x) = v >= -0.5 * width + outline[0][int(u)] &&
                                       v < 0.5 * width + outline[1][int(u)]
                                     ? 255
                                     : 0;
        }
    return mask;
  }



  /** Masks that fill cracks have the length of the cracks. */
  void
  check_filled_masks()
  {
    for (const double width : {1., 3., 7., 15., 25.})
      for (const double degrees : {0., 20., 45., 90.})
        {
          const MaskLine line   = line_of_mask(filled_bar(width, degrees, 0.));
          const double   length = length_in(line.line);
          std::printf("bar %g px wide at %g degrees: %.1f, ends +- %.2f\n",
                      width,
                      degrees,
                      length,
                      line.end_error);
          const std::string text = ", " + std::to_string(int(width)) +
                                   " px wide at " +
                                   std::to_string(int(degrees)) + " degrees";
          check(std::abs(length - 300.) <= 4. + 0.5 * line.end_error,
                "a bar is 300 px long" + text);
          check(width > 1. ? line.end_error > 0. : line.end_error < 0.1,
                "its ends are as sure as it is thin" + text);
        }
    const cv::Mat none = cv::Mat::zeros(90, 90, CV_8U);
    check(length_in(line_of_mask(none).line) == 0., "nothing has no line");
  }



  /** Raters who agree shorten nothing. */
  void
  check_lengths_agreed()
  {
    cv::Mat line = cv::Mat::zeros(300, 400, CV_8U);
    cv::line(line, {110, 150}, {290, 150}, 255);
    const double length = length_in(line);
    for (const double tolerance : {0., 2., 5., 20., 50.})
      check_close(length_in(consensus_line({line, line, line}, tolerance)),
                  length,
                  2. / length,
                  "three alike, at a tolerance of " +
                    std::to_string(int(tolerance)));
  }



  nlohmann::json
  run(const std::string &text)
  {
    write_text("test.prm",
               "set Analysis = segmentation\nset Overwrite = true\n"
               "set Images = worn.png\nset Output directory = out\n"
               "subsection Segmentation\n" +
                 text + "end\n");
    const Outcome outcome = run_program({program, "test.prm"});
    check(outcome.code == 0, "the program ends well: " + outcome.errors);
    return nlohmann::json::parse(text_of("out/segmentation.json"))
      .at("images")
      .at(0);
  }



  void
  check_refused(const std::string &text, const std::string &words)
  {
    write_text("test.prm",
               "set Analysis = segmentation\nset Overwrite = true\n"
               "set Images = worn.png\nset Output directory = refused\n"
               "subsection Segmentation\n" +
                 text + "end\n");
    const Outcome outcome = run_program({program, "test.prm"});
    check(outcome.code != 0 && outcome.errors.find(words) != std::string::npos,
          "refused with '" + words + "': " + outcome.errors);
    check(!std::filesystem::exists("refused/segmentation.json"),
          "and nothing is written: " + words);
  }



  /** An image, and masks of it by two people and in other formats. */
  struct Files
  {
    Files()
    {
      SpecimenSettings settings;
      settings.seed       = 31;
      settings.width      = 512.;
      settings.height     = 384.;
      const Specimen made = make_specimen(settings);
      cv::Mat        grey;
      made.image.convertTo(grey, CV_32F);
      frame = {0, 0, 512, rows_above_data_bar(grey)};
      write_png("worn.png",
                made.image,
                "Kind = synthetic specimen\nPixel size = 1 um\n");
      all  = made.cracks;
      half = all.clone();
      half.colRange(0, 256).setTo(0);
      write_png("worn_anna.png", all);
      std::filesystem::create_directories("berta");
      write_png("berta/worn.png", half);
      cv::Mat below = cv::Mat::zeros(all.size(), CV_8U);
      all.rowRange(0, all.rows - 6).copyTo(below.rowRange(6, all.rows));
      write_png("worn_below.png", below);
      // ilastik writes labels, background 1 and cracks 2, of the frame alone.
      cv::Mat labels = 1 + cv::Mat(all / 255);
      write_png("worn-labels.png", labels(frame));
      cv::Mat wide;
      cv::Mat(all != 0).convertTo(wide, CV_16U, 257.);
      write_png("worn_wide.png", wide);
      write_png("worn_inverted.png", cv::Mat(255 - all));
      write_png("worn_three.png", cv::Mat(all / 255 + half / 255));
      write_png("worn_small.png", all(cv::Rect(0, 0, 300, 200)));
      write_png("other.png", all);
      write_png("worn_areas.png", made.exfoliation);
      write_layers();
      std::filesystem::remove_all("twice");
      std::filesystem::create_directories("twice");
      write_png("twice/worn_berta.png", all);
      write_png("twice/worn_2_berta.png", half);
    }

    /** Marks of one colour on transparent layers, two colours, and nothing. */
    void
    write_layers() const
    {
      const cv::Mat none = cv::Mat::zeros(all.size(), CV_8U);
      const auto    save = [&](const std::string &name,
                            const cv::Mat     &grey,
                            const cv::Mat     &alpha) {
        cv::Mat layer;
        cv::merge(std::vector<cv::Mat>{grey, grey, grey, alpha}, layer);
        write_png(name, layer);
      };
      save("worn_black.png", none, all);
      save("worn_red.png", cv::Mat(all / 2), all);
      save("worn_clear.png", none, none);
      save("worn_two.png", cv::Mat(half / 2), all);
      write_png("worn_empty.png", none);
    }

    cv::Rect frame;
    cv::Mat  all, half;
  };



  void
  check_one_rater()
  {
    const auto image  = run("  set Masks = worn_anna.png\n");
    const auto rating = image.at("cracks").at("rating");
    check(rating.at("raters") == nlohmann::json({"anna"}),
          "the rater is what the name adds");
    check(rating.at("deviation").is_null(),
          "with one rater nothing tells how far they differ");
    check(text_of("out/run.log").find("with one mask nothing tells") !=
            std::string::npos,
          "and the log says so");
    check(image.at("cracks").at("excluded").empty(),
          "squeal has left out nothing where a rater states the cracks");
    check(unbroken(text_of("out/run.log"))
              .find("worn_anna.png: marks of 'anna' in ") != std::string::npos,
          "the log tells which mask was taken for which image");
    const double length = image.at("cracks").at("length_mm");
    check_close(rating.at("lengths_mm").at(0).get<double>(),
                length,
                1e-9,
                "the length stated is that of the mask");
    for (const char *same :
         {"  set Masks = worn_wide.png\n",
          "  set Masks = worn-labels.png\n  set Mask value = 2\n",
          "  set Masks = worn_inverted.png\n  set Mask value = 0\n",
          "  set Masks = worn_black.png\n",
          "  set Masks = worn_red.png\n"})
      check_close(run(same).at("cracks").at("length_mm").get<double>(),
                  length,
                  1e-9,
                  std::string("the same by") + same);
  }



  /** Who marks nothing has not excluded everything. */
  void
  check_nothing_marked()
  {
    for (const std::string name : {"worn_empty.png", "worn_clear.png"})
      {
        const auto cracks = run("  set Masks = " + name + "\n").at("cracks");
        check(cracks.at("length_mm") == 0., name + " has no crack");
        check(cracks.at("length_error_mm") > 0.005, "with an error");
        const std::string log = unbroken(text_of("out/run.log"));
        check(log.find("nothing is marked in it") != std::string::npos,
              "and a warning");
        check(log.find("up to 0 mm") == std::string::npos &&
                text_of("out/report.html").find("up to 0 mm") ==
                  std::string::npos,
              "short cracks are not excluded");
        check(cracks.at("mean_width_um").is_null() &&
                cracks.at("mean_width_error_um").is_null(),
              "what is not there has no width");
        const Table table = read_csv("out/segmentation.csv");
        check(table.is_missing(0, "crack_width_m") &&
                table.is_missing(0, "crack_width_error_m"),
              "nor in the table");
        check(run("  set Area masks = " + name + "\n")
                  .at("exfoliation")
                  .at("area_fraction_error") > 0.,
              "small areas are not excluded either");
      }
  }



  /** Nobody's mask is laid over another image without a word. */
  void
  check_whose_masks()
  {
    check_refused("  set Masks = twice/worn*.png\n",
                  "by 'berta' on another image");
    write_png("worn_2.png", cv::Mat(64, 64, CV_8U, cv::Scalar(90)));
    check_refused("  set Masks = twice/worn_2_berta.png\n", "may be a mask of");
    std::filesystem::remove("worn_2.png");
  }



  void
  check_two_raters()
  {
    const auto image  = run("  set Masks = worn_anna.png, berta/*.png\n"
                            "  set Area masks = worn_areas.png\n");
    const auto cracks = image.at("cracks"), rating = cracks.at("rating");
    check(rating.at("raters") == nlohmann::json({"anna", "berta"}),
          "a rater is the folder where the name adds nothing");
    const double anna  = rating.at("lengths_mm").at(0),
                 berta = rating.at("lengths_mm").at(1),
                 both  = cracks.at("length_mm");
    check(berta < 0.8 * anna, "berta marked less");
    check(both > berta && both < 1.1 * anna, "the consensus lies with them");
    const double deviation = rating.at("deviation");
    check_close(
      deviation,
      std::sqrt(0.5 * (std::pow(anna - both, 2) + std::pow(berta - both, 2))),
      1e-9,
      "how far they differ");
    check(cracks.at("length_error_mm").get<double>() >= deviation,
          "that is part of the error");
    const auto   pair  = rating.at("pairs").at(0);
    const double kappa = pair.at("cohen_kappa").at("value");
    check(kappa > 0.3 && kappa < 0.99, "they agree in part");
    check(text_of("out/run.log").find(" agree on ") == std::string::npos,
          "which is enough for a consensus");
    check_close(pair.at("dice").get<double>(),
                kappa,
                0.05,
                "of few pixels kappa is about Dice");
    check(image.at("exfoliation").at("rating").at("raters").size() == 1,
          "areas have raters of their own");
    // Lines of two pixels' tolerance that lie six pixels apart are others.
    run("  set Masks = worn_anna.png, worn_below.png\n");
    check(
      unbroken(text_of("out/run.log")).find("'anna' and 'below' agree on") !=
        std::string::npos,
      "raters who marked other places are warned of");
  }



  void
  check_beside()
  {
    const auto own = run("").at("cracks");
    check(!own.contains("rating"), "no mask, no rating");
    const auto image  = run("  set Masks = worn_anna.png, berta/*.png\n"
                            "  set Mask use = beside\n");
    const auto cracks = image.at("cracks"), rating = cracks.at("rating");
    check(rating.at("raters") == nlohmann::json({"anna", "berta", "squeal"}),
          "squeal is one of three raters");
    check_close(cracks.at("length_mm").get<double>(),
                own.at("length_mm").get<double>(),
                1e-12,
                "squeal's own length is stated");
    check(!own.at("excluded").empty() &&
            cracks.at("excluded") == own.at("excluded"),
          "with the lines that it left out");
    check(cracks.at("length_error_mm").get<double>() >
            own.at("length_error_mm").get<double>(),
          "its error holds how far the others differ");
    check(rating.at("pairs").at(1).at("cohen_kappa").at("value") > 0.7,
          "squeal agrees with the truth");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program = argv[1];
  cv::setNumThreads(1);
  check_kappa();
  check_consensus();
  check_filled_masks();
  check_lengths_agreed();
  const Files files;
  check_one_rater();
  check_nothing_marked();
  check_whose_masks();
  check_two_raters();
  check_beside();
  check_refused("  set Masks = worn_inverted.png\n", "it is inverted");
  check_refused("  set Masks = worn_three.png\n", "set 'Mask value'");
  check_refused("  set Masks = worn_anna.png\n  set Mask value = 7\n",
                "has no pixel of 'Mask value' 7");
  check_refused("  set Masks = worn_two.png\n", "draw them in one colour");
  check_refused("  set Masks = worn_small.png\n", "draw masks on the image");
  check_refused("  set Masks = other.png\n", "belongs to no image");
  check_refused("  set Masks = nobody*.png\n", "'Masks': no file matches");
  check_refused("  set Masks = worn_anna.png\n  set Mosaic = true\n",
                "not with 'Mosaic'");
  return 0;
}
