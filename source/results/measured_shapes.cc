// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/inputs_read.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/response_parameters.h>
#include <squeal/parameters/text.h>
#include <squeal/results/measured_shapes.h>
#include <squeal/results/table.h>

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Lines of a universal file, with fields in fixed columns. */
    class Lines
    {
    public:
      explicit Lines(const std::string &path)
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
            const std::size_t at = (i % n_in_line) * width;
            std::string       field =
              at < line.size() ? prm::trim(line.substr(at, width)) : "";
            for (char &c : field)
              if (c == 'D' || c == 'd')
                c = 'E';
            char        *end   = nullptr;
            const double value = std::strtod(field.c_str(), &end);
            if (field.empty() || *end != '\0' || !std::isfinite(value))
              fail("'" + field + "' is no number of " + what + " (columns " +
                   std::to_string(at + 1) + " to " +
                   std::to_string(at + width) + ")");
            result.push_back(value);
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
      const std::string        path;
      std::vector<std::string> lines;
      std::size_t              next = 0;
    };

    /** Frequency from the numbers of record 8. */
    double
    frequency_of(const int analysis, const std::vector<double> &reals)
    {
      const bool is_normal = analysis == 2;
      if (reals.size() < (is_normal ? 1u : 2u))
        return 0.;
      return is_normal ? reals[0] : std::abs(reals[1]) / (2. * M_PI);
    }

    MeasuredShape
    read_shape(Lines &lines)
    {
      MeasuredShape shape;
      shape.name = prm::trim(lines.take("a title"));
      for (unsigned int i = 0; i < 4; ++i)
        lines.take("a title");
      const std::vector<int> kind = lines.integers(6, "the kind of the data");
      const int analysis = kind[1], data = kind[4], n_values = kind[5];
      if (analysis != 2 && analysis != 3 && analysis != 7)
        lines.fail("analysis type " + std::to_string(analysis) +
                   " is no mode; 2, 3 or 7 are read");
      if (data != 2 && data != 4 && data != 5 && data != 6)
        lines.fail("data type " + std::to_string(data) +
                   " is not read; 2 and 4 (real), 5 and 6 (complex) are");
      if (n_values != 3 && n_values != 6)
        lines.fail(std::to_string(n_values) +
                   " values a node; three or six are read");
      const bool is_complex = data > 4;
      // Double precision has wider fields.
      const bool         is_double = data == 4 || data == 6;
      const unsigned int width     = is_double ? 20 : 13;
      const unsigned int n_in_line = is_double ? 4 : 6;
      const std::string  what      = "the numbers of the mode";
      const auto         counts    = lines.integers(2, what);
      if (counts[0] < 0 || counts[0] > 6 || counts[1] < 0 || counts[1] > 1000)
        lines.fail("wrong counts in " + what);
      const auto reals = lines.numbers(counts[1], 13, 6, what);
      shape.frequency  = frequency_of(analysis, reals);
      while (!lines.is_mark())
        {
          const int  node   = lines.integers(1, "a node")[0];
          const auto values = lines.numbers(n_values * (is_complex ? 2 : 1),
                                            width,
                                            n_in_line,
                                            "a displacement");
          if (node < 1)
            lines.fail("node " + std::to_string(node) + " is below 1");
          const auto [place, is_new] = shape.nodes.try_emplace(node);
          if (!is_new)
            lines.fail("node " + std::to_string(node) +
                       " is there twice in one shape");
          for (unsigned int c = 0; c < 3; ++c)
            place->second[c] = is_complex
                                 ? Complex(values[2 * c], values[2 * c + 1])
                                 : Complex(values[c]);
        }
      lines.take("the end of the dataset");
      if (shape.nodes.empty())
        lines.fail("the shape has no node");
      return shape;
    }

    std::vector<MeasuredShape>
    read_universal(const std::string &path)
    {
      Lines                      lines(path);
      std::vector<MeasuredShape> shapes;
      while (!lines.at_end())
        {
          if (!lines.is_mark())
            {
              if (prm::trim(lines.take("a line")).empty())
                continue;
              lines.fail("expected -1 at the start of a dataset");
            }
          lines.take("-1");
          const std::string number =
            prm::trim(lines.take("a dataset's number"));
          if (number == "55")
            shapes.push_back(read_shape(lines));
          else
            {
              if (number.empty() || number.find_first_not_of("0123456789bB ") !=
                                      std::string::npos)
                lines.fail("'" + number + "' is no number of a dataset");
              while (!lines.is_mark())
                lines.take("the end of dataset " + number);
              lines.take("-1");
            }
        }
      return shapes;
    }

    std::vector<MeasuredShape>
    read_table(const std::string &path)
    {
      using Type                       = Table::Type;
      const Table                table = read_csv(path,
                                   {{"shape", Type::text, "", ""},
                                                   {"frequency_hz", Type::real, "Hz", ""},
                                                   {"point", Type::text, "", ""},
                                                   {"real", Type::real, "", ""},
                                                   {"imag", Type::real, "", ""}});
      std::vector<MeasuredShape> shapes;
      for (std::size_t r = 0; r < table.n_rows(); ++r)
        {
          const std::string name  = table.text(r, "shape");
          const std::string place = path + ":" + std::to_string(r + 2) + ": ";
          for (const char *column : {"frequency_hz", "real", "imag"})
            if (table.is_missing(r, column))
              throw InputError(place + "no value of " + column);
          MeasuredShape *shape = nullptr;
          for (auto &candidate : shapes)
            if (candidate.name == name)
              shape = &candidate;
          if (!shape)
            {
              shapes.emplace_back();
              shape            = &shapes.back();
              shape->name      = name;
              shape->frequency = table.real(r, "frequency_hz");
            }
          else if (shape->frequency != table.real(r, "frequency_hz"))
            throw InputError(place + "shape '" + name +
                             "' has another frequency above: give each shape "
                             "a name of its own");
          if (!shape->points
                 .insert({table.text(r, "point"),
                          {table.real(r, "real"), table.real(r, "imag")}})
                 .second)
            throw InputError(place + "shape '" + name + "' has point '" +
                             table.text(r, "point") + "' twice");
        }
      return shapes;
    }
  } // namespace



  std::vector<MeasuredShape>
  read_measured_shapes(const std::string &path)
  {
    std::istringstream in(read_input_file(path));
    std::string        line;
    while (std::getline(in, line) && prm::trim(line).empty())
      ;
    const auto shapes =
      prm::trim(line) == "-1" ? read_universal(path) : read_table(path);
    if (shapes.empty())
      throw InputError(path + ": holds no shape (no dataset 55, no row)");
    return shapes;
  }

  std::vector<MeasuredShape>
  read_measured_shapes(const MeasurementParameters &measurement)
  {
    std::vector<std::string> names;
    for (const auto &point : measurement.points)
      names.push_back(point.name);
    const auto shapes = read_measured_shapes(measurement.shapes_file);
    for (const auto &shape : shapes)
      for (const auto &[name, value] : shape.points)
        if (measurement.find(name) < 0)
          throw InputError(measurement.shapes_file + ": shape '" + shape.name +
                           "' has point '" + name +
                           "', which is not in Measurement/Points" +
                           prm::did_you_mean(name, names));
    return shapes;
  }
} // namespace squeal
