// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_parametric_system_h
#define squeal_sweep_parametric_system_h

#include <squeal/discretization/affine_system.h>
#include <squeal/sweep/sweep_grid.h>

#include <vector>

namespace squeal
{
  /**
   * The affine parts of a scene over a parameter box, those merged whose
   * coefficients are proportional all over the box: the TriboBrake with
   * Rayleigh damping has four when the pad's stiffness and the friction
   * coefficient are swept.
   */
  class ParametricSystem
  {
  public:
    /** Throws InputError where a swept entry changes the operators themselves
     * (geometry, Poisson ratio, ...), which no coefficient can follow. */
    ParametricSystem(const AffineSystem &system, const SweepGrid &grid);

    /** One term a merged part. */
    const AffineSystem &merged() const;
    const SweepGrid    &grid() const;

    /** Whether a part belongs to some of the grid's contact states only. */
    bool is_switched(const std::size_t part) const;

    /** Coefficients of every part there. */
    std::vector<TermCoefficients> coefficients(const SweepPoint &point) const;
    /** Of a scene that differs in numbers that keep the parts apart. */
    std::vector<TermCoefficients> coefficients(
      const SceneParameters &scene) const;

  private:
    AffineSystem     parts;
    const SweepGrid &sweep_grid;
    /** In which contact states each part is. */
    std::vector<std::vector<bool>> is_there;
  };

  /** Throws InputError naming @p section for an entry that enters otherwise than
   * by coefficients of affine parts. */
  void require_affine(const std::string &section, const std::string &path);

  /** Whether a coefficient of @p system differs between two scenes whose matrix
   * is more than zeros. */
  bool change_matrices(const AffineSystem    &system,
                       const SceneParameters &a,
                       const SceneParameters &b);
} // namespace squeal

#endif
