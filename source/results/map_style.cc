// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/results/map_style.h>
#include <squeal/results/plotter.h>

namespace squeal
{
  std::string
  sequential_palette()
  {
    return "set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', "
           "3 '#2c728e', 4 '#21918c', 5 '#28ae80', 6 '#5ec962', 7 '#addc30', "
           "8 '#fde725')";
  }

  std::string
  two_sided_palette()
  {
    return "set palette defined (-1 '#0072b2', 0 '#f7f7f7', 1 '#d55e00')";
  }

  std::string
  palette_of_kinds(const std::vector<std::string> &kinds)
  {
    const std::string n = std::to_string(kinds.size());
    std::string       colours, names;
    unsigned int      n_coloured = 0;
    for (std::size_t k = 0; k < kinds.size(); ++k)
      {
        const std::string before = k > 0 ? ", " : "";
        const std::string number = std::to_string(k);
        const bool        none   = kinds[k] == "open";
        const std::string colour =
          none ? no_value_colour()
               : in_quotes(colour_code(n_coloured++ == 0 ? Ink::blue
                                       : n_coloured == 2 ? Ink::orange
                                                         : Ink::green));
        colours += before + number + " " + colour;
        names += before + in_quotes(kinds[k]) + " " + number;
      }
    return "set palette maxcolors " + n + "\nset palette defined (" + colours +
           ")\nset cbrange [-0.5:" + n + " - 0.5]\nset cbtics (" + names + ")";
  }

  std::string
  no_value_colour()
  {
    return "'#d0d0d0'";
  }
} // namespace squeal
