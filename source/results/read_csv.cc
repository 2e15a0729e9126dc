// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/inputs_read.h>
#include <squeal/parameters/text.h>
#include <squeal/results/csv_dialect.h>
#include <squeal/results/table.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    /** The cells of one line of a CSV file and where it starts. */
    struct Record
    {
      std::size_t              line;
      std::vector<std::string> cells;
    };

    [[noreturn]] void
    fail(const std::string &path,
         const std::size_t  line,
         const std::string &text)
    {
      throw InputError(path + ":" + std::to_string(line) + ": " + text);
    }

    std::optional<long long>
    as_integer(const std::string &text)
    {
      long long  value = 0;
      const auto result =
        std::from_chars(text.data(), text.data() + text.size(), value);
      // "-0" is a real number whose sign an integer would lose
      if (result.ec != std::errc() || result.ptr != text.data() + text.size() ||
          (value == 0 && text.front() == '-'))
        return {};
      return value;
    }

    /** Also NaN, which the caller refuses by name. */
    std::optional<double>
    as_real(const std::string &text)
    {
      double            value = 0.;
      const std::size_t skip  = !text.empty() && text.front() == '+' ? 1 : 0;
      const auto        result =
        std::from_chars(text.data() + skip, text.data() + text.size(), value);
      if (text.size() == skip || result.ec != std::errc() ||
          result.ptr != text.data() + text.size())
        return {};
      return value;
    }

    /** Cuts the content of a file into records; blank lines are none. */
    std::vector<Record>
    split(const std::string &path,
          const std::string &content,
          CsvDialect        &dialect)
    {
      std::vector<Record> records;
      std::size_t         line = 1, i = 0;
      while (i < content.size())
        {
          Record      record{line, {}};
          std::string cell;
          bool        was_quoted = false;
          bool        inside     = false;
          bool        has_text   = false;
          const auto  finish     = [&]() {
            record.cells.push_back(
              was_quoted
                ? cell
                : dialect.number(prm::trim(cell),
                                 path + ":" + std::to_string(record.line)));
            cell.clear();
            was_quoted = false;
          };
          for (; i < content.size() && (inside || content[i] != '\n'); ++i)
            {
              const char c = content[i];
              has_text     = has_text || !std::isspace(c);
              line += c == '\n';
              if (inside && c == '"' && content.compare(i, 2, "\"\"") == 0)
                cell += content[i++];
              else if (inside && c == '"')
                inside = false;
              else if (inside)
                cell += c;
              else if (c == '"' && prm::trim(cell).empty())
                {
                  inside = was_quoted = true;
                  cell.clear();
                }
              else if (c == dialect.separator())
                finish();
              else if (c == '\r' && i + 1 < content.size() &&
                       content[i + 1] != '\n')
                fail(path, line, "a carriage return within the line");
              else if (c != '\r' && !was_quoted)
                cell += c;
            }
          if (inside)
            fail(path, record.line, "a quote is opened and not closed");
          finish();
          if (has_text)
            records.push_back(std::move(record));
          ++i;
          ++line;
        }
      return records;
    }

    /** Narrowest type of all cells of column @p c. */
    Type
    deduced_type(const std::vector<Record> &records, const std::size_t c)
    {
      bool all_integer = true, all_real = true, any = false;
      for (std::size_t r = 1; r < records.size(); ++r)
        {
          const std::string &text = records[r].cells[c];
          if (text.empty())
            continue;
          any         = true;
          all_real    = all_real && as_real(text).has_value();
          all_integer = all_integer && as_integer(text).has_value();
        }
      if (!any || !all_real)
        return any ? Type::text : Type::real;
      return all_integer ? Type::integer : Type::real;
    }

    Cell
    read_cell(const std::string   &path,
              const std::size_t    line,
              const Table::Column &column,
              const std::string   &text)
    {
      if (text.empty())
        return {};
      if (column.type == Type::text)
        return text;
      if (column.type == Type::integer)
        if (const auto value = as_integer(text))
          return *value;
      const auto value = as_real(text);
      if (!value || std::isnan(*value) || column.type == Type::integer)
        fail(path,
             line,
             "column '" + column.name + "': " + prm::in_quotes(text) +
               " is not " +
               (column.type == Type::integer ? "an integer" : "a number"));
      // What was written as infinite reads back.
      return unbounded(*value);
    }

    std::vector<Table::Column>
    read_header(const std::string                &path,
                const std::vector<Record>        &records,
                const std::vector<Table::Column> &required)
    {
      const Record              &header = records.front();
      std::vector<Table::Column> columns;
      std::string                names;
      for (std::size_t c = 0; c < header.cells.size(); ++c)
        {
          Table::Column column;
          column.name = header.cells[c];
          if (column.name.empty())
            fail(path,
                 header.line,
                 "column " + std::to_string(c + 1) + " has no name");
          // it is shown in messages and titles
          if (column.name.find_first_of("\r\n") != std::string::npos)
            fail(path,
                 header.line,
                 "the name of column " + std::to_string(c + 1) +
                   " has more than one line");
          for (const Table::Column &earlier : columns)
            if (earlier.name == column.name)
              fail(path, header.line, "two columns '" + column.name + "'");
          names += (c == 0 ? "" : ", ") + column.name;
          columns.push_back(column);
        }
      for (const Table::Column &asked : required)
        if (std::none_of(columns.begin(), columns.end(), [&](const auto &c) {
              return c.name == asked.name;
            }))
          fail(path,
               header.line,
               "the column '" + asked.name +
                 "' is missing; the columns are: " + names);
      return columns;
    }
  } // namespace



  Table
  read_csv(const std::string &path, const std::vector<Table::Column> &required)
  {
    std::string content = without_byte_order_mark(read_input_file(path), path);
    // Line ends of old, which some spreadsheets still write.
    if (content.find('\n') == std::string::npos)
      std::replace(content.begin(), content.end(), '\r', '\n');
    const auto is_binary = [](const char c) {
      return static_cast<unsigned char>(c) < 32 && !std::isspace(c);
    };
    const auto bad = std::find_if(content.begin(), content.end(), is_binary);
    if (bad != content.end())
      fail(path,
           1 + std::count(content.begin(), bad, '\n'),
           "bytes that are no text: not a CSV file");

    const std::size_t header =
      std::min(content.find_first_not_of(" \r\n\t"), content.size());
    CsvDialect dialect(
      content.substr(header, content.find('\n', header) - header));
    const std::vector<Record> records = split(path, content, dialect);
    if (records.empty())
      throw InputError("'" + path +
                       "' is empty: a CSV file with a header row "
                       "is expected");

    std::vector<Table::Column> columns = read_header(path, records, required);
    for (const Record &record : records)
      if (record.cells.size() != columns.size())
        fail(path,
             record.line,
             std::to_string(record.cells.size()) +
               " cells where the header "
               "names " +
               std::to_string(columns.size()) +
               dialect.hint(record.cells.size(), columns.size()));

    for (std::size_t c = 0; c < columns.size(); ++c)
      {
        columns[c].type = deduced_type(records, c);
        for (const Table::Column &asked : required)
          if (asked.name == columns[c].name)
            columns[c] = asked;
      }

    Table table(columns);
    for (std::size_t r = 1; r < records.size(); ++r)
      {
        std::vector<Cell> row;
        for (std::size_t c = 0; c < columns.size(); ++c)
          row.push_back(
            read_cell(path, records[r].line, columns[c], records[r].cells[c]));
        table.add_row(std::move(row));
      }
    return table;
  }
} // namespace squeal
