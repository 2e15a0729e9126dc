// SPDX-License-Identifier: LGPL-2.1-or-later

// Which degrees of freedom of a Discretization are free, and how they are
// numbered over the ranks.

#include <squeal/base/exceptions.h>
#include <squeal/discretization/discretization.h>

#include <deal.II/base/partitioner.h>
#include <deal.II/base/partitioner.templates.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/lac/affine_constraints.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    using dealii::IndexSet;

    std::array<bool, 6>
    held_components(const SupportParameters &support, const unsigned int axis)
    {
      static const std::array<const char *, 6> names{
        {"x", "y", "z", "rx", "ry", "rz"}};
      std::array<bool, 6> held{};
      for (unsigned int c = 0; c < 6; ++c)
        held[c] =
          support.kind == SupportParameters::Kind::clamped ||
          (c == axis && support.kind == SupportParameters::Kind::held) ||
          std::find(support.components.begin(),
                    support.components.end(),
                    names[c]) != support.components.end();
      return held;
    }

    /** Direction in which a guided or held face can move. Throws InputError. */
    unsigned int
    guided_axis(const CoarseMesh        &mesh,
                const SupportParameters &support,
                const unsigned int       face)
    {
      using Kind = SupportParameters::Kind;
      if (support.kind != Kind::guided && support.kind != Kind::held)
        return -1u;
      const unsigned int axis = axis_of_face(mesh, face);
      if (axis == -1u)
        throw InputError("Scene/Support " + support.name +
                         "/Face: a guided or held face is flat and looks along "
                         "x, y or z; tie another one to a rigid body "
                         "(Scene/Tie) and support that by components");
      return axis;
    }

    IndexSet
    dofs_of_face(const dealii::DoFHandler<3> &dofs,
                 const unsigned int           id,
                 const std::array<bool, 6>   &components)
    {
      dealii::ComponentMask mask(3, false);
      for (unsigned int c = 0; c < 3; ++c)
        mask.set(c, components[c]);
      IndexSet result = dealii::DoFTools::extract_boundary_dofs(
        dofs,
        mask,
        std::set<dealii::types::boundary_id>{
          static_cast<dealii::types::boundary_id>(id)});
      return result;
    }

    /** The smallest index any rank knows on the face: the master that a guided
     * face follows. */
    unsigned int
    smallest_on_any_rank(const IndexSet &set, const MPI_Comm comm)
    {
      unsigned int mine = -1u, smallest;
      for (const auto i : set)
        {
          mine = i;
          break;
        }
      MPI_Allreduce(&mine, &smallest, 1, MPI_UNSIGNED, MPI_MIN, comm);
      return smallest;
    }

    /** Whether any rank knows one of @p set that is zero. */
    bool
    is_held_somewhere(const IndexSet                          &set,
                      const dealii::AffineConstraints<double> &constraints,
                      const MPI_Comm                           comm)
    {
      int held = 0;
      for (const auto i : set)
        if (const auto *entries = constraints.is_constrained(i)
                                    ? constraints.get_constraint_entries(i)
                                    : nullptr;
            entries && entries->empty())
          held = 1;
      MPI_Allreduce(MPI_IN_PLACE, &held, 1, MPI_INT, MPI_MAX, comm);
      return held != 0;
    }

    /** The face moves along its normal as a whole, and not at all where another
     * support holds a part of it. */
    void
    guide(const IndexSet                    &set,
          const MPI_Comm                     comm,
          dealii::AffineConstraints<double> &constraints)
    {
      const unsigned int master  = smallest_on_any_rank(set, comm);
      const bool         is_held = is_held_somewhere(set, constraints, comm);
      for (const auto i : set)
        if (!constraints.is_constrained(i) && (is_held || i != master))
          {
            constraints.add_line(i);
            if (!is_held)
              constraints.add_entry(i, master, 1.);
          }
    }

    /** Guided faces come last: they depend on what else is held. */
    void
    add_supports(const SceneParameters             &scene,
                 const CoarseMesh                  &mesh,
                 const dealii::DoFHandler<3>       &dofs,
                 const MPI_Comm                     comm,
                 dealii::AffineConstraints<double> &constraints)
    {
      using Kind = SupportParameters::Kind;
      for (const bool guided : {false, true})
        for (const auto &support : scene.supports)
          {
            const unsigned int b = body_index(scene, support.body);
            if (scene.bodies[b].shape == BodyParameters::Shape::rigid ||
                support.kind == Kind::free ||
                (support.kind == Kind::guided) != guided)
              continue;
            const unsigned int id =
              face_id(mesh, scene, support.body, support.face);
            const unsigned int axis = guided_axis(mesh, support, id);
            if (guided)
              guide(dofs_of_face(dofs, id, {{axis == 0, axis == 1, axis == 2}}),
                    comm,
                    constraints);
            else
              for (const auto i :
                   dofs_of_face(dofs, id, held_components(support, axis)))
                if (!constraints.is_constrained(i))
                  constraints.add_line(i);
          }
    }

    void
    make_unique(std::vector<IndexSet::value_type> &numbers)
    {
      std::sort(numbers.begin(), numbers.end());
      numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    }

    /** Free numbers of the degrees of freedom that this rank refers to, those
     * of other ranks fetched from them. */
    class FreeNumbers
    {
    public:
      FreeNumbers(const dealii::DoFHandler<3>    &dofs,
                  const std::vector<Combination> &masters,
                  const IndexSet                 &free_owned,
                  const unsigned int              first,
                  const MPI_Comm                  comm)
      {
        std::vector<IndexSet::value_type> needed;
        for (const auto &combination : masters)
          for (const auto &[dof, weight] : combination)
            needed.push_back(dof);
        make_unique(needed);
        IndexSet needed_set(dofs.n_dofs());
        needed_set.add_indices(needed.begin(), needed.end());
        partitioner = std::make_shared<dealii::Utilities::MPI::Partitioner>(
          dofs.locally_owned_dofs(), needed_set, comm);
        const unsigned int n_owned = partitioner->locally_owned_size();
        numbers.assign(n_owned + partitioner->n_ghost_indices(), -1.);
        unsigned int next = first;
        for (const auto i : free_owned)
          numbers[partitioner->global_to_local(i)] = next++;

        std::vector<double>             buffer(partitioner->n_import_indices());
        std::vector<MPI_Request>        requests;
        const dealii::ArrayView<double> ghosts(numbers.data() + n_owned,
                                               partitioner->n_ghost_indices());
        partitioner->export_to_ghosted_array_start<double>(
          0,
          dealii::ArrayView<const double>(numbers.data(), n_owned),
          dealii::ArrayView<double>(buffer.data(), buffer.size()),
          ghosts,
          requests);
        partitioner->export_to_ghosted_array_finish<double>(ghosts, requests);
      }

      /** Number of a degree of freedom; -1 where it is not free. */
      double
      operator()(const dealii::types::global_dof_index dof) const
      {
        return numbers[partitioner->global_to_local(dof)];
      }

    private:
      std::shared_ptr<dealii::Utilities::MPI::Partitioner> partitioner;
      std::vector<double>                                  numbers;
    };
  } // namespace



  void
  Discretization::distribute()
  {
    const auto &scene = *scene_parameters;
    rigid_rows.assign(scene.bodies.size(), {{-1u, -1u, -1u, -1u, -1u, -1u}});
    std::vector<Combination> masters;
    IndexSet                 free_owned(0);
    relevant = IndexSet(0);
    if (has_mesh())
      {
        dofs = std::make_unique<dealii::DoFHandler<3>>(*mesh);
        dofs->distribute_dofs(*fe);
        dealii::DoFTools::extract_locally_relevant_dofs(*dofs, relevant);

        dealii::AffineConstraints<double> constraints(relevant);
        dealii::DoFTools::make_hanging_node_constraints(*dofs, constraints);
        add_supports(scene, coarse, *dofs, comm, constraints);
        constraints.close();

        const IndexSet &owned = dofs->locally_owned_dofs();
        free_owned            = IndexSet(dofs->n_dofs());
        std::vector<IndexSet::value_type> free_list;
        for (const auto i : owned)
          if (!constraints.is_constrained(i))
            free_list.push_back(i);
        free_owned.add_indices(free_list.begin(), free_list.end());
        free_owned.compress();

        masters.resize(relevant.n_elements());
        unsigned int k = 0;
        for (const auto i : relevant)
          {
            if (!constraints.is_constrained(i))
              masters[k] = {{i, 1.}};
            else if (const auto *entries =
                       constraints.get_constraint_entries(i))
              for (const auto &[j, w] : *entries)
                masters[k].emplace_back(j, w);
            ++k;
          }
      }
    number_free_unknowns(masters, free_owned);
  }



  unsigned int
  Discretization::number_rigid_motions()
  {
    const auto  &scene = *scene_parameters;
    unsigned int n     = 0;
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      if (scene.bodies[b].shape == BodyParameters::Shape::rigid)
        {
          std::array<bool, 6> held{};
          for (const auto &support : scene.supports)
            if (support.body == scene.bodies[b].name)
              for (unsigned int c = 0; c < 6; ++c)
                held[c] = held[c] || held_components(support, 2)[c];
          for (unsigned int c = 0; c < 6; ++c)
            if (!held[c])
              rigid_rows[b][c] = n++;
        }
    return n;
  }



  void
  Discretization::number_free_unknowns(const std::vector<Combination> &masters,
                                       const IndexSet &free_owned)
  {
    int rank;
    MPI_Comm_rank(comm, &rank);
    // Rigid bodies come first, on rank 0.
    const unsigned int n_rigid_all = number_rigid_motions();
    const unsigned int n_rigid     = rank == 0 ? n_rigid_all : 0;
    const unsigned int n_mine      = free_owned.n_elements() + n_rigid;
    unsigned int       first = 0, n_total = 0;
    MPI_Exscan(&n_mine, &first, 1, MPI_UNSIGNED, MPI_SUM, comm);
    if (rank == 0)
      first = 0;
    MPI_Allreduce(&n_mine, &n_total, 1, MPI_UNSIGNED, MPI_SUM, comm);
    if (n_total == 0)
      throw InputError("scene '" + scene_parameters->name +
                       "': every displacement is held by Scene/Supports; "
                       "nothing can move");

    expansions.assign(masters.size(), {});
    std::vector<IndexSet::value_type> touched;
    if (has_mesh())
      {
        const FreeNumbers numbers(
          *dofs, masters, free_owned, first + n_rigid, comm);
        for (unsigned int k = 0; k < masters.size(); ++k)
          for (const auto &[dof, weight] : masters[k])
            if (const double number = numbers(dof); number >= 0.)
              {
                expansions[k].emplace_back(static_cast<unsigned int>(number),
                                           weight);
                touched.push_back(static_cast<unsigned int>(number));
              }
      }

    IndexSet owned_rows(n_total), relevant_rows(n_total);
    owned_rows.add_range(first, first + n_mine);
    make_unique(touched);
    relevant_rows.add_indices(touched.begin(), touched.end());
    row_space = std::make_shared<RowSpace>(owned_rows, relevant_rows, comm);
    count_free_of_bodies();
  }



  void
  Discretization::count_free_of_bodies()
  {
    const unsigned int first = row_space->first_owned();
    const unsigned int n     = row_space->n_owned();
    std::vector<bool>  counted(n, false);
    body_free.assign(scene_parameters->bodies.size(), 0);
    const auto count = [&](const unsigned int body, const unsigned int row) {
      if (row < first || row >= first + n || counted[row - first])
        return;
      counted[row - first] = true;
      ++body_free[body];
    };
    for (unsigned int b = 0; b < body_free.size(); ++b)
      for (const unsigned int row : rigid_rows[b])
        if (row != -1u)
          count(b, row);
    if (has_mesh())
      {
        std::vector<dealii::types::global_dof_index> indices(
          fe->n_dofs_per_cell());
        for (const auto &cell : dofs->active_cell_iterators())
          if (!cell->is_artificial())
            {
              cell->get_dof_indices(indices);
              for (const auto i : indices)
                for (const auto &[row, weight] : expansion(i))
                  count(cell->material_id(), row);
            }
      }
    MPI_Allreduce(MPI_IN_PLACE,
                  body_free.data(),
                  static_cast<int>(body_free.size()),
                  MPI_UNSIGNED,
                  MPI_SUM,
                  comm);
  }



  std::vector<double>
  Discretization::expand(const Eigen::VectorXd &free_with_ghosts) const
  {
    std::vector<double> result(expansions.size(), 0.);
    for (unsigned int k = 0; k < expansions.size(); ++k)
      for (const auto &[row, weight] : expansions[k])
        result[k] += weight * free_with_ghosts[row_space->local(row)];
    return result;
  }
} // namespace squeal
