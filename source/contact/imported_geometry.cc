// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/imported_geometry.h>

namespace squeal
{
  namespace
  {
    dealii::Tensor<1, 3>
    tensor_of(const Vector3 &v)
    {
      dealii::Tensor<1, 3> result;
      for (unsigned int c = 0; c < 3; ++c)
        result[c] = v[c];
      return result;
    }

    /** Displacements along x, y, z from those along three directions. */
    std::array<Functionals::Row, 3>
    cartesian(const std::array<ImportedContact::Row, 3> &along,
              const std::array<Vector3, 3>              &directions)
    {
      std::array<Functionals::Row, 3> result;
      for (unsigned int c = 0; c < 3; ++c)
        result[c] = combine({{directions[0][c], &along[0]},
                             {directions[1][c], &along[1]},
                             {directions[2][c], &along[2]}});
      return result;
    }
  } // namespace



  ContactGeometry
  imported_geometry(std::shared_ptr<const RowSpace> space,
                    const ImportedContact          &contact)
  {
    ContactGeometry g;
    g.areas       = contact.areas;
    g.speed_ratio = contact.speed_ratio;
    for (std::size_t j = 0; j < contact.points.size(); ++j)
      {
        const auto &x = contact.points[j];
        const auto &d = contact.directions[j];
        g.points.emplace_back(x[0], x[1], x[2]);
        g.frames.push_back({tensor_of(d[0]), tensor_of(d[1]), tensor_of(d[2])});
        g.source_rows.push_back(cartesian(contact.source[j], d));
        g.target_rows.push_back(cartesian(contact.target[j], d));
      }
    g.normal     = std::make_shared<const Functionals>(space, contact.normal);
    g.tangential = std::make_shared<const Functionals>(space, contact.sliding);
    g.transverse =
      std::make_shared<const Functionals>(space, contact.transverse);
    return g;
  }
} // namespace squeal
