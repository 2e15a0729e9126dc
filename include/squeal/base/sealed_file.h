// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_sealed_file_h
#define squeal_base_sealed_file_h

#include <squeal/base/hdf5_handle.h>

#include <string>

namespace squeal
{
  /**
   * @name HDF5 files that squeal reads back
   *
   * They start with a user block of 512 bytes, which HDF5 leaves alone: a line
   * "squeal <kind>" by which squeal knows its own files, and size and checksum
   * of all that follows. A file that has been cut, extended or changed in any
   * byte is told from a whole one before HDF5 sees it.
   */
  //@{
  /** How such a file is made: to be handed to H5Fcreate(). */
  Hdf5Handle sealed_creation();

  /** Fills the block of a closed file in and hands all bytes to the disk.
   * Throws InputError. */
  void seal_file(const std::string &path, const std::string &kind);

  /** Whether @p path is a file that squeal has made as one of this @p kind,
   * damaged or not. */
  bool is_sealed_file(const std::string &path, const std::string &kind);

  /** Whether every byte is as seal_file() has left it. */
  bool is_whole_file(const std::string &path, const std::string &kind);
  //@}
} // namespace squeal

#endif
