// SPDX-License-Identifier: LGPL-2.1-or-later
#include "dataset_55.h"

#include <cmath>
#include <map>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    void
    append(std::string &list, const std::string &text)
    {
      list += (list.empty() ? "" : ", ") + text;
    }

    /** Frequency and eigenvalue from the numbers of record 8. */
    void
    set_frequency(const int                  analysis,
                  const std::vector<double> &reals,
                  MeasuredShape             &shape)
    {
      const bool is_normal = analysis == 2;
      if (reals.size() < (is_normal ? 1u : 2u))
        return;
      if (!is_normal)
        shape.eigenvalue = {reals[0], reals[1]};
      shape.frequency = is_normal ? reals[0] : std::abs(reals[1]) / (2. * M_PI);
    }

    /** Takes a shape to the eigenvalue with the positive imaginary part, to
     * which computed shapes belong. */
    void
    take_upper_member(MeasuredShape &shape)
    {
      if (shape.eigenvalue.imag() < 0.)
        for (auto &[node, values] : shape.nodes)
          for (Complex &value : values)
            value = std::conj(value);
    }

    std::string
    name_of_values(const int specific)
    {
      static const std::map<int, const char *> names{{2, "stress"},
                                                     {3, "strain"},
                                                     {4, "forces of elements"},
                                                     {5, "temperature"},
                                                     {9, "reaction forces"}};
      const auto                               it = names.find(specific);
      return it == names.end()
               ? "specific data type " + std::to_string(specific)
               : it->second;
    }

    /** Whether values are motions, by their characteristic (2: three, 3: six
     * motions a node) and specific type (8: displacement, 11: velocity, 12:
     * acceleration). A 0, or "general" as the type, leaves it open. */
    bool
    takes_as_motions(const std::string &title,
                     const int          characteristic,
                     const int          specific,
                     OtherDatasets     &other)
    {
      const bool is_open = specific == 0 || specific == 1;
      const bool is_motion =
        specific == 8 || specific == 11 || specific == 12 || is_open;
      if (!is_motion || characteristic == 1 || characteristic > 3)
        {
          append(other.skipped,
                 "'" + title + "' (" +
                   (is_motion
                      ? "data characteristic " + std::to_string(characteristic)
                      : name_of_values(specific)) +
                   ")");
          return false;
        }
      if (is_open || characteristic == 0)
        append(other.unsaid, "'" + title + "'");
      return true;
    }
  } // namespace



  std::optional<MeasuredShape>
  read_dataset_55(UniversalLines &lines, OtherDatasets &other)
  {
    MeasuredShape shape;
    shape.name = prm::trim(lines.take("a title"));
    for (unsigned int i = 0; i < 4; ++i)
      lines.take("a title");
    const std::vector<int> kind = lines.integers(6, "the kind of the data");
    const int analysis = kind[1], data = kind[4], n_values = kind[5];
    if (!takes_as_motions(shape.name, kind[2], kind[3], other))
      {
        while (!lines.is_mark())
          lines.take("the end of dataset 55");
        lines.take("-1");
        return std::nullopt;
      }
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
    set_frequency(analysis, reals, shape);
    while (!lines.is_mark())
      {
        const int  node   = lines.integers(1, "a node")[0];
        const auto values = lines.numbers(
          n_values * (is_complex ? 2 : 1), width, n_in_line, "a displacement");
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
    take_upper_member(shape);
    return shape;
  }
} // namespace squeal
