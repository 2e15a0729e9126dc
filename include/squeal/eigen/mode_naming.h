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
  /**
   * What a vibration shape is called, and why. The columns of a near tie are
   * those on which its alternatives agree; others are as if they did not apply.
   */
  struct ModeName
  {
    /** Such as "(0,3+)", "T(0,0)", "support radial 1" or
     * "(0,3+) support tangential 2"; "mode 7" without geometry; the
     * alternatives joined by "|" for a near tie. Two modes of one table may
     * share a name, as those of a coalesced pair do. */
    std::string text;
    /** Names that the shape may have, one unless it is a near tie, in an order
     * that does not depend on which is nearer. */
    std::vector<std::string> alternatives;
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
    /** Other body that is part of the name, or -1u, its motion, the nodes
     * along the body and the number in the name, which is one more. */
    unsigned int solid = -1u;
    std::string  solid_family;
    unsigned int solid_number = 0;
    unsigned int solid_nodes  = 0;

    bool
    is_tie() const
    {
      return alternatives.size() > 1;
    }
  };

  /** What names mean, in some sentences: for logs and reports. */
  std::string explanation_of_names();

  /** Whether the name @p text is @p wanted or has it in front: "(0,3+)" is in
   * "(0,3+) support tangential 2" and, as one of the alternatives, in
   * "(0,3+)|(0,4+)". A near tie that is wanted is any of its names. */
  bool is_called(const std::string &text, const std::string &wanted);



  /**
   * Names of vibration shapes of a scene.
   *
   * An annulus is a disc, and so is a body from a mesh file that pads slide on
   * all round (disc_rings()): its shape (n, m) has n nodal circles and m nodal
   * diameters; "+" has an antinode in the middle of the bodies that touch it
   * (at the first of them where they stand all round it; at angle 0 without a
   * pair), "-" a node. Other bodies are named by the
   * direction of their motion and the number of parts that move in opposition
   * along the body: 1 without a node, 2 with one node. A name mentions a disc
   * and another body by their energy shares (naming::disc_share,
   * naming::solid_share), at least one of them.
   *
   * A name follows from the shape alone, not from its place in a table. What
   * lies within the band about a decision has both names, as a tie.
   *
   * Naming needs the coordinates of a vector only, a linear map: those of a
   * whole basis V are computed once and serve every combination V q.
   */
  class ModeNamer
  {
  public:
    /** For models without geometry: plain numbers. */
    ModeNamer();

    /** For a scene; may be dropped with the discretization afterwards. All
     * ranks together. */
    explicit ModeNamer(const Discretization &discretization);

    /** Names of real shapes (owned rows x modes).
     * @p energy_shares: bodies x modes, each column of sum about 1.
     * @p eigenvalues: of the columns, their neighbours next to them, or empty.
     * Columns of one eigenvalue are named by the shapes that their space holds,
     * whatever mixture of them they are. */
    std::vector<ModeName> name(const Block            &modes,
                               const Eigen::MatrixXd  &energy_shares,
                               const Eigen::VectorXcd &eigenvalues = {}) const;

    /** Names of complex shapes. They do not depend on the phase; a travelling
     * wave is a tie of both parities. */
    std::vector<ModeName> name(const ComplexBlock     &modes,
                               const Eigen::MatrixXd  &energy_shares,
                               const Eigen::VectorXcd &eigenvalues = {}) const;

    /** Coordinates of vectors, a column each, the same on every rank. */
    Eigen::MatrixXd coordinates(const Block &vectors) const;
    unsigned int    n_coordinates() const;

    /** Names from coordinates. */
    std::vector<ModeName> name_coordinates(
      const Eigen::MatrixXcd &coordinates,
      const Eigen::MatrixXd  &energy_shares,
      const Eigen::VectorXcd &eigenvalues = {}) const;

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

    /** What every row of signature() belongs to, whatever the order of the
     * bodies: "pin_3", the third row of body pin; "pin_about_disc_3" where its
     * points or directions follow the disc that names refer to. */
    const std::vector<std::string> &signature_entries() const;

    /** Angle of the "+" antinode about the disc axis from x towards y, rad. */
    double reference_angle() const;

    /** The disc that names refer to: that of the first contact pair, else the
     * first one, else -1u. */
    unsigned int disc() const;

    /** Its ring; null without one. */
    const DiscRing *ring() const;

  private:
    struct Body
    {
      std::string                  name;
      std::unique_ptr<DiscShapes>  disc;  /**< of a disc */
      std::unique_ptr<SolidShapes> solid; /**< of any other body */
      unsigned int                 first_sample     = 0;
      unsigned int                 first_coordinate = 0;
    };

    struct DiscPart
    {
      unsigned int body;
      DiscShape    shape;
    };
    struct SolidPart
    {
      unsigned int body;
      SolidShape   shape;
    };
    std::vector<DiscPart>  disc_parts(const Eigen::VectorXcd &coordinates,
                                      const Eigen::VectorXd  &shares) const;
    std::vector<SolidPart> solid_parts(const Eigen::VectorXcd &coordinates,
                                       const Eigen::VectorXd  &shares) const;
    std::string text_of(const DiscPart *disc, const SolidPart *solid) const;
    ModeName    describe(const Eigen::VectorXcd &coordinates,
                         const Eigen::VectorXd  &energy_shares) const;
    /** Indices of the discs, or of the other bodies, with the largest share. */
    std::vector<unsigned int> largest_bodies(const Eigen::VectorXd &shares,
                                             const bool discs) const;
    /** Coordinates of the shapes in the space of each multiple eigenvalue in
     * the place of the columns that they are nearest to. */
    Eigen::MatrixXcd separated(const Eigen::MatrixXcd &coordinates,
                               const Eigen::VectorXcd &eigenvalues) const;
    Eigen::VectorXd  mirror_weights() const;
    /** Orders columns by nodal diameters, "+" before "-". */
    std::vector<unsigned int> order_of_shapes(
      const Eigen::MatrixXd &coordinates) const;

    std::vector<Body>                  bodies;
    unsigned int                       n_discs           = 0;
    unsigned int                       total_coordinates = 0;
    double                             angle             = 0.;
    unsigned int                       main_body         = -1u;
    std::optional<DiscRing>            main_ring;
    std::shared_ptr<const Functionals> samples, signature_rows;
    std::vector<std::string>           entries; /**< of signature_rows */
  };
} // namespace squeal

#endif
