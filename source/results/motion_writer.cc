// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/results/motion_writer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace squeal
{
  namespace
  {
    /** Finer than what a screen shows: the numbers are compared with those of
     * the tables. */
    constexpr int motion_bits = 22;

    double
    longest_vector(const Eigen::MatrixXd &u)
    {
      double largest = 0.;
      for (Eigen::Index k = 0; k < u.cols(); ++k)
        for (Eigen::Index i = 0; i + 2 < u.rows(); i += 3)
          largest = std::max(largest, u.block<3, 1>(i, k).norm());
      return largest;
    }

    /** Puts places, about the axis, or vectors of the points of @p body turned
     * to those of a frame. */
    void
    turn_points(const DisplayMesh::Geometry &g,
                const TurnedBody            &body,
                const double                 angle,
                const bool                   are_places,
                Eigen::VectorXd             &values)
    {
      std::vector<bool> is_done(g.n_points(), false);
      const double      c = std::cos(angle), s = std::sin(angle),
                   x0 = are_places ? body.x : 0., y0 = are_places ? body.y : 0.;
      for (std::size_t i = 0; i < g.hexahedra.size(); ++i)
        {
          const auto p = static_cast<std::size_t>(g.hexahedra[i]);
          if (is_done[p] ||
              g.hexahedron_body[i / 8] != static_cast<std::int32_t>(body.body))
            continue;
          is_done[p]     = true;
          const double x = values[3 * p] - x0, y = values[3 * p + 1] - y0;
          values[3 * p]     = x0 + c * x - s * y;
          values[3 * p + 1] = y0 + s * x + c * y;
        }
    }

    /** The same for all bodies that are turned in frame @p k. */
    Eigen::VectorXd
    turned_points(const DisplayMesh::Geometry   &g,
                  const std::vector<TurnedBody> &turned,
                  const std::size_t              k,
                  const bool                     are_places,
                  Eigen::VectorXd                values)
    {
      for (const TurnedBody &body : turned)
        turn_points(g, body, body.angles.at(k), are_places, values);
      return values;
    }
  } // namespace



  std::string
  frame_file(const std::string &name, const std::size_t k)
  {
    char number[32];
    std::snprintf(number, sizeof(number), "_%04zu.vtu", k);
    return "frames/" + name + number;
  }



  WrittenMotion
  write_motion(const Discretization          &discretization,
               OutputDirectory               &output,
               const std::string             &name,
               const std::vector<double>     &times,
               const Block                   &motion,
               const unsigned int             n_subdivisions,
               const double                   display_scale,
               const std::vector<TurnedBody> &turned)
  {
    Assert(motion.cols() == static_cast<Eigen::Index>(times.size()),
           dealii::ExcMessage("one column for each time"));
    const DisplayMesh     mesh(discretization, n_subdivisions);
    const Eigen::MatrixXd u = mesh.displacements(motion);
    WrittenMotion         written;
    on_root(*discretization.space(), [&]() {
      if (!u.allFinite())
        throw ComputationError("the motion '" + name + "' is not finite");
      const auto           &g      = mesh.geometry();
      const Eigen::VectorXd mean   = u.rowwise().mean(),
                            places = Eigen::Map<const Eigen::VectorXd>(
                              g.points.data(), g.points.size());
      const DrawnBodies bodies(discretization, mesh, false);
      written.largest_displacement = longest_vector(u);
      written.largest_deviation    = longest_vector(u.colwise() - mean);
      if (written.largest_deviation > 0.)
        written.display_factor =
          display_scale * mesh.size() / written.largest_deviation;
      const Rounding whole(written.largest_displacement, motion_bits),
        part(written.largest_deviation, motion_bits);
      std::vector<std::pair<double, std::string>> steps;
      for (std::size_t k = 0; k < times.size(); ++k)
        {
          vtk::UnstructuredGrid frame = bodies.grid();
          frame.vectors               = "deviation";
          frame.field_data +=
            vtk::number("time_s", times[k]) +
            vtk::number("display_factor", written.display_factor);
          const auto seen = [&](const Eigen::VectorXd &values) {
            return turned_points(g, turned, k, false, values);
          };
          const Eigen::VectorXd motion_there    = seen(u.col(k)),
                                deviation_there = seen(u.col(k) - mean),
                                points =
                                  turned_points(g, turned, k, true, places);
          if (!turned.empty())
            frame.points = bodies.point_vector(
              "Points",
              [&](const unsigned int i) { return points[i]; },
              Rounding(mesh.size(), motion_bits));
          frame.point_data =
            bodies.point_vector(
              "displacement",
              [&](const unsigned int i) { return motion_there[i]; },
              whole) +
            bodies.point_vector(
              "deviation",
              [&](const unsigned int i) { return deviation_there[i]; },
              part);
          const std::string file = frame_file(name, k);
          write_atomically(output.file(file), [&](std::ostream &out) {
            vtk::write_vtu(out, frame);
          });
          steps.emplace_back(times[k], file);
        }
      write_atomically(output.file(name + ".pvd"), [&](std::ostream &out) {
        out << vtk::collection(steps);
      });
    });
    return written;
  }
} // namespace squeal
