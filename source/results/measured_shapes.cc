// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/inputs_read.h>
#include <squeal/base/number_text.h>
#include <squeal/base/run_log.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/response_parameters.h>
#include <squeal/parameters/text.h>
#include <squeal/results/measured_shapes.h>
#include <squeal/results/table.h>

#include "dataset_55.h"
#include "universal_lines.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Turn = std::array<Vector3, 3>; /**< the axes of a system */

    /** What a universal file holds. */
    struct UniversalModel
    {
      std::vector<MeasuredShape>      shapes;
      std::map<unsigned int, int>     systems; /**< of the nodes' motions */
      std::map<unsigned int, Vector3> places;  /**< m, in the global axes */
      std::map<int, Turn>             turns;   /**< Cartesian systems */
      std::set<int>                   unread;  /**< systems of other kinds */
      double                          length = 1.; /**< units in a metre */
      OtherDatasets                   other;
    };

    /** The global system has no number, or 1 where the file defines no 1. */
    bool
    is_global(const UniversalModel &model, const int system)
    {
      return system == 0 || (system == 1 && model.turns.count(1) == 0 &&
                             model.unread.count(1) == 0);
    }

    /** Dataset 164: how many of the file's units of length make a metre. */
    double
    read_length(UniversalLines &lines)
    {
      lines.take("the code of the units");
      const double length = lines.numbers(1, 25, 3, "the units")[0];
      if (!(length > 0.))
        lines.fail("the unit of length is not above 0");
      while (!lines.is_mark())
        lines.take("the end of dataset 164");
      lines.take("-1");
      return length;
    }

    /** Datasets 15 (single precision), 781 and 2411 (double precision). */
    void
    read_nodes(UniversalLines &lines,
               const bool      is_double,
               UniversalModel &model)
    {
      while (!lines.is_mark())
        {
          std::vector<double> x;
          std::vector<int>    head;
          if (is_double)
            {
              head = lines.integers(4, "a node");
              x    = lines.numbers(3, 25, 3, "a node's coordinates");
            }
          else
            {
              const auto all =
                lines.fields({10, 10, 10, 10, 13, 13, 13}, "a node");
              for (unsigned int i = 0; i < 4; ++i)
                head.push_back(static_cast<int>(all[i]));
              x.assign(all.begin() + 4, all.end());
            }
          if (head[0] < 1)
            lines.fail("node " + std::to_string(head[0]) + " is below 1");
          const auto found = model.systems.emplace(head[0], head[2]).first;
          if (found->second != head[2])
            lines.fail("node " + std::to_string(head[0]) +
                       " is there twice, with two displacement systems");
          if (head[1] == 0 || head[1] == 1)
            model.places[head[0]] = {{x[0], x[1], x[2]}};
        }
      lines.take("the end of the dataset");
    }

    /** Dataset 18: origin, a point on the x axis and one in the x-z plane. */
    void
    read_systems(UniversalLines &lines, UniversalModel &model)
    {
      while (!lines.is_mark())
        {
          const auto head = lines.integers(5, "a coordinate system");
          lines.take("a coordinate system's name");
          const auto p =
            lines.numbers(9, 13, 6, "the axes of a coordinate system");
          const Eigen::Vector3d o(p[0], p[1], p[2]);
          const Eigen::Vector3d x = Eigen::Vector3d(p[3], p[4], p[5]) - o;
          const Eigen::Vector3d y =
            (Eigen::Vector3d(p[6], p[7], p[8]) - o).cross(x);
          if (head[1] != 0 || head[2] != 0 ||
              !(y.norm() > 1e-6 * x.squaredNorm()))
            {
              model.unread.insert(head[0]);
              continue;
            }
          const Eigen::Vector3d z    = x.cross(y);
          Turn                 &turn = model.turns[head[0]];
          for (unsigned int c = 0; c < 3; ++c)
            {
              turn[0][c] = x[c] / x.norm();
              turn[1][c] = y[c] / y.norm();
              turn[2][c] = z[c] / z.norm();
            }
        }
      lines.take("the end of the dataset");
    }

    /** Dataset 2420: systems that are not read but known to be there, except
     * for the global one. */
    void
    read_transformations(UniversalLines &lines, UniversalModel &model)
    {
      lines.take("a part");
      lines.take("a part's name");
      while (!lines.is_mark())
        {
          const auto head = lines.integers(3, "a coordinate system");
          lines.take("a coordinate system's name");
          const auto m =
            lines.numbers(12, 25, 3, "the axes of a coordinate system");
          bool is_unit = head[1] == 0;
          for (unsigned int i = 0; i < 12; ++i)
            is_unit = is_unit && std::abs(m[i] - (i % 4 == 0 && i < 9)) < 1e-9;
          if (is_unit)
            model.turns[head[0]] = {
              {{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}}};
          else
            model.unread.insert(head[0]);
        }
      lines.take("the end of the dataset");
    }

    /** Brings the motions of all nodes into the global axes. */
    void
    turn_shapes(const std::string &path, UniversalModel &model)
    {
      for (auto &shape : model.shapes)
        for (auto &[node, value] : shape.nodes)
          {
            const auto at = model.systems.find(node);
            if (at == model.systems.end() || is_global(model, at->second))
              continue;
            const auto turn = model.turns.find(at->second);
            if (turn == model.turns.end())
              throw InputError(
                path + ": the motion of node " + std::to_string(node) +
                " is in coordinate system " + std::to_string(at->second) +
                ", which is " +
                (model.unread.count(at->second) ? "no Cartesian one of dataset "
                                                  "18 in the global system"
                                                : "not in the file") +
                ": write the motions in the global axes (system 0)");
            const auto local = value;
            value            = {};
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int c = 0; c < 3; ++c)
                value[c] += turn->second[i][c] * local[i];
          }
    }

    /** Of conjugate pairs that a file holds whole the members with a negative
     * imaginary part say nothing new. */
    void
    drop_second_members(std::vector<MeasuredShape> &shapes)
    {
      const std::vector<MeasuredShape> all = shapes;
      const auto is_second = [&all](const MeasuredShape &shape) {
        const auto lambda = std::conj(shape.eigenvalue);
        return lambda.imag() > 0. &&
               std::any_of(all.begin(), all.end(), [&](const auto &other) {
                 return std::abs(other.eigenvalue - lambda) <=
                        1e-6 * std::abs(lambda);
               });
      };
      shapes.erase(std::remove_if(shapes.begin(), shapes.end(), is_second),
                   shapes.end());
    }

    UniversalModel
    read_universal(const std::string &path)
    {
      UniversalLines lines(path);
      UniversalModel model;
      while (!lines.at_end())
        {
          if (!lines.is_mark())
            {
              if (prm::trim(lines.take("a line")).empty())
                continue;
              lines.fail("expected -1 at the start of a dataset");
            }
          lines.take("-1");
          const std::string number =
            prm::trim(lines.take("a dataset's number"));
          if (number == "55")
            {
              if (auto shape = read_dataset_55(lines, model.other))
                model.shapes.push_back(std::move(*shape));
            }
          else if (number == "15" || number == "781" || number == "2411")
            read_nodes(lines, number != "15", model);
          else if (number == "18")
            read_systems(lines, model);
          else if (number == "2420")
            read_transformations(lines, model);
          else if (number == "164")
            model.length = read_length(lines);
          else
            {
              if (number.empty() || number.find_first_not_of("0123456789bB ") !=
                                      std::string::npos)
                lines.fail("'" + number + "' is no number of a dataset");
              while (!lines.is_mark())
                lines.take("the end of dataset " + number);
              lines.take("-1");
            }
        }
      turn_shapes(path, model);
      drop_second_members(model.shapes);
      return model;
    }

    std::vector<MeasuredShape>
    read_table(const std::string &path)
    {
      using Type                       = Table::Type;
      const Table                table = read_csv(path,
                                   {{"shape", Type::text, "", ""},
                                                   {"frequency_hz", Type::real, "Hz", ""},
                                                   {"point", Type::text, "", ""},
                                                   {"real", Type::real, "", ""},
                                                   {"imag", Type::real, "", ""}});
      std::vector<MeasuredShape> shapes;
      for (std::size_t r = 0; r < table.n_rows(); ++r)
        {
          const std::string name  = table.text(r, "shape");
          const std::string place = path + ":" + std::to_string(r + 2) + ": ";
          for (const char *column : {"frequency_hz", "real", "imag"})
            if (table.is_missing(r, column))
              throw InputError(place + "no value of " + column);
          MeasuredShape *shape = nullptr;
          for (auto &candidate : shapes)
            if (candidate.name == name)
              shape = &candidate;
          if (!shape)
            {
              shapes.emplace_back();
              shape            = &shapes.back();
              shape->name      = name;
              shape->frequency = table.real(r, "frequency_hz");
            }
          else if (shape->frequency != table.real(r, "frequency_hz"))
            throw InputError(place + "shape '" + name +
                             "' has another frequency above: give each shape "
                             "a name of its own");
          if (!shape->points
                 .insert({table.text(r, "point"),
                          {table.real(r, "real"), table.real(r, "imag")}})
                 .second)
            throw InputError(place + "shape '" + name + "' has point '" +
                             table.text(r, "point") + "' twice");
        }
      return shapes;
    }
  } // namespace



  namespace
  {
    UniversalModel
    read_shapes(const std::string &path)
    {
      std::istringstream in(read_input_file(path));
      std::string        line;
      while (std::getline(in, line) && prm::trim(line).empty())
        ;
      UniversalModel model;
      if (prm::trim(line) == "-1")
        model = read_universal(path);
      else
        model.shapes = read_table(path);
      if (model.shapes.empty())
        throw InputError(
          path + ": holds no shape (" +
          (model.other.skipped.empty()
             ? "no dataset 55, no row"
             : "no displacements, velocities or accelerations: " +
                 model.other.skipped) +
          ")");
      return model;
    }

    double
    distance(const Vector3 &a, const Vector3 &b)
    {
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }

    /** Refuses nodes that lie elsewhere than the points of their numbers: by
     * more than a tenth of the extent of the points, as measured places are
     * never exact. Files whose nodes are all at 0 give no places. */
    void
    refuse_other_places(const UniversalModel        &model,
                        const MeasurementParameters &m)
    {
      double extent = 0., largest = 0.;
      for (const auto &a : m.points)
        for (const auto &b : m.points)
          extent = std::max(extent, distance(a.position, b.position));
      for (const auto &[node, place] : model.places)
        largest = std::max(largest, distance(place, {{0., 0., 0.}}));
      if (extent == 0. || largest == 0.)
        return;
      for (unsigned int i = 0; i < m.points.size(); ++i)
        if (const auto at = model.places.find(m.node(i));
            at != model.places.end())
          {
            Vector3 place = at->second;
            for (double &x : place)
              x /= model.length;
            const double d = distance(place, m.points[i].position);
            if (d > 0.1 * extent)
              throw InputError(
                m.shapes_file + ": node " + std::to_string(at->first) +
                " lies " + rounded_text(d, 3) + " m from point '" +
                m.points[i].name +
                "' of Measurement/Points: give the nodes of the file "
                "coordinates in the axes of the scene, in the unit of dataset "
                "164 (metres without it)");
          }
    }

    void
    tell(const OtherDatasets &other, const std::string &path, RunLog &log)
    {
      if (!other.skipped.empty())
        log.info(path + ": not taken as shapes, as they are no motions: " +
                 other.skipped);
      if (!other.unsaid.empty())
        log.warning(path +
                    " does not say whether its datasets 55 are motions; they "
                    "are taken as such: " +
                    other.unsaid);
    }
  } // namespace



  std::vector<MeasuredShape>
  read_measured_shapes(const std::string &path)
  {
    return read_shapes(path).shapes;
  }

  std::vector<MeasuredShape>
  read_measured_shapes(const MeasurementParameters &measurement, RunLog &log)
  {
    std::vector<std::string> names;
    for (const auto &point : measurement.points)
      names.push_back(point.name);
    const UniversalModel model = read_shapes(measurement.shapes_file);
    refuse_other_places(model, measurement);
    tell(model.other, measurement.shapes_file, log);
    const auto &shapes = model.shapes;
    for (const auto &shape : shapes)
      for (const auto &[name, value] : shape.points)
        if (measurement.find(name) < 0)
          throw InputError(measurement.shapes_file + ": shape '" + shape.name +
                           "' has point '" + name +
                           "', which is not in Measurement/Points" +
                           prm::did_you_mean(name, names));
    return shapes;
  }
} // namespace squeal
