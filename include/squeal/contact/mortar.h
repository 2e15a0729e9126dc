// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_mortar_h
#define squeal_contact_mortar_h

#include <squeal/discretization/discretization.h>
#include <squeal/discretization/point_evaluator.h>

#include <string>
#include <vector>

namespace squeal
{
  /**
   * The dual mortar operators of a pair of faces: with dual shape functions
   * psi_j on the source face, int psi_j phi_k = delta_jk D_j, and
   * M_j u = int psi_j u_target. The weighted gap vanishes where the source
   * node moves as the combination D_j^-1 M_j of target unknowns.
   */
  struct MortarCoupling
  {
    std::vector<dealii::Point<3>> nodes;   /**< source nodes, m */
    std::vector<double>           weights; /**< D_j, m^2 */
    /** Pieces of the source face between neighbouring nodes, by their numbers,
     * counter-clockwise seen from outside. */
    std::vector<std::array<unsigned int, 4>> quads;
    /** Outward unit normals of the source face at its nodes, averaged over the
     * faces round each. */
    std::vector<dealii::Tensor<1, 3>> normals;
    /** Row of each source node's displacement (x, y, z); -1u where held. */
    std::vector<std::array<unsigned int, 3>> source_rows;
    /** D_j^-1 M_j for the three components; empty on the ground. */
    std::vector<std::array<Functionals::Row, 3>> target_rows;
    /** The largest distance of a source node from the place that its row takes
     * on the target, m, and the largest share of a source face that lies beside
     * the target. */
    double distance = 0., beside = 0.;
  };

  /**
   * Integrates D and M over the segments that source and target faces share,
   * see face_overlap(): to rounding where both are parallelograms, spectrally
   * where edges are curved. Constants are transferred exactly, linear fields
   * where the faces lie in one plane. Throws InputError (its text begins with
   * @p where) where the source face leaves the target or carries hanging nodes.
   */
  MortarCoupling make_mortar_coupling(const Discretization &discretization,
                                      const PointEvaluator &evaluator,
                                      const unsigned int    source_face_id,
                                      const unsigned int    target_body,
                                      const std::string    &where);

  /**
   * The same for the tie of a number, on two meshes of one surface that may
   * differ as arcs and facets do: across by 5 % of the larger face, beside each
   * other by 2 % of a source face. A source node at x follows the place X =
   * D^-1 M x_target that its row takes, and is carried along by the rotation
   * that fits the target nodes round it best, by least squares, each with what
   * it shares with the source faces there: u = D^-1 M u_target + omega x (x -
   * X). Every rigid motion of the target is then one of the source face, forces
   * pass with their moments, and where x = X nothing is added. Throws as above.
   */
  MortarCoupling make_tie_coupling(const Discretization &discretization,
                                   const PointEvaluator &evaluator,
                                   const unsigned int    tie);

  /** A sentence for the log on each tie whose faces differ by more than 1e-6 of
   * a face, with the distance. Collective. */
  std::vector<std::string> remarks_on_ties(
    const Discretization &discretization);

  /**
   * Node to surface: every source node follows the target where it stands,
   * M_j u = D_j u_target(x_j), with the tributary areas D_j of the mortar
   * operators. For comparison: an even pressure does not pass faces that do
   * not match. Throws as make_mortar_coupling().
   */
  MortarCoupling make_node_coupling(const Discretization &discretization,
                                    const PointEvaluator &evaluator,
                                    const unsigned int    source_face_id,
                                    const unsigned int    target_body,
                                    const std::string    &where);
} // namespace squeal

#endif
