// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/contact_resultant.h>
#include <squeal/contact/pressure_moments.h>

#include <algorithm>
#include <cmath>
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

    /** The values of all points less their mean over the face, over the root of
     * the mean square of what is left; 0 where that is rounding. */
    Eigen::VectorXd
    normalised(const ContactGeometry &g, Eigen::VectorXd values)
    {
      const Eigen::Map<const Eigen::VectorXd> areas(g.areas.data(),
                                                    g.areas.size());
      const double size = values.cwiseAbs().maxCoeff();
      values.array() -= areas.dot(values) / areas.sum();
      const double width =
        std::sqrt(areas.dot(values.cwiseAbs2()) / areas.sum());
      values *= width > least_width * size ? 1. / width : 0.;
      return values;
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
    result.rows      = Eigen::MatrixXd::Zero(2, 3 * g.points.size());
    unsigned int row = 0;
    // A distance along one axis is an arm about the other.
    for (const auto &[about, along] :
         {std::make_pair(first, other), std::make_pair(other, first)})
      {
        Eigen::VectorXd values(g.points.size());
        for (std::size_t j = 0; j < g.points.size(); ++j)
          values[j] = has_side ? g.points[j][along] : g.frames[j].normal[about];
        const Eigen::VectorXd weights = normalised(g, values);
        for (std::size_t j = 0; j < g.points.size(); ++j)
          result.rows(row, 3 * j) = weights[j];
        result.names[row] =
          std::string(has_side ? "moment of the normal forces about "
                               : "resultant of the normal forces along ") +
          "xyz"[about];
        ++row;
      }
    return result;
  }
} // namespace squeal
