// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/tiff_directory.h>

#include <set>

namespace squeal::tribology
{
  TiffDirectory::TiffDirectory(const std::string &data)
    : data(data)
  {
    if (data.size() < 8)
      return;
    big   = data[0] == 'M';
    valid = (data.compare(0, 2, "II") == 0 || data.compare(0, 2, "MM") == 0) &&
            bytes(2, 2) == 42;
    directory = bytes(4, 4);
  }



  std::optional<std::size_t>
  TiffDirectory::entry(const unsigned int tag) const
  {
    if (!valid)
      return {};
    const std::size_t n_entries = bytes(directory, 2);
    for (std::size_t i = 0; i < n_entries; ++i)
      {
        const std::size_t place = directory + 2 + 12 * i;
        if (place + 12 > data.size())
          return {};
        if (bytes(place, 2) == tag)
          return place;
      }
    return {};
  }



  std::string
  TiffDirectory::text(const unsigned int tag) const
  {
    const auto place = entry(tag);
    if (!place)
      return "";
    const std::size_t length = bytes(*place + 4, 4);
    const std::size_t start  = length > 4 ? bytes(*place + 8, 4) : *place + 8;
    return start < data.size() ? data.substr(start, length) : "";
  }



  std::optional<std::uint32_t>
  TiffDirectory::number(const unsigned int tag) const
  {
    constexpr std::uint32_t short_type = 3, long_type = 4;
    const auto              place = entry(tag);
    if (!place)
      return {};
    const std::uint32_t type = bytes(*place + 2, 2);
    if (type == short_type)
      return bytes(*place + 8, 2);
    if (type == long_type)
      return bytes(*place + 8, 4);
    return {};
  }



  std::vector<TiffDirectory>
  TiffDirectory::later_pages() const
  {
    std::vector<TiffDirectory> pages;
    if (!valid)
      return pages;
    // A damaged chain may run in circles.
    std::set<std::size_t> seen = {directory};
    for (TiffDirectory page = *this;; pages.push_back(page))
      {
        const std::size_t n_entries = bytes(page.directory, 2);
        page.directory = bytes(page.directory + 2 + 12 * n_entries, 4);
        if (page.directory == 0 || page.directory + 2 > data.size() ||
            !seen.insert(page.directory).second)
          return pages;
      }
  }



  std::uint32_t
  TiffDirectory::bytes(const std::size_t place, const int n_bytes) const
  {
    std::uint32_t value = 0;
    if (place + n_bytes > data.size())
      return 0;
    for (int i = 0; i < n_bytes; ++i)
      value |= std::uint32_t(std::uint8_t(data[place + i]))
               << 8 * (big ? n_bytes - 1 - i : i);
    return value;
  }
} // namespace squeal::tribology
