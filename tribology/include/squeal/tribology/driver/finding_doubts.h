// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_driver_finding_doubts_h
#define squeal_tribology_driver_finding_doubts_h

#include <squeal/tribology/images/segmentation.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** What a user is to look at in one image, in a line each: widths that are
   * not known, dark bands that may be wide cracks, rows that the scan darkened.
   * @p pixel_size in um. */
  std::vector<std::string> doubts_of(const Segmentation &found,
                                     double              pixel_size);

  /** The same of an image that is out of focus, or shows nothing that would
   * tell: what it hides is in no error. @p grey is CV_32F. */
  std::vector<std::string> doubts_of_focus(const CrackMap &cracks,
                                           const cv::Mat  &grey,
                                           double          pixel_size);
} // namespace squeal::tribology

#endif
