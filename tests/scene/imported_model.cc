// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The sample model of prm/matrices is the same model in all three formats and
// has the eigenvalues that SciPy finds from its MatrixMarket files; parts that
// do not fit together are refused.
#include <squeal/base/exceptions.h>

#include <squeal/scene/imported_model.h>

#include <Eigen/Dense>

#include "../check.h"
#include "import_helpers.h"
#include "source_directory.h"

#include <complex>

using namespace squeal;
using namespace squeal::testing;
using Role = MatrixPartParameters::Role;

namespace
{
  const std::string folder = SQUEAL_SOURCE_DIR "/prm/matrices/ring_pad/";

  void
  add_part(SceneParameters   &scene,
           const std::string &name,
           const std::string &file,
           const Role         role,
           const std::string &matrix_name = "")
  {
    scene.matrix_parts.push_back(part_of(file, role, matrix_name));
    scene.matrix_parts.back().name = name;
  }

  /** The sample model from text files of one of the formats. */
  SceneParameters
  sample_scene(const std::string &format, const std::string &ring = "ring.mtx")
  {
    SceneParameters   scene;
    const std::string start = folder + format + "/";
    add_part(scene, "mass", start + "mass.mtx", Role::mass);
    add_part(scene, "ring", start + ring, Role::stiffness);
    add_part(scene, "pad", start + "pad.mtx", Role::stiffness);
    add_part(scene, "support", start + "support.mtx", Role::stiffness);
    add_part(scene, "damping", start + "damping.mtx", Role::damping);
    scene.contact_pattern_file = folder + "contact.csv";
    return scene;
  }

  SceneParameters
  sample_scene_nastran()
  {
    SceneParameters   scene   = sample_scene("market");
    const std::string names[] = {"MAAX", "KRING", "KPAD", "KSUPP", "BAAX"};
    for (unsigned int i = 0; i < 5; ++i)
      {
        scene.matrix_parts[i].file        = folder + "nastran/ring_pad.pch";
        scene.matrix_parts[i].matrix_name = names[i];
      }
    return scene;
  }

