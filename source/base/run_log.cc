// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace squeal
{
  namespace
  {
    constexpr std::size_t columns_of_a_line = 80;

    constexpr double seconds_before_progress = 5.;
    constexpr double seconds_between_lines   = 10.;
    constexpr double seconds_between_updates = 0.25;
    constexpr double seconds_before_estimate = 1.;

    std::string
    padded(const std::string &text, const std::size_t width, const bool left)
    {
      const std::size_t used = display_width(text);
      const std::string blanks(width > used ? width - used : 0, ' ');
      return left ? text + blanks : blanks + text;
    }

    /** Columns of these widths that stand beside each other within a line, the
     * first one in each block. */
    std::vector<std::vector<std::size_t>>
    blocks_of(const std::vector<std::size_t> &width, const std::size_t indent)
    {
      std::vector<std::vector<std::size_t>> blocks(1);
      std::size_t                           used = indent;
      for (std::size_t c = 0; c < width.size(); ++c)
        {
          if (blocks.back().size() > 1 && used + width[c] > columns_of_a_line)
            {
              blocks.push_back({0});
              used = indent + width[0] + 2;
            }
          blocks.back().push_back(c);
          used += width[c] + 2;
        }
      return blocks;
    }

    std::string
    without_trailing_blanks(std::string line)
    {
      line.erase(line.find_last_not_of(' ') + 1);
      return line;
    }
  } // namespace



  std::size_t
  display_width(const std::string &text)
  {
    // continuation bytes of UTF-8 take no column
    return std::count_if(text.begin(), text.end(), [](const char c) {
      return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    });
  }



  std::string
  format_duration(const double seconds)
  {
    char text[64];
    if (!(seconds < 1e9))
      return "unknown";
    const long whole = std::lround(std::max(0., seconds));
    if (seconds < 9.95)
      std::snprintf(text,
                    sizeof(text),
                    seconds < 1. ? "%.2f s" : "%.1f s",
                    std::max(0., seconds));
    else if (whole < 60)
      std::snprintf(text, sizeof(text), "%ld s", whole);
    else if (whole < 3600)
      std::snprintf(
        text, sizeof(text), "%ld min %02ld s", whole / 60, whole % 60);
    else
      std::snprintf(
        text, sizeof(text), "%ld h %02ld min", whole / 3600, whole / 60 % 60);
    return text;
  }



  void
  print_aligned(std::ostream                                &out,
                const std::vector<std::vector<std::string>> &rows,
                const std::vector<bool>                     &left,
                const std::string                           &indent)
  {
    std::vector<std::size_t> width;
    for (const auto &row : rows)
      {
        width.resize(std::max(width.size(), row.size()), 0);
        for (std::size_t c = 0; c < row.size(); ++c)
          width[c] = std::max(width[c], display_width(row[c]));
      }
    bool is_first = true;
    for (const auto &columns : blocks_of(width, indent.size()))
      {
        std::size_t total = 0;
        for (const std::size_t c : columns)
          total += width[c] + 2;
        out << (is_first ? "" : "\n");
        is_first = false;
        for (std::size_t r = 0; r < rows.size(); ++r)
          {
            std::string line = indent;
            for (const std::size_t c : columns)
              if (c < rows[r].size())
                line +=
                  (c == 0 ? "" : "  ") +
                  padded(rows[r][c], width[c], c < left.size() && left[c]);
            out << without_trailing_blanks(line) << '\n';
            if (r == 0)
              out << indent << std::string(total > 2 ? total - 2 : 0, '-')
                  << '\n';
          }
      }
  }



  std::string
  wrapped(const std::string &text, const std::size_t width)
  {
    std::istringstream lines(text);
    std::string        result;
    for (std::string line; std::getline(lines, line);)
      {
        std::string indent;
        while (display_width(line) > width)
          {
            const std::size_t first = line.find_first_not_of(' ');
            std::size_t       cut = std::string::npos, column = 0;
            for (std::size_t i = 0; i < line.size(); ++i)
              {
                if (i > first && line[i] == ' ' &&
                    (column <= width || cut == std::string::npos))
                  cut = i;
                column += display_width(line.substr(i, 1));
              }
            if (cut == std::string::npos)
              break;
            if (indent.empty())
              indent = std::string(first + 2, ' ');
            const std::size_t next = line.find_first_not_of(' ', cut);
            result += without_trailing_blanks(line.substr(0, cut)) + '\n';
            line = next == std::string::npos ? "" : indent + line.substr(next);
          }
        result += line + '\n';
      }
    return result;
  }



  RunLog::RunLog(const bool is_root, const bool is_quiet)
    : RunLog(is_root, std::cout, isatty(STDOUT_FILENO) == 1, is_quiet)
  {
  }



  RunLog::RunLog(const bool    is_root,
                 std::ostream &console,
                 const bool    is_terminal,
                 const bool    is_quiet)
    : is_root(is_root)
    , console(console)
    , is_terminal(is_terminal)
    , is_quiet(is_quiet)
  {
  }



  void
  RunLog::open(const std::string &file_name)
  {
    if (!is_root)
      return;
    path  = file_name;
    errno = 0;
    file.open(path, std::ios::trunc);
    file << kept << std::flush;
    if (!file)
      throw InputError("cannot write '" + path + "': " + std::strerror(errno));
    kept.clear();
  }



  void
  RunLog::write(const std::string &lines, const Importance importance)
  {
    if (!is_root)
      return;
    show_transient("");
    if (!is_quiet || importance == Importance::result)
      console << wrapped(lines) << std::flush;
    write_to_file(lines);
  }



  void
  RunLog::write_to_file(const std::string &lines)
  {
    if (path.empty())
      {
        kept += lines;
        return;
      }
    file << lines << std::flush;
    if (!file)
      throw InputError("cannot write '" + path + "': is the disk full?");
  }



  void
  RunLog::show_transient(const std::string &text)
  {
    if (!is_root || !is_terminal || is_quiet)
      return;
    if (transient_width > 0)
      console << '\r' << std::string(transient_width, ' ') << '\r';
    console << text << std::flush;
    transient_width = display_width(text);
  }



  void
  RunLog::info(const std::string &text)
  {
    write(!text.empty() && text.back() == '\n' ? text : text + '\n');
  }



  void
  RunLog::result(const std::string &text)
  {
    write(!text.empty() && text.back() == '\n' ? text : text + '\n',
          Importance::result);
  }



  void
  RunLog::heading(const std::string &text)
  {
    write('\n' + text + '\n' +
          std::string(std::min(display_width(text), columns_of_a_line), '-') +
          '\n');
  }



  void
  RunLog::key_values(const Lines &lines)
  {
    write(aligned(lines));
  }



  std::string
  RunLog::aligned(const Lines &lines)
  {
    std::size_t width = 0;
    for (const auto &[name, value] : lines)
      width = std::max(width, display_width(name));
    std::string text;
    for (const auto &[name, value] : lines)
      text += without_trailing_blanks("  " + padded(name, width, true) + "  " +
                                      value) +
              '\n';
    return text;
  }



  void
  RunLog::warning(const std::string &text)
  {
    if (!is_root ||
        std::count(warning_texts.begin(), warning_texts.end(), text))
      return;
    warning_texts.push_back(text);
    write("warning: " + text + '\n', Importance::result);
  }



  const std::vector<std::string> &
  RunLog::warnings() const
  {
    return warning_texts;
  }



  void
  RunLog::summary(const Lines &figures, const Timers &timers)
  {
    if (!is_root)
      return;
    heading("Summary");
    char memory[64];
    std::snprintf(memory, sizeof(memory), "%.0f MB", peak_memory_mb());
    Lines lines = figures;
    lines.emplace_back("peak memory", memory);
    write(aligned(lines), Importance::result);

    std::ostringstream table;
    timers.print(table);
    write('\n' + table.str());

    if (warning_texts.empty())
      return;
    const std::size_t n = warning_texts.size();
    std::string       text =
      '\n' + std::to_string(n) + (n == 1 ? " warning:\n" : " warnings:\n");
    for (const std::string &warning : warning_texts)
      text += "  - " + warning + '\n';
    write(text);
  }



  bool
  RunLog::on_root() const
  {
    return is_root;
  }



  Progress::Progress(RunLog            &log,
                     const std::string &what,
                     const std::size_t  n_steps,
                     Clock              clock)
    : log(log)
    , what(what)
    , n_steps(n_steps)
    , clock(clock ? std::move(clock) : Clock(wall_seconds))
    , start(this->clock())
    , last_line(start - seconds_between_lines + seconds_before_progress)
    , last_transient(start)
  {
  }



  Progress::~Progress()
  {
    if (!shown)
      return;
    try
      {
        const bool complete = n_steps == 0 || n_done >= n_steps;
        log.info(done() + (complete ? ", done in " : ", ended after ") +
                 format_duration(clock() - start));
      }
    catch (const std::exception &)
      {
        // a log that cannot be written is reported by the next line of it
      }
  }



  std::string
  Progress::done() const
  {
    std::string text = what + ": " + std::to_string(n_done);
    if (n_steps > 0)
      text += " of " + std::to_string(n_steps) + " (" +
              std::to_string(100 * n_done / n_steps) + " %)";
    return text;
  }



  std::string
  Progress::line(const double elapsed, const std::string &note) const
  {
    std::string  text    = done() + ", " + format_duration(elapsed);
    const double seconds = elapsed - first_report;
    if (n_steps > n_done && n_done > n_at_first &&
        seconds >= seconds_before_estimate)
      text +=
        ", about " +
        format_duration(seconds * (n_steps - n_done) / (n_done - n_at_first)) +
        " left";
    return note.empty() ? text : text + ", " + note;
  }



  void
  Progress::advance(const std::size_t n_more, const std::string &note)
  {
    n_done += n_more;
    if (!log.is_root)
      return;
    const double now     = clock();
    const double elapsed = now - start;
    if (n_at_first == 0)
      {
        first_report = elapsed;
        n_at_first   = n_done;
      }
    if (elapsed < seconds_before_progress)
      return;

    if (now - last_line >= seconds_between_lines)
      {
        if (log.is_terminal)
          log.write_to_file(line(elapsed, note) + '\n');
        else
          log.info(line(elapsed, note));
        last_line = now;
        shown     = true;
      }
    if (log.is_terminal && now - last_transient >= seconds_between_updates)
      {
        log.show_transient(line(elapsed, note));
        last_transient = now;
        shown          = true;
      }
  }
} // namespace squeal
