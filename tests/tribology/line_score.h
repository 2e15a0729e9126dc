// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_tribology_line_score_h
#define squeal_tests_tribology_line_score_h

#include <squeal/tribology/images/centre_line.h>

#include <opencv2/imgproc.hpp>

namespace squeal::testing
{
  /** Agreement of two line maps within a tolerance. */
  struct LineScore
  {
    int    n_found = 0, n_true = 0; /**< skeleton pixels */
    double precision = 0., recall = 0.;

    double
    f1() const
    {
      const double sum = precision + recall;
      return sum > 0. ? 2. * precision * recall / sum : 0.;
    }
  };

  /** Both masks are thinned; precision is the share of found skeleton pixels
   * within @p tolerance of a true one, recall the other way round. Values of
   * @p truth near 128 are left out of both. */
  inline LineScore
  score_lines(const cv::Mat &found,
              const cv::Mat &truth,
              const double   tolerance)
  {
    const cv::Mat ignored = (truth > 100) & (truth < 200);
    cv::Mat       a = tribology::thin(found), b = tribology::thin(truth >= 200);
    a.setTo(0, ignored);
    b.setTo(0, ignored);
    LineScore s;
    s.n_found = cv::countNonZero(a);
    s.n_true  = cv::countNonZero(b);
    if (s.n_found == 0 || s.n_true == 0)
      return s;
    cv::Mat to_a, to_b;
    cv::distanceTransform(~a, to_a, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    cv::distanceTransform(~b, to_b, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    s.precision = double(cv::countNonZero((to_b <= tolerance) & a)) / s.n_found;
    s.recall    = double(cv::countNonZero((to_a <= tolerance) & b)) / s.n_true;
    return s;
  }

  /** Overlap of two areas. */
  inline double
  dice(const cv::Mat &a, const cv::Mat &b)
  {
    const double sum = cv::countNonZero(a) + cv::countNonZero(b);
    return sum > 0. ? 2. * cv::countNonZero(a & b) / sum : 1.;
  }
} // namespace squeal::testing

#endif
