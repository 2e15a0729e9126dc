// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_cea_quantities_h
#define squeal_output_cea_quantities_h

#include <squeal/eigen/unstable_pair.h>
#include <squeal/model/mode_solution.h>

#include <vector>

namespace squeal
{
  /** What is said of each complex pair beside its eigenvalue. */
  struct PairQuantities
  {
    std::vector<ModeName> names;
    Eigen::MatrixXd       energy_shares; /**< bodies x pairs */
    /** Work of the friction force on the vibration in one cycle over the peak
     * kinetic energy: -2 pi Im(x^H K_f x) / (|lambda|^2 x^H M x). Positive:
     * friction feeds the vibration. */
    std::vector<double> energy_per_cycle;
    /** Root mean square of the tangential motion of the source times that of
     * the normal motion of the target at the contact, times the mass of the
     * scene, for x^H M x = 1. */
    std::vector<double> contact_participation;
    /** The undamped modes that make up the pair: the two with the largest MAC,
     * numbers from 0, and these MACs. */
    std::vector<std::array<int, 2>>    partners;
    std::vector<std::array<double, 2>> partner_mac;
    /** Estimated relative discretisation error, from the partners'. */
    std::vector<double> discretisation_error;
    /** lambda - lambda_h by the mesh, 1/s; empty: not estimated. */
    Eigen::VectorXcd mesh_error;
  };

  /** Tangential motion of the source and normal motion of the target at every
   * point of a contact pair. */
  struct ContactMotion
  {
    std::shared_ptr<const Functionals> tangential_source, normal_target;
  };
  ContactMotion contact_motion(const Model &model, const unsigned int number);

  /** Mass of all bodies and lumped masses in @p scene, kg, which is that of the
   * model but for densities and masses of a sweep; of imported matrices that of
   * the direction in which fewest unknowns are held. */
  double total_mass(const Model &model, const SceneParameters &scene);

  /** Names of all pairs. */
  std::vector<ModeName> pair_names(const Model        &model,
                                   const ComplexPairs &pairs);

  PairQuantities pair_quantities(const Model        &model,
                                 const ModeSolution &modes,
                                 const ComplexPairs &pairs);


  /** The contact state of a scene as its parameters name it: of several pairs
   * each state once, "none" without pairs. */
  std::string contact_state_text(const SceneParameters &scene);

  /** eigenvalues.csv. */
  Table eigenvalue_table(const Model          &model,
                         const ModeSolution   &modes,
                         const ComplexPairs   &pairs,
                         const PairQuantities &quantities);
} // namespace squeal

#endif
