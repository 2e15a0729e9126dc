// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/unknown_choice.h>
#include <squeal/eigen/mode_naming_choice.h>
#include <squeal/eigen/mode_naming_disc.h>
#include <squeal/eigen/mode_naming_profile.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

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

    using Rows = std::vector<std::array<Functionals::Row, 3>>;

    /** Displacements of the points; those on the curved boundary may lie
     * outside the cells of a coarse mesh of low degree. @p is_whole: whether
     * the body is there at all of them. */
    Rows
    displacement_rows(const PointEvaluator                &evaluator,
                      const unsigned int                   body,
                      const std::vector<dealii::Point<3>> &points,
                      bool                                &is_whole)
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
      is_whole = true;
      if (!missing.empty())
        {
          auto outside = evaluator.displacements(body, again, 0.3);
          for (unsigned int p = 0; p < missing.size(); ++p)
            {
              result.rows[missing[p]] = outside.rows[p];
              is_whole                = is_whole && outside.found[p];
            }
        }
      return result.rows;
    }

    /** Component of a displacement along a unit vector. */
    Functionals::Row
    along(const std::array<Functionals::Row, 3> &xyz,
          const dealii::Tensor<1, 3>            &direction)
    {
      std::vector<std::pair<double, const Functionals::Row *>> parts;
      for (unsigned int c = 0; c < 3; ++c)
        if (direction[c] != 0.)
          parts.emplace_back(direction[c], &xyz[c]);
      return combine(parts);
    }

    Rows
    mean_of(const Rows &one, const Rows &other)
    {
      Rows result(one.size());
      for (std::size_t p = 0; p < one.size(); ++p)
        for (unsigned int c = 0; c < 3; ++c)
          result[p][c] = combine({{0.5, &one[p][c]}, {0.5, &other[p][c]}});
      return result;
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
    switch (family)
      {
      case DiscShape::Family::bending:
        return "bending";
      case DiscShape::Family::tangential:
        return "tangential";
      case DiscShape::Family::radial:
        return "radial";
      }
    unknown_choice("family");
  }



  DiscShapes::DiscShapes(const DiscRing                &ring,
                         const double                   density,
                         const PointEvaluator          &evaluator,
                         const unsigned int             body,
                         const double                   reference_angle,
                         std::vector<Functionals::Row> &rows)
    : fourier(fourier_matrix())
  {
    const double            width     = ring.outer_radius - ring.inner_radius;
    const double            thickness = std::abs(ring.face - ring.other_side);
    const dealii::QGauss<1> gauss(n_rings);
    std::vector<dealii::Point<3>> on_face, inside, beyond;
    std::vector<double>           angles;
    for (unsigned int k = 0; k < n_rings; ++k)
      {
        const double r = ring.inner_radius + width * gauss.point(k)[0];
        ring_masses.push_back(2. * M_PI * r * width * gauss.weight(k) *
                              thickness * density);
        for (unsigned int j = 0; j < n_angles; ++j)
          {
            angles.push_back(reference_angle + 2. * M_PI * j / n_angles);
            const double angle = angles.back();
            on_face.push_back(ring.point(r, angle, ring.face));
            inside.push_back(
              ring.point(r, angle, 0.5 * (ring.face + ring.other_side)));
            beyond.push_back(ring.point(r, angle, ring.other_side));
          }
      }

    bool       is_whole = true;
    const Rows face     = displacement_rows(evaluator, body, on_face, is_whole);
    Rows       xyz      = displacement_rows(evaluator, body, inside, is_whole);
    if (!is_whole)
      {
        const Rows other = displacement_rows(evaluator, body, beyond, is_whole);
        xyz              = is_whole ? mean_of(face, other) : face;
      }
    for (unsigned int k = 0; k < n_rings; ++k)
      for (unsigned int c = 0; c < n_components; ++c)
        for (unsigned int p = k * n_angles; p < (k + 1) * n_angles; ++p)
          rows.push_back(c == 0   ? along(face[p], ring.directions[2])
                         : c == 1 ? along(xyz[p], ring.tangential(angles[p]))
                                  : along(xyz[p], ring.radial(angles[p])));
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



  Eigen::VectorXcd
  DiscShapes::profile(const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
                      const unsigned int                        component,
                      const unsigned int                        m,
                      const bool                                sine) const
  {
    Eigen::VectorXcd result(n_rings);
    for (unsigned int k = 0; k < n_rings; ++k)
      result[k] = coordinates[first(k, component) + coefficient(m, sine)];
    return result;
  }

  std::vector<unsigned int>
  DiscShapes::numbers_of_circles(const Eigen::VectorXcd &profile) const
  {
    Eigen::VectorXd real = most_real_part(profile);
    for (unsigned int k = 0; k < n_rings; ++k)
      real[k] /= std::sqrt(ring_masses[k]);
    return naming::numbers_of_nodes(real);
  }



  DiscShapes::HeldContent
  DiscShapes::held_content(
    const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
    const unsigned int                        m,
    const bool                                sine) const
  {
    // The largest |cos(f) p_m - sin(f) p_(m+1)|^2 = mean + difference cos(2 f)
    // - product sin(2 f) over 0 <= f <= 45 degrees.
    const Eigen::VectorXcd p       = profile(coordinates, 0, m, sine);
    const Eigen::VectorXcd next    = profile(coordinates, 0, m + 1, sine);
    const double           product = p.dot(next).real();
    const double           mean = 0.5 * (p.squaredNorm() + next.squaredNorm());
    const double difference     = 0.5 * (p.squaredNorm() - next.squaredNorm());
    const double best           = std::atan2(-product, difference);
    const double twice          = best >= 0. && best <= 0.5 * M_PI      ? best
                                  : mean + difference >= mean - product ? 0.
                                                                        : 0.5 * M_PI;
    HeldContent  result;
    result.content =
      mean + difference * std::cos(twice) - product * std::sin(twice);
    result.profile = std::cos(0.5 * twice) * p - std::sin(0.5 * twice) * next;
    return result;
  }



  void
  DiscShapes::add_bending(const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
                          std::vector<DiscShape> &shapes) const
  {
    std::vector<DiscShape>   candidates;
    std::vector<double>      contents;
    std::vector<HeldContent> held;
    for (unsigned int m = 0; m < n_harmonics; ++m)
      for (const bool sine : {false, true})
        if (m > 0 || !sine)
          {
            DiscShape shape;
            shape.nodal_diameters = m;
            shape.parity          = m == 0 ? "" : sine ? "-" : "+";
            candidates.push_back(shape);
            held.push_back(held_content(coordinates, m, sine));
            contents.push_back(held.back().content);
          }
    std::vector<unsigned int> chosen =
      naming::near_largest(contents, naming::content_margin);
    for (const unsigned int i :
         naming::near_largest(contents, naming::parity_margin))
      if (candidates[i].nodal_diameters ==
            candidates[chosen.front()].nodal_diameters &&
          std::find(chosen.begin(), chosen.end(), i) == chosen.end())
        chosen.push_back(i);
    std::sort(chosen.begin(), chosen.end());
    for (const unsigned int i : chosen)
      for (const unsigned int n : numbers_of_circles(held[i].profile))
        {
          shapes.push_back(candidates[i]);
          shapes.back().nodal_circles = n;
        }
  }



  void
  DiscShapes::add_in_plane(
    const Eigen::Ref<const Eigen::VectorXcd> &coordinates,
    std::vector<DiscShape>                   &shapes) const
  {
    const std::array<Eigen::MatrixX2d, 2> parts = {
      {energies(coordinates, 1), energies(coordinates, 2)}};
    const Eigen::VectorXd all = (parts[0] + parts[1]).rowwise().sum();
    for (const unsigned int m : naming::near_largest(
           {all.data(), all.data() + all.size()}, naming::content_margin))
      for (const unsigned int radial :
           naming::near_largest({parts[0].row(m).sum() / (1. - radial_share),
                                 parts[1].row(m).sum() / radial_share},
                                naming::family_margin))
        for (const unsigned int sine :
             naming::near_largest({parts[radial](m, 0), parts[radial](m, 1)},
                                  naming::parity_margin))
          for (const unsigned int n :
               numbers_of_circles(profile(coordinates, 1 + radial, m, sine)))
            {
              DiscShape shape;
              shape.family          = radial ? DiscShape::Family::radial
                                             : DiscShape::Family::tangential;
              shape.nodal_circles   = n;
              shape.nodal_diameters = m;
              shape.parity          = m == 0 ? "" : sine ? "-" : "+";
              shapes.push_back(shape);
            }
  }



  std::vector<DiscShape>
  DiscShapes::classify(
    const Eigen::Ref<const Eigen::VectorXcd> &coordinates) const
  {
    std::vector<DiscShape> shapes;
    for (const unsigned int family : naming::near_largest(
           {energies(coordinates, 0).sum(),
            energies(coordinates, 1).sum() + energies(coordinates, 2).sum()},
           naming::family_margin))
      if (family == 0)
        add_bending(coordinates, shapes);
      else
        add_in_plane(coordinates, shapes);
    return shapes;
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
