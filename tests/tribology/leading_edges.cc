// SPDX-License-Identifier: LGPL-2.1-or-later

// Where the disc enters under a pad, from the history to the correlation: each
// damage table tells its own sliding direction, shared causes follow it
// whatever the axis, and an edge that contradicts it is refused. Argument: the
// program.
#include "../analyses/program.h"

#include <squeal/base/exceptions.h>
#include <squeal/results/contact_history.h>
#include <squeal/results/hdf5_file.h>
#include <squeal/results/table.h>
#include <squeal/tribology/statistics/pad_tables.h>

#include <nlohmann/json.hpp>

#include <cmath>

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;

namespace
{
  std::string program;

  constexpr std::size_t n_x = 8, n_y = 6;

  struct Edge
  {
    LeadingEdge           edge;
    std::array<double, 2> sliding;
    std::string           name;
  };

  const std::vector<Edge> edges = {
    {LeadingEdge::lowest_y, {{0., 1.}}, "lowest y"},
    {LeadingEdge::highest_y, {{0., -1.}}, "highest y"},
    {LeadingEdge::lowest_x, {{1., 0.}}, "lowest x"},
    {LeadingEdge::highest_x, {{-1., 0.}}, "highest x"}};

  /** Cells of a pad between a node and @p edge, and all along that way. */
  std::array<std::size_t, 2>
  way_from(const LeadingEdge edge, const std::size_t i, const std::size_t j)
  {
    return edge == LeadingEdge::lowest_y    ? std::array{j, n_y}
           : edge == LeadingEdge::highest_y ? std::array{n_y - 1 - j, n_y}
           : edge == LeadingEdge::lowest_x  ? std::array{i, n_x}
                                            : std::array{n_x - 1 - i, n_x};
  }

  /** Tables of a pad whose index and feature decay over 15 % of it from
   * @p edge on. @p header and @p values: more columns of the damage. */
  void
  write_pad(const std::string                             &start,
            const LeadingEdge                              edge,
            const std::string                             &header,
            const std::function<std::string(std::size_t)> &values)
  {
    std::ofstream damage(start + "damage.csv"),
      features(start + "features.csv");
    damage << "node,x_m,y_m,area_m2,index" << header << "\n";
    features << "x_m,y_m,feature\n";
    damage.precision(17);
    features.precision(17);
    for (std::size_t j = 0; j < n_y; ++j)
      for (std::size_t i = 0; i < n_x; ++i)
        {
          const auto [step, all] = way_from(edge, i, j);
          const double decay     = std::exp(-double(step) / (.15 * all));
          const double x = 1e-3 * i, y = 1e-3 * j;
          damage << i + n_x * j << "," << x << "," << y << ",1e-6," << decay
                 << values(i + n_x * j) << "\n";
          features << x << "," << y << "," << decay << "\n";
        }
  }

  void
  write_pad(const std::string           &start,
            const LeadingEdge            edge,
            const std::array<double, 2> &sliding)
  {
    write_pad(start, edge, ",sliding_x,sliding_y", [&](const std::size_t) {
      return "," + std::to_string(sliding[0]) + "," +
             std::to_string(sliding[1]);
    });
  }

  CorrelationParameters
  parameters_of(const std::vector<std::string> &starts,
                const LeadingEdge               wanted = LeadingEdge::automatic)
  {
    CorrelationParameters p;
    for (const std::string &start : starts)
      {
        p.damage_tables.push_back(start + "damage.csv");
        p.feature_tables.push_back(start + "features.csv");
      }
    p.indices      = {"index"};
    p.features     = {"feature"};
    p.leading_edge = wanted;
    return p;
  }

  std::vector<PadMaps>
  read(const LeadingEdge wanted = LeadingEdge::automatic)
  {
    return read_pads(parameters_of({"one_"}, wanted));
  }

  bool
  has(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }



