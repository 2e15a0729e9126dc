// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/discretization/discretization.h>
#include <squeal/scene/layer_mesh.h>
#include <squeal/scene/turning.h>

#include <deal.II/distributed/grid_refinement.h>
#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  Discretization::Discretization(const SceneParameters          &scene,
                                 const DiscretizationParameters &p,
                                 const unsigned int              degree,
                                 const MPI_Comm                  communicator)
    : scene_parameters(&scene)
    , parameters(p)
    , comm(communicator)
    , coarse(make_coarse_mesh(scene))
    , fe(std::make_unique<dealii::FESystem<3>>(dealii::FE_Q<3>(degree), 3))
    , curved_mapping(std::make_unique<dealii::MappingQ<3>>(degree))
  {
    if (!coarse.cells.empty())
      {
        create_mesh();
        mesh->refine_global(p.refinements);
      }
    distribute();
  }

  Discretization::~Discretization()
  {
    dofs.reset();
  }



  void
  Discretization::create_mesh()
  {
    mesh = std::make_shared<Triangulation>(
      comm,
      dealii::Triangulation<3>::MeshSmoothing(dealii::Triangulation<3>::none));
    try
      {
        mesh->create_triangulation(
          coarse.vertices, coarse.cells, coarse.boundary);
      }
    catch (const dealii::ExceptionBase &e)
      {
        throw InputError(
          "the scene '" + scene_parameters->name +
          "' cannot be meshed: inverted cells, or two bodies that share "
          "vertices by accident");
      }
    attach_manifolds();
  }



  void
  Discretization::attach_manifolds()
  {
    // Cells inherit manifold ids when refined: set once on the coarse mesh.
    for (unsigned int b = 0; b < scene_parameters->bodies.size(); ++b)
      {
        const auto &body     = scene_parameters->bodies[b];
        const bool  annulus  = body.shape == BodyParameters::Shape::annulus;
        const bool  cylinder = body.shape == BodyParameters::Shape::cylinder;
        if (!annulus && !cylinder)
          continue;
        const dealii::types::manifold_id id = b + 1;
        for (const auto &cell : mesh->cell_iterators_on_level(0))
          if (cell->material_id() == b)
            {
              if (annulus)
                cell->set_all_manifold_ids(id);
              for (const unsigned int f : cell->face_indices())
                if (cell->face(f)->at_boundary() &&
                    cell->face(f)->boundary_id() == face_id(b, 0) && cylinder)
                  cell->face(f)->set_all_manifold_ids(id);
            }
        mesh->set_manifold(
          id,
          dealii::CylindricalManifold<3>(dealii::Tensor<1, 3>({0., 0., 1.}),
                                         turned_position(body)));
      }
    attach_manifolds_of_layers();
    attach_charts();
  }



  void
  Discretization::attach_manifolds_of_layers()
  {
    for (unsigned int b = 0; b < scene_parameters->bodies.size(); ++b)
      {
        const auto &body = scene_parameters->bodies[b];
        if (body.shape != BodyParameters::Shape::layer)
          continue;
        const auto &bottom = bottom_body(*scene_parameters, body);
        const dealii::types::manifold_id id =
          1 + body_index(*scene_parameters, bottom.name);
        const dealii::Point<3> axis = turned_position(bottom);
        // Of a cylinder only what lies on its side or outside of it is round.
        const auto is_round = [&](const auto &face) {
          std::array<double, 4> r;
          for (unsigned int v = 0; v < 4; ++v)
            r[v] = std::hypot(face->vertex(v)[0] - axis[0],
                              face->vertex(v)[1] - axis[1]);
          const auto [low, high] = std::minmax_element(r.begin(), r.end());
          return *low > (1. - 1e-9) * bottom.outer_radius &&
                 *high < (1. + 1e-9) * *low;
        };
        for (const auto &cell : mesh->cell_iterators_on_level(0))
          if (cell->material_id() == b)
            {
              if (bottom.shape == BodyParameters::Shape::annulus)
                cell->set_all_manifold_ids(id);
              else if (bottom.shape == BodyParameters::Shape::cylinder)
                for (const unsigned int f : cell->face_indices())
                  if (is_round(cell->face(f)))
                    cell->face(f)->set_all_manifold_ids(id);
            }
      }
  }



  void
  Discretization::attach_charts()
  {
    const unsigned int first = scene_parameters->bodies.size() + 1;
    for (const auto &cell : mesh->cell_iterators_on_level(0))
      if (const auto it = coarse.curved.find(cell->index());
          it != coarse.curved.end())
        {
          Assert(cell->vertex_index(0) ==
                   coarse.cells[cell->index()].vertices[0],
                 dealii::ExcInternalError());
          cell->set_all_manifold_ids(first + cell->index());
          mesh->set_manifold(first + cell->index(), *chart_of_cell(it->second));
        }
  }



  void
  Discretization::refine(const std::vector<double>       &indicators,
                         const double                     share,
                         const std::vector<unsigned int> &whole)
  {
    dealii::Vector<float> criteria(mesh->n_active_cells());
    for (unsigned int i = 0; i < criteria.size(); ++i)
      criteria[i] = static_cast<float>(indicators[i]);
    dealii::parallel::distributed::GridRefinement::
      refine_and_coarsen_fixed_fraction(*mesh, criteria, share, 0.);
    mesh->execute_coarsening_and_refinement();
    make_even(whole);
    distribute();
  }



  void
  Discretization::make_even(const std::vector<unsigned int> &faces)
  {
    const auto faces_at = [](const auto &cell, const unsigned int id) {
      std::vector<unsigned int> result;
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == id)
          result.push_back(f);
      return result;
    };
    for (bool changed = true; changed;)
      {
        changed = false;
        for (const unsigned int id : faces)
          {
            int               finest = 0;
            std::vector<bool> is_there(mesh->n_vertices(), false);
            for (const auto &cell : mesh->active_cell_iterators())
              if (!cell->is_artificial())
                for (const unsigned int f : faces_at(cell, id))
                  {
                    finest = std::max(finest, cell->level());
                    for (const unsigned int v : cell->face(f)->vertex_indices())
                      is_there[cell->face(f)->vertex_index(v)] = true;
                  }
            MPI_Allreduce(MPI_IN_PLACE, &finest, 1, MPI_INT, MPI_MAX, comm);
            // Cells beside the face share an edge of it, two of its corners:
            // coarser ones would make the nodes of its border hang.
            for (const auto &cell : mesh->active_cell_iterators())
              if (cell->is_locally_owned() && cell->level() < finest)
                {
                  unsigned int n_there = 0;
                  for (const unsigned int v : cell->vertex_indices())
                    n_there += is_there[cell->vertex_index(v)];
                  if (n_there >= 2)
                    {
                      cell->set_refine_flag();
                      changed = true;
                    }
                }
          }
        int any = changed;
        MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, comm);
        changed = any != 0;
        if (changed)
          mesh->execute_coarsening_and_refinement();
      }
  }



  std::unique_ptr<Discretization>
  Discretization::with_degree(const unsigned int degree) const
  {
    auto other =
      std::unique_ptr<Discretization>(new Discretization(*this, degree));
    return other;
  }

  Discretization::Discretization(const Discretization &other,
                                 const unsigned int    degree)
    : scene_parameters(other.scene_parameters)
    , parameters(other.parameters)
    , comm(other.comm)
    , coarse(other.coarse)
    , mesh(other.mesh)
    , fe(std::make_unique<dealii::FESystem<3>>(dealii::FE_Q<3>(degree), 3))
    , curved_mapping(std::make_unique<dealii::MappingQ<3>>(degree))
  {
    distribute();
  }



  const SceneParameters &
  Discretization::scene() const
  {
    return *scene_parameters;
  }

  const CoarseMesh &
  Discretization::coarse_mesh() const
  {
    return coarse;
  }

  bool
  Discretization::has_mesh() const
  {
    return mesh != nullptr;
  }

  bool
  Discretization::has_lumped_mass() const
  {
    return parameters.mass == DiscretizationParameters::Mass::lumped;
  }

  unsigned int
  Discretization::degree() const
  {
    return fe->degree;
  }

  const Discretization::Triangulation &
  Discretization::triangulation() const
  {
    return *mesh;
  }

  const dealii::DoFHandler<3> &
  Discretization::dof_handler() const
  {
    return *dofs;
  }

  const dealii::Mapping<3, 3> &
  Discretization::mapping() const
  {
    return *curved_mapping;
  }

  std::shared_ptr<const RowSpace>
  Discretization::space() const
  {
    return row_space;
  }

  unsigned int
  Discretization::n_dofs() const
  {
    return has_mesh() ? dofs->n_dofs() : 0;
  }

  const std::vector<unsigned int> &
  Discretization::n_free_of_body() const
  {
    return body_free;
  }

  const Combination &
  Discretization::expansion(const dealii::types::global_dof_index dof) const
  {
    return expansions[relevant.index_within_set(dof)];
  }

  unsigned int
  Discretization::rigid_row(const unsigned int body,
                            const unsigned int motion) const
  {
    return rigid_rows[body][motion];
  }

  const dealii::IndexSet &
  Discretization::relevant_dofs() const
  {
    return relevant;
  }
} // namespace squeal
