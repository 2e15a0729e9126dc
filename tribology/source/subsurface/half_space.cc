// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/subsurface/half_space.h>

#include <array>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /**
     * Third and fourth derivatives of the integral of z ln(r + z) - r over a
     * rectangle, as antiderivatives at a corner: what depends on one of a and b
     * only is left out, since it cancels between the corners.
     */
    struct Derivatives
    {
      double xxx = 0., yyy = 0., zzz = 0., xxy = 0., xyy = 0., xxz = 0.,
             yyz = 0., xyz = 0., xzz = 0., yzz = 0.;
      double xxzz = 0., yyzz = 0., zzzz = 0., xyzz = 0., xzzz = 0., yzzz = 0.,
             xxyz = 0., xyyz = 0., xxxz = 0., yyyz = 0.;

      /** ln(r + b) without cancellation. */
      static double
      logarithm(const double r, const double b, const double others)
      {
        return b >= 0. ? std::log(r + b) : std::log(others / (r - b));
      }

      void
      add(const double a, const double b, const double z, const double sign)
      {
        const double aa = a * a, bb = b * b, zz = z * z;
        const double r       = std::sqrt(aa + bb + zz);
        const double log_a   = logarithm(r, a, bb + zz);
        const double log_b   = logarithm(r, b, aa + zz);
        const double below_a = aa * r + z * bb, below_b = bb * r + z * aa;
        xyz += sign * std::log(r + z);
        xxy -= sign * a / (r + z);
        xyy -= sign * b / (r + z);
        xzz += sign * log_b;
        yzz += sign * log_a;
        zzz -= sign * std::atan(a * b / (z * r));
        xxz += below_a > 0. ? sign * std::atan(a * b * (r - z) / below_a) : 0.;
        yyz += below_b > 0. ? sign * std::atan(a * b * (r - z) / below_b) : 0.;
        xxx += sign * (b / (r + z) - log_b);
        yyy += sign * (a / (r + z) - log_a);

        xyzz += sign / r;
        xzzz -= sign * z * b / (r * (aa + zz));
        yzzz -= sign * z * a / (r * (bb + zz));
        xxzz -= sign * a * b / (r * (aa + zz));
        yyzz -= sign * a * b / (r * (bb + zz));
        zzzz += sign * a * b * (r * r + zz) / (r * (aa + zz) * (bb + zz));
        xxyz += sign * a / (r * (r + z));
        xyyz += sign * b / (r * (r + z));
      }

      /** The two that follow since the potential is harmonic. */
      void
      complete()
      {
        xxxz = -xyyz - xzzz;
        yyyz = -xxyz - yzzz;
      }
    };



    /** Displacement times shear modulus at (x, y, z) from unit forces at the
     * origin along x, y and z: Cerruti and Boussinesq, Johnson (1985), eqs.
     * 3.18 and 3.75. */
    Eigen::Matrix3d
    point_displacement(const double x,
                       const double y,
                       const double z,
                       const double nu)
    {
      const double r = std::sqrt(x * x + y * y + z * z), rrr = r * r * r;
      const double m = 1. - 2. * nu, s = r + z;
      // of the tangential forces along, across and down
      const auto along = [&](const double a) {
        return 1. / r + a * a / rrr + m * (1. / s - a * a / (r * s * s));
      };
      const double across = x * y / rrr - m * x * y / (r * s * s);
      const auto   down   = [&](const double a) {
        return a * z / rrr + m * a / (r * s);
      };
      const auto outward = [&](const double a) {
        return a * z / rrr - m * a / (r * s);
      };
      Eigen::Matrix3d u;
      u << along(x), across, outward(x), //
        across, along(y), outward(y),    //
        down(x), down(y), z * z / rrr + 2. * (1. - nu) / r;
      return u / (4. * M_PI);
    }
  } // namespace



  PatchInfluence
  patch_influence(const Patch &patch,
                  const double x,
                  const double y,
                  const double z,
                  const double nu)
  {
    Derivatives d;
    d.add(x - patch.x_min, y - patch.y_min, z, 1.);
    d.add(x - patch.x_max, y - patch.y_min, z, -1.);
    d.add(x - patch.x_min, y - patch.y_max, z, -1.);
    d.add(x - patch.x_max, y - patch.y_max, z, 1.);
    d.complete();

    const double   m = 1. - 2. * nu;
    PatchInfluence s;
    s.col(0) << 2. * (1. + nu) * d.xzz + 2. * nu * d.xxx - z * d.xxxz,
      2. * nu * (d.xzz + d.xyy) - z * d.xyyz, -z * d.xzzz,
      d.yzz + 2. * nu * d.xxy - z * d.xxyz, -z * d.xyzz, d.zzz - z * d.xxzz;
    s.col(1) << 2. * nu * (d.yzz + d.xxy) - z * d.xxyz,
      2. * (1. + nu) * d.yzz + 2. * nu * d.yyy - z * d.yyyz, -z * d.yzzz,
      d.xzz + 2. * nu * d.xyy - z * d.xyyz, d.zzz - z * d.yyzz, -z * d.xyzz;
    s.col(2) << 2. * nu * d.zzz - m * d.xxz - z * d.xxzz,
      2. * nu * d.zzz - m * d.yyz - z * d.yyzz, d.zzz - z * d.zzzz,
      -m * d.xyz - z * d.xyzz, -z * d.yzzz, -z * d.xzzz;
    return s / (2. * M_PI);
  }



  Eigen::Matrix3d
  patch_displacement(const Patch &patch,
                     const double x,
                     const double y,
                     const double z,
                     const double nu)
  {
    constexpr std::array<double, 4> places{{-.8611363115940526,
                                            -.3399810435848563,
                                            .3399810435848563,
                                            .8611363115940526}},
      weights{{.3478548451374538,
               .6521451548625461,
               .6521451548625461,
               .3478548451374538}};
    const double    a = .5 * (patch.x_max - patch.x_min);
    const double    b = .5 * (patch.y_max - patch.y_min);
    Eigen::Matrix3d u = Eigen::Matrix3d::Zero();
    for (unsigned int i = 0; i < places.size(); ++i)
      for (unsigned int j = 0; j < places.size(); ++j)
        u += a * b * weights[i] * weights[j] *
             point_displacement(x - patch.x_min - a * (1. + places[i]),
                                y - patch.y_min - b * (1. + places[j]),
                                z,
                                nu);
    return u;
  }



  StripInfluence
  strip_influence(const double x_min,
                  const double x_max,
                  const double x,
                  const double z)
  {
    StripInfluence s = StripInfluence::Zero();
    for (const auto &[end, sign] :
         {std::pair{x - x_min, 1.}, std::pair{x - x_max, -1.}})
      {
        const double rr    = end * end + z * z;
        const double angle = std::atan2(end, z);
        const double az = end * z / rr, zz = z * z / rr;
        const double f = sign / M_PI;
        s.col(0) += f * Eigen::Vector3d(-std::log(rr) - zz, zz, az - angle);
        s.col(1) += f * Eigen::Vector3d(az - angle, -az - angle, zz);
      }
    return s;
  }



  bool
  is_near_edge(const double distance, const double depth)
  {
    return distance < 3. * depth;
  }
} // namespace squeal::tribology
