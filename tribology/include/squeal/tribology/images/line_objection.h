// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_line_objection_h
#define squeal_tribology_images_line_objection_h

#include <squeal/tribology/images/line_judge.h>

namespace squeal::tribology
{
  /** Why a dark line is no crack. */
  enum class Exclusion
  {
    groove, /**< straight, with others alongside or through the image */
    border, /**< of a stain, a joint or an area: unlike flanks, broad */
    faint,  /**< little contrast over noise, or broken */
    alone,  /**< nothing around it goes on */
    small,  /**< too little in all with what it is connected to */
    rim,    /**< runs along an area that is a feature itself */
    wide,   /**< a dark band, wider than the lines that are looked for */
    scan    /**< pieces of rows that the scan darkened */
  };

  /** The words for it. */
  const char *name_of(Exclusion reason);

  /** What speaks most against a line: of the groups of features that tell one
   * kind from cracks, that whose replacement by what cracks have on the mean
   * raises the log odds most. */
  Exclusion main_objection(const LineJudge                          &judge,
                           const std::array<double, n_all_features> &features);
} // namespace squeal::tribology

#endif
