// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_row_file_h
#define squeal_base_row_file_h

#include <squeal/base/checksum.h>
#include <squeal/base/named_numbers.h>

#include <cstddef>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * Rows of numbers that are written to a file as they come, so that memory
   * does not grow with them, and that a run that was killed goes on from. What
   * memory() returns stands for the rows up to then, whatever follows them.
   * The file begins with the line "squeal <kind>" (see state_files.h). Every
   * failure throws InputError with the name of the file.
   */
  class RowFile
  {
  public:
    /** Of rows of @p n_columns numbers, still without a file. */
    RowFile(const std::string &path,
            const std::string &kind,
            const std::size_t  n_columns);
    ~RowFile();
    RowFile(const RowFile &)            = delete;
    RowFile &operator=(const RowFile &) = delete;

    /** Begins an empty file in the place of one of that name. */
    void start();

    /** Adds whole rows, one after the other in @p values. */
    void append(const std::vector<double> &values);

    std::size_t n_rows() const;

    /** @p n rows from row @p first on. */
    std::vector<double> read(const std::size_t first,
                             const std::size_t n) const;

    /** Number and checksum of the rows so far, which are on the disk then. */
    NamedNumbers memory();

    /** Goes on behind the rows that @p memory stands for; what follows them in
     * the file is dropped. Throws where the file is not there or has other
     * rows. */
    void restore(const NamedNumbers &memory);

    /** Closes the file and removes it. */
    void remove();

    const std::string &path() const;

  private:
    [[noreturn]] void fail(const std::string &what) const;
    void              open(const int flags);
    /** Hands what is buffered to the system. */
    void flush() const;
    /** The checksum of the first @p n_bytes of rows. */
    RunningChecksum checksum_of_rows(const std::size_t n_bytes) const;

    const std::string         name, head;
    const std::size_t         n_columns;
    int                       descriptor = -1;
    std::size_t               rows       = 0;
    RunningChecksum           checksum; /**< of all rows */
    mutable std::vector<char> buffer;   /**< rows not yet written */
  };
} // namespace squeal

#endif
