// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/contact_terms.h>
#include <squeal/model/common_parts.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    /** Whether the matrices of two bodies on one mesh are the same. The modulus
     * of an isotropic one and the density are factors of theirs. */
    bool
    have_same_matrices(const BodyParameters &a, const BodyParameters &b)
    {
      using Shape = BodyParameters::Shape;
      using Model = BodyParameters::MaterialModel;
      if (a.name != b.name || a.shape != b.shape ||
          a.material_model != b.material_model ||
          (a.rotation_speed == 0.) != (b.rotation_speed == 0.) ||
          a.angle != b.angle)
        return false;
      if (a.shape == Shape::rigid)
        return a.mass == b.mass && a.inertia == b.inertia;
      if (a.material_model == Model::isotropic)
        return a.poisson_ratio == b.poisson_ratio;
      return a.young_moduli == b.young_moduli &&
             a.shear_moduli == b.shear_moduli &&
             a.poisson_ratios == b.poisson_ratios &&
             a.material_axis_1 == b.material_axis_1 &&
             a.material_axis_2 == b.material_axis_2;
    }
  } // namespace



  bool
  CommonParts::exist_for(const DiscretizationParameters &p)
  {
    using Refinement = DiscretizationParameters::Refinement;
    return p.refinement == Refinement::none ||
           p.refinement == Refinement::uniform;
  }

  void
  CommonParts::hold_for(const Discretization &d)
  {
    const auto &bodies = d.scene().bodies;
    if (degree == d.degree() && n_dofs == d.n_dofs() &&
        std::equal(bodies.begin(),
                   bodies.end(),
                   parameters.begin(),
                   parameters.end(),
                   have_same_matrices))
      return;
    parameters = bodies;
    degree     = d.degree();
    n_dofs     = d.n_dofs();
    matrices.clear();
    of_contacts.clear();
  }

  const std::vector<BodyMatrices> &
  CommonParts::bodies(const Discretization &d)
  {
    hold_for(d);
    if (matrices.empty())
      matrices = assemble_bodies(d);
    return matrices;
  }

  const std::vector<MortarCoupling> &
  CommonParts::couplings(const Discretization &d)
  {
    hold_for(d);
    if (of_contacts.empty())
      of_contacts = contact_couplings(d);
    return of_contacts;
  }
} // namespace squeal
