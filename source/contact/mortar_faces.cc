// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/mortar_faces.h>
#include <squeal/discretization/face_quadrature.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>

#include <deal.II/lac/affine_constraints.h>

#include <algorithm>
#include <functional>
#include <map>

namespace squeal
{
  namespace
  {
    /** Where to take a node for, by its first degree of freedom and where the
     * mapping puts it. */
    using NodePosition =
      std::function<dealii::Point<3>(const dealii::types::global_dof_index,
                                     const dealii::Point<3> &)>;

    /** Nodes of the faces of cells, in the order of a FaceBasis. */
    class FaceNodes
    {
    public:
      FaceNodes(const Discretization &d, const FaceBasis &basis)
        : fe(d.dof_handler().get_fe())
        , basis(basis)
        , values(
            d.mapping(),
            fe,
            dealii::Quadrature<3>(fe.base_element(0).get_unit_support_points()),
            dealii::update_quadrature_points)
        , dofs(fe.n_dofs_per_cell())
      {
      }

      void
      reinit(const Discretization::CellIterator &cell)
      {
        values.reinit(cell);
        cell->get_dof_indices(dofs);
      }

      /** Calls @p visit(node of the basis, support point of the cell) for the
       * nodes of a face. Unit coordinates are ordered so that their tangents,
       * crossed, point outwards. */
      template <typename Visit>
      void
      visit_nodes(const unsigned int f, const Visit &visit) const
      {
        const unsigned int axis = f / 2;
        unsigned int       a = (axis + 1) % 3, b = (axis + 2) % 3;
        if (f % 2 == 0)
          std::swap(a, b);
        const auto &support = values.get_quadrature().get_points();
        for (unsigned int i = 0; i < support.size(); ++i)
          if (std::abs(support[i][axis] - f % 2) < 1e-10)
            visit(basis.column(support[i][a]) +
                    (basis.degree() + 1) * basis.column(support[i][b]),
                  i);
      }

      unsigned int
      n_support_points() const
      {
        return values.get_quadrature().size();
      }

      const dealii::Point<3> &
      position(const unsigned int i) const
      {
        return values.quadrature_point(i);
      }

      dealii::types::global_dof_index
      dof(const unsigned int i, const unsigned int component) const
      {
        return dofs[fe.component_to_system_index(component, i)];
      }

      TargetFace
      face(const unsigned int f, const NodePosition &place = {}) const
      {
        std::vector<dealii::Point<3>> nodes(basis.n_nodes());
        std::vector<std::array<dealii::types::global_dof_index, 3>> node_dofs(
          basis.n_nodes());
        visit_nodes(f, [&](const unsigned int node, const unsigned int i) {
          for (unsigned int c = 0; c < 3; ++c)
            node_dofs[node][c] = dof(i, c);
          nodes[node] = place ? place(dof(i, 0), position(i)) : position(i);
        });
        return {SurfaceFace(basis, nodes), node_dofs, 0};
      }

    private:
      const dealii::FiniteElement<3>              &fe;
      const FaceBasis                             &basis;
      dealii::FEValues<3>                          values;
      std::vector<dealii::types::global_dof_index> dofs;
    };



    bool
    reaches(const Discretization::CellIterator &cell,
            const unsigned int                  body,
            const dealii::BoundingBox<3>       &box)
    {
      if (cell->material_id() != body)
        return false;
      // Curved cells bulge beyond their vertices.
      auto around = cell->bounding_box();
      around.extend(.2 * cell->diameter());
      return around.get_neighbor_type(box) !=
             dealii::NeighborType::not_neighbors;
    }



    /**
     * Places of hanging nodes as their constraints have it. On a curved edge
     * the mapping puts them off the edge of the coarse cell: faces would gape
     * or overlap there, and the constrained motion of a linear field is that of
     * the constrained place.
     */
    class HangingPlaces
    {
    public:
      HangingPlaces(const Discretization         &d,
                    FaceNodes                    &nodes,
                    const unsigned int            body,
                    const dealii::BoundingBox<3> &box)
      {
        if (!d.triangulation().has_hanging_nodes())
          return;
        constraints.reinit(d.relevant_dofs());
        dealii::DoFTools::make_hanging_node_constraints(d.dof_handler(),
                                                        constraints);
        for (const auto &cell : d.dof_handler().active_cell_iterators())
          if (!cell->is_artificial() && reaches(cell, body, box))
            {
              nodes.reinit(cell);
              for (unsigned int i = 0; i < nodes.n_support_points(); ++i)
                // Several cells may map a hanging node: the first one counts.
                known.emplace(nodes.dof(i, 0), nodes.position(i));
            }
      }

