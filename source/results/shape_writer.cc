// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/results/shape_writer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace squeal
{
  namespace
  {
    /** Multiples of a power of two near 2^-bits of @p largest: the float's
     * last bits are zero, which zlib makes use of. */
    class Rounding
    {
    public:
      Rounding(const double largest, const int bits)
      {
        int exponent = 0;
        std::frexp(largest, &exponent);
        step = largest > 0. ? std::ldexp(1., exponent - bits) : 1.;
      }

      float
      operator()(const double value) const
      {
        // adding zero turns -0 into 0
        return static_cast<float>(std::nearbyint(value / step) * step + 0.);
      }

    private:
      double step;
    };

    constexpr int displacement_bits = 13, position_bits = 20;



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



    /** Runs @p action on rank 0; what it throws, every rank throws. */
    template <typename Action>
    void
    on_root(const RowSpace &space, const Action &action)
    {
      std::string   text;
      unsigned long head[2] = {0, 0}; // kind of failure, length of the text
      if (space.rank() == 0)
        try
          {
            action();
          }
        catch (const InputError &e)
          {
            text    = e.what();
            head[0] = 1;
          }
        catch (const std::exception &e)
          {
            text    = e.what();
            head[0] = 2;
          }
      head[1] = text.size();
      MPI_Bcast(head, 2, MPI_UNSIGNED_LONG, 0, space.communicator());
      if (head[0] == 0)
        return;
      text.resize(head[1]);
      MPI_Bcast(&text[0], head[1], MPI_CHAR, 0, space.communicator());
      if (head[0] == 1)
        throw InputError(text);
      throw ComputationError(text);
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
    on_root(*discretization.space(), [&]() { set_geometry(); });
  }



  void
  ShapeWriter::set_geometry()
  {
    const auto &g       = mesh.geometry();
    const bool  surface = options.surface_only;
    auto        corners = surface ? g.quads : g.hexahedra;

    std::vector<std::int32_t> number(g.n_points(), -1);
    for (auto &corner : corners)
      {
        if (number[corner] < 0)
          {
            number[corner] = drawn_points.size();
            drawn_points.push_back(corner);
          }
        corner = number[corner];
      }

    const Rounding     rounded(mesh.size(), position_bits);
    std::vector<float> positions;
    for (const unsigned int p : drawn_points)
      for (unsigned int c = 0; c < 3; ++c)
        positions.push_back(rounded(g.points[3 * p + c]));

    const auto               &body = surface ? g.quad_body : g.hexahedron_body;
    const unsigned int        n_corners = surface ? 4 : 8;
    const std::uint8_t        vtk_quad = 9, vtk_hexahedron = 12;
    std::vector<std::int32_t> ends(body.size());
    for (unsigned int i = 0; i < ends.size(); ++i)
      ends[i] = (i + 1) * n_corners;

    grid.n_points  = drawn_points.size();
    grid.n_cells   = body.size();
    grid.vectors   = "displacement";
    grid.scalars   = "body";
    grid.points    = vtk::data_array("Points", 3, positions);
    grid.cell_data = vtk::data_array("body", 1, body);
    if (discretization.space()->n_ranks() > 1 && !surface)
      grid.cell_data += vtk::data_array("subdomain", 1, g.hexahedron_rank);
    grid.cells =
      vtk::data_array("connectivity", 1, corners) +
      vtk::data_array("offsets", 1, ends) +
      vtk::data_array("types",
                      1,
                      std::vector<std::uint8_t>(
                        body.size(), surface ? vtk_quad : vtk_hexahedron));
    std::vector<std::string> names;
    for (const auto &b : discretization.scene().bodies)
      names.push_back(b.name);
    grid.field_data = vtk::texts("body_names", names);
  }



  void
  ShapeWriter::write_shape(const std::string &name,
                           const Block       &real,
                           const Block       &imaginary,
                           const double       frequency,
                           const unsigned int frames,
                           const Metadata    &metadata)
  {
    Assert(frames > 0, dealii::ExcMessage("no frames"));
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
      write_files(name, displacements, phase, frames, field_data);
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
      const double       c = factor * std::cos(phase_offset + phase);
      const double       s = factor * std::sin(phase_offset + phase);
      std::vector<float> values;
      values.reserve(3 * drawn_points.size());
      for (const unsigned int p : drawn_points)
        for (unsigned int i = 3 * p; i < 3 * p + 3; ++i)
          values.push_back(
            rounded(c * displacements(i, 0) - s * displacements(i, 1)));
      return vtk::data_array(field, 3, values);
    };

    const std::string real_and_imaginary =
      at_phase("displacement_real", 0.) +
      at_phase("displacement_imag", -0.5 * M_PI);
    vtk::UnstructuredGrid frame = grid;
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
