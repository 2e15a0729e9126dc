// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_axis_h
#define squeal_results_axis_h

#include <optional>
#include <string>
#include <vector>

namespace squeal
{
  /** What the caller wants of an axis; the rest follows from the data. */
  struct AxisSettings
  {
    enum class Scale
    {
      linear,
      logarithmic,
      /** asinh(value / linear_width): decades on both sides of zero */
      signed_logarithmic
    };

    /** A named place instead of a number. */
    struct Mark
    {
      double      value;
      std::string text;
      bool        highlighted = false;
    };

    std::string           label; /**< with the unit: "frequency in kHz" */
    Scale                 scale        = Scale::linear;
    double                linear_width = 1.; /**< of signed_logarithmic */
    std::optional<double> lower;             /**< else from the data */
    std::optional<double> upper;
    std::vector<Mark>     marks; /**< if given, they replace the ticks */
  };

  /**
   * Maps values to positions 0 (lower or left end) to 1 and chooses the range
   * and ticks a person would: round numbers, powers of ten, few labels.
   */
  class Axis
  {
  public:
    struct Tick
    {
      double      position;
      std::string text; /**< "" for a minor tick */
      bool        highlighted = false;
    };

    /** @p values are all that must be in sight, in any order; what is not
     * finite (or not positive on a logarithmic axis) is ignored. */
    Axis(const AxisSettings &settings, const std::vector<double> &values);

    /** Position of @p value, outside [0, 1] beyond the ends; NaN for what a
     * logarithmic axis does not have. */
    double position(double value) const;

    bool contains(double value) const;

    /** By position. Each major tick carries its text. */
    const std::vector<Tick> &ticks() const;

  private:
    double transformed(double value) const;
    void   choose_range(const std::vector<double> &values);
    void   add_tick(double             value,
                    const std::string &text,
                    bool               highlighted = false);
    void   add_linear_ticks();
    void   add_logarithmic_ticks();
    void   add_signed_ticks();

    AxisSettings      settings;
    double            lower = 0.;
    double            upper = 1.;
    std::vector<Tick> tick_list;
  };

  /** @p value for a reader: "−0.25" with a real minus sign, at most @p
   * n_decimals decimals. */
  std::string plain_number(double value, int n_decimals);

  /** "10⁻⁸". */
  std::string power_of_ten(int exponent);
} // namespace squeal

#endif
