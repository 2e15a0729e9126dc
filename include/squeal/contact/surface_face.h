// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_surface_face_h
#define squeal_contact_surface_face_h

#include <deal.II/base/point.h>

#include <Eigen/Dense>

#include <optional>
#include <vector>

namespace squeal
{
  /**
   * Lagrange functions of a face of FE_Q cells on the unit square. The node in
   * column i and row j has the number i + (degree + 1) j.
   */
  class FaceBasis
  {
  public:
    explicit FaceBasis(const unsigned int degree);

    unsigned int degree() const;
    unsigned int n_nodes() const;
    /** Unit coordinates of a node. */
    dealii::Point<2> node(const unsigned int number) const;
    /** Number of the column (or row) of nodes at this unit coordinate. */
    unsigned int column(const double coordinate) const;

    struct Values
    {
      Eigen::VectorXd              value;
      Eigen::Matrix<double, -1, 2> gradient; /**< by the unit coordinates */
    };
    Values evaluate(const dealii::Point<2> &unit) const;

  private:
    std::vector<double> coordinates;
  };

  /**
   * The geometry of one face of a mesh, of the degree of its basis. The unit
   * coordinates are ordered so that tangent(0) x tangent(1) points out of the
   * body.
   */
  class SurfaceFace
  {
  public:
    /** Nodes in the order of @p basis, which must live on. m */
    SurfaceFace(const FaceBasis                     &basis,
                const std::vector<dealii::Point<3>> &nodes);

    const std::vector<dealii::Point<3>> &nodes() const;
    dealii::Point<3> point(const dealii::Point<2> &unit) const;

    /** Position and its derivatives by the unit coordinates. */
    struct Frame
    {
      dealii::Point<3>     x;
      dealii::Tensor<1, 3> tangent[2];
      dealii::Tensor<1, 3> area_vector() const; /**< outward, m^2 */
    };
    Frame frame(const dealii::Point<2> &unit) const;

    /** Outward unit normal at the centre. */
    const dealii::Tensor<1, 3> &normal() const;
    /** Largest distance of two corners. m */
    double diameter() const;
    /** How far nodes lie off the plane through the centre. m */
    double bulge() const;
    /** Whether the face is a parallelogram with its nodes evenly in it. */
    bool is_affine() const;
    /** Whether edge k, from corner k to k + 1 counterclockwise from (0, 0), is
     * straight. */
    bool has_straight_edge(const unsigned int k) const;

    struct Projection
    {
      dealii::Point<2> unit;
      double           distance; /**< from the face to the point, along it. m */
    };
    /** Where a line through @p x along @p direction meets the face or its
     * smooth continuation (Newton's method); nothing where it does not. */
    std::optional<Projection> project(
      const dealii::Point<3>     &x,
      const dealii::Tensor<1, 3> &direction,
      const dealii::Point<2>     &guess = {.5, .5}) const;

  private:
    const FaceBasis              *basis;
    std::vector<dealii::Point<3>> node_points;
    dealii::Tensor<1, 3>          centre_normal;
    double                        size, off_plane;
    bool                          affine;
  };

  /** Corner k of the unit square, counterclockwise from (0, 0). */
  dealii::Point<2> unit_corner(const unsigned int k);
} // namespace squeal

#endif
