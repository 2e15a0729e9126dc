// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/surface_face.h>

#include <deal.II/fe/fe_q.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** Of lengths, relative to the face. */
    constexpr double round_off = 1e-12;
  } // namespace

  FaceBasis::FaceBasis(const unsigned int degree)
  {
    const dealii::FE_Q<1> line(degree);
    for (const auto &x : line.get_unit_support_points())
      coordinates.push_back(x[0]);
    std::sort(coordinates.begin(), coordinates.end());
  }

  unsigned int
  FaceBasis::degree() const
  {
    return coordinates.size() - 1;
  }

  unsigned int
  FaceBasis::n_nodes() const
  {
    return coordinates.size() * coordinates.size();
  }

  dealii::Point<2>
  FaceBasis::node(const unsigned int number) const
  {
    return {coordinates[number % coordinates.size()],
            coordinates[number / coordinates.size()]};
  }

  unsigned int
  FaceBasis::column(const double coordinate) const
  {
    unsigned int nearest = 0;
    for (unsigned int i = 1; i < coordinates.size(); ++i)
      if (std::abs(coordinates[i] - coordinate) <
          std::abs(coordinates[nearest] - coordinate))
        nearest = i;
    return nearest;
  }

  FaceBasis::Values
  FaceBasis::evaluate(const dealii::Point<2> &unit) const
  {
    // Products of (x - x_k) / (x_i - x_k), with derivatives.
    const unsigned int n = coordinates.size();
    Eigen::MatrixXd    one(n, 4);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < 2; ++c)
        {
          double value = 1., derivative = 0.;
          for (unsigned int k = 0; k < n; ++k)
            if (k != i)
              {
                const double span = coordinates[i] - coordinates[k];
                const double step = unit[c] - coordinates[k];
                derivative        = (derivative * step + value) / span;
                value *= step / span;
              }
          one(i, c)     = value;
          one(i, c + 2) = derivative;
        }
    Values result{Eigen::VectorXd(n * n),
                  Eigen::Matrix<double, -1, 2>(n * n, 2)};
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = 0; i < n; ++i)
        {
          result.value[i + n * j]       = one(i, 0) * one(j, 1);
          result.gradient(i + n * j, 0) = one(i, 2) * one(j, 1);
          result.gradient(i + n * j, 1) = one(i, 0) * one(j, 3);
        }
    return result;
  }



  dealii::Point<2>
  unit_corner(const unsigned int k)
  {
    return {k % 4 == 1 || k % 4 == 2 ? 1. : 0., k % 4 >= 2 ? 1. : 0.};
  }



  SurfaceFace::SurfaceFace(const FaceBasis                     &basis,
                           const std::vector<dealii::Point<3>> &nodes)
    : basis(&basis)
    , node_points(nodes)
    , size(0.)
    , off_plane(0.)
    , affine(true)
  {
    const Frame centre = frame({.5, .5});
    centre_normal      = centre.area_vector() / centre.area_vector().norm();
    for (unsigned int k = 0; k < 4; ++k)
      for (unsigned int l = 0; l < k; ++l)
        size =
          std::max(size, point(unit_corner(k)).distance(point(unit_corner(l))));
    for (const auto &x : node_points)
      off_plane = std::max(off_plane, std::abs((x - centre.x) * centre_normal));
    // The tangents of a parallelogram are the same everywhere.
    for (unsigned int j = 0; j <= basis.degree() + 1; ++j)
      for (unsigned int i = 0; i <= basis.degree() + 1; ++i)
        {
          const Frame f =
            frame({i / (basis.degree() + 1.), j / (basis.degree() + 1.)});
          for (unsigned int c = 0; c < 2; ++c)
            affine = affine && (f.tangent[c] - centre.tangent[c]).norm() <
                                 round_off * size * basis.degree();
        }
  }

  const std::vector<dealii::Point<3>> &
  SurfaceFace::nodes() const
  {
    return node_points;
  }

  dealii::Point<3>
  SurfaceFace::point(const dealii::Point<2> &unit) const
  {
    return frame(unit).x;
  }

  SurfaceFace::Frame
  SurfaceFace::frame(const dealii::Point<2> &unit) const
  {
    const auto values = basis->evaluate(unit);
    Frame      result;
    for (unsigned int a = 0; a < node_points.size(); ++a)
      {
        result.x += values.value[a] * node_points[a];
        for (unsigned int c = 0; c < 2; ++c)
          result.tangent[c] += values.gradient(a, c) * node_points[a];
      }
    return result;
  }

  dealii::Tensor<1, 3>
  SurfaceFace::Frame::area_vector() const
  {
    return dealii::cross_product_3d(tangent[0], tangent[1]);
  }

  const dealii::Tensor<1, 3> &
  SurfaceFace::normal() const
  {
    return centre_normal;
  }

  double
  SurfaceFace::diameter() const
  {
    return size;
  }

  double
  SurfaceFace::bulge() const
  {
    return off_plane;
  }

  bool
  SurfaceFace::is_affine() const
  {
    return affine;
  }

  bool
  SurfaceFace::has_straight_edge(const unsigned int k) const
  {
    const auto                 a = unit_corner(k), b = unit_corner(k + 1);
    const auto                 x   = point(a);
    const dealii::Tensor<1, 3> end = point(b) - x;
    for (unsigned int i = 1; i <= basis->degree(); ++i)
      {
        const dealii::Tensor<1, 3> arm =
          point(a + i / (basis->degree() + 1.) * (b - a)) - x;
        if (dealii::cross_product_3d(arm, end).norm() >
            round_off * size * end.norm())
          return false;
      }
    return true;
  }

  std::optional<SurfaceFace::Projection>
  SurfaceFace::project(const dealii::Point<3>     &x,
                       const dealii::Tensor<1, 3> &direction,
                       const dealii::Point<2>     &guess) const
  {
    Projection result{guess, 0.};
    // Newton's method converges quadratically: one more step after the first
    // small one leaves rounding errors only, and one step does where the face
    // is affine.
    bool last_step = affine;
    for (unsigned int step = 0; step < 30; ++step)
      {
        const Frame f = frame(result.unit);
        const auto  r = x - f.x;
        // r = change_0 tangent_0 + change_1 tangent_1 + distance direction
        const auto   across = dealii::cross_product_3d(f.tangent[1], direction);
        const double volume = f.tangent[0] * across;
        if (!(std::abs(volume) > 1e-9 * size * size))
          return {};
        const double change[2] = {
          r * across / volume,
          f.tangent[0] * dealii::cross_product_3d(r, direction) / volume};
        result.distance = r * f.area_vector() / volume;
        for (unsigned int c = 0; c < 2; ++c)
          result.unit[c] += change[c];
        if (last_step)
          return result;
        const double moved = std::abs(change[0]) + std::abs(change[1]);
        if (!(moved < 1e3))
          return {};
        last_step = moved < 1e-8;
      }
    return {};
  }
} // namespace squeal
