// SPDX-License-Identifier: LGPL-2.1-or-later

// The shapes in the files are those of the eigenvectors: read back, every
// point of every body moves as it was told to, on any number of ranks.

#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/results/shape_writer.h>

#include <deal.II/base/mpi.h>

#include "read_vtu.h"
#include "shape_scene.h"
#include "worst.h"

#include <algorithm>
#include <complex>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

using namespace squeal;
using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  const std::string directory = "shape_writer_output";

  bool
  is_root()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  Eigen::Vector3d
  vector_at(const std::vector<float> &values, const unsigned int point)
  {
    return {values[3 * point], values[3 * point + 1], values[3 * point + 2]};
  }

  /** Largest distance of the three vectors at the corners of all cells from
   * the motion. */
  double
  error_of_frame(const std::string  &xml,
                 const LinearMotion &real,
                 const LinearMotion &imaginary)
  {
    const auto points  = vtu_array<float>(xml, "Points");
    const auto corners = vtu_array<std::int32_t>(xml, "connectivity");
    const auto body    = vtu_array<std::int32_t>(xml, "body");
    const auto u       = vtu_array<float>(xml, "displacement");
    const auto re      = vtu_array<float>(xml, "displacement_real");
    const auto im      = vtu_array<float>(xml, "displacement_imag");
    check(u.size() == points.size() && re.size() == points.size() &&
            im.size() == points.size(),
          "three components for each point");
    const double               phase  = vtu_number(xml, "phase_rad");
    const std::complex<double> factor = std::polar(
      vtu_number(xml, "display_factor"), vtu_number(xml, "phase_offset_rad"));
    const unsigned int n_corners = corners.size() / body.size();
    Worst              error;
    for (unsigned int i = 0; i < corners.size(); ++i)
      {
        const unsigned int     b = body[i / n_corners], p = corners[i];
        const Eigen::Vector3d  x = vector_at(points, p);
        const Eigen::Vector3cd w =
          factor * (real.at(b, x).cast<std::complex<double>>() +
                    std::complex<double>(0., 1.) * imaginary.at(b, x));
        const Eigen::Vector3d now = (w * std::polar(1., phase)).real();
        error.add((vector_at(re, p) - w.real()).norm());
        error.add((vector_at(im, p) - w.imag()).norm());
        error.add((vector_at(u, p) - now).norm());
      }
    return error.largest();
  }

  double
  largest_displacement(const std::string &xml, const std::string &field)
  {
    const auto u = vtu_array<float>(xml, field);
    Worst      largest;
    for (unsigned int p = 0; 3 * p < u.size(); ++p)
      largest.add(vector_at(u, p).norm());
    return largest.largest();
  }

  std::vector<std::string>
  files_of(const std::string &pvd)
  {
    std::vector<std::string> files;
    for (std::size_t at = 0;
         (at = pvd.find("file=\"", at)) != std::string::npos;)
      {
        at += 6;
        files.push_back(pvd.substr(at, pvd.find('"', at) - at));
      }
    return files;
  }

  void
  check_geometry(const std::string &xml, const double size)
  {
    const auto points  = vtu_array<float>(xml, "Points");
    const auto corners = vtu_array<std::int32_t>(xml, "connectivity");
    const auto body    = vtu_array<std::int32_t>(xml, "body");
    const auto types   = vtu_array<std::uint8_t>(xml, "types");
    const auto ends    = vtu_array<std::int32_t>(xml, "offsets");
    check(types.size() == body.size() && ends.size() == body.size() &&
            std::all_of(
              types.begin(), types.end(), [](auto t) { return t == 12; }) &&
            ends.back() == static_cast<int>(corners.size()),
          "all cells are hexahedra");
    // Lattice points of 36 x 8, 8 x 8 + 7 x 8 and 8 x 8 cells, and a cube.
    check(body.size() == 36 * 8 + 15 * 8 + 8 * 8 + 1, "number of cells");

    Worst positive, rim;
    for (unsigned int i = 0; i < body.size(); ++i)
      {
        std::array<Eigen::Vector3d, 8> v;
        for (unsigned int c = 0; c < 8; ++c)
          v[c] = vector_at(points, corners[8 * i + c]);
        positive.add((v[1] - v[0]).cross(v[3] - v[0]).dot(v[4] - v[0]) / 1e-9);
        if (body[i] == 0)
          for (const auto &x : v)
            rim.add(x.head<2>().norm());
      }
    check(positive.smallest() > 0., "corners are in VTK's order");
    check_close(
      rim.largest(), 0.12, 1e-6, "pieces of a curved cell end on the curve");
    const Eigen::Vector3d lower(-0.12, -0.12, -0.01), upper(0.2, 0.12, 0.02);
    check_close(size, (upper - lower).norm(), 1e-12, "size of the scene");

    // Where pad and disc touch there are points of both.
    std::set<unsigned int> of_disc, of_pad, of_support, common, tied;
    for (unsigned int i = 0; i < corners.size(); ++i)
      (body[i / 8] == 0   ? of_disc
       : body[i / 8] == 1 ? of_pad
                          : of_support)
        .insert(corners[i]);
    std::set_intersection(of_disc.begin(),
                          of_disc.end(),
                          of_pad.begin(),
                          of_pad.end(),
                          std::inserter(common, common.end()));
    std::set_intersection(of_pad.begin(),
                          of_pad.end(),
                          of_support.begin(),
                          of_support.end(),
                          std::inserter(tied, tied.end()));
    check(common.empty(), "touching bodies share no points");
    check(tied.size() == 25, "tied bodies share the points of the tie");
  }

  void
  shapes_are_right(const Discretization &discretization,
                   OutputDirectory      &output)
  {
    const LinearMotion real(0.3), imaginary(1.7);
    const Block        re = unknowns(discretization, real);
    const Block        im = unknowns(discretization, imaginary);
    ShapeOptions       options;
    ShapeWriter        writer(discretization, output, options);
    const DisplayMesh  mesh(discretization, 2);
    const double       drawn = options.display_scale * mesh.size();
    writer.write_shape("shape", re, im, 5004.25, 12, {{"sigma_per_s", -3.5}});
    options.surface_only = true;
    ShapeWriter surface(discretization, output, options);
    surface.write_shape("surface", re, im, 5004.25, 12);
    if (!is_root())
      return;

    for (const std::string name : {"shape", "surface"})
      {
        const std::string pvd = read_file(directory + "/" + name + ".pvd");
        check_xml(pvd, name + ".pvd");
        const auto files = files_of(pvd);
        check(files.size() == 12 && files[3] == "shapes/" + name + "_03.vtu",
              name + ": twelve frames in the subfolder");
        Worst error, largest;
        for (const auto &file : files)
          {
            const std::string vtu = read_file(directory + "/" + file);
            check_xml(vtu, file);
            largest.add(largest_displacement(vtu, "displacement"));
            error.add(error_of_frame(vtu, real, imaginary));
          }
        check(error.largest() < 3e-4 * drawn,
              name + ": every point moves as it was told");
        check(largest.largest() < 1.0002 * drawn &&
                largest.largest() > 0.96 * drawn,
              name + ": the largest motion is the display scale");
      }
    const std::string vtu = read_file(directory + "/shapes/shape_00.vtu");
    check_geometry(vtu, mesh.size());
    check(vtu_number(vtu, "frequency_hz") == 5004.25 &&
            vtu_number(vtu, "sigma_per_s") == -3.5,
          "field data hold frequency and growth rate");
    check(vtu.find("<PointData Vectors=\"displacement\">") != std::string::npos,
          "the displacement is the active vector");
    for (const auto &entry : fs::recursive_directory_iterator(directory))
      check(entry.path().filename().string().find(".part") == std::string::npos,
            "no temporary file is left: " + entry.path().string());
    check(output.files().count("shape.pvd") == 1 &&
            output.files().count("shapes/surface_11.vtu") == 1,
          "the manifest knows all files");
  }

  void
  phase_is_aligned(const Discretization &discretization,
                   OutputDirectory      &output)
  {
    const Block  re = unknowns(discretization, LinearMotion(0.3));
    const Block  none(re.rows(), 0), zero = Block::Zero(re.rows(), 1);
    ShapeOptions options;
    ShapeWriter  writer(discretization, output, options);
    writer.write_shape("real", re, none, 1., 1);
    writer.write_shape("no_animation", re, none, 1., 0);
    writer.write_shape("imaginary", zero, re, 1., 1);
    options.align_phase = false;
    ShapeWriter exact(discretization, output, options);
    exact.write_shape("not_aligned", zero, re, 1., 1);
    writer.write_shape("nothing", zero, none, 0., 2);
    if (!is_root())
      return;

    const auto vtu = [](const std::string &name) {
      return read_file(directory + "/shapes/" + name + ".vtu");
    };
    const auto a = vtu_array<float>(vtu("real"), "displacement");
    auto       b = vtu_array<float>(vtu("imaginary"), "displacement");
    if (a[0] * b[0] < 0.)
      for (float &value : b)
        value = -value;
    check(vtu_array<float>(vtu("no_animation"), "displacement_real") ==
            vtu_array<float>(vtu("real"), "displacement_real"),
          "without an animation real and imaginary part are there");
    Worst difference;
    for (unsigned int i = 0; i < a.size(); ++i)
      difference.add(std::abs(a[i] - b[i]));
    check(difference.largest() <
            2e-4 * largest_displacement(vtu("real"), "displacement"),
          "a real shape times i is drawn as the real one");
    check(largest_displacement(vtu("not_aligned"), "displacement") == 0. &&
            largest_displacement(vtu("not_aligned"), "displacement_imag") > 0.,
          "a shape with a phase of its own keeps it");
    check(largest_displacement(vtu("nothing_01"), "displacement") == 0.,
          "a shape of zeros is drawn at rest");
    check(files_of(read_file(directory + "/real.pvd")) ==
            std::vector<std::string>{"shapes/real.vtu"},
          "one frame is one file");
  }

  void
  failures(const Discretization &discretization, OutputDirectory &output)
  {
    Block shape = unknowns(discretization, LinearMotion(0.3));
    if (is_root())
      fs::create_directories(directory + "/shapes/taken_00.vtu/folder");
    ShapeWriter writer(discretization, output);
    const Block none(shape.rows(), 0);
    check_throws<InputError>(
      [&]() { writer.write_shape("taken", shape, none, 1., 2); },
      "taken_00.vtu",
      "a file that cannot be written is said on every rank");
    if (is_root())
      check(!fs::exists(directory + "/taken.pvd"), "and the PVD is not there");
    shape(shape.rows() - 1, 0) = std::numeric_limits<double>::quiet_NaN();
    ShapeOptions options;
    options.align_phase = false;
    ShapeWriter exact(discretization, output, options);
    for (ShapeWriter *w : {&writer, &exact})
      check_throws<ComputationError>(
        [&]() { w->write_shape("nan", shape, none, 1., 2); },
        "'nan'",
        "a shape that is not finite is refused");
  }

  /** Lumped scenes have no mesh. */
  void
  rigid_bodies_alone(OutputDirectory &output)
  {
    SceneParameters scene;
    scene.bodies.resize(1);
    scene.bodies[0].shape = BodyParameters::Shape::rigid;
    scene.bodies[0].name  = "mass";
    const Discretization discretization(
      scene, DiscretizationParameters(), 2, MPI_COMM_WORLD);
    ShapeWriter writer(discretization, output);
    Block       shape = Block::Zero(discretization.space()->n_owned(), 1);
    if (is_root())
      shape(2, 0) = 7.;
    writer.write_shape("rigid", shape, Block(shape.rows(), 0), 1., 1);
    if (!is_root())
      return;
    const std::string vtu = read_file(directory + "/shapes/rigid.vtu");
    const auto        u   = vtu_array<float>(vtu, "displacement");
    check(u.size() == 24, "a rigid body is drawn as a cube");
    for (unsigned int p = 0; p < 8; ++p)
      check(u[3 * p] == 0. && u[3 * p + 1] == 0. &&
              std::abs(u[3 * p + 2] - 0.05) < 1e-5,
            "which moves with it");
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const SceneParameters                    scene          = shape_scene();
  const auto                               discretization = refined(scene, 2);
  OutputDirectory                          output(directory, true, is_root());
  shapes_are_right(*discretization, output);
  phase_is_aligned(*discretization, output);
  rigid_bodies_alone(output);
  failures(*discretization, output);
  if (is_root())
    {
      fs::remove_all(directory + "/shapes/taken_00.vtu");
      check(shape_name(17, 5003.9, true) == "mode_017_5004Hz_unstable" &&
              shape_name(3, 0., false) == "mode_003_0Hz",
            "shapes are named by number, frequency and stability");
    }
}
