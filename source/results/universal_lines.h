// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_universal_lines_h
#define squeal_results_universal_lines_h

#include <squeal/base/exceptions.h>
#include <squeal/base/inputs_read.h>
#include <squeal/parameters/text.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace squeal
{
  /** Lines of a universal file, with fields in fixed columns. */
  class UniversalLines
  {
  public:
    explicit UniversalLines(const std::string &path)
      : path(path)
    {
      std::istringstream in(read_input_file(path));
      for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    }

    bool
    at_end() const
    {
      return next == lines.size();
    }

    const std::string &
    take(const std::string &what)
    {
      if (at_end())
        fail("ends where " + what + " should be");
      return lines[next++];
    }

    bool
    is_mark() const
    {
      return !at_end() && prm::trim(lines[next]) == "-1";
    }

    [[noreturn]] void
    fail(const std::string &what) const
    {
      throw InputError(path + ":" + std::to_string(next) + ": " + what);
    }

    /** @p n numbers in fields of @p width, @p n_in_line in a line. */
    std::vector<double>
    numbers(const unsigned int n,
            const unsigned int width,
            const unsigned int n_in_line,
            const std::string &what)
    {
      std::vector<double> result;
      std::string         line;
      for (unsigned int i = 0; i < n; ++i)
        {
          if (i % n_in_line == 0)
            line = take(what);
          result.push_back(number(line, (i % n_in_line) * width, width, what));
        }
      return result;
    }

    /** Numbers of one line in fields of the given widths. */
    std::vector<double>
    fields(const std::vector<unsigned int> &widths, const std::string &what)
    {
      const std::string  &line = take(what);
      std::vector<double> result;
      std::size_t         at = 0;
      for (const unsigned int width : widths)
        {
          result.push_back(number(line, at, width, what));
          at += width;
        }
      return result;
    }

    std::vector<int>
    integers(const unsigned int n, const std::string &what)
    {
      std::vector<int> result;
      for (const double value : numbers(n, 10, 8, what))
        {
          if (value != std::floor(value) || std::abs(value) > 2e9)
            fail("a number of " + what + " is not whole");
          result.push_back(static_cast<int>(value));
        }
      return result;
    }

  private:
    double
    number(const std::string &line,
           const std::size_t  at,
           const unsigned int width,
           const std::string &what) const
    {
      std::string field =
        at < line.size() ? prm::trim(line.substr(at, width)) : "";
      for (char &c : field)
        if (c == 'D' || c == 'd')
          c = 'E';
      char        *end   = nullptr;
      const double value = std::strtod(field.c_str(), &end);
      if (field.empty() || *end != '\0' || !std::isfinite(value))
        fail("'" + field + "' is no number of " + what + " (columns " +
             std::to_string(at + 1) + " to " + std::to_string(at + width) +
             ")");
      return value;
    }

    const std::string        path;
    std::vector<std::string> lines;
    std::size_t              next = 0;
  };
} // namespace squeal

#endif
