// SPDX-License-Identifier: LGPL-2.1-or-later

// The exported matrices are the ones that were solved: those of two degrees of
// freedom in closed form; the exported pairs of a brake solve the exported
// problem; imported again they have the same eigenvalues.

#include <squeal/analyses/analyses.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>

#include <deal.II/base/mpi.h>

#include <squeal/scene/matrix_import.h>

#include <Eigen/SparseCore>
#include <nlohmann/json.hpp>

#include <complex>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "check.h"
#include "source_directory.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;
using Complex = std::complex<double>;
using Sparse  = Eigen::SparseMatrix<double>;

namespace
{
  bool is_root;

  std::string
  number(const double value)
  {
    std::ostringstream text;
    text << value;
    return text.str();
  }

  const std::vector<std::string> quiet = {"Overwrite = true",
                                          "Output/Shapes = none",
                                          "Output/Plots = false",
                                          "Output/Report = false"};

  void
  run(const std::string       &file,
      std::vector<std::string> overrides,
      const std::string       &directory)
  {
    overrides.insert(overrides.end(), quiet.begin(), quiet.end());
    overrides.push_back("Output directory = " + directory);
    Parameters parameters = read_parameters(file, overrides);
    // Those of the file are about its own parameters.
    parameters.result_checks.clear();
    parameters.check();
    RunContext context(parameters, is_root);
    switch (parameters.analysis)
      {
      case Parameters::Analysis::modes:
        run_modes(context);
        break;
      case Parameters::Analysis::cea:
        run_cea(context);
        break;
      case Parameters::Analysis::sweep:
        run_sweep(context);
        break;
      case Parameters::Analysis::work_precision:
        run_work_precision(context);
        break;
      default:
        check(false, "an analysis that exports matrices");
      }
    MPI_Barrier(MPI_COMM_WORLD);
  }

