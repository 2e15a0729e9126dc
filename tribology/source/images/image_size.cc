// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/available_memory.h>
#include <squeal/base/exceptions.h>
#include <squeal/results/table.h>
#include <squeal/tribology/images/image_size.h>
#include <squeal/tribology/images/tiff_directory.h>

#include <cstdlib>

namespace squeal::tribology
{
  namespace
  {
    constexpr unsigned int tiff_width = 256, tiff_height = 257;

    bool
    begins(const std::string &data, const std::string &mark)
    {
      return data.compare(0, mark.size(), mark) == 0;
    }



    std::uint32_t
    big_endian(const std::string &data, const std::size_t place, const int n)
    {
      std::uint32_t value = 0;
      for (int i = 0; i < n; ++i)
        value = value << 8 | std::uint8_t(data[place + i]);
      return value;
    }



    std::optional<ImageSize>
    size_of_png(const std::string &data)
    {
      if (data.size() < 24 || data.compare(12, 4, "IHDR") != 0)
        return {};
      return ImageSize{big_endian(data, 16, 4), big_endian(data, 20, 4)};
    }



    /** The segments of a JPEG up to the one that starts the frame. */
    std::optional<ImageSize>
    size_of_jpeg(const std::string &data)
    {
      std::size_t place = 2;
      while (place + 9 <= data.size())
        {
          const unsigned int mark = big_endian(data, place, 2);
          if (mark == 0xffff) // fill bytes
            {
              ++place;
              continue;
            }
          if (mark < 0xff01)
            return {};
          const bool starts_frame = mark >= 0xffc0 && mark <= 0xffcf &&
                                    mark != 0xffc4 && mark != 0xffc8 &&
                                    mark != 0xffcc;
          if (starts_frame)
            return ImageSize{big_endian(data, place + 7, 2),
                             big_endian(data, place + 5, 2)};
          const bool has_no_length =
            mark == 0xff01 || (mark >= 0xffd0 && mark <= 0xffd8);
          place += has_no_length ? 2 : 2 + big_endian(data, place + 2, 2);
        }
      return {};
    }



    std::optional<ImageSize>
    size_of_bmp(const std::string &data)
    {
      if (data.size() < 26)
        return {};
      const auto at = [&](const std::size_t place) {
        std::int32_t value = 0;
        for (int i = 3; i >= 0; --i)
          value = std::int32_t(std::uint32_t(value) << 8 |
                               std::uint8_t(data[place + i]));
        return std::llabs(value); // rows from the top have a negative height
      };
      return ImageSize{std::uint64_t(at(18)), std::uint64_t(at(22))};
    }
  } // namespace



  double
  ImageSize::n_pixels() const
  {
    return double(width) * double(height);
  }



  std::optional<ImageSize>
  image_size(const std::string &data)
  {
    if (begins(data, "\x89PNG\r\n\x1a\n"))
      return size_of_png(data);
    if (begins(data, "\xff\xd8"))
      return size_of_jpeg(data);
    if (begins(data, "BM"))
      return size_of_bmp(data);
    const TiffDirectory tiff(data);
    const auto          width  = tiff.number(tiff_width);
    const auto          height = tiff.number(tiff_height);
    if (!width || !height)
      return {};
    return ImageSize{*width, *height};
  }



  void
  require_room(const std::string &path,
               const ImageSize   &size,
               const double       largest)
  {
    const double      needed = bytes_per_pixel * size.n_pixels();
    const std::string text   = path + " has " + std::to_string(size.width) +
                             " x " + std::to_string(size.height) +
                             " pixels, which take some " +
                             rounded_text(1e-9 * needed, 2) + " GB of memory";
    if (size.n_pixels() > 1e6 * largest)
      throw InputError(text +
                       ": reduce or cut the image, or raise 'Largest "
                       "image' (" +
                       shortest_text(largest) + " million pixels)");
    const double available = available_memory();
    if (needed > available)
      throw InputError(text + ", and " + rounded_text(1e-9 * available, 2) +
                       " GB are available: reduce or cut the image");
  }
} // namespace squeal::tribology
