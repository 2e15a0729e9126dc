// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/contact/contact_resultant.h>
#include <squeal/contact/pressure_moments.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace squeal
{
  namespace
  {
    /** A point looks along the mean normal of its face if no further off than
     * this: rounded coordinates in mesh files. */
    constexpr double flat_within = 1e-3;

    /** A face narrower than this part of its distance from the origin has no
     * width but for rounding. */
    constexpr double least_width = 1e-9;

    /** Nor has one along a line, whose width is this part of its length. */
    constexpr double least_slenderness = 1e-6;

    /** Mean squares of the components of the normals over the face. */
    std::array<double, 3>
    mean_squares_of_normals(const ContactGeometry &g)
    {
      std::array<double, 3> squares{};
      double                area = 0.;
      for (std::size_t j = 0; j < g.points.size(); ++j)
        {
          area += g.areas[j];
          for (unsigned int c = 0; c < 3; ++c)
            squares[c] += g.areas[j] * std::pow(g.frames[j].normal[c], 2);
        }
      for (double &square : squares)
        square /= area;
      return squares;
    }

    /** 1 over the root of @p squares, symmetric; 0 along directions in which
     * they are no larger than @p least. */
    Eigen::Matrix2d
    inverse_root(const Eigen::Matrix2d &squares, const double least)
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> of(squares);
      Eigen::Vector2d                                      factors;
      for (unsigned int k = 0; k < 2; ++k)
        factors[k] = of.eigenvalues()[k] > least
                       ? 1. / std::sqrt(of.eigenvalues()[k])
                       : 0.;
      return of.eigenvectors() * factors.asDiagonal() *
             of.eigenvectors().transpose();
    }

    /** Takes the mean over the face from both columns of @p values, and returns
     * the combinations of them, a column each, that have the mean square 1 and
     * whose product has the mean 0: of all the ones nearest to the columns. */
    Eigen::Matrix2d
    normalise(const ContactGeometry &g, Eigen::MatrixX2d &values)
    {
      const Eigen::Map<const Eigen::VectorXd> areas(g.areas.data(),
                                                    g.areas.size());
      const double          size = values.cwiseAbs().maxCoeff();
      const Eigen::Vector2d mean = values.transpose() * areas / areas.sum();
      values.rowwise() -= mean.transpose();
      const Eigen::Matrix2d squares =
        values.transpose() * areas.asDiagonal() * values / areas.sum();
      const double least =
        std::max(std::pow(least_width * size, 2),
                 std::pow(least_slenderness, 2) * squares.trace());
      return inverse_root(squares, least);
    }

    /** The axis of the scene that is neither @p a nor @p b. */
    unsigned int
    third_axis(const unsigned int a, const unsigned int b)
    {
      return 3 - a - b;
    }
  } // namespace



  bool
  is_flat(const ContactGeometry &g)
  {
    const dealii::Tensor<1, 3> mean = mean_frame(g).normal;
    for (const ContactFrame &frame : g.frames)
      if ((frame.normal - mean).norm() > flat_within)
        return false;
    return true;
  }



  std::string
  PressureMoments::name_of(const std::array<double, 2> &parts) const
  {
    const Eigen::Vector2d axis = axes * Eigen::Vector2d(parts[0], parts[1]);
    // An axis has no sense: from -90 to 90 degrees.
    double angle = std::atan2(axis[1], axis[0]) * 180. / M_PI;
    if (std::abs(angle) > 90.)
      angle -= std::copysign(180., angle);
    if (!(std::abs(angle) >= .5))
      return names[0];
    if (std::abs(angle) > 89.5)
      return names[1];
    const std::string &name = names[0];
    return name.substr(0, name.size() - 1) + "an axis " +
           rounded_text(angle, 2) + " deg from " + name.back() + " towards " +
           names[1].back();
  }



  PressureMoments
  pressure_moments(const ContactGeometry &g)
  {
    const bool         has_side = looks_to_one_side(g);
    const auto         squares  = mean_squares_of_normals(g);
    const auto        *choice   = has_side
                                    ? std::max_element(squares.begin(), squares.end())
                                    : std::min_element(squares.begin(), squares.end());
    const unsigned int left_out = choice - squares.begin(),
                       first    = left_out == 0 ? 1 : 0,
                       other    = third_axis(left_out, first);
    PressureMoments result;
    result.rows = Eigen::MatrixXd::Zero(2, 3 * g.points.size());
    // A distance along one axis is an arm about the other, forwards about the
    // first and backwards about the second or the other way round.
    Eigen::MatrixX2d values(g.points.size(), 2);
    for (std::size_t j = 0; j < g.points.size(); ++j)
      for (const auto &[column, about, along] :
           {std::make_tuple(0, first, other), std::make_tuple(1, other, first)})
        values(j, column) =
          has_side ? g.points[j][along] : g.frames[j].normal[about];
    const Eigen::Matrix2d parts   = normalise(g, values);
    const Eigen::MatrixXd weights = (values * parts).transpose();
    for (std::size_t j = 0; j < g.points.size(); ++j)
      result.rows.col(3 * j) = weights.col(j);
    result.axes = Eigen::Vector2d(1., has_side ? -1. : 1.).asDiagonal() * parts;
    for (const auto &[row, about] :
         {std::make_pair(0, first), std::make_pair(1, other)})
      result.names[row] =
        std::string(has_side ? "moment of the normal forces about "
                             : "resultant of the normal forces along ") +
        "xyz"[about];
    return result;
  }
} // namespace squeal
