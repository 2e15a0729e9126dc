// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_mode_naming_disc_h
#define squeal_eigen_mode_naming_disc_h

#include <squeal/discretization/disc_ring.h>
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
   * Shapes of one disc from its displacement on circles of its ring: along the
   * axis on the contact face, tangential and radial at half the thickness,
   * where bending has no part in them. Where half the thickness is hollow,
   * between the vanes of a ventilated disc, the mean of both sides takes its
   * place; where the other side is no ring, the contact face.
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
    /** Appends its samples to @p rows. @p density in kg/m^3, @p reference_angle
     * in rad about the axis of the ring. */
    DiscShapes(const DiscRing                &ring,
               const double                   density,
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
     * Shapes that a real or complex vector may be called, one unless it is a
     * near tie. The order is fixed: bending, tangential, radial; ascending
     * diameters, "+" before "-", ascending circles.
     *
     * A bending shape is called by the harmonic m and the parity with the
     * largest content on the contact face. What a pad holds is no single
     * harmonic: a disc that is kept from moving at the pad takes equal parts
     * of cos(m theta) and -cos((m + 1) theta) to be at rest there, and it goes
     * over into the free (n, m+) shape as the pad softens. The content of
     * (n, m+) is therefore the largest squared projection on cos(f) cos(m
     * theta) - sin(f) cos((m + 1) theta), 0 <= f <= 45 degrees; with the sines,
     * where the pad holds the slope, that of (n, m-). Two neighbours in
     * opposition have one name until m + 1 has 5.8 times the energy of m.
     *
     * A travelling wave is a tie of both parities.
     */
    std::vector<DiscShape> classify(
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
    /** Coefficients of a harmonic, one a ring. */
    Eigen::VectorXcd profile(
      const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
      const unsigned int                        component,
      const unsigned int                        m,
      const bool                                sine) const;
    std::vector<unsigned int> numbers_of_circles(
      const Eigen::VectorXcd &profile) const;

    struct HeldContent
    {
      double           content; /**< kg m^2 */
      Eigen::VectorXcd profile; /**< of the projection */
    };
    HeldContent held_content(
      const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
      const unsigned int                        m,
      const bool                                sine) const;
    void add_bending(const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
                     std::vector<DiscShape>                   &shapes) const;
    void add_in_plane(const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
                      std::vector<DiscShape>                   &shapes) const;

    std::vector<double> ring_masses; /**< kg */
    Eigen::MatrixXd     fourier;     /**< coefficients x angles */
  };
} // namespace squeal

#endif
