// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_hdf5_file_h
#define squeal_results_hdf5_file_h

#include <cstdint>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * An HDF5 file with what squeal keeps in one: arrays of numbers, some of
   * which grow along their first dimension, texts, and attributes of the root.
   * Any failure throws InputError with the file's name.
   *
   * Groups of a dataset's path ("nodes/area") are made when needed.
   */
  class Hdf5File
  {
  public:
    using Dimensions = std::vector<std::uint64_t>;

    enum class Mode
    {
      create,
      create_sealed, /**< to be sealed when it is closed: see sealed_file.h */
      read
    };

    /** How numbers are kept in the file; memory has double or uint8_t. */
    enum class Kind
    {
      real64,
      real32,
      integer32,
      integer8
    };

    Hdf5File(const std::string &path, Mode mode);
    ~Hdf5File();
    Hdf5File(const Hdf5File &)            = delete;
    Hdf5File &operator=(const Hdf5File &) = delete;

    /** Writes all data to the file and closes it; after that only destruction
     * is allowed. */
    void close();

    /** @name Attributes of the root */
    //@{
    void   write_attribute(const std::string &name, double value);
    void   write_attribute(const std::string &name, const std::string &text);
    bool   has_attribute(const std::string &name) const;
    double number_attribute(const std::string &name) const;
    std::string text_attribute(const std::string &name) const;
    //@}

    /** @name Datasets */
    //@{
    /** Writes a whole dataset. */
    void write(const std::string         &name,
               const Dimensions          &dimensions,
               const std::vector<double> &values,
               Kind                       kind = Kind::real64);

    /** Texts, one a row. */
    void write(const std::string &name, const std::vector<std::string> &texts);

    /** An empty dataset that grows; @p row are the dimensions of one row, and
     * @p n_chunk rows are stored together. */
    void create_growing(const std::string &name,
                        const Dimensions  &row,
                        Kind               kind,
                        std::uint64_t      n_chunk);

    /** Adds rows to it; the number of values is a multiple of the row's. */
    void append(const std::string &name, const std::vector<double> &values);

    bool has(const std::string &name) const;

    Dimensions dimensions(const std::string &name) const;

    /** Rows @p first to @p first + @p n of a dataset of numbers. */
    void read_rows(const std::string   &name,
                   std::uint64_t        first,
                   std::uint64_t        n,
                   std::vector<double> &values) const;

    std::vector<double> read(const std::string &name) const;

    std::vector<std::string> read_texts(const std::string &name) const;
    //@}

    const std::string &path() const;

  private:
    [[noreturn]] void fail(const std::string &what) const;
    /** Number of values of @p bytes each; fails where they take more than the
     * available memory, as what a damaged file says of its extent may. */
    std::uint64_t size_to_read(const std::string &name,
                               const Dimensions  &extent,
                               const std::size_t  bytes) const;

    std::string  file_name;
    std::int64_t id = -1;
  };
} // namespace squeal

#endif