  Sparse
  read(const std::string &file)
  {
    MatrixPartParameters part;
    part.file = file;
    part.role = MatrixPartParameters::Role::friction;
    part.name = file;
    const ImportedMatrix                matrix = read_matrix(part);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t k = 0; k < matrix.values.size(); ++k)
      entries.emplace_back(matrix.rows[k], matrix.columns[k], matrix.values[k]);
    Sparse result(matrix.n, matrix.n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Eigen::MatrixXcd
  read_full(const std::string &file)
  {
    std::ifstream in(file);
    std::string   line;
    std::getline(in, line);
    check(line == "%%MatrixMarket matrix array complex general", file);
    std::getline(in, line);
    Eigen::Index n_rows, n_columns;
    in >> n_rows >> n_columns;
    Eigen::MatrixXcd result(n_rows, n_columns);
    for (Eigen::Index k = 0; k < result.size(); ++k)
      {
        double re, im;
        check(bool(in >> re >> im), file + " is complete");
        result.data()[k] = {re, im};
      }
    return result;
  }

  std::string
  first_line(const std::string &file)
  {
    const std::string text = read_file(file);
    return text.substr(0, text.find('\n'));
  }

  Eigen::VectorXcd
  eigenvalues(const std::string &directory)
  {
    const Table      table = read_csv(directory + "/eigenvalues.csv");
    Eigen::VectorXcd lambda(table.n_rows());
    for (std::size_t i = 0; i < table.n_rows(); ++i)
      lambda[i] = {table.real(i, "sigma_per_s"),
                   2. * M_PI * table.real(i, "frequency_hz")};
    return lambda;
  }

  void
  check_equal(const Eigen::VectorXcd &a,
              const Eigen::VectorXcd &b,
              const double            tolerance,
              const std::string      &text)
  {
    check(a.size() == b.size() && a.size() > 0,
          text + ": " + std::to_string(a.size()) + " pairs and as many");
    Worst worst;
    for (Eigen::Index i = 0; i < a.size(); ++i)
      worst.add((b.array() - a[i]).abs().minCoeff<Eigen::PropagateNaN>() /
                std::abs(a[i]));
    check(worst.largest() <= tolerance,
          text + ": " + std::to_string(worst.largest() * 1e9) + "e-9");
  }

  Eigen::VectorXcd
  undamped(const std::string &directory)
  {
    const auto f = read_csv(directory + "/modes.csv").reals("frequency_hz");
    return Eigen::Map<const Eigen::VectorXd>(f.data(), f.size())
      .cast<Complex>();
  }



  /** prm/minimal/hoffmann.prm at mu = 1 in the unknowns y, z: the belt drags
   * the mass along -k_yz; here with damping and with a loss factor. */
  void
  test_two_unknowns()
  {
    const std::string file = SQUEAL_SOURCE_DIR "/prm/minimal/hoffmann.prm";
    run(file,
        {"Output/Export matrices = true",
         "Scene/Damping/Model = whole model",
         "Scene/Damping/Mass damping = 0.01",
         "Scene/Damping/Stiffness damping = 0.002"},
        "hoffmann");
    if (is_root)
      {
        Eigen::Matrix2d K;
        K << 2., 1. / 3., -1., 2.;
        const Eigen::Matrix2d C = .01 * Eigen::Matrix2d::Identity() + .002 * K;
        const std::string     folder = "hoffmann/matrices/";
        const auto            close  = [&](const std::string     &name,
                               const Eigen::Matrix2d &expected) {
          check((Eigen::MatrixXd(read(folder + name)) - expected).norm() <=
                  1e-15,
                "two unknowns: " + name);
        };
        close("mass.mtx", Eigen::Matrix2d::Identity());
        close("damping.mtx", C);
        close("stiffness.mtx", K);
        check(first_line(folder + "mass.mtx") ==
                "%%MatrixMarket matrix coordinate real symmetric",
              "the mass is symmetric");
        check(first_line(folder + "stiffness.mtx") ==
                "%%MatrixMarket matrix coordinate real general",
              "the stiffness is not");
      }
    run(file,
        {"Output/Export matrices = true",
         "Scene/Damping/Model = whole model",
         "Scene/Damping/Structural damping = 0.25"},
        "loss_factor");
    if (!is_root)
      return;
    const std::string text = read_file("loss_factor/matrices/stiffness.mtx");
    check(text.find("coordinate complex general") != std::string::npos &&
            text.find("\n2 2 4\n1 1 2 0.5\n") != std::string::npos,
          "K (1 + i eta) is complex");
    check(!std::filesystem::exists("loss_factor/matrices/scene.prm"),
          "no scene of kind matrices with a complex stiffness");
  }



  /** The sums of the parts by the coefficients of the index. */
  void
  check_parts(const std::string &folder,
              const Sparse      &M,
              const Sparse      &C,
              const Sparse      &K)
  {
    const auto index = nlohmann::json::parse(read_file(folder + "index.json"));
    check(index.at("unknowns") == M.rows(), "the index has the unknowns");
    Sparse mass(M.rows(), M.rows()), damping = mass, stiffness = mass;
    for (const auto &part : index.at("parts"))
      {
        check(part.at("mass") != 0. || part.at("damping") != 0. ||
                part.at("stiffness") != 0.,
              "every part of the index counts");
        const Sparse A = read(folder + part.at("file").get<std::string>());
        mass += part.at("mass").get<double>() * A;
        damping += part.at("damping").get<double>() * A;
        stiffness += part.at("stiffness").get<double>() * A;
      }
    check(index.at("parts").size() > 5, "parts");
    const auto close = [](const Sparse &a, const Sparse &b, const char *name) {
      check(b.norm() > 0. && Sparse(a - b).norm() <= 1e-14 * b.norm(),
            std::string("the parts add up to ") + name);
    };
    close(mass, M, "M");
    close(damping, C, "C");
    close(stiffness, K, "K");
  }

  void
  check_pairs(const std::string &directory)
  {
    const std::string folder      = directory + "/matrices/";
    const Sparse      M           = read(folder + "mass.mtx"),
                 C                = read(folder + "damping.mtx"),
                 K                = read(folder + "stiffness.mtx");
    const Eigen::VectorXcd lambda = read_full(folder + "eigenvalues.mtx");
    const Eigen::MatrixXcd X      = read_full(folder + "right_vectors.mtx");
    check_equal(lambda, eigenvalues(directory), 1e-14, "exported eigenvalues");
    const Eigen::MatrixXcd Mx = M * X, Cx = C * X, Kx = K * X;
    // Where springs are stiff, K x is the small difference of large terms: the
    // two evaluations, here by entries and there by parts, round differently.
    const Eigen::MatrixXd K_rounded = K.cwiseAbs() * X.cwiseAbs();
    const Table           table     = read_csv(directory + "/eigenvalues.csv");
    for (Eigen::Index i = 0; i < lambda.size(); ++i)
      {
        const Complex l     = lambda[i];
        const double  scale = std::norm(l) * Mx.col(i).norm() +
                             std::abs(l) * Cx.col(i).norm() + Kx.col(i).norm();
        const double residual =
          (l * l * Mx.col(i) + l * Cx.col(i) + Kx.col(i)).norm() / scale;
        const double rounding = std::numeric_limits<double>::epsilon() *
                                K_rounded.col(i).norm() / scale;
        check(std::abs(residual - table.real(i, "residual_rel")) <=
                1e-3 * residual + rounding,
              "residual of the exported pair " + std::to_string(i + 1) + ": " +
                number(residual) + ", of the solved one " +
                number(table.real(i, "residual_rel")) + ", rounding " +
                number(rounding));
      }
    check_parts(folder, M, C, K);
  }

  const std::vector<std::string> small_brake = {
    "Discretization/Degree = 2",
    "Discretization/Estimate error = false",
    "Scene/Body disc/Cells = 16, 3, 1",
    "Scene/Body pad/Cells = 2, 2, 2",
    "Scene/Body support/Cells = 2, 2, 4",
    "Eigenvalues/Lowest frequency = 900",
    "Eigenvalues/Highest frequency = 6000",
    "Eigenvalues/Error tolerance = 1e-11",
    "Output/Export matrices = true"};

  void
  test_brake(const std::string              &directory,
             const std::vector<std::string> &changes)
  {
    std::vector<std::string> overrides = small_brake;
    overrides.push_back("Analysis = cea");
    overrides.insert(overrides.end(), changes.begin(), changes.end());
    run(
      SQUEAL_SOURCE_DIR "/prm/tribobrake/calibrated.prm", overrides, directory);
    if (is_root)
      {
        check_pairs(directory);
        std::ofstream(directory + "_again.prm")
          << "include " << directory << "/matrices/scene.prm\n"
          << "set Analysis = cea\nsubsection Eigenvalues\n"
          << "  set Lowest frequency = 900\n  set Highest frequency = 6000\n"
          << "  set Error tolerance = 1e-11\nend\n";
      }
    MPI_Barrier(MPI_COMM_WORLD);
    run(directory + "_again.prm", {}, directory + "_again");
    if (!is_root)
      return;
    check_equal(eigenvalues(directory + "_again"),
                eigenvalues(directory),
                1e-9,
                directory + " imported again");
    check_equal(undamped(directory + "_again"),
                undamped(directory),
                1e-9,
                directory + " imported again: undamped modes");
  }

  /** The exported scene at half the coefficient is the scene at half the
   * coefficient: damping by friction follows. */
  void
  test_half_friction(const std::string              &directory,
                     const std::vector<std::string> &damping)
  {
    const std::string file = SQUEAL_SOURCE_DIR "/prm/minimal/hoffmann.prm";
    const auto        run_hoffmann = [&](const std::string &own,
                                  const std::string &change) {
      std::vector<std::string> overrides = damping;
      overrides.push_back(change);
      run(file, overrides, directory + own);
    };
    run_hoffmann("", "Output/Export matrices = true");
    run_hoffmann("_half", "Scene/Contact belt/Friction coefficient = 0.5");
    if (is_root)
      std::ofstream(directory + "_again.prm")
        << "include " << directory << "/matrices/scene.prm\n"
        << "set Analysis = cea\nsubsection Eigenvalues\n"
        << "  set Highest frequency = 0.5\nend\n";
    MPI_Barrier(MPI_COMM_WORLD);
    run(directory + "_again.prm",
        {"Scene/Friction coefficient = 0.5"},
        directory + "_half_again");
    if (is_root)
      check_equal(eigenvalues(directory + "_half_again"),
                  eigenvalues(directory + "_half"),
                  1e-9,
                  directory + " with half of the friction");
  }

  /** Each mesh of a ladder has its stages timed and its matrices written;
   * tolerances on one mesh share them. */
  void
  test_ladder()
  {
    std::vector<std::string> overrides = small_brake;
    overrides.push_back("Analysis = work precision");
    overrides.push_back("Work precision/Quantity = eigenvalue");
    overrides.push_back("Work precision/Ladders = cells");
    overrides.push_back("Work precision/Values = 0.5, 1");
    run(
      SQUEAL_SOURCE_DIR "/prm/tribobrake/calibrated.prm", overrides, "ladder");
    overrides.push_back("Work precision/Ladders = basis");
    overrides.push_back("Work precision/Values = 1e-2, 1e-6");
    run(SQUEAL_SOURCE_DIR "/prm/tribobrake/calibrated.prm",
        overrides,
        "tolerances");
    if (!is_root)
      return;
    const Table table = read_csv("ladder/work_precision.csv");
    check(table.n_rows() == 2, "a row each");
    // 16 x 3 x 1, 2 x 2 x 2 and 2 x 2 x 4 cells of degree 2, and half of them:
    // one cell through the thickness stays.
    check(table.integer(1, "dofs") ==
            32 * 6 * 3 * 3 + 5 * 5 * 5 * 3 + 5 * 5 * 8 * 3,
          "unknowns of the mesh of the scene");
    check(table.integer(0, "dofs") ==
            16 * 4 * 3 * 3 + 3 * 3 * 3 * 3 + 3 * 3 * 4 * 3,
          "unknowns of half of the cells");
    for (unsigned int i = 0; i < 2; ++i)
      {
        const std::string folder = table.text(i, "matrices");
        const Sparse      M      = read("ladder/" + folder + "/mass.mtx");
        check(M.rows() == table.integer(i, "dofs"), folder);
        check(read_full("ladder/" + folder + "/right_vectors.mtx").cols() ==
                table.integer(i, "pairs"),
              "as many vectors as pairs");
        check(table.real(i, "residual_rel") <= 1e-8, "residuals");
        double sum = 0.;
        for (const char *stage : {"assembly", "factor", "modes", "pairs"})
          {
            const double seconds = table.real(i, std::string(stage) + "_cpu_s");
            check(seconds > 0., std::string("seconds of ") + stage);
            sum += seconds;
          }
        check(sum <= 1.001 * table.real(i, "seconds"),
              "stages are parts of the whole");
      }
    const Table other = read_csv("tolerances/work_precision.csv");
    check(other.text(0, "matrices") != other.text(1, "matrices") &&
            other.integer(0, "dofs") == table.integer(1, "dofs"),
          "rungs with as many unknowns have folders of their own");
  }

  const std::string turning = R"(subsection Scene
  set Bodies = disc, pad
  set Supports = hub, back
  set Contacts = face
  subsection Body disc
    set Shape = annulus
    set Inner radius = 0.05
    set Outer radius = 0.15
    set Height = 0.006
    set Cells = 16, 2, 1
    set Rotation speed = 100
    set Stiffness damping = 1e-6
  end
  subsection Body pad
    set Size = 0.04, 0.04, 0.01
    set Position = 0.1, 0, 0.006
    set Cells = 2, 2, 1
    set Young modulus = 1e10
    set Density = 2500
  end
  subsection Support hub
    set Body = disc
    set Face = inner
  end
  subsection Support back
    set Body = pad
    set Face = z_max
  end
  subsection Damping
    set Model = per part
  end
  subsection Contact face
    set Source body = pad
    set Source face = z_min
    set Target body = disc
    set Target face = top
    set Grid = 3, 3
    set Friction direction = slip
    set Normal stiffness = 1e7
  end
end
subsection Discretization
  set Degree = 1
end
subsection Eigenvalues
  set Highest frequency = 3000
  set Error tolerance = 1e-11
end
)";

