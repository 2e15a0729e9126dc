// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_elimination_h
#define squeal_contact_elimination_h

#include <squeal/base/low_rank_matrix.h>
#include <squeal/discretization/affine_system.h>

#include <memory>
#include <vector>

namespace squeal
{
  /**
   * Unknowns that follow others: u_s = sum of weights u_m, with the dependent
   * (source) unknowns s and combinations of independent ones m, both global
   * rows of the full row space. No m is itself dependent.
   */
  struct DependentUnknowns
  {
    std::vector<unsigned int>     rows;
    std::vector<Functionals::Row> combinations;
  };

  /**
   * The map u = P v from the independent unknowns v to all unknowns u. The
   * dependent rows are known in full on every rank (contact is small).
   */
  class Elimination
  {
  public:
    Elimination(std::shared_ptr<const RowSpace> full,
                DependentUnknowns               dependent);

    std::shared_ptr<const RowSpace> full_space() const;
    std::shared_ptr<const RowSpace> reduced_space() const;
    unsigned int                    n_dependent() const;

    /** u = P v. */
    Block expand(const Block &v) const;
    /** P^T f. */
    Block restrict_forces(const Block &f) const;
    /** The dependent rows of f, the same on every rank. */
    Eigen::MatrixXd dependent_rows(const Block &f) const;
    /** E_s g: values on the dependent rows, zero elsewhere. */
    Block from_dependent_rows(const Eigen::MatrixXd &g) const;

    /** Functionals of all unknowns as functionals of the independent ones. */
    std::shared_ptr<const Functionals> reduce(
      const Functionals &functionals) const;

    /** P^T A P with entries of A given in full numbering: appends to
     * @p reduced. Of a symmetric A both triangles must be given. */
    void reduce_entries(const Triplets &full,
                        const bool      lower_only,
                        Triplets       &reduced) const;

    /** L^T (E_s^T A) P for functionals L (one a dependent row), entries. */
    void friction_entries(const Triplets    &full,
                          const Functionals &left,
                          Triplets          &reduced) const;

  private:
    int dependent_index(const unsigned int row) const;

    std::shared_ptr<const RowSpace> full, reduced;
    DependentUnknowns               dependent;
    std::vector<int>                new_number; /**< of every full row; -1-k
                                                   for dependent number k */
    std::shared_ptr<const Functionals> combinations; /**< in reduced rows */
  };

  /** P^T A P. */
  class EliminatedOperator : public LinearOperator
  {
  public:
    EliminatedOperator(std::shared_ptr<const LinearOperator> matrix,
                       std::shared_ptr<const Elimination>    elimination);
    Block multiply(const Block &X) const override;
    Block multiply_transposed(const Block &X) const override;
    Block multiply_absolute(const Block &X) const override;
    bool  is_symmetric() const override;
    void  append_to(Triplets    &triplets,
                    const double factor,
                    const bool   lower_only) const override;

  private:
    std::shared_ptr<const LinearOperator> matrix;
    std::shared_ptr<const Elimination>    elimination;
  };

  /**
   * What part A of the pencil adds to the friction of an eliminated contact:
   * B_t^T lambda_n with the recovered multipliers lambda_n = D^-1 E_s^T A P v.
   */
  class MultiplierFriction : public LowRankOperator
  {
  public:
    /** @p tangential: one functional a dependent row, in full numbering. */
    MultiplierFriction(std::shared_ptr<const LinearOperator> matrix,
                       std::shared_ptr<const Elimination>    elimination,
                       std::shared_ptr<const Functionals>    tangential);
    const Functionals &left_rows() const override;
    Eigen::MatrixXd    forces(const Block &X) const override;
    Block transposed_forces(const Eigen::MatrixXd &g) const override;
    Block multiply_absolute(const Block &X) const override;
    bool  is_symmetric() const override;
    void  append_to(Triplets    &triplets,
                    const double factor,
                    const bool   lower_only) const override;

  private:
    std::shared_ptr<const LinearOperator> matrix;
    std::shared_ptr<const Elimination>    elimination;
    std::shared_ptr<const Functionals>    left; /**< in reduced rows */
  };
} // namespace squeal

#endif
