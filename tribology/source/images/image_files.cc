// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/tribology/images/image_files.h>

#include <opencv2/imgcodecs.hpp>

#include <glob.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <ostream>

namespace squeal::tribology
{
  namespace
  {
    std::string
    big_endian(const std::uint32_t value)
    {
      std::string bytes;
      for (int i = 3; i >= 0; --i)
        bytes += char(value >> 8 * i);
      return bytes;
    }



    std::uint32_t
    crc(const std::string &data)
    {
      std::uint32_t c = 0xffffffffU;
      for (const char byte : data)
        {
          c ^= std::uint8_t(byte);
          for (int k = 0; k < 8; ++k)
            c = c & 1U ? 0xedb88320U ^ (c >> 1) : c >> 1;
        }
      return ~c;
    }
  } // namespace



  std::vector<std::string>
  expand_wildcards(const std::vector<std::string> &names)
  {
    std::vector<std::string>           files;
    std::map<std::string, std::string> stems;
    for (const std::string &name : names)
      {
        glob_t found = {};
        // A name without wildcards stands for itself, so that what is wrong
        // with the file is said when it is read.
        const int flags =
          name.find_first_of("*?[") == std::string::npos ? GLOB_NOCHECK : 0;
        const bool ok = glob(name.c_str(), flags, nullptr, &found) == 0;
        std::vector<std::string> matches;
        for (std::size_t i = 0; ok && i < found.gl_pathc; ++i)
          matches.emplace_back(found.gl_pathv[i]);
        globfree(&found);
        if (matches.empty())
          throw InputError("'Images': no file matches " + name);
        for (const std::string &file : matches)
          {
            const std::string stem = std::filesystem::path(file).stem();
            const auto        same = stems.emplace(stem, file);
            if (!same.second && same.first->second == file)
              continue;
            if (!same.second)
              throw InputError("'Images': " + file + " and " +
                               same.first->second +
                               " would write the same result files: rename "
                               "one of them");
            files.push_back(file);
          }
      }
    return files;
  }



  void
  write_png(const std::string &path,
            const cv::Mat     &image,
            const std::string &text)
  {
    std::vector<uchar> bytes;
    cv::imencode(".png", image, bytes);
    std::string data(bytes.begin(), bytes.end());
    if (!text.empty())
      {
        const std::string chunk = std::string("tEXtsqueal") + '\0' + text;
        // The last chunk, IEND, has twelve bytes.
        data.insert(data.size() - 12,
                    big_endian(std::uint32_t(chunk.size() - 4)) + chunk +
                      big_endian(crc(chunk)));
      }
    write_atomically(path, [&](std::ostream &out) {
      out.write(data.data(), std::streamsize(data.size()));
    });
  }
} // namespace squeal::tribology
