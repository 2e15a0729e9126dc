// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/crack_finder.h>
#include <squeal/tribology/images/crack_growth.h>
#include <squeal/tribology/images/line_graph.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** What an edge has to show; contrasts in units of noise. */
    struct Need
    {
      double local, path;
      double darkness; /**< of the darker flank's brightness */
      int    length;   /**< pixels */
    };
    constexpr Need   to_start   = {3.2, 2.7, 0.045, 0};
    constexpr Need   to_belong  = {2.9, 2.4, 0.02, 0};
    constexpr Need   to_hang_on = {3.7, 2., 0.07, 8};
    constexpr double crest      = 2.;
    constexpr double counts     = 2.;  // contrast above this adds up
    constexpr double needed_sum = 80.; // over the pixels of a crack
    // A contrast far above the limit makes up for a short path.
    constexpr Need   clear          = {0., 2.4, 0.08, 12};
    constexpr double clear_contrast = 5.;
    // A long wavy line is a crack although each piece of it is faint.
    constexpr Need   faint          = {2.7, 2.2, 0.07, 60};
    constexpr double faint_coarse   = 1.95;
    constexpr double faint_waviness = 0.011; // of its length
    // In pixels.
    constexpr int    crest_spur      = 4;
    constexpr int    longest_spur    = 6;
    constexpr int    shortest_crack  = 20;
    constexpr int    shortest_end    = 4;
    constexpr int    shortest_bridge = 5;
    constexpr int    shortest_branch = 12;
    constexpr double longest_join    = 6.; // of a branch to its crack
    constexpr double flank           = 4.;
    constexpr double far_ahead = 70., ahead = 35.;
    // Straight lines of this length are scratches, grooves or edges.
    constexpr double strong_contrast = 3.25;
    constexpr double strong_scratch = 110., weak_scratch = 80.;
    constexpr double led_on_scratch = 140.;
    constexpr int    scratch_width  = 3;
    constexpr int    scratch_part   = 40;
    // Filters of half an octave less, and the share of the strength of cracks
    // that they have to keep.
    constexpr double narrow_filters = 0.7; // pixels, deviation
    constexpr double least_kept     = 0.95;

    cv::Mat
    find_crests(const RidgeField &ridges)
    {
      cv::Mat crests = cv::Mat::zeros(ridges.sharp.size(), CV_8U);
      for (int y = 0; y < crests.rows; ++y)
        {
          const float *z = ridges.sharp.ptr<float>(y);
          for (int x = 0; x < crests.cols; ++x)
            if (z[x] >= crest && ridges.is_crest({x, y}))
              crests.at<uchar>(y, x) = 255;
        }
      cv::dilate(crests, crests, cv::Mat());
      cv::Mat skeleton = thin(crests);
      remove_spurs(skeleton, crest_spur);
      return skeleton;
    }



    /** Means along an edge, but the median of the unlimited contrast. */
    struct Weight
    {
      double local = 0., path = 0., coarse = 0., darkness = 0.;
      double unlimited = 0., waviness = 0.;
      int    length      = 0;
      bool   is_straight = false;

      bool
      has(const Need &need) const
      {
        return local >= need.local && path >= need.path &&
               darkness >= need.darkness && length >= need.length;
      }

      bool
      is_clear() const
      {
        return has(clear) && unlimited >= clear_contrast;
      }

      bool
      is_faint_crack() const
      {
        return has(faint) && coarse >= faint_coarse &&
               waviness >= faint_waviness * length;
      }

      /** What the edge adds to the evidence of its crack. */
      double
      evidence() const
      {
        if (is_clear())
          return length * (unlimited - counts);
        if (has(to_start))
          return length * (local - counts);
        return is_faint_crack() ? needed_sum : 0.;
      }
    };

    /** How much darker each pixel is than the darker flank, relative to it. */
    cv::Mat1f
    relative_darkness(const cv::Mat &grey, const RidgeField &ridges)
    {
      cv::Mat1f smooth;
      cv::GaussianBlur(grey, smooth, cv::Size(), 1.);
      const auto at = [&](const cv::Point &q) {
        return std::max(1.F,
                        smooth(std::clamp(q.y, 0, smooth.rows - 1),
                               std::clamp(q.x, 0, smooth.cols - 1)));
      };
      cv::Mat1f darkness(grey.size());
      for (int y = 0; y < grey.rows; ++y)
        for (int x = 0; x < grey.cols; ++x)
          {
            const cv::Point p(x, y), across = ridges.across(p, flank);
            const float     beside = std::min(at(p + across), at(p - across));
            darkness(p)            = (beside - at(p)) / beside;
          }
      return darkness;
    }



    /** Whether both flanks of the narrowest filter lie inside of the image: the
     * contrast is known. */
    bool
    is_known(const RidgeField &ridges, const cv::Point &p)
    {
      const cv::Point across = ridges.across(p, ridges.flank);
      const int       x = std::abs(across.x), y = std::abs(across.y);
      const cv::Size  size = ridges.local.size();
      return p.x >= x && p.x < size.width - x && p.y >= y &&
             p.y < size.height - y;
    }



    /** The pixels of an edge between the first and the last of contrast: crests
     * go on beyond a crack by a hook. An edge that is hooks for the most part
     * stays as it is. */
    PixelPath
    core_of(const RidgeField &ridges, const PixelPath &axis)
    {
      const auto has_contrast = [&](const cv::Point &p) {
        return ridges.local.at<float>(p) >= counts;
      };
      const auto first = std::find_if(axis.begin(), axis.end(), has_contrast);
      const auto last =
        std::find_if(axis.rbegin(), axis.rend(), has_contrast).base();
      return last - first >= 0.5 * axis.size() ? PixelPath(first, last) : axis;
    }



    /** Those pixels whose contrast is known; all of them if that is less than
     * half: an edge is not judged by a few pixels. */
    PixelPath
    known_pixels(const RidgeField &ridges, const PixelPath &axis)
    {
      PixelPath known;
      for (const cv::Point &p : axis)
        if (is_known(ridges, p))
          known.push_back(p);
      return 2 * known.size() < axis.size() ? axis : known;
    }



    /** Whether an edge, or half of its parts, lie on a straight line that is
     * longer than @p longest. A scratch that leads into something else is bent
     * as a whole. */
    bool
    lies_on_scratch(const cv::Mat   &crests,
                    const LinePiece &piece,
                    const double     longest)
    {
      if (straight_run(crests, piece) > longest)
        return true;
      const std::size_t n       = piece.axis.size();
      const std::size_t n_parts = std::max<std::size_t>(1, n / scratch_part);
      std::size_t       on      = 0;
      for (std::size_t k = 0; k < n_parts; ++k)
        {
          LinePiece part;
          part.axis.assign(piece.axis.begin() + k * n / n_parts,
                           piece.axis.begin() + (k + 1) * n / n_parts);
          if (straight_run(crests, part) > longest)
            on += part.axis.size();
        }
      return 2 * on >= n;
    }



    /** The crests of an image as edges with their weights. */
    class CrestGraph
    {
    public:
      CrestGraph(const RidgeField &ridges, const cv::Mat1f &darkness)
        : crests(find_crests(ridges))
        , graph(crests)
      {
        for (const LineGraph::Edge &edge : graph.edges)
          {
            const PixelPath core  = core_of(ridges, edge.piece.axis);
            const PixelPath known = known_pixels(ridges, core);
            Weight          w;
            w.length   = int(core.size());
            w.waviness = edge.piece.waviness();
            std::vector<float> unlimited;
            for (const cv::Point &p : known)
              {
                unlimited.push_back(ridges.unlimited.at<float>(p));
                w.local += ridges.local.at<float>(p) / known.size();
              }
            for (const cv::Point &p : core)
              {
                w.path += ridges.strength.at<float>(p) / w.length;
                w.coarse += ridges.coarse.at<float>(p) / w.length;
                w.darkness += darkness(p) / w.length;
              }
            const auto middle = unlimited.begin() + unlimited.size() / 2;
            std::nth_element(unlimited.begin(), middle, unlimited.end());
            w.unlimited   = *middle;
            w.is_straight = lies_on_scratch(
              crests,
              edge.piece,
              w.local > strong_contrast ? strong_scratch : weak_scratch);
            weights.push_back(w);
            cores.push_back(core);
          }
      }

      /** Edges that belong to connected parts with enough evidence, and strong
       * ones that end beside these. */
      cv::Mat
      cracks() const
      {
        std::vector<char> kept;
        for (std::size_t i = 0; i < weights.size(); ++i)
          kept.push_back(may_belong(i));
        const std::vector<int> part = graph.parts(kept);
        std::vector<double>    sum(kept.size(), 0.), length(kept.size(), 0.);
        for (std::size_t i = 0; i < kept.size(); ++i)
          if (kept[i])
            {
              const Weight &w = weights[i];
              length[part[i]] += w.length;
              sum[part[i]] += w.evidence();
            }
        for (std::size_t i = 0; i < kept.size(); ++i)
          if (kept[i])
            kept[i] =
              sum[part[i]] >= needed_sum && length[part[i]] >= shortest_crack;
        cv::Mat result = graph.draw(kept);
        remove_hooks(kept, result);
        return joined(kept, result);
      }

      /** Where scratches run. */
      cv::Mat
      scratches() const
      {
        cv::Mat result = cv::Mat::zeros(crests.size(), CV_8U);
        for (std::size_t i = 0; i < weights.size(); ++i)
          if (weights[i].is_straight)
            for (const cv::Point &p : graph.edges[i].piece.pixels)
              result.at<uchar>(p) = 255;
        cv::dilate(result, result, cv::Mat(), {-1, -1}, scratch_width);
        return result;
      }

      const cv::Mat crests;

    private:
      bool
      may_belong(const std::size_t i) const
      {
        const Weight &w          = weights[i];
        const bool    has_an_end = graph.edges[i].nodes.size() < 2;
        if (!has_an_end && w.length <= shortest_bridge)
          return true;
        return (w.has(to_belong) || w.has(to_hang_on) || w.is_clear() ||
                w.is_faint_crack()) &&
               !w.is_straight && (!has_an_end || w.length >= shortest_end);
      }

      /** Takes what lies beyond the cores off the free ends of edges. */
      void
      remove_hooks(const std::vector<char> &kept, cv::Mat &skeleton) const
      {
        for (std::size_t i = 0; i < kept.size(); ++i)
          {
            PixelPath        axis = graph.edges[i].piece.axis;
            const PixelPath &core = cores[i];
            for (const cv::Point &inner : {core.front(), core.back()})
              {
                if (kept[i] && n_neighbours(skeleton, axis.front()) == 1)
                  for (const cv::Point &p : axis)
                    {
                      if (p == inner)
                        break;
                      skeleton.at<uchar>(p) = 0;
                    }
                std::reverse(axis.begin(), axis.end());
              }
          }
      }

      /** Adds edges that would start a crack and end beside one, which hides
       * where they branch off. */
      cv::Mat
      joined(const std::vector<char> &kept, const cv::Mat &skeleton) const
      {
        if (cv::countNonZero(skeleton) == 0)
          return skeleton;
        const NearestPixels nearest(skeleton);
        cv::Mat             result = skeleton.clone();
        for (std::size_t i = 0; i < kept.size(); ++i)
          {
            const Weight    &w    = weights[i];
            const PixelPath &axis = graph.edges[i].piece.axis;
            cv::Point        end = axis.front(), other = axis.back();
            if (nearest.distance(other) < nearest.distance(end))
              std::swap(end, other);
            if (kept[i] || w.is_straight || !w.has(to_start) ||
                w.length < shortest_branch ||
                nearest.distance(end) > longest_join ||
                nearest.distance(other) <
                  nearest.distance(end) + 0.5 * w.length)
              continue;
            for (const cv::Point &p : graph.edges[i].piece.pixels)
              result.at<uchar>(p) = 255;
            cv::line(result, end, nearest.place(end), 255);
          }
        return thin(result);
      }

      LineGraph              graph;
      std::vector<Weight>    weights;
      std::vector<PixelPath> cores;
    };



    /** Removes the edges that lie on long straight lines, which a crack was
     * led on to, and what is short then. */
    void
    remove_straight_edges(cv::Mat &skeleton, const cv::Mat &crests)
    {
      const LineGraph   graph(skeleton);
      const cv::Mat     all = crests | skeleton;
      std::vector<char> kept;
      for (const LineGraph::Edge &edge : graph.edges)
        kept.push_back(straight_run(all, edge.piece) < led_on_scratch);
      skeleton = graph.draw(kept);
      for (const LinePiece &piece : line_pieces(skeleton))
        if (int(piece.pixels.size()) < shortest_crack)
          for (const cv::Point &p : piece.pixels)
            skeleton.at<uchar>(p) = 0;
    }



    /** Cracks in the evidence of one set of filters. */
    class Search
    {
    public:
      Search(const cv::Mat &grey, const RidgeField &ridges)
        : ridges(ridges)
        , darkness(relative_darkness(grey, ridges))
        , graph(ridges, darkness)
        , start(graph.cracks())
      {
        remove_spurs(start, longest_spur);
      }

      bool
      is_empty() const
      {
        return cv::countNonZero(start) == 0;
      }

      /** What the cracks keep of their strength in other filters: the median
       * over their pixels. A crest may lie a pixel beside. */
      double
      kept_strength(const RidgeField &other) const
      {
        cv::Mat strength, other_strength;
        cv::dilate(ridges.strength, strength, cv::Mat());
        cv::dilate(other.strength, other_strength, cv::Mat());
        PixelPath pixels;
        cv::findNonZero(start, pixels);
        std::vector<float> kept;
        for (const cv::Point &p : pixels)
          kept.push_back(other_strength.at<float>(p) /
                         std::max(0.01F, strength.at<float>(p)));
        const auto middle = kept.begin() + kept.size() / 2;
        std::nth_element(kept.begin(), middle, kept.end());
        return *middle;
      }

      /** The cracks with what goes on from their ends. */
      CrackLines
      finished() const
      {
        if (is_empty())
          return {ridges, start};
        // Neither scratches nor the outermost pixels lead a crack on.
        cv::Mat closed = graph.scratches();
        cv::rectangle(closed, cv::Rect({0, 0}, closed.size()), 255);
        cv::Mat free = ridges.local.clone();
        free.setTo(0., closed);
        cv::Mat cracks =
          CrackGrowth(ridges, free, darkness, start, far_ahead).grow(start);
        const CrackGrowth near(ridges, free, darkness, cracks, ahead);
        cracks = near.finish_ends(near.grow(cracks));
        remove_spurs(cracks, longest_spur);
        remove_straight_edges(cracks, graph.crests);
        return {ridges, near.place_ends(cracks)};
      }

    private:
      const RidgeField ridges;
      const cv::Mat1f  darkness;
      const CrestGraph graph;
      cv::Mat          start;
    };
  } // namespace



  CrackLines
  find_cracks(const cv::Mat &grey, const int n_octaves)
  {
    const Search wide(grey, filter_ridges(grey, n_octaves));
    if (wide.is_empty())
      return wide.finished();
    const RidgeField ridges = filter_ridges(grey, n_octaves, narrow_filters);
    return wide.kept_strength(ridges) < least_kept
             ? wide.finished()
             : Search(grey, ridges).finished();
  }
} // namespace squeal::tribology
