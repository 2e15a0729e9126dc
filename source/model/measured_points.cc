// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/discretization/point_evaluator.h>
#include <squeal/model/measured_points.h>
#include <squeal/results/compare.h>
#include <squeal/scene/imported_model.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    /** Of a cell's size, for points typed with few digits on curved edges. */
    constexpr double tolerance = 1e-3;

    Vector3
    unit(const Vector3 &d)
    {
      const double length = std::hypot(d[0], d[1], d[2]);
      return {{d[0] / length, d[1] / length, d[2] / length}};
    }
  } // namespace



  namespace
  {
    std::vector<Functionals::Row>
    rows_of_bodies(const Parameters &p, const Discretization &d)
    {
      const PointEvaluator          evaluator(d);
      std::vector<Functionals::Row> rows;
      for (const auto &point : p.measurement.points)
        {
          const dealii::Point<3> x(
            point.position[0], point.position[1], point.position[2]);
          const auto found = evaluator.displacements(
            body_index(p.scene, point.body), {x}, tolerance);
          if (!found.found[0])
            throw InputError("Measurement/Point " + point.name +
                             "/Position lies outside body '" + point.body +
                             "'");
          const Vector3 n = unit(point.direction);
          rows.push_back(combine({{n[0], &found.rows[0][0]},
                                  {n[1], &found.rows[0][1]},
                                  {n[2], &found.rows[0][2]}}));
        }
      return rows;
    }

    bool
    is_translation(const ImportedModel &model,
                   const unsigned int   unknown,
                   const unsigned int   body)
    {
      return model.body_of[unknown] == body &&
             model.labels[unknown].component >= 1 &&
             model.labels[unknown].component <= 3;
    }

    double
    distance(const Vector3 &a, const Vector3 &b)
    {
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }

    /** An unknown of the node of a body at a point, from which it may be
     * @p tolerance of the way to the furthest one away. */
    unsigned int
    unknown_at(const ImportedModel           &model,
               const unsigned int             body,
               const MeasuredPointParameters &point)
    {
      const std::string text = "Measurement/Point " + point.name +
                               "/Position is at no node of '" + point.body +
                               "'";
      unsigned int nearest = -1u;
      double       size    = 0.;
      for (unsigned int i = 0; i < model.n_dofs; ++i)
        if (is_translation(model, i, body))
          {
            const double here = distance(model.positions[i], point.position);
            size              = std::max(size, here);
            if (nearest == -1u ||
                here < distance(model.positions[nearest], point.position))
              nearest = i;
          }
      if (nearest == -1u)
        throw InputError(text + ", which has none");
      const Vector3 &place = model.positions[nearest];
      if (!(distance(place, point.position) <= tolerance * size))
        throw InputError(
          text + ": the nearest is " + rounded_text(place[0], 8) + ", " +
          rounded_text(place[1], 8) + ", " + rounded_text(place[2], 8));
      return nearest;
    }

    Functionals::Row
    row_at_node(const ImportedModel           &model,
                const MeasuredPointParameters &point)
    {
      const std::string section = "Measurement/Point " + point.name;
      const auto        body =
        std::find(model.bodies.begin(), model.bodies.end(), point.body);
      if (body == model.bodies.end())
        throw InputError(section + "/Body = '" + point.body +
                         "' is not in 'Scene/Node table file'");
      const unsigned int number = body - model.bodies.begin();
      const long    node = model.labels[unknown_at(model, number, point)].node;
      const Vector3 n    = unit(point.direction);
      Functionals::Row row;
      for (unsigned int i = 0; i < model.n_dofs; ++i)
        if (is_translation(model, i, number) && model.labels[i].node == node)
          if (const double weight = n[model.labels[i].component - 1];
              weight != 0.)
            row.emplace_back(i, weight);
      if (row.empty())
        throw InputError(section + "/Direction: the node is held along it");
      return row;
    }

    std::vector<Functionals::Row>
    rows_of_nodes(const Parameters &p, const ImportedModel &model)
    {
      std::vector<Functionals::Row> rows;
      for (const auto &point : p.measurement.points)
        rows.push_back(row_at_node(model, point));
      return rows;
    }
  } // namespace



  MeasuredPoints::MeasuredPoints(const Model &model)
    : model(model)
  {
    const auto       &p     = model.parameters();
    const auto        space = model.discretization() != nullptr
                                ? model.discretization()->space()
                                : model.linearized().system.space;
    const auto        rows  = model.imported() != nullptr
                                ? rows_of_nodes(p, *model.imported())
                                : rows_of_bodies(p, *model.discretization());
    const Functionals functionals(space, rows);
    all = model.linearized().restrict_forces(functionals.apply_transposed(
      Eigen::MatrixXd(Eigen::MatrixXd::Identity(rows.size(), rows.size()))));
  }

  unsigned int
  MeasuredPoints::size() const
  {
    return all.cols();
  }

  const Block &
  MeasuredPoints::vectors() const
  {
    return all;
  }

  Block
  MeasuredPoints::vectors(const std::vector<unsigned int> &places) const
  {
    Block result(all.rows(), places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
      result.col(i) = all.col(places[i]);
    return result;
  }

  Eigen::MatrixXcd
  MeasuredPoints::sample(const ComplexBlock &shapes) const
  {
    const RowSpace  &space = *model.linearized().system.space;
    Eigen::MatrixXcd result(all.cols(), shapes.cols());
    result.real() = space.dot(all, Block(shapes.real()));
    result.imag() = space.dot(all, Block(shapes.imag()));
    return result;
  }



  bool
  MeasuredPoints::measured_value(const MeasuredShape  &shape,
                                 const unsigned int    point,
                                 std::complex<double> &value) const
  {
    const auto &m = model.parameters().measurement;
    const auto &p = m.points[point];
    if (const auto named = shape.points.find(p.name);
        named != shape.points.end())
      {
        value = named->second;
        return true;
      }
    const auto numbered = shape.nodes.find(m.node(point));
    if (numbered == shape.nodes.end())
      return false;
    const Vector3 n = unit(p.direction);
    value           = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      value += n[c] * numbered->second[c];
    return true;
  }

  MeasuredPoints::Values
  MeasuredPoints::measured_values(const MeasuredShape &shape) const
  {
    Values result;
    for (unsigned int i = 0; i < size(); ++i)
      if (std::complex<double> value; measured_value(shape, i, value))
        {
          result.values.push_back(value);
          result.places.push_back(i);
        }
    return result;
  }

  Eigen::MatrixXd
  MeasuredPoints::mac(const std::vector<MeasuredShape> &measured,
                      const Eigen::MatrixXcd           &sampled) const
  {
    Eigen::MatrixXd result(measured.size(), sampled.cols());
    for (std::size_t m = 0; m < measured.size(); ++m)
      {
        const auto [a, places] = measured_values(measured[m]);
        if (places.size() < 2)
          throw InputError(
            model.parameters().measurement.shapes_file + ": shape '" +
            measured[m].name + "' has " + std::to_string(places.size()) +
            " of the points in Measurement/Points: a MAC needs at least two "
            "(see Point <name>/Node)");
        if (std::all_of(a.begin(), a.end(), [](const auto &value) {
              return value == 0.;
            }))
          throw InputError(model.parameters().measurement.shapes_file +
                           ": shape '" + measured[m].name +
                           "' is zero at all points in Measurement/Points: it "
                           "is like every mode and like none");
        for (Eigen::Index k = 0; k < sampled.cols(); ++k)
          {
            std::vector<std::complex<double>> b;
            for (const unsigned int i : places)
              b.push_back(sampled(i, k));
            result(m, k) = modal_assurance(a, b);
          }
      }
    return result;
  }



  Eigen::VectorXd
  MeasuredPoints::comac(const std::vector<MeasuredShape> &measured,
                        const Eigen::MatrixXcd           &sampled,
                        const Eigen::MatrixXd            &mac) const
  {
    Eigen::VectorXd products  = Eigen::VectorXd::Zero(size()),
                    squares_a = products, squares_b = products;
    for (std::size_t m = 0; m < measured.size() && mac.cols() > 0; ++m)
      {
        Eigen::Index best;
        mac.row(m).maxCoeff(&best);
        const auto [a, places] = measured_values(measured[m]);
        double norm_a = 0., norm_b = 0.;
        for (std::size_t j = 0; j < places.size(); ++j)
          {
            norm_a += std::norm(a[j]);
            norm_b += std::norm(sampled(places[j], best));
          }
        if (norm_a == 0. || norm_b == 0.)
          continue;
        for (std::size_t j = 0; j < places.size(); ++j)
          {
            const double x = std::norm(a[j]) / norm_a,
                         y = std::norm(sampled(places[j], best)) / norm_b;
            products[places[j]] += std::sqrt(x * y);
            squares_a[places[j]] += x;
            squares_b[places[j]] += y;
          }
      }
    Eigen::VectorXd result(size());
    for (Eigen::Index i = 0; i < result.size(); ++i)
      {
        const double size = squares_a[i] * squares_b[i];
        result[i] = size > 0. ? products[i] * products[i] / size : std::nan("");
      }
    return result;
  }
} // namespace squeal
