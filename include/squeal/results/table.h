// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_table_h
#define squeal_results_table_h

#include <squeal/base/number_text.h>

#include <iosfwd>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace squeal
{
  /** One value of a row: a double, an integer, a text, or nothing. A double
   * that is not finite goes into no table, unless or_missing() or unbounded()
   * says that it belongs there. */
  class Cell
  {
  public:
    Cell() = default;
    Cell(double value);
    Cell(const std::string &value);
    Cell(const char *value);
    template <typename Integer,
              typename = std::enable_if_t<std::is_integral_v<Integer>>>
    Cell(Integer value)
      : value(static_cast<long long>(value))
    {
    }

    bool is_missing() const;

    std::variant<std::monostate, double, long long, std::string> value;

    /** Whether an infinite value is a result. */
    bool may_be_infinite = false;
  };

  /** @p value, or nothing where it is NaN: for quantities that are not there in
   * every row, and only for those. An infinite value is refused as ever. */
  Cell or_missing(double value);

  /** @p value, which may be infinite but not NaN: the condition of a defective
   * eigenvalue, the life without damage. */
  Cell unbounded(double value);

  /**
   * Rows under typed columns: what every analysis hands over, and what is
   * written as CSV, printed, checked and put into the report. Columns may be
   * added at any time; rows that exist have nothing in them.
   */
  class Table
  {
  public:
    enum class Type
    {
      real,
      integer,
      text
    };

    /** The name is the word in the header of the CSV and carries the unit
     * (`frequency_hz`); unit and sentence are for people. */
    struct Column
    {
      std::string name;
      Type        type = Type::real;
      std::string unit;         /**< "Hz", "1/s", "" */
      std::string description;  /**< one sentence */
      int         n_digits = 6; /**< significant digits where people read it */
      /** >= 0: this many decimals instead, but for what is smaller than the
       * last of them: two significant digits */
      int n_decimals = -1;
    };

    Table() = default;
    explicit Table(std::vector<Column> columns);

    void add_column(const Column &column);

    /** Appends a row, one cell a column in their order. An integer in a real
     * column is converted; any other mismatch is a programming error. Throws
     * ComputationError naming the column and the row for a value that is not
     * finite and was not said to be so. */
    void add_row(std::vector<Cell> cells);

    /** Puts a column before the others, the same cell in every row. */
    void put_first(const Column &column, const Cell &cell);

    /** Adds the rows of another table with the same columns; a table without
     * columns takes those of the other. */
    void append(const Table &other);

    /** Replaces one cell. */
    void set(std::size_t row, const std::string &column, const Cell &cell);

    std::size_t                n_rows() const;
    const std::vector<Column> &columns() const;
    bool                       has_column(const std::string &name) const;

    /** Position of a column. Throws InputError naming the columns there are. */
    std::size_t column_index(const std::string &name) const;

    const Cell &cell(std::size_t row, std::size_t column) const;
    bool        is_missing(std::size_t row, const std::string &column) const;

    /** Value of a real or integer column; NaN where there is none. */
    double real(std::size_t row, const std::string &column) const;
    /** Value of an integer column; throws InputError where there is none. */
    long long integer(std::size_t row, const std::string &column) const;
    /** The value as in the CSV; "" where there is none. */
    std::string text(std::size_t row, const std::string &column) const;
    /** All values of a real or integer column. */
    std::vector<double> reals(const std::string &column) const;

    /** The value as people read it, rounded as the column asks. */
    std::string display(std::size_t row, std::size_t column) const;

    /** Writes a CSV: header of names, every digit of every number, an empty
     * cell for a missing value, "\n" line ends. */
    void write_csv(std::ostream &out) const;
    void write_csv(const std::string &path) const;

    /** Prints the named columns (all if none is named), rounded and aligned,
     * at most @p n_rows_shown rows. */
    void print(std::ostream                   &out,
               const std::vector<std::string> &names        = {},
               std::size_t                     n_rows_shown = -1) const;

    /** Prints the meaning of each column: name, unit, sentence. */
    void describe(std::ostream &out) const;

  private:
    std::vector<Column>            column_list;
    std::vector<std::vector<Cell>> rows;
  };

  /**
   * Reads a CSV with a header row (separated by commas, or by semicolons or
   * tabs with decimal points or commas; optional quotes, \n or \r\n, with or
   * without a byte-order mark). The
   * type of a column is the narrowest that fits all of its cells, unless it is
   * named in @p required. Throws InputError "file:line: ..." for a required
   * column that is missing or holds something else, NaN, a row of another
   * length than the header, a column named twice, an unclosed quote, an empty
   * file, or bytes that are no text.
   */
  Table read_csv(const std::string                &path,
                 const std::vector<Table::Column> &required = {});
} // namespace squeal

#endif
