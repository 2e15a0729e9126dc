// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/text.h>

#include <squeal/scene/bulk_data.h>
#include <squeal/scene/matrix_formats.h>

#include <algorithm>
#include <map>

namespace squeal
{
  namespace import
  {
    namespace
    {
      /** The header entry of a DMIG matrix. */
      struct Header
      {
        long         form = 0, type = 0;
        unsigned int line = 0;
      };

      using Headers = std::map<std::string, Header>;

      Headers
      read_headers(TextFile &file)
      {
        Headers  headers;
        BulkLine line;
        file.rewind();
        while (next_bulk_line(file, line))
          {
            if (line.entry != "DMIG" || line.data[1] != "0")
              continue;
            Header header;
            header.form =
              integer_field(file, line.data[2], "form of the matrix");
            header.type =
              integer_field(file, line.data[3], "type of the matrix");
            header.line            = file.line_number();
            const std::string name = upper_case(line.data[0]);
            if (!headers.emplace(name, header).second)
              file.fail("DMIG " + name + " has a second header entry");
          }
        return headers;
      }

      std::string
      names_of(const Headers &headers)
      {
        std::string names;
        for (const auto &header : headers)
          names += (names.empty() ? "" : ", ") + header.first;
        return names;
      }

      /** The matrix asked for: by name, or the only square one. */
      Headers::const_iterator
      choose(const TextFile    &file,
             const Headers     &headers,
             const std::string &name)
      {
        if (headers.empty())
          throw InputError(file.name() + ": no DMIG header entry");
        if (!name.empty())
          {
            const auto found = headers.find(upper_case(name));
            if (found == headers.end())
              throw InputError(file.name() + ": no DMIG matrix " +
                               prm::in_quotes(name) + "; there are " +
                               names_of(headers));
            return found;
          }
        const auto is_square = [](const auto &header) {
          return header.second.form == 1 || header.second.form == 6;
        };
        if (std::count_if(headers.begin(), headers.end(), is_square) != 1)
          throw InputError(file.name() +
                           ": say with 'Matrix name' which of the DMIG "
                           "matrices " +
                           names_of(headers) + " to take");
        return std::find_if(headers.begin(), headers.end(), is_square);
      }

      void
      check_header(const TextFile    &file,
                   const std::string &name,
                   const Header      &header)
      {
        if (header.form != 1 && header.form != 6)
          file.fail_at(header.line,
                       "DMIG " + name + " has form " +
                         std::to_string(header.form) +
                         "; a square (1) or symmetric (6) one is needed");
        if (header.type != 1 && header.type != 2)
          file.fail_at(header.line,
                       "DMIG " + name + " has type " +
                         std::to_string(header.type) +
                         "; a real one (1 or 2) is needed");
      }

      DofLabel
      read_point_label(const TextFile        &file,
                       const std::string_view point,
                       const std::string_view component)
      {
        DofLabel label;
        label.node = integer_field(file, point, "grid point");
        if (label.node < 1)
          file.fail("grid point " + std::to_string(label.node) +
                    " does not exist");
        const long number =
          component.empty() ? 0 : integer_field(file, component, "component");
        if (number < 0 || number > 6)
          file.fail("component " + std::to_string(number) +
                    " does not exist; it is 1 to 6, or 0 for a scalar point");
        label.component = static_cast<unsigned int>(number);
        return label;
      }

      /** Reads the column entries of one matrix. */
      class ColumnReader
      {
      public:
        ColumnReader(TextFile &file, const std::string &name)
          : file(file)
          , name(name)
        {
        }

        RawMatrix
        read()
        {
          BulkLine line;
          file.rewind();
          while (next_bulk_line(file, line))
            {
              if (!line.entry.empty())
                start_entry(line);
              if (is_in_column)
                // An entry is a sequence of groups of four fields; the first
                // one names the column, each other one is a term.
                for (unsigned int i = line.entry.empty() ? 0 : 4;
                     i < line.n_data;
                     i += 4)
                  read_term(line, i);
            }
          end_entry();
          if (matrix.entries.empty())
            file.fail("DMIG " + name + " has no terms");
          return std::move(matrix);
        }

      private:
        TextFile          &file;
        const std::string &name;
        RawMatrix          matrix;
        DofLabel           column;
        bool               is_in_column = false;
        unsigned int       first_line = 0, n_terms = 0;

        void
        start_entry(const BulkLine &line)
        {
          end_entry();
          is_in_column = line.entry == "DMIG" && line.data[1] != "0" &&
                         upper_case(line.data[0]) == name;
          if (!is_in_column)
            return;
          column     = read_point_label(file, line.data[1], line.data[2]);
          first_line = file.line_number();
          n_terms    = 0;
          if (!line.data[3].empty())
            file.fail("field 5 of a DMIG column entry must be blank");
        }

        void
        end_entry() const
        {
          if (is_in_column && n_terms == 0)
            file.fail_at(first_line,
                         "this column of DMIG " + name + " has no terms");
        }

        void
        read_term(const BulkLine &line, const unsigned int i)
        {
          const auto field = [&](const unsigned int k) {
            return line.data[i + k];
          };
          if (field(0).empty() && field(1).empty() && field(2).empty() &&
              field(3).empty())
            return;
          const DofLabel row   = read_point_label(file, field(0), field(1));
          const double   value = real_field(file, field(2), "matrix term");
          if (!field(3).empty() &&
              real_field(file, field(3), "imaginary part") != 0.)
            file.fail("the term has an imaginary part in a real matrix");
          matrix.add(row, column, value, file.line_number());
          ++n_terms;
        }
      };
    } // namespace



    RawMatrix
    read_nastran_matrix(TextFile &file, const std::string &name)
    {
      file.check_last_line_is_complete();
      const Headers headers = read_headers(file);
      const auto    chosen  = choose(file, headers, name);
      check_header(file, chosen->first, chosen->second);
      RawMatrix matrix = ColumnReader(file, chosen->first).read();
      matrix.storage = chosen->second.form == 6 ? RawMatrix::Storage::symmetric
                                                : RawMatrix::Storage::general;
      return matrix;
    }
  } // namespace import
} // namespace squeal
