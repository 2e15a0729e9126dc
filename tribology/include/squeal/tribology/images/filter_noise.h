// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_filter_noise_h
#define squeal_tribology_images_filter_noise_h

#include <opencv2/core.hpp>

#include <cstdint>
#include <tuple>
#include <vector>

namespace squeal::tribology
{
  /** Noise by row of blocks, to interpolate between where it is needed: an
   * image of it would take longer to write and read than to compute. */
  struct NoiseRows
  {
    cv::Mat grid; // CV_32F, a row for each row of blocks
    int     n_rows = 0;

    /** The next rows of blocks beside row @p y of the image, and the share of
     * the second. */
    std::tuple<const float *, const float *, float> beside(int y) const;
  };

  /** Spread of the answers of a filter by block, from the 90th percentile of
   * their sizes, which is 1.645 deviations of a normal distribution and follows
   * heavy tails, but not those that cracks themselves make. A block never
   * counts as much quieter than the others, nor as much louder: a dense network
   * of cracks would pass for noise. */
  class FilterNoise
  {
  public:
    /** Of answers for an image of @p size; @p block: pixels. */
    FilterNoise(const cv::Size &size, double block);

    /** Takes those of the next row of the image, which are read while they are
     * still in the cache. */
    void add_row(const float *values);

    /** That of all rows. Rows that are added then begin another image. */
    NoiseRows finish();

  private:
    /** Bits of sizes, which are in the order of the sizes. */
    using Sizes = std::vector<std::int32_t>;

    static float spread(const Sizes &sizes);

    int begin_of_row(int j) const;
    int begin_of_column(int i) const;

    cv::Size           size, n_blocks;
    cv::Mat1f          grid;
    std::vector<Sizes> sizes; // of the blocks of a row
    int                next_row = 0, row_of_blocks = 0;
  };
} // namespace squeal::tribology

#endif
