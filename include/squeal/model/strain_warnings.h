// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_strain_warnings_h
#define squeal_model_strain_warnings_h

#include <squeal/contact/contact_geometry.h>
#include <squeal/parameters/scene_parameters.h>

#include <vector>

namespace squeal
{
  class PressedModel;
  class RunLog;
  struct SteadySliding;

  /** Warns of pairs whose mean pressure is more than a tenth of the Young
   * modulus of one of their bodies: the equations are those of small
   * displacements. @p contacts and @p states are those of the pairs of @p
   * scene, of which those count whose forces are in N; none of rigid bodies and
   * of imported matrices. */
  void warn_of_large_strains(const SceneParameters              &scene,
                             const std::vector<ContactGeometry> &contacts,
                             const std::vector<ContactState>    &states,
                             RunLog                             &log);

  /** The same in steady sliding under the full load. */
  void warn_of_large_strains(const SceneParameters &scene,
                             const PressedModel    &pressed,
                             const SteadySliding   &steady,
                             RunLog                &log);
} // namespace squeal

#endif
