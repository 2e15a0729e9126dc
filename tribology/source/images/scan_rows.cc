// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/scan_rows.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    constexpr int most_rows      = 4;  // of one piece
    constexpr int row_window     = 41; // pixels along a row that are averaged
    constexpr int shortest_piece = 30; // pixels
    constexpr int next_columns   = 8;  // by which a piece is prolonged
    constexpr std::size_t fewest_pieces = 4; // that tell of the scan
    // Of the depth: what an edge of a row leaves in the next one, by which its
    // rows differ, and by which the surface above and below does. Optics leave
    // 0.3 and more of a narrow crack there.
    constexpr float sharp_edge = 0.15F, alike_flanks = 0.4F;
    // Of the noise of means along a row, and grey levels at least.
    constexpr float least_over_noise = 10.F, least_darkening = 3.F;
    // A pixel of a row is dark by so much of its depth, and most of them are.
    constexpr float  dark_pixel = 0.3F;
    constexpr double mostly     = 0.6;

    /** Deviation by which means along neighbouring rows differ from one
     * another, grey levels. */
    float
    noise_between_rows(const cv::Mat1f &means)
    {
      std::vector<float> sizes;
      for (int y = 1; y + 1 < means.rows; ++y)
        for (int x = 0; x < means.cols; x += 4)
          sizes.push_back(
            std::abs(means(y, x) - 0.5F * (means(y - 1, x) + means(y + 1, x))));
      if (sizes.empty())
        return 0.F;
      const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
      std::nth_element(sizes.begin(), middle, sizes.end());
      return *middle / 0.6745F;
    }



    /** The @p n rows from one on against what is above and below them. */
    class RowSteps
    {
    public:
      RowSteps(const cv::Mat1f &means,
               const int        y,
               const int        n,
               const float      noise)
        : noise(noise)
        , least(std::max(least_darkening, least_over_noise * noise))
        , inner(means.cols, 0.F)
        , above(means.cols)
        , below(means.cols)
        , before(means[y - 1])
        , after(means[y + n])
      {
        for (int k = 0; k < n; ++k)
          rows.push_back(means[y + k]);
        const float *above_1 = means[y - 2], *above_2 = means[y - 3],
                    *below_1 = means[y + n + 1], *below_2 = means[y + n + 2];
        for (const float *row : rows)
          for (int x = 0; x < means.cols; ++x)
            inner[x] += row[x] / float(n);
        for (int x = 0; x < means.cols; ++x)
          {
            above[x] = 0.5F * (above_1[x] + above_2[x]);
            below[x] = 0.5F * (below_1[x] + below_2[x]);
          }
      }

      /** By how much they are darker at column @p x; 0 where their edges are no
       * steps. */
      float
      at(const int x) const
      {
        const float depth = 0.5F * (above[x] + below[x]) - inner[x];
        if (depth < least ||
            std::abs(above[x] - below[x]) > alike_flanks * depth)
          return 0.F;
        const float within = sharp_edge * depth + noise;
        if (std::abs(before[x] - above[x]) > within ||
            std::abs(after[x] - below[x]) > within)
          return 0.F;
        for (const float *row : rows)
          if (std::abs(row[x] - inner[x]) > within)
            return 0.F;
        return depth;
      }

    private:
      float                      noise, least;
      std::vector<float>         inner, above, below; // means by column
      const float               *before, *after;
      std::vector<const float *> rows;
    };



    /** The rows of one candidate and its columns. */
    struct Piece
    {
      cv::Rect box;
      float    depth = 0.F;
    };

    /** What the rows above and below @p b give in its place. */
    cv::Mat1f
    from_beside(const cv::Mat1f &grey, const cv::Rect &b)
    {
      cv::Mat1f filled(b.size());
      for (int y = 0; y < b.height; ++y)
        for (int x = 0; x < b.width; ++x)
          {
            const float t = float(y + 1) / float(b.height + 1);
            filled(y, x)  = (1.F - t) * grey(b.y - 1, b.x + x) +
                           t * grey(b.y + b.height, b.x + x);
          }
      return filled;
    }



    /** With what goes on from it, where grains hide the edges. */
    Piece
    prolonged(const cv::Mat1f &grey, Piece piece)
    {
      const auto is_dark = [&](const int x) {
        const cv::Rect next(x, piece.box.y, next_columns, piece.box.height);
        return x >= 0 && next.br().x <= grey.cols &&
               cv::mean(from_beside(grey, next) - grey(next))[0] >
                 0.5 * piece.depth;
      };
      while (is_dark(piece.box.br().x))
        piece.box.width += next_columns;
      while (is_dark(piece.box.x - next_columns))
        {
          piece.box.x -= next_columns;
          piece.box.width += next_columns;
        }
      return piece;
    }



    /** Fills it in, if its pixels are dark all along. */
    bool
    fill(cv::Mat1f &grey, const Piece &piece)
    {
      const cv::Rect &b      = piece.box;
      const cv::Mat1f filled = from_beside(grey, b);
      int             n_dark = 0;
      for (int y = 0; y < b.height; ++y)
        for (int x = 0; x < b.width; ++x)
          n_dark +=
            filled(y, x) - grey(b.y + y, b.x + x) > dark_pixel * piece.depth;
      if (n_dark < mostly * b.area())
        return false;
      filled.copyTo(grey(b));
      return true;
    }



    /** Candidates of @p n rows from row @p y on. The mean along a row falls to
     * a half of its depth where a piece ends. */
    std::vector<Piece>
    candidates(const cv::Mat1f &means, const int y, const int n, float noise)
    {
      const RowSteps     steps(means, y, n, noise);
      std::vector<Piece> pieces;
      for (int x = 0; x < means.cols;)
        {
          Piece piece;
          int   end = x;
          for (float d; end < means.cols && (d = steps.at(end)) > 0.F; ++end)
            piece.depth = std::max(piece.depth, d);
          int first = x, last = end;
          while (first < last && steps.at(first) < 0.5F * piece.depth)
            ++first;
          while (first < last && steps.at(last - 1) < 0.5F * piece.depth)
            --last;
          piece.box = {first, y, last - first, n};
          if (piece.box.width >= shortest_piece)
            pieces.push_back(piece);
          x = std::max(end, x + 1);
        }
      return pieces;
    }
  } // namespace



  ScanRows
  without_scan_rows(const cv::Mat &grey)
  {
    ScanRows  result;
    cv::Mat1f filled = grey.clone();
    cv::Mat1f means;
    cv::boxFilter(
      grey, means, CV_32F, {row_window, 1}, {-1, -1}, true, cv::BORDER_REFLECT);
    const float noise = noise_between_rows(means);
    for (int n = 1; n <= most_rows; ++n)
      for (int y = 3; y + n + 2 < grey.rows; ++y)
        for (const Piece &found : candidates(means, y, n, noise))
          if (const Piece piece = prolonged(filled, found); fill(filled, piece))
            {
              PixelPath pixels;
              for (int x = 0; x < piece.box.width; ++x)
                pixels.emplace_back(piece.box.x + x, y + n / 2);
              result.pieces.push_back(pixels);
            }
    result.are_filled = result.pieces.size() >= fewest_pieces;
    result.grey       = result.are_filled ? cv::Mat(filled) : grey;
    return result;
  }
} // namespace squeal::tribology
