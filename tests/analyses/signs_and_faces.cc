// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact faces by the program: what lies the wrong way round is refused before
// any work, springs are as stiff in all as was asked, and what is told of a
// pad does not depend on the place round the axis where it sits. Arguments: the
// program, the folder of parameter files.

#include <squeal/results/table.h>

#include <array>

#include "../contact/turned_block.h"
#include "program.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  void
  refuses(const std::string              &text,
          const std::vector<std::string> &parts,
          const std::string              &claim)
  {
    std::filesystem::remove_all("out");
    write_text("scene.prm", text);
    const Outcome o = run_program({program, "scene.prm"});
    check(o.code == 2, claim + ": " + std::to_string(o.code) + " " + o.errors);
    for (const std::string &part : parts)
      check(o.errors.find(part) != std::string::npos,
            claim + ": says '" + part + "': " + o.errors);
  }

  void
  accepts(const std::string &text, const std::string &claim)
  {
    std::filesystem::remove_all("out");
    write_text("scene.prm", text);
    const Outcome o = run_program({program, "scene.prm"});
    check(o.code == 0, claim + ": " + o.errors);
  }

  std::string
  changed(std::string                                             text,
          const std::vector<std::pair<std::string, std::string>> &changes)
  {
    for (const auto &[old, by] : changes)
      text = replaced_in(text, old, by);
    return text;
  }

  const std::string by_file = "set Shape = gmsh\n    set Mesh file = ";

  /** The small brake with its pad, or its disc as a plate, from a mesh file
   * whose nodes go through @p map. */
  template <typename Map>
  void
  write_block(const BodyParameters &block, const Map &map)
  {
    make_turned_block(block, 0.);
    std::istringstream in(text_of(block.name + ".msh"));
    std::ostringstream out;
    out.precision(17);
    bool is_node = false;
    for (std::string line; std::getline(in, line);)
      {
        if (line[0] == '$')
          is_node = line == "$Nodes";
        std::istringstream words(line);
        int                number;
        double             x, y, z;
        if (is_node && words >> number >> x >> y >> z)
          {
            const dealii::Point<3> p = map(x, y, z);
            out << number << ' ' << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
          }
        else
          out << line << '\n';
      }
    write_text(block.name + ".msh", out.str());
  }

  /** Pad of the small brake from a file. */
  std::string
  brake_with_pad(const std::string &file)
  {
    return changed(
      small_brake,
      {{"set Shape         = block\n    set Size          = 0.01, 0.01, 0.01",
        by_file + file},
       {"set Position      = 0.1, 0, 0", "set Position = 0, 0, 0"},
       {"set Cells         = 1, 1, 1\n    set Young", "set Young"}});
  }

  /** A pad on a plate from a file. */
  std::string
  brake_with_plate(const std::string &file)
  {
    return changed(
      small_brake,
      {{"set Shape         = annulus\n    set Position      = 0, "
        "0, -0.01\n    set Cells         = 8, 1, 1",
        by_file + file},
       {"set Face = inner", "set Face = x_min"},
       {"frequency = 6000", "frequency = 60000"},
       {"set Target face          = top", "set Target face          = z_max"}});
  }



  void
  faces()
  {
    const std::string below = changed(
      small_brake,
      {{"set Position      = 0.1, 0, 0", "set Position      = 0.1, 0, -0.02"},
       {"set Source face          = z_min", "set Source face          = z_max"},
       {"set Target face          = top", "set Target face          = bottom"},
       {"    set Face       = z_max", "    set Face       = z_min"}});
    accepts(small_brake, "a pad on the disc is taken");
    const Table above = read_csv("out/eigenvalues.csv");
    accepts(below, "a pad under the disc is taken");
    const Table under = read_csv("out/eigenvalues.csv");
    check(above.n_rows() == under.n_rows(), "with as many pairs");
    for (std::size_t i = 0; i < above.n_rows(); ++i)
      {
        check_close(under.real(i, "frequency_hz"),
                    above.real(i, "frequency_hz"),
                    1e-8,
                    "the frequency below is that above");
        check_close(under.real(i, "sigma_per_s"),
                    above.real(i, "sigma_per_s"),
                    1e-8,
                    "and so is the growth rate",
                    above.real(i, "frequency_hz"));
      }
    const auto pressed = [&](const std::string &scene,
                             const std::string &face,
                             const std::string &force) {
      accepts(
        changed(
          scene,
          {{"set Analysis         = cea", "set Analysis         = preload"},
           {"set Contacts = pad_disc",
            "set Contacts = pad_disc\n  set Loads = up"},
           {"  subsection Contact pad_disc",
            "  subsection Load up\n    set Body = pad\n    set Face = " + face +
              "\n    set Force = 0, 0, " + force +
              "\n  end\n  subsection Contact pad_disc"},
           {"set Grid                 = 2, 2", "set Formulation = mortar"}}),
        "steady sliding is taken");
      return read_csv("out/preload.csv");
    };
    const Table from_above = pressed(small_brake, "z_max", "-100"),
                from_below = pressed(below, "z_min", "100");
    const std::size_t last = from_above.n_rows() - 1;
    for (const char *column : {"normal_n",
                               "tangential_n",
                               "centre_y_m",
                               "leading_edge_factor",
                               "approach_m",
                               "approach_of_load_m"})
      check_close(from_below.real(last, column),
                  from_above.real(last, column),
                  1e-6,
                  std::string(column) + " of a pad under the disc");
    const BodyParameters plate =
      make_block("plate", {{.1, 0., 0.}}, {{.05, .05, .01}}, {{2, 2, 1}});
    const auto at = [](const double x, const double y, const double z) {
      return dealii::Point<3>(.1 + x, y, z - .01);
    };
    write_block(plate, at);
    accepts(brake_with_plate("plate.msh"), "a flat plate is taken");
    refuses(changed(brake_with_plate("plate.msh"),
                    {{"set Target face          = z_max",
                      "set Target face          = z_mux"}}),
            {"z_mux", "z_max"},
            "a misspelt target face of springs is refused");
    refuses(changed(brake_with_plate("plate.msh"),
                    {{"set Target face          = z_max",
                      "set Target face          = z_min"}}),
            {"pad_disc", "z_min"},
            "and one that is not where the pad is");
    write_block(plate, [&](const double x, const double y, const double z) {
      return at(x, y, z + (z > 0. ? .02 * y : 0.));
    });
    refuses(brake_with_plate("plate.msh"),
            {"pad_disc", "is not along the face", "(0, -0.02000, 0.9998)"},
            "sliding that is not along a tilted plate is refused");
    // Between the nodes of its quadratic arcs, where those of other cells meet
    // it, a face is not round by 0.1 degrees.
    refuses(R"(
set Analysis         = cea
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = drum, lining
  set Contacts = rub
  subsection Body drum
    set Shape        = annulus
    set Inner radius = 0.1
    set Outer radius = 0.112
    set Height       = 0.03
    set Cells        = 12, 1, 1
  end
  subsection Body lining
    set Shape        = annulus
    set Inner radius = 0.08
    set Outer radius = 0.1
    set Height       = 0.03
    set Cells        = 16, 1, 1
  end
  subsection Contact rub
    set Formulation        = mortar
    set Source body        = lining
    set Source face        = outer
    set Target body        = drum
    set Target face        = inner
    set Friction direction = slip
  end
end
subsection Discretization
  set Degree = 2
end
)",
            {"rub",
             "is not along the face",
             "and may be 0.057",
             "more cells round the axis"},
            "a face that is not round about the axis is refused");
    write_block(plate, [&](const double x, const double y, const double z) {
      return at(x, y, z + (z > 0. ? 10. * x * x : 0.));
    });
    refuses(brake_with_plate("plate.msh"),
            {"pad_disc", "do not look at each other", "(0.2425, 0, 0.9701)"},
            "a bent plate is refused");
  }



  /** A disc that turns slides along the pad as it turns. */
  void
  turning()
  {
    const auto brake = [](const std::string &speed,
                          const std::string &axis,
                          const std::string &mu,
                          const std::string &direction) {
      return changed(
        small_brake,
        {{"set Cells         = 8, 1, 1",
          "set Cells         = 8, 1, 1\n    set Rotation speed = " + speed +
            "\n    set Rotation axis = 0, 0, " + axis},
         {"set Friction coefficient = 0.3",
          "set Friction coefficient = " + mu +
            "\n    set Friction direction = " + direction}});
    };
    accepts(brake("300", "1", "0.3", "slip"), "turning as it slides");
    accepts(brake("-300", "1", "-0.3", "slip"), "both the other way");
    accepts(brake("-300", "-1", "0.3", "slip"), "about -z");
    accepts(brake("-300", "1", "0", "slip"), "without friction");
    for (const auto &[speed, axis, mu, direction] :
         std::vector<std::array<std::string, 4>>{
           {{"-300", "1", "0.3", "slip"}},
           {{"300", "1", "-0.3", "slip"}},
           {{"300", "-1", "0.3", "slip"}},
           {{"-300", "1", "0.3", "fixed y"}},
           {{"300",
             "1",
             "0.3",
             "given\n    set Sliding direction = 0, -1, 0"}}})
      refuses(brake(speed, axis, mu, direction),
              {"pad_disc", "Rotation speed", "the other way"},
              "a disc that turns against its sliding is refused: " + speed +
                " rad/s, axis " + axis + ", mu = " + mu + ", " + direction);
    // 300 rad/s at 0.1 m are 30 m/s: that is what terms of the slip rate need.
    const auto slipping = [&](const std::string &speed,
                              const std::string &term) {
      return brake("300",
                   "1",
                   "0.3\n    set Sliding speed = " + speed + "\n    set " +
                     term,
                   "slip");
    };
    for (const std::string term :
         {"Transverse slip term = true",
          "Friction slope = -0.001",
          "Friction law = table\n    set Friction speeds = 0, 100\n    set "
          "Friction coefficients = 0.4, 0.3"})
      {
        accepts(slipping("30", term), "the speed of turning, " + term);
        accepts(slipping("28", term), "to a tenth, " + term);
        for (const std::string speed : {"0.1126", "26", "34"})
          refuses(slipping(speed, term),
                  {"Contact pad_disc/Sliding speed", speed, "30.0", "m/s"},
                  speed + " m/s beside 30 m/s are refused, " + term);
      }
    accepts(brake("300", "1", "0.3\n    set Sliding speed = 0.1", "slip"),
            "nothing goes by the sliding speed");
    const auto sweep = [&](const std::string &mu, const std::string &values) {
      return changed(brake("300", "1", mu, "slip"), {{"= cea", "= sweep"}}) +
             "subsection Sweep\n  set Axes = mu\n  subsection Axis mu\n"
             "    set Entries = Scene/Contact pad_disc/Friction coefficient\n"
             "    set Scale = list\n    set Values = " +
             values + "\n  end\nend\n";
    };
    accepts(sweep("0.3", "0, 0.3"), "a sweep of one sense");
    refuses(sweep("0.3", "-0.3, 0.3"),
            {"Axis mu", "0.3 in the scene and -0.3"},
            "a sweep that reverses the sliding of a turning disc is refused");
    refuses(sweep("0", "0.2, 0.3"),
            {"Axis mu", "0 in the scene"},
            "and one whose scene has no sense");
  }



  void
  grids()
  {
    refuses(changed(small_brake,
                    {{"set Shape         = block\n    set Size          = "
                      "0.01, 0.01, 0.01",
                      "set Shape = cylinder\n    set Outer radius = 0.005\n"
                      "    set Height = 0.01"},
                     {"set Cells         = 1, 1, 1\n    set Young",
                      "set Cells         = 4, 1, 1\n    set Young"},
                     {"set Face       = z_max", "set Face       = top"},
                     {"set Grid                 = 2, 2",
                      "set Grid                 = 11, 11"},
                     {"set Source face          = z_min",
                      "set Source face          = bottom"}}),
            {"Spring layout", "rectangular", "quadrature"},
            "a grid on a round pin is refused");
    const BodyParameters pad =
      make_block("pad", {{.1, 0., 0.}}, {{.01, .01, .01}}, {{1, 1, 1}});
    const double c = std::cos(.5), s = std::sin(.5);
    write_block(pad, [&](const double x, const double y, const double z) {
      return dealii::Point<3>(.1 + c * x - s * y, s * x + c * y, z);
    });
    // 4 x 2.5895e8 N/m on 1e-4 m^2.
    refuses(brake_with_pad("pad.msh"),
            {"pad_disc", "0 of 4 points", "1.036e+13"},
            "a grid whose corners are beside a turned pad is refused");
    accepts(changed(brake_with_pad("pad.msh"),
                    {{"set Grid                 = 2, 2",
                      "set Spring layout = quadrature\n    set Normal "
                      "stiffness per area = 1.036e13"}}),
            "quadrature points are on any face");
  }



  /** Steady sliding of a pad at an angle round the axis: last load step. */
  Table
  preload_at(const double degrees)
  {
    const double         angle = degrees * M_PI / 180.;
    const BodyParameters pad =
      make_block("pad", {{.1, 0., 0.}}, {{.02, .012, .01}}, {{2, 2, 1}});
    const double c = std::cos(angle), s = std::sin(angle);
    write_block(pad, [&](const double x, const double y, const double z) {
      return dealii::Point<3>(c * (x + .1) - s * y, s * (x + .1) + c * y, z);
    });
    std::string text = changed(
      brake_with_pad("pad.msh"),
      {{"set Analysis         = cea", "set Analysis         = preload"},
       {"set Cells         = 8, 1, 1", "set Cells         = 12, 2, 1"},
       {"set Contacts = pad_disc", "set Contacts = pad_disc\n  set Loads = up"},
       {"set Grid                 = 2, 2",
        "set Formulation = mortar\n    set Friction direction = slip"},
       {"  subsection Contact pad_disc",
        "  subsection Load up\n    set Body = pad\n    set Face = z_max\n"
        "    set Force = 0, 0, -100\n  end\n  subsection Contact pad_disc"}});
    accepts(text, "preload at " + std::to_string(degrees) + " degrees");
    return read_csv("out/preload.csv");
  }

  void
  turned()
  {
    const Table       straight = preload_at(0.);
    const std::size_t last     = straight.n_rows() - 1;
    check_close(straight.real(last, "tangential_n"),
                0.3 * 100.,
                1e-2,
                "friction force of a pad on the x axis");
    check(std::abs(straight.real(last, "centre_y_m")) > 1e-4,
          "the centre of pressure is off the middle");
    for (const double degrees : {30., 90., 240.})
      {
        const Table turned = preload_at(degrees);
        for (const auto &[column, floor] :
             std::vector<std::pair<std::string, double>>{
               {"normal_n", 0.},
               {"tangential_n", 0.},
               {"radial_n", 30.},
               {"centre_x_m", 1e-3},
               {"centre_y_m", 1e-3},
               {"leading_edge_factor", 0.},
               {"peak_pressure_pa", 0.}})
          check_close(turned.real(last, column),
                      straight.real(last, column),
                      1e-6,
                      column + " at " + std::to_string(degrees),
                      floor);
      }
  }



  void
  contact_states(const std::string &folder)
  {
    const auto run = [&](const std::string &state) {
      const Outcome o =
        run_program({program,
                     "--set",
                     "Scene/Body beam/Cells = 2, 8, 1",
                     "--set",
                     "Scene/Body pin/Cells = 2, 2, 2",
                     "--set",
                     "Scene/Contact pin_beam/Contact state = " + state,
                     "--set",
                     "Output directory = states",
                     "--set",
                     "Overwrite = true",
                     "--set",
                     "Output/Plots = false",
                     "--set",
                     "Output/Shapes = none",
                     folder + "/pin_on_beam/cea.prm"});
      check(o.code == 0 || o.code == 4, state + " runs: " + o.errors);
      return read_csv("states/eigenvalues.csv");
    };
    for (const std::string state : {"full", "stick", "preload"})
      check(run(state).text(0, "contact_state") == state,
            "the table of eigenvalues says " + state);
    const std::string record = text_of("states/run.json");
    check(record.find("mesh error not estimated") != std::string::npos,
          "and the record that the mesh error is not estimated");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 4, "arguments: program, folder, part");
  program                = argv[1];
  const std::string part = argv[3];
  if (part == "faces")
    faces();
  else if (part == "turning")
    turning();
  else if (part == "grids")
    grids();
  else if (part == "turned")
    turned();
  else if (part == "contact_states")
    contact_states(argv[2]);
  else
    check(false, "parts are faces, turning, grids, turned, contact_states");
}
