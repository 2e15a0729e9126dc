// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/centre_line.h>
#include <squeal/tribology/images/crack_finder.h>
#include <squeal/tribology/images/crack_growth.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace squeal::tribology
{
  namespace
  {
    // In units of noise.
    constexpr double crest_levels[]  = {2.8, 3.5};
    constexpr double free_strength   = 2.; // counts nothing
    constexpr double strongest_needs = 4.;
    constexpr double sum_needs       = 80.;
    // In pixels.
    constexpr int longest_spur    = 8;
    constexpr int shortest_piece  = 25;
    constexpr int shortest_sample = 10;
    // Shape.
    constexpr double least_chord      = 0.5;
    constexpr double least_axis_share = 0.2;
    constexpr int    straight_length  = 40;
    constexpr double straight_within  = 0.0075;
    constexpr int    scratch_votes    = 60;
    constexpr int    scratch_length   = 110;
    constexpr int    scratch_gap      = 12;
    constexpr int    scratch_width    = 13;

    /** Strength of the axis of a piece. */
    struct Weight
    {
      double sum = 0., strongest = 0.;
    };

    Weight
    weigh(const LinePiece &piece, const RidgeField &ridges)
    {
      Weight w;
      for (const cv::Point &p : piece.axis)
        {
          const double z = ridges.strength.at<float>(p);
          w.sum += z - free_strength;
          w.strongest = std::max(w.strongest, z);
        }
      return w;
    }



    /** Sum that less than one background piece of this image reaches: their
     * sums are exponentially distributed about the median. */
    double
    significant_sum(const std::vector<LinePiece> &pieces,
                    const std::vector<Weight>    &weights)
    {
      std::vector<double> sums;
      for (std::size_t i = 0; i < pieces.size(); ++i)
        if (int(pieces[i].axis.size()) >= shortest_sample)
          sums.push_back(weights[i].sum);
      if (sums.empty())
        return sum_needs;
      const auto middle = sums.begin() + sums.size() / 2;
      std::nth_element(sums.begin(), middle, sums.end());
      const double mean = *middle / std::log(2.);
      // Pieces beside a crack share in it: four fifths are background.
      return std::max(sum_needs,
                      0.8 * mean * std::log(std::max<double>(2., sums.size())));
    }



    bool
    is_straight(const LinePiece &piece)
    {
      return int(piece.axis.size()) > straight_length &&
             piece.waviness() < straight_within * piece.axis.size();
    }



    bool
    has_shape_of_crack(const LinePiece &piece)
    {
      return int(piece.axis.size()) >= shortest_piece &&
             piece.chord_ratio() > least_chord &&
             piece.axis.size() > least_axis_share * piece.pixels.size() &&
             !is_straight(piece);
    }



    /** Takes away the strength along straight lines that crests follow over a
     * long way: grooves, scratches and edges of the specimen. A crack that
     * crosses one has another direction and stays. */
    void
    silence_scratches(RidgeField &ridges, const cv::Mat &crests)
    {
      constexpr int          n = RidgeField::n_directions;
      std::vector<cv::Vec4i> lines;
      cv::HoughLinesP(crests,
                      lines,
                      1.,
                      CV_PI / 360.,
                      scratch_votes,
                      scratch_length,
                      scratch_gap);
      std::vector<cv::Mat> masks(n);
      for (const cv::Vec4i &l : lines)
        {
          const double a = std::atan2(l[3] - l[1], l[2] - l[0]) / CV_PI * n;
          for (int turn = -1; turn <= 1; ++turn)
            {
              cv::Mat &mask = masks[(cvRound(a) + turn + 2 * n) % n];
              if (mask.empty())
                mask = cv::Mat::zeros(crests.size(), CV_8U);
              cv::line(mask, {l[0], l[1]}, {l[2], l[3]}, 255, scratch_width);
            }
        }
      for (int t = 0; t < n; ++t)
        if (!masks[t].empty())
          ridges.strength.setTo(0., masks[t] & (ridges.direction == t));
    }



    cv::Mat
    crests_above(const RidgeField &ridges, const double level)
    {
      cv::Mat crests = cv::Mat::zeros(ridges.strength.size(), CV_8U);
      for (int y = 0; y < crests.rows; ++y)
        {
          const float *z = ridges.strength.ptr<float>(y);
          for (int x = 0; x < crests.cols; ++x)
            if (z[x] >= level && ridges.is_crest({x, y}))
              crests.at<uchar>(y, x) = 255;
        }
      cv::dilate(crests, crests, cv::Mat());
      cv::Mat skeleton = thin(crests);
      remove_spurs(skeleton, longest_spur);
      return skeleton;
    }



    void
    add_cracks(const RidgeField &ridges, const double level, cv::Mat &cracks)
    {
      const auto          pieces = line_pieces(crests_above(ridges, level));
      std::vector<Weight> weights;
      for (const LinePiece &piece : pieces)
        weights.push_back(weigh(piece, ridges));
      const double needed = significant_sum(pieces, weights);
      for (std::size_t i = 0; i < pieces.size(); ++i)
        if (weights[i].sum >= needed &&
            weights[i].strongest >= strongest_needs &&
            has_shape_of_crack(pieces[i]))
          for (const cv::Point &p : pieces[i].pixels)
            cracks.at<uchar>(p) = 255;
    }



    /** Removes the straight stretches between junctions: grooves that a crack
     * meets. */
    void
    remove_straight_stretches(cv::Mat &skeleton)
    {
      cv::Mat   nodes = cv::Mat::zeros(skeleton.size(), CV_8U);
      PixelPath pixels;
      cv::findNonZero(skeleton, pixels);
      for (const cv::Point &p : pixels)
        if (n_neighbours(skeleton, p) > 2)
          nodes.at<uchar>(p) = 255;
      cv::dilate(nodes, nodes, cv::Mat());
      cv::Mat stretches = skeleton.clone();
      stretches.setTo(0, nodes);
      for (const LinePiece &piece : line_pieces(stretches))
        if (is_straight(piece))
          for (const cv::Point &p : piece.pixels)
            skeleton.at<uchar>(p) = 0;
      for (const LinePiece &piece : line_pieces(skeleton))
        if (int(piece.pixels.size()) <= longest_spur)
          for (const cv::Point &p : piece.pixels)
            skeleton.at<uchar>(p) = 0;
    }
  } // namespace



  cv::Mat
  find_centre_lines(const RidgeField &field)
  {
    // Scratches neither count nor lead a crack on.
    RidgeField ridges = field;
    ridges.strength   = field.strength.clone();
    silence_scratches(ridges, crests_above(field, crest_levels[0]));
    cv::Mat cracks = cv::Mat::zeros(ridges.strength.size(), CV_8U);
    for (const double level : crest_levels)
      add_cracks(ridges, level, cracks);
    // The levels run at most a pixel apart.
    cv::dilate(cracks,
               cracks,
               cv::getStructuringElement(cv::MORPH_CROSS, cv::Size(3, 3)));
    cracks = thin(cracks);
    remove_spurs(cracks, longest_spur);
    if (cv::countNonZero(cracks) > 0)
      cracks = CrackGrowth(ridges, cracks).grow(cracks);
    remove_spurs(cracks, longest_spur);
    remove_straight_stretches(cracks);
    remove_spurs(cracks, longest_spur);
    return cracks;
  }
} // namespace squeal::tribology
