// SPDX-License-Identifier: LGPL-2.1-or-later

// An orthotropic material has its moduli along the axes it is given.

#include <squeal/discretization/element_matrices.h>

#include <deal.II/base/tensor.h>

#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Axis = dealii::Tensor<1, 3>;

  BodyParameters
  lining()
  {
    BodyParameters body;
    body.material_model = BodyParameters::MaterialModel::orthotropic;
    body.young_moduli   = {{8e9, 6e9, 1e9}};
    body.shear_moduli   = {{.5e9, .7e9, 2.5e9}};
    body.poisson_ratios = {{.15, .1, .2}};
    return body;
  }

  /** Largest difference of two tensors over the largest entry. */
  double
  difference(const ElasticTensor &a, const ElasticTensor &b)
  {
    Worst worst;
    for (unsigned int i = 0; i < 9; ++i)
      for (unsigned int j = 0; j < 9; ++j)
        worst.add(std::abs(a[i][j] - b[i][j]) / 8e9);
    return worst.largest();
  }

  /** a_i b_j C_ijkl c_k d_l */
  double
  component(const ElasticTensor &C,
            const Axis          &a,
            const Axis          &b,
            const Axis          &c,
            const Axis          &d)
  {
    double sum = 0.;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = 0; l < 3; ++l)
            sum += a[i] * b[j] * C[3 * i + j][3 * k + l] * c[k] * d[l];
    return sum;
  }
} // namespace



int
main()
{
  // axes 1, 2, 3 along y, z, x
  BodyParameters turned  = lining();
  turned.material_axis_1 = {{0., 3., 0.}};
  turned.material_axis_2 = {{0., 1., .5}};
  // E3, E1, E2; G23 = G(1, 2), G13 = G(3, 2), G12 = G(3, 1); nu along x of
  // tension along y is nu12' of the compliances -nu31/E3
  BodyParameters permuted = lining();
  permuted.young_moduli   = {{1e9, 8e9, 6e9}};
  permuted.shear_moduli   = {{2.5e9, .5e9, .7e9}};
  permuted.poisson_ratios = {{.2, .15 * 1. / 6., .1 * 1. / 8.}};
  check(difference(elastic_tensor(turned), elastic_tensor(permuted)) < 1e-14,
        "axes along y, z, x");
  check(difference(elastic_tensor(turned), elastic_tensor(lining())) > .1,
        "which is another material");

  BodyParameters skew  = lining();
  skew.material_axis_1 = {{1., 2., -1.}};
  skew.material_axis_2 = {{.5, -.3, .8}};
  const Axis x({1., 0., 0.}), y({0., 1., 0.}), z({0., 0., 1.});
  Axis       first({1., 2., -1.}), second({.5, -.3, .8});
  first /= first.norm();
  second -= (second * first) * first;
  second /= second.norm();
  const Axis  third = dealii::cross_product_3d(first, second);
  const auto  C = elastic_tensor(lining()), D = elastic_tensor(skew);
  const Axis *old_axes[] = {&x, &y, &z},
             *new_axes[] = {&first, &second, &third};
  Worst worst;
  for (unsigned int n = 0; n < 81; ++n)
    {
      const unsigned int a = n % 3, b = n / 3 % 3, c = n / 9 % 3, d = n / 27;
      worst.add(
        std::abs(
          component(D, *new_axes[a], *new_axes[b], *new_axes[c], *new_axes[d]) -
          component(
            C, *old_axes[a], *old_axes[b], *old_axes[c], *old_axes[d])) /
        8e9);
    }
  check(worst.largest() < 1e-14, "skew axes: all components along them");
}
