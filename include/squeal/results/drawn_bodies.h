// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_drawn_bodies_h
#define squeal_results_drawn_bodies_h

#include <squeal/results/display_mesh.h>
#include <squeal/results/vtk_xml.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /** Multiples of a power of two near 2^-bits of a largest value: the float's
   * last bits are zero, which zlib makes use of. */
  class Rounding
  {
  public:
    Rounding(const double largest, const int bits);

    float
    operator()(const double value) const
    {
      // adding zero turns -0 into 0
      return static_cast<float>(std::nearbyint(value / step) * step + 0.);
    }

  private:
    double step;
  };

  /**
   * What all VTU files of the bodies have in common: the undeformed geometry
   * with cell data `body` (its number in the scene) and, on several ranks,
   * `subdomain`; field data `body_names`. Positions are rounded to 2^-20 of
   * the scene's size. On rank 0 only; the others have an empty one.
   */
  class DrawnBodies
  {
  public:
    /** @p surface_only: quads of the surface instead of hexahedra. */
    DrawnBodies(const Discretization &discretization,
                const DisplayMesh    &mesh,
                const bool            surface_only);

    const vtk::UnstructuredGrid &grid() const;

    /** A point vector of the drawn points: @p value of the indices 3 p + c of
     * the mesh's points p, rounded. */
    std::string point_vector(const std::string                         &name,
                             const std::function<double(unsigned int)> &value,
                             const Rounding &rounded) const;

  private:
    std::vector<unsigned int> drawn_points; /**< of the mesh */
    vtk::UnstructuredGrid     common;
  };

  /** Runs @p action on rank 0; what it throws, every rank throws. */
  void on_root(const RowSpace &space, const std::function<void()> &action);
} // namespace squeal

#endif
