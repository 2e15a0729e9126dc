// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/text.h>

#include <squeal/scene/matrix_formats.h>

#include <algorithm>
#include <map>

namespace squeal
{
  namespace import
  {
    namespace
    {
      /**
       * One line of a bulk data file cut into its fields, whichever of the
       * three field formats it uses.
       */
      struct BulkLine
      {
        /** Name of the entry that starts here, in capitals; empty on a
         * continuation line. */
        std::string entry;
        /** Fields 2 to 9, or in large format the four of half an entry. */
        std::array<std::string_view, 8> data;
        unsigned int                    n_data = 8;
        /** What the fields look into. */
        std::string text;
      };

      /** Cuts off a comment and puts blanks for tabs. */
      std::string
      plain_text(const std::string_view line)
      {
        std::string text;
        for (const char c : line.substr(0, line.find('$')))
          if (c == '\t')
            text.resize(text.size() / 8 * 8 + 8, ' ');
          else
            text += c;
        return text;
      }

      void
      split_free_fields(const TextFile &file, BulkLine &line)
      {
        std::string_view rest   = line.text;
        std::string_view marker = rest.substr(0, rest.find(','));
        rest.remove_prefix(marker.size());
        marker      = trimmed(marker);
        line.n_data = marker.find('*') == std::string_view::npos ? 8 : 4;
        line.entry  = upper_case(marker);
        for (unsigned int i = 0; !rest.empty(); ++i)
          {
            rest.remove_prefix(1);
            const std::string_view field = rest.substr(0, rest.find(','));
            rest.remove_prefix(field.size());
            if (i < line.n_data)
              line.data[i] = trimmed(field);
            // One more is the mark that the continuation line repeats.
            else if (i > line.n_data)
              file.fail("too many fields; a free-field line has " +
                        std::to_string(line.n_data) + " after the first");
          }
      }

      void
      split_fixed_fields(BulkLine &line)
      {
        const std::string_view text  = line.text;
        const std::string_view first = text.substr(0, 8);
        line.n_data = first.find('*') == std::string_view::npos ? 8 : 4;
        line.entry  = upper_case(trimmed(first));
        const unsigned int width = 64 / line.n_data;
        for (unsigned int i = 0; i < line.n_data; ++i)
          if (8 + i * width < text.size())
            line.data[i] = trimmed(text.substr(8 + i * width, width));
      }

      /** Moves to the next line that is not empty; false at the end. */
      bool
      next_bulk_line(TextFile &file, BulkLine &line)
      {
        while (file.next())
          {
            line.text = plain_text(file.line());
            if (trimmed(line.text).empty())
              continue;
            line.data.fill({});
            if (line.text.find(',') != std::string::npos)
              split_free_fields(file, line);
            else
              split_fixed_fields(line);
            if (!line.entry.empty() && line.entry.back() == '*')
              line.entry.pop_back();
            if (!line.entry.empty() &&
                (line.entry[0] == '+' || line.entry[0] == '*'))
              line.entry.clear();
            return true;
          }
        return false;
      }

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
      read_label(const TextFile        &file,
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
          column     = read_label(file, line.data[1], line.data[2]);
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
          const DofLabel row   = read_label(file, field(0), field(1));
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
