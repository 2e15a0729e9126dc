// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/turning.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    /** A vector that turns with the body, at its `Angle`. */
    dealii::Tensor<1, 3>
    turned_vector(const BodyParameters &body, const dealii::Tensor<1, 3> &r)
    {
      const Vector3             &a = body.rotation_axis;
      const dealii::Tensor<1, 3> axis({a[0], a[1], a[2]});
      const dealii::Tensor<1, 3> e = axis / axis.norm(), along = (e * r) * e;
      const double               angle = body.angle * (M_PI / 180.);
      return along + std::cos(angle) * (r - along) +
             std::sin(angle) * dealii::cross_product_3d(e, r);
    }
  } // namespace



  const BodyParameters &
  carrier_of(const SceneParameters &scene, const unsigned int number)
  {
    const BodyParameters *body = &scene.bodies[number];
    while (body->shape == BodyParameters::Shape::layer)
      body = &scene.bodies[body_index(scene, body->layer_body)];
    return *body;
  }



  dealii::Point<3>
  turned_point(const BodyParameters &body, const dealii::Point<3> &x)
  {
    if (body.angle == 0.)
      return x;
    const Vector3         &c = body.centre_of_rotation();
    const dealii::Point<3> centre(c[0], c[1], c[2]);
    return centre + turned_vector(body, x - centre);
  }



  dealii::Point<3>
  turned_position(const BodyParameters &body)
  {
    const Vector3 &x = body.position;
    return turned_point(body, {x[0], x[1], x[2]});
  }



  dealii::Point<3>
  centre_of_gravity(const BodyParameters &rigid)
  {
    return turned_position(rigid);
  }



  dealii::SymmetricTensor<2, 3>
  turned_tensor(const BodyParameters &body, const Vector3 &values)
  {
    dealii::SymmetricTensor<2, 3> result;
    for (unsigned int k = 0; k < 3; ++k)
      {
        dealii::Tensor<1, 3> axis;
        axis[k] = 1.;
        if (body.angle != 0.)
          axis = turned_vector(body, axis);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            result[i][j] += values[k] * axis[i] * axis[j];
      }
    return result;
  }



  dealii::Point<3>
  place_of(const SceneParameters &scene, const LumpedMassParameters &mass)
  {
    return turned_point(carrier_of(scene, body_index(scene, mass.body)),
                        {mass.point[0], mass.point[1], mass.point[2]});
  }
} // namespace squeal
