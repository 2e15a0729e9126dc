// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/filter_noise.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace squeal::tribology
{
  namespace
  {
    constexpr float heaviest_tail = 3.F; // 90th percentile over median
    // Of the noise of the median block.
    constexpr float quietest_block = 0.3F, loudest_block = 3.F;


    float
    size_of_bits(const std::int32_t bits)
    {
      float size;
      std::memcpy(&size, &bits, sizeof size);
      return size;
    }



    /** Appends the size of every second value to @p sizes. */
    void
    append_sizes(const float               *values,
                 const int                  n_values,
                 std::vector<std::int32_t> &sizes)
    {
      const std::size_t before = sizes.size();
      sizes.resize(before + std::size_t(n_values + 1) / 2);
      std::int32_t *size = sizes.data() + before;
      for (int x = 0; x < n_values; x += 2)
        {
          const float value = std::abs(values[x]);
          std::memcpy(size++, &value, sizeof value);
        }
    }



    /** That of rank @p nth, counted from zero, below @p upper, which at least
     * so many do not exceed. Halving what it can be counts all sizes for every
     * bit, many at once, which takes less time than to sort them in part. */
    std::int32_t
    size_of_rank(const std::vector<std::int32_t> &sizes,
                 const int                        nth,
                 std::int32_t                     upper)
    {
      std::int32_t lower = 0;
      while (lower < upper)
        {
          const std::int32_t middle  = lower + (upper - lower) / 2;
          int                n_up_to = 0;
          for (const std::int32_t size : sizes)
            n_up_to += size <= middle ? 1 : 0;
          if (n_up_to > nth)
            upper = middle;
          else
            lower = middle + 1;
        }
      return lower;
    }
  } // namespace



  std::tuple<const float *, const float *, float>
  NoiseRows::beside(const int y) const
  {
    const auto place = float((y + 0.5) / (double(n_rows) / grid.rows) - 0.5);
    const int  row   = cvFloor(place);
    return {grid.ptr<float>(std::max(row, 0)),
            grid.ptr<float>(std::min(row + 1, grid.rows - 1)),
            place - float(row)};
  }



  FilterNoise::FilterNoise(const cv::Size &size, const double block)
    : size(size)
    , n_blocks(std::max(1, cvRound(size.width / block)),
               std::max(1, cvRound(size.height / block)))
    , grid(cv::Mat1f::zeros(n_blocks))
    , sizes(n_blocks.width)
  {
  }



  int
  FilterNoise::begin_of_row(const int j) const
  {
    return j * size.height / n_blocks.height;
  }



  int
  FilterNoise::begin_of_column(const int i) const
  {
    return i * size.width / n_blocks.width;
  }



  /** From the 90th percentile, at most by a heavy tail above the median. */
  float
  FilterNoise::spread(const Sizes &sizes)
  {
    const auto  largest = *std::max_element(sizes.begin(), sizes.end());
    const auto  tail = size_of_rank(sizes, int(9 * sizes.size() / 10), largest);
    const int   half = int(sizes.size() / 2);
    const float by_tail    = size_of_bits(tail) / 1.645F;
    const auto  limited_by = [](const std::int32_t median) {
      return heaviest_tail * size_of_bits(median) / 0.6745F;
    };
    // Mostly the median does not limit anything, which one count tells.
    int n_that_limit = 0;
    for (const std::int32_t size : sizes)
      n_that_limit += limited_by(size) < by_tail ? 1 : 0;
    return n_that_limit <= half ? by_tail
                                : limited_by(size_of_rank(sizes, half, tail));
  }



  void
  FilterNoise::add_row(const float *values)
  {
    const int y = next_row++;
    if ((y - begin_of_row(row_of_blocks)) % 2 == 0)
      for (int i = 0; i < n_blocks.width; ++i)
        {
          const int x = begin_of_column(i) + (y / 2) % 2;
          append_sizes(values + x, begin_of_column(i + 1) - x, sizes[i]);
        }
    if (next_row < begin_of_row(row_of_blocks + 1))
      return;
    for (int i = 0; i < n_blocks.width; ++i)
      {
        if (!sizes[i].empty())
          grid(row_of_blocks, i) = spread(sizes[i]);
        sizes[i].clear();
      }
    ++row_of_blocks;
  }



  NoiseRows
  FilterNoise::finish()
  {
    next_row = row_of_blocks = 0;
    std::vector<float> all(grid.begin(), grid.end());
    std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
    // Below a thousandth of a grey level there is only rounding.
    const float usual = all[all.size() / 2];
    cv::Mat1f   limited;
    cv::max(grid, std::max(quietest_block * usual, 1e-3F), limited);
    cv::min(limited, std::max(loudest_block * usual, 1e-3F), limited);
    cv::GaussianBlur(
      limited, limited, cv::Size(3, 3), 0., 0., cv::BORDER_REPLICATE);
    NoiseRows noise;
    noise.n_rows = size.height;
    cv::resize(limited,
               noise.grid,
               cv::Size(size.width, n_blocks.height),
               0.,
               0.,
               cv::INTER_LINEAR);
    return noise;
  }
} // namespace squeal::tribology
