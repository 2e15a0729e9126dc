// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_kept_inverse_h
#define squeal_transient_kept_inverse_h

#include <squeal/base/contact_status.h>

#include <Eigen/Dense>

#include <vector>

namespace squeal
{
  /** What the rows of the Jacobian of a contact node depend on. */
  struct NodeRows
  {
    ContactStatus   status    = ContactStatus::open;
    double          friction  = 0.; /**< d|lambda_t| / dp at this x */
    double          turning   = 0.; /**< mu p / |x|: how x turns the force */
    double          along     = 0.; /**< d|lambda_t| / d|x| */
    Eigen::Vector2d direction = Eigen::Vector2d::Zero(); /**< of x */

    /** Whether one Jacobian serves both. */
    bool is_near(const NodeRows &other) const;
    /** Whether the force along x is given by the normal one alone. */
    bool is_limited() const;
  };

  /**
   * Inverse of a Jacobian with three rows a node (normal, along, across), kept
   * while rows of some nodes change: a low-rank change of it (Woodbury) stands
   * for the new rows. Scalar is the precision it is kept in; float halves the
   * memory that an application reads.
   *
   * Rows of open nodes are those of the identity. At a slipping node the row
   * along its direction d, less mu times the normal row, holds that node's
   * unknowns alone where the force along d is limited: x_d = mu x_n + r_d - mu
   * r_n. So open nodes and these unknowns are eliminated before the
   * factorisation. What is kept is the
   * factor; once it has been applied often the whole inverse, which is faster
   * to apply and dearer to get.
   */
  template <typename Scalar>
  class KeptInverse
  {
  public:
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using Rows =
      Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    /** Three rows of a Jacobian, or all of them. */
    using Jacobian =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    /** Factorises @p J, whose nodes have the rows that @p nodes tells. */
    void invert(const Jacobian &J, const std::vector<NodeRows> &nodes);
    /** Forgets all changes. */
    void clear();
    /** Sets the changes of the rows of the nodes at @p places among @p nodes,
     * which may be new ones at the end. */
    void            extend(const Jacobian                  &changes,
                           const std::vector<unsigned int> &places,
                           const std::vector<unsigned int> &nodes);
    Eigen::VectorXd apply(const Eigen::VectorXd &v);

    /** @name What an operator that is set up again needs to give the same bits
     */
    //@{
    const Matrix &changed_columns() const;
    const Matrix &change_matrix() const;
    unsigned int  n_applied() const;
    /** After invert() and extend() with all changes at once. */
    void restore(const Matrix      &changed_columns,
                 const Matrix      &change_matrix,
                 const unsigned int n_applied);
    //@}

  private:
    /** J^-1 R without the changes. @p Right: Matrix, or a vector, which the
     * factors are solved for five times as fast as for a matrix of one column.
     */
    template <typename Right>
    Right solve(const Right &R) const;
    void  factorize();

    /** An unknown that is left: of a node, in a direction of its three. */
    struct Unknown
    {
      Eigen::Index                first; /**< row of its node */
      Eigen::Matrix<Scalar, 3, 1> row;   /**< of the equations */
      Eigen::Matrix<Scalar, 3, 1> motion;
    };
    std::vector<NodeRows>       base;
    std::vector<Unknown>        unknowns;
    Rows                        equations; /**< of the unknowns, all columns */
    Eigen::PartialPivLU<Matrix> factor;
    Matrix                      inverse; /**< empty until it pays */
    unsigned int                applications = 0;

    Matrix difference; /**< what the rows of changed nodes differ by */
    Matrix columns;    /**< of the inverse that belong to changed nodes */
    Matrix small;      /**< difference times columns */
    Eigen::PartialPivLU<Matrix> small_factor; /**< of identity plus small */
  };
} // namespace squeal

#endif
