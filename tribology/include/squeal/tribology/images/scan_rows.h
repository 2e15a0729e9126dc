// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_scan_rows_h
#define squeal_tribology_images_scan_rows_h

#include <squeal/tribology/images/centre_line.h>

#include <vector>

namespace squeal::tribology
{
  /** A picture without the dark rows that its scan left in it. */
  struct ScanRows
  {
    cv::Mat                grey;   /**< CV_32F, the rows filled in */
    std::vector<PixelPath> pieces; /**< their middle, from left to right */
    bool                   are_filled = false;
  };

  /**
   * Fills in pieces of one to four rows that are darker than those above and
   * below, by what lies beside them: a detector that charges or a beam that
   * flickers darkens whole rows, from one row to the next. The optics blur
   * whatever the specimen shows, so that a crack along a row darkens the rows
   * beside it too. Pieces shorter than some 30 pixels are not told from grains.
   * A scan that darkens rows does so in several places: fewer than four pieces
   * may be cracks of a picture without optics, and stay.
   * @p grey is CV_32F.
   */
  ScanRows without_scan_rows(const cv::Mat &grey);
} // namespace squeal::tribology

#endif
