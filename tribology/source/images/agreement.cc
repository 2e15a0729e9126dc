// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/agreement.h>
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/mask_line.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace squeal::tribology
{
  namespace
  {
    constexpr int blocks  = 4; // along each edge of the image
    constexpr int n_parts = blocks * blocks;

    /** Pixels of one block by how many raters marked them, and marks of each
     * rater. */
    struct Counts
    {
      explicit Counts(const std::size_t n_raters)
        : by_marks(n_raters + 1, 0.)
        , marks(n_raters, 0.)
      {
      }

      void
      add(const Counts &other, const double sign)
      {
        for (std::size_t k = 0; k < by_marks.size(); ++k)
          by_marks[k] += sign * other.by_marks[k];
        for (std::size_t k = 0; k < marks.size(); ++k)
          marks[k] += sign * other.marks[k];
      }

      std::vector<double> by_marks, marks;
    };



    /** Of what is @p seen, in blocks of the rectangle around it; those in which
     * nothing is seen are left out. */
    std::vector<Counts>
    count(const std::vector<const cv::Mat *> &masks, const SeenPixels &seen)
    {
      const cv::Rect view = seen.empty() ? cv::Rect({0, 0}, masks[0]->size())
                                         : cv::boundingRect(seen);
      std::vector<Counts> parts(n_parts, Counts(masks.size()));
      for (int y = view.y; y < view.br().y; ++y)
        for (int x = view.x; x < view.br().x; ++x)
          {
            if (!seen.empty() && seen.at<uchar>(y, x) == 0)
              continue;
            Counts &part =
              parts[std::size_t((y - view.y) * blocks / view.height) * blocks +
                    std::size_t((x - view.x) * blocks / view.width)];
            std::size_t n = 0;
            for (std::size_t k = 0; k < masks.size(); ++k)
              if (masks[k]->at<uchar>(y, x) != 0)
                {
                  part.marks[k] += 1.;
                  ++n;
                }
            part.by_marks[n] += 1.;
          }
      parts.erase(std::remove_if(parts.begin(),
                                 parts.end(),
                                 [](const Counts &part) {
                                   return cv::sum(part.by_marks)[0] == 0.;
                                 }),
                  parts.end());
      return parts;
    }



    /** (observed - expected) / (1 - expected); nothing where chance alone makes
     * raters agree. */
    std::optional<double>
    beyond_chance(const double observed, const double expected)
    {
      if (!(expected < 1. - 1e-12))
        return std::nullopt;
      return (observed - expected) / (1. - expected);
    }



    /** Cohen's kappa: each rater has a share of marks of his own. */
    std::optional<double>
    cohen(const Counts &c)
    {
      const double n = c.by_marks[0] + c.by_marks[1] + c.by_marks[2];
      const double a = c.marks[0] / n, b = c.marks[1] / n;
      return beyond_chance((c.by_marks[0] + c.by_marks[2]) / n,
                           a * b + (1. - a) * (1. - b));
    }



    /** Fleiss' kappa: the share of pairs of raters that agree on a pixel, and
     * one share of marks for all. */
    std::optional<double>
    fleiss(const Counts &c)
    {
      const double m = double(c.marks.size());
      double       n = 0., marked = 0., agreeing = 0.;
      for (std::size_t k = 0; k < c.by_marks.size(); ++k)
        {
          const double yes = double(k), no = m - yes;
          n += c.by_marks[k];
          marked += c.by_marks[k] * yes;
          agreeing += c.by_marks[k] * (yes * (yes - 1.) + no * (no - 1.));
        }
      const double p = marked / (n * m);
      return beyond_chance(agreeing / (n * m * (m - 1.)),
                           p * p + (1. - p) * (1. - p));
    }



    /** The value of all blocks, its deviation by the jackknife. */
    template <typename Measure>
    std::optional<Kappa>
    jackknife(const std::vector<Counts> &parts, const Measure &measure)
    {
      Counts all(parts[0].marks.size());
      for (const Counts &part : parts)
        all.add(part, 1.);
      const std::optional<double> value = measure(all);
      if (!value)
        return std::nullopt;
      double sum = 0., squares = 0.;
      for (const Counts &part : parts)
        {
          Counts rest = all;
          rest.add(part, -1.);
          // Marks in one block alone: without it there is nothing to judge.
          const double left_out = measure(rest).value_or(0.);
          sum += left_out;
          squares += left_out * left_out;
        }
      const double n        = double(parts.size());
      const double variance = std::max(0., squares / n - sum * sum / (n * n));
      return Kappa{*value, std::sqrt((n - 1.) * variance)};
    }



    /** What one rater drew, some of it at least. */
    struct RaterLine
    {
      explicit RaterLine(const cv::Mat &line)
        : nearest(line)
        , counted(cv::Mat1b::zeros(line.size()))
      {
        cv::findNonZero(line, pixels);
        for (const LineEnd &end : line_ends(line))
          ends.emplace(std::pair(end.tip.x, end.tip.y), end.ahead);
      }

      /** Whether a pixel of the line lies within @p tolerance of @p p. What
       * lies ahead of an end is not beside the line. */
      bool
      has_beside(const cv::Point &p, const double tolerance) const
      {
        const cv::Point &q = nearest.place(p);
        if (cv::norm(p - q) > tolerance)
          return false;
        const auto end = ends.find({q.x, q.y});
        return end == ends.end() || end->second.dot(cv::Point2d(p - q)) < 1.;
      }

      NearestPixels                              nearest;
      PixelPath                                  pixels;
      std::map<std::pair<int, int>, cv::Point2d> ends; /**< directions ahead */
      cv::Mat1b counted; /**< pixels that at least half of the raters have */
    };



    /** Whether @p p lies on the way from a line to another one that is no
     * farther away than @p tolerance, but for rounding. */
    bool
    is_between(const std::vector<RaterLine> &lines,
               const double                  tolerance,
               const cv::Point              &p)
    {
      constexpr double rounding = 0.8; // pixels
      for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t j = i + 1; j < lines.size(); ++j)
          {
            const cv::Point &a = lines[i].nearest.place(p),
                            &b = lines[j].nearest.place(p);
            const double apart = cv::norm(a - b);
            if (apart <= tolerance && lines[i].counted(a) != 0 &&
                lines[j].counted(b) != 0 &&
                cv::norm(p - a) + cv::norm(p - b) <= apart + rounding)
              return true;
          }
      return false;
    }



    /** Fills what is enclosed in @p mask and smaller than a square of
     * @p tolerance: no crack goes round it, only ways between two lines. */
    void
    fill_holes(cv::Mat &mask, const double tolerance)
    {
      std::vector<std::vector<cv::Point>> outlines;
      std::vector<cv::Vec4i>              places;
      cv::findContours(
        mask, outlines, places, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
      for (std::size_t i = 0; i < outlines.size(); ++i)
        if (places[i][3] >= 0 &&
            cv::contourArea(outlines[i]) < tolerance * tolerance)
          cv::drawContours(mask, outlines, int(i), 255, cv::FILLED);
    }



    /** Fills in @p mask what lies between lines of two raters that are one line
     * drawn twice: ways of at most @p tolerance from one to the other. */
    void
    join(const std::vector<RaterLine> &lines,
         const double                  tolerance,
         cv::Mat                      &mask)
    {
      for (const RaterLine &line : lines)
        for (const cv::Point &p : line.pixels)
          if (line.counted(p) != 0)
            for (const RaterLine &other : lines)
              if (const cv::Point &q = other.nearest.place(p);
                  other.counted(q) != 0 && cv::norm(p - q) <= tolerance)
                cv::line(mask, p, q, 255);
      // such ways leave holes between them
      for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
          if (mask.at<uchar>(y, x) == 0 && is_between(lines, tolerance, {x, y}))
            mask.at<uchar>(y, x) = 255;
      fill_holes(mask, tolerance);
    }
  } // namespace



  Agreement
  agreement_of(const std::vector<cv::Mat> &masks, const SeenPixels &seen)
  {
    Agreement                    result;
    std::vector<const cv::Mat *> all;
    for (const cv::Mat &mask : masks)
      all.push_back(&mask);
    result.fleiss = jackknife(count(all, seen), fleiss);
    for (std::size_t i = 0; i < masks.size(); ++i)
      for (std::size_t j = i + 1; j < masks.size(); ++j)
        {
          const std::vector<Counts> parts = count({&masks[i], &masks[j]}, seen);
          double                    both = 0., sum = 0.;
          for (const Counts &part : parts)
            {
              both += part.by_marks[2];
              sum += part.marks[0] + part.marks[1];
            }
          result.pairs.push_back(
            {i, j, jackknife(parts, cohen), sum > 0. ? 2. * both / sum : 1.});
        }
    return result;
  }



  cv::Mat
  widened(const cv::Mat &line, const double tolerance)
  {
    const int reach = cvFloor(tolerance);
    cv::Mat1b disc(2 * reach + 1, 2 * reach + 1);
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        disc(y + reach, x + reach) = x * x + y * y <= tolerance * tolerance;
    cv::Mat result;
    cv::dilate(line != 0, result, disc);
    return result;
  }



  cv::Mat
  consensus_of(const std::vector<cv::Mat> &masks)
  {
    cv::Mat votes = cv::Mat::zeros(masks[0].size(), CV_32S);
    for (const cv::Mat &mask : masks)
      {
        cv::Mat one;
        cv::Mat(mask != 0).convertTo(one, CV_32S, 1. / 255.);
        votes += one;
      }
    return 2 * votes >= int(masks.size());
  }



  cv::Mat
  consensus_line(const std::vector<cv::Mat> &lines, const double tolerance)
  {
    if (lines.size() == 1)
      return lines[0].clone();
    std::vector<RaterLine> all;
    for (const cv::Mat &line : lines)
      if (cv::countNonZero(line) > 0)
        all.emplace_back(line);
    cv::Mat mask = cv::Mat::zeros(lines[0].size(), CV_8U);
    for (RaterLine &line : all)
      {
        for (const cv::Point &p : line.pixels)
          {
            // himself among them
            const auto n = std::count_if(
              all.begin(), all.end(), [&](const RaterLine &other) {
                return other.has_beside(p, tolerance);
              });
            if (2 * std::size_t(n) >= lines.size())
              line.counted(p) = 255;
          }
        mask |= line.counted;
      }
    join(all, tolerance, mask);
    return line_of_mask(mask).line;
  }
} // namespace squeal::tribology
