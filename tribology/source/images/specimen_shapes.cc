// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/specimen_shapes.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace squeal::tribology
{
  namespace
  {
    /** Draws the shapes one after the other from one stream of numbers. */
    class ShapeSource
    {
    public:
      explicit ShapeSource(const SpecimenSettings &settings)
        : s(settings)
        , f(settings.feature_size)
        , random(settings.seed)
      {
      }

      SpecimenShapes
      draw()
      {
        blobs(shapes.plateaus, s.plateaus, 40. * f, 130. * f, 0.);
        blobs(shapes.exfoliations, s.exfoliated, 15. * f, 70. * f, 30. * f);
        rods(shapes.fibres, count(14.), 50. * f, 180. * f, 4. * f, 9. * f);
        grooves();
        cracks();
        return shapes;
      }

    private:
      double
      uniform(const double a, const double b)
      {
        return a + (b - a) * (random() / 4294967296.);
      }

      /** Normal distribution by twelve uniform ones: the same everywhere. */
      double
      normal()
      {
        double sum = -6.;
        for (int i = 0; i < 12; ++i)
          sum += uniform(0., 1.);
        return sum;
      }

      /** Number of features for a density per mm^2 at feature size 1. */
      int
      count(const double density) const
      {
        return cvRound(density * 1e-6 * s.width * s.height / (f * f));
      }

      cv::Point2d
      place(const double border)
      {
        return {uniform(-border, s.width + border),
                uniform(-border, s.height + border)};
      }

      Curve
      blob(const cv::Point2d &centre, const double radius)
      {
        double amplitude[7], phase[7];
        for (int k = 2; k < 7; ++k)
          {
            amplitude[k] = uniform(0., 0.5) / k;
            phase[k]     = uniform(0., 2. * CV_PI);
          }
        const double turn = uniform(0., CV_PI), flat = uniform(0.55, 1.);
        Curve        curve;
        for (int i = 0; i < 90; ++i)
          {
            const double a = 2. * CV_PI * i / 90;
            double       r = 1.;
            for (int k = 2; k < 7; ++k)
              r += amplitude[k] * std::cos(k * a + phase[k]);
            const double x = radius * r * std::cos(a),
                         y = flat * radius * r * std::sin(a);
            curve.emplace_back(
              centre.x + x * std::cos(turn) - y * std::sin(turn),
              centre.y + x * std::sin(turn) + y * std::cos(turn));
          }
        return curve;
      }

      bool
      is_inside(const std::vector<Curve> &curves, const cv::Point2d &p) const
      {
        const cv::Point2f q = p;
        return std::any_of(curves.begin(), curves.end(), [&](const Curve &c) {
          return cv::pointPolygonTest(
                   std::vector<cv::Point2f>(c.begin(), c.end()), q, false) >=
                 0.;
        });
      }

      void
      blobs(std::vector<Curve> &curves,
            const double        share,
            const double        smallest,
            const double        largest,
            const double        apart)
      {
        double area = 0.;
        for (int i = 0; i < 2000 && area < share * s.width * s.height; ++i)
          {
            // Many small ones, few large ones.
            const double u = uniform(0., 1.);
            const double r = smallest * std::pow(largest / smallest, u * u);
            const cv::Point2d centre = place(0.);
            const Curve       curve  = blob(centre, r);
            if (is_inside(curves, centre) ||
                (apart > 0. && is_inside(shapes.plateaus, centre)))
              continue;
            area += std::abs(cv::contourArea(
              std::vector<cv::Point2f>(curve.begin(), curve.end())));
            curves.push_back(curve);
          }
      }

      void
      rods(std::vector<Rod> &list,
           const int         n,
           const double      shortest,
           const double      longest,
           const double      thinnest,
           const double      thickest)
      {
        for (int i = 0; i < n; ++i)
          {
            const double      a    = uniform(0., CV_PI);
            const cv::Point2d half = 0.5 * uniform(shortest, longest) *
                                     cv::Point2d(std::cos(a), std::sin(a));
            const cv::Point2d centre = place(0.);
            // Glass and metal are bright, aramid is a little dark.
            const double tone =
              uniform(0., 1.) < 0.8 ? uniform(0.1, 0.3) : -uniform(0.03, 0.06);
            list.push_back({centre - half,
                            centre + half,
                            uniform(thinnest, thickest),
                            tone});
          }
      }

      void
      grooves()
      {
        const int n = cvRound(0.04 * s.width / f);
        for (int i = 0; i < n; ++i)
          {
            const double x      = uniform(0., s.width);
            const double y      = uniform(-0.5, 1.) * s.height;
            const double tilt   = 0.02 * normal();
            const double length = uniform(0.3, 1.5) * s.height;
            shapes.grooves.push_back({{x, y},
                                      {x + tilt * length, y + length},
                                      uniform(1.5, 3.5) * f,
                                      0.04 * normal()});
          }
      }

      void
      cracks()
      {
        const int n = count(s.crack_density);
        for (int i = 0, tries = 0; i < n && tries < 100 * n; ++tries)
          {
            const cv::Point2d p = place(0.);
            if (s.rate && uniform(0., largest_rate()) >
                            s.rate(p.x / s.width, p.y / s.height))
              continue;
            if (crack(p, uniform(150., 520.) * f, uniform(2., 5.5) * f, false))
              ++i;
          }
      }

      double
      largest_rate()
      {
        if (bound > 0.)
          return bound;
        for (int i = 0; i <= 100; ++i)
          for (int j = 0; j <= 100; ++j)
            bound = std::max(bound, s.rate(i / 100., j / 100.));
        bound = std::max(bound, 1e-12);
        return bound;
      }

      /** A walk whose direction drifts about the main one, across the sliding
       * direction more often than not. False: too short to be one. */
      bool
      crack(const cv::Point2d &start,
            const double       length,
            const double       width,
            const bool         is_branch,
            const double       parent_direction = 0.)
      {
        const double main =
          is_branch ? parent_direction +
                        (uniform(0., 1.) < 0.5 ? 1. : -1.) * uniform(0.5, 1.1)
                    : 0.45 * normal() + (uniform(0., 1.) < 0.5 ? 0. : CV_PI);
        const double depth = uniform(0.4, 0.75);
        const double step  = 3. * f;
        const int    n     = int(length / step);
        CrackShape   shape;
        shape.is_branch = is_branch;
        cv::Point2d p   = start;
        double      a = main, thickness = 0., tone = 0.;
        for (int i = 0; i <= n; ++i)
          {
            if (is_inside(shapes.exfoliations, p))
              break;
            const double along = double(i) / n;
            thickness          = 0.9 * thickness + 0.1 * normal();
            tone               = 0.9 * tone + 0.05 * normal();
            const double taper =
              is_branch ? std::sqrt(1. - 0.8 * along)
                        : 0.45 + 0.55 * std::sqrt(std::sin(CV_PI * along));
            shape.line.push_back(p);
            shape.width.push_back(width * taper *
                                  std::clamp(1. + 0.5 * thickness, 0.6, 1.5));
            shape.depth.push_back(std::clamp(depth + tone, 0.3, 0.85));
            a += 0.1 * (main - a) + 0.22 * normal();
            p += step * cv::Point2d(std::cos(a), std::sin(a));
          }
        if (shape.line.size() < 12)
          return false;
        shapes.cracks.push_back(shape);
        if (!is_branch)
          for (std::size_t i = 8; i + 8 < shape.line.size(); ++i)
            if (uniform(0., 1.) < 0.008)
              {
                const cv::Point2d d = shape.line[i + 2] - shape.line[i - 2];
                crack(shape.line[i],
                      uniform(60., 180.) * f,
                      0.8 * shape.width[i],
                      true,
                      std::atan2(d.y, d.x));
              }
        return true;
      }

      const SpecimenSettings &s;
      const double            f;
      std::mt19937            random;
      SpecimenShapes          shapes;
      double                  bound = 0.;
    };
  } // namespace



  SpecimenShapes
  draw_shapes(const SpecimenSettings &settings)
  {
    return ShapeSource(settings).draw();
  }
} // namespace squeal::tribology
