// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_path_evidence_h
#define squeal_tribology_images_path_evidence_h

#include <opencv2/core.hpp>

#include <array>

namespace squeal::tribology
{
  /** Short-line contrast of each pixel and direction in units of noise. */
  struct OrientedContrast
  {
    static constexpr int n_directions = 16;

    /** Contrasts are limited to least..most: one dark grain does not make a
     * path, one bright grain does not end it. */
    static constexpr double least = -2., most = 4.;
    /** Stored integers per unit: sums over a path fit into 16 bits. */
    static constexpr int per_unit = 512;

    /** CV_16S planes for the directions pi t / n_directions, from +x (right)
     * towards +y (down). */
    std::array<cv::Mat, n_directions> planes;
  };

  /** Best path through each pixel. */
  struct PathEvidence
  {
    cv::Mat mean;      /**< CV_32F, contrast per sample of the path */
    cv::Mat sharp;     /**< CV_32F, the same with more weight at the pixel */
    cv::Mat local;     /**< CV_32F, contrast of the sample at the pixel */
    cv::Mat direction; /**< CV_8U, of the path at the pixel */
  };

  /**
   * Adds up contrast along the best curved path of about 36 pixels through each
   * pixel: samples are 3 pixels apart, the direction turns by at most one step
   * between two samples and each turn costs. Solved exactly by dynamic
   * programming over place and direction, for each half of the path apart. The
   * weaker half has three times the weight of the stronger: a spot or the end
   * of a line lies on one side only. A half that leaves the image counts by its
   * samples inside; when they are fewer than three the other half counts twice.
   */
  PathEvidence integrate_paths(const OrientedContrast &contrast);
} // namespace squeal::tribology

#endif
