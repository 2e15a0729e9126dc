// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/model/point_remarks.h>
#include <squeal/scene/coarse_mesh.h>

#include <deal.II/distributed/tria.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** Stiffness of a point, over that of a cell, that counts. */
    constexpr double least_ratio = 1e-4;

    /** Mean edge of the cells of a body, m, and their stiffness, N/m; without
     * cells of a rigid body, on which points are exact. */
    struct CellSize
    {
      double edge = 0., stiffness = 0.;
    };

    std::vector<CellSize>
    cell_sizes(const Model &model)
    {
      const auto     &bodies  = model.parameters().scene.bodies;
      Eigen::MatrixXd n_cells = Eigen::MatrixXd::Zero(bodies.size(), 1);
      for (const auto &cell :
           model.discretization()->triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          n_cells(cell->material_id(), 0) += 1.;
      model.discretization()->space()->sum(n_cells);
      std::vector<CellSize> result(bodies.size());
      for (std::size_t b = 0; b < bodies.size(); ++b)
        {
          const BodyParameters &body = bodies[b];
          if (body.shape == BodyParameters::Shape::rigid || n_cells(b, 0) == 0.)
            continue;
          const double modulus =
            body.material_model == BodyParameters::MaterialModel::isotropic
              ? body.young_modulus
              : *std::max_element(body.young_moduli.begin(),
                                  body.young_moduli.end());
          result[b].edge =
            std::cbrt(model.body_matrices()[b].volume / n_cells(b, 0));
          result[b].stiffness = modulus * result[b].edge;
        }
      return result;
    }

    std::string
    remark(const std::string &what,
           const std::string &body,
           const std::string &way_out)
    {
      return what + " acts at single points of body '" + body +
             "': its frequencies go down without limit as the mesh is refined, "
             "and the stated mesh error does not cover that; " +
             way_out;
    }

    /** Of the spring at its points, N/m, in the stiffest direction. */
    double
    largest_stiffness(const SpringParameters &spring)
    {
      double result = spring.stiffness;
      for (const double k : spring.stiffnesses)
        result = std::max(result, k);
      return result;
    }

    /** Between two points of a row, m; infinite for one alone. */
    double
    spacing(const SpringParameters &spring)
    {
      if (spring.number < 2)
        return std::numeric_limits<double>::infinity();
      double square = 0.;
      for (unsigned int c = 0; c < 3; ++c)
        square += std::pow(spring.last_point[c] - spring.first_point[c], 2);
      return std::sqrt(square) / (spring.number - 1);
    }
  } // namespace



  std::vector<std::string>
  remarks_on_points(const Model &model)
  {
    std::vector<std::string> remarks;
    if (!model.discretization() || !model.discretization()->has_mesh())
      return remarks;
    const auto &scene = model.parameters().scene;
    const auto  cells = cell_sizes(model);
    const auto  bends = [&](const std::string &body, const double stiffness) {
      const CellSize &cell = cells[body_index(scene, body)];
      return cell.edge > 0. && stiffness > least_ratio * cell.stiffness;
    };
    const double omega = 2. * M_PI * model.parameters().eigen.highest_frequency;
    for (const auto &mass : scene.lumped_masses)
      if (bends(mass.body, mass.mass * omega * omega))
        remarks.push_back(remark("lumped mass '" + mass.name + "'",
                                 mass.body,
                                 "make it a body that is tied to a face"));
    for (const auto &spring : scene.springs)
      for (const std::string &body : {spring.body, spring.other_body})
        if (spring.kind == SpringParameters::Kind::points && body != "ground" &&
            bends(body, largest_stiffness(spring)) &&
            spacing(spring) > cells[body_index(scene, body)].edge)
          remarks.push_back(remark("spring '" + spring.name + "'",
                                   body,
                                   "spread it over a face ('Kind = area')"));
    return remarks;
  }
} // namespace squeal
