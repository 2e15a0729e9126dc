// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef squeal_base_dense_decompositions_h
#define squeal_base_dense_decompositions_h

/**
 * @file
 * Eigen's decompositions of dense matrices, compiled once for the whole program
 * (`dense_decompositions.cc`) instead of in every unit that asks for one: they
 * were a quarter of the code of the object files. The header is among the
 * precompiled ones (`cmake/precompiled_headers.cmake`); no source needs to
 * include it, and without it the same code is made where it is used.
 */

#include <Eigen/Dense>

// The parts below Eigen's interface are named as Eigen 3.4 names them.
#if EIGEN_VERSION_AT_LEAST(3, 4, 0) && !EIGEN_VERSION_AT_LEAST(3, 4, 90)

namespace squeal
{
  /** Short names of Eigen's types in the lists below. */
  namespace dense_types
  {
    using Eigen::Block;
    using Eigen::Dynamic;
    using Eigen::Index;
    using Eigen::MatrixXd;
    using Eigen::VectorXd;
    using Kernel    = Eigen::internal::gebp_traits<double, double>;
    using Result    = Eigen::internal::blas_data_mapper<double, Index, 0, 0, 1>;
    using Columns   = Eigen::internal::const_blas_data_mapper<double, Index, 0>;
    using Rows      = Eigen::internal::const_blas_data_mapper<double, Index, 1>;
    using Part      = Block<MatrixXd, Dynamic, Dynamic, false>;
    using Column    = Block<const MatrixXd, Dynamic, 1, false>;
    using ColumnEnd = Eigen::VectorBlock<Block<MatrixXd, Dynamic, 1, true>>;
    using Factors   = Eigen::VectorBlock<const VectorXd>;
    using FactorsOfPart = Block<const VectorXd, Dynamic, 1, false>;
    using Triangle = Eigen::Matrix<double, Dynamic, Dynamic, Eigen::RowMajor>;
  } // namespace dense_types
} // namespace squeal

/** The decompositions; PREFIX is `extern template` or `template`. */
#  define SQUEAL_DENSE_DECOMPOSITIONS(PREFIX)                    \
    PREFIX class Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>; \
    PREFIX class Eigen::HouseholderQR<Eigen::MatrixXd>;          \
    PREFIX class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;    \
    PREFIX class Eigen::PartialPivLU<Eigen::MatrixXd>;           \
    PREFIX class Eigen::PartialPivLU<Eigen::MatrixXcd>;          \
    PREFIX class Eigen::LLT<Eigen::MatrixXd, Eigen::Lower>;      \
    PREFIX class Eigen::LDLT<Eigen::MatrixXd, Eigen::Lower>;     \
    PREFIX class Eigen::JacobiSVD<Eigen::MatrixXd>;

/** The kernels of small products and of LU. */
#  define SQUEAL_DENSE_KERNELS(PREFIX)                \
    PREFIX struct Eigen::internal::gebp_kernel<       \
      double,                                         \
      double,                                         \
      squeal::dense_types::Index,                     \
      squeal::dense_types::Result,                    \
      squeal::dense_types::Kernel::mr,                \
      squeal::dense_types::Kernel::nr,                \
      false,                                          \
      false>;                                         \
    PREFIX struct Eigen::internal::gemm_pack_lhs<     \
      double,                                         \
      squeal::dense_types::Index,                     \
      squeal::dense_types::Columns,                   \
      squeal::dense_types::Kernel::mr,                \
      squeal::dense_types::Kernel::LhsProgress,       \
      squeal::dense_types::Kernel::LhsPacket4Packing, \
      0,                                              \
      false,                                          \
      false>;                                         \
    PREFIX struct Eigen::internal::gemm_pack_lhs<     \
      double,                                         \
      squeal::dense_types::Index,                     \
      squeal::dense_types::Rows,                      \
      squeal::dense_types::Kernel::mr,                \
      squeal::dense_types::Kernel::LhsProgress,       \
      squeal::dense_types::Kernel::LhsPacket4Packing, \
      1,                                              \
      false,                                          \
      false>;                                         \
    PREFIX struct Eigen::internal::gemm_pack_rhs<     \
      double,                                         \
      squeal::dense_types::Index,                     \
      squeal::dense_types::Columns,                   \
      squeal::dense_types::Kernel::nr,                \
      0,                                              \
      false,                                          \
      false>;                                         \
    PREFIX struct Eigen::internal::gemm_pack_rhs<     \
      double,                                         \
      squeal::dense_types::Index,                     \
      squeal::dense_types::Rows,                      \
      squeal::dense_types::Kernel::nr,                \
      1,                                              \
      false,                                          \
      false>;                                         \
    PREFIX struct Eigen::internal::partial_lu_impl<double, 0, int, -1>;

/** Reflections, and the symmetric eigenproblem of a tridiagonal matrix. */
#  define SQUEAL_DENSE_REFLECTIONS(PREFIX)                                    \
    PREFIX void Eigen::internal::make_block_householder_triangular_factor(    \
      squeal::dense_types::Triangle &,                                        \
      const squeal::dense_types::Part &,                                      \
      const squeal::dense_types::Factors &);                                  \
    PREFIX void Eigen::internal::make_block_householder_triangular_factor(    \
      squeal::dense_types::Triangle &,                                        \
      const squeal::dense_types::Part &,                                      \
      const squeal::dense_types::FactorsOfPart &);                            \
    PREFIX void Eigen::internal::apply_block_householder_on_the_left(         \
      squeal::dense_types::Part &,                                            \
      const squeal::dense_types::Part &,                                      \
      const squeal::dense_types::Factors &,                                   \
      bool);                                                                  \
    PREFIX void                                                               \
    Eigen::MatrixBase<squeal::dense_types::Part>::applyHouseholderOnTheRight( \
      const squeal::dense_types::Column &, const double &, double *);         \
    PREFIX void                                                               \
    Eigen::MatrixBase<squeal::dense_types::Part>::applyHouseholderOnTheLeft(  \
      const squeal::dense_types::Column &, const double &, double *);         \
    PREFIX void                                                               \
    Eigen::MatrixBase<squeal::dense_types::Part>::applyHouseholderOnTheLeft(  \
      const squeal::dense_types::ColumnEnd &, const double &, double *);      \
    PREFIX void Eigen::internal::tridiagonalization_inplace(                  \
      squeal::dense_types::MatrixXd &, squeal::dense_types::VectorXd &);      \
    PREFIX Eigen::ComputationInfo                                             \
           Eigen::internal::computeFromTridiagonal_impl(                      \
      squeal::dense_types::VectorXd &,                                 \
      squeal::dense_types::VectorXd &,                                 \
      const squeal::dense_types::Index,                                \
      bool,                                                            \
      squeal::dense_types::MatrixXd &);

SQUEAL_DENSE_KERNELS(extern template)
SQUEAL_DENSE_REFLECTIONS(extern template)
SQUEAL_DENSE_DECOMPOSITIONS(extern template)

#endif
#endif
