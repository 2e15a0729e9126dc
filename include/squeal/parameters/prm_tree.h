// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_prm_tree_h
#define squeal_parameters_prm_tree_h

#include <string>
#include <vector>

namespace squeal
{
  namespace prm
  {
    /** Where an entry was written. */
    struct Location
    {
      std::string  file;     /**< as shown to the user, or e.g. "--set" */
      unsigned int line = 0; /**< from 1; 0: no line */

      /** "file:line" or just the file. */
      std::string text() const;
    };

    /** One "set" of a parameter file, not yet compared with a declaration. */
    struct RawEntry
    {
      std::string path; /**< "Section/Sub/Entry" */
      std::string value;
      Location    location;
      /** Folder that relative file names in the value start from. */
      std::string directory;
      /** Entries of a larger number override those of a smaller one: those of a
       * file have one number, larger than those of what it includes. */
      unsigned int order = 0;
    };

    /** One "subsection" of a parameter file. */
    struct RawSection
    {
      std::string path; /**< "Section/Sub" */
      Location    location;
    };

    /**
     * What is written in a parameter file and the files it includes: every
     * entry once, every section at least once, in the order of reading.
     */
    struct PrmTree
    {
      std::vector<RawEntry>   entries;
      std::vector<RawSection> sections;

      /** The entry of this path, or nullptr. */
      const RawEntry *find(const std::string &path) const;

      /** Adds an entry or replaces the one of the same path. */
      void set(const RawEntry &entry);

      /** The first mention of a section, or nullptr. */
      const RawSection *find_section(const std::string &path) const;
    };

    /**
     * Reads a parameter file: "subsection NAME ... end", "set ENTRY = VALUE",
     * "include FILE" (relative to the including file, also inside a section),
     * "drop NAME", comments from '#' at the start of a line or after a blank,
     * lines continued by a backslash at their end.
     *
     * Entries of a file override those of the files it includes, wherever the
     * include stands; of two included files the later one overrides the
     * earlier. A file that is included a second time in the same section adds
     * nothing.
     *
     * "drop NAME" removes an entry, or a section with all that is in it, from
     * what the file has included before that line; a member of a family, "drop
     * Scene/Body pad", is taken from the list of names, too, unless the section
     * is written again. NAME starts from the section that the line stands in.
     *
     * Throws InputError, one line with file and line number, for a missing
     * file, a directory, a file that sets nothing, bytes that are no text, a
     * line that is not understood, sections that are not closed, an entry set
     * twice in one file, a drop of what was not included, and includes that
     * lead back to themselves.
     */
    PrmTree read_prm_file(const std::string &file);

    /** @p file and the files it includes, by their absolute names, in the order
     * of reading. Throws as read_prm_file(). */
    std::vector<std::string> prm_files_of(const std::string &file);

    /** Takes "Section/Sub/Entry = value" apart, as given after --set; relative
     * file names start from the working directory, and its order is the largest
     * there is. Throws InputError. */
    RawEntry parse_override(const std::string &text);

    /** @p path with blanks around its names removed and those inside reduced
     * to one. */
    std::string normal_path(const std::string &path);
  } // namespace prm
} // namespace squeal

#endif
