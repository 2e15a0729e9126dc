// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/tribology/images/area_evidence.h>
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/line_length.h>
#include <squeal/tribology/images/mask_line.h>
#include <squeal/tribology/images/rating.h>

#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    // Where people drew it, a crack need not be found to be measured.
    constexpr double  widest_drawn = 144.; // pixels
    const char *const own_name     = "squeal";
    // Deviation of a drawn outline, pixels.
    constexpr double drawn_outline = 0.7;
    // Raters below this agree on less than they disagree.
    constexpr double least_dice = 0.5;

    /** On the pad, um. */
    double
    length_of(const cv::Mat &line, const Placement &placement)
    {
      const cv::Mat lengths = pixel_lengths(line);
      PixelPath     pixels;
      cv::findNonZero(line, pixels);
      double sum = 0.;
      for (const cv::Point &p : pixels)
        sum += lengths.at<float>(p) *
               cv::norm(PixelOnPad(placement, {p.x + 0.5, p.y + 0.5})
                          .step(direction_at(line, p, 0.)));
      return sum;
    }



    /** Fills in how far @p rating.amounts lie from @p stated. A rater who is
     * what is stated tells nothing: @p n_others do. */
    void
    compare(Rating                     &rating,
            const std::vector<cv::Mat> &masks,
            const double                stated,
            const std::size_t           n_others,
            const SeenPixels           &seen)
    {
      if (masks.size() < 2)
        return;
      double squares = 0.;
      for (const double amount : rating.amounts)
        squares += (amount - stated) * (amount - stated);
      rating.deviation = std::sqrt(squares / double(n_others));
      rating.agreement = agreement_of(masks, seen);
    }



    std::string
    short_lines(const std::string &rater, const MaskLine &drawn)
    {
      const cv::Rect &first = drawn.without_line.front();
      return std::to_string(drawn.without_line.size()) + " of the marks of '" +
             rater + "', one from column " + std::to_string(first.x) +
             " and row " + std::to_string(first.y) +
             " on, have lines of less than half their extent, which is all "
             "that counts of them: draw them as lines of one pixel";
    }
  } // namespace



  Rating
  rate_cracks(const cv::Mat            &picture,
              const std::vector<Marks> &cracks,
              const RatingSettings     &settings,
              const int                 n_octaves,
              Segmentation             &segmentation)
  {
    Rating               rating;
    std::vector<cv::Mat> lines, wide;
    double               square = 0.; // of what ends are wrong by
    for (const Marks &marks : cracks)
      {
        MaskLine drawn = line_of_mask(marks.mask);
        keep_seen(drawn.line, segmentation.seen);
        if (!drawn.without_line.empty())
          rating.warnings.push_back(short_lines(marks.rater, drawn));
        rating.raters.push_back(marks.rater);
        lines.push_back(drawn.line);
        square += drawn.end_error * drawn.end_error;
      }
    const cv::Mat stated = settings.is_beside
                             ? segmentation.cracks.centre_line
                             : consensus_line(lines, settings.tolerance);
    if (settings.is_beside)
      {
        rating.raters.push_back(own_name);
        lines.push_back(stated);
      }
    else
      // Whoever drew them misses and invents nothing but what raters differ by.
      {
        const cv::Mat grey = mirrored_beyond(picture, segmentation.seen);
        segmentation.cracks =
          measure_cracks(grey,
                         stated,
                         filter_ridges(grey, n_octaves, 1., segmentation.seen),
                         widest_drawn);
        segmentation.cracks.doubt.ends =
          std::sqrt(square / double(cracks.size()));
        keep_seen(segmentation.cracks.area, segmentation.seen);
        // What the finder left out is part of its judgement, not of theirs.
        segmentation.excluded.clear();
      }
    for (const cv::Mat &line : lines)
      {
        rating.amounts.push_back(length_of(line, settings.placement));
        wide.push_back(widened(line, settings.tolerance));
      }
    compare(rating,
            wide,
            length_of(stated, settings.placement),
            cracks.size(),
            segmentation.seen);
    return rating;
  }



  Rating
  rate_areas(const std::vector<Marks> &areas,
             const RatingSettings     &settings,
             Segmentation             &segmentation)
  {
    Rating               rating;
    std::vector<cv::Mat> masks;
    for (const Marks &marks : areas)
      {
        rating.raters.push_back(marks.rater);
        masks.push_back(marks.mask.clone());
        keep_seen(masks.back(), segmentation.seen);
      }
    if (settings.is_beside)
      {
        rating.raters.push_back(own_name);
        masks.push_back(segmentation.areas.exfoliation);
      }
    else
      {
        // Whoever drew them knows what the dark places are.
        AreaMap &drawn       = segmentation.areas;
        drawn.exfoliation    = consensus_of(masks);
        drawn.unsettled      = cv::Mat();
        drawn.darker_share   = 0.;
        drawn.bulk_is_darker = false;
        // Who marks none has not excluded what is too small to be an area.
        const bool has_any = cv::countNonZero(drawn.exfoliation) > 0;
        drawn.exfoliation_error =
          has_any ? drawn_outline *
                      outline_length(drawn.exfoliation, segmentation.seen)
                  : settings.smallest_area;
      }
    const PixelAreas pixels(segmentation, settings.placement);
    for (const cv::Mat &mask : masks)
      rating.amounts.push_back(pixels.of(mask));
    compare(rating,
            masks,
            pixels.of(segmentation.areas.exfoliation),
            areas.size(),
            segmentation.seen);
    return rating;
  }



  std::vector<std::string>
  disagreements(const Rating &rating)
  {
    std::vector<std::string> lines;
    if (rating.agreement)
      for (const PairAgreement &pair : rating.agreement->pairs)
        if (pair.dice < least_dice)
          lines.push_back("the raters '" + rating.raters[pair.first] +
                          "' and '" + rating.raters[pair.second] +
                          "' agree on " + rounded_text(100. * pair.dice, 2) +
                          " % of what they marked: what counts is what at "
                          "least half of the raters marked, of two raters "
                          "the marks of both together");
    return lines;
  }



  void
  add_deviations(const std::optional<Rating> &cracks,
                 const std::optional<Rating> &areas,
                 ImageStatistics             &statistics)
  {
    if (cracks && cracks->deviation)
      {
        const double length = 1e-3 * *cracks->deviation; // mm
        statistics.crack_length_error =
          std::hypot(statistics.crack_length_error, length);
        statistics.crack_area_error = std::hypot(
          statistics.crack_area_error, 1e-3 * statistics.crack_width * length);
      }
    if (areas && areas->deviation)
      statistics.exfoliation_fraction_error =
        std::hypot(statistics.exfoliation_fraction_error,
                   1e-6 * *areas->deviation / statistics.observed_area);
  }
} // namespace squeal::tribology
