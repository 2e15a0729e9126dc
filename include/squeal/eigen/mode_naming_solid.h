// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_mode_naming_solid_h
#define squeal_eigen_mode_naming_solid_h

#include <squeal/discretization/disc_ring.h>
#include <squeal/discretization/point_evaluator.h>

#include <string>
#include <vector>

namespace squeal
{
  /** Motion of a pad, a support beam or a rigid body. */
  struct SolidShape
  {
    /** Such as "tangential" or "torsion"; empty for a body at rest. */
    std::string family;
    /** Nodes of the dominant motion along the body's long axis. */
    unsigned int n_nodes = 0;

    /** The family, "motion" for a body at rest or one whose slices only change
     * their shape. */
    std::string name() const;
    /** The name and the number of nodes + 1, such as "tangential 2". */
    std::string text() const;
  };

  /**
   * Motions of one body that is no disc. A meshed body is cut into slices along
   * its longest side (that along the disc's axis, else z, if none is twice as
   * long as the others); each
   * slice has a mean displacement and a rotation about that axis, by which it
   * is named, and five linear changes of shape: strains and shear in its plane,
   * rotations out of it. A rigid body is one slice with three displacements and
   * three rotations.
   *
   * Displacements are radial, tangential and normal with respect to the disc
   * axis as seen from the centre of the body; without a disc x, y and z.
   *
   * The coordinates of a vector are these motions, slice by slice, scaled such
   * that their sum of squares is the integral of density |u|^2 as far as u is
   * linear in each slice.
   */
  class SolidShapes
  {
  public:
    /** Appends its coordinates to @p rows. @p ring: of the disc that gives the
     * axis, or null. */
    SolidShapes(const Discretization          &discretization,
                const PointEvaluator          &evaluator,
                const unsigned int             body,
                const DiscRing                *ring,
                std::vector<Functionals::Row> &rows);

    unsigned int n_coordinates() const;

    /** What a vector may be called, one unless it is a near tie; families in
     * the order of the coordinates, then ascending nodes. */
    std::vector<SolidShape> classify(
      const Eigen::Ref<const Eigen::VectorXcd> &coordinates) const;

    /** As DiscShapes::mirror_weights(): +1 for motions that the mirror plane
     * through disc axis and body keeps, -1 for the others, 0 for changes of
     * shape. */
    Eigen::VectorXd mirror_weights() const;

  private:
    /** Coordinates of one slice. */
    unsigned int n_rows() const;
    void         add_rigid_rows(const Discretization          &discretization,
                                const unsigned int             body,
                                std::vector<Functionals::Row> &rows) const;
    void         add_slice_rows(
              const PointEvaluator                             &evaluator,
              const unsigned int                                body,
              const std::vector<std::vector<dealii::Point<3>>> &slices,
              const double                                      mass,
              std::vector<Functionals::Row>                    &rows) const;

    std::vector<std::string> families;
    std::vector<double>      mirror; /**< sign of each family */
    unsigned int             n_slices        = 0;
    unsigned int             n_shape_changes = 0; /**< of a slice */
    unsigned int             axis            = 2; /**< long axis, 0 to 2 */
    /** Radial, tangential and normal unit vectors; x, y, z without a disc. */
    std::array<dealii::Tensor<1, 3>, 3> directions;
  };

  /** Centre of a body: of its bounding box if meshed, of gravity if rigid. */
  dealii::Point<3> body_centre(const Discretization &discretization,
                               const unsigned int    body);
} // namespace squeal

#endif
