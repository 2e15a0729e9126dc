// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/specimen.h>
#include <squeal/tribology/images/specimen_shapes.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace squeal::tribology
{
  namespace
  {
    constexpr double bulk_tone = 0.5; // of white
    constexpr int    samples   = 3;   // per pixel edge, of thin shapes
    constexpr int    shift     = 6;   // fractional bits of coordinates

    /** Draws the layers of a specimen; all of the field of view. */
    class Painter
    {
    public:
      explicit Painter(const SpecimenSettings &settings)
        : s(settings)
        , shapes(draw_shapes(settings))
        , size(cvRound(s.width / s.pixel_size),
               cvRound(s.height / s.pixel_size))
        , random(settings.seed + 77u)
      {
      }

      Specimen
      paint()
      {
        Specimen result;
        cv::Mat  tone(size, CV_32F, cv::Scalar(bulk_tone));
        // The plateau is worn smooth: it hides most of the texture.
        const cv::Mat plateau     = areas(shapes.plateaus);
        const cv::Mat exfoliation = areas(shapes.exfoliations);
        const cv::Mat bulk        = cv::Mat(1. - 0.75 * plateau);
        tone += texture(6., 0.018).mul(bulk) + texture(20., 0.015).mul(bulk) +
                texture(90., 0.012);
        tone += 0.10 * plateau.mul(cv::Mat(1. - exfoliation));
        paint_rods(tone, shapes.grooves);
        paint_rods(tone, shapes.fibres);
        const cv::Mat pit =
          bulk_tone * 0.55 + texture(5., 0.05) + texture(15., 0.04);
        tone = tone.mul(cv::Mat(1. - exfoliation)) + pit.mul(exfoliation);
        tone += 0.10 * rim(exfoliation);
        paint_cracks(tone, result);
        result.exfoliation = exfoliation > 0.5;
        result.plateau     = (plateau > 0.5) & (exfoliation <= 0.5);
        result.exfoliated_area =
          cv::countNonZero(result.exfoliation) * s.pixel_size * s.pixel_size;
        expose(tone, result);
        return result;
      }

    private:
      cv::Point
      fine(const cv::Point2d &p) const
      {
        const double scale = samples / s.pixel_size * (1 << shift);
        return {cvRound(p.x * scale), cvRound(p.y * scale)};
      }

      cv::Mat
      coarse(const cv::Mat &layer) const
      {
        cv::Mat small;
        cv::resize(layer, small, size, 0., 0., cv::INTER_AREA);
        small.convertTo(small, CV_32F, 1. / 255.);
        return small;
      }

      cv::Mat
      fine_layer() const
      {
        return cv::Mat::zeros(
          samples * size.height, samples * size.width, CV_8U);
      }

      cv::Mat
      areas(const std::vector<Curve> &curves) const
      {
        cv::Mat layer = fine_layer();
        for (const Curve &curve : curves)
          {
            std::vector<cv::Point> points;
            for (const cv::Point2d &p : curve)
              points.push_back(fine(p));
            cv::fillPoly(layer,
                         std::vector<std::vector<cv::Point>>{points},
                         255,
                         cv::LINE_8,
                         shift);
          }
        return coarse(layer);
      }

      /** Smooth random field with the given grain (um at feature size 1); the
       * same at every pixel size. */
      cv::Mat
      texture(const double grain, const double amplitude)
      {
        const double g = grain * s.feature_size / 2.;
        cv::Mat      grid(std::max(2, cvRound(s.height / g)),
                     std::max(2, cvRound(s.width / g)),
                     CV_32F);
        random.fill(grid, cv::RNG::NORMAL, 0., 1.);
        cv::GaussianBlur(grid, grid, cv::Size(), 1.);
        cv::Mat    field;
        const bool shrinks = grid.cols > size.width;
        cv::resize(grid,
                   field,
                   size,
                   0.,
                   0.,
                   shrinks ? cv::INTER_AREA : cv::INTER_CUBIC);
        cv::Scalar mean, deviation;
        cv::meanStdDev(grid, mean, deviation);
        return (field - mean[0]) * (amplitude / deviation[0]);
      }

      /** Edges charge up on the side of the detector. */
      cv::Mat
      rim(const cv::Mat &area) const
      {
        const int d = std::max(1, cvRound(3. * s.feature_size / s.pixel_size));
        cv::Mat   moved, edge;
        cv::warpAffine(area, moved, cv::Matx23d(1, 0, d, 0, 1, d), size);
        edge = moved - area;
        cv::max(edge, 0., edge);
        return edge;
      }

      void
      quad(cv::Mat           &layer,
           const cv::Point2d &a,
           const cv::Point2d &b,
           const double       wa,
           const double       wb,
           const double       value) const
      {
        const cv::Point2d d = b - a;
        const cv::Point2d n =
          cv::Point2d(-d.y, d.x) * (0.5 / std::max(1e-9, cv::norm(d)));
        const cv::Point corners[4] = {fine(a + wa * n),
                                      fine(b + wb * n),
                                      fine(b - wb * n),
                                      fine(a - wa * n)};
        cv::fillConvexPoly(layer, corners, 4, value, cv::LINE_8, shift);
      }

      void
      paint_rods(cv::Mat &tone, const std::vector<Rod> &rods) const
      {
        cv::Mat bright = fine_layer(), dark = fine_layer();
        for (const Rod &rod : rods)
          quad(rod.tone > 0. ? bright : dark,
               rod.begin,
               rod.end,
               rod.width,
               rod.width,
               255. * std::min(1., std::abs(rod.tone)));
        tone += coarse(bright) - coarse(dark);
      }

      void
      paint_cracks(cv::Mat &tone, Specimen &result) const
      {
        cv::Mat depth = fine_layer(), cover = fine_layer();
        cv::Mat centre = cv::Mat::zeros(size, CV_8U);
        for (const CrackShape &c : shapes.cracks)
          {
            result.n_cracks += !c.is_branch;
            for (std::size_t i = 0; i + 1 < c.line.size(); ++i)
              {
                const cv::Point2d &a = c.line[i], &b = c.line[i + 1];
                quad(
                  depth, a, b, c.width[i], c.width[i + 1], 255. * c.depth[i]);
                quad(cover, a, b, c.width[i], c.width[i + 1], 255.);
                for (cv::Mat *layer : {&depth, &cover})
                  cv::circle(*layer,
                             fine(b),
                             cvRound(0.5 * c.width[i + 1] * samples /
                                     s.pixel_size * (1 << shift)),
                             layer == &depth ? 255. * c.depth[i] : 255.,
                             cv::FILLED,
                             cv::LINE_8,
                             shift);
                const double k = (1 << shift) / s.pixel_size;
                const double o = -0.5 * (1 << shift);
                cv::line(centre,
                         {cvRound(a.x * k + o), cvRound(a.y * k + o)},
                         {cvRound(b.x * k + o), cvRound(b.y * k + o)},
                         255,
                         1,
                         cv::LINE_8,
                         shift);
              }
          }
        tone              = tone.mul(cv::Mat(1. - coarse(depth)));
        const cv::Mat all = coarse(cover);
        result.cracks     = (all > 0.5) | centre;
        result.crack_area = cv::sum(all)[0] * s.pixel_size * s.pixel_size;
        result.crack_length =
          seen_crack_length(shapes.cracks, cv::Size2d(s.width, s.height));
      }

      /** Shading, blur, noise, eight bits, data bar. */
      void
      expose(cv::Mat &tone, Specimen &result)
      {
        const double a = random.uniform(0., 2. * CV_PI);
        for (int y = 0; y < size.height; ++y)
          for (int x = 0; x < size.width; ++x)
            {
              const double u = double(x) / size.width - 0.5,
                           v = double(y) / size.height - 0.5;
              tone.at<float>(y, x) *=
                float(1. + s.shading * (std::cos(a) * u + std::sin(a) * v) -
                      0.5 * s.shading * (u * u + v * v));
            }
        cv::GaussianBlur(tone, tone, cv::Size(), 0.7);
        // Counting electrons: the noise grows with the root of the signal.
        cv::Mat noise(size, CV_32F), root;
        random.fill(noise, cv::RNG::NORMAL, 0., s.noise);
        cv::max(tone, 0., tone);
        cv::sqrt(tone * (1. / bulk_tone), root);
        tone = 255. * tone + noise.mul(root);
        tone.convertTo(result.image, CV_8U);
        if (s.data_bar)
          add_data_bar(result);
      }

      void
      add_data_bar(Specimen &result) const
      {
        const int bar = std::max(24, cvRound(0.05 * size.height));
        for (cv::Mat *m : {&result.image,
                           &result.cracks,
                           &result.exfoliation,
                           &result.plateau})
          cv::copyMakeBorder(
            *m, *m, 0, bar, 0, 0, cv::BORDER_CONSTANT, cv::Scalar(0));
        // The largest of 1, 2, 5 times a power of ten below a fifth.
        double length = 1e-3;
        for (const double decade : {1e-3, 1e-2, 0.1, 1., 10., 100., 1e3, 1e4})
          for (const double d : {1., 2., 5.})
            if (d * decade <= 0.2 * s.width)
              length = d * decade;
        const int n = cvRound(length / s.pixel_size);
        const int y = size.height + bar / 2;
        const int x = size.width - n - bar / 2;
        cv::rectangle(result.image, cv::Rect(x, y - 1, n, 3), 255, cv::FILLED);
        result.scale_bar        = {x - 4, y - 4, n + 8, 9};
        result.scale_bar_length = length;
        char text[64];
        std::snprintf(
          text, sizeof text, "%g um   SYNTHETIC   seed %u", length, s.seed);
        cv::putText(result.image,
                    text,
                    {bar / 3, size.height + 2 * bar / 3},
                    cv::FONT_HERSHEY_SIMPLEX,
                    bar / 60.,
                    255);
      }

      const SpecimenSettings &s;
      const SpecimenShapes    shapes;
      const cv::Size          size;
      cv::RNG                 random;
    };
  } // namespace



  Specimen
  make_specimen(const SpecimenSettings &settings)
  {
    return Painter(settings).paint();
  }
} // namespace squeal::tribology
