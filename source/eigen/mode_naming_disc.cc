// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/mode_naming_disc.h>
#include <squeal/eigen/mode_naming_profile.h>

#include <deal.II/base/quadrature_lib.h>

#include <Eigen/Eigenvalues>

namespace squeal
{
  namespace
  {
    constexpr unsigned int n_rings      = 10;
    constexpr unsigned int n_angles     = 72;
    constexpr unsigned int n_harmonics  = (n_angles - 1) / 2;
    constexpr unsigned int n_components = 3;
    /** Angles of a ring in the signature are every such one. */
    constexpr unsigned int signature_stride = 3;
    /** Lobes below this share of the largest one make no nodal circle. */
    constexpr double lobe_threshold = 0.1;
    /** The same round the circumference. A disc that is all but pinned by a
     * pad touches zero there without a change of sign. */
    constexpr double diameter_threshold = 0.05;
    /** Nodal diameters are counted as long as their harmonic has this share of
     * the energy of the largest one. */
    constexpr double counted_share = 0.02;
    /** An in-plane shape is called radial above this share of its energy. With
     * m = 1 a clamped disc's rim moves almost like a rigid ring, half of the
     * energy in either direction: the name must not hang on the mesh there. */
    constexpr double radial_share = 0.65;

    /** Row of the mean (m = 0, sine unused), cosine or sine of harmonic m. */
    unsigned int
    coefficient(const unsigned int m, const bool sine)
    {
      return m == 0 ? 0 : 2 * m - 1 + (sine ? 1 : 0);
    }

    /** Rows whose sum of squares is the mean square of a ring's samples. */
    Eigen::MatrixXd
    fourier_matrix()
    {
      Eigen::MatrixXd F(2 * n_harmonics + 1, n_angles);
      for (unsigned int j = 0; j < n_angles; ++j)
        {
          const double angle = 2. * M_PI * j / n_angles;
          F(0, j)            = 1. / n_angles;
          for (unsigned int m = 1; m <= n_harmonics; ++m)
            {
              const double scale          = std::sqrt(2.) / n_angles;
              F(coefficient(m, false), j) = scale * std::cos(m * angle);
              F(coefficient(m, true), j)  = scale * std::sin(m * angle);
            }
        }
      return F;
    }

    /** Displacements of the points; those on the curved boundary may lie
     * outside the cells of a coarse mesh of low degree. */
    std::vector<std::array<Functionals::Row, 3>>
    displacement_rows(const PointEvaluator                &evaluator,
                      const unsigned int                   body,
                      const std::vector<dealii::Point<3>> &points)
    {
      auto                      result = evaluator.displacements(body, points);
      std::vector<unsigned int> missing;
      std::vector<dealii::Point<3>> again;
      for (unsigned int p = 0; p < points.size(); ++p)
        if (!result.found[p])
          {
            missing.push_back(p);
            again.push_back(points[p]);
          }
      if (!missing.empty())
        {
          auto outside = evaluator.displacements(body, again, 0.3);
          for (unsigned int p = 0; p < missing.size(); ++p)
            result.rows[missing[p]] = outside.rows[p];
        }
      return result.rows;
    }
  } // namespace



  std::string
  DiscShape::text() const
  {
    const std::string prefix = family == Family::tangential ? "T"
                               : family == Family::radial   ? "R"
                                                            : "";
    return prefix + "(" + std::to_string(nodal_circles) + "," +
           std::to_string(nodal_diameters) + parity + ")";
  }

  std::string
  to_string(const DiscShape::Family family)
  {
    return family == DiscShape::Family::bending      ? "bending"
           : family == DiscShape::Family::tangential ? "tangential"
                                                     : "radial";
  }



  DiscShapes::DiscShapes(const Discretization          &discretization,
                         const PointEvaluator          &evaluator,
                         const unsigned int             body,
                         const double                   reference_angle,
                         std::vector<Functionals::Row> &rows)
    : fourier(fourier_matrix())
  {
    const auto  &disc  = discretization.scene().bodies[body];
    const auto   axis  = disc.position;
    const double width = disc.outer_radius - disc.inner_radius;

    const dealii::QGauss<1>       gauss(n_rings);
    std::vector<dealii::Point<3>> points;
    std::vector<double>           angles;
    for (unsigned int k = 0; k < n_rings; ++k)
      {
        const double r = disc.inner_radius + width * gauss.point(k)[0];
        ring_masses.push_back(2. * M_PI * r * width * gauss.weight(k) *
                              disc.height * disc.density);
        for (unsigned int j = 0; j < n_angles; ++j)
          {
            angles.push_back(reference_angle + 2. * M_PI * j / n_angles);
            points.emplace_back(axis[0] + r * std::cos(angles.back()),
                                axis[1] + r * std::sin(angles.back()),
                                axis[2] + 0.5 * disc.height);
          }
      }

    const auto xyz = displacement_rows(evaluator, body, points);
    for (unsigned int k = 0; k < n_rings; ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int p = k * n_angles; p < (k + 1) * n_angles; ++p)
          {
            const double cosine = std::cos(angles[p]);
            const double sine   = std::sin(angles[p]);
            const auto  &x = xyz[p][0], &y = xyz[p][1], &z = xyz[p][2];
            rows.push_back(c == 0   ? z
                           : c == 1 ? combine({{-sine, &x}, {cosine, &y}})
                                    : combine({{cosine, &x}, {sine, &y}}));
          }
  }



  unsigned int
  DiscShapes::n_samples() const
  {
    return n_rings * n_components * n_angles;
  }

  unsigned int
  DiscShapes::n_coordinates() const
  {
    return n_rings * n_components * fourier.rows();
  }

