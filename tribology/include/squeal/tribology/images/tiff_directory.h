// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_tiff_directory_h
#define squeal_tribology_images_tiff_directory_h

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /** A directory of a TIFF file, the first one at that; of any other file an
   * empty one. Looks into @p data, which must outlive it. */
  class TiffDirectory
  {
  public:
    explicit TiffDirectory(const std::string &data);

    /** Text of @p tag; empty when there is none. */
    std::string text(unsigned int tag) const;

    /** First number (16 or 32 bit) of @p tag. */
    std::optional<std::uint32_t> number(unsigned int tag) const;

    /** The directories behind this one, each once. */
    std::vector<TiffDirectory> later_pages() const;

  private:
    /** Place of the entry of a tag. */
    std::optional<std::size_t> entry(unsigned int tag) const;

    /** The number in some bytes; 0 behind the end. */
    std::uint32_t bytes(std::size_t place, int n_bytes) const;

    const std::string &data;
    bool               big = false, valid = false;
    std::size_t        directory = 0; /**< its place */
  };
} // namespace squeal::tribology

#endif
