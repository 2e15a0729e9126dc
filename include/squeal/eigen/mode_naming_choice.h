// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_mode_naming_choice_h
#define squeal_eigen_mode_naming_choice_h

#include <Eigen/Core>

#include <vector>

namespace squeal
{
  /**
   * Decisions behind a name. Each has a band in which it is left open: what
   * lies on either side of a limit would be told apart by rounding, the mesh
   * or the least change of a parameter. The widths are such that no name of the
   * TriboBrake turned into another one over 1000 small steps
   * (driver.mode_names) and that less than 5 % of the names are left open.
   */
  namespace naming
  {
    /** Contents of Fourier coefficients: see near_largest(). A mixture of two
     * shapes that are told apart by it turns by 2 degrees within the band. */
    constexpr double content_margin = 0.03;
    /** Of the two parities of one number of nodal diameters, which are
     * orthogonal: shapes with a MAC above 0.95 differ by an angle a with sin a
     * < sqrt(0.05), and contents by at most that on either side of a tie. */
    constexpr double parity_margin = 0.2236;
    /** Energies of directions and of bodies. */
    constexpr double family_margin = 0.2236;

    /** A limit and the factor by which a value may lie on either side of it
     * and still be undecided. */
    struct Limit
    {
      double value;
      double factor;
    };

    /** Energy share from which a disc is part of a name. It is small: in the
     * squealing modes of a brake with a heavy support the disc has some 1 % of
     * the energy, in the support's own modes 0.1 %. */
    constexpr Limit disc_share{0.005, 1.6};
    /** Energy share from which another body is part of a name. */
    constexpr Limit solid_share{0.3, 1.3};
    /** Sum of the energy shares of all bodies that are no discs from which the
     * largest of them are part of a name: a pad of several bodies may have most
     * of the energy though none of its bodies has a large share. Where they
     * have more than half of it the limit is passed beyond its band. */
    constexpr Limit solids_share{0.38, 1.3};
    /** Share of its motions that slices of a body must move as a whole for it
     * to be named by that. Of a body that is only sheared or breathes the means
     * are rounding: they would name it by chance. */
    constexpr Limit moving_share{1e-3, 3.};
    /** Lobes below this part of the largest one make no node. */
    constexpr Limit lobe{0.1, 1.5};

    /** Whether a value may be above, and whether it may be below a limit; one
     * of them is true. A NaN is below. */
    bool may_exceed(const double value, const Limit &limit);
    bool may_fall_short(const double value, const Limit &limit);

    /** Indices, ascending, of the @p scores s >= 0 that cannot be told from
     * the largest one: largest - s <= margin (largest + s). */
    std::vector<unsigned int> near_largest(const std::vector<double> &scores,
                                           const double               margin);

    /** Possible numbers of nodes of a profile, ascending: one, or two if it
     * has a lobe that may or may not be counted. */
    std::vector<unsigned int> numbers_of_nodes(const Eigen::VectorXd &profile);
  } // namespace naming
} // namespace squeal

#endif
