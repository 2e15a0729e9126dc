// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/text.h>

#include <squeal/scene/matrix_formats.h>

#include <algorithm>


namespace squeal
{
  namespace import
  {
    void
    RawMatrix::add(const unsigned int row,
                   const unsigned int column,
                   const double       value,
                   const unsigned int line)
    {
      entries.push_back({row, column, line, value});
      n = std::max({n, row + 1, column + 1});
    }



    void
    RawMatrix::add(const DofLabel    &row,
                   const DofLabel    &column,
                   const double       value,
                   const unsigned int line)
    {
      const unsigned int i = index(row);
      const unsigned int j = index(column);
      add(i, j, value, line);
    }



    unsigned int
    RawMatrix::index(const DofLabel &label)
    {
      const auto [place, is_new] = index_of.try_emplace(label, labels.size());
      if (is_new)
        labels.push_back(label);
      return place->second;
    }



    namespace
    {
      /** The third line of a Harwell-Boeing file starts with three letters:
       * real, complex or pattern; kind of symmetry; assembled or elements. */
      bool
      is_harwell_boeing_type(const std::string &line)
      {
        const auto among = [&](const std::size_t i, const char *letters) {
          return std::string(letters).find(line[i]) != std::string::npos;
        };
        return line.size() > 3 && among(0, "RCP") && among(1, "SUHZR") &&
               among(2, "AE") && among(3, " \t");
      }

      bool
      starts_like_a_number(const std::string_view text)
      {
        return !text.empty() &&
               std::string("0123456789+-.").find(text[0]) != std::string::npos;
      }

      bool
      is_abaqus_entry(const std::string &line)
      {
        const Fields fields = split_at_blanks_and_commas(line);
        return prm::starts_with(line, "*MATRIX INPUT") ||
               (starts_like_a_number(line) && (fields.n == 3 || fields.n == 5));
      }
    } // namespace



    MatrixPartParameters::Format
    detect_format(TextFile &file)
    {
      using Format        = MatrixPartParameters::Format;
      Format found        = Format::automatic;
      bool   is_first     = true;
      bool   is_undecided = true;
      file.rewind();
      // Abaqus' files show on their first entry, but the second line of a
      // Harwell-Boeing file looks alike; a DMIG may stand anywhere.
      while (is_undecided && file.next())
        {
          const std::string line = upper_case(trimmed(file.line()));
          if (file.line_number() == 1 &&
              prm::starts_with(line, "%%MATRIXMARKET"))
            {
              found = Format::matrix_market;
              break;
            }
          if (file.line_number() == 3 && is_harwell_boeing_type(line))
            file.fail("this is a Harwell-Boeing file; write MatrixMarket "
                      "instead (Ansys: *EXPORT,name,MMF,file)");
          if (prm::starts_with(line, "DMIG"))
            {
              found    = Format::nastran;
              is_first = false;
            }
          else if (is_first && !line.empty() && !prm::starts_with(line, "**"))
            {
              is_first = false;
              if (is_abaqus_entry(line))
                found = Format::abaqus;
            }
          is_undecided = found == Format::automatic || file.line_number() < 3;
        }
      file.rewind();
      if (found == Format::automatic)
        throw InputError(file.name() +
                         " is no matrix in MatrixMarket, Abaqus or Nastran "
                         "DMIG format (doc/import.md)");
      return found;
    }
  } // namespace import
} // namespace squeal
