// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/tribology/images/micrograph.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <vector>

namespace squeal::tribology
{
  namespace
  {
    /** True where most pixels at the border of a mask are set. */
    bool
    most_of_border(const cv::Mat &mask)
    {
      const int n_set = cv::countNonZero(mask.row(0)) +
                        cv::countNonZero(mask.row(mask.rows - 1)) +
                        cv::countNonZero(mask.col(0)) +
                        cv::countNonZero(mask.col(mask.cols - 1));
      return n_set > mask.rows + mask.cols;
    }

    /** What differs from the background at the border of @p part, CV_8U. */
    cv::Mat
    bar_mask(const cv::Mat &part)
    {
      double low, high;
      cv::minMaxLoc(part, &low, &high);
      const cv::Mat bright = part > 0.5 * (low + high);
      return most_of_border(bright) ? cv::Mat(~bright) : bright;
    }



    /** Pixels in a row that are set. */
    struct Run
    {
      int first = 0, length = 0;

      int
      end() const
      {
        return first + length;
      }
    };

    /** From left to right. */
    std::vector<Run>
    runs_of(const cv::Mat &mask, const int y)
    {
      std::vector<Run> runs;
      for (int x = 0; x < mask.cols; ++x)
        if (mask.at<unsigned char>(y, x) != 0)
          {
            if (runs.empty() || runs.back().end() < x)
              runs.push_back({x, 0});
            ++runs.back().length;
          }
      return runs;
    }



    Run
    longest_of(const std::vector<Run> &runs)
    {
      Run longest;
      for (const Run &run : runs)
        if (run.length > longest.length)
          longest = run;
      return longest;
    }



    int
    row_of_longest_run(const cv::Mat &mask)
    {
      int row = 0, length = 0;
      for (int y = 0; y < mask.rows; ++y)
        if (const Run run = longest_of(runs_of(mask, y)); run.length > length)
          {
            row    = y;
            length = run.length;
          }
      return row;
    }



    // Of the longest run: strokes of letters beside a bar are shorter than the
    // first, letters between its halves than the second, and the halves are
    // alike to the third.
    constexpr double least_piece = 0.25, most_letter = 0.5, like_halves = 0.8;

    /** Whether the row @p y of runs is a bar in two halves with its label
     * between them, which stands above the row and below it. */
    bool
    has_label_inside(const cv::Mat          &mask,
                     const int               y,
                     const std::vector<Run> &runs)
    {
      const Run &left = runs.front(), &right = runs.back();
      const int  longer  = std::max(left.length, right.length),
                shorter  = std::min(left.length, right.length);
      const auto is_long = [&](const Run &run) {
        return run.length > most_letter * longer;
      };
      if (shorter < like_halves * longer ||
          std::count_if(runs.begin(), runs.end(), is_long) != 2)
        return false;
      const cv::Mat between = mask.colRange(left.end(), right.first);
      return cv::countNonZero(between.rowRange(0, y)) > 0 &&
             cv::countNonZero(between.rowRange(y + 1, mask.rows)) > 0;
    }



    /** The bar in the row @p y of its box: the longest run, or from the first to the
     * last pixel of a bar whose label stands between its halves. Throws
     * InputError where several runs may be the bar or parts of it. */
    Run
    bar_in(const cv::Mat &mask, const int y, const std::string &path)
    {
      const std::vector<Run> runs    = runs_of(mask, y);
      const Run              longest = longest_of(runs);
      if (std::count_if(runs.begin(), runs.end(), [&](const Run &run) {
            return run.length >= least_piece * longest.length;
          }) < 2)
        return longest;
      if (!has_label_inside(mask, y, runs))
        throw InputError(path + ": the box of 'Scale bar' has several bars "
                                "beside one another, and nothing tells which "
                                "of them make up the length: draw the box "
                                "around one bar, or set 'Pixel size'");
      return {runs.front().first, runs.back().end() - runs.front().first};
    }
  } // namespace



