// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/tribology/damage/history_contradictions.h>
#include <squeal/tribology/fatigue/open_contact.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace squeal::tribology
{
  namespace
  {
    // Of the largest value of a history; a contact opens between two samples.
    constexpr double worth_a_line = 0.01;
    /** Mean slip rate of what sticks, of the largest one: a change of status
     * lies between two samples. */
    constexpr double least_slip = 0.05;

    /** Length of the mean of unit vectors from which they have a direction, and
     * cosine of the angle from which two directions contradict each other. */
    constexpr double one_way = 0.5, least_cosine = 0.5;

    /** Of a history that slides all round: more of its sliding points one way
     * than there can be. */
    constexpr double hardly_round = 0.9;



    /** "" where the friction takes energy. */
    std::string
    note_of_energy(const std::vector<SurfaceSums> &sums)
    {
      double      taken = 0., given = 0.;
      std::size_t n_giving = 0;
      for (const SurfaceSums &s : sums)
        {
          taken += std::max(0., s.friction_energy);
          given += std::max(0., -s.friction_energy);
          n_giving += s.friction_energy < 0.;
        }
      if (!(given > worth_a_line * taken))
        return "";
      return "the friction power is negative at " + std::to_string(n_giving) +
             " of " + std::to_string(sums.size()) +
             " nodes, as if friction drove the sliding: traction and slip rate "
             "of a face point the same way; turn the sign of one "
             "of them, or friction energy and power are wrong";
    }



    /** A line for the first pair of nodes at the same place; "" without. */
    std::string
    note_of_places(const HistoryLayout &layout)
    {
      std::vector<std::size_t> order(layout.n_nodes());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(),
                order.end(),
                [&](const std::size_t a, const std::size_t b) {
                  return std::tie(layout.points[a], a) <
                         std::tie(layout.points[b], b);
                });
      std::size_t n_double = 0;
      std::string first;
      for (std::size_t i = 1; i < order.size(); ++i)
        if (layout.points[order[i]] == layout.points[order[i - 1]])
          {
            ++n_double;
            if (first.empty())
              first = std::to_string(order[i - 1]) + " and " +
                      std::to_string(order[i]);
          }
      return n_double == 0
               ? ""
               : std::to_string(n_double) +
                   " nodes lie where another one lies, such as " + first +
                   ": each counts with its own area, so that the face is too "
                   "large where both have the whole one";
    }
  } // namespace



  HistoryContradictions::HistoryContradictions(const HistoryLayout &layout,
                                               const double         stick_speed)
    : layout(layout)
    , stick_speed(stick_speed)
  {
  }



  void
  HistoryContradictions::add(const HistorySamples &s)
  {
    n_values += s.pressure.size();
    for (std::size_t i = 0; i < s.pressure.size(); ++i)
      {
        const double p = s.pressure[i];
        n_tension += p < 0.;
        highest = std::max(highest, p);
        if (p < lowest)
          {
            lowest      = p;
            lowest_node = i % layout.n_nodes();
          }
        if (layout.has_status)
          add_status(s, i);
        if (!layout.has_slip_rate)
          add_way(s.traction[2 * i], s.traction[2 * i + 1]);
        else if (p > 0.)
          add_way(p * s.slip_rate[2 * i], p * s.slip_rate[2 * i + 1]);
      }
  }



  void
  HistoryContradictions::add_status(const HistorySamples &s,
                                    const std::size_t     i)
  {
    const auto   status = static_cast<ContactStatus>(s.status[i]);
    const double p      = s.pressure[i];
    if (status == ContactStatus::open)
      {
        n_open += p > 0.;
        highest_open = std::max(highest_open, p);
      }
    else
      {
        ++n_closed;
        n_closed_without += !(p > 0.);
      }
    if (!layout.has_slip_rate)
      return;
    const double rate = std::hypot(s.slip_rate[2 * i], s.slip_rate[2 * i + 1]);
    fastest           = std::max(fastest, rate);
    if (status == ContactStatus::stick)
      {
        ++n_stick;
        stick_rates += rate;
      }
  }



  void
  HistoryContradictions::add_way(const double x, const double y)
  {
    way_x += x;
    way_y += y;
    way_size += std::hypot(x, y);
  }



  std::string
  HistoryContradictions::note_of_direction() const
  {
    const double told = std::hypot(layout.sliding[0], layout.sliding[1]),
                 way  = std::hypot(way_x, way_y);
    if (!(told > one_way) && way > hardly_round * way_size)
      return "'nodes/sliding' has a length of " + rounded_text(told, 2) +
             ", which says that the target slides all round and that there is "
             "no leading edge, but the " +
             (layout.has_slip_rate ? "slip rates" : "tractions") +
             " point one way: it is the mean of unit directions, no speed; "
             "give one of length 1";
    // Neither counts where points slide all round or to and fro.
    if (!(told > one_way) || !(way > one_way * way_size) ||
        layout.sliding[0] * way_x + layout.sliding[1] * way_y >
          least_cosine * told * way)
      return "";
    return std::string(layout.has_slip_rate ? "the slip rates point"
                                            : "the tractions point") +
           " along (" + rounded_text(way_x / way, 2) + ", " +
           rounded_text(way_y / way, 2) +
           ") on the mean, but the target slides along (" +
           rounded_text(layout.sliding[0], 2) + ", " +
           rounded_text(layout.sliding[1], 2) +
           ") by 'nodes/sliding' (without it along y): leading and trailing "
           "edge are told by the latter; give the history its 'nodes/sliding'";
  }



  std::vector<std::string>
  HistoryContradictions::notes_of_status() const
  {
    const std::string        mend = "; mend the status, or leave it out and it "
                                    "follows from the pressure";
    std::vector<std::string> lines;
    if (highest_open > worth_a_line * highest)
      lines.push_back("the status is open in " + std::to_string(n_open) +
                      " of " + std::to_string(n_values) +
                      " values that have a pressure, up to " +
                      rounded_text(highest_open, 3) +
                      " Pa: contact time, impacts and stick-slip follow the "
                      "status, wear and pressures do not" +
                      mend);
    if (n_closed_without > worth_a_line * n_closed)
      lines.push_back(std::to_string(n_closed_without) + " of " +
                      std::to_string(n_closed) +
                      " values with a closed status have no pressure: contact "
                      "time and impacts follow the status" +
                      mend);
    if (n_stick > 0 &&
        stick_rates > n_stick * std::max(least_slip * fastest, stick_speed))
      lines.push_back("the slip rate is " +
                      rounded_text(stick_rates / n_stick, 3) +
                      " m/s on the mean of the " + std::to_string(n_stick) +
                      " values whose status is stick: stick-slip follows the "
                      "status, wear and friction power follow the slip rate; "
                      "mend one of both");
    return lines;
  }

  std::vector<std::string>
  HistoryContradictions::notes(const std::vector<SurfaceSums> &sums) const
  {
    std::vector<std::string> lines;
    if (lowest < -rest_of_none * highest)
      lines.push_back("the pressure is negative in " +
                      std::to_string(n_tension) + " values, down to " +
                      rounded_text(lowest, 3) + " Pa at node " +
                      std::to_string(lowest_node) +
                      ": compression is positive and a contact cannot pull; "
                      "they are counted as they stand");
    for (const std::string &line : notes_of_status())
      lines.push_back(line);
    if (const std::string places = note_of_places(layout); !places.empty())
      lines.push_back(places);
    if (const std::string energy = note_of_energy(sums); !energy.empty())
      lines.push_back(energy);
    if (const std::string direction = note_of_direction(); !direction.empty())
      lines.push_back(direction);
    return lines;
  }
} // namespace squeal::tribology
