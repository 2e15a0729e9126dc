// SPDX-License-Identifier: LGPL-2.1-or-later

// Two frames are joined where they show the same, and not by a chance
// correlation where the stage has them elsewhere.
#include <squeal/base/exceptions.h>
#include <squeal/tribology/images/frame_overlap.h>
#include <squeal/tribology/images/mosaic.h>
#include <squeal/tribology/images/specimen.h>

#include <opencv2/imgproc.hpp>

#include <cmath>

#include "check.h"
#include "cut_frames.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  /** What the detector adds to each frame by itself: brightness that falls off
   * to one corner, the same in all frames, and noise. */
  void
  expose(Micrograph  &m,
         const double shading,
         const double gain,
         cv::RNG     &random)
  {
    for (int y = 0; y < m.grey.rows; ++y)
      for (int x = 0; x < m.grey.cols; ++x)
        m.grey.at<float>(y, x) *= float(
          gain *
          (1. - shading * (double(x) / m.grey.cols + double(y) / m.grey.rows)));
    cv::Mat noise(m.grey.size(), CV_32F);
    random.fill(noise, cv::RNG::NORMAL, 0., 8.);
    m.grey += noise;
  }



  struct Score
  {
    int n_joined = 0, n_right = 0;
  };

  /** Two frames of each of @p n pictures beside each other with an overlap of
   * 60 to 90 pixels. */
  Score
  score_of(const int n, const cv::Point2d &stage, cv::RNG &random)
  {
    Score score;
    for (int k = 0; k < n; ++k)
      {
        SpecimenSettings settings;
        settings.width         = 400.;
        settings.height        = 300.;
        settings.crack_density = 60.;
        settings.data_bar      = false;
        settings.seed          = 1 + k;
        cv::Mat grey;
        make_specimen(settings).image.convertTo(grey, CV_32F);
        const int width = 230 + random.uniform(0, 16);
        auto      frames =
          frames_of(grey, {width, 290}, {{0, 0}, {400 - width, k % 10}}, stage);
        expose(frames[0], 0.2, 1., random);
        expose(frames[1], 0.2, 0.95, random);
        frames[1].metadata.stage->x += random.uniform(-12., 12.);
        try
          {
            const Mosaic mosaic = join_frames(frames);
            score.n_joined += mosaic.n_refined;
            score.n_right += mosaic.n_refined == 1 &&
                             cv::norm(mosaic.shifts[1] - mosaic.shifts[0] -
                                      cv::Point2d(400 - width, k % 10)) < 0.5;
          }
        catch (const InputError &)
          {
            // refused
          }
      }
    return score;
  }

  void
  check_chance_correlations()
  {
    cv::RNG     random(11);
    const int   n     = 50;
    const Score right = score_of(n, {1., 1.}, random);
    check(right.n_joined == n && right.n_right == n,
          "all frames that show the same are joined there: " +
            std::to_string(right.n_right) + " of " + std::to_string(n));
    const Score wrong = score_of(n, {-1., 1.}, random);
    check(wrong.n_joined == 0,
          "with the stage reversed none is: " + std::to_string(wrong.n_joined) +
            " of " + std::to_string(n));
  }



  /** Shading that all frames have fits at a place that says nothing. */
  void
  check_shading()
  {
    cv::RNG       random(3);
    const cv::Mat even(300, 400, CV_32F, cv::Scalar(150.));
    auto frames = frames_of(even, {250, 300}, {{0, 0}, {150, 0}}, {1., 1.});
    for (Micrograph &m : frames)
      expose(m, 0.2, 1., random);
    const Mosaic mosaic = join_frames(frames);
    check(mosaic.n_refined == 0 && mosaic.warnings.size() == 1 &&
            mosaic.warnings[0].find("nothing to align") != std::string::npos,
          "frames that show noise and shading lie by their stage positions");
    check_close(mosaic.correction, 0., 1e-12, "which stay as they are");
  }



  /** The lead of a match is told from that of none. */
  void
  check_lead()
  {
    cv::RNG random(5);
    cv::Mat a(90, 120, CV_32F), b(90, 120, CV_32F);
    random.fill(a, cv::RNG::NORMAL, 100., 20.);
    random.fill(b, cv::RNG::NORMAL, 100., 20.);
    check(lead_over_other_shifts(a, a) > 10., "a picture on itself");
    check(lead_over_other_shifts(a, 0.5 * a + 0.5 * b) > 5.,
          "half of it is noise");
    check(lead_over_other_shifts(a, b) < 0., "another picture");
    const cv::Mat flat(90, 120, CV_32F, cv::Scalar(50.));
    check(lead_over_other_shifts(flat, flat) == 0., "nothing shown");
    check(lead_over_other_shifts({}, {}) == 0., "no overlap");
    // Stripes fit as well a period of 20 pixels beside.
    cv::Mat stripes(90, 120, CV_32F);
    for (int x = 0; x < stripes.cols; ++x)
      stripes.col(x) = 100. + 50. * std::cos(CV_PI * x / 10.);
    check(lead_over_other_shifts(stripes + 0.1 * a, stripes + 0.1 * b) < 1.,
          "a pattern that repeats itself");
  }
} // namespace



int
main()
{
  cv::setNumThreads(1);
  check_lead();
  check_shading();
  check_chance_correlations();
}
