// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/checksum.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/inputs_read.h>

#include <filesystem>
#include <mutex>

namespace squeal
{
  namespace
  {
    /** One for the process: files are read in every layer, and what a result
     * depends on must not be lost on the way up. */
    struct Inputs
    {
      std::mutex                         mutex;
      std::map<std::string, std::string> content_of_path;
    };

    Inputs &
    inputs()
    {
      static Inputs all;
      return all;
    }

    std::string
    absolute_name(const std::string &path)
    {
      return std::filesystem::absolute(path).lexically_normal().string();
    }
  } // namespace



  std::string
  read_input_file(const std::string &path)
  {
    std::string                       bytes = read_file(path);
    const std::lock_guard<std::mutex> guard(inputs().mutex);
    inputs().content_of_path[absolute_name(path)] = content_of(bytes);
    return bytes;
  }

  std::string
  content_of(const std::string &bytes)
  {
    return std::to_string(bytes.size()) + " bytes, checksum " +
           checksum_of(bytes);
  }

  std::map<std::string, std::string>
  inputs_read()
  {
    const std::lock_guard<std::mutex> guard(inputs().mutex);
    return inputs().content_of_path;
  }

  std::string
  content_of_input(const std::string &path)
  {
    const auto known = inputs_read();
    if (const auto found = known.find(absolute_name(path));
        found != known.end())
      return found->second;
    try
      {
        return content_of(read_input_file(path));
      }
    catch (const InputError &)
      {
        return "missing";
      }
  }
} // namespace squeal
