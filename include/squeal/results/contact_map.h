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

    ContactMap(const std::vector<std::array<double, 3>> &points, /**< m */
               const Values                             &areas);                             /**< m^2 */

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
     * the sliding direction +y points up. */
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
    std::vector<std::vector<PlanarPoint>> cells;    /**< of the nodes */
    std::vector<std::vector<int>>         polygons; /**< between nodes */
  };
} // namespace squeal

#endif
