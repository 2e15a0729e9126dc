// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/tribology/images/image_files.h>

#include <opencv2/imgcodecs.hpp>

#include <glob.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>

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



    /** Whether a name stands for files that match it. */
    bool
    is_wildcard(const std::string &name)
    {
      std::error_code none;
      return name.find_first_of("*?[") != std::string::npos &&
             !std::filesystem::exists(name, none);
    }



    std::vector<std::string>
    matches_of(const std::string &wildcard)
    {
      glob_t     found = {};
      const bool ok    = glob(wildcard.c_str(), 0, nullptr, &found) == 0;
      std::vector<std::string> matches;
      for (std::size_t i = 0; ok && i < found.gl_pathc; ++i)
        matches.emplace_back(found.gl_pathv[i]);
      globfree(&found);
      return matches;
    }



    /** The first five of some names and how many more there are. */
    std::string
    first_of(const std::set<std::string> &names)
    {
      constexpr std::size_t n_shown = 5;
      std::string           list;
      std::size_t           n = 0;
      for (const std::string &name : names)
        if (++n <= n_shown)
          list += (n == 1 ? "" : ", ") + name;
      return names.size() <= n_shown
               ? list
               : list + " and " + std::to_string(names.size() - n_shown) +
                   " more";
    }
  } // namespace



  bool
  is_image_name(const std::filesystem::path &path)
  {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    for (const char *known : {".tif", ".tiff", ".png", ".jpg", ".jpeg", ".bmp"})
      if (ending == known)
        return true;
    return false;
  }



  std::vector<std::string>
  expand_names(const std::vector<std::string> &names, const std::string &entry)
  {
    std::vector<std::string> files;
    std::set<std::string>    known;
    for (const std::string &name : names)
      {
        // A name without wildcards stands for itself, so that what is wrong
        // with the file is said when it is read.
        const std::vector<std::string> matches =
          is_wildcard(name) ? matches_of(name) : std::vector<std::string>{name};
        if (matches.empty())
          throw InputError("'" + entry + "': no file matches " + name);
        for (const std::string &file : matches)
          if (known.insert(file).second)
            files.push_back(file);
      }
    return files;
  }



  std::vector<std::string>
  expand_wildcards(const std::vector<std::string> &names)
  {
    const std::vector<std::string>     files = expand_names(names, "Images");
    std::map<std::string, std::string> stems;
    for (const std::string &file : files)
      {
        const auto same =
          stems.emplace(std::filesystem::path(file).stem(), file);
        if (!same.second)
          throw InputError("'Images': " + file + " and " + same.first->second +
                           " would write the same result files: rename "
                           "one of them");
      }
    return files;
  }



  std::vector<std::string>
  missed_images(const std::vector<std::string> &names,
                const std::vector<std::string> &files)
  {
    namespace fs = std::filesystem;
    std::set<fs::path>                        taken;
    std::map<fs::path, std::set<std::string>> missed;
    for (const std::string &file : files)
      taken.insert(fs::absolute(file).lexically_normal());
    for (const std::string &name : names)
      {
        const fs::path    path(name);
        const std::string folder = path.parent_path().string();
        if (!is_wildcard(name) ||
            path.filename().string().find_first_of("*?[") ==
              std::string::npos ||
            folder.find_first_of("*?[") != std::string::npos)
          continue;
        std::error_code none;
        for (const auto &entry : fs::directory_iterator(
               folder.empty() ? fs::path(".") : fs::path(folder), none))
          if (entry.is_regular_file(none) && is_image_name(entry.path()) &&
              taken.count(fs::absolute(entry.path()).lexically_normal()) == 0)
            missed[folder].insert(entry.path().filename().string());
      }
    std::vector<std::string> lines;
    for (const auto &[folder, images] : missed)
      lines.push_back("'Images': the wildcards miss " +
                      std::to_string(images.size()) + " images of '" +
                      (folder.empty() ? "." : folder.string()) +
                      "': " + first_of(images));
    return lines;
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
