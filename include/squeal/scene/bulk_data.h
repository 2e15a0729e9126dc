// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_bulk_data_h
#define squeal_scene_bulk_data_h

#include <squeal/scene/import_text.h>

#include <vector>

namespace squeal
{
  namespace import
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
      /** Mark at the end of a line that the continuation line repeats at its
       * start; without the sign in front. */
      std::string mark_in_front, mark_behind;
      /** What the fields look into. */
      std::string text;
    };

    /** Moves to the next line that is not empty and cuts it into fields, of
     * small, large or free format; false at the end. Throws InputError where a
     * line has too many fields or replicates the entry before ('=' in the first
     * field). */
    bool next_bulk_line(TextFile &file, BulkLine &line);

    /** An entry with its continuation lines. */
    struct BulkEntry
    {
      std::string name; /**< in capitals */
      /** Fields 2 to 9 of all lines, eight each; empty where left out. */
      std::vector<std::string> fields;
      unsigned int             line = 0; /**< number of its first line */

      /** A field, counted from 0; empty behind the last. */
      const std::string &field(const std::size_t i) const;
    };

    /** Reads a file entry by entry. */
    class BulkEntries
    {
    public:
      explicit BulkEntries(TextFile &file);

      /** The next entry; false at the end or at ENDDATA. Throws InputError for
       * a continuation line that continues nothing or bears another mark than
       * the line before. */
      bool next(BulkEntry &entry);

      /** Whether ENDDATA was met. */
      bool has_end() const;

    private:
      void append(BulkEntry &entry);

      TextFile    &file;
      BulkLine     line;
      bool         is_ahead = false; /**< the line begins the next entry */
      bool         ended    = false;
      std::string  mark;
      unsigned int n_halves = 0; /**< lines of four fields of the entry */
    };
  } // namespace import
} // namespace squeal

#endif
