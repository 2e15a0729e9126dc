// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_csv_dialect_h
#define squeal_results_csv_dialect_h

#include <string>

namespace squeal
{
  /**
   * How a spreadsheet wrote its cells: separated by commas, or by semicolons or
   * tabs, which leave the comma to decimals. The header decides: a comma
   * outside quotes makes commas the separator.
   *
   * Where commas do not separate, number() reads decimal commas. A table that
   * has decimal points as well is refused, as nobody knows what 1.234 means in
   * it.
   */
  class CsvDialect
  {
  public:
    CsvDialect() = default;

    /** @p header may start with a byte-order mark. */
    explicit CsvDialect(const std::string &header);

    char
    separator() const
    {
      return mark;
    }

    /** @p cell with a decimal point, if it is a number with a decimal comma;
     * else as it is. Throws InputError "@p place: ..." for a decimal comma
     * after decimal points and the other way about, and for a number with
     * both. */
    std::string number(const std::string &cell, const std::string &place);

    /** What to say beside a row of too many cells; "" where the separator
     * cannot be the reason. */
    std::string hint(std::size_t n_cells, std::size_t n_columns) const;

  private:
    char mark       = ',';
    bool has_points = false, has_commas = false;
  };

  /** Takes a UTF-8 byte-order mark off. Throws InputError for text in UTF-16,
   * naming @p path. */
  std::string without_byte_order_mark(const std::string &text,
                                      const std::string &path);
} // namespace squeal

#endif
