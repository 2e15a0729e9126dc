// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_elimination_h
#define squeal_contact_elimination_h

#include <squeal/base/congruent_operator.h>
#include <squeal/base/low_rank_matrix.h>
#include <squeal/discretization/affine_system.h>

#include <memory>
#include <string>
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
    /** What makes each follow, such as "Tie pad_support": for messages. */
    std::vector<std::string> owners;
  };

  /**
   * The map u = P v from the independent unknowns v to all unknowns u. The
   * dependent rows are known in full on every rank (contact is small).
   */
  class Elimination : public VectorMap
  {
  public:
    Elimination(std::shared_ptr<const RowSpace> full,
                DependentUnknowns               dependent);

    std::shared_ptr<const RowSpace> full_space() const;
    std::shared_ptr<const RowSpace> reduced_space() const;
    unsigned int                    n_dependent() const;

    /** u = P v. */
    Block expand(const Block &v) const override;
    /** P^T f. */
    Block restrict_forces(const Block &f) const override;
    /** |P| |v| and |P|^T |f|, entry by entry: bounds of rounding. */
    Block expand_absolute(const Block &v) const;
    Block restrict_absolute(const Block &f) const;

    /** Functionals of all unknowns as functionals of the independent ones. */
    std::shared_ptr<const Functionals> reduce(
      const Functionals &functionals) const;

    /** P^T A P with entries of A given in full numbering: appends to
     * @p reduced. Of a symmetric A both triangles must be given. */
    void reduce_entries(const Triplets &full,
                        const bool      lower_only,
                        Triplets       &reduced) const;

    /** N A P with functionals N of all unknowns, as functionals of the
     * independent ones: the rows of A that N takes, summed over the ranks. With
     * @p absolute |N| |A| |P|. */
    std::shared_ptr<const Functionals> forces_of(const Functionals    &normal,
                                                 const LinearOperator &matrix,
                                                 const bool absolute) const;

  private:
    /** The dependent rows of f, the same on every rank. */
    Eigen::MatrixXd dependent_rows(const Block &f) const;
    Block           independent_rows(const Block &f) const;
    Block expanded(const Block &v, const Eigen::MatrixXd &of_dependent) const;

    std::shared_ptr<const RowSpace> full, reduced;
    DependentUnknowns               dependent;
    std::vector<int>                new_number; /**< of every full row; -1-k
                                                   for dependent number k */
    std::shared_ptr<const Functionals> combinations; /**< in reduced rows */
  };

  /** P^T A P. */
  class EliminatedOperator : public CongruentOperator
  {
  public:
    EliminatedOperator(std::shared_ptr<const LinearOperator> matrix,
                       std::shared_ptr<const Elimination>    elimination);
    const LinearOperator &inner() const override;
    const VectorMap      &map() const override;
    Block                 multiply(const Block &X) const override;
    Block                 multiply_transposed(const Block &X) const override;
    Block                 multiply_absolute(const Block &X) const override;
    bool                  is_symmetric() const override;
    void                  append_to(Triplets    &triplets,
                                    const double factor,
                                    const bool   lower_only) const override;

  private:
    std::shared_ptr<const LinearOperator> matrix;
    std::shared_ptr<const Elimination>    elimination;
  };

  /**
   * What part A of the pencil adds to the friction of an eliminated contact:
   * B_t^T lambda_n with the recovered multipliers. The forces A P v on a source
   * node are n lambda_n + t mu lambda_n, and t is across n: lambda_n = N A P v,
   * where N takes the component along n of the three rows of each node. The few
   * rows of N A P are computed once: products with the whole of A would take as
   * long as those of the pencil itself.
   */
  class MultiplierFriction : public LowRankOperator
  {
  public:
    /** @p tangential: B_t of the nodes that slip as functionals of the
     * independent unknowns, one object for all parts (which are then one
     * low-rank change). @p normal: N, in full numbering. */
    MultiplierFriction(const LinearOperator              &matrix,
                       const Elimination                 &elimination,
                       std::shared_ptr<const Functionals> tangential,
                       const Functionals                 &normal);
    const Functionals &left_rows() const override;
    Eigen::MatrixXd    forces(const Block &X) const override;
    Block transposed_forces(const Eigen::MatrixXd &g) const override;
    Block multiply_absolute(const Block &X) const override;
    bool  is_symmetric() const override;
    void  append_to(Triplets    &triplets,
                    const double factor,
                    const bool   lower_only) const override;

  private:
    std::shared_ptr<const Functionals> left, right, right_absolute;
  };
} // namespace squeal

#endif
