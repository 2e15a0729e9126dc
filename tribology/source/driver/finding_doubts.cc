// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/tribology/driver/finding_doubts.h>
#include <squeal/tribology/images/image_blur.h>
#include <squeal/tribology/images/line_length.h>

#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    void
    add_scan_rows(const Segmentation &found, std::vector<std::string> &doubts)
    {
      int    n      = 0;
      double length = 0.;
      for (const ExcludedLine &line : found.excluded)
        if (line.reason == Exclusion::scan)
          {
            ++n;
            length += double(line.pixels.size());
          }
      if (n > 0)
        doubts.push_back(
          std::to_string(n) + (n == 1 ? " piece" : " pieces") + " of rows, " +
          rounded_text(length, 3) +
          " pixels in all, are darker than the rows beside them, with edges "
          "sharper than optics make: they are taken for the scan, are filled "
          "in by these rows, and count for nothing");
      if (const std::size_t few = found.rows_like_scan.size(); few > 0)
        doubts.push_back(
          std::to_string(few) + (few == 1 ? " line lies" : " lines lie") +
          " exactly along the rows of the image, with edges sharper than "
          "optics make: part of the cracks may be of the scan");
    }
  } // namespace



  std::vector<std::string>
  doubts_of(const Segmentation &found, const double pixel_size)
  {
    std::vector<std::string> doubts;
    if (const double n = found.cracks.without_line; n > 0.)
      doubts.push_back(
        "along " + rounded_text(n * pixel_size, 3) +
        " um of the cracks the image shows no dark line, or one that is "
        "wider than what is measured: the width there is not known, and "
        "its error says so");
    for (const ExcludedLine &band : found.excluded)
      if (band.reason == Exclusion::wide)
        doubts.push_back(
          "a dark band " + rounded_text(band.width, 2) + " pixels wide and " +
          rounded_text(length_of_pixels(band.pixels), 3) +
          " pixels long may be a crack too wide to be found: the error of "
          "the length holds it; give the image with larger pixels, or mark "
          "it in 'Masks'");
    add_scan_rows(found, doubts);
    return doubts;
  }



  std::vector<std::string>
  doubts_of_focus(const CrackMap &cracks,
                  const cv::Mat  &grey,
                  const double    pixel_size)
  {
    if (cracks.blur.is_measured)
      return {"the image is out of focus: by its cracks it is blurred by " +
              rounded_text(cracks.blur.value, 2) + " +- " +
              rounded_text(cracks.blur.error * cracks.blur.value, 1) +
              " pixels, with which widths are measured; cracks narrower than "
              "about that, " +
              rounded_text(cracks.blur.value * pixel_size, 2) +
              " um, are missed in part or as a whole, and the error of the "
              "length does not contain them"};
    if (cv::countNonZero(cracks.centre_line) == 0 &&
        std::isinf(sharpest_edges(grey)))
      return {"no edge stands out of the noise: the image is out of focus or "
              "shows nothing, narrow cracks would not be seen, and the error "
              "of the length does not contain them"};
    return {};
  }
} // namespace squeal::tribology
