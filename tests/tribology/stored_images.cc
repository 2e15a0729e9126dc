// SPDX-License-Identifier: LGPL-2.1-or-later

// One picture in many files: bits, white and black, turned, in stacks, with
// pixels that are no squares, under names with brackets. Argument: the program.
#include "../analyses/program.h"

#include <squeal/base/exceptions.h>
#include <squeal/results/table.h>
#include <squeal/tribology/images/element_map.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/rater_masks.h>
#include <squeal/tribology/images/specimen.h>
#include <squeal/tribology/images/stored_pixels.h>

#include <nlohmann/json.hpp>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>

#include "tiff_file.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  std::string program;

  cv::Mat
  worn_surface()
  {
    SpecimenSettings settings;
    settings.seed     = 3;
    settings.width    = 400.;
    settings.height   = 300.;
    settings.data_bar = false;
    return make_specimen(settings).image;
  }



  cv::Mat
  of_16_bit(const cv::Mat &image, const double factor)
  {
    cv::Mat wide;
    image.convertTo(wide, CV_16U, factor);
    return wide;
  }



  bool
  same(const cv::Mat &a, const cv::Mat &b)
  {
    return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) < 1e-4;
  }



  void
  check_bits(const cv::Mat &image)
  {
    cv::imwrite("bits.png", image);
    const cv::Mat grey = read_grey("bits.png");
    for (const double factor : {1., 2., 16., 257.})
      {
        cv::Mat wide = of_16_bit(image, factor);
        cv::imwrite("wide.png", wide);
        check(same(read_grey("wide.png"), grey),
              "the same grey from 16 bit, times " + std::to_string(factor));
        check(read_micrograph("wide.png", 1.).notes.size() ==
                (factor < 257. ? 1u : 0u),
              "and a note where bits are not used");
        wide.at<ushort>(20, 30) = 65535;
        cv::imwrite("wide.png", wide);
        cv::Mat read           = read_grey("wide.png");
        read.at<float>(20, 30) = grey.at<float>(20, 30);
        check(same(read, grey), "one hot pixel does not darken the others");
      }
    cv::imwrite("dark.png", cv::Mat(image / 16));
    check(read_micrograph("dark.png", 1.).warnings.size() == 1 &&
            read_micrograph("bits.png", 1.).warnings.empty(),
          "a picture that is nearly black has a warning, others none");
  }



  void
  check_white_and_black(const cv::Mat &image)
  {
    const cv::Mat wide = of_16_bit(image, 257.);
    write_text("inverted_8.tif", tiff_file({{255 - image, 0}}));
    write_text("inverted_16.tif", tiff_file({{65535 - wide, 0}}));
    for (const char *file : {"inverted_8.tif", "inverted_16.tif"})
      check(same(read_grey(file), read_grey("bits.png")),
            std::string("white is zero is read as meant: ") + file);
    check(read_micrograph("inverted_16.tif", 1.).warnings.empty(),
          "without a warning where all bits are used");
    for (const int bits : {10, 12})
      {
        const double most = std::pow(2., bits) - 1.;
        write_text(
          "inverted_few.tif",
          tiff_file({{most - of_16_bit(image, std::pow(2., bits - 8)), 0}}));
        const auto warnings = read_micrograph("inverted_few.tif", 1.).warnings;
        check(
          warnings.size() == 1 &&
            warnings[0].find("of its 16 bits the picture uses " +
                             std::to_string(bits) + ":") != std::string::npos &&
            warnings[0].find("subtract its values from " +
                             std::to_string(int(most))) != std::string::npos,
          "where black lies in few bits is not known, which is said");
      }
  }



  void
  check_turned(const cv::Mat &image)
  {
    cv::Mat half;
    cv::rotate(image, half, cv::ROTATE_180);
    for (const cv::Mat &values : {image, of_16_bit(image, 257.)})
      {
        write_text("turned.tif", tiff_file({{values, 1, 3}}));
        const Micrograph m = read_micrograph("turned.tif", 1.);
        cv::Mat          expected;
        half.convertTo(expected, CV_32F);
        check(same(m.grey, expected), "a turned image is read upright");
        check(m.orientation == 3 && m.notes.size() == 1, "which a note says");
        cv::Mat mask = image > 250;
        mask(cv::Rect(100, 100, 20, 20)).setTo(255);
        write_png("turned_by_fiji.png", mask);
        check_throws<InputError>(
          [&]() { read_mask("turned_by_fiji.png", m, -1, 1e3); },
          "orientation tag",
          "a mask without the tag may lie turned over it");
        write_text("turned_mask.tif", tiff_file({{mask, 1, 3}}));
        cv::Mat turned_mask;
        cv::rotate(mask, turned_mask, cv::ROTATE_180);
        check(same(read_mask("turned_mask.tif", m, -1, 1e3), turned_mask),
              "one with the same tag lies as the image does");
        check_throws<InputError>(
          [&m]() { element_map_over(m, "turned_by_fiji.png"); },
          "has the orientation tag 1, the view of turned.tif 3",
          "an element map without the tag may lie turned over it");
        turned_mask.convertTo(expected, CV_32F);
        check(same(element_map_over(m, "turned_mask.tif").values, expected),
              "one with the same tag lies as the image does");
      }
  }



  /** The chunk tRNS of a grey PNG with its checksum. */
  std::string
  transparent_chunk(const int grey)
  {
    const std::string data = std::string("tRNS") + char(grey >> 8) + char(grey);
    std::uint32_t     crc  = 0xffffffffU;
    for (const char byte : data)
      {
        crc ^= std::uint8_t(byte);
        for (int bit = 0; bit < 8; ++bit)
          crc = crc >> 1 ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
      }
    std::string chunk = std::string(3, '\0') + '\2' + data;
    for (int byte = 3; byte >= 0; --byte)
      chunk += char(~crc >> 8 * byte);
    return chunk;
  }



  /** One grey value of a PNG without an alpha channel may be transparent. */
  void
  check_transparent_grey(const cv::Mat &image)
  {
    cv::Mat bytes = image.clone();
    bytes.setTo(199, bytes == 200);
    bytes(cv::Rect(20, 30, 9, 9)).setTo(199);
    bytes.colRange(140, bytes.cols).setTo(200);
    for (const auto &[values, grey] :
         {std::pair(bytes, 200),
          std::pair(of_16_bit(bytes, 257.), 200 * 257),
          std::pair(bytes, 199),
          std::pair(bytes, 201)})
      {
        cv::imwrite("opaque.png", values);
        std::string file = text_of("opaque.png");
        check(read_pixels("opaque.png").opaque.empty(), "nothing is said");
        // Behind the header of 33 bytes.
        file.insert(33, transparent_chunk(grey));
        write_text("transparent.png", file);
        const StoredPixels pixels = read_pixels("transparent.png");
        const cv::Mat      shown  = values != grey;
        if (grey == 201)
          check(pixels.opaque.empty(), "no pixel has that value");
        else
          check(same(pixels.opaque, shown),
                "transparent grey " + std::to_string(grey));
        check(!pixels.is_transparent, "something is seen");
      }
    const Micrograph m = read_micrograph("transparent.png", 1.);
    check(m.seen.empty(), "all of it is seen");
    cv::imwrite("opaque.png", cv::Mat(64, 64, CV_8U, cv::Scalar(9)));
    std::string file = text_of("opaque.png");
    file.insert(33, transparent_chunk(9));
    write_text("transparent.png", file);
    check_throws<InputError>([]() { read_micrograph("transparent.png", 1.); },
                             "transparent everywhere",
                             "where nothing is seen nothing is measured");
  }



  /** The decoder gives no transparency of a grey TIFF. */
  void
  check_transparent_tiff(const cv::Mat &image)
  {
    cv::Mat alpha(image.size(), CV_8U, cv::Scalar(255));
    alpha.colRange(140, alpha.cols).setTo(0);
    for (const double factor : {1., 257.})
      {
        TiffPage page{factor > 1. ? of_16_bit(image, factor) : image};
        page.alpha = factor > 1. ? of_16_bit(alpha, factor) : alpha;
        write_text("alpha.tif", tiff_file({page}));
        check_throws<InputError>([]() { read_pixels("alpha.tif"); },
                                 "save it as PNG",
                                 "a grey TIFF that is transparent in part");
      }
    write_text("alpha.tif", tiff_file({{image}}));
    check(same(read_grey("alpha.tif"), read_grey("bits.png")),
          "and none without transparency");
  }



  void
  check_stacks(const cv::Mat &image)
  {
    write_text("stack.tif", tiff_file({{image}, {image}}));
    for (const std::string &begin :
         {std::string("II+\0\b\0\0\0", 8), std::string("MM\0+\0\b\0\0", 8)})
      {
        write_text("big.tif", begin + std::string(200, '\0'));
        check_throws<InputError>([]() { read_pixels("big.tif"); },
                                 "BigTIFF, which is not read: save it as",
                                 "a BigTIFF is told from a damaged file");
      }
    check_throws<InputError>([]() { read_raw("stack.tif"); },
                             "a stack of 2 images",
                             "which image of a stack is meant is not known");
    cv::Mat small;
    cv::resize(image, small, cv::Size(), 0.25, 0.25);
    write_text("thumbnail.tif", tiff_file({{image}, {small}}));
    check(same(read_grey("thumbnail.tif"), read_grey("bits.png")),
          "a thumbnail behind the image makes no stack");
  }



  Outcome
  run(const std::string &images, const std::string &text = "")
  {
    write_text("test.prm",
               "set Analysis = segmentation\nset Overwrite = true\n"
               "set Output directory = out\nset Images = " +
                 images + "\n" + text);
    return run_program({program, "test.prm"});
  }



  double
  length_in(const std::string &images)
  {
    const Outcome outcome = run(images, "set Pixel size = 1\n");
    check(outcome.code == 0, images + " is read: " + outcome.errors);
    return nlohmann::json::parse(text_of("out/segmentation.json"))
      .at("images")
      .at(0)
      .at("cracks")
      .at("length_mm");
  }



  /** Four dark lines of 250 pixels along the columns. */
  cv::Mat
  upright_lines()
  {
    cv::Mat grey(400, 500, CV_32F, cv::Scalar(130.)), bytes;
    for (int k = 0; k < 4; ++k)
      grey(cv::Rect(100 + 90 * k, 75, 3, 250)).setTo(60.);
    cv::Mat noise(grey.size(), CV_32F);
    cv::RNG(4).fill(noise, cv::RNG::NORMAL, 0., 3.);
    cv::Mat(grey + noise).convertTo(bytes, CV_8U);
    return bytes;
  }



  /** Pixels of 1 x 2 um: 2 mm of lines along the longer edge. */
  void
  check_pixels_that_are_no_squares()
  {
    const cv::Mat lines = upright_lines();
    write_text(
      "tall.tif",
      tiff_file({{lines,
                  1,
                  0,
                  34682,
                  "[Scan]\r\nPixelWidth=1e-6\r\nPixelHeight=2e-6\r\n"}}));
    const ImageMetadata metadata = read_metadata("tall.tif");
    check_close(metadata.aspect, 2., 1e-12, "height over width");
    check_close(
      *metadata.pixel_size, std::sqrt(2.), 1e-12, "the size by the area");
    const Outcome refused = run("tall.tif");
    check(refused.code != 0 &&
            refused.errors.find("2.000 times as high") != std::string::npos,
          "without points such pixels are refused: " + refused.errors);
    cv::Mat mask = lines < 95;
    cv::medianBlur(mask, mask, 5);
    write_png("tall_by_hand.png", mask);
    const std::string by_points =
      "subsection Segmentation\n  set Registration = points\n"
      "  set Transform = affine\n  set Image points = 0,0, 500,0, 0,400\n"
      "  set Pad points = -0.25,-0.4, 0.25,-0.4, -0.25,0.4\n"
      "  set Pad size = 0.5, 0.8\n  set Cells = 1, 1\n";
    for (const std::string masks : {"", "  set Masks = tall_by_hand.png\n"})
      {
        const Outcome outcome = run("tall.tif", by_points + masks + "end\n");
        check(outcome.code == 0, "points tell their shape: " + outcome.errors);
        const auto image =
          nlohmann::json::parse(text_of("out/segmentation.json"))
            .at("images")
            .at(0);
        const auto &cracks = image.at("cracks");
        check_close(cracks.at("length_mm").get<double>(),
                    2.,
                    0.05,
                    "the length on the pad");
        check_close(
          cracks.at("length_mm").get<double>(),
          1e3 * read_csv("out/segmentation.csv").real(0, "crack_length_m"),
          1e-3,
          "in every table");
        check_close(cracks.at("length_density_per_mm").get<double>(),
                    1e-3 *
                      read_csv("out/cells.csv").real(0, "crack_density_per_m"),
                    1e-3,
                    "as in the cells");
        if (!masks.empty())
          check_close(cracks.at("rating").at("lengths_mm").at(0).get<double>(),
                      cracks.at("length_mm").get<double>(),
                      1e-9,
                      "as the rater drew them");
      }
  }



  void
  check_brackets_in_names(const cv::Mat &image)
  {
    std::filesystem::create_directories("br");
    write_png("br/img[1].png", image);
    write_png("br/img1.png", cv::Mat(image.size(), CV_8U, cv::Scalar(120)));
    check(expand_wildcards({"br/img[1].png"}) ==
            std::vector<std::string>{"br/img[1].png"},
          "a file of that name comes before the files that match it");
    check(expand_wildcards({"br/img[12].png"}) ==
            std::vector<std::string>{"br/img1.png"},
          "else brackets are a wildcard");
    check(length_in("br/img[1].png") > 0., "the program reads it");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument");
  program = argv[1];
  cv::setNumThreads(1);
  const cv::Mat image = worn_surface();
  check_bits(image);
  check_white_and_black(image);
  check_turned(image);
  check_transparent_grey(image);
  check_transparent_tiff(image);
  check_stacks(image);
  check_pixels_that_are_no_squares();
  check_brackets_in_names(image);
  return 0;
}
