// SPDX-License-Identifier: LGPL-2.1-or-later

// What a report says of the damage of one contact pair.

#include <squeal/parameters/choices.h>
#include <squeal/parameters/text.h>
#include <squeal/tribology/driver/damage_study.h>

#include <algorithm>
#include <cstdint>

namespace squeal::tribology
{
  namespace
  {
    const char *const in_a_block =
      "in a block that is free at its sides and held at its back: half-space "
      "kernels and what they lack, by finite elements. Points nearer to the "
      "rim of the face than two of the finest cells are flagged (near_edge) "
      "and left out of maxima.";

    const char *const in_a_half_space =
      "in a half-space. Points nearer to an edge than three depths are flagged "
      "(near_edge) and left out of maxima: a half-space has no edges. The "
      "deeper, the fewer nodes remain, which alone makes a step in the "
      "picture. 'Pad thickness' makes it a block.";



    /** What the cycles are of. */
    std::string
    counted_stress(const FatigueParameters &fatigue)
    {
      return fatigue.quantity == FatigueParameters::Quantity::pressure
               ? "normal stress, compression negative"
               : choice_name(fatigue.quantity);
    }



    /** Which criteria stand over limits that follow from the reference stress.
     */
    std::string
    what_is_an_index(const SubsurfaceParameters &p)
    {
      std::vector<std::string> names;
      for (const auto criterion : p.criteria)
        if (!has_limit(criterion, p))
          names.push_back(choice_name(criterion));
      if (names.empty())
        return "";
      return (names.size() == p.criteria.size()
                ? std::string(" No limit of the material was given: values are")
                : " No limit was given for " + prm::join(names, ", ") +
                    ": their values are") +
             " indices, over limits that follow from Fatigue/Reference stress "
             "as if it were the axial limit.";
    }



    std::string
    where_it_slides(const ContactGrid &grid)
    {
      const auto &[x, y] = grid.sliding();
      return x == 0. && y == 0. ? "the disc slides all round"
             : y > 0.99         ? "the leading edge is below"
                                : "the disc slides along the arrow";
    }
  } // namespace



  void
  report_damage(HtmlReport        &report,
                const Context     &context,
                const Table       &table,
                const Table       &sums,
                const DamageStudy &study,
                const DamageStudy *silent)
  {
    const TribologyParameters &p        = context.parameters;
    const bool                 is_index = p.fatigue.constants.empty();
    const std::string         &pair     = study.reader.layout().pair;
    const auto                 picture  = [&](const std::string &name) {
      return context.output.path() + "/plots/" + name + study.suffix() + ".png";
    };
    report.section("What was done" + (pair.empty() ? pair : ": " + pair));
    report.list(
      {"The history " + p.history.file + " (" +
         std::to_string(study.damage.samples) + " samples, " +
         rounded_text(study.damage.duration, 4) + " s, " +
         std::to_string(study.grid.n_nodes()) +
         " contact nodes) was counted by rainflow (ASTM E1049, residue as " +
         choice_name(p.fatigue.residue) + ") at every node.",
       is_index
         ? "No constants of the material were given: damage is an INDEX, the "
           "sum of n (S_a / " +
             rounded_text(p.fatigue.reference_stress, 4) +
             " Pa)^m. It ranks places and runs; it says nothing about life. "
             "Several slopes stand side by side since nobody has published "
             "one "
             "for brake pads."
       : p.fatigue.accumulation == FatigueParameters::Accumulation::miner
         ? "Damage is that of the given S-N curves: 1 is failure."
         : "Damage is the share of the life by the given S-N curves and the "
           "damage curves of Manson and Halford, while the history repeats "
           "over and over: 1 is failure.",
       "Per second means per second of this history; an application is " +
         rounded_text(p.fatigue.application_time, 4) + " s of it."});
    for (const DamageStudy *counted : {&study, silent})
      for (const std::string &note :
           counted ? counted->damage.notes : std::vector<std::string>())
        report.paragraph(counted->reader.path() + ": " + note + ".");
    report.section("Damage");
    report.table(sums, "Over the whole face");
    report.figure(picture("damage_maps"),
                  "Damage seen through the back of the pad; " +
                    where_it_slides(study.grid) + ".");
    report.figure(
      picture("range_mean"),
      "Range-mean matrix of the node with the largest damage of "
      "slope " +
        slope_name(p.fatigue.exponents.front()) +
        ": number of counted cycles of each range and mean of the " +
        counted_stress(p.fatigue) +
        ", both in MPa, a box for each class; white: none.",
      true);
    if (silent)
      report.figure(
        picture("ratio_maps"),
        "Squealing over silent run, node by node; grey where the silent "
        "pad does not touch.");
    if (silent)
      report.paragraph(
        "The ratio has no scale of its own: it compares with what this "
        "silent run still vibrates, which depends on its disturbance and "
        "damping. Damage grows with a power of the range, so that half the "
        "silent vibration makes the ratio of slope m 2^m times larger.");
    report.section("Surface");
    report.figure(picture("surface_maps"),
                  "What works on third-body layers and edges: friction, "
                  "separation and impacts.");
    if (!study.subsurface.empty())
      {
        report.section("Below the face");
        report.paragraph(
          "Stresses under each node from the tractions of all nodes, over "
          "the last " +
          std::to_string(subsurface_window(study.window, p.subsurface).n) +
          " samples, " +
          (study.subsurface[0].is_in_block ? in_a_block : in_a_half_space) +
          what_is_an_index(p.subsurface));
        report.figure(picture("depths"),
                      "Largest value of each criterion against depth.",
                      true);
      }
    report.section("Limits");
    report.list(
      {"Pressure at the edge of a pad is singular in theory: damage of "
       "single "
       "nodes there depends on the contact mesh. The columns 'averaged' use "
       "the stress averaged over " +
         rounded_text(1e3 * p.fatigue.averaging_length, 3) +
         " mm and may be compared between meshes finer than that.",
       "Plateau factor " + rounded_text(p.fatigue.plateau_factor, 3) +
         ": nodal pressures are multiplied by it; real contact spots carry "
         "more than the nodal mean.",
       "A spectral estimate (Dirlik) assumes a Gaussian process, which a "
       "limit "
       "cycle is not: dirlik_over_counting says how far off it is."});
    report.section("Nodes");
    report.table(
      table, "All nodes (damage" + study.suffix() + ".csv)", {}, {}, false);
  }
} // namespace squeal::tribology