  /** The feature is the decay itself: it correlates with it by 1. */
  void
  each_pad_its_edge()
  {
    std::vector<std::string> starts;
    for (const Edge &e : edges)
      {
        starts.push_back(e.name.substr(0, 1) +
                         e.name.substr(e.name.size() - 1) + "_");
        write_pad(starts.back(), e.edge, e.sliding);
      }
    const CorrelationParameters p    = parameters_of(starts);
    const std::vector<PadMaps>  pads = read_pads(p);
    for (std::size_t i = 0; i < edges.size(); ++i)
      {
        check(pads[i].causes.leading_edge == edges[i].edge,
              "the table tells the edge " + edges[i].name);
        check(pads[i].grid->drawn_face().sliding == edges[i].sliding,
              "its pictures draw the arrow from there");
        for (const Edge &other : edges)
          {
            const double r =
              reference_links(pads[i].features.at("feature"), other.edge)
                .leading_edge;
            if (other.edge == edges[i].edge)
              check_close(r, 1., 1e-9, "a mere decay from " + other.name);
            else
              check(r < .5, "no decay from " + other.name);
          }
      }
    const std::vector<PadLink> links = link_pads(pads, p);
    check(links.size() == edges.size(), "one link a pad");
    for (const PadLink &link : links)
      {
        check_close(link.test.reference.leading_edge,
                    1.,
                    1e-9,
                    "links take the edge of their pad");
        check(link.test.reference.edge == edges[link.pad].edge,
              "and say which it is");
      }
    check(warnings_of_assumed_edges(pads, p).empty(), "nothing is assumed");
  }



  /** A pad that is turned over has the terms of its image. */
  void
  turned_causes()
  {
    const std::vector<SharedCause> all = {
      SharedCause::position, SharedCause::rim, SharedCause::edges};
    const Eigen::MatrixXd plain =
      shared_causes({n_x, n_y, {}}, all, LeadingEdge::lowest_y).values;
    const Eigen::MatrixXd over =
      shared_causes({n_x, n_y, {}}, all, LeadingEdge::highest_y).values;
    const Eigen::MatrixXd swapped =
      shared_causes({n_y, n_x, {}}, all, LeadingEdge::lowest_x).values;
    const Eigen::MatrixXd both =
      shared_causes({n_y, n_x, {}}, all, LeadingEdge::highest_x).values;
    bool are_same = true;
    for (std::size_t j = 0; j < n_y; ++j)
      for (std::size_t i = 0; i < n_x; ++i)
        {
          const Eigen::RowVectorXd row = plain.row(i + n_x * j);
          are_same = are_same && row == over.row(i + n_x * (n_y - 1 - j)) &&
                     row == swapped.row(j + n_y * i) &&
                     row == both.row(n_y - 1 - j + n_y * i);
        }
    check(are_same, "terms of shared causes follow the sliding direction");
  }



  void
  contradictions()
  {
    for (const Edge &told : edges)
      for (const Edge &wanted : edges)
        {
          write_pad("one_", told.edge, told.sliding);
          if (wanted.edge == told.edge)
            check(read(wanted.edge)[0].causes.leading_edge == told.edge,
                  "the edge of the table may be named");
          else
            check_throws<InputError>([&]() { read(wanted.edge); },
                                     "it is '" + told.name + "'",
                                     wanted.name + " contradicts " + told.name);
        }
    write_pad("one_", LeadingEdge::lowest_y, {{.8, .8}});
    check_throws<InputError>([]() { read(); },
                             "no edge leads alone",
                             "of oblique sliding the edge is to be named");
    for (const Edge &e : edges)
      if (e.sliding[0] + e.sliding[1] > 0.)
        check(read(e.edge)[0].causes.leading_edge == e.edge,
              "one of the two that lead: " + e.name);
      else
        check_throws<InputError>([&]() { read(e.edge); },
                                 "'Correlation/Leading edge' is '" + e.name,
                                 "not one that trails: " + e.name);
    write_pad("one_", LeadingEdge::lowest_y, {{0., 0.}});
    check_throws<InputError>([]() { read(); },
                             "no edge leads alone",
                             "where the disc slides all round no edge leads");
    const auto round = read(LeadingEdge::highest_x);
    check(round[0].causes.leading_edge == LeadingEdge::highest_x &&
            round[0].grid->sliding() == std::array<double, 2>{{0., 0.}},
          "one may be named, and no arrow is drawn");
  }



  /** Features of lines against the direction @p sliding, of made images or
   * others. */
  void
  write_lines(const std::string &sliding, const bool is_synthetic)
  {
    std::ofstream features("one_features.csv");
    features << "x_m,y_m,crack_along_sliding,sliding_x,sliding_y,synthetic\n";
    for (std::size_t k = 0; k < n_x * n_y; ++k)
      features << 1e-3 * (k % n_x) << "," << 1e-3 * (k / n_x) << ","
               << std::cos(double(k * k)) << "," << sliding << ","
               << is_synthetic << "\n";
  }

