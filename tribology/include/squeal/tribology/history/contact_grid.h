// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_history_contact_grid_h
#define squeal_tribology_history_contact_grid_h

#include <squeal/results/contact_history.h>
#include <squeal/results/contact_map.h>
#include <squeal/tribology/subsurface/half_space.h>

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace squeal::tribology
{
  /**
   * The nodal cells of a pad's face: where the nodes stand on a rectangular
   * grid, rectangles between the lines midway between nodes, at the rim cut at
   * the nodes themselves; else squares of the tributary area. Pictures take
   * the pieces of the face where the history has them.
   */
  class ContactGrid
  {
  public:
    /** @p points in m, their tributary @p areas in m^2, and the mean of the unit
     * directions in which the target slides, in x and y: below the length of
     * 0.5 it slides all round. */
    ContactGrid(const std::vector<std::array<double, 3>> &points,
                const std::vector<double>                &areas,
                const std::array<double, 2>              &sliding = {{0., 1.}});

    explicit ContactGrid(const HistoryLayout &layout);

    std::size_t
    n_nodes() const
    {
      return cells.size();
    }

    /** Cell of a node. */
    const Patch &cell(std::size_t node) const;

    double area(std::size_t node) const;

    /** The whole face. */
    const Patch &face() const;

    /** x and y of a node. */
    const std::array<double, 2> &place(std::size_t node) const;

    /** Whether the nodes stand on a rectangular grid. */
    bool is_grid() const;

    /** Numbers of nodes along x and y, and the node at each place, x fastest;
     * only if is_grid(). */
    std::size_t                     n_x() const;
    std::size_t                     n_y() const;
    const std::vector<std::size_t> &order() const;

    /** Pieces of the face, four nodes each in order round it: of the history or
     * of the grid; none where neither tells them. */
    const std::vector<std::array<unsigned int, 4>> &quads() const;

    /** The face as pictures draw it, seen through the back of the pad: x to the
     * right, y up, the leading edge below where sliding() is along y. */
    DrawnFace drawn_face() const;

    /** @p values at the nodes for the points of drawn_face(): where the nodes of
     * a grid are middles of cells, those at the border of the face follow, with
     * the value of the nearest node. */
    std::vector<double> drawn_values(std::vector<double> values) const;

    /** Unit direction in x and y in which the target slides on the whole; 0, 0
     * where it slides all round, so that there is no leading edge. */
    const std::array<double, 2> &sliding() const;

    /** Where a node lies between the leading edge, 0, and the trailing one, 1;
     * NaN where sliding() has no direction. */
    double share_of_way(std::size_t node) const;

    /** Distance of a node from the nearest edge of the face: of the rectangle
     * of a grid, else of the outline of its pieces or, where they are not
     * known, of the hull of the nodes. */
    double edge_distance(std::size_t node) const;

    /**
     * Row i: weights of all nodes in the average about node i, a normal
     * distribution with two standard deviations to @p length / 2 times the
     * tributary areas; the unit matrix for 0.
     */
    Eigen::MatrixXd averaging(double length) const;

  private:
    void build(const std::vector<std::array<double, 3>> &points);
    void set_border();
    void set_outline();

    std::vector<std::array<double, 2>>       places;
    std::vector<double>                      areas, xs, ys;
    std::vector<Patch>                       cells;
    std::vector<std::size_t>                 ordered;
    std::vector<std::array<unsigned int, 4>> pieces;
    /** Points at the border of a grid of middles of cells, half a cell beyond
     * the outermost of them, each with the node that is nearest, and the pieces
     * out to there; none for other grids. For pictures. */
    std::vector<std::pair<std::array<double, 2>, std::size_t>> border;
    std::vector<std::array<unsigned int, 4>>                   bordered_pieces;
    /** Nodes at the ends of the straight pieces of the border; none for a grid.
     */
    std::vector<std::array<std::size_t, 2>> outline;
    std::array<double, 2>                   slides{{0., 1.}};
    Patch                                   whole{};
  };
} // namespace squeal::tribology

#endif
