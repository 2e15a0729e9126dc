// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_contact_resultant_h
#define squeal_contact_contact_resultant_h

#include <squeal/contact/contact_geometry.h>

#include <Eigen/Dense>

#include <array>
#include <vector>

namespace squeal
{
  /**
   * The directions of a pair as a whole: n is the mean outward normal of the
   * target over the face, t the mean direction of sliding in the plane across
   * it (Omega x r at the centre of a face that is symmetric about its radius),
   * s = t x n. Where points slide all round, in no common direction, t is the
   * coordinate axis y, or x on faces that look along y. It turns with the
   * scene.
   */
  ContactFrame mean_frame(const ContactGeometry &geometry);

  /** Whether the face has a side that it looks to, so that motions and forces
   * along a normal of its own have a meaning: false all round a shaft. */
  bool looks_to_one_side(const ContactGeometry &geometry);

  /** Whether its points slide in one direction on the whole, so that the face
   * has a leading edge: false all round the axis of a disc. */
  bool slides_one_way(const ContactGeometry &geometry);

  /** 1 or -1: with that factor the direction s of @p other, which turns over
   * with the normal, goes the way of that of @p first, both outwards or both
   * inwards on a disc between two pads. */
  double transverse_sense(const ContactGeometry &first,
                          const ContactGeometry &other);

  /** Resultant of nodal forces by the target on the source, N, in
   * mean_frame(): along s (radially outwards of a pad on a disc turning about
   * +z), along t and along n, compression positive. On a curved face pressure
   * and friction both have parts along t and n, so that the resultant is what
   * the supports and loads of the source hold. Where slides_one_way() is false
   * the first two are the sums of what each node has across and along its own
   * sliding. Where looks_to_one_side() is false the third is the sum of the
   * nodes' normal forces, which have no part in the others. @p forces: three a
   * node of this pair. */
  std::array<double, 3> resultant_force(const ContactGeometry &geometry,
                                        const Eigen::VectorXd &forces);

  /** resultant_force() as a matrix: 3 x three a node. */
  Eigen::MatrixXd resultant_rows(const ContactGeometry &geometry);

  /** The sums of the nodes' normal forces and of what each has along its own
   * sliding, N, as a matrix: 2 x three a node. Their quotient is mu where all
   * nodes slip along their sliding, however the face is curved. */
  Eigen::MatrixXd sum_rows(const ContactGeometry &geometry);

  /** The resultant of nodal forces on the contact face and where it acts. */
  struct ContactResultant
  {
    std::array<double, 3> force;  /**< resultant_force(), N */
    std::array<double, 2> centre; /**< of pressure, from the centre of the face,
                                     m: along s and t; NaN without contact */
    double mean_pressure = 0.; /**< of normal forces over the whole face, Pa */
    double peak_pressure = 0.; /**< of a node, Pa */
    /** Mean pressure of the nodes on the edge where the target's surface
     * enters, over that of the face; NaN without contact and where the face
     * looks to no side or slides all round. */
    double leading_edge_factor = 0.;
  };

  ContactResultant contact_resultant(const ContactGeometry &geometry,
                                     const Eigen::VectorXd &forces);

  /** Nodes on the edges of the face where the target's surface enters: those
   * whose outward normal is within some 45 degrees of the direction against the
   * sliding there, edges of slots too. Where points have no pieces between them
   * (ContactGeometry::quads), or no edge looks there, the outermost row. None
   * where slides_one_way() is false. */
  std::vector<bool> leading_edge(const ContactGeometry &geometry);

  /** Those on the edges where it leaves, likewise. */
  std::vector<bool> trailing_edge(const ContactGeometry &geometry);

  /** Tractions of the target on the source at every node, Pa, along x, y, z. */
  std::vector<dealii::Tensor<1, 3>> tractions(const ContactGeometry &geometry,
                                              const Eigen::VectorXd &forces);

  /**
   * Two directions in a contact face and its normal, in which fields of the
   * face are kept and drawn: s, t and n of mean_frame(), so that the leading
   * edge is where the second one begins. Where n is along an axis of the scene,
   * and t within 30 degrees of another, they are those axes, which keeps the
   * nodes of a block in rows. On a curved face the two follow the normal of the
   * node by the shortest turn.
   */
  class FaceAxes
  {
  public:
    explicit FaceAxes(const ContactGeometry &geometry);

    /** Whether they are x, y and z. */
    bool is_global() const;
    /** First, second and third direction; unit vectors, right-handed. */
    const std::array<dealii::Tensor<1, 3>, 3> &directions() const;
    /** A place along them, m. */
    std::array<double, 3> place(const dealii::Point<3> &x) const;
    /** Mean over the face of the unit directions of sliding, along the first
     * and the second direction: shorter than 1 where they differ. */
    std::array<double, 2> sliding() const;
    /** What is @p along and @p across the sliding at a node, as components
     * along the first and the second direction. */
    std::array<double, 2> components(const unsigned int node,
                                     const double       along,
                                     const double       across) const;

  private:
    std::array<dealii::Tensor<1, 3>, 3> axes;
    std::array<double, 2>               mean_sliding;
    /** Of every node: the first and the second direction on sliding and
     * transverse direction. */
    std::vector<std::array<double, 4>> projections;
  };
} // namespace squeal

#endif
