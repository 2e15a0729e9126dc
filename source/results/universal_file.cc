// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/results/universal_file.h>

#include <cmath>
#include <cstdio>
#include <ostream>

namespace squeal
{
  namespace
  {
    /** printf into a string. */
    template <typename... Arguments>
    std::string
    print(const char *format, const Arguments &...arguments)
    {
      char text[256];
      std::snprintf(text, sizeof text, format, arguments...);
      return text;
    }

    /** "80A1": one line of text, never longer, never empty. */
    std::string
    title_line(const std::string &text)
    {
      return (text.empty() ? "NONE" : text.substr(0, universal_title_length)) +
             "\n";
    }

    void
    open_dataset(std::ostream &out, const int number)
    {
      out << print("%6d\n%6d\n", -1, number);
    }

    void
    close_dataset(std::ostream &out)
    {
      out << print("%6d\n", -1);
    }

    /** Numbers of @p format, @p n_in_line in a line. */
    class NumberLines
    {
    public:
      NumberLines(std::ostream &out, const char *format, const int n_in_line)
        : out(out)
        , format(format)
        , n_in_line(n_in_line)
      {
      }

      void
      add(const double value)
      {
        out << print(format, value);
        if (++n == n_in_line)
          end();
      }

      void
      end()
      {
        if (n > 0)
          out << '\n';
        n = 0;
      }

    private:
      std::ostream &out;
      const char   *format;
      const int     n_in_line;
      int           n = 0;
    };

    /** Records 8 to 11: what an axis holds. */
    std::string
    axis_line(const int          kind,
              const int          length,
              const int          force,
              const std::string &label,
              const std::string &unit)
    {
      return print("%10d%5d%5d%5d %-20.20s %-20.20s\n",
                   kind,
                   length,
                   force,
                   0,
                   label.c_str(),
                   unit.c_str());
    }

    std::string
    quantity_unit(const UniversalFunction::Quantity quantity)
    {
      switch (quantity)
        {
        case UniversalFunction::Quantity::displacement:
          return "m";
        case UniversalFunction::Quantity::velocity:
          return "m/s";
        case UniversalFunction::Quantity::acceleration:
          return "m/s^2";
        }
      unknown_choice("quantity");
    }

    std::string
    quantity_label(const UniversalFunction::Quantity quantity)
    {
      switch (quantity)
        {
        case UniversalFunction::Quantity::displacement:
          return "Displacement";
        case UniversalFunction::Quantity::velocity:
          return "Velocity";
        case UniversalFunction::Quantity::acceleration:
          return "Acceleration";
        }
      unknown_choice("quantity");
    }
  } // namespace



  int
  universal_direction(const std::array<double, 3> &d)
  {
    const double length = std::hypot(d[0], d[1], d[2]);
    for (int c = 0; c < 3; ++c)
      if (std::abs(std::abs(d[c]) - length) <= 1e-9 * length)
        return d[c] > 0. ? c + 1 : -c - 1;
    return 0;
  }



  void
  write_universal_units(std::ostream &out)
  {
    open_dataset(out, 164);
    out << print("%10d%-20s%10d\n", 1, "SI: metre, newton", 2)
        << print("%25.17E%25.17E%25.17E\n%25.17E\n", 1., 1., 1., 273.15);
    close_dataset(out);
  }



  void
  write_universal_nodes(std::ostream                             &out,
                        const std::vector<unsigned int>          &nodes,
                        const std::vector<std::array<double, 3>> &places)
  {
    open_dataset(out, 15);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      out << print("%10u%10d%10d%10d%13.5E%13.5E%13.5E\n",
                   nodes[i],
                   0,
                   0,
                   1,
                   places[i][0],
                   places[i][1],
                   places[i][2]);
    close_dataset(out);
  }



  void
  write_universal_function(std::ostream &out, const UniversalFunction &f)
  {
    const std::size_t n     = f.frequencies.size();
    const double      first = f.frequencies.front();
    open_dataset(out, 58);
    out << title_line(f.titles[0]) << title_line(f.titles[1]) << title_line("")
        << title_line("") << title_line("");
    // Function 4: frequency response. Load case 0: one excitation.
    out << print("%5d%10d%5d%10d %-10.10s%10u%4d %-10.10s%10u%4d\n",
                 4,
                 0,
                 0,
                 0,
                 f.response.name.c_str(),
                 f.response.node,
                 f.response.direction,
                 f.reference.name.c_str(),
                 f.reference.node,
                 f.reference.direction);
    // Ordinate 6: complex, double precision.
    out << print("%10d%10zu%10d%13.5E%13.5E%13.5E\n",
                 6,
                 n,
                 f.evenly ? 1 : 0,
                 f.evenly ? first : 0.,
                 f.evenly && n > 1 ? (f.frequencies.back() - first) / (n - 1)
                                   : 0.,
                 0.);
    out << axis_line(18, 0, 0, "Frequency", "Hz")
        << axis_line(static_cast<int>(f.quantity),
                     1,
                     0,
                     quantity_label(f.quantity),
                     quantity_unit(f.quantity))
        << axis_line(13, 0, 1, "Force", "N")
        << axis_line(0, 0, 0, "NONE", "NONE");
    NumberLines lines(out, "%20.12E", 4);
    for (std::size_t i = 0; i < n; ++i)
      {
        if (!f.evenly)
          {
            lines.end();
            out << print("%13.5E", f.frequencies[i]);
          }
        lines.add(f.values[i].real());
        lines.add(f.values[i].imag());
      }
    lines.end();
    close_dataset(out);
  }



  void
  write_universal_shape(std::ostream &out, const UniversalShape &shape)
  {
    open_dataset(out, 55);
    out << title_line(shape.title) << title_line("") << title_line("")
        << title_line("") << title_line("");
    // Structural model, complex eigenvalue of second order, translations,
    // displacement, complex, three values a node.
    out << print("%10d%10d%10d%10d%10d%10d\n", 1, 7, 2, 8, 5, 3)
        << print("%10d%10d%10d%10u\n", 2, 6, 1, shape.number);
    NumberLines lines(out, "%13.5E", 6);
    for (const double value :
         {shape.eigenvalue.real(), shape.eigenvalue.imag(), 0., 0., 0., 0.})
      lines.add(value);
    for (std::size_t i = 0; i < shape.nodes.size(); ++i)
      {
        out << print("%10u\n", shape.nodes[i]);
        for (const auto &value : shape.values[i])
          {
            lines.add(value.real());
            lines.add(value.imag());
          }
      }
    close_dataset(out);
  }
} // namespace squeal
