// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/label_layout.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace squeal
{
  namespace
  {
    constexpr double pi = 3.14159265358979323846;

    // weights of what makes a place bad, in units of a pixel of distance
    constexpr double cost_of_covered_label    = 40.; // per square pixel
    constexpr double cost_of_covered_obstacle = 1.2; // per square pixel
    constexpr double cost_of_crossed_label    = 300.;
    constexpr double cost_of_crossed_leader   = 100.;
    constexpr double cost_of_leader           = 15.;
    constexpr double longest_clear_distance   = 20.; // without a leader
    constexpr int    n_rounds                 = 8;

    PixelBox
    grown(const PixelBox &box, const double by)
    {
      return {box.x_min - by, box.y_min - by, box.x_max + by, box.y_max + by};
    }

    /** A straight line from (x, y) to (x, y). */
    using Leader = std::array<double, 4>;

    /** From the point of @p label to the near side of its text in @p box. */
    Leader
    leader_to(const PointLabel &label, const PixelBox &box)
    {
      return {{label.x,
               label.y,
               std::min(box.x_max, std::max(box.x_min, label.x)),
               std::min(box.y_max, std::max(box.y_min, label.y))}};
    }

    bool
    runs_through(const Leader &line, const PixelBox &box)
    {
      for (int i = 1; i < 16; ++i)
        {
          const double x = line[0] + i / 16. * (line[2] - line[0]);
          const double y = line[1] + i / 16. * (line[3] - line[1]);
          if (x > box.x_min && x < box.x_max && y > box.y_min && y < box.y_max)
            return true;
        }
      return false;
    }

    bool
    cross_each_other(const Leader &a, const Leader &b)
    {
      const auto side = [](const Leader &line, const double x, const double y) {
        return (line[2] - line[0]) * (y - line[1]) -
               (line[3] - line[1]) * (x - line[0]);
      };
      return side(a, b[0], b[1]) * side(a, b[2], b[3]) < 0. &&
             side(b, a[0], a[1]) * side(b, a[2], a[3]) < 0.;
    }

    /** Advance of a character of DejaVu Sans over the size of the font. */
    double
    advance(const char c)
    {
      const auto is_in = [c](const char *set) {
        return std::strchr(set, c) != nullptr;
      };
      // continuation bytes of UTF-8
      if ((static_cast<unsigned char>(c) & 0xC0) == 0x80)
        return 0.;
      if (is_in("ijlI,.:; '|"))
        return 0.32;
      if (is_in("()[]-/\\frt"))
        return 0.40;
      if (is_in("+=<>~"))
        return 0.84;
      if (is_in("mwMW%@"))
        return 0.97;
      return c >= 'A' && c <= 'Z' ? 0.70 : 0.63;
    }

    /** Where a text may stand from its point. */
    struct LabelPlace
    {
      double distance; /**< of its near edge, pixels */
      double angle;
    };

    /** Near places first, right of the point before left of it. */
    std::vector<LabelPlace>
    candidate_places()
    {
      std::vector<LabelPlace> places;
      for (const double distance :
           {10., 15., 25., 40., 60., 85., 115., 150., 200., 260.})
        for (const int sixteenth :
             {0, 8, 2, -2, 4, -4, 6, -6, 1, -1, 3, -3, 7, -7, 5, -5})
          places.push_back({distance, sixteenth * pi / 8.});
      return places;
    }

    class Placement
    {
    public:
      Placement(std::vector<PointLabel>     &labels,
                const std::vector<PixelBox> &obstacles,
                const PixelBox              &bounds,
                const double                 font_size)
        : labels(labels)
        , obstacles(obstacles)
        , bounds(bounds)
        , font_size(font_size)
        , is_placed(labels.size(), false)
        , places(candidate_places())
      {
      }

      /** Gives label @p i the best place beside what is placed. */
      void
      place(const std::size_t i)
      {
        double best  = std::numeric_limits<double>::infinity();
        is_placed[i] = true;
        for (std::size_t p = 0; p < places.size(); ++p)
          {
            const PixelBox free   = box_at(labels[i], places[p]);
            const PixelBox box    = pushed_into_bounds(free);
            const bool     is_far = places[p].distance > longest_clear_distance;
            const double total = cost(i, box) + places[p].distance + 0.01 * p +
                                 (is_far ? cost_of_leader : 0.) +
                                 std::abs(box.x_min - free.x_min) +
                                 std::abs(box.y_min - free.y_min);
            if (total < best)
              {
                best                   = total;
                labels[i].box          = box;
                labels[i].needs_leader = is_far;
              }
          }
      }

    private:
      PixelBox
      box_at(const PointLabel &label, const LabelPlace &place) const
      {
        const double width  = text_width(label.text, font_size);
        const double height = text_height(font_size);
        const double c = std::cos(place.angle), s = std::sin(place.angle);
        const double x = label.x + (place.distance + 0.5 * width) * c;
        const double y = label.y + (place.distance + 0.5 * height) * s;
        return {
          x - 0.5 * width, y - 0.5 * height, x + 0.5 * width, y + 0.5 * height};
      }

      PixelBox
      pushed_into_bounds(const PixelBox &box) const
      {
        const double dx = std::max(0., bounds.x_min - box.x_min) -
                          std::max(0., box.x_max - bounds.x_max);
        const double dy = std::max(0., bounds.y_min - box.y_min) -
                          std::max(0., box.y_max - bounds.y_max);
        return {box.x_min + dx, box.y_min + dy, box.x_max + dx, box.y_max + dy};
      }

      double
      cost(const std::size_t i, const PixelBox &box) const
      {
        const Leader own = leader_to(labels[i], box);
        double       sum = 0.;
        for (std::size_t j = 0; j < labels.size(); ++j)
          if (j != i && is_placed[j])
            {
              const Leader other = leader_to(labels[j], labels[j].box);
              sum +=
                cost_of_covered_label * grown(box, 2.).overlap(labels[j].box);
              if (runs_through(own, labels[j].box) || runs_through(other, box))
                sum += cost_of_crossed_label;
              if (cross_each_other(own, other))
                sum += cost_of_crossed_leader;
            }
        for (const PixelBox &obstacle : obstacles)
          sum += cost_of_covered_obstacle * box.overlap(obstacle);
        return sum;
      }

      std::vector<PointLabel>     &labels;
      const std::vector<PixelBox> &obstacles;
      const PixelBox              &bounds;
      double                       font_size;
      std::vector<bool>            is_placed;
      std::vector<LabelPlace>      places;
    };
  } // namespace



  double
  PixelBox::overlap(const PixelBox &other) const
  {
    const double w =
      std::min(x_max, other.x_max) - std::max(x_min, other.x_min);
    const double h =
      std::min(y_max, other.y_max) - std::max(y_min, other.y_min);
    return w > 0. && h > 0. ? w * h : 0.;
  }



  double
  text_width(const std::string &text, const double font_size)
  {
    // 4/3 pixels a point at 96 dots per inch, and a little reserve
    double width = 0.;
    for (const char c : text)
      width += advance(c);
    return 1.03 * width * font_size * 4. / 3.;
  }



  std::string
  shortened(const std::string &text, const double width, const double font_size)
  {
    if (text_width(text, font_size) <= width)
      return text;
    std::vector<std::string> letters;
    for (const char c : text)
      if ((c & 0xc0) == 0x80 && !letters.empty()) // goes on with a letter
        letters.back() += c;
      else
        letters.emplace_back(1, c);
    std::string       start, end;
    const std::string ellipsis = "\u2026";
    for (std::size_t i = 0, j = letters.size(); i < j;)
      {
        const bool        at_start = i + j <= letters.size();
        const std::string longer =
          at_start ? start + letters[i++] : letters[--j] + end;
        if (text_width(at_start ? longer + ellipsis + end
                                : start + ellipsis + longer,
                       font_size) > width)
          break;
        (at_start ? start : end) = longer;
      }
    return start + ellipsis + end;
  }



  double
  text_height(const double font_size)
  {
    return 1.6 * font_size;
  }



  void
  place_labels(std::vector<PointLabel>     &labels,
               const std::vector<PixelBox> &obstacles,
               const PixelBox              &bounds,
               const double                 font_size)
  {
    Placement placement(labels, obstacles, bounds, font_size);
    // the later rounds mend what the first could not foresee
    for (int round = 0; round < n_rounds; ++round)
      for (std::size_t i = 0; i < labels.size(); ++i)
        placement.place(i);
  }
} // namespace squeal
