// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_second_solutions_h
#define squeal_model_second_solutions_h

#include <squeal/eigen/complex_pairs.h>
#include <squeal/model/common_parts.h>
#include <squeal/model/other_degree.h>
#include <squeal/model/pressed_conditions.h>

#include <memory>

namespace squeal
{
  /**
   * The pairs of one scene after another with elements of another degree: the
   * second solutions that tell what the mesh does to growth rates. What a scene
   * has in common with an earlier one is used again: the statics of its contact
   * where the moduli or the loads alone are others, factor and modes where it
   * differs by its friction alone.
   */
  class SecondSolutions
  {
  public:
    /** Of scenes that have nothing in common. */
    SecondSolutions();
    ~SecondSolutions();

    /** Of scenes on one mesh; those that follow have the same number @p bodies
     * where their bodies and loads are the same. */
    void of_bodies(const std::size_t bodies);

    struct Solution
    {
      std::shared_ptr<const OtherDegree> scene;
      ComplexPairs                       pairs; /**< may be none */
    };

    /** Those about @p pairs of @p model, from @p below of their lowest
     * frequency under it to @p above of their highest beyond it. Throws
     * ComputationError where they are not certified. */
    Solution solve(const Model        &model,
                   const unsigned int  degree,
                   const ComplexPairs &pairs,
                   const double        below,
                   const double        above,
                   Timers             &timers);

  private:
    struct Solved;

    /** Of the matrices of the last scene, with the friction of @p parameters;
     * null where @p scene differs by more than its friction. */
    std::unique_ptr<const Pencil> pencil_on_last(
      const OtherDegree     &scene,
      const SceneParameters &parameters) const;

    /** Of scenes on one mesh: parts, statics. */
    std::unique_ptr<CommonParts>       parts;
    std::unique_ptr<PressedConditions> pressed;
    std::size_t                        bodies_of_scene = 0;
    std::unique_ptr<const Solved>      last;
  };
} // namespace squeal

#endif
