// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_label_layout_h
#define squeal_results_label_layout_h

#include <string>
#include <vector>

namespace squeal
{
  /** A rectangle in pixels, y upwards. */
  struct PixelBox
  {
    double x_min = 0.;
    double y_min = 0.;
    double x_max = 0.;
    double y_max = 0.;

    /** Area shared with @p other; 0 if apart. */
    double overlap(const PixelBox &other) const;
  };

  /** Pixels that @p text takes in the font of charts at @p font_size points. */
  double text_width(const std::string &text, double font_size);

  /** @p text or, where it is wider than @p width pixels, as much of its start
   * and its end as fits about an ellipsis; never less than the ellipsis. */
  std::string shortened(const std::string &text,
                        double             width,
                        double             font_size);

  /** Pixels from one line of text to the next. */
  double text_height(double font_size);

  /** A text that belongs to a point of a chart. */
  struct PointLabel
  {
    double      x; /**< the point, in pixels */
    double      y;
    std::string text;
    PixelBox    box;                  /**< result: where the text stands */
    bool        needs_leader = false; /**< result: too far to be clear */
  };

  /**
   * Finds a place for each label near its point so that labels cover neither
   * each other nor, where that can be had, the @p obstacles (markers, lines),
   * and stay within @p bounds.
   */
  void place_labels(std::vector<PointLabel>     &labels,
                    const std::vector<PixelBox> &obstacles,
                    const PixelBox              &bounds,
                    double                       font_size);
} // namespace squeal

#endif