  double
  scale_bar_pixels(const cv::Mat     &grey,
                   const cv::Rect    &box,
                   const std::string &path)
  {
    if ((box & cv::Rect({0, 0}, grey.size())) != box || box.area() == 0)
      throw InputError(path + ": the box of 'Scale bar' is not in the image");
    double        low, high;
    const cv::Mat part = grey(box);
    cv::minMaxLoc(part, &low, &high);
    const cv::Mat bar = bar_mask(part);
    const int     y   = row_of_longest_run(bar);
    if (longest_of(runs_of(bar, y)).length < 10 || high - low < 30.)
      throw InputError(path + ": there is no bar in the box of 'Scale bar'");
    const Run run = bar_in(bar, y, path);
    if (run.first == 0 || run.end() == part.cols)
      throw InputError(path + ": the bar reaches the left or the right border "
                              "of the box of 'Scale bar': draw the box wider "
                              "than the bar, with its background around it");
    return run.length;
  }



  namespace
  {
    // Grey levels within which a label has one value, and the share of the
    // background of a bar that has to have it.
    constexpr double one_value = 6., flat_share = 0.8;
    // Shares: of a picture that a label may take, of a label that is none of
    // its text, and of a picture that has the value of a bar by chance.
    constexpr double largest_label = 0.2, least_filled = 0.5,
                     usual_value = 0.01;
    constexpr int label_margin   = 3;  // pixels, by optics or compression
    constexpr int text_beside    = 40; // pixels between a bar and its text

    /** The middle one of those of @p values for which @p mask is set. */
    float
    middle_within(const cv::Mat &values, const cv::Mat &mask)
    {
      std::vector<float> sample;
      for (int y = 0; y < values.rows; ++y)
        for (int x = 0; x < values.cols; ++x)
          if (mask.at<uchar>(y, x) != 0)
            sample.push_back(values.at<float>(y, x));
      const auto middle = sample.begin() + std::ptrdiff_t(sample.size() / 2);
      std::nth_element(sample.begin(), middle, sample.end());
      return *middle;
    }



    cv::Mat
    like_value(const cv::Mat &grey, const float value)
    {
      cv::Mat mask;
      cv::inRange(grey,
                  cv::Scalar(value - one_value),
                  cv::Scalar(value + one_value),
                  mask);
      return mask;
    }



    /** The rectangle of the label in which the bar of @p box lies: what has the
     * one value of the background there and is connected to it. The box where
     * the background is the surface itself. */
    cv::Rect
    label_about(const cv::Mat &grey, const cv::Rect &box, const cv::Mat &bar)
    {
      const cv::Mat beside = ~bar;
      cv::Mat       flat   = like_value(grey, middle_within(grey(box), beside));
      if (cv::countNonZero(flat(box) & beside) <
          flat_share * cv::countNonZero(beside))
        return box;
      flat(box).setTo(255);
      cv::Mat1i labels, stats;
      cv::Mat   centroids;
      cv::connectedComponentsWithStats(flat, labels, stats, centroids, 4);
      const int      own = labels(box.y, box.x);
      const cv::Rect label(stats(own, cv::CC_STAT_LEFT),
                           stats(own, cv::CC_STAT_TOP),
                           stats(own, cv::CC_STAT_WIDTH),
                           stats(own, cv::CC_STAT_HEIGHT));
      const bool     is_label =
        label.area() <= largest_label * double(grey.total()) &&
        stats(own, cv::CC_STAT_AREA) >= least_filled * label.area();
      return is_label ? label : box;
    }



    /** @p box and the text above or below it that has the value of the bar,
     * where nearly nothing else in the picture has. */
    cv::Rect
    with_text(const cv::Mat &grey, const cv::Rect &box, const cv::Mat &bar)
    {
      const cv::Mat  ink = like_value(grey, middle_within(grey(box), bar));
      const cv::Rect near =
        cv::Rect(
          box.x, box.y - text_beside, box.width, box.height + 2 * text_beside) &
        cv::Rect({0, 0}, grey.size());
      const int beyond = cv::countNonZero(ink) - cv::countNonZero(ink(near));
      if (beyond > usual_value * double(grey.total()))
        return box;
      const cv::Rect text = cv::boundingRect(ink(near)) + near.tl();
      return text.area() > 0 ? box | text : box;
    }
  } // namespace



  cv::Rect
  scale_bar_place(const cv::Mat &grey, const cv::Rect &box)
  {
    const cv::Mat  bar = bar_mask(grey(box));
    const cv::Rect all =
      label_about(grey, box, bar) | with_text(grey, box, bar);
    return cv::Rect(all.x - label_margin,
                    all.y - label_margin,
                    all.width + 2 * label_margin,
                    all.height + 2 * label_margin) &
           cv::Rect({0, 0}, grey.size());
  }
} // namespace squeal::tribology
