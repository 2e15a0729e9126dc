// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_contact_geometry_h
#define squeal_contact_contact_geometry_h

#include <squeal/base/contact_status.h>
#include <squeal/base/low_rank_matrix.h>
#include <squeal/contact/contact_frames.h>
#include <squeal/discretization/discretization.h>
#include <squeal/discretization/point_evaluator.h>

#include <memory>
#include <vector>

namespace squeal
{
  /**
   * Contact state of a pair: the status of every contact point and the normal
   * force it carries, as a share of the pair's `Normal force` (sums to one over
   * the closed points) or, of a contact that loads press, in N. One type for
   * the linearised operators and for the contact solvers.
   */
  struct ContactState
  {
    std::vector<ContactStatus> status;
    std::vector<double>        force_share;
    bool                       in_newtons = false; /**< of @p force_share */
  };

  /** Contact states of one pair, of which the scene's `state_number` tells the
   * one that holds. */
  using ContactStates = std::vector<ContactState>;

  /**
   * Where a contact pair touches: points on the source face, their tributary
   * areas and frames, and the functionals of the relative motion there, target
   * minus source (disc minus pad): normal B_n u = n . (u_d - u_p), which is
   * z_d - z_p above the disc and z_p - z_d below it, along the sliding of the
   * target surface B_t u, and across it.
   */
  struct ContactGeometry
  {
    std::vector<dealii::Point<3>> points;
    std::vector<double>           areas; /**< m^2 */
    /** Pieces of the source face between neighbouring points, by their numbers
     * round each piece, as they are drawn; none between Gauss points. */
    std::vector<std::array<unsigned int, 4>> quads;
    std::vector<ContactFrame>                frames;
    /** |V| at the point over the mean of |V| over the points. */
    std::vector<double>                speed_ratio;
    std::shared_ptr<const Functionals> normal, tangential, transverse;
    /** Displacements (x, y, z) of the two sides at every point. */
    std::vector<std::array<Functionals::Row, 3>> source_rows, target_rows;
  };

  /** Sets frames, speed ratios and the three functionals of @p geometry, whose
   * points and rows of both sides are there. @p source_normals: outward, of
   * the source face at every point. Throws as contact_frames(). */
  void set_frames(const Discretization                    &discretization,
                  const ContactParameters                 &contact,
                  const std::vector<dealii::Tensor<1, 3>> &source_normals,
                  ContactGeometry                         &geometry);

  /**
   * Contact points of @p contact: the grid or the Gauss points of the source
   * face. Throws InputError where the faces do not meet or the source face
   * leaves the target.
   */
  ContactGeometry make_contact_geometry(const Discretization    &discretization,
                                        const PointEvaluator    &evaluator,
                                        const ContactParameters &contact);

  /** The relative motion of the points of @p contacts, one pair after the
   * other: three rows a point, normal, along and across the sliding. */
  Functionals relative_motion(const std::vector<ContactGeometry> &contacts);

  /** Full slip or full stick with an even pressure: shares by the tributary
   * areas, so that they are those of the face and not of its mesh. */
  ContactState uniform_state(const ContactGeometry &geometry,
                             const ContactStatus    status);
} // namespace squeal

#endif
