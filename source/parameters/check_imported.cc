// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>

namespace squeal
{
  namespace prm
  {
    void
    check_imported(const Parameters &p)
    {
      using Analysis   = Parameters::Analysis;
      using Integrator = TransientParameters::Integrator;
      if (p.scene.kind != SceneParameters::Kind::matrices)
        return;
      const TransientParameters &t = p.transient;
      const bool is_moving         = p.analysis == Analysis::transient ||
                             p.analysis == Analysis::limit_cycle ||
                             p.analysis == Analysis::triggers;
      const bool is_linear = p.analysis != Analysis::preload &&
                             p.analysis != Analysis::limit_cycle &&
                             p.analysis != Analysis::triggers &&
                             (!is_moving || t.compare_with_cea);
      for (const ContactParameters &c : p.scene.contacts)
        {
          const std::string section = "Scene/Contact " + c.name;
          if (c.formulation != ContactParameters::Formulation::springs &&
              is_linear)
            refuse_entry(section,
                         "Formulation",
                         "must be springs: eigenvalues of matrices without "
                         "penetration would need unknowns taken out");
        }
      if (!is_moving)
        return;
      for (const MatrixPartParameters &part : p.scene.matrix_parts)
        if (part.role == MatrixPartParameters::Role::damping)
          refuse_entry("Scene/Matrix part " + part.name,
                       "Role",
                       "= damping is not for motions in time, whose damping "
                       "is C = alpha M + beta K: leave the part out and set "
                       "'Scene/Damping'");
      if (t.disc_frame != TransientParameters::DiscFrame::eulerian)
        refuse_entry("Transient",
                     "Disc frame",
                     "= corotating turns meshes, which matrices do not have");
      if (t.integrator == Integrator::explicit_)
        refuse_entry("Transient",
                     "Integrator",
                     "= explicit needs lumped masses of 'Kind = bodies'");
      if (t.animation_frames > 0)
        refuse_entry("Transient",
                     "Animation frames",
                     "must be 0: matrices have no mesh to draw");
      if (!t.hammer.body.empty())
        refuse_entry("Transient/Hammer",
                     "Body",
                     "must be empty: matrices have no face to strike; a "
                     "'Friction impulse' is a trigger, too");
    }
  } // namespace prm
} // namespace squeal
