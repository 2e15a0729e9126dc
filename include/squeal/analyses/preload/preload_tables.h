// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_analyses_preload_preload_tables_h
#define squeal_analyses_preload_preload_tables_h

#include <squeal/model/pressed_model.h>
#include <squeal/results/table.h>

#include <string>

namespace squeal
{
  /**
   * preload.csv, a row a load step. The columns of a pair have no prefix where
   * it is the only one; of several each has those behind its name, and sums in
   * front: forces of the pairs that slide, nodes of all.
   */
  class LoadSteps
  {
  public:
    /** @p is_worn: the faces have run in; as the depth of what is worn is
     * arbitrary, bodies have no approach and no secant stiffness then. */
    explicit LoadSteps(const std::vector<ContactParameters> &contacts,
                       const bool                            is_worn = false);

    void add(const PressedModel  &pressed,
             const SteadySliding &state,
             const double         share);

    const Table &table() const;

    /** Name of the column of pair @p number that is called @p name where there
     * is one pair. */
    std::string column(const unsigned int number,
                       const std::string &name) const;
    /** The value of a column as the table shows it, under the full load, "not
     * defined" where it has none. */
    std::string at_full_load(const std::string &column) const;

    /** preload.json; null where a quantity has no value, as a leading edge in a
     * ring. */
    void write_json(const std::vector<ContactParameters> &contacts,
                    const std::string                    &path) const;

  private:
    const std::vector<std::string> names; /**< of several pairs */
    const bool                     is_worn;
    Table                          steps;
  };

  /** What the target pulls the source of a pair along its sliding with, N: the
   * resultant of @p forces, three a node of the pair; on a curved face, where
   * pressure has a part in that, the sum of what each node has along its own
   * sliding. */
  double friction_along_sliding(const ContactPair     &pair,
                                const Eigen::VectorXd &forces);

  /** Moment of @p forces, N, three a node, on the source of a pair about the
   * rotation axis of the @p target, N m: positive turns as the right hand does.
   */
  double moment_about_axis(const ContactGeometry &geometry,
                           const Eigen::VectorXd &forces,
                           const BodyParameters  &target);

  /** contact.csv: the nodes of all pairs. */
  Table contact_nodes_table(const PressedModel  &pressed,
                            const SteadySliding &state);
} // namespace squeal

#endif
