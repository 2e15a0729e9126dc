// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_contact_map_h
#define squeal_results_contact_map_h

#include <squeal/results/planar_cells.h>
#include <squeal/results/plotter.h>

#include <array>
#include <string>
#include <vector>

namespace squeal
{
  /** A contact face as it is drawn. */
  struct DrawnFace
  {
    std::vector<std::array<double, 3>> points; /**< m */
    std::vector<double>                areas;  /**< of the points, m^2 */
    std::vector<PlanarPoint>           places; /**< in the picture, m */
    /** Between points, by their numbers; see ContactGeometry::quads. */
    std::vector<std::array<unsigned int, 4>> quads;
    /** Of the target's surface in the picture, of length one; 0: none that
     * all points have. */
    PlanarPoint sliding = {0., 0.};
    /** Without units, of both directions. */
    std::array<std::string, 2> axes = {"x", "y"};
  };

  /**
   * The nodes of a contact face and the cells they stand for: quarters of the
   * quads between them, or, of points that have no quads, what is nearer to
   * them than to any other.
   */
  class ContactMap
  {
  public:
    using Values = std::vector<double>;

    explicit ContactMap(const DrawnFace &face);

    /** One panel of a picture. */
    struct Panel
    {
      std::string title;
      std::string label;                  /**< of the colours, with unit */
      Values      values;                 /**< NaN: none there, drawn in grey */
      double      lower = 0., upper = 0.; /**< the same: by the values */
      /** Names of the values 0, 1, 2 ... where they are kinds; a kind of the
       * name "open" is grey too. */
      std::vector<std::string> kinds;
      std::vector<double>      arrows_x, arrows_y; /**< one a node, or none */
      /** Colours over six decades at most; what is not positive is grey. */
      bool logarithmic = false;
    };

    /** Writes path.png with the panels side by side, @p n_columns in a row,
     * and the direction of sliding; panels whose colours mean the same share
     * one bar. The second axis points up. */
    bool plot(const Plotter            &plotter,
              const std::vector<Panel> &panels,
              const std::string        &path,
              const unsigned int        n_columns = 2) const;

    /** Writes a .vtu file with the values of @p fields at the nodes. */
    void write_vtu(
      const std::string                                 &path,
      const std::vector<std::pair<std::string, Values>> &fields) const;

  private:
    DrawnFace                     face;
    std::vector<PointCell>        cells;
    std::vector<std::vector<int>> polygons; /**< between points */
  };
} // namespace squeal

#endif
