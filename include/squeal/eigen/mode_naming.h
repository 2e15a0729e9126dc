// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_eigen_mode_naming_h
#define squeal_eigen_mode_naming_h

#include <squeal/eigen/mode_naming_disc.h>
#include <squeal/eigen/mode_naming_solid.h>

#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /** What a vibration shape is called, and why. */
  struct ModeName
  {
    /** Such as "(0,3+)", "T(0,0)", "support radial 1" or
     * "(0,3+) support tangential 2"; "mode 7" without geometry. Two modes of
     * one table may share a name, as those of a coalesced pair do. */
    std::string text;
    /** True when a disc shape is part of the name; the next three are only
     * then meaningful. */
    bool        is_disc         = false;
    int         nodal_circles   = -1;
    int         nodal_diameters = -1;
    std::string parity; /**< "+", "-" or empty */
    /** Of the disc (bending, tangential, radial) if it is part of the name, of
     * the other body otherwise; empty without geometry. */
    std::string family;
    /** Body with the largest energy share; -1u without geometry. */
    unsigned int body = -1u;
    /** Other body that is part of the name, or -1u, its motion, the number of
     * that motion in the table from 1, and the nodes along the body. */
    unsigned int solid = -1u;
    std::string  solid_family;
    unsigned int solid_number = 0;
    unsigned int solid_nodes  = 0;
  };



  /**
   * Names of vibration shapes of a scene.
   *
   * An annulus is a disc: its shape (n, m) has n nodal circles and m nodal
   * diameters; "+" has an antinode at the source body of the first contact
   * pair, "-" a node (angle 0 without a pair). Other bodies are named by the
   * direction of their motion; motions of one direction are numbered in the
   * order of the columns, which is to be that of ascending frequency, and modes
   * that move the body alike have one number. A name mentions the disc when it
   * has the largest energy share or more than disc_share, another body when
   * that has the largest share or more than solid_share.
   *
   * Naming needs the coordinates of a vector only, a linear map: those of a
   * whole basis V are computed once and serve every combination V q.
   */
  class ModeNamer
  {
  public:
    /** Energy shares from which a body that does not have the largest one is
     * mentioned. The disc's is small: in the squealing modes of a brake with a
     * heavy support it has some 1 % of the energy, in the support's own modes
     * 0.1 %. */
    static constexpr double disc_share  = 0.005;
    static constexpr double solid_share = 0.2;

    /** For models without geometry: plain numbers. */
    ModeNamer();

    /** For a scene; may be dropped with the discretization afterwards. All
     * ranks together. */
    explicit ModeNamer(const Discretization &discretization);

    /** Names of real shapes (owned rows x modes, ascending frequency).
     * @p energy_shares: bodies x modes, each column of sum about 1. */
    std::vector<ModeName> name(const Block           &modes,
                               const Eigen::MatrixXd &energy_shares) const;

    /** Names of complex shapes. They do not depend on the phase; a travelling
     * wave has its m and the parity of its larger part. */
    std::vector<ModeName> name(const ComplexBlock    &modes,
                               const Eigen::MatrixXd &energy_shares) const;

    /** Coordinates of vectors, a column each, the same on every rank. */
    Eigen::MatrixXd coordinates(const Block &vectors) const;
    unsigned int    n_coordinates() const;

    /** Names from coordinates. */
    std::vector<ModeName> name_coordinates(
      const Eigen::MatrixXcd &coordinates,
      const Eigen::MatrixXd  &energy_shares) const;

    /**
     * Turns the modes of every multiple frequency into shapes with names: of a
     * doublet of an axisymmetric disc the first is the "+" and the second the
     * "-" shape; of a square beam the two bending directions come apart. The
     * rotation is orthogonal, so that columns stay orthonormal.
     *
     * Frequencies ascend; those closer than @p tolerance (relative) to their
     * neighbour belong together. Other columns are returned as they are.
     */
    Block separate_multiple(const Block               &modes,
                            const std::vector<double> &frequencies,
                            const double               tolerance = 1e-6) const;

    /**
     * Displacements at some hundred points of all bodies, each row scaled by
     * the square root of the mass it stands for: S x of modes on two meshes can
     * be compared by the MAC, and is nearly orthogonal for different modes of
     * one mesh. Null for models without geometry.
     */
    std::shared_ptr<const Functionals> signature() const;

    /** Angle of the "+" antinode about the disc axis from x towards y, rad. */
    double reference_angle() const;

  private:
    struct Body
    {
      std::string                  name;
      std::unique_ptr<DiscShapes>  disc;  /**< of an annulus */
      std::unique_ptr<SolidShapes> solid; /**< of any other body */
      unsigned int                 first_sample     = 0;
      unsigned int                 first_coordinate = 0;
    };

    ModeName        describe(const Eigen::VectorXcd &coordinates,
                             const Eigen::VectorXd  &energy_shares) const;
    Eigen::VectorXd mirror_weights() const;
    /** Orders columns by nodal diameters, "+" before "-". */
    std::vector<unsigned int> order_of_shapes(
      const Eigen::MatrixXd &coordinates) const;

    std::vector<Body>                  bodies;
    unsigned int                       n_discs           = 0;
    unsigned int                       total_coordinates = 0;
    double                             angle             = 0.;
    std::shared_ptr<const Functionals> samples, signature_rows;
  };
} // namespace squeal

#endif
