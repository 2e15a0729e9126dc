// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/criteria/enclosing_ball.h>

#include <Eigen/QR>

#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Rounding: points this much outside are inside, relative to the radius.
     */
    constexpr double slack = 1e-12;

    bool
    holds(const Ball5 &ball, const Point5 &point)
    {
      return (point - ball.centre).norm() <= ball.radius * (1. + slack);
    }



    /** The smallest ball with all these points on its surface; its centre lies
     * in the plane through them. */
    Ball5
    ball_through(const std::vector<Point5> &points)
    {
      Ball5 ball;
      if (points.empty())
        {
          ball.radius = -1.;
          return ball;
        }
      ball.centre = points[0];
      if (points.size() == 1)
        return ball;
      const int       n = static_cast<int>(points.size()) - 1;
      Eigen::MatrixXd edges(5, n);
      Eigen::VectorXd squares(n);
      for (int i = 0; i < n; ++i)
        {
          edges.col(i) = points[i + 1] - points[0];
          squares(i)   = 0.5 * edges.col(i).squaredNorm();
        }
      const Eigen::MatrixXd gram = edges.transpose() * edges;
      const Point5          from_first =
        edges * gram.completeOrthogonalDecomposition().solve(squares);
      ball.centre += from_first;
      ball.radius = from_first.norm();
      return ball;
    }



    Ball5
    ball_of_few(const std::vector<Point5> &points,
                const std::size_t          n,
                std::vector<Point5>       &surface)
    {
      if (n == 0 || surface.size() == 6)
        return ball_through(surface);
      const Ball5 ball = ball_of_few(points, n - 1, surface);
      if (ball.radius >= 0. && holds(ball, points[n - 1]))
        return ball;
      surface.push_back(points[n - 1]);
      const Ball5 larger = ball_of_few(points, n - 1, surface);
      surface.pop_back();
      return larger;
    }



    double
    distance_squared(const double ax,
                     const double ay,
                     const double bx,
                     const double by)
    {
      return (ax - bx) * (ax - bx) + (ay - by) * (ay - by);
    }



    struct Circle
    {
      double x, y, squared;
    };



    bool
    holds(const Circle &c, const double x, const double y)
    {
      return distance_squared(c.x, c.y, x, y) <= c.squared * (1. + slack);
    }



    Circle
    circle_of_two(const double ax, const double ay, const double bx, double by)
    {
      return {
        .5 * (ax + bx), .5 * (ay + by), .25 * distance_squared(ax, ay, bx, by)};
    }



    Circle
    circle_of_three(const double ax,
                    const double ay,
                    const double bx,
                    const double by,
                    const double cx,
                    const double cy)
    {
      const double ux = bx - ax, uy = by - ay, vx = cx - ax, vy = cy - ay;
      const double d = 2. * (ux * vy - uy * vx);
      const double u = ux * ux + uy * uy, v = vx * vx + vy * vy;
      if (std::abs(d) <= 1e-14 * (u + v))
        {
          // on a line: the two ends
          Circle circle = circle_of_two(ax, ay, bx, by);
          for (const Circle &other :
               {circle_of_two(ax, ay, cx, cy), circle_of_two(bx, by, cx, cy)})
            if (other.squared > circle.squared)
              circle = other;
          return circle;
        }
      const double x = (vy * u - uy * v) / d, y = (ux * v - vx * u) / d;
      return {ax + x, ay + y, x * x + y * y};
    }
  } // namespace



  Ball5
  smallest_enclosing_ball(const std::vector<Point5> &points)
  {
    std::vector<Point5> few, surface;
    if (points.empty())
      return {};
    few.push_back(points[0]);
    Ball5 ball = ball_through(few);
    while (true)
      {
        const Point5 *farthest = nullptr;
        double        distance = ball.radius * (1. + slack);
        for (const Point5 &point : points)
          if (const double d = (point - ball.centre).norm(); d > distance)
            {
              distance = d;
              farthest = &point;
            }
        if (farthest == nullptr)
          return ball;
        few.push_back(*farthest);
        const Ball5 larger = ball_of_few(few, few.size(), surface);
        if (!(larger.radius > ball.radius))
          return ball;
        ball = larger;
        // only what carries the ball is kept
        std::vector<Point5> carrying;
        for (const Point5 &point : few)
          if ((point - ball.centre).norm() >= ball.radius * (1. - 1e-9))
            carrying.push_back(point);
        few = carrying;
      }
  }



  double
  smallest_enclosing_circle(const std::vector<double> &x,
                            const std::vector<double> &y)
  {
    if (x.empty())
      return 0.;
    Circle circle{x[0], y[0], 0.};
    for (std::size_t i = 1; i < x.size(); ++i)
      if (!holds(circle, x[i], y[i]))
        {
          circle = {x[i], y[i], 0.};
          for (std::size_t j = 0; j < i; ++j)
            if (!holds(circle, x[j], y[j]))
              {
                circle = circle_of_two(x[i], y[i], x[j], y[j]);
                for (std::size_t k = 0; k < j; ++k)
                  if (!holds(circle, x[k], y[k]))
                    circle =
                      circle_of_three(x[i], y[i], x[j], y[j], x[k], y[k]);
              }
        }
    return std::sqrt(circle.squared);
  }
} // namespace squeal::tribology
