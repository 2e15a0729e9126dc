// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_open_hdf5_files_h
#define squeal_base_open_hdf5_files_h

#include <hdf5.h>

namespace squeal
{
  /**
   * Closes an HDF5 file. @return below 0 where it could not be written to its
   * end, as the disk is full. HDF5 has then freed a part of it, but keeps it in
   * its list, and closes it once more when MPI ends: a segmentation fault.
   */
  herr_t close_hdf5_file(hid_t file);

  /** Whether HDF5 has such a file in its list, which this process cannot take
   * out of it: it then has to end without the end of MPI. */
  bool hdf5_cannot_end();
} // namespace squeal

#endif
