// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_surface_quads_h
#define squeal_results_surface_quads_h

#include <squeal/results/display_mesh.h>

#include <array>
#include <vector>

namespace squeal
{
  /** A piece of a body's surface and what its corners do. */
  struct SurfaceQuad
  {
    /** Counter-clockwise seen from outside, undeformed, m. */
    std::array<std::array<double, 3>, 4> corners;
    /** In the units of the vector that was drawn. */
    std::array<std::array<double, 3>, 4> displacements;
    unsigned int                         body;
  };

  /**
   * The surfaces of all bodies as quads, each face of a cell cut into n x n,
   * for pictures drawn without a display. Faces joined by a conforming tie are
   * inside and left out; contact faces are there on both sides. Every function
   * is collective and gives the quads on rank 0, none elsewhere, always in the
   * same order.
   */
  class SurfaceQuads
  {
  public:
    SurfaceQuads(const Discretization &discretization,
                 const unsigned int    n_subdivisions);

    /** Displacements of one column of free unknowns (owned rows). */
    std::vector<SurfaceQuad> evaluate(const Block &column) const;

    /** Re((real + i imaginary) e^(i phase)); see phase_of_largest_motion().
     * @p imaginary may have no columns. */
    std::vector<SurfaceQuad> evaluate(const Block &real,
                                      const Block &imaginary,
                                      const double phase) const;

    /** Size of the scene, m; see DisplayMesh::size(). */
    double size() const;

  private:
    DisplayMesh mesh;
  };

  /** The largest displacement of a corner; 0 if there are no quads. */
  double largest_displacement(const std::vector<SurfaceQuad> &quads);
} // namespace squeal

#endif
