// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_solved_scene_h
#define squeal_model_solved_scene_h

#include <squeal/model/cea_solution.h>
#include <squeal/model/common_parts.h>
#include <squeal/model/model.h>
#include <squeal/parameters/parameters.h>

#include <memory>
#include <vector>

namespace squeal
{
  /**
   * The complex pairs of a scene, and what those of the same bodies with other
   * friction start from.
   *
   * A brake that turns backwards, or slides at another speed, differs by its
   * friction alone as long as the same contact nodes are closed. Factor, modes
   * and friction responses are then those of the earlier scene, whose pairs are
   * a start as well; whether they are is asked of the matrices. Residuals and
   * errors of the pairs are their own. With 'Refinement = eigenvalue error'
   * each scene has a mesh of its own.
   */
  class SolvedScene
  {
  public:
    /**
     * @param states   of the closed contacts, a list for each pair; empty for
     *                 those of the parameters
     * @param earlier  a scene to start from where that is possible, or null
     * @param common   what it shares with other scenes whose meshes are made of
     *                 the same numbers
     * Throws InputError where the band is empty, ComputationError where the
     * pairs do not converge.
     */
    SolvedScene(const Parameters                 &parameters,
                const std::vector<ContactStates> &states,
                const SolvedScene                *earlier,
                CommonParts                      &common,
                RunLog                           &log,
                Timers                           &timers);

    const Model       &model() const;
    const Pencil      &pencil() const;
    const CeaSolution &solution() const;
    /** Whether it holds what another scene can start from. */
    bool has_start() const;

  private:
    /** Of the matrices of @p earlier, with the friction of this scene; null
     * where this scene is another one. */
    std::unique_ptr<const Pencil> pencil_on(const SolvedScene &earlier) const;

    const Parameters                 parameters;
    Model                            own_model; /**< its mesh may be refined */
    std::unique_ptr<const Pencil>    shared_pencil; /**< or null */
    ModeSolution                     modes; /**< where the start is its own */
    std::unique_ptr<CertifiedSolver> solver;
    CeaSolution                      found;
  };
} // namespace squeal

#endif
