// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/tribology/images/registration.h>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Smaller over larger spread of the points about their centre. */
    double
    flatness(const std::vector<cv::Point2d> &points)
    {
      cv::Point2d centre(0., 0.);
      for (const cv::Point2d &p : points)
        centre += p * (1. / points.size());
      double xx = 0., xy = 0., yy = 0.;
      for (const cv::Point2d &p : points)
        {
          const cv::Point2d d = p - centre;
          xx += d.x * d.x;
          xy += d.x * d.y;
          yy += d.y * d.y;
        }
      const double spread = std::hypot(xx - yy, 2. * xy);
      const double large = xx + yy + spread, small = xx + yy - spread;
      return large > 0. ? std::sqrt(std::max(0., small) / large) : 0.;
    }



    /** Residuals (um, rms) of an image that is mirrored and of one that is not
     * must differ by this factor, and the larger one be this part of the spread
     * of the points: nearly on a line both fit, and errors of reading decide.
     */
    constexpr double least_ratio = 3., least_part = .05;

    void
    require_one_orientation(const double one,
                            const double other,
                            const double spread)
    {
      const double less = std::min(one, other), more = std::max(one, other);
      if (more < least_ratio * less || more < least_part * spread)
        throw InputError(
          "the registration points of 'Segmentation/Image points' and 'Pad "
          "points' fit the image and its mirror image alike (" +
          rounded_text(less, 3) + " and " + rounded_text(more, 3) +
          " um rms): add a point off their line, or mend a wrong one");
    }



    /** Throws InputError where the points do not tell whether the image is
     * mirrored. */
    cv::Matx33d
    fit_similarity(const std::vector<cv::Point2d> &from,
                   const std::vector<cv::Point2d> &to)
    {
      // z' = a z + b, or a conj(z) + b where the y axes oppose each other.
      cv::Matx33d         best;
      double              least = -1., spread = 0.;
      std::vector<double> residuals;
      for (const double sign : {1., -1.})
        {
          cv::Point2d cf(0., 0.), ct(0., 0.);
          for (std::size_t i = 0; i < from.size(); ++i)
            {
              cf +=
                cv::Point2d(from[i].x, sign * from[i].y) * (1. / from.size());
              ct += to[i] * (1. / to.size());
            }
          double re = 0., im = 0., norm = 0.;
          for (std::size_t i = 0; i < from.size(); ++i)
            {
              const cv::Point2d f =
                cv::Point2d(from[i].x, sign * from[i].y) - cf;
              const cv::Point2d t = to[i] - ct;
              re += f.dot(t);
              im += f.cross(t);
              norm += f.dot(f);
            }
          re /= norm;
          im /= norm;
          const cv::Matx33d m(re,
                              -im * sign,
                              ct.x - re * cf.x + im * cf.y,
                              im,
                              re * sign,
                              ct.y - im * cf.x - re * cf.y,
                              0.,
                              0.,
                              1.);
          double            error = 0.;
          spread                  = 0.;
          for (std::size_t i = 0; i < from.size(); ++i)
            {
              const cv::Vec3d q = m * cv::Vec3d(from[i].x, from[i].y, 1.);
              error +=
                std::pow(q[0] - to[i].x, 2) + std::pow(q[1] - to[i].y, 2);
              spread += (to[i] - ct).dot(to[i] - ct);
            }
          residuals.push_back(std::sqrt(error / from.size()));
          if (least < 0. || error < least)
            {
              least = error;
              best  = m;
            }
        }
      require_one_orientation(
        residuals[0], residuals[1], std::sqrt(spread / from.size()));
      return best;
    }



    cv::Matx33d
    fit_affine(const std::vector<cv::Point2d> &from,
               const std::vector<cv::Point2d> &to)
    {
      cv::Mat1d a(int(from.size()), 3), b(int(from.size()), 2), x;
      for (int i = 0; i < a.rows; ++i)
        {
          a(i, 0) = from[i].x;
          a(i, 1) = from[i].y;
          a(i, 2) = 1.;
          b(i, 0) = to[i].x;
          b(i, 1) = to[i].y;
        }
      cv::solve(a, b, x, cv::DECOMP_SVD);
      return {x(0, 0), x(1, 0), x(2, 0), x(0, 1), x(1, 1), x(2, 1), 0., 0., 1.};
    }
  } // namespace



  cv::Point2d
  Placement::operator()(const cv::Point2d &pixel) const
  {
    const cv::Vec3d q = to_pad * cv::Vec3d(pixel.x, pixel.y, 1.);
    return {q[0] / q[2], q[1] / q[2]};
  }



  namespace
  {
    /** What of a polygon has a coordinate (0: x, 1: y) that is @p sign times at
     * most @p limit. */
    std::vector<cv::Point2d>
    cut_polygon(const std::vector<cv::Point2d> &polygon,
                const int                       axis,
                const double                    sign,
                const double                    limit)
    {
      const auto beyond = [&](const cv::Point2d &p) {
        return sign * (axis == 0 ? p.x : p.y) - limit;
      };
      std::vector<cv::Point2d> kept;
      for (std::size_t i = 0; i < polygon.size(); ++i)
        {
          const cv::Point2d &p = polygon[i],
                            &q = polygon[(i + 1) % polygon.size()];
          const double a = beyond(p), b = beyond(q);
          if (a <= 0.)
            kept.push_back(p);
          if ((a < 0. && b > 0.) || (a > 0. && b < 0.))
            kept.push_back(p + a / (a - b) * (q - p));
        }
      return kept;
    }



    double
    area_of(const std::vector<cv::Point2d> &polygon)
    {
      double twice_area = 0.;
      for (std::size_t i = 0; i < polygon.size(); ++i)
        twice_area += (polygon[i] - polygon[0])
                        .cross(polygon[(i + 1) % polygon.size()] - polygon[0]);
      return 0.5 * std::abs(twice_area);
    }



    /** On the pad, in turn. */
    std::vector<cv::Point2d>
    corners_of(const cv::Size &size, const Placement &placement)
    {
      const double             w = size.width, h = size.height;
      std::vector<cv::Point2d> corners;
      for (const cv::Point2d &corner : {cv::Point2d(0., 0.),
                                        cv::Point2d(w, 0.),
                                        cv::Point2d(w, h),
                                        cv::Point2d(0., h)})
        corners.push_back(placement(corner));
      return corners;
    }
  } // namespace



  double
  share_on_pad(const cv::Size   &size,
               const Placement  &placement,
               const cv::Size2d &pad)
  {
    std::vector<cv::Point2d> part  = corners_of(size, placement);
    const double             whole = area_of(part);
    for (const double sign : {1., -1.})
      {
        part = cut_polygon(part, 0, sign, 0.5 * pad.width);
        part = cut_polygon(part, 1, sign, 0.5 * pad.height);
      }
    return whole > 0. ? area_of(part) / whole : 0.;
  }



  PixelOnPad::PixelOnPad(const Placement &placement, const cv::Point2d &pixel)
  {
    // The derivatives, exact where lines stay parallel.
    const cv::Matx33d &m = placement.to_pad;
    const cv::Point2d  o = placement(pixel);
    const double       w = m(2, 0) * pixel.x + m(2, 1) * pixel.y + m(2, 2);
    u = {(m(0, 0) - o.x * m(2, 0)) / w, (m(1, 0) - o.y * m(2, 0)) / w};
    v = {(m(0, 1) - o.x * m(2, 1)) / w, (m(1, 1) - o.y * m(2, 1)) / w};
  }



  double
  PixelOnPad::area() const
  {
    return std::abs(u.cross(v));
  }



  cv::Point2d
  PixelOnPad::step(const double direction) const
  {
    return std::cos(direction) * u + std::sin(direction) * v;
  }



  double
  PixelOnPad::stretch() const
  {
    // Singular values of the two edges.
    const double sum  = u.dot(u) + v.dot(v);
    const double root = std::hypot(u.dot(u) - v.dot(v), 2. * u.dot(v));
    return std::sqrt((sum + root) / std::max(sum - root, 1e-12 * sum));
  }



  Placement
  fit_placement(const std::vector<cv::Point2d>         &pixels,
                const std::vector<cv::Point2d>         &pad,
                const SegmentationParameters::Transform kind)
  {
    using T                    = SegmentationParameters::Transform;
    const std::size_t n_needed = kind == T::affine       ? 3
                                 : kind == T::homography ? 4
                                                         : 3;
    if (pixels.size() < n_needed || pixels.size() != pad.size())
      throw InputError("'Segmentation/Image points' has " +
                       std::to_string(pixels.size()) + " points: at least " +
                       std::to_string(n_needed) + " are needed");
    // Across a line nothing but errors of reading is fitted.
    const double least_flatness = kind == T::homography ? .01 : .05,
                 flattest       = std::min(flatness(pixels), flatness(pad));
    if (flattest < least_flatness)
      throw InputError("the registration points of 'Segmentation/Image points' "
                       "or 'Pad points' are collinear or nearly so (as wide "
                       "across their line as " +
                       rounded_text(100. * flattest, 2) +
                       " % of along it): choose points that do not lie on one "
                       "line");
    Placement placement;
    if (kind == T::similarity)
      placement.to_pad = fit_similarity(pixels, pad);
    else if (kind == T::affine)
      placement.to_pad = fit_affine(pixels, pad);
    else
      {
        const cv::Mat h = cv::findHomography(pixels, pad, 0);
        if (h.empty())
          throw InputError("three of the registration points are collinear: "
                           "'Segmentation/Transform = homography' needs four "
                           "in general position");
        placement.to_pad = cv::Matx33d(h.ptr<double>());
      }
    double sum = 0.;
    for (std::size_t i = 0; i < pixels.size(); ++i)
      sum += std::pow(cv::norm(placement(pixels[i]) - pad[i]), 2);
    placement.residual = std::sqrt(sum / pixels.size());
    if (!std::isfinite(placement.residual))
      throw InputError("the registration points are collinear or coincide: "
                       "choose others in 'Segmentation/Image points'");
    return placement;
  }



  Placement
  place_by_stage(const Micrograph &m)
  {
    if (!m.metadata.stage)
      throw InputError(m.path + " has no stage position in its metadata: use "
                                "'Segmentation/Registration = points'");
    const double p = m.pixel_size;
    return {cv::Matx33d(p,
                        0.,
                        m.metadata.stage->x - 0.5 * p * m.frame.width,
                        0.,
                        p,
                        m.metadata.stage->y - 0.5 * p * m.frame.height,
                        0.,
                        0.,
                        1.),
            0.};
  }



  PadView
  in_axes_of_pad(const cv::Mat &image, const Placement &placement)
  {
    const double                   w = image.cols, h = image.rows;
    const std::vector<cv::Point2d> corners =
      corners_of(image.size(), placement);
    cv::Point2d lower = corners[0], upper = corners[0];
    double      twice_area = 0.;
    for (std::size_t i = 0; i < 4; ++i)
      {
        lower.x = std::min(lower.x, corners[i].x);
        lower.y = std::min(lower.y, corners[i].y);
        upper.x = std::max(upper.x, corners[i].x);
        upper.y = std::max(upper.y, corners[i].y);
        twice_area += corners[i].cross(corners[(i + 1) % 4]);
      }
    PadView result;
    result.pixel_size   = std::sqrt(0.5 * std::abs(twice_area) / (w * h));
    result.upper_left   = {lower.x, upper.y};
    const double      s = result.pixel_size;
    const cv::Matx33d to_view(
      1. / s, 0., -lower.x / s, 0., -1. / s, upper.y / s, 0., 0., 1.);
    // Pixels have their centre at whole numbers there, at halves here.
    const cv::Matx33d to_centre(1., 0., 0.5, 0., 1., 0.5, 0., 0., 1.),
      from_centre(1., 0., -0.5, 0., 1., -0.5, 0., 0., 1.);
    cv::warpPerspective(image,
                        result.image,
                        from_centre * to_view * placement.to_pad * to_centre,
                        {std::max(1, cvRound((upper.x - lower.x) / s)),
                         std::max(1, cvRound((upper.y - lower.y) / s))},
                        cv::INTER_LINEAR,
                        cv::BORDER_CONSTANT,
                        cv::Scalar::all(255));
    return result;
  }
} // namespace squeal::tribology
