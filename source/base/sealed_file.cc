// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/checksum.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/input_file.h>
#include <squeal/base/sealed_file.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <unistd.h>

namespace squeal
{
  namespace
  {
    constexpr std::size_t block_size = 512; // the least that HDF5 knows

    std::string
    mark_of(const std::string &kind)
    {
      return "squeal " + kind + "\n";
    }

    /** The block in front of what follows it in the file @p path. */
    std::string
    block_of(const std::string &kind, const std::string &path)
    {
      const FileChecksum sum   = checksum_of_file(path, block_size);
      std::string        block = mark_of(kind) + std::to_string(sum.size) +
                          " bytes\n" + "checksum " + sum.digits + "\n";
      block.resize(block_size, '\0');
      return block;
    }

    /** The first bytes of a file, fewer where it is shorter. */
    std::string
    first_bytes(const std::string &path, const std::size_t n)
    {
      std::string   start(n, '\0');
      std::ifstream in(path, std::ios::binary);
      in.read(start.data(), start.size());
      start.resize(in.gcount());
      return start;
    }
  } // namespace



  Hdf5Handle
  sealed_creation()
  {
    const hid_t list = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(list, block_size);
    return {list, H5Pclose};
  }



  void
  seal_file(const std::string &path, const std::string &kind)
  {
    if (first_bytes(path, block_size).size() < block_size)
      throw InputError("cannot write '" + path + "': it is cut off");
    const std::string block      = block_of(kind, path);
    const int         descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    const bool        is_written =
      descriptor >= 0 &&
      ::pwrite(descriptor, block.data(), block.size(), 0) ==
        static_cast<ssize_t>(block.size()) &&
      ::fsync(descriptor) == 0;
    const int error = errno;
    if (descriptor >= 0)
      ::close(descriptor);
    if (!is_written)
      throw InputError("cannot write '" + path + "': " + std::strerror(error));
  }



  bool
  is_sealed_file(const std::string &path, const std::string &kind)
  {
    const std::string mark = mark_of(kind);
    return input_file_fault(path).empty() &&
           first_bytes(path, mark.size()) == mark;
  }

  bool
  is_whole_file(const std::string &path, const std::string &kind)
  {
    const std::string block = first_bytes(path, block_size);
    return block.size() == block_size && block == block_of(kind, path);
  }
} // namespace squeal
