// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_kept_inverse_h
#define squeal_transient_kept_inverse_h

#include <Eigen/Dense>

#include <vector>

namespace squeal
{
  /**
   * Inverse of a matrix with three rows a node, kept while rows of some nodes
   * change: a low-rank change of it (Woodbury) stands for the new rows. Scalar
   * is the precision that the inverse is kept in; float halves the memory that
   * an application reads.
   */
  template <typename Scalar>
  struct KeptInverse
  {
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    Matrix inverse;
    Matrix difference; /**< what the rows of changed nodes differ by */
    Matrix columns;    /**< of the inverse that belong to changed nodes */
    Matrix small;      /**< difference times columns */
    Eigen::PartialPivLU<Matrix> small_factor; /**< of identity plus small */

    /** Inverts @p J, whose rows @p open are those of the identity. */
    void invert(const Eigen::MatrixXd  &J,
                const std::vector<int> &closed,
                const std::vector<int> &open);
    /** Forgets all changes. */
    void clear();
    /** Sets the changes of the rows of the nodes at @p places among @p nodes,
     * which may be new ones at the end. */
    void            extend(const Eigen::MatrixXd           &changes,
                           const std::vector<unsigned int> &places,
                           const std::vector<unsigned int> &nodes);
    void            factorize();
    Eigen::VectorXd apply(const Eigen::VectorXd &v) const;
  };
} // namespace squeal

#endif
