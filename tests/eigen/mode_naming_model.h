// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_eigen_mode_naming_model_h
#define squeal_tests_eigen_mode_naming_model_h

#include <squeal/base/mumps.h>
#include <squeal/discretization/assembly.h>
#include <squeal/eigen/mode_naming.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <string>
#include <vector>

namespace squeal
{
  namespace testing
  {
    /** A scene with its matrices; extra springs are added by hand. */
    struct Model
    {
      explicit Model(const SceneParameters &s, const unsigned int degree)
        : scene(s)
        , discretization(scene, {}, degree, MPI_COMM_WORLD)
        , bodies(assemble_bodies(discretization))
        , namer(discretization)
      {
      }

      const RowSpace &
      space() const
      {
        return *discretization.space();
      }

      Block
      mass(const Block &X) const
      {
        Block Y = Block::Zero(X.rows(), X.cols());
        for (unsigned int b = 0; b < bodies.size(); ++b)
          Y += scene.bodies[b].density * bodies[b].mass->multiply(X);
        return Y;
      }

      Block
      stiffness(const Block &X) const
      {
        Block Y = Block::Zero(X.rows(), X.cols());
        for (unsigned int b = 0; b < bodies.size(); ++b)
          Y += scene.bodies[b].young_modulus * bodies[b].stiffness->multiply(X);
        for (const auto &spring : springs)
          Y += spring.multiply(X);
        return Y;
      }

      void
      add_springs(const std::vector<Functionals::Row> &rows, const double k)
      {
        auto B = std::make_shared<Functionals>(discretization.space(), rows);
        springs.emplace_back(B, Eigen::VectorXd::Constant(rows.size(), k), B);
      }

      /** Energy shares, bodies x columns, of (part of) a vector. */
      Eigen::MatrixXd
      energies(const Block &X) const
      {
        Eigen::MatrixXd E(bodies.size(), X.cols());
        for (unsigned int b = 0; b < bodies.size(); ++b)
          E.row(b) =
            scene.bodies[b].density *
            X.cwiseProduct(bodies[b].mass->multiply(X)).colwise().sum();
        space().sum(E);
        return E;
      }

      SceneParameters            scene;
      Discretization             discretization;
      std::vector<BodyMatrices>  bodies;
      ModeNamer                  namer;
      std::vector<LowRankMatrix> springs;
    };

    struct Modes
    {
      std::vector<double> frequencies; /**< Hz */
      Block               shapes;      /**< mass-orthonormal */
    };

    /** Modes up to a frequency by block Lanczos with full orthogonalisation. */
    inline Modes
    modes_of(const Model &model, const double highest)
    {
      constexpr int   size = 8, n_steps = 14;
      const double    shift = -std::pow(2. * M_PI * 1000., 2);
      const RowSpace &space = model.space();
      Triplets        entries;
      for (unsigned int b = 0; b < model.bodies.size(); ++b)
        {
          const auto &body = model.scene.bodies[b];
          model.bodies[b].stiffness->append_to(
            entries, body.young_modulus, true);
          model.bodies[b].mass->append_to(entries, -shift * body.density, true);
        }
      for (const auto &spring : model.springs)
        spring.append_to(entries, 1., true);
      MumpsFactorization<double> factor(
        model.discretization.space(),
        MumpsFactorization<double>::Symmetry::symmetric);
      factor.factorize(entries.rows, entries.columns, entries.values);

      Block Q(space.n_owned(), size * n_steps);
      Block W = Block::Random(space.n_owned(), size);
      for (int k = 0; k < n_steps; ++k)
        {
          for (unsigned int repeat = 0; repeat < 2; ++repeat)
            {
              const Block V = Q.leftCols(k * size);
              W -= V * space.dot(V, model.mass(W));
              const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(
                space.dot(W, model.mass(W)));
              W = W * gram.eigenvectors() *
                  gram.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal();
            }
          Q.middleCols(k * size, size) = W;
          W                            = factor.solve(model.mass(W));
        }
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(
        space.dot(Q, model.stiffness(Q)));
      Modes modes;
      for (const double value : ritz.eigenvalues())
        if (value < std::pow(2. * M_PI * highest, 2))
          modes.frequencies.push_back(std::sqrt(std::max(0., value)) /
                                      (2. * M_PI));
      modes.shapes = Q * ritz.eigenvectors().leftCols(modes.frequencies.size());
      return modes;
    }

    inline BodyParameters
    disc(const std::array<unsigned int, 3> &cells)
    {
      BodyParameters b;
      b.name     = "disc";
      b.shape    = BodyParameters::Shape::annulus;
      b.position = {{0., 0., -0.01}};
      b.cells    = cells;
      return b;
    }

    inline BodyParameters
    block(const std::string                 &name,
          const Vector3                     &position,
          const Vector3                     &size,
          const std::array<unsigned int, 3> &cells)
    {
      BodyParameters b;
      b.name     = name;
      b.position = position;
      b.size     = size;
      b.cells    = cells;
      return b;
    }

    inline void
    clamp(SceneParameters   &scene,
          const std::string &body,
          const std::string &face)
    {
      SupportParameters support;
      support.name = body;
      support.body = body;
      support.face = face;
      scene.supports.push_back(support);
    }

    inline SceneParameters
    disc_scene(const std::array<unsigned int, 3> &cells)
    {
      SceneParameters scene;
      scene.bodies = {disc(cells)};
      clamp(scene, "disc", "inner");
      return scene;
    }
  } // namespace testing
} // namespace squeal

#endif
