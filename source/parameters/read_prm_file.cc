// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>

#include <squeal/parameters/names.h>
#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <utility>

#include "drop_included.h"
#include "indexed_tree.h"

namespace squeal
{
  namespace prm
  {
    namespace
    {
      namespace fs = std::filesystem;

      // Far beyond what anybody writes: the largest shipped file has some 150
      // lines. They end includes that double at each level.
      constexpr std::size_t largest_size      = std::size_t(1) << 24; // bytes
      constexpr std::size_t most_lines        = 200000;
      constexpr std::size_t most_nested_files = 32;
      constexpr std::size_t most_nested_sections = 32;

      /** A line without comment, its continuations joined, and the number of
       * the first of them. */
      struct LogicalLine
      {
        std::string  text;
        unsigned int number;
      };



      [[noreturn]] void
      refuse(const Location &location, const std::string &reason)
      {
        throw InputError(location.text() + ": " + reason);
      }



      /** @p line without its comment: a '#' inside a word is none. */
      std::string
      without_comment(const std::string &line)
      {
        for (std::size_t i = 0; i < line.size(); ++i)
          if (line[i] == '#' &&
              (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t'))
            return trim(line.substr(0, i));
        return trim(line);
      }



      /** Refuses anything but text before it is shown in other messages. */
      void
      check_is_text(const std::string &content, const std::string &file)
      {
        unsigned int line = 1;
        for (const char c : content)
          {
            const unsigned char code = static_cast<unsigned char>(c);
            if (c == '\n')
              ++line;
            else if ((code < 0x20 && c != '\t' && c != '\r' && c != '\f') ||
                     code == 0x7f)
              refuse({file, line},
                     "holds bytes that are no text: this is not a parameter "
                     "file");
          }
      }



      std::string
      read_text(const std::string &file, const std::string &included_from)
      {
        const std::string start =
          included_from.empty() ? "" : included_from + ": include: ";
        std::error_code ignored;
        if (file.empty() || !fs::exists(file, ignored))
          throw InputError(start + in_quotes(file) + ": no such file");
        if (fs::is_directory(file, ignored))
          throw InputError(start + in_quotes(file) +
                           " is a directory, not a parameter file: name the "
                           "files in it (" +
                           file + "/*.prm)");
        if (fs::is_regular_file(file, ignored) &&
            fs::file_size(file, ignored) > largest_size)
          throw InputError(start + in_quotes(file) +
                           " is too large for a parameter file");
        try
          {
            return read_file(file);
          }
        catch (const InputError &e)
          {
            throw InputError(start + e.what());
          }
      }



      /** Refuses lines that end as on the oldest Macintosh: all are one. */
      void
      check_has_line_feeds(const std::string &content, const std::string &file)
      {
        const std::size_t first = content.find('\r');
        if (first != std::string::npos &&
            content.find('\n') == std::string::npos &&
            content.find_first_not_of(" \t\r", first) != std::string::npos)
          throw InputError(file +
                           ": its lines end with a carriage return alone "
                           "(CR): save it with line feeds (LF)");
      }



      std::vector<LogicalLine>
      logical_lines(std::string content, const std::string &file)
      {
        if (starts_with(content, "\xef\xbb\xbf")) // byte order mark
          content.erase(0, 3);
        check_is_text(content, file);
        check_has_line_feeds(content, file);

        std::vector<LogicalLine> lines;
        bool                     continues = false;
        unsigned int             number    = 0;
        for (std::size_t start = 0; start < content.size();)
          {
            const std::size_t end =
              std::min(content.find('\n', start), content.size());
            std::string line =
              without_comment(content.substr(start, end - start));
            start = end + 1;
            ++number;
            if (!is_utf8(line))
              refuse({file, number},
                     "holds letters in another encoding than UTF-8; save the "
                     "file as UTF-8");

            const bool continued = continues;
            continues            = !line.empty() && line.back() == '\\';
            if (continues)
              line = trim(line.substr(0, line.size() - 1));
            if (continued)
              lines.back().text += " " + line;
            else
              lines.push_back({line, number});
          }
        if (continues)
          refuse({file, lines.back().number},
                 "the backslash at the end promises one more line");
        return lines;
      }



      /** Reads a file and what it includes. */
      class PrmReader
      {
      public:
        PrmTree read(const std::string &file,
                     const std::string &section,
                     const std::string &included_from);

        /** The files read so far, in the order of reading. */
        std::vector<std::string> files() const;

      private:
        /** A file and the section that it is read into. */
        using Inclusion = std::pair<std::string, std::string>;

        struct File
        {
          std::string             name;
          std::string             directory;
          std::vector<RawSection> open; /**< sections, the innermost last */
          IndexedTree             own;
          IndexedTree             included;
          std::vector<RawSection> dropped; /**< of what was included */
          /** Files that it has included, themselves or through others. */
          std::set<Inclusion> has_included;
        };

        void read_line(const std::string &line,
                       const Location    &location,
                       File              &file);
        void read_set(const std::string &rest,
                      const Location    &location,
                      File              &file) const;
        void read_include(const std::string &name,
                          const Location    &location,
                          File              &file);
        void read_drop(const std::string &name,
                       const Location    &location,
                       File              &file) const;
        void open_section(const std::string &name,
                          const Location    &location,
                          File              &file) const;

        /** Files being read, outermost first. */
        std::vector<std::string> active;
        /** Files read, with the section they were read into. */
        std::set<Inclusion> done;
        /** The same in order. */
        std::vector<Inclusion> order;
        /** Files read to their end. */
        unsigned int n_complete = 0;
        /** Lines of all of them so far. */
        std::size_t n_lines = 0;
      };



      /** The section a line of the file stands in. */
      std::string
      innermost(const std::vector<RawSection> &open)
      {
        return open.back().path;
      }



      /** Refuses sections that nobody can mean before they cost time. */
      void
      check_depth(const std::string &path, const Location &location)
      {
        if (std::count(path.begin(), path.end(), '/') >
            static_cast<long>(most_nested_sections))
          refuse(location,
                 "more than " + std::to_string(most_nested_sections) +
                   " sections inside each other: is an 'end' missing?");
      }



      void
      PrmReader::read_set(const std::string &rest,
                          const Location    &location,
                          File              &file) const
      {
        const std::size_t equals = rest.find('=');
        if (equals == std::string::npos)
          refuse(location,
                 in_quotes("set " + rest) +
                   " has no '='; write 'set Entry = value'");
        const std::string name = normal_path(rest.substr(0, equals));
        if (name.empty())
          refuse(location, "'set' without the name of an entry");

        const std::string path = path_of(innermost(file.open), name);
        check_depth(path, location);
        if (const RawEntry *earlier = file.own.find(path))
          refuse(location,
                 "entry " + in_quotes(path) +
                   " is set a second time; the first "
                   "is in line " +
                   std::to_string(earlier->location.line) +
                   ": remove one of them");
        file.own.set(
          {path, trim(rest.substr(equals + 1)), location, file.directory});
      }



      void
      PrmReader::read_include(const std::string &name,
                              const Location    &location,
                              File              &file)
      {
        if (name.empty())
          refuse(location, "'include' without the name of a file");
        const fs::path path =
          fs::path(name).is_absolute()
            ? fs::path(name)
            : (fs::path(file.name).parent_path() / name).lexically_normal();
        const std::string section = innermost(file.open);
        std::error_code   ignored;
        const Inclusion   self = {fs::weakly_canonical(path, ignored).string(),
                                  section};
        // What files share that this one includes is read once; here it would
        // be passed over without a word.
        if (file.has_included.count(self) > 0)
          refuse(location,
                 "include " + in_quotes(name) +
                   ": that file is included above already, here or by a file "
                   "that this one includes, and is not read again: name it "
                   "before what is to override it, or write what was dropped "
                   "into a file of its own");
        const std::size_t before = order.size();
        file.included.add(read(path.string(), section, location.text()));
        file.has_included.insert(self);
        file.has_included.insert(order.begin() + before, order.end());
      }



      void
      PrmReader::read_drop(const std::string &name,
                           const Location    &location,
                           File              &file) const
      {
        if (name.empty())
          refuse(location, "'drop' without the name of a section or an entry");
        const std::string section = innermost(file.open);
        const std::string path    = path_of(section, name);
        PrmTree           tree    = *file.included;
        if (!drop_path(tree, path))
          refuse(location,
                 "'drop' of " + in_quotes(path) +
                   ": nothing of that name was included before this line" +
                   did_you_mean(name, names_below(tree, section)));
        file.included.become(std::move(tree));
        file.dropped.push_back({path, location});
      }



      void
      PrmReader::open_section(const std::string &name,
                              const Location    &location,
                              File              &file) const
      {
        if (name.empty())
          refuse(location, "'subsection' without a name");
        const std::string path = path_of(innermost(file.open), name);
        check_depth(path, location);
        file.open.push_back({path, location});
        file.own.add_section(file.open.back());
      }



      void
      PrmReader::read_line(const std::string &line,
                           const Location    &location,
                           File              &file)
      {
        const std::size_t space   = line.find_first_of(" \t");
        std::string       keyword = line.substr(0, space);
        for (char &c : keyword)
          c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        const std::string rest =
          space == std::string::npos ? "" : trim(line.substr(space));

        if (keyword == "set")
          read_set(rest, location, file);
        else if (keyword == "include")
          read_include(rest, location, file);
        else if (keyword == "drop")
          read_drop(normal_path(rest), location, file);
        else if (keyword == "subsection")
          open_section(normal_path(rest), location, file);
        else if (keyword == "end" && rest.empty())
          {
            if (file.open.size() == 1)
              refuse(location, "'end' without a 'subsection' that it closes");
            file.open.pop_back();
          }
        else
          refuse(location,
                 in_quotes(line) +
                   " is not understood; a line starts with 'set', "
                   "'subsection', 'end', 'include', 'drop' or '#'" +
                   did_you_mean(
                     keyword, {"set", "subsection", "end", "include", "drop"}));
      }



      PrmTree
      PrmReader::read(const std::string &name,
                      const std::string &section,
                      const std::string &included_from)
      {
        if (active.size() >= most_nested_files)
          throw InputError(included_from + ": include " + in_quotes(name) +
                           ": more than " + std::to_string(most_nested_files) +
                           " files that include each other");
        const std::string content = read_text(name, included_from);
        std::error_code   ignored;
        const std::string identity =
          fs::weakly_canonical(name, ignored).string();
        const bool is_cycle =
          std::find(active.begin(), active.end(), identity) != active.end();
        if (is_cycle)
          throw InputError(included_from + ": include " + in_quotes(name) +
                           " leads back to a file that includes this one");
        if (!done.insert({identity, section}).second)
          return {};
        order.emplace_back(identity, section);

        active.push_back(identity);
        File file;
        file.name      = name;
        file.directory = fs::absolute(name).parent_path().string();
        file.open.push_back({section, {}});
        bool                           is_empty = true;
        const std::vector<LogicalLine> lines    = logical_lines(content, name);
        n_lines += lines.size();
        if (n_lines > most_lines)
          throw InputError(
            (included_from.empty()
               ? name
               : included_from + ": include " + in_quotes(name)) +
            ": more than " + std::to_string(most_lines) +
            " lines with all included files");
        for (const LogicalLine &line : lines)
          if (!line.text.empty())
            {
              read_line(line.text, {name, line.number}, file);
              is_empty = false;
            }
        active.pop_back();

        if (file.open.size() > 1)
          refuse(file.open.back().location,
                 "subsection " + in_quotes(entry_of(file.open.back().path)) +
                   " has no 'end'");
        if (is_empty)
          throw InputError(name + ": sets no entry: " +
                           (trim(content).empty()
                              ? "the file is empty"
                              : "all of its lines are comments"));

        PrmTree tree = *file.included;
        for (const RawSection &section : file.dropped)
          take_from_list(tree, *file.own, section.path);
        file.included.become(std::move(tree));
        PrmTree own = *file.own;
        ++n_complete; // after those that it includes
        for (RawEntry &entry : own.entries)
          entry.order = n_complete;
        file.included.add(own);
        return *file.included;
      }



      std::vector<std::string>
      PrmReader::files() const
      {
        std::vector<std::string> names;
        for (const Inclusion &inclusion : order)
          names.push_back(inclusion.first);
        return names;
      }
    } // namespace



    PrmTree
    read_prm_file(const std::string &file)
    {
      return PrmReader().read(file, "", "");
    }



    std::vector<std::string>
    prm_files_of(const std::string &file)
    {
      PrmReader reader;
      reader.read(file, "", "");
      return reader.files();
    }
  } // namespace prm
} // namespace squeal
