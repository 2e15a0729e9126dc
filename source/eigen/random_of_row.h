// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_eigen_random_of_row_h
#define squeal_source_eigen_random_of_row_h

#include <cmath>
#include <cstdint>

namespace squeal
{
  /** A random number from -1 to 1 that depends on the global row and the number
   * of a column only. A linear congruential generator started from the row
   * gives a linear function of it: the columns of alike parts would all be
   * combinations of two, and second differences zero. This is Steele, Lea and
   * Flood's SplitMix (2014). */
  inline double
  random_of_row(const std::uint64_t row, const std::uint64_t column)
  {
    std::uint64_t z = ((row << 16) + column + 1) * 0x9e3779b97f4a7c15u;
    z               = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z               = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return std::ldexp(double((z ^ (z >> 31)) >> 11), -52) - 1.;
  }
} // namespace squeal

#endif
