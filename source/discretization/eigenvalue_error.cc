// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/discretization/eigenvalue_error.h>
#include <squeal/discretization/element_matrices.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/qprojector.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping.h>

#include <Eigen/Dense>

#include <algorithm>
#include <map>

#include <cstdlib>
namespace squeal
{
  namespace
  {
    using Cell       = Discretization::CellIterator;
    using Descriptor = dealii::QProjector<3>::DataSetDescriptor;
    /** Nine components [3 i + j] at points (rows) for the modes (columns). */
    using TensorField = std::array<Eigen::MatrixXd, 9>;

    /**
     * The polynomials of degree p + 1 on the unit cell that vanish at the
     * nodes of degree p: products of three factors of which each is a Lagrange
     * polynomial of degree p or the bubble of degree p + 1 that vanishes at
     * its nodes, one of them at least the bubble.
     */
    class EnrichmentSpace
    {
    public:
      EnrichmentSpace(const unsigned int degree)
        : p(degree)
      {
        auto nodes = dealii::QGaussLobatto<1>(p + 1).get_points();
        factors = dealii::Polynomials::generate_complete_Lagrange_basis(nodes);
        nodes.push_back(0.5 * (nodes[p / 2] + nodes[p / 2 + 1]));
        factors.emplace_back(nodes, p + 1);
        for (unsigned int k = 0; k <= p + 1; ++k)
          for (unsigned int j = 0; j <= p + 1; ++j)
            for (unsigned int i = 0; i <= p + 1; ++i)
              if (i == p + 1 || j == p + 1 || k == p + 1)
                index.push_back({{i, j, k}});
      }

      unsigned int
      size() const
      {
        return index.size();
      }

      /** Values at points (rows) of the functions (columns), or derivatives
       * along the unit direction @p derivative. */
      Eigen::MatrixXd
      evaluate(const std::vector<dealii::Point<3>> &points,
               const int                            derivative = -1) const
      {
        Eigen::MatrixXd     result(points.size(), size());
        Eigen::MatrixXd     factor(p + 2, 3);
        std::vector<double> values(2);
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            for (unsigned int d = 0; d < 3; ++d)
              for (unsigned int i = 0; i <= p + 1; ++i)
                {
                  factors[i].value(points[q][d], values);
                  factor(i, d) = values[int(d) == derivative ? 1 : 0];
                }
            for (unsigned int a = 0; a < size(); ++a)
              result(q, a) = factor(index[a][0], 0) * factor(index[a][1], 1) *
                             factor(index[a][2], 2);
          }
        return result;
      }

      /** Whether function @p a is zero on face @p face of the unit cell. */
      bool
      vanishes_on(const unsigned int a, const unsigned int face) const
      {
        return index[a][face / 2] != (face % 2 == 0 ? 0 : p);
      }

    private:
      unsigned int                                    p;
      std::vector<dealii::Polynomials::Polynomial<double>> factors;
      std::vector<std::array<unsigned int, 3>>        index;
    };



    struct Law
    {
      ElasticTensor C;
      double        density, modulus;
    };

    void
    apply(const ElasticTensor &C, const TensorField &strain, TensorField &stress)
    {
      for (unsigned int i = 0; i < 9; ++i)
        {
          stress[i].setZero(strain[0].rows(), strain[0].cols());
          for (unsigned int j = 0; j < 9; ++j)
            if (C[i][j] != 0.)
              stress[i] += C[i][j] * strain[j];
        }
    }



    class Estimator
    {
    public:
      Estimator(const Discretization  &discretization,
                const Block           &modes,
                const Eigen::VectorXd &omega_squared)
        : d(discretization)
        , lambda(omega_squared)
        , fe(d.degree())
        , space(d.degree())
        , quadrature(d.degree() + 2)
        , face_quadrature(d.degree() + 2)
        , volume(d.mapping(),
                 fe,
                 quadrature,
                 dealii::update_values | dealii::update_gradients |
                   dealii::update_JxW_values |
                   dealii::update_inverse_jacobians)
        , own_face(d.mapping(), fe, face_quadrature, face_flags())
        , own_subface(d.mapping(), fe, face_quadrature, face_flags())
        , other_face(d.mapping(), fe, face_quadrature, dealii::update_gradients)
        , other_subface(d.mapping(),
                        fe,
                        face_quadrature,
                        dealii::update_gradients)
      {
        for (const auto &body : d.scene().bodies)
          laws.push_back(law(body));
        const auto &system = d.dof_handler().get_fe();
        for (auto &list : dof_of)
          list.resize(fe.n_dofs_per_cell());
        for (unsigned int i = 0; i < system.n_dofs_per_cell(); ++i)
          {
            const auto [c, a] = system.system_to_component_index(i);
            dof_of[c][a]      = i;
          }
        {
          const unsigned int n = fe.n_dofs_per_cell();
          dealii::FullMatrix<double> back(n, n);
          dealii::FETools::get_back_interpolation_matrix(fe, dealii::FE_Q<3>(d.degree()-1), back);
          detail = Eigen::MatrixXd::Identity(n, n);
          for (unsigned int i=0;i<n;++i) for (unsigned int j=0;j<n;++j) detail(i,j)-=back(i,j);
        }
        values = space.evaluate(quadrature.get_points());
        for (unsigned int k = 0; k < 3; ++k)
          derivatives[k] = space.evaluate(quadrature.get_points(), k);
        const Eigen::MatrixXd local = d.space()->gather(modes);
        nodal.resize(d.relevant_dofs().n_elements(), modes.cols());
        for (int j = 0; j < modes.cols(); ++j)
          {
            const auto column = d.expand(local.col(j));
            nodal.col(j) =
              Eigen::Map<const Eigen::VectorXd>(column.data(), column.size());
          }
      }

