// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/discretization/element_matrices.h>

#include <Eigen/Dense>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** The axes 1, 2, 3 of an orthotropic material, one a column; exactly the
     * unit matrix where they are x, y, z. */
    Eigen::Matrix3d
    material_axes(const BodyParameters &body)
    {
      const Eigen::Vector3d first =
        Eigen::Vector3d(body.material_axis_1.data()).normalized();
      const Eigen::Vector3d third =
        first.cross(Eigen::Vector3d(body.material_axis_2.data())).normalized();
      Eigen::Matrix3d axes;
      axes << first, third.cross(first), third;
      return axes;
    }

    /** Components along x, y, z of a tensor given along @p axes. */
    ElasticTensor
    turned(const ElasticTensor &C, const Eigen::Matrix3d &axes)
    {
      if (axes == Eigen::Matrix3d::Identity())
        return C;
      // Both index pairs turn as the Kronecker product of the axes does.
      Eigen::Matrix<double, 9, 9> Q, tensor;
      for (unsigned int i = 0; i < 9; ++i)
        for (unsigned int j = 0; j < 9; ++j)
          {
            Q(i, j)      = axes(i / 3, j / 3) * axes(i % 3, j % 3);
            tensor(i, j) = C[i][j];
          }
      tensor = (Q * tensor * Q.transpose()).eval();
      ElasticTensor result;
      for (unsigned int i = 0; i < 9; ++i)
        for (unsigned int j = 0; j < 9; ++j)
          result[i][j] = .5 * (tensor(i, j) + tensor(j, i));
      return result;
    }
  } // namespace



  ElasticTensor
  elastic_tensor(const BodyParameters &body)
  {
    Eigen::Matrix<double, 6, 6> D = Eigen::Matrix<double, 6, 6>::Zero();
    if (body.material_model == BodyParameters::MaterialModel::isotropic)
      {
        const double nu     = body.poisson_ratio;
        const double lambda = nu / ((1. + nu) * (1. - 2. * nu));
        const double G      = 0.5 / (1. + nu);
        D.topLeftCorner<3, 3>().setConstant(lambda);
        D.topLeftCorner<3, 3>().diagonal().array() += 2. * G;
        D.bottomRightCorner<3, 3>().diagonal().setConstant(G);
      }
    else
      {
        Eigen::Matrix3d S;
        const auto     &E  = body.young_moduli;
        const auto     &nu = body.poisson_ratios;     // nu23, nu13, nu12
        S << 1. / E[0], -nu[2] / E[0], -nu[1] / E[0], //
          -nu[2] / E[0], 1. / E[1], -nu[0] / E[1],    //
          -nu[1] / E[0], -nu[0] / E[1], 1. / E[2];
        D.topLeftCorner<3, 3>() = S.inverse();
        for (unsigned int i = 0; i < 3; ++i)
          D(3 + i, 3 + i) = body.shear_moduli[i]; // G23, G13, G12
      }
    const auto voigt = [](const unsigned int i, const unsigned int j) {
      return i == j ? i : 6 - i - j; // (1,2) -> 3, (0,2) -> 4, (0,1) -> 5
    };
    ElasticTensor C;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = 0; l < 3; ++l)
            C[3 * i + j][3 * k + l] = D(voigt(i, j), voigt(k, l));
    return body.material_model == BodyParameters::MaterialModel::isotropic
             ? C
             : turned(C, material_axes(body));
  }



  ElasticTensor
  elastic_constants(const BodyParameters &body)
  {
    ElasticTensor result = elastic_tensor(body);
    if (body.material_model == BodyParameters::MaterialModel::isotropic)
      for (auto &row : result)
        for (double &c : row)
          c *= body.young_modulus;
    return result;
  }

  double
  largest_elastic_constant(const BodyParameters &body)
  {
    double result = 0.;
    for (const auto &row : elastic_constants(body))
      for (const double c : row)
        result = std::max(result, c);
    return result;
  }



  ElementMatrices::ElementMatrices(const dealii::DoFHandler<3> &dofs,
                                   const dealii::Mapping<3, 3> &mapping,
                                   const bool                   lumped_mass)
    : fe(dofs.get_fe().degree)
    , quadrature(dofs.get_fe().degree + 1)
    , fe_values(mapping,
                fe,
                quadrature,
                dealii::update_values | dealii::update_gradients |
                  dealii::update_quadrature_points | dealii::update_JxW_values)
  {
    if (lumped_mass)
      at_nodes = std::make_unique<dealii::FEValues<3>>(
        mapping,
        fe,
        dealii::QGaussLobatto<3>(fe.degree + 1),
        dealii::update_JxW_values);
    const auto        &system = dofs.get_fe();
    const unsigned int n      = fe.n_dofs_per_cell();
    component_of.resize(3 * n);
    scalar_of.resize(3 * n);
    for (auto &list : dof_of)
      list.resize(n);
    for (unsigned int i = 0; i < 3 * n; ++i)
      {
        std::tie(component_of[i], scalar_of[i]) =
          system.system_to_component_index(i);
        dof_of[component_of[i]][scalar_of[i]] = i;
      }
  }



  void
  ElementMatrices::reinit(
    const dealii::DoFHandler<3>::active_cell_iterator &cell)
  {
    const auto &mesh_cell =
      static_cast<const dealii::Triangulation<3>::active_cell_iterator &>(cell);
    fe_values.reinit(mesh_cell);
    const unsigned int n = fe.n_dofs_per_cell(), n_q = quadrature.size();
    values.resize(n_q, n);
    weighted_values.resize(n_q, n);
    for (unsigned int d = 0; d < 3; ++d)
      {
        gradients[d].resize(n_q, n);
        weighted[d].resize(n_q, n);
      }
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int q = 0; q < n_q; ++q)
        {
          const double w        = fe_values.JxW(q);
          values(q, a)          = fe_values.shape_value(a, q);
          weighted_values(q, a) = w * values(q, a);
          const auto &gradient  = fe_values.shape_grad(a, q);
          for (unsigned int d = 0; d < 3; ++d)
            {
              gradients[d](q, a) = gradient[d];
              weighted[d](q, a)  = w * gradient[d];
            }
        }
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int l = k; l < 3; ++l)
        {
          H[k][l].noalias() = gradients[k].transpose() * weighted[l];
          if (l > k)
            H[l][k] = H[k][l].transpose();
        }
    if (at_nodes)
      lump_mass(mesh_cell);
    else
      scalar_mass.noalias() = values.transpose() * weighted_values;
  }



  void
  ElementMatrices::lump_mass(
    const dealii::Triangulation<3>::active_cell_iterator &cell)
  {
    at_nodes->reinit(cell);
    const auto        &node = fe.get_poly_space_numbering_inverse();
    const unsigned int n    = fe.n_dofs_per_cell();
    scalar_mass.setZero(n, n);
    for (unsigned int q = 0; q < n; ++q)
      scalar_mass(node[q], node[q]) = at_nodes->JxW(q);
  }



  void
  ElementMatrices::stiffness(const ElasticTensor &C, Eigen::MatrixXd &K) const
  {
    const unsigned int n = fe.n_dofs_per_cell();
    K.resize(3 * n, 3 * n);
    Eigen::MatrixXd block(n, n);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          block.setZero();
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int l = 0; l < 3; ++l)
              if (const double c = C[3 * i + k][3 * j + l]; c != 0.)
                block += c * H[k][l];
          for (unsigned int b = 0; b < n; ++b)
            for (unsigned int a = 0; a < n; ++a)
              K(dof_of[i][a], dof_of[j][b]) = block(a, b);
        }
  }



  void
  ElementMatrices::spread(const Eigen::MatrixXd &scalar,
                          Eigen::MatrixXd       &out) const
  {
    const unsigned int n = fe.n_dofs_per_cell();
    out.setZero(3 * n, 3 * n);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int b = 0; b < n; ++b)
        for (unsigned int a = 0; a < n; ++a)
          out(dof_of[i][a], dof_of[i][b]) = scalar(a, b);
  }

  void
  ElementMatrices::mass(Eigen::MatrixXd &M) const
  {
    spread(scalar_mass, M);
  }



  void
  ElementMatrices::rotation(const double     x0,
                            const double     y0,
                            Eigen::MatrixXd &G,
                            Eigen::MatrixXd &N) const
  {
    const unsigned int n_q = quadrature.size();
    Eigen::MatrixXd    turn(n_q, fe.n_dofs_per_cell());
    Eigen::VectorXd    weights(n_q);
    for (unsigned int q = 0; q < n_q; ++q)
      {
        const auto &x = fe_values.quadrature_point(q);
        turn.row(q) =
          (x[0] - x0) * gradients[1].row(q) - (x[1] - y0) * gradients[0].row(q);
        weights[q] = fe_values.JxW(q);
      }
    const Eigen::MatrixXd half = weighted_values.transpose() * turn;
    spread(half - half.transpose(), G);
    spread(-turn.transpose() * weights.asDiagonal() * turn, N);
  }



  Eigen::VectorXd
  ElementMatrices::centrifugal_load(const double x0, const double y0) const
  {
    const unsigned int n = fe.n_dofs_per_cell(), n_q = quadrature.size();
    Eigen::MatrixXd    radius(n_q, 2);
    for (unsigned int q = 0; q < n_q; ++q)
      radius.row(q) << fe_values.quadrature_point(q)[0] - x0,
        fe_values.quadrature_point(q)[1] - y0;
    const Eigen::MatrixXd forces = weighted_values.transpose() * radius;
    Eigen::VectorXd       result = Eigen::VectorXd::Zero(3 * n);
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int a = 0; a < n; ++a)
        result[dof_of[i][a]] = forces(a, i);
    return result;
  }



  void
  ElementMatrices::stress_stiffness(const ElasticTensor   &C,
                                    const Eigen::VectorXd &u,
                                    Eigen::MatrixXd       &S) const
  {
    const unsigned int n = fe.n_dofs_per_cell(), n_q = quadrature.size();
    Eigen::MatrixXd    gradient(n_q, 9); // du_i/dx_j as 3 i + j
    for (unsigned int i = 0; i < 3; ++i)
      {
        Eigen::VectorXd values_of_i(n);
        for (unsigned int a = 0; a < n; ++a)
          values_of_i[a] = u[dof_of[i][a]];
        for (unsigned int j = 0; j < 3; ++j)
          gradient.col(3 * i + j) = gradients[j] * values_of_i;
      }
    const Eigen::MatrixXd law =
      Eigen::Map<const Eigen::Matrix<double, 9, 9, Eigen::RowMajor>>(
        C[0].data());
    const Eigen::MatrixXd stress = gradient * law.transpose();
    Eigen::MatrixXd       scalar = Eigen::MatrixXd::Zero(n, n);
    for (unsigned int k = 0; k < 3; ++k)
      for (unsigned int l = 0; l < 3; ++l)
        scalar += gradients[k].transpose() *
                  stress.col(3 * k + l).asDiagonal() * weighted[l];
    spread(.5 * (scalar + scalar.transpose()), S);
  }



  void
  ElementMatrices::turning_axes(Eigen::MatrixXd &G, Eigen::MatrixXd &N) const
  {
    const unsigned int n = fe.n_dofs_per_cell();
    G.setZero(3 * n, 3 * n);
    N.setZero(3 * n, 3 * n);
    for (unsigned int b = 0; b < n; ++b)
      for (unsigned int a = 0; a < n; ++a)
        {
          const double m                = scalar_mass(a, b);
          G(dof_of[0][a], dof_of[1][b]) = -m;
          G(dof_of[1][a], dof_of[0][b]) = m;
          for (unsigned int i = 0; i < 2; ++i)
            N(dof_of[i][a], dof_of[i][b]) = m;
        }
  }
} // namespace squeal
