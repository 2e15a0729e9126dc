// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_measured_points_h
#define squeal_model_measured_points_h

#include <squeal/eigen/complex_pairs.h>
#include <squeal/model/model.h>
#include <squeal/results/measured_shapes.h>

namespace squeal
{
  /**
   * The points of section Measurement on a model: each is a displacement along
   * its (unit) direction.
   */
  class MeasuredPoints
  {
  public:
    /** Throws InputError for a point that lies outside its body or, with
     * imported matrices, at no node of it. */
    explicit MeasuredPoints(const Model &model);

    unsigned int size() const;

    /** Unit forces at all points, or at some of them by their places in the
     * list: rows of the system x points. Transposed it observes the motion. */
    const Block &vectors() const;
    Block        vectors(const std::vector<unsigned int> &places) const;

    /** Displacements at the points: points x shapes. */
    Eigen::MatrixXcd sample(const ComplexBlock &shapes) const;

    /** MAC of every measured shape with every sampled one. Throws InputError
     * naming a measured shape that has less than two points in common with the
     * list, or is zero at all of them. */
    Eigen::MatrixXd mac(const std::vector<MeasuredShape> &measured,
                        const Eigen::MatrixXcd           &sampled) const;

    /**
     * Coordinate MAC of every point: how well all measured shapes, each with
     * the sampled one of largest @p mac and both of unit length over their
     * common points, agree there. (sum |a b|)^2 / (sum |a|^2 sum |b|^2) over
     * the shapes; NaN at points that none of them has.
     */
    Eigen::VectorXd comac(const std::vector<MeasuredShape> &measured,
                          const Eigen::MatrixXcd           &sampled,
                          const Eigen::MatrixXd            &mac) const;

  private:
    /** Values of a shape and the points they belong to. */
    struct Values
    {
      std::vector<std::complex<double>> values;
      std::vector<unsigned int>         places;
    };
    Values measured_values(const MeasuredShape &shape) const;

    /** The measured value at a point; false where it was not measured. */
    bool measured_value(const MeasuredShape  &shape,
                        const unsigned int    point,
                        std::complex<double> &value) const;

    const Model &model;
    Block        all;
  };
} // namespace squeal

#endif
