// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/text.h>

#include <squeal/scene/matrix_formats.h>

namespace squeal
{
  namespace import
  {
    namespace
    {
      RawMatrix::Storage
      read_banner(TextFile &file)
      {
        if (!file.next())
          file.fail("the file is empty");
        const std::string banner = upper_case(file.line());
        const Fields      words  = split_at_blanks_and_commas(banner);
        if (words.n < 5 || words[0] != "%%MATRIXMARKET" || words[1] != "MATRIX")
          file.fail("the first line must read "
                    "'%%MatrixMarket matrix coordinate real general' (or "
                    "symmetric, skew-symmetric)");
        if (words[2] != "COORDINATE")
          file.fail("a dense ('array') matrix cannot be read; write a sparse "
                    "one ('coordinate')");
        if (words[3] != "REAL" && words[3] != "DOUBLE" && words[3] != "INTEGER")
          file.fail("a matrix of kind " +
                    prm::in_quotes(std::string(words[3])) +
                    " cannot be read; write a real one");
        if (words[4] == "GENERAL")
          return RawMatrix::Storage::general;
        if (words[4] == "SYMMETRIC")
          return RawMatrix::Storage::symmetric;
        if (words[4] == "SKEW-SYMMETRIC")
          return RawMatrix::Storage::skew;
        file.fail("symmetry " + prm::in_quotes(std::string(words[4])) +
                  " is not known; write general, symmetric or skew-symmetric");
      }

      /** Moves to the next line that is neither blank nor a comment; sees the
       * mark of damping on the way. */
      bool
      next_data_line(TextFile &file, RawMatrix &matrix)
      {
        while (file.next())
          {
            const std::string_view line = trimmed(file.line());
            if (line.empty())
              continue;
            if (line[0] != '%')
              return true;
            if (trimmed(line.substr(1)) == damping_mark)
              matrix.is_damping = true;
          }
        return false;
      }

      unsigned int
      read_index(const TextFile        &file,
                 const std::string_view text,
                 const char            *what,
                 const unsigned int     n)
      {
        const long index = integer_field(file, text, what);
        if (index < 1 || index > static_cast<long>(n))
          file.fail(std::string(what) + " " + std::to_string(index) +
                    " is outside 1 to " + std::to_string(n));
        return static_cast<unsigned int>(index - 1);
      }
    } // namespace



    RawMatrix
    read_matrix_market(TextFile &file)
    {
      RawMatrix matrix;
      matrix.storage       = read_banner(file);
      matrix.size_is_given = true;

      if (!next_data_line(file, matrix))
        file.fail("the line with the numbers of rows, columns and entries is "
                  "missing");
      const Fields size = split_at_blanks_and_commas(file.line());
      if (size.n != 3)
        file.fail("this line must give the numbers of rows, columns and "
                  "entries");
      const long n_rows    = integer_field(file, size[0], "number of rows");
      const long n_columns = integer_field(file, size[1], "number of columns");
      const long n_entries = integer_field(file, size[2], "number of entries");
      const long largest   = 1000000000;
      if (n_rows < 1 || n_rows > largest || n_entries < 0)
        file.fail("numbers of rows and entries must be positive");
      if (n_rows != n_columns)
        file.fail("the matrix has " + std::to_string(n_rows) + " rows and " +
                  std::to_string(n_columns) + " columns; it must be square");

      const unsigned int n = static_cast<unsigned int>(n_rows);
      while (next_data_line(file, matrix))
        {
          if (static_cast<long>(matrix.entries.size()) == n_entries)
            file.fail("more entries than the " + std::to_string(n_entries) +
                      " announced");
          const Fields entry = split_at_blanks_and_commas(file.line());
          if (entry.n != 3)
            file.fail("an entry has row, column and value");
          const unsigned int row    = read_index(file, entry[0], "row", n);
          const unsigned int column = read_index(file, entry[1], "column", n);
          matrix.add(row,
                     column,
                     real_field(file, entry[2], "value"),
                     file.line_number());
        }
      if (static_cast<long>(matrix.entries.size()) != n_entries)
        file.fail("the file ends after " +
                  std::to_string(matrix.entries.size()) + " of " +
                  std::to_string(n_entries) + " entries: it is truncated");
      // the last number may have lost digits
      file.check_last_line_is_complete();
      matrix.n = n;
      return matrix;
    }
  } // namespace import
} // namespace squeal
