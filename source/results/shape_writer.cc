// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/results/shape_writer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace squeal
{
  namespace
  {
    constexpr int displacement_bits = 13;



    /** The largest |Re(u e^(i phase))| of any point in the period: the longest
     * half axis of the points' ellipses. */
    double
    largest_motion(const Eigen::MatrixXd &u)
    {
      double largest = 0.;
      for (int i = 0; i < u.rows(); i += 3)
        {
          const Eigen::Vector3d a = u.block<3, 1>(i, 0),
                                b = u.block<3, 1>(i, 1);
          const double mean       = 0.5 * (a.squaredNorm() + b.squaredNorm());
          const double half       = 0.5 * (a.squaredNorm() - b.squaredNorm());
          largest =
            std::max(largest, std::sqrt(mean + std::hypot(half, a.dot(b))));
        }
      return largest;
    }



    std::string
    two_digits(const unsigned int i)
    {
      return (i < 10 ? "0" : "") + std::to_string(i);
    }
  } // namespace



  ShapeWriter::ShapeWriter(const Discretization &discretization,
                           OutputDirectory      &output,
                           const ShapeOptions   &options)
    : discretization(discretization)
    , output(output)
    , options(options)
    , mesh(discretization, options.n_subdivisions)
  {
    on_root(*discretization.space(), [&]() {
      bodies = std::make_unique<DrawnBodies>(
        discretization, mesh, options.surface_only);
    });
  }



  void
  ShapeWriter::write_shape(const std::string &name,
                           const Block       &real,
                           const Block       &imaginary,
                           const double       frequency,
                           const unsigned int frames,
                           const Metadata    &metadata)
  {
    const RowSpace &space = *discretization.space();
    Block           both  = Block::Zero(space.n_owned(), 2);
    both.col(0)           = real;
    if (imaginary.cols() > 0)
      both.col(1) = imaginary;
    const double phase =
      options.align_phase
        ? phase_of_largest_motion(space, both.col(0), both.col(1))
        : 0.;
    const Eigen::MatrixXd displacements = mesh.displacements(both);
    on_root(space, [&]() {
      std::string field_data =
        vtk::texts("name", {name}) + vtk::number("frequency_hz", frequency);
      for (const auto &[key, value] : metadata)
        field_data += vtk::number(key, value);
      write_files(name, displacements, phase, std::max(frames, 1u), field_data);
    });
  }



  void
  ShapeWriter::write_files(const std::string     &name,
                           const Eigen::MatrixXd &displacements,
                           const double           phase_offset,
                           const unsigned int     frames,
                           const std::string     &field_data)
  {
    if (!displacements.allFinite())
      throw ComputationError("the shape '" + name + "' is not finite");
    const double   largest = largest_motion(displacements);
    const double   drawn   = options.display_scale * mesh.size();
    const double   factor  = largest > 0. ? drawn / largest : 0.;
    const Rounding rounded(drawn, displacement_bits);

    const auto at_phase = [&](const char *field, const double phase) {
      const double c = factor * std::cos(phase_offset + phase);
      const double s = factor * std::sin(phase_offset + phase);
      return bodies->point_vector(
        field,
        [&](const unsigned int i) {
          return c * displacements(i, 0) - s * displacements(i, 1);
        },
        rounded);
    };

    const std::string real_and_imaginary =
      at_phase("displacement_real", 0.) +
      at_phase("displacement_imag", -0.5 * M_PI);
    vtk::UnstructuredGrid frame = bodies->grid();
    frame.vectors               = "displacement";
    frame.field_data += field_data + vtk::number("display_factor", factor) +
                        vtk::number("phase_offset_rad", phase_offset);
    const std::string common_field_data = frame.field_data;

    std::vector<std::pair<double, std::string>> steps;
    for (unsigned int k = 0; k < frames; ++k)
      {
        const double      time  = static_cast<double>(k) / frames;
        const double      phase = 2. * M_PI * time;
        const std::string file =
          "shapes/" + name + (frames > 1 ? "_" + two_digits(k) : "") + ".vtu";
        frame.point_data = at_phase("displacement", phase) + real_and_imaginary;
        frame.field_data = common_field_data + vtk::number("phase_rad", phase);
        write_atomically(output.file(file), [&](std::ostream &out) {
          vtk::write_vtu(out, frame);
        });
        steps.emplace_back(time, file);
      }
    write_atomically(output.file(name + ".pvd"),
                     [&](std::ostream &out) { out << vtk::collection(steps); });
  }



  std::string
  shape_name(const unsigned int index,
             const double       frequency,
             const bool         unstable)
  {
    char text[64];
    std::snprintf(text, sizeof(text), "mode_%03u_%.0fHz", index, frequency);
    return text + std::string(unstable ? "_unstable" : "");
  }
} // namespace squeal
