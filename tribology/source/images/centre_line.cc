// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <deque>

namespace squeal::tribology
{
  const cv::Point neighbour_steps[8] =
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};

  namespace
  {
    // Rough outlines give branches that reach from the middle to the outline.
    constexpr double spur_over_half_width = 1.5;

    bool
    is_set(const cv::Mat &mask, const cv::Point &p)
    {
      return p.x >= 0 && p.y >= 0 && p.x < mask.cols && p.y < mask.rows &&
             mask.at<uchar>(p) != 0;
    }



    /** Zhang and Suen's conditions for the sub-iteration @p second, with
     * @p least neighbours. */
    bool
    is_removable(const cv::Mat   &m,
                 const cv::Point &p,
                 const int        least,
                 const bool       second)
    {
      bool n[8]; // clockwise from north
      for (int k = 0; k < 8; ++k)
        n[k] = is_set(m, p + neighbour_steps[(k + 6) % 8]);
      int count = 0, turns = 0;
      for (int k = 0; k < 8; ++k)
        {
          count += n[k];
          turns += !n[k] && n[(k + 1) % 8];
        }
      if (count < least || count > 6 || turns != 1)
        return false;
      return second ? !(n[0] && n[2] && n[6]) && !(n[0] && n[4] && n[6])
                    : !(n[0] && n[2] && n[4]) && !(n[2] && n[4] && n[6]);
    }



    /** The corner of a staircase, without which the line stays connected. */
    bool
    is_corner(const cv::Mat &m, const cv::Point &p)
    {
      bool n[8]; // from east, clockwise on the screen
      for (int k = 0; k < 8; ++k)
        n[k] = is_set(m, p + neighbour_steps[k]);
      bool has_corner = false;
      int  parts      = 0;
      for (int k = 0; k < 8; k += 2)
        {
          const int diagonal = k + 1, next = (k + 2) % 8;
          has_corner = has_corner || (n[k] && n[next]);
          // Yokoi's number of 8-connected parts around the pixel.
          parts += !n[k] && (n[diagonal] || n[next]);
        }
      return has_corner && parts == 1;
    }



    /** What the neighbours of a pixel tell of it. */
    struct Surroundings
    {
      Surroundings(const cv::Mat &m, const cv::Point &p)
      {
        bool n[8]; // from east, clockwise on the screen
        for (int k = 0; k < 8; ++k)
          {
            n[k] = is_set(m, p + neighbour_steps[k]);
            count += n[k];
          }
        for (int k = 0; k < 8; k += 2)
          {
            const int diagonal = k + 1, next = (k + 2) % 8;
            has_corner = has_corner || (n[k] && n[next]);
            parts += !n[k] && (n[diagonal] || n[next]);
          }
      }

      /** Whether the line stays connected without the pixel and loses no
       * end. */
      bool
      is_spare() const
      {
        return count > 1 && parts == 1;
      }

      int  count      = 0;
      int  parts      = 0; /**< Yokoi's number of 8-connected parts around it */
      bool has_corner = false; /**< of a staircase */
    };



    /** Removes what makes a line thicker than a pixel, one pixel after the
     * other. Corners of staircases go first: they are one side of a diagonal
     * line of two pixels, of whose end the other side begins. */
    void
    remove_spare_pixels(cv::Mat &line, const PixelPath &pixels)
    {
      for (const cv::Point &p : pixels)
        {
          const Surroundings s(line, p);
          if (s.has_corner && s.is_spare())
            line.at<uchar>(p) = 0;
        }
      // Against the line as it was as well: no end is followed inwards.
      const cv::Mat before = line.clone();
      for (const cv::Point &p : pixels)
        if (is_set(line, p) && Surroundings(before, p).is_spare() &&
            Surroundings(line, p).is_spare())
          line.at<uchar>(p) = 0;
    }



    /** Takes pixels with @p least neighbours away from all sides of @p result;
     * returns those that are left. */
    PixelPath
    shrink(cv::Mat &result, const int least)
    {
      PixelPath active;
      cv::findNonZero(result, active);
      for (bool changed = true; changed;)
        {
          changed = false;
          for (const bool second : {false, true})
            {
              PixelPath removed;
              for (const cv::Point &p : active)
                if (is_removable(result, p, least, second))
                  removed.push_back(p);
              for (const cv::Point &p : removed)
                result.at<uchar>(p) = 0;
              if (removed.empty())
                continue;
              changed = true;
              active.erase(std::remove_if(active.begin(),
                                          active.end(),
                                          [&](const cv::Point &p) {
                                            return result.at<uchar>(p) == 0;
                                          }),
                           active.end());
            }
        }
      return active;
    }



    /** The pixels of a branch from a line end, without its junction; empty
     * when it is longer than @p n or has no junction. */
    PixelPath
    short_branch(const cv::Mat &skeleton, const cv::Point &tip, const int n)
    {
      PixelPath path = {tip};
      while (int(path.size()) <= n)
        {
          cv::Point next;
          int       n_ways = 0;
          for (const cv::Point &step : neighbour_steps)
            {
              const cv::Point q = path.back() + step;
              if (is_set(skeleton, q) &&
                  std::find(path.begin(), path.end(), q) == path.end())
                {
                  next = q;
                  ++n_ways;
                }
            }
          if (n_ways == 0)
            return {};
          if (n_ways > 1 || n_neighbours(skeleton, next) > 2)
            return path;
          path.push_back(next);
        }
      return {};
    }



    /** Way from @p start to the farthest pixel of the same label. */
    PixelPath
    farthest_way(const cv::Mat1i &labels,
                 const cv::Point &start,
                 cv::Mat1b       &from)
    {
      const int             label = labels(start);
      std::deque<cv::Point> queue = {start};
      PixelPath             seen  = {start};
      from(start)                 = 9;
      cv::Point      last         = start;
      const cv::Rect inside({0, 0}, labels.size());
      while (!queue.empty())
        {
          last = queue.front();
          queue.pop_front();
          for (int k = 0; k < 8; ++k)
            {
              const cv::Point q = last + neighbour_steps[k];
              if (!inside.contains(q) || labels(q) != label || from(q) != 0)
                continue;
              from(q) = uchar(k + 1);
              seen.push_back(q);
              queue.push_back(q);
            }
        }
      PixelPath way = {last};
      while (from(way.back()) != 9)
        way.push_back(way.back() - neighbour_steps[from(way.back()) - 1]);
      for (const cv::Point &p : seen)
        from(p) = 0;
      return way;
    }
  } // namespace



  cv::Mat
  thin(const cv::Mat &mask)
  {
    cv::Mat         result = mask.clone();
    const PixelPath active = shrink(result, 2);
    // Corners would look like junctions.
    for (const cv::Point &p : active)
      if (is_corner(result, p))
        result.at<uchar>(p) = 0;
    return result;
  }



  cv::Mat
  thin_marks(const cv::Mat &mask)
  {
    cv::Mat         result = mask.clone();
    const PixelPath active = shrink(result, 3);
    // They would look like junctions.
    remove_spare_pixels(result, active);
    return result;
  }



  int
  n_neighbours(const cv::Mat &skeleton, const cv::Point &p)
  {
    int n = 0;
    for (const cv::Point &step : neighbour_steps)
      n += is_set(skeleton, p + step);
    return n;
  }



  void
  remove_spurs(cv::Mat &skeleton, const int n)
  {
    remove_spurs(skeleton, n, {});
  }



  void
  remove_spurs(cv::Mat &skeleton, const int n, const cv::Mat1f &half_widths)
  {
    const auto most = [&](const double half) {
      return std::max(n, int(spur_over_half_width * half));
    };
    double widest = 0.;
    if (!half_widths.empty())
      cv::minMaxLoc(half_widths, nullptr, &widest);
    for (int pass = 0; pass < 2; ++pass)
      {
        PixelPath pixels, removed;
        cv::findNonZero(skeleton, pixels);
        for (const cv::Point &p : pixels)
          if (n_neighbours(skeleton, p) == 1)
            {
              const PixelPath branch = short_branch(skeleton, p, most(widest));
              if (!half_widths.empty() && !branch.empty() &&
                  int(branch.size()) > most(half_widths(branch.back())))
                continue;
              removed.insert(removed.end(), branch.begin(), branch.end());
            }
        if (removed.empty())
          return;
        for (const cv::Point &p : removed)
          skeleton.at<uchar>(p) = 0;
        skeleton = thin(skeleton);
      }
  }



  std::vector<LineEnd>
  line_ends(const cv::Mat &skeleton)
  {
    std::vector<LineEnd> ends;
    PixelPath            pixels;
    cv::findNonZero(skeleton, pixels);
    for (const cv::Point &tip : pixels)
      {
        if (n_neighbours(skeleton, tip) != 1)
          continue;
        PixelPath path = {tip};
        for (int i = 0; i < 12; ++i)
          {
            const auto step = std::find_if(
              std::begin(neighbour_steps),
              std::end(neighbour_steps),
              [&](const cv::Point &s) {
                const cv::Point q = path.back() + s;
                return is_set(skeleton, q) &&
                       std::find(path.begin(), path.end(), q) == path.end();
              });
            if (step == std::end(neighbour_steps))
              break;
            path.push_back(path.back() + *step);
          }
        const cv::Point2d d      = tip - path.back();
        const double      length = cv::norm(d);
        // A shorter piece says nothing about its direction.
        if (length >= 5.)
          ends.push_back({tip, d * (1. / length), path});
      }
    return ends;
  }



  cv::Moments
  moments_around(const cv::Mat &skeleton, const cv::Point &p, const int reach)
  {
    const int      n   = 2 * reach + 1;
    const cv::Rect box = cv::Rect(p.x - reach, p.y - reach, n, n) &
                         cv::Rect({0, 0}, skeleton.size());
    return cv::moments(skeleton(box), true);
  }



  double
  direction_at(const cv::Mat   &skeleton,
               const cv::Point &p,
               const double     fallback)
  {
    const cv::Moments m = moments_around(skeleton, p, 5);
    if (m.m00 < 4.)
      return fallback;
    const double a = 0.5 * std::atan2(2. * m.mu11, m.mu20 - m.mu02);
    return a < 0. ? a + CV_PI : a;
  }



  NearestPixels::NearestPixels(const cv::Mat &mask)
    : places(cv::countNonZero(mask) + 1)
  {
    cv::distanceTransform(
      ~mask, distances, labels, cv::DIST_L2, 5, cv::DIST_LABEL_PIXEL);
    PixelPath pixels;
    cv::findNonZero(mask, pixels);
    for (const cv::Point &p : pixels)
      places[labels(p)] = p;
  }



  double
  LinePiece::chord_ratio() const
  {
    return cv::norm(axis.front() - axis.back()) / axis.size();
  }



  double
  LinePiece::waviness() const
  {
    cv::Point2d mean(0., 0.);
    for (const cv::Point2d p : axis)
      mean += p;
    mean      = mean * (1. / axis.size());
    double xx = 0., yy = 0., xy = 0.;
    for (const cv::Point2d p : axis)
      {
        const cv::Point2d d = p - mean;
        xx += d.x * d.x;
        yy += d.y * d.y;
        xy += d.x * d.y;
      }
    const double spread = std::hypot(xx - yy, 2. * xy);
    return std::sqrt(std::max(0., 0.5 * (xx + yy - spread)) / axis.size());
  }



  std::vector<LinePiece>
  line_pieces(const cv::Mat &skeleton)
  {
    cv::Mat1i              labels;
    const int              n = cv::connectedComponents(skeleton, labels, 8);
    std::vector<LinePiece> pieces(std::max(0, n - 1));
    PixelPath              pixels;
    cv::findNonZero(skeleton, pixels);
    for (const cv::Point &p : pixels)
      pieces[labels(p) - 1].pixels.push_back(p);
    cv::Mat1b from = cv::Mat1b::zeros(skeleton.size());
    for (LinePiece &piece : pieces)
      {
        const PixelPath way = farthest_way(labels, piece.pixels[0], from);
        piece.axis          = farthest_way(labels, way[0], from);
      }
    return pieces;
  }
} // namespace squeal::tribology