  /** Angles of lines and damage are against one sliding direction. */
  void
  directions_of_lines()
  {
    const auto read_lines = [](const std::vector<std::string> &names,
                               const LeadingEdge               wanted =
                                 LeadingEdge::automatic) {
      CorrelationParameters p = parameters_of({"one_"}, wanted);
      p.features              = names;
      return read_pads(p);
    };
    for (const Edge &e : edges)
      {
        write_pad("one_", e.edge, e.sliding);
        const bool        along_x = e.sliding[0] != 0.;
        const std::string same    = along_x ? "1,0" : "0,1",
                          other   = along_x ? "0,1" : "1,0";
        write_lines(same, false);
        check(read_lines({"crack_along_sliding"}).size() == 1,
              "one direction for both: " + e.name);
        const auto all = read_lines({});
        check(all[0].features.size() == 1 && !all[0].is_synthetic,
              "neither the direction nor the kind of images is a feature");
        write_lines(other, false);
        for (const auto &names :
             {std::vector<std::string>{}, {"crack_along_sliding"}})
          check_throws<InputError>([&]() { read_lines(names); },
                                   along_x ? "Sliding direction = 0'"
                                           : "Sliding direction = 90.0'",
                                   "two directions are refused: " + e.name);
      }
    // Four degrees are the same, six are not.
    write_pad("one_", LeadingEdge::lowest_y, {{0., 1.}});
    write_lines("0.0698,0.9976", false);
    check(read_lines({}).size() == 1, "directions that are nearly the same");
    write_lines("0.1045,0.9945", false);
    check_throws<InputError>([&]() { read_lines({}); },
                             "crack_along_sliding",
                             "and those that are not");
    write_pad("one_", LeadingEdge::lowest_y, "", [](std::size_t) {
      return std::string();
    });
    write_lines("1,0", false);
    check(read_lines({})[0].is_edge_assumed, "what is assumed refuses nothing");
    check_throws<InputError>([&]() { read_lines({}, LeadingEdge::highest_y); },
                             "Sliding direction = 90.0'",
                             "but an edge that is named does");
    check(read_lines({}, LeadingEdge::lowest_x).size() == 1,
          "unless the disc comes from there");
  }



  /** Tables of made images say so, and so do their verdicts. */
  void
  made_images()
  {
    write_pad("one_", LeadingEdge::lowest_y, {{0., 1.}});
    const auto verdict = [](const bool is_synthetic) {
      write_lines("0,1", is_synthetic);
      write_text("made.prm",
                 "set Analysis = correlation\nset Output directory = made\n"
                 "set Overwrite = true\nsubsection Correlation\n"
                 "  set Damage tables = one_damage.csv\n"
                 "  set Feature tables = one_features.csv\n"
                 "  set Indices = index\n  set Surrogates = 99\n"
                 "  set Bootstraps = 0\nend\n"
                 "subsection Output\n  set Plots = false\nend\n");
      const Outcome outcome = run_program({program, "made.prm"});
      check(outcome.code == 0, "correlation: " + outcome.errors);
      return read_csv("made/correlation.csv").text(0, "verdict");
    };
    check(verdict(true).find("synthetic: ") == 0,
          "a verdict on made images says so");
    check(has(text_of("made/report.html"), "made by a generator") &&
            nlohmann::json::parse(text_of("made/correlation.json"))
              .at("synthetic")
              .get<bool>(),
          "in the report and in the record as well");
    check(!has(verdict(false), "synthetic"), "one on others does not");
  }



  void
  tables_of_others()
  {
    const auto none = [](const std::size_t) { return std::string(); };
    write_pad("one_", LeadingEdge::lowest_y, "", none);
    const auto assumed = read();
    check(
      assumed[0].causes.leading_edge == LeadingEdge::lowest_y &&
        warnings_of_assumed_edges(assumed, parameters_of({"one_"})).size() == 1,
      "a table without direction: the lowest y, with a warning");
    const auto named = read(LeadingEdge::highest_x);
    check(named[0].grid->drawn_face().sliding == PlanarPoint{{-1., 0.}} &&
            warnings_of_assumed_edges(named, parameters_of({"one_"})).empty(),
          "an edge that is named is none that is assumed");
    write_pad("one_", LeadingEdge::lowest_y, ",sliding_x", [](std::size_t) {
      return std::string(",0");
    });
    check_throws<InputError>(
      []() { read(); }, "no column sliding_y", "half a direction is none");
    write_pad("one_",
              LeadingEdge::lowest_y,
              ",sliding_x,sliding_y",
              [](const std::size_t k) {
                return std::string(k < 3 ? ",0,1" : ",0,-1");
              });
    check_throws<InputError>(
      []() { read(); }, "one_damage.csv:5: sliding_y", "nor are two of them");
  }



