// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_tribology_straight_scenes_h
#define squeal_tests_tribology_straight_scenes_h

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <vector>

namespace squeal::testing
{
  /** A surface with straight cracks whose place is known. */
  struct StraightScene
  {
    cv::Mat             grey;    /**< CV_32F, 0 to 255 */
    cv::Mat             cracks;  /**< CV_8U */
    std::vector<double> lengths; /**< pixels */
  };

  /** A grainy surface of 512 x 512 pixels. */
  inline cv::Mat
  grainy_surface(cv::RNG &random)
  {
    const cv::Size size(512, 512);
    cv::Mat        grey(size, CV_32F, cv::Scalar(random.uniform(100., 160.)));
    for (const double deviation : {0.7, 2.5, 9.})
      {
        cv::Mat grains(size, CV_32F);
        random.fill(grains, cv::RNG::NORMAL, 0., 1.);
        cv::GaussianBlur(grains, grains, cv::Size(), deviation);
        cv::Scalar mean, spread;
        cv::meanStdDev(grains, mean, spread);
        grey += grains * (random.uniform(2., 5.) / spread[0]);
      }
    return grey;
  }



  /** Darkens a line of the width, blurred as by optics. */
  inline void
  darken_line(cv::Mat           &grey,
              const cv::Point2d &a,
              const cv::Point2d &b,
              const double       width,
              const double       contrast)
  {
    constexpr int fine = 4, shift = 6;
    cv::Mat layer = cv::Mat::zeros(fine * grey.rows, fine * grey.cols, CV_8U);
    const auto point = [&](const cv::Point2d &p) {
      return cv::Point(cvRound((p.x + 0.5) * fine * (1 << shift)),
                       cvRound((p.y + 0.5) * fine * (1 << shift)));
    };
    cv::line(layer,
             point(a),
             point(b),
             255,
             std::max(1, cvRound(fine * width)),
             cv::LINE_8,
             shift);
    cv::Mat cover;
    cv::resize(layer, cover, grey.size(), 0., 0., cv::INTER_AREA);
    cover.convertTo(cover, CV_32F, contrast / 255.);
    cv::GaussianBlur(cover, cover, cv::Size(), 0.7);
    grey -= cover;
  }



  /** Three straight cracks of 40 to 400 pixels in bands of their own; with
   * grooves in one direction through the whole image when asked for. */
  inline StraightScene
  straight_scene(const unsigned int seed, const bool with_grooves)
  {
    cv::RNG       random(seed);
    StraightScene scene;
    scene.grey   = grainy_surface(random);
    scene.cracks = cv::Mat::zeros(scene.grey.size(), CV_8U);
    if (with_grooves)
      {
        const double angle = random.uniform(0., CV_PI);
        const int    n     = random.uniform(12, 30);
        for (int i = 0; i < n; ++i)
          {
            const cv::Point2d u(std::cos(angle), std::sin(angle)), v(-u.y, u.x);
            const cv::Point2d c =
              cv::Point2d(256., 256.) + v * random.uniform(-360., 360.);
            darken_line(scene.grey,
                        c - 400. * u,
                        c + 400. * u,
                        random.uniform(1., 3.),
                        random.uniform(-25., 25.));
          }
      }
    for (int i = 0; i < 3; ++i)
      {
        const double      length = random.uniform(40., 400.);
        const double      angle  = random.uniform(-0.3, 0.3);
        const cv::Point2d half =
          0.5 * length * cv::Point2d(std::cos(angle), std::sin(angle));
        const cv::Point2d c(random.uniform(220., 292.), 100. + 156. * i);
        darken_line(scene.grey,
                    c - half,
                    c + half,
                    random.uniform(1., 3.),
                    random.uniform(30., 80.));
        cv::line(scene.cracks, c - half, c + half, 255);
        scene.lengths.push_back(length);
      }
    cv::min(cv::max(scene.grey, 0.), 255., scene.grey);
    return scene;
  }
} // namespace squeal::testing

#endif
