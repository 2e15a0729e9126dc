// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_criteria_enclosing_ball_h
#define squeal_tribology_criteria_enclosing_ball_h

#include <Eigen/Core>

#include <array>
#include <vector>

namespace squeal::tribology
{
  /** A stress deviator (or any path) in the five dimensions in which the length
   * of a point is sqrt(J2). */
  using Point5 = Eigen::Matrix<double, 5, 1>;

  struct Ball5
  {
    Point5 centre = Point5::Zero();
    double radius = 0.;
  };

  /**
   * The smallest ball that holds all points. From the ball of a few points the
   * farthest one is taken in until none is outside; each ball of few is exact
   * (Welzl 1991), so that the radius grows and the loop ends.
   */
  Ball5 smallest_enclosing_ball(const std::vector<Point5> &points);

  /** Radius of the smallest circle that holds all points (x_i, y_i). */
  double smallest_enclosing_circle(const std::vector<double> &x,
                                   const std::vector<double> &y);
} // namespace squeal::tribology

#endif
