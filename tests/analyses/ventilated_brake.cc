// SPDX-License-Identifier: LGPL-2.1-or-later

// Two pads on a ventilated disc, from a mesh file: the spectrum stays when the
// brake is mirrored with its turning, turned about the disc's axis or stood on
// its head, and changes when the friction of one of the pads is turned round
// or the brake is mirrored alone.

#include <squeal/analyses/analyses.h>

#include <deal.II/base/mpi.h>

#include <Eigen/Geometry>

#include <complex>
#include <sstream>

#include "analyses/ventilated_brake_mesh.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string scene_folder;

  /** Writes the mesh with every node x at R x. */
  void
  place_mesh(const std::string &file, const Eigen::Matrix3d &R)
  {
    std::ifstream      in("brake.msh");
    std::ostringstream out;
    out.precision(17);
    bool is_node = false;
    for (std::string line; std::getline(in, line);)
      {
        if (line[0] == '$')
          is_node = line == "$Nodes";
        std::istringstream words(line);
        int                number;
        Eigen::Vector3d    x;
        if (is_node && words >> number >> x[0] >> x[1] >> x[2])
          out << number << ' ' << (R * x).transpose() << '\n';
        else
          out << line << '\n';
      }
    write_text(file, out.str());
  }

  struct Options
  {
    Eigen::Matrix3d R        = Eigen::Matrix3d::Identity();
    double          mu_lower = .4, mu_upper = .4;
    bool            turns_back = false; /**< axis along -z */
  };

  /** lambda of every pair of the brake, ascending in frequency. */
  Eigen::VectorXcd
  spectrum(const Options &o)
  {
    place_mesh("placed.msh", o.R);
    std::vector<std::string> settings = {
      "Discretization/Degree = 1",
      "Discretization/Estimate error = false",
      "Eigenvalues/Lowest frequency = 100",
      "Eigenvalues/Highest frequency = 9000",
      "Eigenvalues/Residual tolerance = 1e-10",
      "Eigenvalues/Error tolerance = 1e-11",
      "Scene/Contact lower/Friction coefficient = " +
        std::to_string(o.mu_lower),
      "Scene/Contact upper/Friction coefficient = " +
        std::to_string(o.mu_upper),
      std::string("Scene/Body disc/Rotation axis = 0, 0, ") +
        (o.turns_back ? "-1" : "1"),
      "Overwrite = true",
      "Output directory = out",
      "Output/Shapes = none",
      "Output/Plots = false",
      "Output/Report = false"};
    const std::string mesh = std::filesystem::absolute("placed.msh").string();
    for (const std::string body : {"disc", "pad_lower", "pad_upper"})
      settings.push_back("Scene/Body " + body + "/Mesh file = " + mesh);
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

  /** Largest distance of two spectra, relative, pair by pair. */
  double
  difference(const Eigen::VectorXcd &a, const Eigen::VectorXcd &b)
  {
    Worst worst;
    for (Eigen::Index i = 0; i < std::min(a.size(), b.size()); ++i)
      worst.add((b.array() - a[i]).abs().minCoeff<Eigen::PropagateNaN>() /
                std::abs(a[i]));
    return worst.largest();
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check(argc == 3, "usage: ventilated_brake PYTHON FOLDER_OF_THE_SCENE");
  scene_folder = argv[2];
  make_coarse_brake(argv[1], scene_folder);
  const Eigen::VectorXcd as_it_is = spectrum({});
  check(as_it_is.size() > 15, "a spectrum");
  check((as_it_is.real().array() > 1.).any(), "friction makes a pair grow");

  const auto same = [&](const Options &o, const std::string &claim) {
    const Eigen::VectorXcd other = spectrum(o);
    const double           d     = difference(as_it_is, other);
    std::cout << "        " << claim << ": " << d << std::endl;
    check(other.size() == as_it_is.size() && d <= 1e-9, claim + " stays");
  };
  const auto differs = [&](const Options &o, const std::string &claim) {
    const double d = difference(as_it_is, spectrum(o));
    std::cout << "        " << claim << ": " << d << std::endl;
    check(d > 1e-5, claim + " is another brake");
  };
  const Eigen::Matrix3d mirror =
    Eigen::Vector3d(-1., 1., 1.).asDiagonal().toDenseMatrix();
  Options o;
  o.R          = mirror;
  o.turns_back = true;
  same(o, "mirrored with its turning");
  differs({mirror, .4, .4, false}, "mirrored alone");
  o   = {};
  o.R = Eigen::AngleAxisd(.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  same(o, "turned about its axis");
  o.R = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  o.turns_back = true;
  same(o, "stood on its head");
  same({Eigen::Matrix3d::Identity(), -.4, -.4, true},
       "negative friction against the other turning");
  differs({Eigen::Matrix3d::Identity(), .4, -.4, false},
          "friction turned round at one pad");
}