  /** What a turning body carries of its damping is no friction: the exported
   * scene at half the coefficient is the scene at half the coefficient. */
  void
  test_carried_damping()
  {
    const std::string mu = "Scene/Contact face/Friction coefficient = ";
    if (is_root)
      {
        std::ofstream("carried.prm") << turning;
        std::ofstream("carried_again.prm")
          << "include carried/matrices/scene.prm\nset Analysis = cea\n"
          << "subsection Scene\n  set Friction coefficient = 0.5\nend\n"
          << "subsection Eigenvalues\n  set Highest frequency = 3000\n"
          << "  set Error tolerance = 1e-11\nend\n";
      }
    MPI_Barrier(MPI_COMM_WORLD);
    run("carried.prm",
        {"Analysis = cea", "Output/Export matrices = true", mu + "0.5"},
        "carried");
    run("carried.prm", {"Analysis = cea", mu + "0.25"}, "carried_half");
    run("carried_again.prm", {}, "carried_again");
    if (is_root)
      check_equal(eigenvalues("carried_again"),
                  eigenvalues("carried_half"),
                  1e-9,
                  "damping that a turning body carries, at half the friction");
  }

  void
  test_modes()
  {
    run(SQUEAL_SOURCE_DIR "/prm/minimal/hoffmann.prm",
        {"Analysis = modes", "Output/Export matrices = true"},
        "modes");
    if (!is_root)
      return;
    check(read("modes/matrices/stiffness.mtx").nonZeros() == 4,
          "the analysis modes exports, friction included");
    check(!std::filesystem::exists("modes/matrices/right_vectors.mtx"),
          "no complex pairs without their analysis");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  is_root = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  test_two_unknowns();
  test_half_friction("whole",
                     {"Scene/Damping/Model = whole model",
                      "Scene/Damping/Mass damping = 0.01",
                      "Scene/Damping/Stiffness damping = 0.02",
                      "Scene/Spring horizontal/Dashpot = 0.03"});
  // Sliding at 45 degrees to the plane y, z of the motion has a part across.
  test_half_friction("parts",
                     {"Scene/Damping/Model = per part",
                      "Scene/Body mass/Mass damping = 0.01",
                      "Scene/Spring horizontal/Stiffness damping = 0.02",
                      "Scene/Contact belt/Stiffness damping = 0.05",
                      "Scene/Contact belt/Friction direction = given",
                      "Scene/Contact belt/Sliding direction = 1, 1, 0",
                      "Scene/Contact belt/Transverse slip term = true",
                      "Scene/Contact belt/Sliding speed = 1",
                      "Scene/Contact belt/Normal force = 0.1",
                      "Scene/Contact belt/Friction slope = -0.02"});
  test_brake("brake", {});
  // A turning disc: C has a skew part; dampers only at single parts.
  test_brake("turning",
             {"Scene/Body disc/Rotation speed = 50",
              "Scene/Damping/Model = per part",
              "Scene/Damping/Mass damping = 0",
              "Scene/Damping/Stiffness damping = 0",
              "Scene/Body pad/Stiffness damping = 1e-7",
              "Scene/Spring lower_left/Dashpot = 20"});
  test_ladder();
  if (dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
    test_carried_damping();
  test_modes();
  return 0;
}
