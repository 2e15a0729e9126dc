// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_import_tables_h
#define squeal_scene_import_tables_h

#include <squeal/scene/matrix_import.h>

namespace squeal
{
  /** A line of the node table of an imported model: where an unknown is. */
  struct NodeTableRow
  {
    /** Number of the unknown, from 1; 0 where the table has no column dof. */
    long     dof = 0;
    DofLabel label;
    Vector3  position{{0., 0., 0.}}; /**< m */
    /** Name of the body it belongs to. */
    std::string body;
    /** Force on it of every load that was asked for, N (N m for rotations). */
    std::vector<double> forces;
    /** Its weight in the mean motion of the far face of every contact that was
     * asked for; NaN where the table has no such column. */
    std::vector<double> far_weights;
    /** Line of the file, for error texts. */
    unsigned int line = 0;
  };

  /**
   * Reads a node table: comma-separated lines below a header line with the
   * columns node, component, x, y, z, body and, unless all matrices name their
   * rows, dof, in any order. Coordinates in m. For each of @p loads there must
   * be a column load_<name>, the force on the unknown in N. For each of
   * @p contacts there may be a column far_<name>, the weight of the unknown in
   * the mean motion of the source's face away from the contact along the
   * normal.
   *
   * Throws InputError with file and line: a missing or doubled column, a line
   * with too few or too many values, a value that is no finite number, a
   * component that does not exist, a dof or (node, component) given twice, an
   * empty body name, a table without lines.
   */
  std::vector<NodeTableRow> read_node_table(
    const std::string              &file,
    const std::vector<std::string> &loads    = {},
    const std::vector<std::string> &contacts = {});



  /** One coefficient of a contact pattern. */
  struct ContactTerm
  {
    enum class Side
    {
      source,
      target
    };
    enum class Direction
    {
      normal,
      sliding,
      transverse
    };
    /** Number of the point pair. */
    long      pair      = 0;
    Side      side      = Side::source;
    Direction direction = Direction::normal;
    /** Number of the unknown, from 1, or 0 where it has a name. */
    long     dof = 0;
    DofLabel label;
    /** Whether supports hold the unknown: it is not in the matrices, and has a
     * component alone. */
    bool   is_held = false;
    double weight  = 0.;
    /** Multiplies the normal stiffness of the pair. */
    double stiffness_factor = 1.;
    /** Contact pair of the scene that the point pair belongs to; empty where
     * the scene names none. */
    std::string contact;
    /** Place of the point pair, m, the area that it stands for, m^2, and |V|
     * there over the mean of all points; of scenes with contacts. */
    Vector3      position{{0., 0., 0.}};
    double       area        = 0.;
    double       speed_ratio = 1.;
    unsigned int line        = 0;
  };

  /**
   * Reads a contact pattern: comma-separated lines below a header line with the
   * columns pair, side (source or target), direction (normal, sliding or
   * transverse), weight, and either dof or node and component; a column
   * stiffness_factor may follow. Each line is one weight of one row of B_n
   * (normal) or B_t (sliding, transverse):
   *
   *   row = sum over target of weight u - sum over source of weight u,
   *
   * so that the normal row is the approach z_d - z_p of the two faces, normal
   * pointing out of the target, and the sliding row is the displacement of the
   * target against the source along the target's motion. `held x`, `held y` or
   * `held z` in the place of the number or node is the share of unknowns that
   * supports hold, which are not in the matrices.
   *
   * With @p of_contacts, for scenes that name their contacts, there are the
   * columns contact, x, y, z and area in place of the stiffness factor, and
   * speed_ratio may follow; pairs count in each contact by themselves.
   *
   * Throws InputError with file and line, as read_node_table() does, and for a
   * pair whose lines give different numbers of that kind, or a stiffness
   * factor, area or speed ratio that is not positive.
   */
  std::vector<ContactTerm> read_contact_pattern(const std::string &file,
                                                const bool of_contacts = false);
} // namespace squeal

#endif
