// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/open_hdf5_files.h>

#include <atomic>

namespace squeal
{
  namespace
  {
    /** As the list of HDF5 itself, one for the process; its own count leaves
     * out what has lost its last user. */
    std::atomic<bool> &
    has_unclosed_file()
    {
      static std::atomic<bool> result(false);
      return result;
    }
  } // namespace



  herr_t
  close_hdf5_file(const hid_t file)
  {
    const herr_t flushed = H5Fflush(file, H5F_SCOPE_LOCAL),
                 closed  = H5Fclose(file);
    if (closed < 0)
      has_unclosed_file() = true;
    return flushed < 0 ? flushed : closed;
  }



  bool
  hdf5_cannot_end()
  {
    return has_unclosed_file();
  }
} // namespace squeal
