// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_mode_naming_disc_h
#define squeal_eigen_mode_naming_disc_h

#include <squeal/discretization/point_evaluator.h>

#include <string>
#include <vector>

namespace squeal
{
  /** Shape (n, m) of a disc's vibration. */
  struct DiscShape
  {
    enum class Family
    {
      bending,    /**< along the axis */
      tangential, /**< in the plane, round the axis; prefix T */
      radial      /**< in the plane, through the axis; prefix R */
    };
    Family       family          = Family::bending;
    unsigned int nodal_circles   = 0; /**< n */
    unsigned int nodal_diameters = 0; /**< m */
    /** "+": antinode of the family's component at the reference angle, "-":
     * node there, empty for m = 0. */
    std::string parity;

    /** Such as "(0,3+)", "(1,0)" or "T(0,1-)". */
    std::string text() const;
  };

  /** Such as "bending". */
  std::string to_string(const DiscShape::Family family);



  /**
   * Shapes of one annulus from its displacement on rings at half the
   * thickness, along the axis, tangential and radial.
   *
   * The coordinates of a vector are the Fourier coefficients of every ring and
   * component, the angle counted from the reference angle: the mean, then
   * cosine and sine of each m. They are scaled such that their sum of squares
   * is the integral of density |u|^2 over the body (rotation of the cross
   * sections left out).
   */
  class DiscShapes
  {
  public:
    /** Appends its samples to @p rows. @p reference_angle in rad about the
     * axis of the body, from x towards y. */
    DiscShapes(const Discretization          &discretization,
               const PointEvaluator          &evaluator,
               const unsigned int             body,
               const double                   reference_angle,
               std::vector<Functionals::Row> &rows);

    unsigned int n_samples() const;
    unsigned int n_coordinates() const;

    /** Coordinates of vectors from their samples, a column each. */
    Eigen::MatrixXd coordinates(
      const Eigen::Ref<const Eigen::MatrixXd> &samples) const;

    /**
     * Shape of a real or complex vector. Nodal diameters are counted, not read
     * off the largest harmonic: under a stiff pad the (0,3+) shape holds more
     * of cos(4 theta) than of cos(3 theta), yet changes its sign six times and
     * goes over into the free (0,3) shape as the pad softens. A travelling wave
     * has the parity of its larger part.
     */
    DiscShape classify(
      const Eigen::Ref<const Eigen::VectorXcd> &coordinates) const;

    /**
     * Weights of the squared coordinates in the form that tells the shapes of
     * a multiple eigenvalue apart: positive for the coordinates that the
     * mirror plane through axis and reference angle keeps, negative for those
     * it turns round, growing with m.
     */
    Eigen::VectorXd mirror_weights() const;

    /** Samples that represent the motion of the disc, (row, factor): with
     * these factors their sum of squares is that of the coordinates as long
     * as few nodal diameters are there. */
    std::vector<std::pair<unsigned int, double>> signature() const;

  private:
    /** First coordinate of a ring and component (0 axial, 1 tangential,
     * 2 radial). */
    unsigned int first(const unsigned int ring,
                       const unsigned int component) const;
    /** Energies of a component by m: cosine in column 0, sine in column 1. */
    Eigen::MatrixX2d energies(
      const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
      const unsigned int                        component) const;
    /** Nodal diameters of the motion with the radial profile of the
     * @p dominant harmonic. */
    unsigned int n_diameters(
      const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
      const unsigned int                        component,
      const unsigned int                        dominant) const;
    /** Radial profile of a harmonic, cosine and sine combined. */
    Eigen::VectorXd profile(
      const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
      const unsigned int                        component,
      const unsigned int                        m) const;

    std::vector<double> ring_masses; /**< kg */
    Eigen::MatrixXd     fourier;     /**< coefficients x angles */
  };
} // namespace squeal

#endif
