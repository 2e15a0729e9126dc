// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_frequency_pencil_h
#define squeal_model_frequency_pencil_h

#include <squeal/eigen/frequency_dependence.h>
#include <squeal/results/table.h>
#include <squeal/scene/modulus_table.h>

#include <memory>
#include <vector>

namespace squeal
{
  /**
   * The pencil of a scene whose bodies have modulus tables: one part for each
   * table and temperature, the rest merged as far as its coefficients are
   * proportional,
   *
   *   K(omega) = K_0 + sum over bodies (E(omega) (1 + i eta(omega)) - E_0) K_b
   *
   * with the stiffness K_b of the body for a modulus of 1, and its damping
   * beta E(omega) K_b.
   */
  class FrequencyPencil
  {
  public:
    /** @param scene  with the moduli of the reference frequency */
    FrequencyPencil(const AffineSystem    &system,
                    const SceneParameters &scene,
                    const ModulusTables   &tables);

    /** At the reference frequency. */
    const Pencil &pencil() const;

    /** Of the parts of pencil() at omega, rad/s; refers to this object. */
    FrequencyDependentPairs::Coefficients coefficients() const;

    /** Merged, at @p frequency, Hz. */
    Pencil merged_at(const double frequency) const;

    /** Number of undamped modes of the reduced basis that lie below @p
     * frequency, Hz, with the moduli of that frequency. */
    unsigned int n_modes_below(const ReducedBasis &basis,
                               const double        frequency) const;

  private:
    AffineSystem            grouped;
    const AffineSystem     &whole;
    const SceneParameters   scene;
    const ModulusTables     tables;
    std::unique_ptr<Pencil> all;
  };

  /** moduli.csv: what each body with a table has in each pair. */
  Table moduli_table(const SceneParameters &scene, const ComplexPairs &pairs);

  /** "shim 3.1e6 to 4.2e6 Pa, loss factor 0.61 to 0.8" of all such bodies over
   * the pairs; empty where there are none. */
  std::string moduli_text(const SceneParameters &scene,
                          const ComplexPairs    &pairs);
} // namespace squeal

#endif
