// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_text_h
#define squeal_parameters_text_h

#include <string>
#include <vector>

namespace squeal
{
  /** Reading, declaring and printing parameter files. */
  namespace prm
  {
    /** @p text without blanks at both ends. */
    std::string trim(const std::string &text);

    /** @p text trimmed, every run of blanks inside made one blank. */
    std::string collapse_blanks(const std::string &text);

    /** The trimmed parts of @p text between @p separator; an empty or blank
     * text has no parts. */
    std::vector<std::string> split(const std::string &text, char separator);

    /** The parts with @p separator between them. */
    std::string join(const std::vector<std::string> &parts,
                     const std::string              &separator);

    /** @p text for an error line: in quotes, shortened, anything that is not
     * printable replaced by '?'. */
    std::string in_quotes(const std::string &text);

    /** Whether @p text is valid UTF-8, which plain ASCII is: anything else
     * could not be written to run.json. */
    bool is_utf8(const std::string &text);

    /** Whether @p text starts with @p start. */
    bool starts_with(const std::string &text, const std::string &start);

    /** Part of @p path before its last '/', empty if there is none. */
    std::string section_of(const std::string &path);

    /** Part of @p path after its last '/'. */
    std::string entry_of(const std::string &path);

    /** "Section/Entry"; just the entry at the top level. */
    std::string path_of(const std::string &section, const std::string &entry);
  } // namespace prm
} // namespace squeal

#endif