  /** A pad of 5 x 5 nodes whose load swings most at the highest y, under a disc
   * that slides to -y. */
  void
  write_history()
  {
    HistoryLayout layout;
    layout.sliding = {{0., -1.}};
    for (unsigned int k = 0; k < 25; ++k)
      layout.points.push_back({{1e-3 * (k % 5), 1e-3 * (k / 5), 0.}});
    layout.areas.assign(25, 1e-6);
    layout.has_gap = layout.has_status = layout.has_resultants = false;
    HistorySamples s;
    for (unsigned int i = 0; i <= 40; ++i)
      {
        s.time.push_back(1e-3 * i);
        for (unsigned int k = 0; k < 25; ++k)
          {
            const double part = std::exp(-(4. - k / 5) / .75);
            const double p = 1e6 * (2. + (.2 + part) * (i % 2 == 0 ? 1. : -1.));
            s.pressure.push_back(p);
            s.traction.insert(s.traction.end(), {0., -.5 * p});
            s.slip_rate.insert(s.slip_rate.end(), {0., -2.});
          }
      }
    HistoryWriter writer("history.h5", layout);
    writer.append(s);
    writer.finish();
    std::ofstream features("features.csv");
    features << "x_m,y_m,crack_density_per_m\n";
    for (unsigned int k = 0; k < 25; ++k)
      features << 1e-3 * (k % 5) << "," << 1e-3 * (k / 5) << ","
               << std::exp(-(4. - k / 5) / .75) << "\n";
  }

  void
  from_history_to_report()
  {
    write_history();
    write_text("damage.prm",
               "set Analysis = damage\nset Output directory = damage\n"
               "set Overwrite = true\nsubsection History\n"
               "  set File = history.h5\nend\nsubsection Fatigue\n"
               "  set Exponents = 3\n  set Spectral = false\nend\n"
               "subsection Subsurface\n  set Compute = false\nend\n"
               "subsection Output\n  set Plots = false\nend\n");
    Outcome outcome = run_program({program, "damage.prm"});
    check(outcome.code == 0, "damage: " + outcome.errors);
    const Table damage = read_csv("damage/damage.csv");
    for (std::size_t k = 0; k < 25; ++k)
      check(damage.real(k, "sliding_x") == 0. &&
              damage.real(k, "sliding_y") == -1.,
            "every row of damage.csv has the direction");
    check(Hdf5File("damage/damage.h5", Hdf5File::Mode::read)
              .read("nodes/sliding_y") == std::vector<double>(25, -1.),
          "so has damage.h5");
    write_text("correlation.prm",
               "set Analysis = correlation\n"
               "set Output directory = correlation\nset Overwrite = true\n"
               "subsection Correlation\n"
               "  set Damage tables = damage/damage.csv\n"
               "  set Feature tables = features.csv\n"
               "  set Indices = damage_m3_per_s\n  set Surrogates = 99\n"
               "  set Bootstraps = 0\nend\n"
               "subsection Output\n  set Plots = false\nend\n");
    outcome = run_program({program, "correlation.prm"});
    check(outcome.code == 0, "correlation: " + outcome.errors);
    const Table links = read_csv("correlation/correlation.csv");
    check_close(links.real(0, "leading_edge_correlation"),
                1.,
                1e-3,
                "the feature decays from where the disc enters");
    check(links.text(0, "leading_edge") == "highest y", "which is said");
    check(has(text_of("correlation/report.html"),
              "at the leading edge, highest y, would reach r = 1"),
          "in the report too");
    check(links.is_missing(0, "bootstrap_lower") &&
            links.is_missing(0, "bootstrap_upper"),
          "no bootstraps, no interval");
    check(nlohmann::json::parse(text_of("correlation/correlation.json"))
            .at("links")[0]
            .at("bootstrap_interval")[0]
            .is_null(),
          "nor in the record");
    for (const auto &[entry, text] :
         {std::pair("Leading edge = lowest y", "'Correlation/Leading edge'"),
          std::pair("Bootstraps = 19", "'Correlation/Bootstraps'")})
      {
        outcome = run_program({program,
                               "correlation.prm",
                               "--set",
                               std::string("Correlation/") + entry});
        check(outcome.code == 2 && has(outcome.errors, text),
              std::string(entry) + " is refused: " + outcome.errors);
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "one argument: the program");
  program = argv[1];
  each_pad_its_edge();
  turned_causes();
  contradictions();
  tables_of_others();
  directions_of_lines();
  made_images();
  from_history_to_report();
}
