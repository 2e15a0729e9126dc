// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/parameters/checks.h>
#include <squeal/tribology/statistics/sliding_of_pad.h>

#include <cmath>
#include <optional>

namespace squeal::tribology
{
  namespace
  {
    using Direction = std::array<double, 2>;

    constexpr const char *sliding_columns[2] = {"sliding_x", "sliding_y"};

    /** Cosines to the normal of an edge: above the first it leads alone, below
     * the second it does not lead. An edge at 45 degrees is one of two. */
    constexpr double leads_alone = 0.9, leads = 0.7;

    /** Sine of the angle between directions that are the same. */
    constexpr double same_direction = 0.0872;

    /** From an edge into the pad. */
    Direction
    inwards(const LeadingEdge edge)
    {
      switch (edge)
        {
        case LeadingEdge::lowest_y:
          return {{0., 1.}};
        case LeadingEdge::highest_y:
          return {{0., -1.}};
        case LeadingEdge::lowest_x:
          return {{1., 0.}};
        case LeadingEdge::highest_x:
          return {{-1., 0.}};
        case LeadingEdge::automatic:
          break;
        }
      unknown_choice("leading edge");
    }



    /** How far @p edge leads: the cosine between its normal and @p sliding. */
    double
    lead_of(const LeadingEdge edge, const Direction &sliding)
    {
      const Direction normal = inwards(edge);
      return normal[0] * sliding[0] + normal[1] * sliding[1];
    }



    LeadingEdge
    first_edge(const Direction &sliding)
    {
      LeadingEdge first = LeadingEdge::lowest_y;
      for (const LeadingEdge edge : {LeadingEdge::highest_y,
                                     LeadingEdge::lowest_x,
                                     LeadingEdge::highest_x})
        if (lead_of(edge, sliding) > lead_of(first, sliding))
          first = edge;
      return first;
    }



    double
    component_of(const Table       &damage,
                 const std::string &file,
                 const std::string &column)
    {
      if (!damage.has_column(column))
        throw InputError("'" + file + "' has no column " + column +
                         ": 'sliding_x' and 'sliding_y' go together");
      const std::size_t index = damage.column_index(column);
      for (std::size_t row = 0; row < damage.n_rows(); ++row)
        if (damage.columns()[index].type == Table::Type::text ||
            !std::isfinite(damage.real(row, column)) ||
            damage.real(row, column) != damage.real(0, column))
          throw InputError(file + ":" + std::to_string(row + 2) + ": " +
                           column +
                           " is not the number of the rows before: it is one "
                           "component of the sliding direction of the whole "
                           "pad");
      return damage.real(0, column);
    }



    /** The direction of the table, 0, 0 for all round; nothing where it has
     * none. */
    std::optional<Direction>
    told_direction(const Table &damage, const std::string &file)
    {
      if (!damage.has_column(sliding_columns[0]) &&
          !damage.has_column(sliding_columns[1]))
        return std::nullopt;
      Direction    d{{component_of(damage, file, sliding_columns[0]),
                      component_of(damage, file, sliding_columns[1])}};
      const double length = std::hypot(d[0], d[1]);
      if (length > 0.)
        d = {{d[0] / length, d[1] / length}};
      return d;
    }



    std::string
    direction_text(const std::string &file, const Direction &d)
    {
      return "the sliding direction of '" + file + "', (" +
             rounded_text(d[0], 3) + ", " + rounded_text(d[1], 3) + ")";
    }



    /** From x towards y, from 0 to below 180: lines have no sign. */
    double
    degrees_of(const Direction &d)
    {
      const double angle = 180. / M_PI * std::atan2(d[1], d[0]);
      return angle - 180. * std::floor(angle / 180.);
    }
  } // namespace



  PadSliding
  sliding_of_pad(const Table       &damage,
                 const std::string &file,
                 const LeadingEdge  wanted)
  {
    const bool is_automatic             = wanted == LeadingEdge::automatic;
    const std::optional<Direction> told = told_direction(damage, file);
    if (!told)
      {
        const LeadingEdge edge = is_automatic ? LeadingEdge::lowest_y : wanted;
        return {inwards(edge), edge, is_automatic, false};
      }
    const LeadingEdge edge         = is_automatic ? first_edge(*told) : wanted;
    const bool        is_all_round = (*told)[0] == 0. && (*told)[1] == 0.;
    if (is_automatic && lead_of(edge, *told) < leads_alone)
      prm::refuse_entry("Correlation",
                        "Leading edge",
                        "is 'automatic', but no edge leads alone by " +
                          direction_text(file, *told) +
                          ": name the edge that features are compared with");
    if (!is_automatic && !is_all_round && lead_of(edge, *told) < leads)
      prm::refuse_entry("Correlation",
                        "Leading edge",
                        "is '" + choice_name(wanted) + "', but by " +
                          direction_text(file, *told) + ", it is '" +
                          choice_name(first_edge(*told)) +
                          "': set that, or 'automatic', which takes the edge "
                          "of each table");
    return {*told, edge, false, true};
  }



  void
  require_same_sliding(const PadSliding  &sliding,
                       const std::string &damage_file,
                       const Table       &features,
                       const std::string &feature_file)
  {
    const std::optional<Direction> of_features =
      told_direction(features, feature_file);
    const Direction &a = sliding.direction;
    if (!of_features || sliding.is_assumed || (a[0] == 0. && a[1] == 0.))
      return;
    const Direction &b         = *of_features;
    const double     sine      = std::abs(a[0] * b[1] - a[1] * b[0]);
    const bool       is_no_way = b[0] == 0. && b[1] == 0.;
    if (!is_no_way && sine <= (sliding.is_told ? same_direction : leads))
      return;
    throw InputError("'crack_along_sliding' is against " +
                     direction_text(feature_file, b) + ", and not against " +
                     direction_text(damage_file, a) +
                     ": segment the images with 'Sliding direction = " +
                     rounded_text(degrees_of(a), 3) +
                     "', or name other features in 'Features'");
  }
} // namespace squeal::tribology
