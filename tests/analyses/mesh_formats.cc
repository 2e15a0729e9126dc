// SPDX-License-Identifier: LGPL-2.1-or-later

// Two pads on a ventilated disc have the same complex eigenvalues from a file
// of Gmsh 2.2, Gmsh 4.1, Abaqus and Nastran.

#include <squeal/analyses/analyses.h>

#include <deal.II/base/mpi.h>

#include <complex>

#include "analyses/ventilated_brake_mesh.h"
#include "scene/mesh_texts.h"
#include "scenes.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string scene_folder;

  struct Brake
  {
    std::string shape, file;
    /** What names of volumes and surfaces are in the file. */
    std::map<std::string, std::string> names;
  };

  Eigen::VectorXcd
  spectrum(const Brake &brake)
  {
    std::vector<std::string> settings = {
      "Discretization/Degree = 1",
      "Discretization/Estimate error = false",
      "Eigenvalues/Lowest frequency = 100",
      "Eigenvalues/Highest frequency = 9000",
      "Eigenvalues/Residual tolerance = 1e-10",
      "Eigenvalues/Error tolerance = 1e-11",
      "Scene/Contact lower/Friction coefficient = 0.4",
      "Scene/Contact upper/Friction coefficient = 0.4",
      "Overwrite = true",
      "Output directory = out",
      "Output/Shapes = none",
      "Output/Plots = false",
      "Output/Report = false"};
    const auto set = [&](const std::string &entry, const std::string &value) {
      settings.push_back("Scene/" + entry + " = " + value);
    };
    const auto name = [&](const std::string &gmsh) {
      const auto it = brake.names.find(gmsh);
      return it == brake.names.end() ? gmsh : it->second;
    };
    for (const std::string body : {"disc", "pad_lower", "pad_upper"})
      {
        set("Body " + body + "/Shape", brake.shape);
        set("Body " + body + "/Mesh file",
            std::filesystem::absolute(brake.file).string());
        set("Body " + body + "/Physical volume", name(body));
      }
    for (const std::string side : {"lower", "upper"})
      {
        set("Contact " + side + "/Source face", name("friction"));
        set("Contact " + side + "/Target face", name(side + "_ring"));
        set("Support back_" + side + "/Face", name("back"));
      }
    set("Support bore/Face", name("bore"));
    set("Support bolts/Face", name("bolt_holes"));
    Parameters parameters =
      read_parameters(scene_folder + "/cea.prm", settings);
    parameters.result_checks.clear(); // those of the shipped mesh
    RunContext context(parameters, true);
    run_cea(context);
    const Table      table = read_csv("out/eigenvalues.csv");
    Eigen::VectorXcd lambda(table.n_rows());
    for (std::size_t i = 0; i < table.n_rows(); ++i)
      lambda[i] = {table.real(i, "sigma_per_s"),
                   2. * M_PI * table.real(i, "frequency_hz")};
    return lambda;
  }

  /** Format 4.1 of a file with one physical group an element. */
  std::string
  gmsh_4_text(const MeshFile &file)
  {
    std::ostringstream out;
    out << std::setprecision(17)
        << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n"
        << file.surface_names.size() + file.volume_names.size() << "\n";
    for (const auto &[tag, name] : file.surface_names)
      out << "2 " << tag << " \"" << name << "\"\n";
    for (const auto &[tag, name] : file.volume_names)
      out << "3 " << tag << " \"" << name << "\"\n";
    out << "$EndPhysicalNames\n$Entities\n0 0 " << file.surface_names.size()
        << ' ' << file.volume_names.size() << "\n";
    for (const auto *names : {&file.surface_names, &file.volume_names})
      for (const auto &group : *names)
        out << group.first << " 0 0 0 1 1 1 1 " << group.first << " 0\n";
    const auto n = file.nodes.size();
    out << "$EndEntities\n$Nodes\n1 " << n << " 1 " << n << "\n3 1 0 " << n
        << "\n";
    for (std::size_t i = 0; i < n; ++i)
      out << i + 1 << "\n";
    for (const auto &x : file.nodes)
      out << x << "\n";
    out << "$EndNodes\n$Elements\n"
        << file.surface_names.size() + file.volume_names.size() << ' '
        << file.elements.size() << " 1 " << file.elements.size() << "\n";
    for (const int dimension : {2, 3})
      for (const auto &[tag, name] :
           dimension == 2 ? file.surface_names : file.volume_names)
        {
          std::ostringstream lines;
          unsigned int       count = 0;
          for (const auto &element : file.elements)
            if ((element.nodes.size() == 4) == (dimension == 2) &&
                file.groups[element.group] == std::vector<int>{tag})
              {
                ++count;
                lines << element.tag;
                for (const unsigned int v : element.nodes)
                  lines << ' ' << v + 1;
                lines << "\n";
              }
          out << dimension << ' ' << tag << (dimension == 2 ? " 3 " : " 5 ")
              << count << "\n"
              << lines.str();
        }
    out << "$EndElements\n";
    return out.str();
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check(argc == 3, "usage: mesh_formats PYTHON FOLDER_OF_THE_SCENE");
  scene_folder = argv[2];
  make_coarse_brake(argv[1], scene_folder);
  const MeshFile file = read_gmsh_file("brake.msh");
  std::ofstream("brake.4.msh") << gmsh_4_text(file);
  std::ofstream("brake.inp") << abaqus_text(file);
  std::ofstream("brake.bdf") << nastran_text(file, Format::free);
  std::map<std::string, std::string> numbers;
  for (const auto *names : {&file.surface_names, &file.volume_names})
    for (const auto &[tag, name] : *names)
      numbers[name] = std::to_string(tag);

  const Eigen::VectorXcd expected = spectrum({"gmsh", "brake.msh", {}});
  check(expected.size() > 15, "a spectrum");
  check((expected.real().array() > 1.).any(), "friction makes a pair grow");
  for (const Brake &brake : {Brake{"gmsh", "brake.4.msh", {}},
                             Brake{"abaqus", "brake.inp", {}},
                             Brake{"nastran", "brake.bdf", numbers}})
    {
      const Eigen::VectorXcd found = spectrum(brake);
      check(found.size() == expected.size(), brake.file + ": number of pairs");
      Worst worst;
      for (Eigen::Index i = 0; i < found.size(); ++i)
        worst.add(
          (expected.array() - found[i]).abs().minCoeff<Eigen::PropagateNaN>() /
          std::abs(found[i]));
      check_below(worst.largest(), 1e-10, brake.file + ": eigenvalues");
    }
}
