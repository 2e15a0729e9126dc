// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/specimen_shapes.h>

#include <algorithm>

namespace squeal::tribology
{
  namespace
  {
    constexpr int samples_a_step = 12; // per step of a centre line

    /** A crack with a box around it, for a quick no. */
    class Cover
    {
    public:
      explicit Cover(const CrackShape &crack)
        : crack(crack)
        , least(crack.line[0])
        , most(crack.line[0])
      {
        const double half =
          0.5 * *std::max_element(crack.width.begin(), crack.width.end());
        for (const cv::Point2d &p : crack.line)
          {
            least.x = std::min(least.x, p.x - half);
            least.y = std::min(least.y, p.y - half);
            most.x  = std::max(most.x, p.x + half);
            most.y  = std::max(most.y, p.y + half);
          }
      }

      bool
      contains(const cv::Point2d &p) const
      {
        if (p.x < least.x || p.y < least.y || p.x > most.x || p.y > most.y)
          return false;
        for (std::size_t i = 0; i + 1 < crack.line.size(); ++i)
          {
            const cv::Point2d a = crack.line[i], d = crack.line[i + 1] - a;
            const double      t = std::clamp((p - a).dot(d) / d.dot(d), 0., 1.);
            const double      width =
              crack.width[i] + t * (crack.width[i + 1] - crack.width[i]);
            if (cv::norm(p - a - t * d) < 0.5 * width)
              return true;
          }
        return false;
      }

    private:
      const CrackShape &crack;
      cv::Point2d       least, most;
    };
  } // namespace



  double
  seen_crack_length(const std::vector<CrackShape> &cracks,
                    const cv::Size2d              &view)
  {
    double             length = 0.;
    std::vector<Cover> before;
    for (const CrackShape &crack : cracks)
      {
        for (std::size_t i = 0; i + 1 < crack.line.size(); ++i)
          {
            const cv::Point2d a = crack.line[i], d = crack.line[i + 1] - a;
            for (int k = 0; k < samples_a_step; ++k)
              {
                const cv::Point2d p = a + (k + 0.5) / samples_a_step * d;
                const bool        is_hidden =
                  std::any_of(before.begin(),
                              before.end(),
                              [&](const Cover &c) { return c.contains(p); });
                if (p.x >= 0. && p.y >= 0. && p.x <= view.width &&
                    p.y <= view.height && !is_hidden)
                  length += cv::norm(d) / samples_a_step;
              }
          }
        before.emplace_back(crack);
      }
    return length;
  }
} // namespace squeal::tribology
