// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_analyses_universal_reader_h
#define squeal_tests_analyses_universal_reader_h

#include <cmath>
#include <complex>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace squeal
{
  namespace testing
  {
    /** What a dataset 58 says, as far as the tests look at it. */
    struct ReadFunction
    {
      std::string response, reference;
      int         response_node, response_direction, reference_node,
        reference_direction, quantity;
      double                            first, step;
      std::vector<double>               frequencies; /**< uneven ones */
      std::vector<std::complex<double>> values;
    };

    /** One line with fields in fixed columns. */
    class Fields
    {
    public:
      Fields(std::istream &in, const std::size_t length)
      {
        require(bool(std::getline(in, line)), "another line");
        require(line.size() == length,
                "a line of " + std::to_string(length) + " columns: '" + line +
                  "'");
      }

      static void
      require(const bool ok, const std::string &what)
      {
        if (!ok)
          throw std::runtime_error("expected " + what);
      }

      int
      integer(const std::size_t width)
      {
        const double value = real(width);
        require(value == std::floor(value), "a whole number in '" + line + "'");
        return static_cast<int>(value);
      }

      /** A number that ends in the last column of its field. */
      double
      real(const std::size_t width)
      {
        const std::string field = text(width);
        char             *end   = nullptr;
        const double      value = std::strtod(field.c_str(), &end);
        require(end == field.c_str() + width && std::isfinite(value),
                "a number, not '" + field + "'");
        return value;
      }

      std::string
      text(const std::size_t width)
      {
        require(at + width <= line.size(), "more columns in '" + line + "'");
        at += width;
        return line.substr(at - width, width);
      }

      void
      blank()
      {
        require(text(1) == " ", "a blank column in '" + line + "'");
      }

      void
      end()
      {
        require(at == line.size(), "the end of '" + line + "'");
      }

    private:
      std::string line;
      std::size_t at = 0;
    };

    inline std::string
    without_blanks(const std::string &text)
    {
      return text.substr(0, text.find_last_not_of(' ') + 1);
    }

    /** Records 8 to 11: the kind of an axis and its label. */
    inline int
    read_axis(std::istream      &in,
              const std::string &label,
              const std::string &unit)
    {
      Fields    fields(in, 10 + 15 + 42);
      const int kind = fields.integer(10);
      for (int i = 0; i < 3; ++i)
        fields.integer(5);
      fields.blank();
      const std::string l = without_blanks(fields.text(20));
      fields.blank();
      const std::string u = without_blanks(fields.text(20));
      Fields::require(label.empty() || l == label, "label " + label);
      Fields::require(unit.empty() || u == unit, "unit " + unit);
      return kind;
    }

    inline ReadFunction
    read_function(std::istream &in)
    {
      ReadFunction f;
      for (int i = 0; i < 5; ++i)
        {
          std::string title;
          Fields::require(std::getline(in, title) && !title.empty() &&
                            title.size() <= 80,
                          "a title of 1 to 80 characters");
        }
      Fields names(in, 5 + 10 + 5 + 10 + 2 * 25);
      Fields::require(names.integer(5) == 4, "a frequency response");
      names.integer(10);
      names.integer(5);
      Fields::require(names.integer(10) == 0, "load case 0");
      names.blank();
      f.response           = without_blanks(names.text(10));
      f.response_node      = names.integer(10);
      f.response_direction = names.integer(4);
      names.blank();
      f.reference           = without_blanks(names.text(10));
      f.reference_node      = names.integer(10);
      f.reference_direction = names.integer(4);
      names.end();

      Fields data(in, 3 * 10 + 3 * 13);
      Fields::require(data.integer(10) == 6, "complex double precision");
      const int n       = data.integer(10);
      const int is_even = data.integer(10);
      f.first           = data.real(13);
      f.step            = data.real(13);
      Fields::require(data.real(13) == 0., "no z axis");
      Fields::require(read_axis(in, "Frequency", "Hz") == 18, "frequency");
      f.quantity = read_axis(in, "", "");
      Fields::require(f.quantity == 8 || f.quantity == 11 || f.quantity == 12,
                      "a displacement, velocity or acceleration");
      Fields::require(read_axis(in, "Force", "N") == 13, "a force");
      read_axis(in, "NONE", "NONE");

      for (int i = 0; i < n;)
        {
          const int in_line = is_even ? std::min(2, n - i) : 1;
          Fields    values(in, (is_even ? 0 : 13) + in_line * 40);
          if (!is_even)
            f.frequencies.push_back(values.real(13));
          for (int k = 0; k < in_line; ++k, ++i)
            {
              const double real = values.real(20);
              f.values.emplace_back(real, values.real(20));
            }
          values.end();
        }
      return f;
    }

    /** The datasets 58 of a universal file. Throws std::runtime_error at the
     * first column that is not what the format asks for. */
    inline std::vector<ReadFunction>
    read_universal_functions(const std::string &text)
    {
      std::istringstream        in(text);
      std::vector<ReadFunction> functions;
      while (in.peek() != EOF)
        {
          Fields start(in, 6);
          Fields::require(start.integer(6) == -1, "-1 before a dataset");
          Fields    kind(in, 6);
          const int number = kind.integer(6);
          if (number == 58)
            {
              functions.push_back(read_function(in));
              Fields end(in, 6);
              Fields::require(end.integer(6) == -1, "-1 after a dataset");
              continue;
            }
          Fields::require(number == 15 || number == 55 || number == 164,
                          "dataset 15, 55, 58 or 164");
          std::string line;
          do
            Fields::require(bool(std::getline(in, line)),
                            "the end of a dataset");
          while (line != "    -1");
        }
      return functions;
    }
  } // namespace testing
} // namespace squeal

#endif
