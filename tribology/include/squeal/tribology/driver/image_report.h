// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_driver_image_report_h
#define squeal_tribology_driver_image_report_h

#include <squeal/results/html_report.h>
#include <squeal/tribology/driver/context.h>
#include <squeal/tribology/images/segmentation_record.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** Writes a copy of the picture @p from to the file @p to, at most 820 pixels
   * wide, and returns @p to; an empty string where there is no picture. */
  std::string reduced_picture(const std::string &from, const std::string &to);

  /** The length of all cracks with its deviation, and their density, in one
   * line. Where images overlap on the pad, what several of them show counts
   * once. */
  std::string cracks_in_words(const SegmentationRecord &record);

  /** What the images do not tell about areas, a line for each image and kind:
   * areas that rest on nothing but brightness are no finding. */
  std::vector<std::string> areas_in_words(const SegmentationRecord &record);

  /** Fills the report of segmented images: figures, what their errors are made
   * of, overlays (the files `<stem>_overlay.png` of the run, reduced into its
   * folder plots), lines that were left out, agreement of raters. */
  void fill_image_report(HtmlReport               &report,
                         const SegmentationRecord &record,
                         Context                  &context);

  /** Fills the report of made specimens: what is drawn in each and the first
   * pictures beside their true cracks. */
  void fill_specimen_report(HtmlReport  &report,
                            const Table &truth,
                            Context     &context);
} // namespace squeal::tribology

#endif
