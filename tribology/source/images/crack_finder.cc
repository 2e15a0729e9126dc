// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/agreement.h>
#include <squeal/tribology/images/crack_finder.h>
#include <squeal/tribology/images/crack_growth.h>
#include <squeal/tribology/images/line_objection.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    // Cracks are sought with filters of half an octave less, but with the wide
    // ones where these make them stronger and bring more evidence, by factors.
    constexpr double narrow_filters = 0.7; // pixels, deviation
    constexpr double stronger = 1.03, more_evidence = 1.5;
    // Log odds of a line that belongs to a crack, and their sum over the pixels
    // of a crack, of (odds + 1).
    constexpr double to_belong  = -0.5;
    constexpr double counts     = -1.;
    constexpr double needed_sum = 45.;
    // Depth against flanks at 6 pixels over that at 4. Of the straight lines in
    // 63 images with cracks, none of those that are kept has more than 1.7.
    constexpr double band_breadth = 2.;
    // Log odds, of lines that are listed although they are left out.
    constexpr double worth_a_word = -3.;
    // In pixels.
    constexpr int    longest_spur    = 6;
    constexpr int    shortest_crack  = 14;
    constexpr int    shortest_end    = 4;
    constexpr int    shortest_bridge = 5;
    constexpr int    shortest_listed = 12;
    constexpr double far_ahead = 70., ahead = 35.;
    // Straight lines of this length that are no cracks lead none on.
    constexpr double longest_straight = 110.;
    constexpr int    groove_width     = 3;
    constexpr double enough_wavy      = 50.;         // to tell shallow lines by
    constexpr double less_dark = 0.6, shallow = 0.3; // shares of theirs
    constexpr double same_line = 2.;                 // pixels apart
    // Share of what was led on to without a line of its own that is wrong.
    constexpr double led_wrong = 0.3;
    // Log odds of a line being true once it is part of a crack: slope and
    // offset over its log odds.
    constexpr double found_slope = 0.37, found_offset = 0.48;
    // Where no crack is found a line of log odds above this has even odds.
    constexpr double unsettled_odds = -4., even_odds = 0.5;
    // Of so few pixels images are looked at enlarged: paths of 36 pixels do not
    // follow their cracks, and crests are lost that no judge can bring back.
    constexpr std::size_t few_pixels  = 256 * 256;
    constexpr int         halved_spur = 2; // pixels

    double
    probability(const double log_odds)
    {
      return 1. / (1. + std::exp(-log_odds));
    }



    void
    paint(cv::Mat &mask, const PixelPath &pixels, const uchar value)
    {
      for (const cv::Point &p : pixels)
        mask.at<uchar>(p) = value;
    }



    /** Cracks in the judged lines of an image. */
    class Search
    {
    public:
      Search(const cv::Mat    &grey,
             const RidgeField &ridges,
             const LineJudge  &judge,
             const SeenPixels &seen,
             const double      enlargement)
        : ridges(ridges)
        , judge(judge)
        , seen(seen)
        , enlargement(enlargement)
        , lines(grey, this->ridges)
      {
        lines.judge(judge);
        choose();
        start = lines.graph.draw(kept);
        remove_hooks();
        remove_spurs(start, longest_spur);
      }

      bool
      is_empty() const
      {
        return cv::countNonZero(start) == 0;
      }

      /** The strength of the cracks in other filters over that in these: the
       * median over their pixels. A crest may lie a pixel beside. */
      double
      strength_in(const RidgeField &other) const
      {
        cv::Mat strength, other_strength;
        cv::dilate(ridges.strength, strength, cv::Mat());
        cv::dilate(other.strength, other_strength, cv::Mat());
        PixelPath pixels;
        cv::findNonZero(start, pixels);
        std::vector<float> ratio;
        for (const cv::Point &p : pixels)
          ratio.push_back(other_strength.at<float>(p) /
                          std::max(0.01F, strength.at<float>(p)));
        const auto middle = ratio.begin() + ratio.size() / 2;
        std::nth_element(ratio.begin(), middle, ratio.end());
        return *middle;
      }

      /** Sum over the pixels of the cracks. */
      double
      all_evidence() const
      {
        double sum = 0.;
        for (std::size_t i = 0; i < kept.size(); ++i)
          if (kept[i])
            sum += double(lines.cores[i].size()) * evidence(i);
        return sum;
      }

      /** The cracks with what goes on from their ends. */
      CrackLines
      finished() const
      {
        cv::Mat cracks = start;
        if (cv::countNonZero(start) > 0)
          {
            // Neither grooves nor the outermost pixels nor what is not seen
            // lead a crack on.
            cv::Mat closed = grooves();
            cv::rectangle(closed, cv::Rect({0, 0}, closed.size()), 255);
            if (!seen.empty())
              closed |= ~seen;
            cv::Mat free = ridges.local.clone();
            free.setTo(0., closed);
            const cv::Mat1f &dark = lines.darkness;
            cracks =
              CrackGrowth(ridges, free, dark, start, far_ahead).grow(start);
            const CrackGrowth near(ridges, free, dark, cracks, ahead);
            cracks = near.finish_ends(near.grow(cracks));
            remove_spurs(cracks, longest_spur);
            cracks = near.place_ends(cracks);
          }
        keep_seen(cracks, seen);
        CrackLines result{ridges, cracks, {}, {}};
        account(result);
        return result;
      }

    private:
      /** Lines that belong to connected parts with enough evidence. */
      void
      choose()
      {
        const std::size_t n = lines.log_odds.size();
        for (std::size_t i = 0; i < n; ++i)
          {
            const int  length = int(lines.cores[i].size());
            const bool is_end = lines.graph.edges[i].nodes.size() < 2;
            kept.push_back((!is_end && length <= shortest_bridge) ||
                           (lines.log_odds[i] >= to_belong &&
                            length >= shortest_end && !is_band(i)));
          }
        drop_shallow_lines();
        part = lines.graph.parts(kept);
        std::vector<double> sum(n, 0.), length(n, 0.);
        for (std::size_t i = 0; i < n; ++i)
          if (kept[i])
            {
              const double own = double(lines.cores[i].size());
              length[part[i]] += own;
              sum[part[i]] += own * evidence(i);
            }
        for (std::size_t i = 0; i < n; ++i)
          if (kept[i])
            kept[i] = sum[part[i]] >= needed_sum * enlargement &&
                      length[part[i]] >= shortest_crack * enlargement;
      }

      /** Straight lines that have little of the darkness of the wavy ones: a
       * groove that cracks cross, or that runs beside them. */
      void
      drop_shallow_lines()
      {
        // A wide crack has its flanks beyond those that darkness is measured
        // against, a groove in a bright place is as bright as the image.
        double length = 0., darkness = 0., depth = 0.;
        for (std::size_t i = 0; i < kept.size(); ++i)
          if (kept[i] && !is_straight(i))
            {
              const double own = double(lines.cores[i].size());
              length += own;
              darkness += own * feature(i, LineFeature::darkness);
              depth += own * (1. - feature(i, LineFeature::level));
            }
        if (length < enough_wavy)
          return;
        for (std::size_t i = 0; i < kept.size(); ++i)
          if (is_straight(i) &&
              length * feature(i, LineFeature::darkness) <
                less_dark * darkness &&
              length * (1. - feature(i, LineFeature::level)) < shallow * depth)
            kept[i] = 0;
      }

      /** Takes what lies beyond the cores off the free ends of lines. */
      void
      remove_hooks()
      {
        for (std::size_t i = 0; i < kept.size(); ++i)
          {
            PixelPath        axis = lines.graph.edges[i].piece.axis;
            const PixelPath &core = lines.cores[i];
            for (const cv::Point &inner : {core.front(), core.back()})
              {
                if (kept[i] && n_neighbours(start, axis.front()) == 1)
                  for (const cv::Point &p : axis)
                    {
                      if (p == inner)
                        break;
                      start.at<uchar>(p) = 0;
                    }
                std::reverse(axis.begin(), axis.end());
              }
          }
      }

      double
      feature(const std::size_t i, const LineFeature k) const
      {
        return lines.features[i][std::size_t(k)];
      }

      bool
      is_straight(const std::size_t i) const
      {
        return feature(i, LineFeature::straight_run) >
               std::log1p(longest_straight / 20.);
      }

      /** The middle of a straight dark band that is wider than the flanks which
       * a line is compared with: deeper the farther one looks. A band of
       * grooves or a joint, whatever the trees make of depths near zero. */
      bool
      is_band(const std::size_t i) const
      {
        return is_straight(i) &&
               feature(i, LineFeature::breadth) > band_breadth;
      }

      /** What each pixel of a line adds to its crack. */
      double
      evidence(const std::size_t i) const
      {
        return std::max(0., lines.log_odds[i] - counts);
      }

      /** Where straight lines run that are no cracks. */
      cv::Mat
      grooves() const
      {
        cv::Mat result = cv::Mat::zeros(start.size(), CV_8U);
        for (std::size_t i = 0; i < kept.size(); ++i)
          if (!kept[i] && is_straight(i))
            paint(result, lines.graph.edges[i].piece.pixels, 255);
        cv::dilate(result, result, cv::Mat(), {-1, -1}, groove_width);
        return result;
      }

      /** What was left out, and what may be wrong. */
      void
      account(CrackLines &result) const
      {
        result.doubt.is_drawn = false;
        const cv::Mat found   = widened(result.centre_line, same_line);
        const bool    is_none = cv::countNonZero(found) == 0;
        cv::Mat       judged  = cv::Mat::zeros(start.size(), CV_8U);
        double        square  = 0.;
        for (std::size_t i = 0; i < kept.size(); ++i)
          {
            const PixelPath &core = lines.cores[i];
            const double     p    = probability(lines.log_odds[i]);
            double           n    = 0.;
            for (const cv::Point &q : core)
              n += found.at<uchar>(q) != 0;
            const double missing = double(core.size()) - n;
            result.doubt.missed += p * missing;
            result.doubt.invented +=
              (1. -
               probability(found_slope * lines.log_odds[i] + found_offset)) *
              n;
            if (is_none && lines.log_odds[i] > unsettled_odds)
              square += even_odds * double(core.size()) * double(core.size());
            paint(judged, core, 255);
            if (lines.log_odds[i] >= worth_a_word &&
                int(core.size()) >= shortest_listed && n < missing)
              result.excluded.push_back(
                {core,
                 p,
                 is_band(i) ? Exclusion::border
                 : lines.log_odds[i] >= to_belong
                   ? Exclusion::small
                   : main_objection(judge, lines.features[i])});
          }
        result.doubt.unsettled = std::sqrt(square);
        cv::Mat led            = result.centre_line.clone();
        led.setTo(0, widened(judged, same_line));
        result.doubt.invented += led_wrong * cv::countNonZero(led);
      }

      const RidgeField  ridges;
      const LineJudge  &judge;
      const SeenPixels  seen;
      const double      enlargement; // pixels in one of the image
      JudgedLines       lines;
      std::vector<char> kept;
      std::vector<int>  part;
      cv::Mat           start;
    };



    /** Cracks in the pixels of the image. Those of an @p enlargement are not
     * independent: it needs as many more for the same evidence. */
    CrackLines
    find_in_pixels(const cv::Mat    &grey,
                   const int         n_octaves,
                   const LineJudge  &judge,
                   const SeenPixels &seen,
                   const double      enlargement = 1.)
    {
      const Search narrow(grey,
                          filter_ridges(grey, n_octaves, narrow_filters, seen),
                          judge,
                          seen,
                          enlargement);
      if (narrow.is_empty())
        return narrow.finished();
      const RidgeField ridges = filter_ridges(grey, n_octaves, 1., seen);
      if (narrow.strength_in(ridges) < stronger)
        return narrow.finished();
      const Search wide(grey, ridges, judge, seen, enlargement);
      return wide.all_evidence() < more_evidence * narrow.all_evidence()
               ? narrow.finished()
               : wide.finished();
    }



    /** A line of an image that was enlarged by two, in its own pixels. */
    cv::Mat
    halved(const cv::Mat &line, const cv::Size &size)
    {
      cv::Mat share;
      line.convertTo(share, CV_32F);
      cv::resize(share, share, size, 0., 0., cv::INTER_AREA);
      cv::Mat result = thin(share > 0.);
      remove_spurs(result, halved_spur);
      return result;
    }



    PixelPath
    halved(const PixelPath &line)
    {
      PixelPath result;
      for (const cv::Point &p : line)
        if (const cv::Point q(p.x / 2, p.y / 2);
            result.empty() || q != result.back())
          result.push_back(q);
      return result;
    }



    /** Cracks in an image that is enlarged by two for it. */
    CrackLines
    find_enlarged(const cv::Mat    &grey,
                  const int         n_octaves,
                  const LineJudge  &judge,
                  const SeenPixels &seen)
    {
      cv::Mat    twice;
      SeenPixels twice_seen;
      cv::resize(grey, twice, cv::Size(), 2., 2., cv::INTER_CUBIC);
      if (!seen.empty())
        cv::resize(seen, twice_seen, twice.size(), 0., 0., cv::INTER_NEAREST);
      const CrackLines found =
        find_in_pixels(twice, n_octaves, judge, twice_seen, 2.);
      CrackLines result{filter_ridges(grey, n_octaves, narrow_filters, seen),
                        halved(found.centre_line, grey.size()),
                        found.excluded,
                        found.doubt};
      for (ExcludedLine &line : result.excluded)
        line.pixels = halved(line.pixels);
      for (double *length : {&result.doubt.missed,
                             &result.doubt.invented,
                             &result.doubt.unsettled})
        *length *= 0.5;
      return result;
    }
  } // namespace



  CrackLines
  find_cracks(const cv::Mat    &grey,
              const int         n_octaves,
              const LineJudge  &judge,
              const SeenPixels &seen)
  {
    return grey.total() > few_pixels
             ? find_in_pixels(grey, n_octaves, judge, seen)
             : find_enlarged(grey, n_octaves, judge, seen);
  }
} // namespace squeal::tribology
