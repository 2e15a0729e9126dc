// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_packing_h
#define squeal_base_packing_h

#include <Eigen/Core>

#include <mpi.h>

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace squeal
{
  /** Values one after the other as bytes, for messages between the ranks of one
   * run. Numbers, texts, plain structures, and vectors and matrices of them. */
  class Packer
  {
  public:
    template <typename T>
    std::enable_if_t<std::is_trivially_copyable_v<T>>
    put(const T &value)
    {
      append(&value, sizeof(T));
    }

    void
    put(const std::string &text)
    {
      put(text.size());
      append(text.data(), text.size());
    }

    template <typename T>
    void
    put(const std::vector<T> &values)
    {
      put(values.size());
      for (const T &value : values)
        put(value);
    }

    template <typename Scalar, int rows, int columns, int options>
    void
    put(const Eigen::Matrix<Scalar, rows, columns, options> &matrix)
    {
      put(matrix.rows());
      put(matrix.cols());
      append(matrix.data(), matrix.size() * sizeof(Scalar));
    }

    const std::vector<char> &
    bytes() const
    {
      return list;
    }

  private:
    void
    append(const void *from, const std::size_t n)
    {
      const char *begin = static_cast<const char *>(from);
      list.insert(list.end(), begin, begin + n);
    }

    std::vector<char> list;
  };

  /** Takes them out again in the same order. */
  class Unpacker
  {
  public:
    explicit Unpacker(const std::vector<char> &bytes)
      : list(bytes)
    {
    }

    template <typename T>
    std::enable_if_t<std::is_trivially_copyable_v<T>>
    get(T &value)
    {
      take(&value, sizeof(T));
    }

    void
    get(std::string &text)
    {
      std::size_t n;
      get(n);
      text.resize(n);
      take(text.data(), n);
    }

    template <typename T>
    void
    get(std::vector<T> &values)
    {
      std::size_t n;
      get(n);
      values.resize(n);
      for (T &value : values)
        get(value);
    }

    template <typename Scalar, int rows, int columns, int options>
    void
    get(Eigen::Matrix<Scalar, rows, columns, options> &matrix)
    {
      Eigen::Index n, m;
      get(n);
      get(m);
      matrix.resize(n, m);
      take(matrix.data(), matrix.size() * sizeof(Scalar));
    }

    bool
    is_empty() const
    {
      return position == list.size();
    }

  private:
    void
    take(void *to, const std::size_t n)
    {
      if (n > 0)
        std::memcpy(to, &list.at(position + n - 1) - (n - 1), n);
      position += n;
    }

    const std::vector<char> &list;
    std::size_t              position = 0;
  };

  /** The bytes of every rank, on all ranks. Collective. */
  std::vector<std::vector<char>> gather_on_all(const MPI_Comm           comm,
                                               const std::vector<char> &own);
} // namespace squeal

#endif
