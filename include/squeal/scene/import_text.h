// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_import_text_h
#define squeal_scene_import_text_h

#include <array>
#include <string>
#include <string_view>

namespace squeal
{
  /** Line-wise reading of the text files that other codes write. */
  namespace import
  {
    /**
     * A text file read line by line. Every complaint carries "file:line: ".
     */
    class TextFile
    {
    public:
      /** Reads the whole file. Throws InputError when it is missing, a
       * directory, empty or not text. */
      explicit TextFile(const std::string &name);
      TextFile(const TextFile &)            = delete;
      TextFile &operator=(const TextFile &) = delete;

      /** Moves to the next line and returns true, or returns false at the
       * end. Line ends of Unix and Windows are taken off, and so is a
       * byte-order mark. */
      bool next();

      /** The current line; valid until the next call of next(). */
      std::string_view line() const;

      /** Number of the current line, from 1. */
      unsigned int line_number() const;

      /** Starts again before the first line. */
      void rewind();

      /** Throws InputError when the last line has no line end: the sign of a
       * copy that stopped half-way, within a number or, in formats that do not
       * say how many entries they hold, between any two lines. */
      void check_last_line_is_complete() const;

      /** Throws InputError about the current line. */
      [[noreturn]] void fail(const std::string &text) const;

      /** Throws InputError about line @p number. */
      [[noreturn]] void fail_at(unsigned int       number,
                                const std::string &text) const;

      const std::string &name() const;

    private:
      std::string      file_name;
      std::string      content;
      std::size_t      position = 0;
      std::string_view current;
      unsigned int     number = 0;
    };

    /** The fields of a line: up to eight are kept, all are counted. */
    struct Fields
    {
      std::array<std::string_view, 8> field;
      unsigned int                    n = 0;

      std::string_view
      operator[](const unsigned int i) const
      {
        return field[i];
      }
    };

    /** Splits at blanks and commas; several in a row count as one. */
    Fields split_at_blanks_and_commas(std::string_view line);

    /** @p text without blanks at both ends. */
    std::string_view trimmed(std::string_view text);

    /** Capital letters of @p text. */
    std::string upper_case(std::string_view text);

    /** Reads the whole of @p text as an integer; false when it is none. */
    bool parse_integer(std::string_view text, long &value);

    /**
     * Reads the whole of @p text as a real number; false when it is none.
     * Takes C notation, Fortran's D exponent (1.0D+5) and Nastran's exponent
     * without a letter (3.+5). "nan" and "inf" are read as such and a number
     * that is too large as infinity; real_field() refuses them.
     */
    bool parse_real(std::string_view text, double &value);

    /** The integer in a field of the current line; throws InputError that
     * calls the field @p what ("row number"). */
    long integer_field(const TextFile  &file,
                       std::string_view text,
                       const char      *what);

    /** The finite real number in a field of the current line. */
    double real_field(const TextFile  &file,
                      std::string_view text,
                      const char      *what);
  } // namespace import
} // namespace squeal

#endif
