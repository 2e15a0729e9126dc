// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_matrix_import_h
#define squeal_scene_matrix_import_h

#include <squeal/parameters/scene_parameters.h>

#include <string>
#include <tuple>
#include <vector>

namespace squeal
{
  /**
   * Name of an unknown in another code: node (or grid point) number and
   * component, 1 to 3 displacements along x, y, z, 4 to 6 rotations, 0 the only
   * unknown of a scalar point. Ordered by node, then component. Nodes that a
   * code adds by itself may have negative numbers.
   */
  struct DofLabel
  {
    long         node      = 0;
    unsigned int component = 0;

    bool
    operator==(const DofLabel &other) const
    {
      return node == other.node && component == other.component;
    }
    bool
    operator<(const DofLabel &other) const
    {
      return std::tie(node, component) < std::tie(other.node, other.component);
    }
  };

  /** "node 12, component 3". */
  std::string describe(const DofLabel &label);



  /**
   * A square matrix read from a file of another code. All nonzero entries are
   * there, both triangles of a symmetric matrix, sorted by row and then by
   * column, each once; row and column numbers start at 0. Values are as in the
   * file: not yet multiplied by factor.
   */
  struct ImportedMatrix
  {
    enum class Symmetry
    {
      symmetric,
      skew,
      general
    };
    /** What is taken for left out of a file. */
    enum class Storage
    {
      stated,       /**< what the file says */
      assumed_full, /**< nothing */
      assumed_half  /**< the mirror images of a symmetric matrix */
    };

    std::string                name;
    std::string                file;
    MatrixPartParameters::Role role   = MatrixPartParameters::Role::stiffness;
    double                     factor = 1.;

    /** Number of rows. */
    unsigned int n = 0;
    /** False where the file does not say how many rows there are: n is then
     * the highest number met. */
    bool     size_is_given = false;
    Symmetry symmetry      = Symmetry::symmetric;
    Storage  storage       = Storage::stated;
    /** Of role friction: whether it is a part of C, as damping_mark in its
     * file says, and not of K. */
    bool is_damping = false;

    std::vector<unsigned int> rows, columns;
    std::vector<double>       values;

    /** Name of every row, ascending; empty where the file has only numbers. */
    std::vector<DofLabel> labels;
  };



  /** Comment of a MatrixMarket file whose matrix is a part of C in the role
   * friction. */
  inline constexpr const char *damping_mark =
    "part of C, times the coefficient of friction";

  /**
   * Reads the matrix of one part. Understood are
   *  - MatrixMarket coordinate files, real or integer, general, symmetric or
   *    skew-symmetric,
   *  - what Abaqus' MATRIX OUTPUT writes with FORMAT=MATRIX INPUT (row node,
   *    row dof, column node, column dof, value) and FORMAT=COORDINATE (row,
   *    column, value),
   *  - DMIG entries of Nastran in small, large and free fields; all other
   *    entries of a bulk data or punch file are passed over.
   *
   * Where a file does not say whether it holds one half of a symmetric matrix,
   * it does if no off-diagonal entry has its mirror image and, for the roles
   * damping and friction, every row and column of a nonzero entry has a
   * diagonal entry. Matrices of the roles mass, stiffness and normal contact
   * must be symmetric, but for the unknowns that these hold (held_stiffness):
   * mirror images may differ by 1e-8 relative (printed digits) and by 1e-14 of
   * the geometric mean of their diagonal entries or of the median of all, that
   * of held ones left out (cancellation), and are replaced by their mean.
   *
   * Throws InputError, one line that names part, file and line, for anything
   * else: a missing, empty, truncated or binary file, complex, dense, pattern
   * and rectangular matrices, an entry that is given twice, out of range or not
   * finite, the wrong number of entries, an unsymmetric stiffness, a part of C
   * in a role that is none, a name of a matrix where the format has none.
   *
   * Sources: the Matrix Market exchange formats (NIST), the keyword reference
   * of Abaqus (*MATRIX INPUT, *MATRIX OUTPUT), the bulk data entry DMIG of the
   * Nastran quick reference guides. doc/import.md says how to write each.
   */
  ImportedMatrix read_matrix(const MatrixPartParameters &part);
} // namespace squeal

#endif
