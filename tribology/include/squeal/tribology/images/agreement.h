// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_agreement_h
#define squeal_tribology_images_agreement_h

#include <squeal/tribology/images/seen_pixels.h>

#include <optional>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /** Chance-corrected agreement with its deviation, from leaving out one of
   * sixteen blocks of what is seen at a time: pixels are not independent. */
  struct Kappa
  {
    double value = 1., deviation = 0.;
  };

  /** How far two raters agree. Kappa is missing where chance alone would make
   * them agree everywhere: both marked nothing, or both everything. */
  struct PairAgreement
  {
    std::size_t          first = 0, second = 0;
    std::optional<Kappa> kappa; /**< Cohen's */
    double               dice = 1.;
  };

  /** How far any number of raters agree. */
  struct Agreement
  {
    std::vector<PairAgreement> pairs;
    std::optional<Kappa>       fleiss; /**< kappa of all of them */
  };

  /** Agreement of @p masks (CV_8U, not 0 where a rater marked a pixel; all of
   * one size; two at least) over those of their pixels that are @p seen, of
   * which there must be some. Lines are to be widened by the tolerance before,
   * see widened(). */
  Agreement agreement_of(const std::vector<cv::Mat> &masks,
                         const SeenPixels           &seen = {});

  /** All pixels within @p tolerance (pixels) of @p line. */
  cv::Mat widened(const cv::Mat &line, double tolerance);

  /** Pixels that at least half of @p masks have. */
  cv::Mat consensus_of(const std::vector<cv::Mat> &masks);

  /**
   * Pixels of the @p lines (skeletons, CV_8U, 0 or 255) beside which at least
   * half of the raters have a line within @p tolerance (pixels), their own
   * included; lines of two raters that lie so near become one, the skeleton of
   * what is between them. Lines farther apart stay apart.
   */
  cv::Mat consensus_line(const std::vector<cv::Mat> &lines, double tolerance);
} // namespace squeal::tribology

#endif
