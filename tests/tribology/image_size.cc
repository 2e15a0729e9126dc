// SPDX-License-Identifier: LGPL-2.1-or-later

// Images are measured by their headers and refused before they are decoded when
// they would not fit.
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/timers.h>
#include <squeal/tribology/images/image_size.h>
#include <squeal/tribology/images/micrograph.h>

#include <opencv2/imgcodecs.hpp>

#include <fstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  std::string
  big_endian(const unsigned int value)
  {
    std::string bytes;
    for (int i = 3; i >= 0; --i)
      bytes += char(value >> 8 * i);
    return bytes;
  }



  /** The head of a PNG of this size; the sum behind it is not looked at. */
  std::string
  png_head(const unsigned int width, const unsigned int height)
  {
    return std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) +
           big_endian(width) + big_endian(height) +
           std::string("\x08\0\0\0\0????", 9);
  }



  void
  sizes_of_written_images()
  {
    const cv::Mat grey(48, 37, CV_8U, cv::Scalar(9));
    cv::Mat       colour(48, 37, CV_8UC3, cv::Scalar(9, 8, 7));
    for (const char *kind : {".png", ".jpg", ".tif", ".bmp"})
      for (const cv::Mat &image : {grey, colour})
        {
          std::vector<uchar> bytes;
          cv::imencode(kind, image, bytes);
          const std::string data(bytes.begin(), bytes.end());
          const auto        size = image_size(data);
          check(size && size->width == 37 && size->height == 48,
                std::string("size of a ") + kind);
          for (std::size_t n = 0; n < std::min<std::size_t>(data.size(), 700);
               ++n)
            image_size(data.substr(0, n));
          check(true, "a cut header does no harm");
        }
    check(!image_size("") && !image_size("no image at all, but some text"),
          "no size of what is no image");
  }



  void
  refusals()
  {
    // 20 kB more would make it a file that decodes to 400 million pixels
    std::ofstream("large.png", std::ios::binary)
      << png_head(20000, 20000) << "IEND";
    check_throws<InputError>([]() { read_grey("large.png"); },
                             "large.png has 20000 x 20000 pixels, which take "
                             "some 48 GB of memory: reduce or cut the image, "
                             "or raise 'Largest image' (100 million pixels)",
                             "more pixels than the limit");
    std::ofstream("huge.png", std::ios::binary)
      << png_head(2000000000, 2000000000) << "IEND";
    check_throws<InputError>([]() { read_grey("huge.png", 1e30); },
                             "GB are available: reduce or cut the image",
                             "more memory than there is, whatever the limit");
    std::ofstream("small.png", std::ios::binary)
      << png_head(200, 200) << "IEND";
    check_throws<InputError>(
      []() { read_grey("small.png"); },
      "no PNG, TIFF, JPEG or BMP image, or it is damaged",
      "a size that is allowed goes to the decoder");
  }
} // namespace



int
main()
{
  sizes_of_written_images();
  refusals();
}
