// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/packing.h>

#include <algorithm>
#include <limits>

namespace squeal
{
  std::vector<std::vector<char>>
  gather_on_all(const MPI_Comm comm, const std::vector<char> &own)
  {
    int rank, n_ranks;
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &n_ranks);
    std::vector<std::vector<char>> all(n_ranks);
    for (int r = 0; r < n_ranks; ++r)
      {
        unsigned long long size = own.size();
        MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, r, comm);
        all[r].resize(size);
        if (r == rank)
          all[r] = own;
        // MPI counts in int.
        constexpr std::size_t most = std::numeric_limits<int>::max() / 2;
        for (std::size_t first = 0; first < size; first += most)
          MPI_Bcast(all[r].data() + first,
                    static_cast<int>(std::min<std::size_t>(most, size - first)),
                    MPI_BYTE,
                    r,
                    comm);
      }
    return all;
  }
} // namespace squeal
