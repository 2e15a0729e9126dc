// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/image_tags.h>
#include <squeal/tribology/images/tiff_directory.h>

#include <cstdint>

namespace squeal::tribology
{
  namespace
  {
    constexpr unsigned int subfile_tag = 254, image_width_tag = 256,
                           image_height_tag = 257, photometric_tag = 262,
                           orientation_tag = 274, extra_samples_tag = 338;

    std::size_t
    big_endian_number(const std::string &data,
                      const std::size_t  place,
                      const int          n_bytes)
    {
      std::size_t value = 0;
      for (int i = 0; i < n_bytes; ++i)
        value = value << 8 | std::uint8_t(data[place + i]);
      return value;
    }



    int
    orientation_in(const TiffDirectory &tags)
    {
      const std::uint32_t value = tags.number(orientation_tag).value_or(1);
      return value >= 1 && value <= 8 ? int(value) : 1;
    }



    ImageTags
    tags_of_tiff(const TiffDirectory &first)
    {
      ImageTags tags;
      tags.orientation       = orientation_in(first);
      tags.white_is_zero     = first.number(photometric_tag) == 0U;
      tags.has_extra_samples = first.number(extra_samples_tag).has_value();
      tags.may_have_alpha    = tags.has_extra_samples;
      // Microscopes put a thumbnail behind the image, with or without a mark.
      const auto is_copy = [&](const TiffDirectory &page) {
        const auto size_of = [](const TiffDirectory &d) {
          return std::uint64_t(d.number(image_width_tag).value_or(0)) *
                 d.number(image_height_tag).value_or(0);
        };
        return (page.number(subfile_tag).value_or(0) & 1U) != 0 ||
               size_of(page) < size_of(first);
      };
      for (const TiffDirectory &page : first.later_pages())
        tags.n_images += !is_copy(page);
      return tags;
    }



    constexpr std::size_t bits_at = 24, colour_type_at = 25; // of a PNG

    /** What the chunk tRNS of @p length bytes at @p place says of a grey
     * image, on the scale that fewer than 8 bits are spread to; nothing of
     * other images. */
    std::optional<int>
    transparent_grey(const std::string &data,
                     const std::size_t  place,
                     const std::size_t  length)
    {
      if (data.size() <= colour_type_at || data.size() < place + 2 ||
          length != 2 || data[colour_type_at] != 0 || data[bits_at] < 1)
        return std::nullopt;
      const int bits  = data[bits_at];
      const int value = int(big_endian_number(data, place, 2));
      return bits == 16 ? value
             : bits < 8 ? value * 255 / ((1 << bits) - 1)
                        : value & 255;
    }



    ImageTags
    tags_of_png(const std::string &data)
    {
      ImageTags     tags;
      constexpr int alpha_bit = 4;
      tags.may_have_alpha =
        data.size() > colour_type_at && (data[colour_type_at] & alpha_bit) != 0;
      for (std::size_t at = 8; at + 12 <= data.size();)
        {
          const std::size_t length = big_endian_number(data, at, 4);
          const std::string kind   = data.substr(at + 4, 4);
          if (kind == "tRNS")
            {
              tags.may_have_alpha   = true;
              tags.transparent_grey = transparent_grey(data, at + 8, length);
            }
          else if (kind == "eXIf")
            {
              const std::string exif = data.substr(at + 8, length);
              tags.orientation       = orientation_in(TiffDirectory(exif));
            }
          at += 12 + length;
        }
      return tags;
    }



    ImageTags
    tags_of_jpeg(const std::string &data)
    {
      ImageTags         tags;
      const std::string mark = std::string("Exif\0\0", 6);
      // The segments in front of the pixels.
      for (std::size_t at = 2; at + 4 <= data.size() && data[at] == '\xff';)
        {
          if (data[at + 1] == '\xff') // a fill byte
            {
              ++at;
              continue;
            }
          if (data[at + 1] == '\xda') // the pixels begin
            break;
          const std::size_t length = big_endian_number(data, at + 2, 2);
          if (data[at + 1] == '\xe1' &&
              data.compare(at + 4, mark.size(), mark) == 0)
            {
              const std::string exif =
                data.substr(at + 4 + mark.size(), length);
              tags.orientation = orientation_in(TiffDirectory(exif));
              break;
            }
          at += 2 + length;
        }
      return tags;
    }
  } // namespace



  ImageTags
  image_tags(const std::string &data)
  {
    if (data.compare(0, 8, "\x89PNG\r\n\x1a\n") == 0)
      return tags_of_png(data);
    if (data.compare(0, 2, "\xff\xd8") == 0)
      return tags_of_jpeg(data);
    return tags_of_tiff(TiffDirectory(data));
  }
} // namespace squeal::tribology