  unsigned int
  DiscShapes::first(const unsigned int ring, const unsigned int component) const
  {
    return (ring * n_components + component) * fourier.rows();
  }



  Eigen::MatrixXd
  DiscShapes::coordinates(
    const Eigen::Ref<const Eigen::MatrixXd> &samples) const
  {
    AssertDimension(samples.rows(), n_samples());
    Eigen::MatrixXd result(n_coordinates(), samples.cols());
    for (unsigned int k = 0; k < n_rings; ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        result.middleRows(first(k, c), fourier.rows()).noalias() =
          std::sqrt(ring_masses[k]) *
          (fourier *
           samples.middleRows((k * n_components + c) * n_angles, n_angles));
    return result;
  }



  Eigen::MatrixX2d
  DiscShapes::energies(const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
                       const unsigned int component) const
  {
    Eigen::MatrixX2d result = Eigen::MatrixX2d::Zero(n_harmonics + 1, 2);
    for (unsigned int k = 0; k < n_rings; ++k)
      {
        const unsigned int start = first(k, component);
        result(0, 0) += std::norm(coordinates[start]);
        for (unsigned int m = 1; m <= n_harmonics; ++m)
          for (const bool sine : {false, true})
            result(m, sine) +=
              std::norm(coordinates[start + coefficient(m, sine)]);
      }
    return result;
  }



  Eigen::VectorXd
  DiscShapes::profile(const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
                      const unsigned int                        component,
                      const unsigned int                        m) const
  {
    Eigen::MatrixX2cd parts(n_rings, 2);
    for (unsigned int k = 0; k < n_rings; ++k)
      for (const bool sine : {false, true})
        parts(k, sine) =
          coordinates[first(k, component) + coefficient(m, sine)];
    // The direction in the plane of cosine and sine that holds most: a doublet
    // turned by any angle, and a travelling wave, have one radial profile.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2cd> directions(
      parts.adjoint() * parts);
    Eigen::VectorXd result =
      most_real_part(parts * directions.eigenvectors().col(1));
    for (unsigned int k = 0; k < n_rings; ++k)
      result[k] /= std::sqrt(ring_masses[k]);
    return result;
  }



  unsigned int
  DiscShapes::n_diameters(const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
                          const unsigned int                        component,
                          const unsigned int dominant) const
  {
    // Weighting with the radial profile leaves out what other nodal circles
    // mix in.
    const Eigen::VectorXd radial = profile(coordinates, component, dominant);
    Eigen::VectorXcd      sum    = Eigen::VectorXcd::Zero(fourier.rows());
    for (unsigned int k = 0; k < n_rings; ++k)
      sum += std::sqrt(ring_masses[k]) * radial[k] *
             coordinates.segment(first(k, component), fourier.rows());
    const Eigen::VectorXcd round = fourier.transpose() * sum;
    return n_sign_changes(most_real_part(round), diameter_threshold, true) / 2;
  }



  DiscShape
  DiscShapes::classify(
    const Eigen::Ref<const Eigen::VectorXcd> &coordinates) const
  {
    const Eigen::MatrixX2d axial      = energies(coordinates, 0);
    const Eigen::MatrixX2d tangential = energies(coordinates, 1);
    const Eigen::MatrixX2d radial     = energies(coordinates, 2);
    const Eigen::MatrixX2d in_plane   = tangential + radial;

    DiscShape    shape;
    unsigned int component = 0;
    if (axial.sum() >= in_plane.sum())
      axial.rowwise().sum().maxCoeff(&shape.nodal_diameters);
    else
      {
        const double all =
          in_plane.rowwise().sum().maxCoeff(&shape.nodal_diameters);
        const bool is_radial =
          radial.row(shape.nodal_diameters).sum() > radial_share * all;
        component = is_radial ? 2 : 1;
        shape.family =
          is_radial ? DiscShape::Family::radial : DiscShape::Family::tangential;
      }
    const auto        &chosen   = component == 0   ? axial
                                  : component == 1 ? tangential
                                                   : radial;
    const unsigned int dominant = shape.nodal_diameters;
    shape.nodal_circles =
      n_sign_changes(profile(coordinates, component, dominant), lobe_threshold);
    const unsigned int counted = n_diameters(coordinates, component, dominant);
    if (chosen.row(counted).sum() >= counted_share * chosen.row(dominant).sum())
      shape.nodal_diameters = counted;
    const unsigned int m = shape.nodal_diameters;
    if (m > 0)
      shape.parity = chosen(m, 0) >= chosen(m, 1) ? "+" : "-";
    return shape;
  }



  Eigen::VectorXd
  DiscShapes::mirror_weights() const
  {
    Eigen::VectorXd result(n_coordinates());
    for (unsigned int k = 0; k < n_rings; ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int m = 0; m <= n_harmonics; ++m)
          for (const bool sine : {false, true})
            result[first(k, c) + coefficient(m, sine && m > 0)] =
              (m + 1.) * ((c == 1) == (sine && m > 0) ? 1. : -1.);
    return result;
  }



  std::vector<std::pair<unsigned int, double>>
  DiscShapes::signature() const
  {
    std::vector<std::pair<unsigned int, double>> result;
    for (unsigned int k = 0; k < n_rings; ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        // Every ring begins at another angle, so that harmonics that look
        // alike on one ring differ on the next.
        for (unsigned int j = k % signature_stride; j < n_angles;
             j += signature_stride)
          result.emplace_back(
            (k * n_components + c) * n_angles + j,
            std::sqrt(ring_masses[k] * signature_stride / n_angles));
    return result;
  }
} // namespace squeal
