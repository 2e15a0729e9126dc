// SPDX-License-Identifier: LGPL-2.1-or-later
#include "abaqus_keywords.h"
#include "abaqus_reader.h"

#include <squeal/parameters/text.h>

#include <algorithm>

// Lines, keywords and data of an Abaqus input file.

namespace squeal
{
  using import::upper_case;

  /** Moves to the next line that is neither blank nor a comment. */
  bool
  AbaqusReader::next_line()
  {
    if (is_held)
      {
        is_held = false;
        return true;
      }
    while (text.next())
      {
        const auto line = import::trimmed(text.line());
        if (!line.empty() && line.substr(0, 2) != "**")
          return true;
      }
    return false;
  }

  void
  AbaqusReader::add_options(const std::string &line)
  {
    const auto plain = [](std::string t) {
      t = std::string(import::trimmed(t));
      if (t.size() > 1 && t.front() == '"' && t.back() == '"')
        t = t.substr(1, t.size() - 2);
      return t;
    };
    for (const std::string &part : prm::split(line, ','))
      {
        const auto equals = part.find('=');
        const auto key =
          abaqus::without_blanks(upper_case(plain(part.substr(0, equals))));
        if (!key.empty())
          keyword.options[key] =
            equals == std::string::npos ? "" : plain(part.substr(equals + 1));
      }
  }

  bool
  AbaqusReader::next_keyword()
  {
    while (next_line())
      {
        std::string line(import::trimmed(text.line()));
        if (line[0] != '*')
          continue; // data of a keyword that is not read
        keyword            = {};
        keyword.line       = text.line_number();
        const auto   comma = std::min(line.find(','), line.size());
        std::string &name  = keyword.name;
        for (const char c : upper_case(line.substr(1, comma - 1)))
          if (c != ' ' || (!name.empty() && name.back() != ' '))
            name += c;
        while (!name.empty() && name.back() == ' ')
          name.pop_back();
        const std::vector<std::string> full = abaqus::full_keywords(name);
        if (full.size() > 1)
          text.fail_at(keyword.line,
                       "*" + name + " may be short for *" +
                         prm::join(full, ", *") + ": spell it out");
        if (!full.empty())
          name = full[0];
        std::string options = line.substr(comma);
        while (!options.empty() && line.back() == ',' && next_line())
          {
            line = import::trimmed(text.line());
            options += line;
          }
        add_options(options);
        return true;
      }
    return false;
  }

  bool
  AbaqusReader::next_data()
  {
    if (!next_line())
      return false;
    const auto line = import::trimmed(text.line());
    if (line[0] == '*')
      {
        is_held = true;
        return false;
      }
    fields.clear();
    ends_with_comma = line.back() == ',';
    for (std::size_t begin = 0; begin <= line.size();)
      {
        const auto end = std::min(line.find(',', begin), line.size());
        fields.emplace_back(import::trimmed(line.substr(begin, end - begin)));
        begin = end + 1;
      }
    if (ends_with_comma)
      fields.pop_back();
    return true;
  }



  /** The one that is spelled out, else one that is short for it. */
  const std::string *
  AbaqusReader::find_option(const char *key) const
  {
    if (const auto it = keyword.options.find(key); it != keyword.options.end())
      return &it->second;
    for (const auto &[written, value] : keyword.options)
      if (abaqus::may_stand_for(written, key))
        return &value;
    return nullptr;
  }

  bool
  AbaqusReader::has_option(const char *key) const
  {
    return find_option(key) != nullptr;
  }

  std::string
  AbaqusReader::option(const char *key) const
  {
    const std::string *value = find_option(key);
    return value == nullptr ? "" : *value;
  }

  std::string
  AbaqusReader::needed(const char *key) const
  {
    const std::string value = option(key);
    if (value.empty())
      text.fail_at(keyword.line, "*" + keyword.name + " needs " + key + "=...");
    return value;
  }

  std::string
  AbaqusReader::data(const std::size_t i) const
  {
    return i < fields.size() ? fields[i] : "";
  }

  long
  AbaqusReader::integer(const std::size_t i, const char *what) const
  {
    return import::integer_field(text, data(i), what);
  }

  double
  AbaqusReader::real(const std::size_t i, const char *what) const
  {
    return data(i).empty() ? 0. : import::real_field(text, data(i), what);
  }
} // namespace squeal
