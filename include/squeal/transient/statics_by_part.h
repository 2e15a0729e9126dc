// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_transient_statics_by_part_h
#define squeal_transient_statics_by_part_h

#include <squeal/transient/reduced_contact_model.h>

#include <optional>
#include <vector>

namespace squeal
{
  /**
   * Steady sliding of a scene cut open, for many sets of moduli and loads: a
   * brake under all its pressures and temperatures.
   *
   * A scene cut open falls into parts that neither stiffness nor mass couples:
   * a body, or bodies that springs and ties join. Where a condition multiplies
   * the whole stiffness of part b by r_b, its free motions phi stay what they
   * are, and its elastic response A_b f becomes A_b f / r_b:
   *   B u = B phi q + sum_b B A_b (f - B^T lambda) / r_b,
   * so that the responses of one condition, kept part by part, give those of
   * all others without another factorisation. Elastic modes are no coordinates
   * here, as their frequencies would differ from condition to condition.
   */
  class StaticsByPart
  {
  public:
    /**
     * Solves one column a contact node and load.
     *
     * @param system   the scene cut open
     * @param scene    its parameters
     * @param basis    modes, among them all free motions; no Ritz vectors
     * @param cut_off  Hz, of these
     * @param nodes    of all contact pairs
     * @param loads    forces on the unknowns, N, a column a load
     */
    StaticsByPart(const AffineSystem    &system,
                  const SceneParameters &scene,
                  const ReductionBasis  &basis,
                  const double           cut_off,
                  const ContactNodes    &nodes,
                  const Block           &loads);

    /**
     * What steady sliding needs of the scene with the parameters @p scene and
     * the loads @p loads, in as many columns: a model without elastic modes,
     * with the flexibility of Flexibility::of_sliding and no observers. @p nodes
     * are those of the same faces. Empty where a part changes otherwise than by
     * one factor of its stiffness, a load otherwise than in its size, or a pair
     * comes to rest. Collective.
     */
    std::optional<ReducedContactModel> at(const SceneParameters &scene,
                                          const Block           &loads,
                                          const ContactNodes    &nodes) const;

  private:
    /** The static responses of one part to unit forces on the contact nodes
     * and to the loads, where these nodes are. */
    struct Part
    {
      Eigen::MatrixXd flexibility; /**< 3 nodes x 3 nodes, m/N */
      Eigen::MatrixXd load_motion; /**< 3 nodes x loads, m */
    };

    void find_parts();
    /** What multiplies the stiffness of every part; empty where one changes
     * otherwise. */
    std::optional<std::vector<double>> stiffness_ratios(
      const SceneParameters &scene) const;
    /** What multiplies every load; empty where one changes otherwise. */
    std::optional<Eigen::VectorXd> load_ratios(const Block &loads) const;
    /** B x_b of every part: @p x with the rows of the others as zeros. */
    std::vector<Eigen::MatrixXd> motions_of_parts(const Functionals &B,
                                                  const Block       &x) const;

    AffineSystem                  system;
    std::vector<TermCoefficients> coefficients; /**< of every term */
    std::vector<unsigned int>     part_of_term;
    std::vector<unsigned int>     part_of_row; /**< of this rank */
    std::vector<Part>             parts;
    ContactNodes                  contact_nodes;
    Block                         solved_loads;
    Eigen::MatrixXd               participation; /**< 3 nodes x free motions */
    Eigen::MatrixXd               modal_loads;   /**< free motions x loads */
  };
} // namespace squeal

#endif
