// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_turning_mortar_h
#define squeal_contact_turning_mortar_h

#include <squeal/base/low_rank_matrix.h>
#include <squeal/contact/mortar_integrals.h>

namespace squeal
{
  /**
   * The dual mortar operators of a source face that stands still and a target
   * whose mesh turns about a vertical axis. The weights of the source nodes
   * stay; M is integrated anew over the segments of every angle, exactly as
   * make_mortar_coupling() does.
   *
   * Faces that meet are looked for among those of the angle before and their
   * neighbours; among all where that is too far away. What comes out is the
   * same to the bit. On one rank.
   */
  class TurningMortar
  {
  public:
    /** Throws InputError as make_mortar_coupling() does, and on several ranks.
     */
    TurningMortar(const Discretization &discretization,
                  const unsigned int    source_face_id,
                  const unsigned int    target_body,
                  const std::string    &where);
    TurningMortar(const TurningMortar &) = delete;

    /** D_j^-1 M_jb at an angle, rad, counterclockwise about z: a row for each
     * source node, over the numbers b of target_dofs(). Each row adds up to
     * one. Throws InputError where the source face leaves the target. */
    std::vector<Functionals::Row> rows(const double angle);

    const std::vector<dealii::Point<3>> &nodes() const; /**< source, m */
    /** Unknowns (x, y, z) of each source node; -1u where held. */
    const std::vector<std::array<unsigned int, 3>> &source_rows() const;
    /** Nodes of the target that the source may meet in a whole turn: degrees of
     * freedom, and places at angle 0, m. */
    const std::vector<std::array<dealii::types::global_dof_index, 3>>
                                        &target_dofs() const;
    const std::vector<dealii::Point<3>> &target_points() const;

    /** Narrowest face of either side, m. */
    double narrowest() const;
    /** Where @p x is in the target's own axes. */
    dealii::Point<3> turned_back(const dealii::Point<3> &x,
                                 const double            angle) const;
    /** Pairs of faces that have been looked at closely so far. */
    unsigned int n_pairs_tried() const;

  private:
    void find_targets(const Discretization &d, const unsigned int body);
    void number_targets();
    /** Faces of @p candidates whose boxes meet that of @p source. */
    std::vector<std::size_t> close_to(
      const SurfaceFace              &source,
      const std::vector<std::size_t> &candidates) const;

    const std::string                        where;
    const FaceBasis                          basis;
    dealii::Point<3>                         axis;
    std::vector<SourceFace>                  sources;
    std::vector<dealii::Point<3>>            source_points;
    std::vector<std::array<unsigned int, 3>> rows_of_source;
    std::vector<std::vector<unsigned int>>   source_nodes; /**< of each face */

    std::vector<TargetFace>                targets;
    std::vector<dealii::BoundingBox<3>>    boxes;
    std::vector<std::size_t>               all;        /**< targets */
    std::vector<std::vector<std::size_t>>  neighbours; /**< and itself */
    std::vector<std::vector<unsigned int>> target_nodes;
    std::vector<std::array<dealii::types::global_dof_index, 3>> dofs;
    std::vector<dealii::Point<3>>                               points;
    double                                                      width, reach;

    /** Faces that each source face has met at the last angle. */
    std::vector<std::vector<std::size_t>> met;
    double                                last_angle = 0.;
    unsigned int                          n_tried    = 0;
  };
} // namespace squeal

#endif
