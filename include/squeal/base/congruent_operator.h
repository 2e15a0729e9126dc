// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_congruent_operator_h
#define squeal_base_congruent_operator_h

#include <squeal/base/linear_operator.h>

namespace squeal
{
  /** A linear map u = P v from the vectors of one row space to those of
   * another. */
  class VectorMap
  {
  public:
    virtual ~VectorMap() = default;
    /** P v. */
    virtual Block expand(const Block &v) const = 0;
    /** P^T f. */
    virtual Block restrict_forces(const Block &f) const = 0;
  };



  /**
   * An operator P^T A P. A sum of several of one map P applies it once.
   */
  class CongruentOperator : public LinearOperator
  {
  public:
    virtual const LinearOperator &inner() const = 0;
    virtual const VectorMap      &map() const   = 0;
  };
} // namespace squeal

#endif
