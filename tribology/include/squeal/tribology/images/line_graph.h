// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_line_graph_h
#define squeal_tribology_images_line_graph_h

#include <squeal/tribology/images/centre_line.h>

namespace squeal::tribology
{
  /** A skeleton cut at its junctions. */
  struct LineGraph
  {
    struct Edge
    {
      LinePiece        piece;
      std::vector<int> nodes; /**< of the junctions at its ends, 0 to 2 */
    };

    explicit LineGraph(const cv::Mat &skeleton);

    /** The skeleton of the edges that are @p kept with the junctions between
     * at least two of them, thinned. */
    cv::Mat draw(const std::vector<char> &kept) const;

    /** Number of the connected part of each edge that is @p kept, from 0; -1
     * for the others. */
    std::vector<int> parts(const std::vector<char> &kept) const;

    std::vector<Edge>      edges;
    std::vector<PixelPath> junctions;
    cv::Size               size;
  };

  /** A straight line of pixels. */
  struct StraightRun
  {
    double      length = 0.; /**< 0: not straight */
    cv::Point2d first, last;
  };

  /** The straight line that @p piece is a part of: pixels of the skeleton
   * within one pixel of it, gaps of up to 8 pixels bridged. */
  StraightRun straight_run_of(const cv::Mat &skeleton, const LinePiece &piece);
} // namespace squeal::tribology

#endif
