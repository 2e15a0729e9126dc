// SPDX-License-Identifier: LGPL-2.1-or-later

// Scale and stage of microscopes, and what cannot be read. Argument: the
// executable.
#include <squeal/base/exceptions.h>
#include <squeal/results/table.h>
#include <squeal/tribology/images/cell_grid.h>
#include <squeal/tribology/images/decoder_messages.h>
#include <squeal/tribology/images/element_map.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/specimen.h>
#include <squeal/tribology/images/stored_pixels.h>
#include <squeal/tribology/setup/image_parameters.h>

#include <opencv2/imgcodecs.hpp>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "check.h"
#include "tiff_file.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;
namespace fs = std::filesystem;

namespace
{
  void
  write(const std::string &name, const std::string &data)
  {
    std::ofstream(name, std::ios::binary) << data;
  }



  std::string
  read(const std::string &name)
  {
    std::ifstream      in(name, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
  }



  /** A grey TIFF of 16 bit with one more ASCII tag. */
  std::string
  tiff(const unsigned int tag, const std::string &text)
  {
    cv::Mat values(64, 64, CV_16U);
    for (int i = 0; i < 64 * 64; ++i)
      values.at<ushort>(i / 64, i % 64) = ushort(i * 16);
    return tiff_file({{values, 1, 0, tag, text}});
  }



  void
  check_metadata()
  {
    write("fei.tif",
          tiff(34682,
               "[User]\r\nUser=x\r\n[Stage]\r\nStageX=0.0012\r\n"
               "StageY=-0.0005\r\n[Scan]\r\nPixelWidth=1.5e-007\r\n"));
    const Micrograph fei = read_micrograph("fei.tif", 0.);
    check_close(fei.pixel_size, 0.15, 1e-12, "FEI pixel size in um");
    check_close(fei.metadata.stage->x, 1200., 1e-12, "FEI stage in um");
    check_close(
      fei.grey.at<float>(0, 10), 160. / 257., 1e-5, "16 bits are scaled");
    write("zeiss.tif",
          tiff(34118,
               "AP_IMAGE_PIXEL_SIZE\r\nImage Pixel Size = 27.91 nm\r\n"
               "AP_STAGE_AT_X\r\nStage at X = 61.200 mm\r\n"
               "AP_STAGE_AT_Y\r\nStage at Y = 48.000 mm\r\n"));
    const Micrograph zeiss = read_micrograph("zeiss.tif", 0.);
    check_close(zeiss.pixel_size, 0.02791, 1e-12, "Zeiss pixel size in um");
    check_close(zeiss.metadata.stage->y, 48000., 1e-12, "Zeiss stage in um");
    check_close(read_micrograph("zeiss.tif", 2.).pixel_size,
                2.,
                1e-12,
                "a given size comes first");
    cv::imwrite("jeol.png", cv::Mat(64, 64, CV_8U, cv::Scalar(9)));
    write("jeol.txt",
          "$CM_MAG 500\r\n$$SM_MICRON_BAR 160\r\n$$SM_MICRON_MARKER 50um\r\n"
          "$CM_STAGE_POS 1.5 -2.0 10 0 0 0\r\n");
    const Micrograph jeol = read_micrograph("jeol.png", 0.);
    check_close(jeol.pixel_size, 50. / 160., 1e-12, "JEOL pixel size in um");
    check_close(jeol.metadata.stage->y, -2000., 1e-12, "JEOL stage in um");

    SpecimenSettings settings;
    settings.pixel_size = 0.8;
    const Specimen made = make_specimen(settings);
    write_png("bar.png", made.image);
    const Micrograph bar =
      read_micrograph("bar.png", 0., {made.scale_bar, made.scale_bar_length});
    check_close(bar.pixel_size, 0.8, 0.01, "pixel size from the scale bar");
    check(bar.frame.height == cvRound(768. / 0.8), "the data bar is left out");
    write(
      "comma.tif",
      tiff(34118, "AP_IMAGE_PIXEL_SIZE\r\nImage Pixel Size = 27,91 nm\r\n"));
    check_close(read_micrograph("comma.tif", 0.).pixel_size,
                0.02791,
                1e-12,
                "a decimal comma in Zeiss tags");
    write(
      "inch.tif",
      tiff(34118, "AP_IMAGE_PIXEL_SIZE\r\nImage Pixel Size = 27.91 inch\r\n"));
    check_throws<InputError>([]() { read_micrograph("inch.tif", 0.); },
                             "no scale",
                             "a length in an unknown unit is none");
    write_png("own.png",
              made.image,
              "Kind = synthetic specimen\nPixel size = 0.8 um\n");
    const Micrograph own = read_micrograph("own.png", 0.);
    check_close(own.pixel_size, 0.8, 1e-12, "the text chunk is found again");
    check(own.metadata.is_synthetic, "a made image says so");
  }



  /** Angles of stage and scan, in degrees. */
  void
  check_rotations()
  {
    write("fei_turned.tif",
          tiff(34682,
               "[Stage]\r\nStageX=0\r\nStageY=0\r\nStageR=1.570796327\r\n"
               "[EScan]\r\nPixelWidth=1e-6\r\nScanRotation=-0.7853981634\r\n"));
    const ImageMetadata fei = read_metadata("fei_turned.tif");
    check_close(fei.stage_rotation, 90., 1e-6, "FEI stage in radians");
    check_close(fei.scan_rotation, -45., 1e-6, "FEI scan in radians");
    for (const bool is_on : {true, false})
      {
        write("zeiss_turned.tif",
              tiff(34118,
                   "Image Pixel Size = 1 um\r\nStage at R = 359.0 Degrees\r\n"
                   "Scan Rotation = 30.0 Degrees\r\nScan Rot = " +
                     std::string(is_on ? "On" : "Off") + "\r\n"));
        const ImageMetadata zeiss = read_metadata("zeiss_turned.tif");
        check_close(zeiss.stage_rotation, -1., 1e-9, "Zeiss stage");
        check_close(zeiss.scan_rotation, is_on ? 30. : 0., 1e-9, "Zeiss scan");
      }
    cv::imwrite("jeol_turned.png", cv::Mat(64, 64, CV_8U, cv::Scalar(9)));
    write("jeol_turned.txt",
          "$$SM_MICRON_BAR 160\r\n$$SM_MICRON_MARKER 50um\r\n"
          "$$SM_SCAN_ROTATION 15.00\r\n");
    check_close(
      read_metadata("jeol_turned.png").scan_rotation, 15., 1e-9, "JEOL scan");
  }



  void
  check_refusals(const std::string &program)
  {
    write("empty.png", "");
    std::string noise;
    for (unsigned int i = 0, x = 1; i < 5000;
         ++i, x                = 1664525u * x + 1013904223u)
      noise += char(x >> 24);
    write("noise.png", noise);
    write("cut.png", read("own.png").substr(0, 20000));
    cv::imwrite("tiny.png", cv::Mat(3, 3, CV_8U, cv::Scalar(9)));
    fs::create_directory("folder.png");
    cv::imwrite("plain.png", cv::Mat(64, 64, CV_8U, cv::Scalar(9)));
    cv::imwrite("pad.png", cv::Mat(64, 64, CV_8U, cv::Scalar(9)));
    const std::string line = "'Segmentation/Registration = points' --set "
                             "'Segmentation/Image points = 0,0,1,1,2,2' --set "
                             "'Segmentation/Pad points = 0,0,1,1,2,2'";
    const std::tuple<std::string, std::string, std::string> cases[] = {
      {"empty.png", "", "empty"},
      {"noise.png", "", "no PNG, TIFF, JPEG or BMP"},
      {"cut.png", "", "truncated"},
      {"tiny.png", "", "at least 32"},
      {"folder.png", "", "directory"},
      {"missing.png", "", "missing.png"},
      {"none*.png", "", "no file matches"},
      {"plain.png", "'Pixel size = 0'", "no scale"},
      {"pad.png", "", "rename the file"},
      {"plain.png", line, "collinear"},
      {"plain.png", "'Segmentation/Depth band = 20'", "'View = section'"},
      {"plain.png", "'Segmentation/Mask tolerance = 5'", "without 'Masks'"},
      {"plain.png", "'Segmentation/Mask value = 5'", "without 'Masks'"},
      {"plain.png", "'Segmentation/Mask use = beside'", "without 'Masks'"},
      {"plain.png", "'Segmentation/Transform = affine'", "= points'"},
      {"plain.png", "'Segmentation/Image points = 0,0,9,0,0,9'", "= points'"},
      {"plain.png", "'Segmentation/Pad points = 0,0,9,0,0,9'", "= points'"},
      {"plain.png",
       "'Segmentation/Scale bar box = 1,1,9,9' --set "
       "'Segmentation/Scale bar length = 50'",
       "beside 'Pixel size'"},
      {"plain.png", "'Output directory = /proc/none'", "output directory"},
      {"plain.png", "'Segmentation/Registration = stage'", "stage position"}};
    for (const auto &[image, more, part] : cases)
      {
        fs::remove_all("refused");
        write("case.prm",
              "set Analysis = segmentation\nset Images = " + image +
                "\nset Pixel size = 1\nset Output directory = refused\n");
        const int status =
          std::system((program + (more.empty() ? "" : " --set " + more) +
                       " case.prm > out.txt 2> err.txt")
                        .c_str());
        const std::string text = read("err.txt");
        check(status != 0, image + " is refused");
        check(text.find(part) != std::string::npos, "it says why: " + text);
        check(std::count(text.begin(), text.end(), '\n') == 1, "in one line");
        int n_files = 0;
        if (fs::exists("refused"))
          for (const auto &f : fs::directory_iterator("refused"))
            {
              // The log and the list of the files are no results.
              const std::string name = f.path().filename();
              n_files += name != "run.log" && name[0] != '.';
            }
        check(n_files == 0, "nothing is left half written");
      }
  }

  /** A map that no crack follows. */
  void
  check_unlinked_map()
  {
    SpecimenParameters made;
    made.damage_table  = "damage.csv";
    made.damage_column = "index";
    check_throws<InputError>([&]() { check_specimen({}, made); },
                             "'Link strength = 0'",
                             "a map is refused where no crack follows it");
    made.link_strength = 1.;
    check_specimen({}, made);
  }

  /** What two statements of one run would contradict is refused. */
  void
  check_registration_by_points(const std::string &program)
  {
    cv::Mat plain(480, 640, CV_8U, cv::Scalar(90));
    for (const char *name : {"field_1.png", "field_2.png"})
      write_png(name, plain);
    const auto errors_of = [&](const std::string &images,
                               const std::string &pixel) {
      write("points.prm",
            "set Analysis = segmentation\nset Overwrite = true\n"
            "set Output directory = points\nset Images = " +
              images + "\nset Pixel size = " + pixel +
              "\nsubsection Segmentation\n  set Registration = points\n"
              "  set Image points = 0, 0, 640, 0, 0, 480\n"
              "  set Pad points = -0.64, -0.48, 0.64, -0.48, -0.64, 0.48\n"
              "  set Pad size = 4, 4\n  set Cells = 4, 4\nend\n");
      const int status =
        std::system((program + " points.prm > out.txt 2> err.txt").c_str());
      const std::string text = read("err.txt");
      check((status == 0) == text.empty(), "an error has its line: " + text);
      return text;
    };
    check(errors_of("field_1.png", "2").empty(), "2 um and 2 um agree");
    check(errors_of("field_1.png", "1").find("but by 'Image points'") !=
            std::string::npos,
          "1 um and 2 um do not");
    check(errors_of("field_?.png", "2").find("is for one image") !=
            std::string::npos,
          "one set of points lays one image");
  }

  /** Element maps keep their numbers; colours are none. */
  void
  check_element_maps()
  {
    cv::imwrite("counts.png", cv::Mat(64, 64, CV_16U, cv::Scalar(1000)));
    check_close(read_element_map("counts.png").values.at<float>(5, 5),
                1000.,
                1e-12,
                "counts of 16 bit");
    cv::imwrite("colours.png",
                cv::Mat(64, 64, CV_8UC3, cv::Scalar(200, 20, 30)));
    check_throws<InputError>([]() { read_element_map("colours.png"); },
                             "colours",
                             "a map in colours is refused");
    cv::imwrite("grey.png", cv::Mat(64, 64, CV_8UC3, cv::Scalar(7, 7, 7)));
    check_close(read_element_map("grey.png").values.at<float>(5, 5),
                7.,
                1e-12,
                "a grey map in three channels");
  }

  /** Transparent pixels of an element map count for nothing, whatever is hidden
   * under them, and not where the map is made smaller either. */
  void
  check_transparent_element_map()
  {
    cv::Mat grey(64, 64, CV_8U, cv::Scalar(40)), alpha(64, 64, CV_8U);
    alpha.setTo(255);
    alpha.colRange(33, 64).setTo(0);
    grey.colRange(33, 64).setTo(0);
    cv::Mat layers;
    cv::merge(std::vector<cv::Mat>{grey, grey, grey, alpha}, layers);
    cv::imwrite("part.png", layers);
    for (const int n : {64, 32})
      {
        Micrograph image;
        image.grey                = cv::Mat::zeros(n, n, CV_32F);
        image.frame               = {0, 0, n, n};
        const ElementMap map      = element_map_over(image, "part.png");
        const int        n_opaque = n == 64 ? 33 : 17; // half of the last one
        check(cv::countNonZero(map.seen) == n * n_opaque &&
                cv::countNonZero(map.seen.colRange(0, n_opaque)) ==
                  n * n_opaque,
              "what is opaque counts");
        CellGrid grid({double(n), double(n)}, 4, 1);
        grid.add_covariate(
          "map",
          map.values,
          {cv::Matx33d(1., 0., -.5 * n, 0., 1., -.5 * n, 0., 0., 1.), 0.},
          map.seen);
        Table table(grid.columns());
        grid.append_rows(table, "pad");
        for (const std::size_t cell : {0, 1, 2})
          check_close(table.real(cell, "map"),
                      40.,
                      1e-6,
                      "the mean is that of opaque pixels");
        check(table.text(3, "map").empty(), "of none there is no mean");
      }
    layers.setTo(cv::Scalar(9, 9, 9, 0));
    cv::imwrite("clear.png", layers);
    check_throws<InputError>([]() { read_element_map("clear.png"); },
                             "transparent everywhere",
                             "a map without a count is refused");
  }

  /** Images that a wildcard does not reach are named. */
  void
  check_missed_images()
  {
    fs::create_directories("slides");
    for (const char *name : {"a.tif", "b.TIF", "c.png", "notes.txt"})
      write(std::string("slides/") + name, "");
    const auto missed = [](const std::vector<std::string> &names) {
      return missed_images(names, expand_wildcards(names));
    };
    const std::vector<std::string> lines = missed({"slides/*.tif"});
    check(lines.size() == 1 &&
            lines[0].find("miss 2 images of 'slides': b.TIF, c.png") !=
              std::string::npos,
          "what *.tif misses: " + (lines.empty() ? "nothing" : lines[0]));
    check(missed({"slides/*.tif", "slides/*.TIF", "slides/c.png"}).empty() &&
            missed({"slides/[ab].*"}).size() == 1 &&
            missed({"slides/a.tif"}).empty(),
          "nothing is missed where all are named or no wildcard is");
  }



  /** Damage that decoders pass over or report on the terminal alone. */
  void
  check_damaged_pixels()
  {
    cv::Mat image(200, 200, CV_8U);
    for (int y = 0; y < image.rows; ++y)
      for (int x = 0; x < image.cols; ++x)
        image.at<std::uint8_t>(y, x) = (37 * x + 91 * y + x * y) % 256;
    unsigned int n_refused = 0, n_silent = 0, n_other = 0;
    for (const std::string name : {"damaged.jpg", "damaged.png"})
      {
        std::vector<unsigned char> encoded;
        cv::imencode(name.substr(7), image, encoded);
        write(name, std::string(encoded.begin(), encoded.end()));
        const cv::Mat whole = read_raw(name, 1e9);
        for (unsigned int i = 1; i < 20; ++i)
          {
            std::string       data(encoded.begin(), encoded.end());
            const std::size_t at = data.size() * (20 + i) / 50;
            for (std::size_t k = at; k < at + 12; ++k)
              data[k] = char(data[k] ^ (0x5a + i));
            write(name, data);
            const std::string said = messages_of([&] {
              try
                {
                  const cv::Mat read = read_raw(name, 1e9);
                  n_silent += cv::norm(read, whole, cv::NORM_INF) > 0.;
                }
              catch (const InputError &e)
                {
                  ++n_refused;
                  n_other +=
                    std::string(e.what()).find("damaged") == std::string::npos;
                }
            });
            check(said.empty(), name + ": nothing on the terminal: " + said);
          }
      }
    std::cout << n_refused << " of 38 damaged images refused, " << n_silent
              << " read with other pixels\n";
    check(n_other == 0, "they are called damaged");
    check(n_refused >= 19, "all PNG, which carry checksums, are refused");
  }

  void
  check_messages()
  {
    check(messages_of([] { std::fprintf(stderr, "one\n"); }) == "one\n",
          "what is written to the terminal is caught");
    check(damage_in("TIFFReadDirectory: Warning, Unknown field with tag 34682")
            .empty(),
          "the tag of a microscope is no damage");
    check(damage_in("a\nCorrupt JPEG data: 3 extraneous bytes\n") ==
            "Corrupt JPEG data: 3 extraneous bytes",
          "the line of a damaged file");
  }
} // namespace



int
main(int argc, char **argv)
{
  cv::setNumThreads(1);
  check_metadata();
  check_unlinked_map();
  check_rotations();
  check_missed_images();
  check_messages();
  check_damaged_pixels();
  check_element_maps();
  check_transparent_element_map();
  if (argc > 1)
    {
      check_refusals(argv[1]);
      check_registration_by_points(argv[1]);
    }
  return 0;
}
