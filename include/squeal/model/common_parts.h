// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_common_parts_h
#define squeal_model_common_parts_h

#include <squeal/contact/mortar.h>
#include <squeal/discretization/assembly.h>
#include <squeal/parameters/analysis_parameters.h>

#include <vector>

namespace squeal
{
  /**
   * What scenes on one mesh have in common whatever their moduli, loads,
   * speeds and friction: the matrices of the bodies and the mortar couplings of
   * the contacts. Each is made for the first scene that asks for it, and again
   * where a later one has other bodies.
   */
  class CommonParts
  {
  public:
    /** Whether all scenes of these parameters have one mesh. */
    static bool exist_for(const DiscretizationParameters &parameters);

    /** assemble_bodies() on @p discretization. Collective. */
    const std::vector<BodyMatrices> &bodies(
      const Discretization &discretization);

    /** contact_couplings() of @p discretization. Collective. */
    const std::vector<MortarCoupling> &couplings(
      const Discretization &discretization);

  private:
    /** Forgets all where the parts are not those of @p discretization. */
    void hold_for(const Discretization &discretization);

    std::vector<BodyParameters> parameters; /**< of the parts */
    unsigned int                degree = 0;
    std::size_t                 n_dofs = 0;
    std::vector<BodyMatrices>   matrices;
    std::vector<MortarCoupling> of_contacts;
  };
} // namespace squeal

#endif
