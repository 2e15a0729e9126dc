// SPDX-License-Identifier: LGPL-2.1-or-later

// A brake from a mesh file that is turned about x, its disc across y, squeals
// as it did: steady sliding, the fields of an operating matrix in both
// directions with the names of their modes, and the edges of a sweep over
// friction. Arguments: the program and the folder of parameter files.

#include <squeal/results/table.h>

#include <fstream>
#include <sstream>

#include "program.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program, folder;

  /** The mesh of Gmsh's format 4.1 with its nodes turned: (x, y, z) becomes
   * (x, -z, y). */
  void
  write_turned_mesh(const std::string &from, const std::string &to)
  {
    std::ifstream in(from);
    std::ofstream out(to);
    bool          is_node = false;
    for (std::string line; std::getline(in, line);)
      {
        if (line[0] == '$')
          is_node = line == "$Nodes";
        std::istringstream words(line);
        std::string        x, y, z, more;
        words >> x >> y >> z >> more;
        if (is_node && !z.empty() && more.empty())
          out << x << ' ' << (z[0] == '-' ? z.substr(1) : "-" + z) << ' ' << y
              << '\n';
        else
          out << line << '\n';
      }
  }

  std::string
  replaced_all(std::string text, const std::string &old, const std::string &by)
  {
    check(text.find(old) != std::string::npos, "the test changes " + old);
    for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos;
         at += by.size())
      text.replace(at, old.size(), by);
    return text;
  }

  void
  write_scenes()
  {
    const std::string mesh  = folder + "/own_brake/brake.msh";
    std::string       scene = text_of(folder + "/own_brake/scene.prm");
    write_text("scene.prm", replaced_all(scene, "= brake.msh", "= " + mesh));
    write_turned_mesh(mesh, "turned.msh");
    for (const auto &[old, by] :
         {std::pair{"= brake.msh", "= turned.msh"},
          {"Stiffnesses = 0, 5e11, 0", "Stiffnesses = 0, 0, 5e11"},
          {"Physical volume = disc",
           "Physical volume = disc\n    set Rotation axis = 0, -1, 0"}})
      scene = replaced_all(scene, old, by);
    write_text("turned_scene.prm", scene);
  }

  /** Runs both scenes with @p more. */
  void
  run(const std::string &analysis, const std::string &more)
  {
    for (const std::string scene : {"", "turned_"})
      {
        const std::string file = scene + "run.prm";
        write_text(file,
                   "include " + scene + "scene.prm\nset Analysis = " +
                     analysis + "\nset Output directory = " + scene +
                     "out\nset Overwrite = true\n"
                     "subsection Output\n set Plots = false\n"
                     " set Report = false\n set Shapes = none\nend\n" +
                     more);
        std::filesystem::remove_all(scene + "out");
        const Outcome o = run_program({program, file});
        check(o.code == 0, scene + analysis + " runs: " + o.errors);
      }
  }

  void
  same(const std::string              &file,
       const std::vector<std::string> &columns,
       const double                    tolerance)
  {
    const Table a = read_csv("out/" + file), b = read_csv("turned_out/" + file);
    check(a.n_rows() > 0 && a.n_rows() == b.n_rows(), file + ": as many rows");
    Worst difference;
    for (std::size_t i = 0; i < a.n_rows(); ++i)
      for (const std::string &column : columns)
        {
          const double x = a.real(i, column), y = b.real(i, column);
          difference.add(std::abs(x - y) / std::max(std::abs(x), std::abs(y)),
                         column);
        }
    check(difference.largest() < tolerance, file + ": the same numbers");
  }

  void
  steady_sliding()
  {
    run("preload", "subsection Discretization\n set Degree = 1\nend\n");
    same("preload.csv",
         {"upper_normal_n",
          "upper_tangential_n",
          "lower_normal_n",
          "lower_peak_pressure_pa",
          "lower_leading_edge_factor",
          "lower_centre_along_m"},
         1e-8);
  }

  void
  matrix()
  {
    run("operating matrix",
        "subsection Discretization\n set Degree = 1\nend\n"
        "subsection Eigenvalues\n set Highest frequency = 3000\nend\n"
        "subsection Operating matrix\n set Pressures = 4e6\n"
        " set Both directions = true\nend\n");
    same("operating_matrix.csv", {"frequency_hz", "sigma_per_s"}, 1e-8);
    const Table a = read_csv("out/operating_matrix.csv"),
                b = read_csv("turned_out/operating_matrix.csv");
    for (std::size_t i = 0; i < a.n_rows(); ++i)
      check(a.text(i, "name") == b.text(i, "name") &&
              a.text(i, "name").find('(') != std::string::npos,
            "the loudest has the name of a disc: " + a.text(i, "name") + ", " +
              b.text(i, "name"));
  }

  void
  edges()
  {
    run("sweep",
        "subsection Discretization\n set Degree = 1\nend\n"
        "subsection Scene\n subsection Contact upper\n"
        "  set Contact state = full\n end\n subsection Contact lower\n"
        "  set Contact state = full\n end\nend\n"
        "subsection Eigenvalues\n set Lowest frequency = 7200\n"
        " set Highest frequency = 7700\nend\n"
        "subsection Sweep\n set Axes = mu\n set Sigma tolerance = 1e-5\n"
        "  subsection Axis mu\n"
        "  set Entries = Scene/Contact upper/Friction coefficient, "
        "Scene/Contact lower/Friction coefficient\n"
        "  set From = 0.4\n  set To = 0.6\n  set Number = 3\n end\nend\n");
    same("unstable_ranges.csv",
         {"lower", "peak_sigma_per_s", "frequency_at_peak_hz"},
         1e-7);
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc > 2, "arguments: the program and the folder of parameter files");
  program = argv[1];
  folder  = argv[2];
  write_scenes();
  steady_sliding();
  matrix();
  edges();
}
