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
  /**
   * The nodes of a flat contact face and the cells they stand for: what is
   * nearer to them than to any other node.
   */
  class ContactMap
  {
  public:
    using Values = std::vector<double>;

    /** A face in the plane x, y. @p points: m; @p areas: m^2. */
    ContactMap(const std::vector<std::array<double, 3>> &points,
               const Values                             &areas);

    /** A face that looks elsewhere, drawn at @p places: across and along the
     * sliding, m. */
    ContactMap(const std::vector<std::array<double, 3>> &points,
               const Values                             &areas,
               const std::vector<std::array<double, 2>> &places);

    /** One panel of a picture. */
    struct Panel
    {
      std::string title;
      std::string label; /**< of the colours, with unit */
      Values      values;
      double      lower = 0., upper = 0.;     /**< the same: by the values */
      std::vector<double> arrows_x, arrows_y; /**< one a node, or none */
    };

    /** Writes path.png with the panels side by side, @p n_columns in a row;
     * the second axis points up. */
    bool plot(const Plotter            &plotter,
              const std::vector<Panel> &panels,
              const std::string        &path,
              const unsigned int        n_columns = 2) const;

    /** Writes a .vtu file with the values of @p fields at the nodes. */
    void write_vtu(
      const std::string                                 &path,
      const std::vector<std::pair<std::string, Values>> &fields) const;

  private:
    std::vector<std::array<double, 3>>    points;
    Values                                areas;
    std::vector<PlanarPoint>              places;
    std::string                           axis_labels; /**< of the picture */
    std::vector<std::vector<PlanarPoint>> cells;       /**< of the nodes */
    std::vector<std::vector<int>>         polygons;    /**< between nodes */
  };
} // namespace squeal

#endif
