// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_display_mesh_h
#define squeal_results_display_mesh_h

#include <squeal/discretization/discretization.h>

#include <Eigen/SparseCore>

#include <cstdint>
#include <vector>

namespace squeal
{
  /**
   * The scene as it is drawn: each cell of the mesh is cut into n x n x n
   * straight hexahedra whose corners lie on the curved geometry, and each
   * rigid body is a small cube about its centre of gravity. Neighbouring cells
   * share points; touching bodies that are not tied do not.
   *
   * The geometry is known on rank 0, and what the points do is a linear map of
   * the free unknowns, set up once. Make a new one after refine().
   */
  class DisplayMesh
  {
  public:
    /** Empty on other ranks than 0. */
    struct Geometry
    {
      std::vector<double>       points;    /**< x y z of each, m */
      std::vector<std::int32_t> hexahedra; /**< 8 points each, VTK's order */
      /** The surface: 4 points each, counter-clockwise from outside. */
      std::vector<std::int32_t> quads;
      std::vector<std::int32_t> hexahedron_body, quad_body;
      std::vector<std::int32_t> hexahedron_rank; /**< the owner's */

      unsigned int
      n_points() const
      {
        return points.size() / 3;
      }
    };

    /** Collective; @p n_subdivisions >= 1. */
    DisplayMesh(const Discretization &discretization,
                const unsigned int    n_subdivisions);

    const Geometry &
    geometry() const
    {
      return gathered;
    }

    /** Diagonal of the box round meshed bodies and centres of gravity, m; 1 m
     * where that is zero. The same on every rank. */
    double
    size() const
    {
      return diagonal;
    }

    /** Displacements of the points for each column of @p owned (free unknowns):
     * 3 n_points x columns on rank 0 (x y z of each point), empty elsewhere.
     * Collective. */
    Eigen::MatrixXd displacements(const Block &owned) const;

  private:
    struct Parts;

    void add_mesh(const Discretization &discretization,
                  const unsigned int    n_subdivisions,
                  Parts                &parts) const;
    void find_size(const Discretization &discretization, const Parts &parts);
    void add_rigid_bodies(const Discretization &discretization,
                          Parts                &parts) const;
    void gather(const Parts &parts);

    std::shared_ptr<const RowSpace>              space;
    Eigen::SparseMatrix<double, Eigen::RowMajor> map; /**< 3 own points x local
                                                           rows */
    std::vector<int> rows_of_rank, first_of_rank;     /**< of the points' map */
    Geometry         gathered;
    double           diagonal = 1.;
  };



  /**
   * The phase that shows the most of a complex shape u: the largest of
   * |Re(u e^(i phase))|^2 summed over the unknowns, in (-pi/2, pi/2].
   * @p imaginary may have no columns. Collective.
   */
  double phase_of_largest_motion(const RowSpace &space,
                                 const Block    &real,
                                 const Block    &imaginary);
} // namespace squeal

#endif
