// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/root_action.h>

#include <algorithm>

#include <mpi.h>

namespace squeal
{
  std::string
  from_root(const std::string &text)
  {
    int is_there = 0;
    MPI_Initialized(&is_there);
    if (!is_there)
      return text;
    std::string        result = text;
    unsigned long long size   = result.size();
    MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, 0, MPI_COMM_WORLD);
    result.resize(size);
    // in pieces that an int can count
    constexpr unsigned long long piece = 1ull << 30;
    for (unsigned long long start = 0; start < size; start += piece)
      MPI_Bcast(&result[start],
                static_cast<int>(std::min(piece, size - start)),
                MPI_CHAR,
                0,
                MPI_COMM_WORLD);
    return result;
  }



  std::string
  on_root(const bool is_root, const std::function<std::string()> &action)
  {
    std::string result, failure;
    if (is_root)
      try
        {
          result = action();
        }
      catch (const InputError &e)
        {
          failure = e.what();
        }
    failure = from_root(failure);
    if (!failure.empty())
      throw InputError(failure);
    return from_root(result);
  }
} // namespace squeal