      /** Estimated part of omega_h^2 - omega^2 of each mode in one cell. */
      Eigen::VectorXd
      cell_errors(const Cell &cell)
      {
        const Law &law = laws[cell->material_id()];
        assemble_volume(cell, law);
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f))
            hold(cell, f);
          else
            add_interior_face(cell, f, law);
        const Eigen::LLT<Eigen::MatrixXd> factor(stiffness);
        Eigen::VectorXd next = factor.matrixL().solve(residual).colwise().squaredNorm();
        static const bool raw = getenv("RAW");
        if (raw) return next;
        for (int j=0;j<next.size();++j) next[j] *= remainder(next[j] / last[j]);
        return next;
      }

    private:
      double remainder(const double ratio) const
      {
        static const double smin = getenv("SMIN") ? atof(getenv("SMIN")) : 3;
        const unsigned int p = d.degree();
        const double s = std::max(smin, -std::log(ratio) / std::log((p + 1.) / p));
        double sum=0;
        if (!(s<40)) return 1;
        const int K=p+20;
        for (int k=p+1;k<K;++k) sum+=std::pow(k/(p+1.),-s);
        sum += std::pow((K-.5)/(p+1.), -s)*(K-.5)/(s-1);
        return sum;
      }
      Eigen::VectorXd last; Eigen::MatrixXd detail;
      static dealii::UpdateFlags
      face_flags()
      {
        return dealii::update_gradients | dealii::update_JxW_values |
               dealii::update_normal_vectors;
      }

      static Law
      law(const BodyParameters &body)
      {
        Law result{elastic_tensor(body), body.density, 0.};
        if (body.shape != BodyParameters::Shape::rigid &&
            body.material_model == BodyParameters::MaterialModel::isotropic)
          for (auto &row : result.C)
            for (double &c : row)
              c *= body.young_modulus;
        for (unsigned int i = 0; i < 9; ++i)
          result.modulus = std::max(result.modulus, result.C[i][i]);
        return result;
      }

      std::array<Eigen::MatrixXd, 3>
      cell_values(const Cell &cell) const
      {
        std::vector<dealii::types::global_dof_index> dofs(
          3 * fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        std::array<Eigen::MatrixXd, 3> result;
        for (unsigned int c = 0; c < 3; ++c)
          {
            result[c].resize(fe.n_dofs_per_cell(), nodal.cols());
            for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
              result[c].row(a) = nodal.row(
                d.relevant_dofs().index_within_set(dofs[dof_of[c][a]]));
          }
        return result;
      }

      /** Stresses of the modes at the points of @p points in @p cell. */
      void
      stresses(const dealii::FEValuesBase<3>        &points,
               const std::array<Eigen::MatrixXd, 3> &u,
               const Law                            &law,
               TensorField                          &stress, TensorField *out=nullptr) const
      {
        TensorField     strain;
        Eigen::MatrixXd gradient(points.n_quadrature_points,
                                 fe.n_dofs_per_cell());
        for (unsigned int k = 0; k < 3; ++k)
          {
            for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
              for (unsigned int q = 0; q < points.n_quadrature_points; ++q)
                gradient(q, a) = points.shape_grad(a, q)[k];
            for (unsigned int c = 0; c < 3; ++c)
              strain[3 * c + k].noalias() = gradient * u[c];
          }
        apply(law.C, strain, stress);
        if (out) *out=strain;
      }

      void
      assemble_volume(const Cell &cell, const Law &law)
      {
        volume.reinit(static_cast<
                      const dealii::Triangulation<3>::active_cell_iterator &>(
          cell));
        const unsigned int n_q = quadrature.size(), n = space.size();
        u = cell_values(cell);
        TensorField stress;
        Eigen::VectorXd weights(n_q);
        for (unsigned int q = 0; q < n_q; ++q)
          weights[q] = volume.JxW(q);
        {
          TensorField strain;
          std::array<Eigen::MatrixXd, 3> w;
          for (unsigned int c=0;c<3;++c) w[c] = detail*u[c];
          stresses(volume, w, law, stress, &strain);
          last.setZero(nodal.cols());
          for (unsigned int i=0;i<9;++i)
            last += (weights.asDiagonal()*stress[i]).cwiseProduct(strain[i]).colwise().sum();
        }
        stresses(volume, u, law, stress);
        std::array<Eigen::MatrixXd, 3> gradients, weighted;
        for (unsigned int k = 0; k < 3; ++k)
          {
            gradients[k].setZero(n_q, n);
            for (unsigned int l = 0; l < 3; ++l)
              {
                Eigen::VectorXd scale(n_q);
                for (unsigned int q = 0; q < n_q; ++q)
                  scale[q] = volume.inverse_jacobian(q)[l][k];
                gradients[k] += scale.asDiagonal() * derivatives[l];
              }
            weighted[k] = weights.asDiagonal() * gradients[k];
          }
        std::array<std::array<Eigen::MatrixXd, 3>, 3> H;
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = k; l < 3; ++l)
            {
              H[k][l].noalias() = gradients[k].transpose() * weighted[l];
              if (l > k)
                H[l][k] = H[k][l].transpose();
            }
        stiffness.setZero(3 * n, 3 * n);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            for (unsigned int k = 0; k < 3; ++k)
              for (unsigned int l = 0; l < 3; ++l)
                if (const double c = law.C[3 * i + k][3 * j + l]; c != 0.)
                  stiffness.block(i * n, j * n, n, n) += c * H[k][l];

        Eigen::MatrixXd displacement_values(n_q, fe.n_dofs_per_cell());
        for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
          for (unsigned int q = 0; q < n_q; ++q)
            displacement_values(q, a) = volume.shape_value(a, q);
        residual.resize(3 * n, nodal.cols());
        for (unsigned int i = 0; i < 3; ++i)
          {
            residual.middleRows(i * n, n).noalias() =
              values.transpose() * (weights.asDiagonal() *
              (displacement_values * u[i]) * (law.density * lambda).asDiagonal());
            for (unsigned int k = 0; k < 3; ++k)
              residual.middleRows(i * n, n).noalias() -=
                weighted[k].transpose() * stress[3 * i + k];
          }
      }

      /** Traces of the enrichment functions at the points of a face, subface
       * or (-1) the whole face. */
      const Eigen::MatrixXd &
      traces(const Cell &cell, const unsigned int f, const int subface)
      {
        const auto hexahedron = dealii::ReferenceCells::Hexahedron;
        const bool o = cell->face_orientation(f), flip = cell->face_flip(f),
                   rotation = cell->face_rotation(f);
        const unsigned int n = face_quadrature.size();
        const unsigned int offset =
          subface < 0 ?
            Descriptor::face(hexahedron, f, o, flip, rotation, n) :
            Descriptor::subface(hexahedron,
                                f,
                                subface,
                                o,
                                flip,
                                rotation,
                                n,
                                dealii::internal::SubfaceCase<3>::case_isotropic);
        auto &stored = face_traces[{subface >= 0, offset}];
        if (stored.size() == 0)
          {
            const auto all =
              subface < 0 ?
                dealii::QProjector<3>::project_to_all_faces(hexahedron,
                                                            face_quadrature) :
                dealii::QProjector<3>::project_to_all_subfaces(hexahedron,
                                                               face_quadrature);
            stored = space.evaluate(
              {all.get_points().begin() + offset,
               all.get_points().begin() + offset + n});
          }
        return stored;
      }

      void
      add_interior_face(const Cell        &cell,
                        const unsigned int f,
                        const Law         &law)
      {
        using TriaCell = const dealii::Triangulation<3>::active_cell_iterator &;
        const auto neighbour = cell->neighbor(f);
        if (neighbour->has_children())
          for (unsigned int s = 0; s < cell->face(f)->n_active_descendants();
               ++s)
            {
              const Cell child = cell->neighbor_child_on_subface(f, s);
              own_subface.reinit(static_cast<TriaCell>(cell), f, s);
              other_face.reinit(static_cast<TriaCell>(child),
                                cell->neighbor_of_neighbor(f));
              add_traction(
                own_subface, other_face, child, traces(cell, f, s), law);
            }
        else
          {
            const Cell other = neighbour;
            own_face.reinit(static_cast<TriaCell>(cell), f);
            if (cell->neighbor_is_coarser(f))
              {
                const auto [face, subface] = cell->neighbor_of_coarser_neighbor(f);
                other_subface.reinit(static_cast<TriaCell>(other),
                                     face,
                                     subface);
                add_traction(
                  own_face, other_subface, other, traces(cell, f, -1), law);
              }
            else
              {
                other_face.reinit(static_cast<TriaCell>(other),
                                  cell->neighbor_of_neighbor(f));
                add_traction(
                  own_face, other_face, other, traces(cell, f, -1), law);
              }
          }
      }

      /** Adds the traction that the neighbour and the cell agree on: the mean
       * of the two, weighted so that the correction takes the least energy. */
      void
      add_traction(const dealii::FEValuesBase<3> &own,
                   const dealii::FEValuesBase<3> &other,
                   const Cell                    &neighbour,
                   const Eigen::MatrixXd         &trace,
                   const Law                     &law)
      {
        const Law  &other_law = laws[neighbour->material_id()];
        TensorField mine, theirs;
        stresses(own, u, law, mine);
        stresses(other, cell_values(neighbour), other_law, theirs);
        static const double hexp = getenv("HEXP") ? atof(getenv("HEXP")) : 0;
        const double hn=std::pow(2., -neighbour->level()*hexp), ho=std::pow(2.,-level*hexp);
        const double share = law.modulus / ho / (law.modulus / ho + other_law.modulus / hn);
        for (unsigned int i = 0; i < 3; ++i)
          {
            Eigen::MatrixXd traction =
              Eigen::MatrixXd::Zero(face_quadrature.size(), nodal.cols());
            for (unsigned int k = 0; k < 3; ++k)
              {
                Eigen::VectorXd area(face_quadrature.size());
                for (unsigned int q = 0; q < face_quadrature.size(); ++q)
                  area[q] = own.JxW(q) * own.normal_vector(q)[k];
                traction += area.asDiagonal() *
                            ((1. - share) * mine[3 * i + k] +
                             share * theirs[3 * i + k]);
              }
            residual.middleRows(i * space.size(), space.size()).noalias() +=
              trace.transpose() * traction;
          }
      }

      /** Removes the functions that a support holds. */
      void
      hold(const Cell &cell, const unsigned int f)
      {
        std::vector<dealii::types::global_dof_index> dofs(
          3 * fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int c = 0; c < 3; ++c)
          {
            bool               held  = true;
            const Combination *first = nullptr;
            for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
              if (fe.has_support_on_face(a, f))
                {
                  const Combination &e = d.expansion(dofs[dof_of[c][a]]);
                  if (first == nullptr)
                    first = &e;
                  held = held && e == *first;
                }
            if (held)
              for (unsigned int a = 0; a < space.size(); ++a)
                if (!space.vanishes_on(a, f))
                  {
                    const unsigned int row = c * space.size() + a;
                    stiffness.row(row).setZero();
                    stiffness.col(row).setZero();
                    stiffness(row, row) = laws[0].modulus;
                    residual.row(row).setZero();
                  }
          }
      }
    public:
      int level=0;
    private:
      const Discretization          &d;
      const Eigen::VectorXd         &lambda;
      dealii::FE_Q<3>                fe;
      EnrichmentSpace                space;
      dealii::QGauss<3>              quadrature;
      dealii::QGauss<2>              face_quadrature;
      dealii::FEValues<3>            volume;
      dealii::FEFaceValues<3>        own_face;
      dealii::FESubfaceValues<3>     own_subface;
      dealii::FEFaceValues<3>        other_face;
      dealii::FESubfaceValues<3>     other_subface;
      std::vector<Law>               laws;
      std::array<std::vector<unsigned int>, 3>                   dof_of;
      std::map<std::pair<bool, unsigned int>, Eigen::MatrixXd>   face_traces;
      Eigen::MatrixXd                nodal, values, stiffness, residual;
      std::array<Eigen::MatrixXd, 3> derivatives, u;
    };
  } // namespace



  ModeErrors
  estimate_mode_errors(const Discretization  &discretization,
                       const Block           &modes,
                       const Eigen::VectorXd &omega_squared,
                       const std::vector<PointForces> &)
  {
    ModeErrors result;
    result.mode = Eigen::VectorXd::Zero(modes.cols());
    if (!discretization.has_mesh())
      return result;
    result.cell.assign(discretization.triangulation().n_active_cells(), 0.);
    Estimator estimator(discretization, modes, omega_squared);
    for (const auto &cell : discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          estimator.level = cell->level();
          const Eigen::VectorXd errors =
            estimator.cell_errors(cell).cwiseQuotient(omega_squared);
          result.cell[cell->active_cell_index()] = errors.sum();
          result.mode += errors;
        }
    Eigen::MatrixXd sum = result.mode;
    discretization.space()->sum(sum);
    result.mode = sum;
    return result;
  }
} // namespace squeal
