// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <squeal/scene/import_text.h>
#include <squeal/scene/modulus_table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace squeal
{
  namespace
  {
    using import::TextFile;
    using Extrapolation = BodyParameters::ModulusExtrapolation;

    enum Column
    {
      frequency,
      temperature,
      storage,
      loss,
      pressure /**< need not be there */
    };
    constexpr unsigned int                   n_columns    = 5;
    const std::array<std::string, n_columns> column_names = {
      {"frequency_Hz",
       "temperature_C",
       "storage_modulus_Pa",
       "loss_factor",
       "pressure_Pa"}};

    /** Where each column stands in a line; -1: nowhere. */
    using Positions = std::array<int, n_columns>;

    /** Six digits without zeros behind them. */
    std::string
    shown(const double value)
    {
      return prm::format_number(std::stod(rounded_text(value, 6)));
    }

    /** d log E / d log f from which on a mode could be consistent at several
     * frequencies: omega^2 rises at most like the modulus. */
    constexpr double steepest_modulus = 1.9;

    bool
    next_line(TextFile &file)
    {
      while (file.next())
        {
          const std::string_view line = import::trimmed(file.line());
          if (!line.empty() && line[0] != '#')
            return true;
        }
      return false;
    }

    Positions
    read_header(TextFile &file)
    {
      if (!next_line(file))
        file.fail("the header line is missing");
      const auto names = prm::split(std::string(file.line()), ',');
      for (const std::string &name : names)
        if (std::find(column_names.begin(), column_names.end(), name) ==
            column_names.end())
          file.fail("column " + prm::in_quotes(name) +
                    " is not known; the columns are frequency_Hz, "
                    "temperature_C, storage_modulus_Pa, loss_factor and, if "
                    "the modulus depends on it, pressure_Pa");
      Positions position;
      for (unsigned int c = 0; c < n_columns; ++c)
        {
          const auto n =
            std::count(names.begin(), names.end(), column_names[c]);
          if (n > 1)
            file.fail("column " + prm::in_quotes(column_names[c]) +
                      " is there twice");
          if (n == 0 && c != pressure)
            file.fail("column " + prm::in_quotes(column_names[c]) +
                      " is missing in the header line");
          position[c] =
            n == 0 ? -1
                   : static_cast<int>(
                       std::find(names.begin(), names.end(), column_names[c]) -
                       names.begin());
        }
      return position;
    }

    std::array<double, n_columns>
    read_row(const TextFile &file, const Positions &position)
    {
      const auto        values = prm::split(std::string(file.line()), ',');
      const std::size_t n      = n_columns - (position[pressure] < 0 ? 1 : 0);
      if (values.size() != n)
        file.fail("this line has " + std::to_string(values.size()) +
                  " values, the header " + std::to_string(n));
      std::array<double, n_columns> row;
      for (unsigned int c = 0; c < n_columns; ++c)
        row[c] = position[c] < 0 ? 0.
                                 : import::real_field(file,
                                                      values[position[c]],
                                                      column_names[c].c_str());
      if (!(row[frequency] > 0.))
        file.fail("frequency_Hz must be greater than 0");
      if (!(row[storage] > 0.))
        file.fail("storage_modulus_Pa must be greater than 0");
      if (!(row[loss] >= 0. && row[loss] <= 10.))
        file.fail("loss_factor must be from 0 to 10");
      if (!(row[temperature] >= -273.15))
        file.fail("temperature_C must be at least -273.15");
      if (!(row[pressure] >= 0.))
        file.fail("pressure_Pa must be at least 0");
      return row;
    }

    /** Slopes at the nodes of a monotone cubic (Fritsch and Carlson; inside the
     * weighted harmonic mean of the neighbouring slopes, 0 at an extremum). */
    std::vector<double>
    monotone_slopes(const std::vector<double> &x, const std::vector<double> &y)
    {
      const std::size_t   n = x.size();
      std::vector<double> secant(n - 1), slope(n, 0.);
      for (std::size_t i = 0; i + 1 < n; ++i)
        secant[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
      slope[0]     = secant[0];
      slope[n - 1] = secant[n - 2];
      for (std::size_t i = 1; i + 1 < n; ++i)
        {
          if (!(secant[i - 1] * secant[i] > 0.))
            continue;
          const double h = x[i] - x[i - 1], k = x[i + 1] - x[i];
          slope[i] = 3. * (h + k) /
                     ((2. * k + h) / secant[i - 1] + (k + 2. * h) / secant[i]);
        }
      return slope;
    }

    /** The steepest slope of the cubics between the nodes. */
    double
    steepest(const std::vector<double> &x,
             const std::vector<double> &y,
             const std::vector<double> &slope)
    {
      double result = 0.;
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        {
          // of a parabola: at the ends, or between them where it turns
          const double secant = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
          const double a = slope[i], b = slope[i + 1];
          const double curvature = a + b - 2. * secant;
          result                 = std::max({result, a, b});
          if (curvature < 0.)
            {
              const double t = (2. * a + b - 3. * secant) / (3. * curvature);
              if (t > 0. && t < 1.)
                result = std::max(result,
                                  a + t * (6. * secant - 4. * a - 2. * b) +
                                    3. * t * t * curvature);
            }
        }
      return result;
    }

    double
    cubic(const std::vector<double> &x,
          const std::vector<double> &y,
          const std::vector<double> &slope,
          const std::size_t          i,
          const double               at)
    {
      const double h = x[i + 1] - x[i], t = (at - x[i]) / h;
      // Equal values stay equal to the last digit.
      return y[i] + t * t * (3. - 2. * t) * (y[i + 1] - y[i]) +
             h * t * (1. - t) * ((1. - t) * slope[i] - t * slope[i + 1]);
    }
  } // namespace



  std::array<double, 2>
  ModulusTable::Curve::at(const double log_frequency) const
  {
    const double x   = std::clamp(log_frequency, log_f.front(), log_f.back());
    const auto above = std::upper_bound(log_f.begin() + 1, log_f.end() - 1, x);
    const std::size_t i = above - log_f.begin() - 1;
    return {
      {cubic(log_f, log_e, slope_e, i, x), cubic(log_f, eta, slope_eta, i, x)}};
  }



  namespace
  {
    /** The two of ascending @p items about @p x and the weight of the second,
     * at the ends the nearest with weight 0. */
    template <typename Item>
    std::tuple<const Item *, const Item *, double>
    about(const std::vector<Item> &items,
          const double             x,
          double Item::*const key)
    {
      if (x <= items.front().*key)
        return {&items.front(), &items.front(), 0.};
      if (x >= items.back().*key)
        return {&items.back(), &items.back(), 0.};
      const auto second = std::upper_bound(
        items.begin(), items.end(), x, [&](const double a, const Item &item) {
          return a < item.*key;
        });
      const auto first = second - 1;
      return {&*first,
              &*second,
              (x - (*first).*key) / ((*second).*key - (*first).*key)};
    }

    std::array<double, 2>
    between(const std::array<double, 2> &a,
            const std::array<double, 2> &b,
            const double                 weight)
    {
      return {{a[0] + weight * (b[0] - a[0]), a[1] + weight * (b[1] - a[1])}};
    }
  } // namespace



  std::array<double, 2>
  ModulusTable::Sheet::at(const double log_f, const double t) const
  {
    const auto [first, second, weight] = about(curves, t, &Curve::temperature);
    return weight > 0. ? between(first->at(log_f), second->at(log_f), weight)
                       : first->at(log_f);
  }



  ModulusTable::ModulusTable(const std::string &file)
    : file_name(file)
  {
    read(file);
    require_moderate_slopes();
  }

  void
  ModulusTable::require_moderate_slopes()
  {
    for (Sheet &sheet : sheets)
      for (Curve &curve : sheet.curves)
        {
          curve.slope_e   = monotone_slopes(curve.log_f, curve.log_e);
          curve.slope_eta = monotone_slopes(curve.log_f, curve.eta);
          const double steep =
            steepest(curve.log_f, curve.log_e, curve.slope_e);
          if (!(steep < steepest_modulus))
            throw InputError(
              "modulus table '" + file_name + "': at " +
              shown(curve.temperature) +
              " degrees Celsius the storage modulus rises like the power " +
              shown(steep) +
              " of the frequency; below the power 1.9 each mode has one "
              "frequency, so no table may be steeper");
        }
  }

  void
  ModulusTable::read(const std::string &name)
  {
    TextFile   file(name);
    const auto position = read_header(file);
    has_pressures       = position[pressure] >= 0;
    const auto place    = [&](const double p, const double t) {
      return (has_pressures ? shown(p) + " Pa and " : "") + shown(t) +
             " degrees Celsius";
    };
    // pressure, temperature, frequency
    std::map<double, std::map<double, std::map<double, ComplexModulus>>> rows;
    while (next_line(file))
      {
        const auto row = read_row(file, position);
        if (!rows[row[pressure]][row[temperature]]
               .emplace(row[frequency], ComplexModulus{row[storage], row[loss]})
               .second)
          file.fail("there is a row for " + shown(row[frequency]) + " Hz and " +
                    place(row[pressure], row[temperature]) + " already");
      }
    if (rows.empty())
      file.fail("the table has no rows");
    file.check_last_line_is_complete();
    for (const auto &[p, temperatures] : rows)
      {
        sheets.push_back({p, {}});
        for (const auto &[t, values] : temperatures)
          {
            if (values.size() < 2)
              file.fail("at " + place(p, t) +
                        " there is one frequency, but at least two are needed");
            Curve curve;
            curve.temperature = t;
            for (const auto &[f, modulus] : values)
              {
                curve.log_f.push_back(std::log(f));
                curve.log_e.push_back(std::log(modulus.storage));
                curve.eta.push_back(modulus.loss_factor);
              }
            sheets.back().curves.push_back(std::move(curve));
          }
      }
  }



  namespace
  {
    [[noreturn]] void
    refuse_table(const std::string &file, const std::string &text)
    {
      throw InputError("modulus table '" + file + "' " + text +
                       ": extend it, or set 'Modulus extrapolation = "
                       "constant' for its values at the nearest end");
    }
  } // namespace



  void
  ModulusTable::require_inside(const Sheet &sheet,
                               const double f,
                               const double t) const
  {
    const std::string here =
      has_pressures ? " at " + shown(sheet.pressure) + " Pa" : "";
    const auto &curves = sheet.curves;
    if (t < curves.front().temperature || t > curves.back().temperature)
      refuse_table(file_name,
                   "goes from " + shown(curves.front().temperature) + " to " +
                     shown(curves.back().temperature) + " degrees Celsius" +
                     here + ", the body has " + shown(t));
    const auto [first, second, weight] = about(curves, t, &Curve::temperature);
    const Curve &other                 = weight > 0. ? *second : *first;
    const double lowest                = std::exp(
                   std::max(first->log_f.front(), other.log_f.front())),
                 highest =
                   std::exp(std::min(first->log_f.back(), other.log_f.back()));
    if (!(f >= lowest * (1. - 1e-12) && f <= highest * (1. + 1e-12)))
      refuse_table(file_name,
                   "goes from " + shown(lowest) + " to " + shown(highest) +
                     " Hz at " + shown(t) + " degrees Celsius" + here +
                     ", but " + shown(f) + " Hz are asked for");
  }

  ComplexModulus
  ModulusTable::at(const double        f,
                   const double        t,
                   const double        p,
                   const Extrapolation extrapolation) const
  {
    const auto [first, second, weight] = about(sheets, p, &Sheet::pressure);
    if (extrapolation == Extrapolation::refused)
      {
        if (has_pressures &&
            (p < sheets.front().pressure || p > sheets.back().pressure))
          refuse_table(file_name,
                       "goes from " + shown(sheets.front().pressure) + " to " +
                         shown(sheets.back().pressure) + " Pa, the body has " +
                         shown(p));
        require_inside(*first, f, t);
        if (weight > 0.)
          require_inside(*second, f, t);
      }
    const double log_f = std::log(std::max(f, 1e-300));
    const auto [log_e, eta] =
      weight > 0. ? between(first->at(log_f, t), second->at(log_f, t), weight)
                  : first->at(log_f, t);
    return {std::exp(log_e), eta};
  }

  bool
  ModulusTable::depends_on_pressure() const
  {
    return has_pressures;
  }



  bool
  ModulusTable::depends_on_frequency() const
  {
    const auto varies = [](const std::vector<double> &values) {
      return std::any_of(values.begin(), values.end(), [&](const double x) {
        return x != values.front();
      });
    };
    for (const Sheet &sheet : sheets)
      for (const Curve &curve : sheet.curves)
        if (varies(curve.log_e) || varies(curve.eta))
          return true;
    return false;
  }
} // namespace squeal
