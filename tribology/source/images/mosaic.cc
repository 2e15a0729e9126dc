// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/tribology/images/frame_overlap.h>
#include <squeal/tribology/images/mosaic.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace squeal::tribology
{
  namespace
  {
    /** Frames that lie as far from where their overlap shows the same draw a
     * crack double, px. */
    constexpr double largest_misfit = 2.;

    /** Frames of one exposure agree to this factor where they overlap. */
    constexpr double brightness_agreement = 1.1;



    /** A frame and an earlier one. */
    struct Overlap
    {
      std::size_t frame, other;
      cv::Point2d start;              /**< px, by the stage */
      cv::Point2d shift      = start; /**< as they fit, px */
      double      area       = 0.;    /**< px, by the stage */
      bool        is_wide    = false; /**< enough to align them */
      bool        is_judged  = false; /**< wide, and with a texture */
      bool        is_refined = false; /**< shows the same in both */
      bool        is_off     = false; /**< but not where others place them */
      bool        is_link    = false; /**< one of those that place frames */

      bool
      is_beside() const
      {
        return std::abs(start.x) >= std::abs(start.y);
      }
    };



    /** Aligns frames by pairs, places all of them and judges every overlap. */
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
          for (std::size_t j = 0; j < i; ++j)
            overlaps.push_back(aligned({i, j, stage[i] - stage[j]}));
        place();
        int n_narrow = 0;
        for (Overlap &o : overlaps)
          {
            if (!o.is_link)
              check_where_placed(o);
            n_narrow += o.is_link && !o.is_wide;
            report(o);
          }
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

      cv::Mat
      picture(const std::size_t i) const
      {
        return frames[i].grey(frames[i].frame);
      }

      bool
      is_wide_at(const Overlap &o, const cv::Point2d &shift) const
      {
        return is_wide_enough(
          shared_part(picture(o.other), picture(o.frame), shift));
      }

      bool
      show_anything(const Overlap &o, const cv::Point2d &shift) const
      {
        const cv::Mat fixed = picture(o.other), moving = picture(o.frame);
        return shows_anything(fixed(shared_part(fixed, moving, shift))) &&
               shows_anything(moving(shared_part(moving, fixed, -shift)));
      }

      /** From the difference of two places of the stage: a start from corrected
       * places would add up all corrections before it. */
      Overlap
      aligned(Overlap o) const
      {
        const auto place_of = [&](const std::size_t i) {
          return cv::Rect2d(stage[i], cv::Size2d(frames[i].frame.size()));
        };
        o.area    = (place_of(o.frame) & place_of(o.other)).area();
        o.is_wide = is_wide_at(o, o.start);
        if (!o.is_wide)
          return o;
        const auto refined =
          refine_shift(picture(o.other), picture(o.frame), o.start);
        o.shift      = refined.value_or(o.start);
        o.is_refined = refined.has_value();
        o.is_judged  = o.is_refined || show_anything(o, o.start);
        return o;
      }

      /** By a tree over all overlaps, those that show anything and large ones
       * first, whatever the order of the frames is. A match goes before no
       * larger overlap without: small ones match by chance. */
      void
      place()
      {
        std::vector<Overlap *> order;
        for (Overlap &o : overlaps)
          if (o.area > 0.)
            order.push_back(&o);
        std::stable_sort(
          order.begin(), order.end(), [](const Overlap *a, const Overlap *b) {
            return std::pair(a->is_judged, a->area) >
                   std::pair(b->is_judged, b->area);
          });
        // The first frame of those that hang together stays where it is.
        std::vector<std::size_t> group(frames.size());
        std::iota(group.begin(), group.end(), std::size_t(0));
        for (Overlap *o : order)
          {
            const std::size_t a = group[o->other], b = group[o->frame];
            if (a == b)
              continue;
            o->is_link            = true;
            const cv::Point2d gap = o->shift - shift_between(*o);
            for (std::size_t k = 0; k < frames.size(); ++k)
              if (group[k] == std::max(a, b))
                {
                  mosaic.shifts[k] += a < b ? gap : -gap;
                  group[k] = std::min(a, b);
                }
          }
        for (std::size_t i = 0; i < frames.size(); ++i)
          mosaic.correction =
            std::max(mosaic.correction, cv::norm(mosaic.shifts[i] - stage[i]));
      }

      /** As frames are placed. */
      cv::Point2d
      shift_between(const Overlap &o) const
      {
        return mosaic.shifts[o.frame] - mosaic.shifts[o.other];
      }

      /** Whether frames that others place show the same there. */
      void
      check_where_placed(Overlap &o) const
      {
        const cv::Point2d placed = shift_between(o);
        const auto        fits   = [&]() {
          return o.is_refined && cv::norm(o.shift - placed) <= largest_misfit;
        };
        o.is_wide = is_wide_at(o, placed);
        if (!o.is_wide)
          o.is_judged = o.is_refined = false;
        if (!o.is_wide || fits())
          return;
        if (const auto again =
              refine_shift(picture(o.other), picture(o.frame), placed))
          {
            o.shift      = *again;
            o.is_refined = true;
          }
        o.is_judged = o.is_refined || show_anything(o, placed);
        o.is_off    = o.is_refined && !fits();
      }

      /** Counts an overlap and warns of what is odd about it. */
      void
      report(const Overlap &o)
      {
        if (!o.is_wide)
          return;
        ++mosaic.n_tried;
        mosaic.n_refined += o.is_refined && !o.is_off;
        const std::string both =
          frames[o.frame].path + " and " + frames[o.other].path;
        if (o.is_off)
          mosaic.warnings.push_back(
            both + " show the same where they overlap, but " +
            rounded_text(cv::norm(o.shift - shift_between(o)), 2) +
            " pixels beside where other overlaps place them: cracks there are "
            "drawn double");
        else if (o.is_refined)
          compare_brightness(o, shift_between(o));
        else if (o.is_link)
          mosaic.warnings.push_back(
            both +
            (o.is_judged ? " do not show the same where they overlap by their "
                           "stage positions"
                         : " show nothing to align them by where they "
                           "overlap") +
            ": they lie to one another by their stage positions alone");
        else if (o.is_judged)
          mosaic.warnings.push_back(
            both + " do not show the same where they overlap as other overlaps "
                   "place them: cracks there may count twice");
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

      /** Whether frames are neighbours by a corner, which no axis of the stage
       * places. */
      bool
      is_by_corner(const Overlap &o) const
      {
        const cv::Size size = frames[o.frame].frame.size();
        const double   x    = std::abs(o.start.x) / size.width,
                     y      = std::abs(o.start.y) / size.height;
        return std::min(x, y) > 0.5 * std::max(x, y);
      }

      /** Hardly any match: the stage does not run as the images do. */
      void
      refuse_mismatch() const
      {
        std::vector<const Overlap *> judged, beside;
        for (const Overlap &o : overlaps)
          if (o.is_judged)
            {
              judged.push_back(&o);
              if (!is_by_corner(o))
                beside.push_back(&o);
            }
        if (!beside.empty())
          judged = beside;
        int n_judged[2] = {0, 0}, n_failed[2] = {0, 0}, n_reversed[2] = {0, 0};
        std::string first;
        for (const Overlap *o : judged)
          {
            const int axis = o->is_beside() ? 0 : 1;
            ++n_judged[axis];
            if (o->is_refined)
              continue;
            ++n_failed[axis];
            if (first.empty())
              first = frames[o->frame].path + " and " + frames[o->other].path;
          }
        const int n_all  = n_judged[0] + n_judged[1],
                  failed = n_failed[0] + n_failed[1];
        bool mismatch    = 2 * failed > n_all;
        // A single overlap may be spoilt by one bad image.
        for (int axis = 0; axis < 2; ++axis)
          mismatch |= n_failed[axis] > 1 && 2 * n_failed[axis] > n_judged[axis];
        if (!mismatch)
          return;
        for (const Overlap *o : judged)
          if (!o->is_refined)
            n_reversed[o->is_beside() ? 0 : 1] += matches_reversed(*o);
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
      std::vector<cv::Point2d>       stage;    /**< px, upper left corners */
      std::vector<Overlap>           overlaps; /**< of all pairs */
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
