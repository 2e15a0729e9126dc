// SPDX-License-Identifier: LGPL-2.1-or-later

// Micrographs: header, pixels, metadata. With SQUEAL_FUZZ_SEEDS=folder it
// writes small ones there to start from.
#include <squeal/tribology/images/micrograph.h>

#include <opencv2/imgcodecs.hpp>

#include "fuzz.h"

using namespace squeal;

extern "C" int
LLVMFuzzerInitialize(int *, char ***)
{
  const char *const folder = std::getenv("SQUEAL_FUZZ_SEEDS");
  if (folder == nullptr)
    return 0;
  cv::Mat image(32, 40, CV_8U);
  for (int i = 0; i < int(image.total()); ++i)
    image.data[i] = std::uint8_t(i * 7 % 251);
  for (const char *kind : {"png", "tif", "jpg", "bmp"})
    cv::imwrite(std::string(folder) + "/seed." + kind, image);
  return 0;
}

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  return fuzz::read_as("in.img", data, size, [](const std::string &path) {
    const tribology::ImageMetadata metadata = tribology::read_metadata(path);
    if (metadata.stage)
      {
        fuzz::require_finite(metadata.stage->x, "the stage position");
        fuzz::require_finite(metadata.stage->y, "the stage position");
      }
    // Ten million pixels keep the inputs quick and below 2 GB.
    const auto micrograph = tribology::read_micrograph(path, 1., {}, 10.);
    fuzz::require(micrograph.grey.cols >= 32 && micrograph.grey.rows >= 32,
                  "an image that is too small");
    fuzz::require(cv::checkRange(micrograph.grey, true, nullptr, 0., 255.01),
                  "a grey value that is none");
  });
}
