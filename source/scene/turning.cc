// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/scene/coarse_mesh.h>
#include <squeal/scene/turning.h>

#include <cmath>

namespace squeal
{
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
    const Vector3             &a = body.rotation_axis;
    const dealii::Tensor<1, 3> axis({a[0], a[1], a[2]});
    const dealii::Tensor<1, 3> e = axis / axis.norm();
    const Vector3             &c = body.centre_of_rotation();
    const dealii::Point<3>     centre(c[0], c[1], c[2]);
    const double               angle = body.angle * (M_PI / 180.);
    const dealii::Tensor<1, 3> r = x - centre, along = (e * r) * e;
    return centre + along + std::cos(angle) * (r - along) +
           std::sin(angle) * dealii::cross_product_3d(e, r);
  }



  dealii::Point<3>
  place_of(const SceneParameters &scene, const LumpedMassParameters &mass)
  {
    return turned_point(carrier_of(scene, body_index(scene, mass.body)),
                        {mass.point[0], mass.point[1], mass.point[2]});
  }
} // namespace squeal