      dealii::Point<3>
      position(const dealii::types::global_dof_index dof,
               const dealii::Point<3>               &mapped) const
      {
        if (!constraints.is_constrained(dof))
          return mapped;
        dealii::Point<3> sum;
        for (const auto &[master, weight] :
             *constraints.get_constraint_entries(dof))
          {
            const auto it = known.find(master);
            if (it == known.end())
              return mapped;
            sum += weight * position(master, it->second);
          }
        return sum;
      }

    private:
      dealii::AffineConstraints<double>                           constraints;
      std::map<dealii::types::global_dof_index, dealii::Point<3>> known;
    };



    /** Stands for a hanging node, which has no row of its own. */
    constexpr unsigned int hanging = -2u;

    unsigned int
    free_row(const Discretization &d, const dealii::types::global_dof_index dof)
    {
      const Combination &parts = d.expansion(dof);
      return parts.empty() ? -1u : parts.size() > 1 ? hanging : parts[0].first;
    }
  } // namespace



  std::vector<SourceFace>
  all_faces(const Discretization &d,
            const FaceBasis      &basis,
            const unsigned int    id)
  {
    // Packed as numbers: key, position and rows of every node.
    std::vector<double> mine;
    FaceNodes           nodes(d, basis);
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == id)
            {
              nodes.reinit(cell);
              const TargetFace face = nodes.face(f);
              for (unsigned int a = 0; a < basis.n_nodes(); ++a)
                {
                  mine.push_back(face.dofs[a][2]);
                  for (unsigned int c = 0; c < 3; ++c)
                    {
                      mine.push_back(face.geometry.nodes()[a][c]);
                      mine.push_back(free_row(d, face.dofs[a][c]));
                    }
                }
            }
    const std::vector<double> all = all_gather(mine, d.space()->communicator());
    std::vector<SourceFace>   faces;
    for (std::size_t p = 0; p < all.size();)
      {
        std::vector<unsigned int>                keys;
        std::vector<dealii::Point<3>>            points;
        std::vector<std::array<unsigned int, 3>> rows;
        for (unsigned int a = 0; a < basis.n_nodes(); ++a)
          {
            keys.push_back(static_cast<unsigned int>(all[p++]));
            points.emplace_back();
            rows.emplace_back();
            for (unsigned int c = 0; c < 3; ++c)
              {
                points.back()[c] = all[p++];
                rows.back()[c]   = static_cast<unsigned int>(all[p++]);
              }
          }
        faces.push_back({SurfaceFace(basis, points), keys, rows});
      }
    return faces;
  }



  std::vector<SourceFace>
  source_faces(const Discretization &d,
               const FaceBasis      &basis,
               const unsigned int    id,
               const std::string    &where)
  {
    std::vector<SourceFace> faces = all_faces(d, basis, id);
    for (const SourceFace &face : faces)
      for (const auto &rows : face.rows)
        if (std::count(rows.begin(), rows.end(), hanging) > 0)
          throw InputError(where + ": the source face carries hanging nodes; "
                                   "refine the target body only");
    return faces;
  }



  std::vector<TargetFace>
  target_faces(const Discretization         &d,
               const FaceBasis              &basis,
               const unsigned int            body,
               const dealii::BoundingBox<3> &box)
  {
    FaceNodes           nodes(d, basis);
    const HangingPlaces places(d, nodes, body, box);
    const NodePosition  place = [&](const auto dof, const auto &mapped) {
      return places.position(dof, mapped);
    };
    std::vector<TargetFace> faces;
    for (const auto &cell : d.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary() &&
          reaches(cell, body, box))
        {
          nodes.reinit(cell);
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary())
              {
                faces.push_back(nodes.face(f, place));
                faces.back().id = cell->face(f)->boundary_id();
              }
        }
    return faces;
  }



  dealii::BoundingBox<3>
  bounding_box(const SurfaceFace &face)
  {
    dealii::BoundingBox<3> box(face.nodes());
    box.extend(.1 * face.diameter());
    return box;
  }



  dealii::BoundingBox<3>
  bounding_box(const std::vector<SourceFace> &faces)
  {
    dealii::BoundingBox<3> box = bounding_box(faces.front().geometry);
    for (const auto &face : faces)
      box.merge_with(bounding_box(face.geometry));
    return box;
  }
} // namespace squeal