  Eigen::MatrixXd
  dense(const ImportedMatrix &matrix)
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(matrix.n, matrix.n);
    for (std::size_t k = 0; k < matrix.values.size(); ++k)
      result(matrix.rows[k], matrix.columns[k]) = matrix.values[k];
    return result;
  }

  Eigen::MatrixXd
  dense(const std::vector<ImportedContact::Row> &rows, const unsigned int n)
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows.size(), n);
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (const auto &[dof, weight] : rows[i])
        result(i, dof) = weight;
    return result;
  }

  bool
  same_model(const ImportedModel &a, const ImportedModel &b)
  {
    bool same = a.n_dofs == b.n_dofs && a.labels == b.labels &&
                a.parts.size() == b.parts.size() &&
                a.contact.normal == b.contact.normal &&
                a.contact.sliding == b.contact.sliding &&
                a.contact.transverse == b.contact.transverse;
    for (unsigned int i = 0; same && i < a.parts.size(); ++i)
      same = a.parts[i].rows == b.parts[i].rows &&
             a.parts[i].columns == b.parts[i].columns &&
             a.parts[i].values == b.parts[i].values;
    return same;
  }

  /** Largest real part and its frequency of the model with friction. */
  std::complex<double>
  most_unstable(const ImportedModel &model, const double mu)
  {
    const unsigned int    n                = model.n_dofs;
    const double          normal_stiffness = 1e7;
    const Eigen::MatrixXd normal           = dense(model.contact.normal, n);
    const Eigen::MatrixXd sliding          = dense(model.contact.sliding, n);
    const Eigen::MatrixXd K =
      dense(model.parts[1]) + dense(model.parts[2]) + dense(model.parts[3]) +
      normal_stiffness * (normal + mu * sliding).transpose() * normal;
    // In units of this frequency the blocks of A are of one size.
    const double          omega = 2. * M_PI * 5000.;
    Eigen::MatrixXd       A     = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    const Eigen::VectorXd inverse =
      dense(model.parts[0]).diagonal().cwiseInverse();
    A.topRightCorner(n, n).setIdentity();
    A.bottomLeftCorner(n, n) = -(inverse.asDiagonal() * K) / omega / omega;
    A.bottomRightCorner(n, n) =
      -(inverse.asDiagonal() * dense(model.parts[4])) / omega;
    const Eigen::VectorXcd eigenvalues =
      Eigen::EigenSolver<Eigen::MatrixXd>(A, false).eigenvalues();
    Eigen::Index i;
    eigenvalues.real().maxCoeff(&i);
    return {omega * eigenvalues(i).real(),
            omega * std::abs(eigenvalues(i).imag()) / 2. / M_PI};
  }

  void
  test_sample()
  {
    const ImportedModel abaqus  = read_imported_model(sample_scene("abaqus"));
    SceneParameters     scene   = sample_scene("market");
    scene.node_table_file       = folder + "nodes.csv";
    const ImportedModel market  = read_imported_model(scene);
    const ImportedModel nastran = read_imported_model(sample_scene_nastran());
    SceneParameters     mixed   = sample_scene("abaqus", "ring_coordinate.mtx");
    mixed.node_table_file       = folder + "nodes.csv";

    check(abaqus.n_dofs == 108 && abaqus.labels.size() == 108,
          "the sample has 108 named unknowns");
    check(same_model(abaqus, market), "Abaqus and MatrixMarket: same model");
    check(same_model(abaqus, nastran), "Abaqus and Nastran: same model");
    check(same_model(market, read_imported_model(mixed)),
          "rows with and without names are joined by the node table");

    check(market.bodies == std::vector<std::string>({"ring", "pad"}),
          "bodies come from the node table");
    check(market.positions[0] == Vector3{{0.1, 0., 0.}} &&
            market.body_of[71] == 0 && market.body_of[72] == 1,
          "positions and bodies belong to the right unknowns");
    check(abaqus.bodies == std::vector<std::string>({"model"}),
          "without a node table there is one body");

    check_close(dense(market.parts[0]).trace(),
                3 * (24 * .08 + 12 * .004),
                1e-12,
                "mass");
    Eigen::VectorXd lift = Eigen::VectorXd::Zero(108);
    for (unsigned int i = 2; i < 108; i += 3)
      lift[i] = 1.;
    check_close(lift.dot(dense(market.parts[1]) * lift),
                24 * 2e7,
                1e-8,
                "a lifted ring pulls on its ground springs alone");
    check((dense(market.contact.normal, 108) * lift).norm() < 1e-12,
          "a lifted model does not press on the contact");

    // SciPy: eig of the same matrices, read by its own mmread, and refined by
    // Newton's method on the quadratic problem with 30 digits. The tolerance
    // is what a dense eigensolver without refinement reaches.
    const std::complex<double> forward = most_unstable(market, .4);
    check_close(forward.real(), 830.1661396548668, 1e-9, "sigma, mu = 0.4");
    check_close(forward.imag(), 6087.158354616242, 1e-11, "f, mu = 0.4");
    const std::complex<double> backward = most_unstable(market, -.4);
    check_close(backward.real(), 136.4321108031825, 1e-8, "sigma, mu = -0.4");
    check_close(backward.imag(), 5813.715929298013, 1e-11, "f, mu = -0.4");
  }

  void
  test_parts()
  {
    ImportedMatrix matrix = read_matrix(
      part_of(write_text("general.txt", "1 1 1.\n1 2 3.\n2 1 -1.\n2 2 2.\n"),
              Role::friction));
    const auto sum_of = [](const Triplets &triplets) {
      EntryMap sum;
      for (std::size_t k = 0; k < triplets.values.size(); ++k)
        sum[{triplets.rows[k], triplets.columns[k]}] += triplets.values[k];
      return sum;
    };
    check(sum_of(lower_symmetric_part(matrix)) ==
            EntryMap({{{0, 0}, 1.}, {{1, 0}, 1.}, {{1, 1}, 2.}}),
          "lower symmetric part");
    check(sum_of(lower_skew_part(matrix)) == EntryMap({{{1, 0}, -2.}}),
          "lower skew part");
  }

  /** Mass and stiffness of two free points, three numbered unknowns. */
  SceneParameters
  small_scene(const std::string &mass      = "1 1 1.\n2 2 1.\n3 3 1.\n",
              const std::string &stiffness = "1 1 1.\n2 2 1.\n3 3 1.\n")
  {
    SceneParameters scene;
    add_part(scene, "M", write_text("mass.txt", mass), Role::mass);
    add_part(scene, "K", write_text("stiff.txt", stiffness), Role::stiffness);
    return scene;
  }

  void
  test_held()
  {
    SceneParameters scene =
      small_scene("1 1 1.\n2 2 2.\n3 3 3.\n",
                  "1 1 4.\n2 1 -1.\n2 2 1e36\n3 2 -2.\n3 3 5.\n");
    scene.contact_pattern_file =
      write_text("pairs.csv",
                 "pair,side,direction,dof,weight\n"
                 "1,target,normal,3,1\n1,source,normal,2,1\n"
                 "1,target,sliding,1,1\n");
    const ImportedModel model = read_imported_model(scene);
    check(model.n_dofs == 2 && model.held == std::vector<unsigned int>({1}) &&
            model.original_numbers == std::vector<unsigned int>({0, 2}),
          "an unknown with 1e36 on the diagonal is held and taken out");
    check(entries_of(model.parts[1]) == EntryMap({{{0, 0}, 4.}, {{1, 1}, 5.}}),
          "the others keep their stiffness");
    check(model.contact.normal[0] == ImportedContact::Row({{1, 1.}}) &&
            model.contact.sliding[0] == ImportedContact::Row({{0, 1.}}),
          "contact rows are renumbered and lose the held unknown");
  }

  void
  refuse(const std::string     &claim,
         const SceneParameters &scene,
         const std::string     &message)
  {
    check_throws<InputError>(
      [&]() { read_imported_model(scene); }, message, claim);
  }

  void
  test_refusals()
  {
    SceneParameters scene;
    refuse("no parts", scene, "no part has the role mass");
    add_part(scene, "M", write_text("mass.txt", "1 1 1.\n"), Role::mass);
    refuse("no stiffness", scene, "no part has the role stiffness");
    refuse("parts of different size",
           small_scene("1 1 1.\n2 2 1.\n"),
           "Matrix part M (mass.txt) has 2 rows, another part 3");
    refuse("parts with and without names",
           small_scene("1,1, 1,1, 1.\n"),
           "Matrix part K (stiff.txt) has row numbers");
    refuse("negative mass",
           small_scene("1 1 1.\n2 2 -1.\n3 3 1.\n"),
           "unknown 2 has a negative mass");
    refuse("Lagrange multiplier",
           small_scene("1 1 1.\n2 2 1.\n3 3 0.\n",
                       "1 1 1.\n2 2 1.\n3 1 1.\n3 2 -1.\n"),
           "unknown 3 has neither mass nor stiffness");
    refuse("all held",
           small_scene("1 1 1.\n", "1 1 1e36\n"),
           "every unknown is held");

    scene                 = small_scene("1,1, 1,1, 1.\n1,2, 1,2, 1.\n",
                        "1,1, 1,1, 1.\n1,2, 1,2, 1.\n");
    const std::string top = "node,component,x,y,z,body\n";
    scene.node_table_file = write_text("table.csv", top + "1,1,0,0,0,a\n");
    refuse("unknown that the table lacks",
           scene,
           "Matrix part M (mass.txt): node 1, component 2 is not in the node "
           "table table.csv");
    scene                 = small_scene();
    scene.node_table_file = "table.csv";
    refuse("rows without names need dof numbers",
           scene,
           "table.csv:1: column 'dof' is missing");
    scene.node_table_file =
      write_text("short.csv", "dof," + top + "1,1,1,0,0,0,a\n2,1,2,0,0,0,a\n");
    refuse("table shorter than the matrices",
           scene,
           "Matrix part M (mass.txt) has 3 rows, the node table 2");
    scene.node_table_file =
      write_text("gap.csv", "dof," + top + "1,1,1,0,0,0,a\n5,1,2,0,0,0,a\n");
    refuse("table with a gap", scene, "gap.csv:3: dof 5, but the table has");
  }

  void
  refuse_pattern(const std::string &claim,
                 const std::string &lines,
                 const std::string &message,
                 const std::string &columns = "pair,side,direction,dof,weight")
  {
    SceneParameters scene = small_scene();
    scene.contact_pattern_file =
      write_text("pairs.csv", columns + "\n" + lines);
    refuse(claim, scene, message);
  }

  void
  test_pattern_refusals()
  {
    const std::string sliding = "1,target,sliding,3,1\n";
    refuse_pattern("unknown out of range",
                   "1,target,normal,4,1\n",
                   "pairs.csv:2: dof 4 does not exist; the model has 3");
    refuse_pattern("names where the matrices have none",
                   "1,target,normal,4,1,1\n",
                   "pairs.csv:2: node 4, component 1 is not in the matrices",
                   "pair,side,direction,node,component,weight");
    refuse_pattern("no normal row", sliding, "pair 1 has no normal row");
    refuse_pattern(
      "no sliding row", "1,target,normal,1,1\n", "pair 1 has no sliding row");
    refuse_pattern("transverse row of one pair only",
                   "1,target,normal,1,1\n" + sliding +
                     "2,target,normal,1,1\n2,target,sliding,1,1\n"
                     "2,target,transverse,1,1\n",
                   "pair 1 has no transverse row");
    refuse_pattern("coefficient twice",
                   "1,target,normal,1,1\n1,target,normal,1,1\n",
                   "pairs.csv:3: unknown 1 is given twice");
    refuse_pattern("sides that do not balance",
                   "1,target,normal,1,.6\n1,target,normal,2,.3\n"
                   "1,source,normal,3,1\n" +
                     sliding,
                   "pairs.csv:4: the normal weights of target and source of "
                   "pair 1 do not add up to the same");
    refuse_pattern("shares of what is held on an axis that is none",
                   "1,target,normal,held w,.6\n",
                   "pairs.csv:2");
    // The same sum with what supports hold of it: the next fault is named.
    refuse_pattern("sides that balance with what is held",
                   "1,target,normal,1,.6\n1,target,normal,held z,.4\n"
                   "1,source,normal,3,1\n",
                   "pair 1 has no sliding row");
  }
} // namespace

int
main()
{
  test_sample();
  test_parts();
  test_held();
  test_refusals();
  test_pattern_refusals();
}
