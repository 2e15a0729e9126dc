// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Names of vibration shapes: a clamped disc, a brake with pad and support, a
// beam, a Gmsh body, a rigid body.
#include <deal.II/base/mpi.h>

#include <fstream>

#include "check.h"
#include "mode_naming_model.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  std::vector<ModeName>
  names_of(const Model &model, const Block &shapes)
  {
    return model.namer.name(shapes, model.energies(shapes));
  }

  std::vector<ModeName>
  names_of(const Model &model, const ComplexBlock &shapes)
  {
    Eigen::MatrixXd shares = model.energies(Block(shapes.real())) +
                             model.energies(Block(shapes.imag()));
    for (int i = 0; i < shares.cols(); ++i)
      shares.col(i) /= shares.col(i).sum();
    return model.namer.name(shapes, shares);
  }

  unsigned int
  index_of(const std::vector<ModeName> &names, const std::string &text)
  {
    for (unsigned int i = 0; i < names.size(); ++i)
      if (names[i].text == text)
        return i;
    check(false, "a mode is named " + text);
    return 0;
  }

  /** Modes of the clamped disc, separated. */
  Modes
  disc_modes(const Model &model, const double highest)
  {
    Modes modes = modes_of(model, highest);
    modes.shapes =
      model.namer.separate_multiple(modes.shapes, modes.frequencies);
    return modes;
  }



  void
  every_mode_of_the_clamped_disc_has_its_name(const Model &model)
  {
    // Converged frequencies, Hz, of radii 50/120 mm, thickness 10 mm, steel.
    const std::vector<std::pair<std::string, double>> reference = {
      {"(0,0)", 1629.68},
      {"(0,1", 1638.31},
      {"(0,2", 1839.64},
      {"(0,3", 2557.49},
      {"(0,4", 3853.4},
      {"(0,5", 5611.7},
      {"(0,6", 7731.5},
      {"(1,0)", 9668.77},
      {"(1,1", 9923.24},
      {"(1,2", 10702.93},
      {"(1,3", 12040.76},
      {"T(0,0)", 6303.3},
      {"T(0,1", 9515.52}};
    Modes modes = modes_of(model, 12200.);
    // Any basis of a doublet will do: turn all of them by some angle.
    for (unsigned int i = 0; i + 1 < modes.frequencies.size(); ++i)
      if (modes.frequencies[i + 1] < modes.frequencies[i] * (1. + 1e-6))
        {
          Eigen::Matrix2d turn;
          turn << std::cos(0.7), -std::sin(0.7), std::sin(0.7), std::cos(0.7);
          modes.shapes.middleCols(i, 2) =
            Block(modes.shapes.middleCols(i, 2)) * turn;
        }
    modes.shapes =
      model.namer.separate_multiple(modes.shapes, modes.frequencies);
    const Eigen::MatrixXd gram =
      model.space().dot(modes.shapes, model.mass(modes.shapes));
    check((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols()))
              .cwiseAbs()
              .maxCoeff<Eigen::PropagateNaN>() < 1e-8,
          "separating doublets keeps modes mass-orthonormal");

    const auto   names   = names_of(model, modes.shapes);
    unsigned int n_named = 0;
    for (const auto &[text, frequency] : reference)
      {
        const bool single = text.back() == ')';
        for (const std::string end : {"+)", "-)"})
          {
            const std::string  full = single ? text : text + end;
            const unsigned int i    = index_of(names, full);
            check_close(modes.frequencies[i], frequency, 6e-3, full);
            check(names[i].is_disc &&
                    names[i].parity == (single ? "" : end.substr(0, 1)) &&
                    names[i].family ==
                      (text[0] == 'T' ? "tangential" : "bending"),
                  full + ": columns of the table");
            ++n_named;
            if (single)
              break;
          }
      }
    // (0,7+) and (0,7-), at 10.2 kHz, are not in the reference.
    check(names.size() == n_named + 2, "no further mode below 12.2 kHz");
    check(names[index_of(names, "(1,3-)")].nodal_circles == 1 &&
            names[index_of(names, "(1,3-)")].nodal_diameters == 3,
          "(1,3-) has one nodal circle and three nodal diameters");
  }



  void
  complex_shapes_are_named_whatever_their_phase(const Model &model)
  {
    const Modes        modes = disc_modes(model, 3000.);
    const auto         names = names_of(model, modes.shapes);
    const unsigned int plus  = index_of(names, "(0,3+)");
    const unsigned int minus = index_of(names, "(0,3-)");

    const Eigen::VectorXcd c = modes.shapes.col(plus).cast<Complex>();
    const Eigen::VectorXcd s = modes.shapes.col(minus).cast<Complex>();
    const Complex          i(0., 1.);
    const Complex          phase = std::polar(1., 2.1);
    ComplexBlock           X(c.size(), 5);
    X.col(0)         = phase * c;
    X.col(1)         = phase * s;
    X.col(2)         = phase * (c + 0.7 * i * s); // travelling waves
    X.col(3)         = phase * (0.7 * c - i * s);
    X.col(4)         = c + i * 0.3 * modes.shapes.col(0).cast<Complex>();
    const auto found = names_of(model, X);
    check(found[0].text == "(0,3+)" && found[1].text == "(0,3-)",
          "the phase of a complex shape does not matter");
    check(found[2].text == "(0,3+)" && found[3].text == "(0,3-)",
          "a travelling wave has its m and the parity of the larger part");
    check(found[4].text == "(0,3+)", "a small part of (0,0) does not matter");
  }



  void
  doublets_are_named_by_their_space(const Model &model)
  {
    const Modes            modes = disc_modes(model, 3000.);
    const auto             names = names_of(model, modes.shapes);
    const Eigen::VectorXcd c =
      modes.shapes.col(index_of(names, "(0,3+)")).cast<Complex>();
    const Eigen::VectorXcd s =
      modes.shapes.col(index_of(names, "(0,3-)")).cast<Complex>();
    const Eigen::MatrixXd shares = Eigen::MatrixXd::Ones(1, 2);
    const auto            of     = [&](const double  a,
                        const double  b,
                        const Complex phase,
                        const Complex split) {
      ComplexBlock X(c.size(), 2);
      X.col(0)         = std::cos(a) * c + phase * std::sin(a) * s;
      X.col(1)         = std::cos(b) * c - phase * std::sin(b) * s;
      const auto named = model.namer.name(
        X, shares, Eigen::Vector2cd(Complex(0., 1.), Complex(0., 1.) + split));
      return named[0].text + " " + named[1].text;
    };
    // Any two vectors of the space, orthogonal or not.
    for (const double a : {0., 0.3, M_PI / 4., 0.8})
      for (const double b : {1.1, M_PI / 4., 1.5})
        for (const double phase : {0., 0.7, 0.5 * M_PI})
          check(of(a, b, std::polar(1., phase), 1e-7) == "(0,3+) (0,3-)",
                "the space of a doublet holds (0,3+) and (0,3-)");
    check(of(1.5, 0.1, 1., 1e-7) == "(0,3-) (0,3+)",
          "a member that clearly is the other one has its name");
    check(of(M_PI / 4., M_PI / 4., 1., 1e-3) == "(0,3+)|(0,3-) (0,3+)|(0,3-)",
          "two eigenvalues have a shape each");
  }



  void
  signatures_pair_the_modes_of_two_meshes(const Model &fine,
                                          const Model &coarse)
  {
    const Modes     a = disc_modes(fine, 7000.), b = disc_modes(coarse, 7000.);
    Eigen::MatrixXd x = fine.namer.signature()->apply(a.shapes);
    Eigen::MatrixXd y = coarse.namer.signature()->apply(b.shapes);
    check(x.rows() == y.rows() && x.rows() < 1000 && x.cols() == y.cols(),
          "signatures of two meshes fit");
    x.colwise().normalize();
    y.colwise().normalize();
    const Eigen::MatrixXd mac = (x.transpose() * y).cwiseAbs2();
    for (int i = 0; i < mac.rows(); ++i)
      for (int j = 0; j < mac.cols(); ++j)
        check(i == j ? mac(i, j) > 0.99 : mac(i, j) < 0.01,
              "MAC " + std::to_string(i) + " " + std::to_string(j) + " is " +
                std::to_string(mac(i, j)));
  }



  void
  parity_refers_to_the_first_pad()
  {
    SceneParameters scene = disc_scene({{16, 3, 1}});
    const double    angle = 0.5;
    scene.bodies.push_back(
      block("pad",
            {{0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.}},
            {{0.01, 0.01, 0.01}},
            {{1, 1, 1}}));
    clamp(scene, "pad", "z_max");
    ContactParameters contact;
    contact.source_body = "pad";
    contact.target_body = "disc";
    scene.contacts.push_back(contact);

    const Model model(scene, 2);
    check_close(
      model.namer.reference_angle(), angle, 1e-12, "angle of the pad");
    const Modes modes = disc_modes(model, 3000.);
    const auto  names = names_of(model, modes.shapes);
    const auto  rows =
      PointEvaluator(model.discretization)
        .displacements(0, {{0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.}});
    const Eigen::MatrixXd u =
      Functionals(model.discretization.space(), {rows.rows[0][2]})
        .apply(modes.shapes);
    for (const std::string m : {"1", "2", "3"})
      check(std::abs(u(0, index_of(names, "(0," + m + "-)"))) <
              0.02 * std::abs(u(0, index_of(names, "(0," + m + "+)"))),
            "(0," + m + "-) has a node at the pad, (0," + m + "+) has none");
  }



  /** Disc, pad and support as a brake in frictionless contact. */
  SceneParameters
  brake_scene()
  {
    SceneParameters scene = disc_scene({{24, 3, 1}});
    const double    r     = 0.1075;
    scene.bodies.push_back(
      block("pad", {{r, 0., 0.}}, {{0.01, 0.01, 0.01}}, {{2, 2, 1}}));
    scene.bodies.push_back(
      block("support", {{r, 0., 0.01}}, {{0.01, 0.01, 0.1}}, {{2, 2, 5}}));
    const double young[]   = {217e9, std::pow(10., 10.4), 1.67e12};
    const double density[] = {7800., 2500., 6.86e4};
    for (unsigned int b = 0; b < 3; ++b)
      {
        scene.bodies[b].young_modulus = young[b];
        scene.bodies[b].density       = density[b];
      }
    TieParameters tie;
    tie.source_body = "pad";
    tie.source_face = "z_max";
    tie.target_body = "support";
    tie.target_face = "z_min";
    scene.ties.push_back(tie);
    ContactParameters contact;
    contact.source_body = "pad";
    contact.target_body = "disc";
    scene.contacts.push_back(contact);
    return scene;
  }

  void
  add_contact_and_guide(Model &model)
  {
    const PointEvaluator          evaluator(model.discretization);
    std::vector<dealii::Point<3>> face, sides;
    for (unsigned int i = 0; i < 11; ++i)
      {
        const double x = 0.1025 + 0.001 * i;
        for (unsigned int j = 0; j < 11; ++j)
          face.emplace_back(x, -0.005 + 0.001 * j, 0.);
        for (const double z : {0.035, 0.085})
          for (const double y : {-0.005, 0.005})
            sides.emplace_back(x, y, z);
      }
    const auto                    on_disc = evaluator.displacements(0, face);
    const auto                    on_pad  = evaluator.displacements(1, face);
    const auto                    guided  = evaluator.displacements(2, sides);
    std::vector<Functionals::Row> gaps, guides;
    for (unsigned int p = 0; p < face.size(); ++p)
      gaps.push_back(
        combine({{1., &on_disc.rows[p][2]}, {-1., &on_pad.rows[p][2]}}));
    for (const auto &rows : guided.rows)
      guides.push_back(rows[1]);
    model.add_springs(gaps, 2.5895e8);
    model.add_springs(guides, 8.422e6);
  }

  void
  brake_modes_are_named_by_disc_and_support()
  {
    Model model(brake_scene(), 3);
    add_contact_and_guide(model);
    const Modes modes = modes_of(model, 7000.);
    const auto  names = names_of(model, modes.shapes);
    for (unsigned int i = 0; i < names.size(); ++i)
      std::cout << modes.frequencies[i] << " Hz: " << names[i].text
                << std::endl;
    const auto nearest = [&](const std::string &text, const double frequency) {
      Worst distance;
      for (unsigned int i = 0; i < names.size(); ++i)
        if (names[i].text == text)
          distance.add(std::abs(modes.frequencies[i] / frequency - 1.));
      check(distance.smallest() < 0.02,
            text + " is found at " + std::to_string(frequency) + " Hz");
    };
    // F. Massi 2006, table 3.1 and text: the "+" modes lie far above the "-"
    // modes of the same name.
    nearest("(0,3+)", 3492.);
    nearest("(0,3-)", 2594.);
    nearest("(0,4+)", 4992.);
    nearest("(0,4-)", 3918.);
    nearest("(0,5+)", 6659.);
    nearest("(0,5-)", 5736.);
    // It swings about a node, moves as one (and bends a little), bends.
    nearest("support tangential 2", 3000.);
    nearest("support tangential 1", 3500.);
    nearest("support tangential 3", 5000.);
    nearest("support radial 3", 5000.);

    const unsigned int swing = index_of(names, "support tangential 2");
    check(names[swing].solid_nodes == 1 && !names[swing].is_disc &&
            names[swing].parity.empty() && names[swing].family == "tangential",
          "the support swings about one node, no disc shape");

    // The members of a coalesced pair: much support, a little disc.
    unsigned int disc_mode = 0;
    for (unsigned int i = 0; i < names.size(); ++i)
      if (names[i].text == "(0,3+)" && modes.frequencies[i] > 3000.)
        disc_mode = i;
    const Eigen::VectorXcd slide =
      modes.shapes.col(index_of(names, "support tangential 1")).cast<Complex>();
    const Eigen::VectorXcd ring = modes.shapes.col(disc_mode).cast<Complex>();
    ComplexBlock           pair(slide.size(), 3);
    pair.col(0)     = modes.shapes.col(swing).cast<Complex>();
    pair.col(1)     = slide + Complex(0.05, 0.1) * ring;
    pair.col(2)     = slide + Complex(0.05, -0.1) * ring;
    const auto both = names_of(model, pair);
    check(both[1].text == "(0,3+) support tangential 1" &&
            both[2].text == both[1].text,
          "both members of a coalesced pair: " + both[1].text + ", " +
            both[2].text);
    check(both[1].is_disc && both[1].nodal_diameters == 3 &&
            both[1].solid_number == 1 && both[1].body == 2,
          "a coalesced pair has the columns of disc and support");

    // Of bodies that share the energy none has the share that names a body.
    const Eigen::MatrixXcd swinging =
      model.namer.coordinates(Block(modes.shapes.col(swing))).cast<Complex>();
    const auto parts = [&](const double of_disc) {
      const double of_others = 0.5 * (1. - of_disc);
      return model.namer
        .name_coordinates(swinging,
                          Eigen::Vector3d(of_disc, of_others, of_others))[0]
        .text;
    };
    check(parts(0.49).find("support tangential 2") != std::string::npos,
          "together they are named: " + parts(0.49));
    check(parts(0.76).find("support") == std::string::npos,
          "a disc with three quarters of the energy is named alone: " +
            parts(0.76));
  }



  void
  directions_of_a_square_beam_come_apart(const BodyParameters &body)
  {
    SceneParameters scene;
    scene.bodies = {body};
    clamp(scene, body.name, "z_min");
    const Model        model(scene, 3);
    const Modes        modes = disc_modes(model, 17000.);
    const auto         names = names_of(model, modes.shapes);
    const std::string  n     = body.name;
    const unsigned int x     = index_of(names, n + " x 1"),
                       y     = index_of(names, n + " y 1");
    // Euler-Bernoulli 1.8751^2 / (2 pi L^2) sqrt(E I / (rho A)); shear and
    // rotation of the sections take 1 %.
    const double slender = std::pow(1.8751, 2) / (2. * M_PI * 0.01) *
                           std::sqrt(210e9 * 1e-4 / (12. * 7800.));
    check_close(modes.frequencies[x], slender, 0.02, n + " bends along x");
    check_close(modes.frequencies[y], modes.frequencies[x], 1e-6, n + " and y");
    check(names[x].solid_nodes == 0 &&
            names[index_of(names, n + " y 2")].solid_nodes == 1,
          "the second bending mode has a node");
    // Torsion of a square section: sqrt(0.1406 a^4 G / (rho a^4/6)) / (4 L).
    check_close(modes.frequencies[index_of(names, n + " torsion 1")],
                std::sqrt(0.1406 * 6. * 210e9 / 2.6 / 7800.) / 0.4,
                0.02,
                n + " twists");
    check_close(modes.frequencies[index_of(names, n + " z 1")],
                std::sqrt(210e9 / 7800.) / 0.4,
                0.02,
                n + " stretches");
    check(!names[x].is_disc && names[x].nodal_diameters == -1,
          "no disc, no nodal diameters");
  }

  /** Of a pad that is sheared or stretched in its plane the mean motions are
   * rounding: no such chance may name it. */
  void
  changes_of_shape_are_not_named_by_rounding()
  {
    SceneParameters scene;
    scene.bodies = {
      block("pad", {{0., 0., 0.}}, {{0.03, 0.03, 0.01}}, {{2, 2, 1}})};
    clamp(scene, "pad", "z_min");
    const Model  model(scene, 3);
    const Modes  modes     = modes_of(model, 250e3);
    const auto   names     = names_of(model, modes.shapes);
    unsigned int n_changes = 0;
    for (const double sign : {-1., 1.})
      {
        // Every mode with a trace of every other.
        const Eigen::Index n   = modes.shapes.cols();
        Eigen::MatrixXd    mix = sign * 1e-7 * Eigen::MatrixXd::Ones(n, n) +
                              Eigen::MatrixXd::Identity(n, n);
        const auto mixed = names_of(model, Block(modes.shapes * mix));
        for (Eigen::Index i = 0; i < n; ++i)
          {
            const double gap = std::min(
              i > 0 ? modes.frequencies[i] - modes.frequencies[i - 1] : 1e300,
              i + 1 < n ? modes.frequencies[i + 1] - modes.frequencies[i]
                        : 1e300);
            // Members of a multiple frequency have no shape of their own.
            if (gap < 1e-3 * modes.frequencies[i])
              continue;
            check(names[i].text == mixed[i].text,
                  names[i].text + " stays " + mixed[i].text);
            n_changes += names[i].text == "pad motion 1";
          }
      }
    check(n_changes >= 2, "a mode that only changes its shape is a motion");
  }

  /** The same beam as a file: 2 x 2 x 10 hexahedra. */
  void
  write_gmsh_beam(const std::string &file)
  {
    const int     n[] = {2, 2, 10};
    std::ofstream out(file);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n"
           "2 1 \"z_min\"\n3 2 \"beam\"\n$EndPhysicalNames\n$Nodes\n"
        << 9 * 11 << "\n";
    const auto node = [](const int i, const int j, const int k) {
      return 1 + i + 3 * j + 9 * k;
    };
    for (int k = 0; k <= n[2]; ++k)
      for (int j = 0; j <= n[1]; ++j)
        for (int i = 0; i <= n[0]; ++i)
          out << node(i, j, k) << " " << 0.005 * (i - 1) << " "
              << 0.005 * (j - 1) << " " << 0.01 * k << "\n";
    out << "$EndNodes\n$Elements\n" << 4 + 40 << "\n";
    int element = 0;
    for (int k = -1; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i)
          {
            const auto quad = [&](const int level) {
              out << " " << node(i, j, level) << " " << node(i + 1, j, level)
                  << " " << node(i + 1, j + 1, level) << " "
                  << node(i, j + 1, level);
            };
            out << ++element << (k < 0 ? " 3 2 1 1" : " 5 2 2 2");
            quad(std::max(k, 0));
            if (k >= 0)
              quad(k + 1);
            out << "\n";
          }
    out << "$EndElements\n";
  }



  void
  rigid_bodies_and_bare_matrices_have_names()
  {
    SceneParameters scene;
    BodyParameters  mass;
    mass.name    = "slider";
    mass.shape   = BodyParameters::Shape::rigid;
    scene.bodies = {mass};
    const Discretization discretization(scene, {}, 1, MPI_COMM_WORLD);
    const ModeNamer      namer(discretization);
    const Block          motions = namer.signature()->apply_transposed(
      Eigen::MatrixXd(Eigen::MatrixXd::Identity(6, 6)));
    const auto names = namer.name(motions, Eigen::MatrixXd::Ones(1, 6));
    const std::vector<std::string> expected = {
      "x", "y", "z", "rotation x", "rotation y", "rotation z"};
    for (unsigned int i = 0; i < 6; ++i)
      check(names[i].text == "slider " + expected[i] + " 1", names[i].text);

    const auto plain =
      ModeNamer().name(Block(Block::Random(5, 3)), Eigen::MatrixXd());
    check(plain.size() == 3 && plain[2].text == "mode 3" && !plain[2].is_disc,
          "models without geometry have plain numbers");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  rigid_bodies_and_bare_matrices_have_names();
  {
    const Model fine(disc_scene({{24, 4, 1}}), 3);
    const Model coarse(disc_scene({{16, 3, 1}}), 2);
    every_mode_of_the_clamped_disc_has_its_name(fine);
    complex_shapes_are_named_whatever_their_phase(coarse);
    doublets_are_named_by_their_space(coarse);
    signatures_pair_the_modes_of_two_meshes(fine, coarse);
  }
  parity_refers_to_the_first_pad();
  brake_modes_are_named_by_disc_and_support();

  directions_of_a_square_beam_come_apart(
    block("beam", {{0., 0., 0.}}, {{0.01, 0.01, 0.1}}, {{1, 1, 5}}));
  changes_of_shape_are_not_named_by_rounding();
  BodyParameters from_file;
  from_file.name            = "bar";
  from_file.shape           = BodyParameters::Shape::gmsh;
  from_file.mesh_file       = "mode_naming_beam.msh";
  from_file.physical_volume = "beam";
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    write_gmsh_beam(from_file.mesh_file);
  MPI_Barrier(MPI_COMM_WORLD);
  directions_of_a_square_beam_come_apart(from_file);
}
