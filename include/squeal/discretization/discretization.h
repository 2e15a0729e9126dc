// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_discretization_discretization_h
#define squeal_discretization_discretization_h

#include <squeal/base/row_space.h>
#include <squeal/parameters/analysis_parameters.h>
#include <squeal/scene/coarse_mesh.h>

#include <deal.II/base/index_set.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <memory>
#include <vector>

namespace dealii
{
  template <int, int>
  class Mapping;
  namespace parallel
  {
    namespace distributed
    {
      template <int, int>
      class Triangulation;
    }
  } // namespace parallel
} // namespace dealii

namespace squeal
{
  /** A linear combination of free unknowns: (row, weight). */
  using Combination = std::vector<std::pair<unsigned int, double>>;

  /**
   * The finite element space of a scene and its free unknowns: displacement
   * components that are neither held by a support nor fixed by hanging nodes,
   * plus the six motions (x, y, z, rx, ry, rz) of every rigid body. Rows of
   * held degrees of freedom do not exist, so that no spurious eigenvalues do.
   *
   * After construction, and again after refine(), everything is valid.
   */
  class Discretization
  {
  public:
    using Triangulation = dealii::parallel::distributed::Triangulation<3, 3>;
    using CellIterator  = dealii::DoFHandler<3>::active_cell_iterator;

    /** Throws InputError where the scene's geometry cannot be meshed. */
    Discretization(const SceneParameters          &scene,
                   const DiscretizationParameters &parameters,
                   const unsigned int              degree,
                   const MPI_Comm                  communicator);
    ~Discretization();

    /** Refines the cells that hold the given share of the summed squared
     * indicator (one number per active cell, owned cells count). The faces of
     * @p whole get cells of one size, the smallest on them. */
    void refine(const std::vector<double>       &indicators,
                const double                     share,
                const std::vector<unsigned int> &whole = {});

    /** The same mesh with another polynomial degree. */
    std::unique_ptr<Discretization> with_degree(
      const unsigned int degree) const;

    // -- accessors
    const SceneParameters &scene() const;
    const CoarseMesh      &coarse_mesh() const;
    bool                   has_mesh() const;
    /** Whether masses are lumped at the Gauss-Lobatto nodes. */
    bool                            has_lumped_mass() const;
    unsigned int                    degree() const;
    const Triangulation            &triangulation() const;
    const dealii::DoFHandler<3>    &dof_handler() const;
    const dealii::Mapping<3, 3>    &mapping() const;
    std::shared_ptr<const RowSpace> space() const;
    /** All displacement components of the mesh before removals. */
    unsigned int n_dofs() const;
    /** Free unknowns of each body (shared ones count for the first). */
    const std::vector<unsigned int> &n_free_of_body() const;

    /** The free unknowns that make up one degree of freedom of the mesh (owned
     * or on a ghost cell); empty where it is held. Global rows. */
    const Combination &expansion(
      const dealii::types::global_dof_index dof) const;

    /** Row of a rigid body's motion 0..5 (x y z rx ry rz), or -1u if held. */
    unsigned int rigid_row(const unsigned int body,
                           const unsigned int motion) const;

    /** Values of all locally relevant degrees of freedom of the mesh for a
     * vector of free unknowns, in the order of relevant_dofs(). */
    std::vector<double> expand(const Eigen::VectorXd &free_with_ghosts) const;
    const dealii::IndexSet &relevant_dofs() const;

  private:
    Discretization(const Discretization &other, const unsigned int degree);
    void create_mesh();
    void attach_manifolds();
    /** Layers on cylinders are as round as these. */
    void attach_manifolds_of_layers();
    /** Curved cells of mesh files keep their shape when they are refined. */
    void attach_charts();
    /** Refines cells at the faces until each has those of one level. */
    void make_even(const std::vector<unsigned int> &faces);
    void distribute();
    void number_free_unknowns(
      const std::vector<Combination> &master_combinations,
      const dealii::IndexSet         &free_owned);
    /** Numbers the free motions of the rigid bodies from 0; their count. */
    unsigned int number_rigid_motions();
    /** Free unknowns of each body, for the summary. */
    void count_free_of_bodies();

    const SceneParameters                   *scene_parameters;
    DiscretizationParameters                 parameters;
    MPI_Comm                                 comm;
    CoarseMesh                               coarse;
    std::shared_ptr<Triangulation>           mesh;
    std::unique_ptr<dealii::FESystem<3>>     fe;
    std::unique_ptr<dealii::Mapping<3, 3>>   curved_mapping;
    std::unique_ptr<dealii::DoFHandler<3>>   dofs;
    dealii::IndexSet                         relevant;
    std::vector<Combination>                 expansions;
    std::vector<std::array<unsigned int, 6>> rigid_rows;
    std::vector<unsigned int>                body_free;
    std::shared_ptr<const RowSpace>          row_space;
  };
} // namespace squeal

#endif
