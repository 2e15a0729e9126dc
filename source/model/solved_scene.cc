// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/eigen/same_operators.h>
#include <squeal/model/solved_scene.h>

namespace squeal
{
  SolvedScene::SolvedScene(const Parameters                 &p,
                           const std::vector<ContactStates> &states,
                           const SolvedScene                *earlier,
                           CommonParts                      &common,
                           RunLog                           &log,
                           Timers                           &timers)
    : parameters(p)
    , own_model(parameters,
                timers,
                states,
                Model::Contacts::closed,
                CommonParts::exist_for(p.discretization) ? &common : nullptr)
  {
    if (earlier && earlier->has_start())
      shared_pencil = pencil_on(*earlier);
    if (shared_pencil)
      {
        log.info("  factor and modes of the condition that differs by its "
                 "friction alone");
        Timers::Section section(timers, "Solve: certified eigenvalues");
        CertifiedSolver from_there(*shared_pencil,
                                   *earlier->solver,
                                   earlier->modes.modes,
                                   earlier->found.pairs);
        found = solve_whole_band(from_there, parameters.eigen, log);
      }
    else
      {
        modes = parameters.discretization.refinement ==
                    DiscretizationParameters::Refinement::eigenvalue_error
                  ? solve_modes_adaptively(own_model, log, timers)
                  : solve_modes(own_model, log, timers);
        found = solve_cea(own_model, modes, log, timers, &solver);
      }
    if (found.pairs.size() == 0)
      {
        warn_of_growth_left_out(found, "", log);
        refuse_empty_band(parameters, shared_pencil ? earlier->modes : modes);
      }
  }

  std::unique_ptr<const Pencil>
  SolvedScene::pencil_on(const SolvedScene &earlier) const
  {
    const AffineSystem &others = earlier.own_model.linearized().system;
    auto result = std::make_unique<const Pencil>(others, parameters.scene);
    const Pencil own(own_model.linearized().system, parameters.scene);
    if (!same_operators(*result, own) ||
        !same_symmetric_operators(*result, earlier.pencil()))
      return nullptr;
    return result;
  }

  const Model &
  SolvedScene::model() const
  {
    return own_model;
  }

  const Pencil &
  SolvedScene::pencil() const
  {
    return shared_pencil ? *shared_pencil : *modes.pencil;
  }

  const CeaSolution &
  SolvedScene::solution() const
  {
    return found;
  }

  bool
  SolvedScene::has_start() const
  {
    return solver != nullptr;
  }
} // namespace squeal
