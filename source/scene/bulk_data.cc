// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/scene/bulk_data.h>

namespace squeal
{
  namespace import
  {
    namespace
    {
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

      /** A mark without the sign in front. */
      std::string
      mark_of(std::string_view text)
      {
        text = trimmed(text);
        if (!text.empty() && (text[0] == '+' || text[0] == '*'))
          text.remove_prefix(1);
        return upper_case(text);
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
            else if (i == line.n_data)
              line.mark_behind = mark_of(field);
            else
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
        if (text.size() > 72)
          line.mark_behind = mark_of(text.substr(72, 8));
      }
    } // namespace



    bool
    next_bulk_line(TextFile &file, BulkLine &line)
    {
      while (file.next())
        {
          line.text = plain_text(file.line());
          line.mark_in_front.clear();
          line.mark_behind.clear();
          if (trimmed(line.text).empty())
            continue;
          line.data.fill({});
          if (line.text.find(',') != std::string::npos)
            split_free_fields(file, line);
          else
            split_fixed_fields(line);
          if (!line.entry.empty() && line.entry[0] == '=')
            file.fail("replication ('=' in the first field) is not read: write "
                      "the entries out");
          if (!line.entry.empty() && line.entry.back() == '*')
            line.entry.pop_back();
          if (!line.entry.empty() &&
              (line.entry[0] == '+' || line.entry[0] == '*'))
            {
              line.mark_in_front = line.entry.substr(1);
              line.entry.clear();
            }
          return true;
        }
      return false;
    }



    const std::string &
    BulkEntry::field(const std::size_t i) const
    {
      static const std::string none;
      return i < fields.size() ? fields[i] : none;
    }



    BulkEntries::BulkEntries(TextFile &file)
      : file(file)
    {
    }

    bool
    BulkEntries::has_end() const
    {
      return ended;
    }

    bool
    BulkEntries::next(BulkEntry &entry)
    {
      if (ended || (!is_ahead && !next_bulk_line(file, line)))
        return false;
      is_ahead = false;
      if (line.entry.empty())
        file.fail("a continuation line continues nothing");
      if (line.entry == "ENDDATA")
        {
          ended = true;
          return false;
        }
      entry.name = line.entry;
      entry.line = file.line_number();
      entry.fields.clear();
      n_halves = 0;
      append(entry);
      while (next_bulk_line(file, line))
        {
          if (!line.entry.empty())
            {
              is_ahead = true;
              break;
            }
          if (!line.mark_in_front.empty() && !mark.empty() &&
              line.mark_in_front != mark)
            file.fail("the continuation mark '" + line.mark_in_front +
                      "' is not that of the line before, '" + mark +
                      "': sort the lines");
          append(entry);
        }
      return true;
    }

    void
    BulkEntries::append(BulkEntry &entry)
    {
      // Two lines of four wide fields are one of eight; a line of eight begins
      // anew behind an odd number of them.
      if (line.n_data == 8 && n_halves % 2 == 1)
        {
          entry.fields.resize(entry.fields.size() + 4);
          n_halves = 0;
        }
      if (line.n_data == 4)
        ++n_halves;
      for (unsigned int i = 0; i < line.n_data; ++i)
        entry.fields.emplace_back(line.data[i]);
      mark = line.mark_behind;
    }
  } // namespace import
} // namespace squeal
