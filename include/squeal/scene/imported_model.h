// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_imported_model_h
#define squeal_scene_imported_model_h

#include <squeal/base/linear_operator.h>

#include <squeal/scene/matrix_import.h>

#include <array>
#include <utility>
#include <vector>

namespace squeal
{
  /**
   * The point pairs of an imported model as sparse rows over its unknowns.
   * Signs as everywhere: normal rows give the approach z_d - z_p (target minus
   * source, normal out of the target), sliding rows the displacement of the
   * target against the source along the target's motion.
   */
  struct ImportedContact
  {
    /** A row: unknown and weight, ascending. */
    using Row = std::vector<std::pair<unsigned int, double>>;

    /** Numbers of the pairs in the file, ascending. */
    std::vector<long> pairs;
    /** Rows of B_n and, along and across the sliding direction, of B_t; one a
     * pair. The transverse rows are empty when the file has none. */
    std::vector<Row> normal, sliding, transverse;
    /** Multiplies the normal stiffness, one a pair. */
    std::vector<double> stiffness_factors;

    /** @name Of contacts that the scene names, one a pair; else empty */
    //@{
    /** Motions of either side along normal, sliding and transverse direction,
     * both counted along it. */
    std::vector<std::array<Row, 3>> target, source;
    /** These three directions, unit vectors, orthogonal: s = t x n. */
    std::vector<std::array<Vector3, 3>> directions;
    std::vector<Vector3>                points; /**< m */
    std::vector<double>                 areas;  /**< m^2 */
    /** |V| over its mean over the points. */
    std::vector<double> speed_ratio;
    //@}
  };



  /**
   * All of a scene of kind `matrices` in one numbering of the unknowns: the
   * union of the parts' names sorted by node and component, or the numbers of
   * the files where these have no names. A node table, if there is one, sets
   * the numbering (column dof) and says what there is.
   *
   * Unknowns that the other code holds by a large number on the diagonal of the
   * stiffness (Abaqus writes 1e36 for boundary conditions) are taken out of all
   * matrices and of the contact rows, as Dirichlet rows are.
   */
  struct ImportedModel
  {
    /** Number of unknowns, held ones not counted. */
    unsigned int n_dofs = 0;

    /** The parts; n is n_dofs and labels are empty in each. */
    std::vector<ImportedMatrix> parts;

    /** Name of each unknown; empty when neither files nor table have names. */
    std::vector<DofLabel> labels;
    /** Number of each unknown before the held ones were taken out, from 0. */
    std::vector<unsigned int> original_numbers;
    /** Unknowns that are held, in the numbering before. */
    std::vector<unsigned int> held;

    /** Place of each unknown, m; empty without a node table. */
    std::vector<Vector3> positions;
    /** Bodies in the order of the table; one called "model" without it. */
    std::vector<std::string> bodies;
    /** Body of each unknown. */
    std::vector<unsigned int> body_of;

    /** Point pairs of a scene that names no contacts; empty without a contact
     * pattern. */
    ImportedContact contact;
    /** Those of the scene's contacts, in its order. */
    std::vector<ImportedContact> contacts;
    /** Forces of the scene's loads, N, one a load and unknown. */
    std::vector<std::vector<double>> loads;
    /** Weights of the mean motion of the source's face away from each contact
     * along the normal, one an unknown; empty where the node table has none. */
    std::vector<std::vector<double>> far_faces;
  };

  /** Magnitude from which on a diagonal stiffness counts as a held unknown. */
  inline constexpr double held_stiffness = 1e30;

  /**
   * Reads all files of an imported scene and brings them together. Throws
   * InputError, one line, for what read_matrix(), read_node_table() and
   * read_contact_pattern() refuse, and for
   *  - a scene without a mass or a stiffness part,
   *  - parts of different size, with and without names and no node table, or
   *    with an unknown that the table does not have,
   *  - a negative mass on the diagonal,
   *  - an unknown with neither mass nor stiffness of its own (unconnected, or
   *    a Lagrange multiplier),
   *  - a point pair without normal or sliding row, with an unknown that is not
   *    there, or one that a rigid translation would open or close,
   *  - a contact of the pattern that the scene does not have or the other way
   *    round, and directions of a pair, by the sums of its weights, that are
   *    not three orthogonal unit vectors with s = t x n.
   */
  ImportedModel read_imported_model(const SceneParameters &scene);

  /** Lower triangle of (A + A^T)/2, diagonal included. */
  Triplets lower_symmetric_part(const ImportedMatrix &matrix);

  /** Lower triangle of (A - A^T)/2. */
  Triplets lower_skew_part(const ImportedMatrix &matrix);
} // namespace squeal

#endif
