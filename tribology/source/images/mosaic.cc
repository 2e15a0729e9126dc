// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/tribology/images/mosaic.h>

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Edge of the smallest overlap that frames are aligned by, px. */
    constexpr int least_overlap = 48;

    /** Blocks of so many pixels leave nothing of the noise of a detector, and
     * their means spread by so many grey levels where anything is shown. */
    constexpr double block_edge = 8., least_spread = 3.;

    /** Frames of one exposure agree to this factor where they overlap. */
    constexpr double brightness_agreement = 1.1;

    /** In the pixels of @p fixed. */
    cv::Rect
    shared_part(const cv::Mat     &fixed,
                const cv::Mat     &moving,
                const cv::Point2d &shift)
    {
      return cv::Rect({0, 0}, fixed.size()) &
             cv::Rect({cvRound(shift.x), cvRound(shift.y)}, moving.size());
    }



    bool
    is_wide_enough(const cv::Rect &overlap)
    {
      return overlap.width >= least_overlap && overlap.height >= least_overlap;
    }



    bool
    shows_anything(const cv::Mat &part)
    {
      cv::Mat    coarse;
      cv::Scalar mean, spread;
      cv::resize(part,
                 coarse,
                 cv::Size(),
                 1. / block_edge,
                 1. / block_edge,
                 cv::INTER_AREA);
      cv::meanStdDev(coarse, mean, spread);
      return spread[0] >= least_spread;
    }
  } // namespace



  std::optional<cv::Point2d>
  refine_shift(const cv::Mat     &fixed,
               const cv::Mat     &moving,
               const cv::Point2d &start)
  {
    const cv::Point whole(cvRound(start.x), cvRound(start.y));
    const cv::Rect  overlap = shared_part(fixed, moving, start);
    if (!is_wide_enough(overlap))
      return std::nullopt;
    cv::Mat1f     warp = cv::Mat1f::eye(2, 3);
    const cv::Mat a    = fixed(overlap);
    const cv::Mat b    = moving(overlap - whole);
    try
      {
        const double correlation = cv::findTransformECC(
          a,
          b,
          warp,
          cv::MOTION_TRANSLATION,
          cv::TermCriteria(
            cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-6),
          cv::noArray(),
          5);
        if (correlation < 0.3)
          return std::nullopt;
      }
    catch (const cv::Exception &)
      {
        // It throws when it does not converge.
        return std::nullopt;
      }
    // A point p of the fixed image is at p + warp in the moving one.
    return cv::Point2d(whole) - cv::Point2d(warp(0, 2), warp(1, 2));
  }



  namespace
  {
    /** A frame and the earlier one that it is aligned to. */
    struct Overlap
    {
      std::size_t frame, other;
      cv::Point2d start;              /**< px, by the stage */
      bool        is_judged  = false; /**< wide enough, and with a texture */
      bool        is_refined = false;

      bool
      is_beside() const
      {
        return std::abs(start.x) >= std::abs(start.y);
      }
    };



    /** Places frames one by one and judges their overlaps. */
    class Joiner
    {
    public:
      Joiner(const std::vector<Micrograph> &frames, Mosaic &mosaic)
        : frames(frames)
        , mosaic(mosaic)
      {
      }

      void
      operator()()
      {
        read_stage();
        mosaic.shifts = stage;
        for (std::size_t i = 1; i < frames.size(); ++i)
          if (const std::size_t other = neighbour_of(i); other != i)
            align({i, other, stage[i] - stage[other]});
        refuse_mismatch();
        if (n_narrow > 0)
          mosaic.warnings.push_back(
            std::to_string(n_narrow) +
            " images overlap their neighbour by less than " +
            std::to_string(least_overlap) +
            " pixels: they lie by the stage positions alone, and nothing tells "
            "whether these are right");
      }

    private:
      void
      read_stage()
      {
        for (const Micrograph &m : frames)
          {
            const Placement p = place_by_stage(m);
            if (std::abs(m.pixel_size / frames[0].pixel_size - 1.) > 1e-3)
              throw InputError(m.path + " and " + frames[0].path +
                               " have different pixel sizes: a mosaic needs "
                               "one");
            stage.push_back(p({0., 0.}) * (1. / m.pixel_size));
          }
      }

      /** The earlier frame that shares the largest area by the stage; @p i
       * where there is none. */
      std::size_t
      neighbour_of(const std::size_t i) const
      {
        double      most  = 0.;
        std::size_t other = i;
        for (std::size_t j = 0; j < i; ++j)
          {
            const cv::Rect2d r =
              cv::Rect2d(stage[i], cv::Size2d(frames[i].frame.size())) &
              cv::Rect2d(stage[j], cv::Size2d(frames[j].frame.size()));
            if (r.area() > most)
              {
                most  = r.area();
                other = j;
              }
          }
        return other;
      }

      cv::Mat
      picture(const std::size_t i) const
      {
        return frames[i].grey(frames[i].frame);
      }

      /** From the difference of two places of the stage: a start from the
       * corrected place of the neighbour would add up all corrections before
       * it. */
      void
      align(Overlap o)
      {
        const cv::Mat     fixed = picture(o.other), moving = picture(o.frame);
        const cv::Rect    part    = shared_part(fixed, moving, o.start);
        const auto        refined = refine_shift(fixed, moving, o.start);
        const cv::Point2d shift   = refined.value_or(o.start);
        mosaic.shifts[o.frame]    = mosaic.shifts[o.other] + shift;
        mosaic.correction         = std::max(
          mosaic.correction, cv::norm(mosaic.shifts[o.frame] - stage[o.frame]));
        if (!is_wide_enough(part))
          {
            ++n_narrow;
            return;
          }
        o.is_refined = refined.has_value();
        o.is_judged =
          o.is_refined ||
          (shows_anything(fixed(part)) &&
           shows_anything(moving(shared_part(moving, fixed, -o.start))));
        ++mosaic.n_tried;
        mosaic.n_refined += o.is_refined;
        overlaps.push_back(o);
        if (o.is_refined)
          compare_brightness(o, shift);
        else
          mosaic.warnings.push_back(
            frames[o.frame].path + " and " + frames[o.other].path +
            (o.is_judged ? " do not show the same where they overlap by their "
                           "stage positions"
                         : " show nothing to align them by where they "
                           "overlap") +
            ": the first lies by the stage position alone");
      }

      void
      compare_brightness(const Overlap &o, const cv::Point2d &shift)
      {
        const cv::Mat fixed = picture(o.other), moving = picture(o.frame);
        const double  a =
          quantile_of(fixed(shared_part(fixed, moving, shift)), 0.5);
        const double b =
          quantile_of(moving(shared_part(moving, fixed, -shift)), 0.5);
        // One grey level keeps black pictures out.
        const double ratio = (b + 1.) / (a + 1.);
        if (ratio > brightness_agreement || ratio < 1. / brightness_agreement)
          mosaic.warnings.push_back(
            frames[o.frame].path + " is " + rounded_text(ratio, 2) +
            " times as bright as " + frames[o.other].path +
            " where they overlap: cracks and areas are told by brightness, so "
            "give both with one exposure and one range");
      }

      /** Hardly any match: the stage does not run as the images do. */
      void
      refuse_mismatch() const
      {
        int n_judged[2] = {0, 0}, n_failed[2] = {0, 0}, n_reversed[2] = {0, 0};
        std::string first;
        for (const Overlap &o : overlaps)
          {
            const int axis = o.is_beside() ? 0 : 1;
            n_judged[axis] += o.is_judged;
            if (!o.is_judged || o.is_refined)
              continue;
            ++n_failed[axis];
            if (first.empty())
              first = frames[o.frame].path + " and " + frames[o.other].path;
          }
        const int n_all  = n_judged[0] + n_judged[1],
                  failed = n_failed[0] + n_failed[1];
        bool mismatch    = 2 * failed > n_all;
        // A single overlap may be spoilt by one bad image.
        for (int axis = 0; axis < 2; ++axis)
          mismatch |= n_failed[axis] > 1 && 2 * n_failed[axis] > n_judged[axis];
        if (!mismatch)
          return;
        for (const Overlap &o : overlaps)
          if (o.is_judged && !o.is_refined)
            n_reversed[o.is_beside() ? 0 : 1] += matches_reversed(o);
        std::string advice;
        for (int axis = 0; axis < 2; ++axis)
          if (2 * n_reversed[axis] > n_failed[axis])
            advice += std::string(advice.empty() ? "" : " and ") +
                      (axis == 0 ? "x" : "y");
        throw InputError(
          "'Segmentation/Mosaic': " + std::to_string(failed) + " of " +
          std::to_string(n_all) +
          " overlaps of images do not show the same, the first that of " +
          first + ": " +
          (advice.empty()
             ? "check the stage positions and the directions of their axes (x "
               "to the right in the images, y downwards), and whether images "
               "are mirrored or turned"
             : "they match with the other sign of the stage position in " +
                 advice +
                 ", which has to run to the right in the images in x and "
                 "downwards in y: change it in the metadata, or the images if "
                 "they are mirrored"));
      }

      bool
      matches_reversed(const Overlap &o) const
      {
        const cv::Point2d start = o.is_beside()
                                    ? cv::Point2d(-o.start.x, o.start.y)
                                    : cv::Point2d(o.start.x, -o.start.y);
        return refine_shift(picture(o.other), picture(o.frame), start)
          .has_value();
      }

      const std::vector<Micrograph> &frames;
      Mosaic                        &mosaic;
      std::vector<cv::Point2d>       stage; /**< px, upper left corners */
      std::vector<Overlap>           overlaps;
      int                            n_narrow = 0;
    };



    /** Draws frames at their shifts, which then count from the corner of the
     * mosaic. */
    void
    draw_frames(const std::vector<Micrograph> &frames,
                const double                   largest,
                Mosaic                        &result)
    {
      cv::Point2d low = result.shifts[0], high = low;
      for (std::size_t i = 0; i < frames.size(); ++i)
        {
          const cv::Point2d s = result.shifts[i];
          low                 = {std::min(low.x, s.x), std::min(low.y, s.y)};
          high                = {std::max(high.x, s.x + frames[i].frame.width),
                                 std::max(high.y, s.y + frames[i].frame.height)};
        }
      // beyond whole numbers the stage positions are nonsense anyway
      const cv::Point2d extent = high - low;
      if (!(extent.x < 1e9 && extent.y < 1e9))
        throw InputError(
          "the mosaic of 'Images' would have more than 1e9 pixels "
          "on an edge: check the stage positions");
      require_room("the mosaic of 'Images' (check the stage positions)",
                   {std::uint64_t(extent.x), std::uint64_t(extent.y)},
                   largest);
      // As far as the frames reach at whole pixels: an empty row would be a
      // dark line.
      const cv::Size size(cvRound(high.x - low.x), cvRound(high.y - low.y));
      cv::Mat        weight = cv::Mat::zeros(size, CV_32F);
      result.grey           = cv::Mat::zeros(size, CV_32F);
      for (std::size_t i = 0; i < frames.size(); ++i)
        {
          result.shifts[i] -= low;
          const cv::Point at(cvRound(result.shifts[i].x),
                             cvRound(result.shifts[i].y));
          const cv::Rect  place =
            cv::Rect(at, frames[i].frame.size()) & cv::Rect({0, 0}, size);
          const cv::Rect part({0, 0}, place.size());
          cv::Mat        shown(part.size(), CV_32F, cv::Scalar(1.));
          if (!frames[i].seen.empty())
            shown.setTo(0., ~frames[i].seen(frames[i].frame)(part));
          result.grey(place) +=
            frames[i].grey(frames[i].frame)(part).mul(shown);
          weight(place) += shown;
        }
      if (cv::countNonZero(weight) < int(weight.total()))
        result.seen = weight > 0.;
      cv::max(weight, 1., weight);
      result.grey /= weight;
    }
  } // namespace



  Mosaic
  join_frames(const std::vector<Micrograph> &frames, const double largest)
  {
    Mosaic result;
    Joiner(frames, result)();
    draw_frames(frames, largest, result);
    return result;
  }
} // namespace squeal::tribology
