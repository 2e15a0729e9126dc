// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_fatigue_rainflow_h
#define squeal_tribology_fatigue_rainflow_h

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace squeal::tribology
{
  /**
   * The turning points of a history that comes in pieces: the first value, each
   * local extremum when the next value shows that it was one, and at the end
   * the last value. Repeated values count once.
   */
  class TurningPoints
  {
  public:
    /**
     * Appends the turning points that @p n values, @p stride apart, make known
     * to @p points, which must have room for n + 1, and returns how many. The
     * loop has no branch that depends on the values: in noise two of three
     * values turn.
     */
    std::size_t
    add(const double *const values,
        const std::size_t   n,
        const std::size_t   stride,
        double *const       points)
    {
      if (n == 0)
        return 0;
      std::size_t i = 0, n_points = 0;
      if (!has_value)
        {
          last      = values[0];
          points[0] = last;
          n_points  = 1;
          has_value = true;
          i         = 1;
        }
      double before = last;
      int    slope  = direction;
      for (; i < n; ++i)
        {
          const double value = values[i * stride];
          const int    now   = int(value > before) - int(value < before);
          points[n_points]   = before;
          n_points += std::size_t(now * slope < 0);
          slope  = now != 0 ? now : slope;
          before = value;
        }
      last      = before;
      direction = slope;
      return n_points;
    }

    /** The last value, unless it is the first one too; returns how many. */
    std::size_t
    finish(double *const points) const
    {
      if (direction == 0)
        return 0;
      points[0] = last;
      return 1;
    }

  private:
    bool   has_value = false;
    double last      = 0.;
    int    direction = 0; /**< of the last change: up 1, down -1, none 0 */
  };



  /**
   * Rainflow counting of a history that comes in pieces (ASTM E1049-85, 5.4.4
   * and, for the repeating history, 5.4.5; the closed cycles are those of the
   * four-point method of ISO 12110-2).
   *
   * Every cycle is handed to a sink(range, mean, count) as soon as it closes;
   * at the end finish() counts what is left by one of two rules:
   *
   * half_cycles  each range that is left is half a cycle. Ranges that hold the
   *              start of the history are counted, and forgotten, at once.
   * repeating    the history is followed by itself for ever: the residue is
   *              passed through the counter a second time, full cycles only.
   *
   * What is kept is the residue: two points for each cycle of a swing that
   * decays (and, with `repeating`, of one that grows). It does not grow with
   * the length of a steady history; deepest() tells how much it was. The cycles
   * and their order do not depend on the pieces.
   */
  class RainflowCounter
  {
  public:
    enum class Residue
    {
      half_cycles,
      repeating
    };

    explicit RainflowCounter(const Residue residue = Residue::half_cycles)
      : residue(residue)
      , stack(64)
    {
    }

    /** Adds @p n values, @p stride apart. */
    template <typename Sink>
    void
    add(const double *values, std::size_t n, std::size_t stride, Sink &&sink)
    {
      std::array<double, block + 1> points;
      while (n > 0)
        {
          const std::size_t m = n < block ? n : block;
          const std::size_t n_points =
            turning.add(values, m, stride, points.data());
          add_points(points.data(), n_points, sink);
          values += m * stride;
          n -= m;
        }
    }

    /** Ends the history; the counter must not be used any more. */
    template <typename Sink>
    void
    finish(Sink &&sink)
    {
      double last;
      add_points(&last, turning.finish(&last), sink);
      if (residue == Residue::repeating)
        repeat(sink);
      else
        for (std::size_t i = 0; i + 1 < depth; ++i)
          hand_over(stack[i], stack[i + 1], 0.5, sink);
    }

    /** What has not been counted yet. */
    std::vector<double>
    open_points() const
    {
      return {stack.begin(), stack.begin() + depth};
    }

    /** Most points that were kept at a time. */
    std::size_t
    deepest() const
    {
      return most;
    }

  private:
    static constexpr std::size_t block = 1024;

    template <typename Sink>
    static void
    hand_over(const double a, const double b, const double count, Sink &&sink)
    {
      sink(std::abs(a - b), 0.5 * (a + b), count);
    }

    template <typename Sink>
    void
    add_points(const double *const points, const std::size_t n, Sink &&sink)
    {
      if (stack.size() < 2 * (depth + n))
        stack.resize(2 * (depth + n));
      if (residue == Residue::half_cycles)
        count_from_start(points, n, sink);
      else
        count_closed(points, n, sink);
    }

    /** ASTM E1049-85, 5.4.4. */
    template <typename Sink>
    void
    count_from_start(const double *const points,
                     const std::size_t   n,
                     Sink              &&sink)
    {
      double *const s = stack.data();
      std::size_t   d = depth;
      for (std::size_t i = 0; i < n; ++i)
        {
          const double point = points[i];
          while (d >= 2 &&
                 std::abs(point - s[d - 1]) >= std::abs(s[d - 1] - s[d - 2]))
            {
              if (d == 2)
                {
                  hand_over(s[0], s[1], 0.5, sink);
                  s[0] = s[1];
                  d    = 1;
                }
              else
                {
                  hand_over(s[d - 2], s[d - 1], 1., sink);
                  d -= 2;
                }
            }
          s[d++] = point;
          most   = d > most ? d : most;
        }
      depth = d;
    }

    /** The four-point method: the start of the history is kept. */
    template <typename Sink>
    void
    count_closed(const double *const points, const std::size_t n, Sink &&sink)
    {
      double *const s = stack.data();
      std::size_t   d = depth;
      for (std::size_t i = 0; i < n; ++i)
        {
          const double point = points[i];
          while (d >= 3)
            {
              const double inner = std::abs(s[d - 1] - s[d - 2]);
              if (std::abs(point - s[d - 1]) < inner ||
                  std::abs(s[d - 2] - s[d - 3]) < inner)
                break;
              hand_over(s[d - 2], s[d - 1], 1., sink);
              d -= 2;
            }
          s[d++] = point;
          most   = d > most ? d : most;
        }
      depth = d;
    }

    template <typename Sink>
    void
    repeat(Sink &&sink)
    {
      const std::vector<double> rest = open_points();
      // the seam may be no turning point, or the same value twice
      TurningPoints       seam;
      std::vector<double> points(2 * rest.size() + 2);
      std::size_t         n = 0;
      for (unsigned int pass = 0; pass < 2; ++pass)
        n += seam.add(rest.data(), rest.size(), 1, points.data() + n);
      n += seam.finish(points.data() + n);
      depth = 0;
      add_points(points.data(), n, sink);
    }

    Residue             residue;
    TurningPoints       turning;
    std::vector<double> stack;
    std::size_t         depth = 0;
    std::size_t         most  = 0;
  };
} // namespace squeal::tribology

#endif
