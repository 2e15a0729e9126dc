// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_mortar_integrals_h
#define squeal_contact_mortar_integrals_h

#include <squeal/contact/mortar_faces.h>

#include <Eigen/Dense>

#include <string>
#include <vector>

namespace squeal
{
  /** int phi_a phi_b of a source face with a target face. */
  struct SharedIntegrals
  {
    unsigned int    target;   /**< number of the target face */
    Eigen::MatrixXd products; /**< source nodes x target nodes, m^2 */
  };

  /** What the dual mortar operators of one source face are made of. */
  struct SourceIntegrals
  {
    Eigen::MatrixXd              mass;         /**< int phi_a phi_b, m^2 */
    double                       covered = 0.; /**< share of the face */
    std::vector<SharedIntegrals> shared;
  };

  /** What target faces may be away from source faces: across, over the larger
   * face's size, and as a share of a source face that lies beside them. */
  struct MeetingLimits
  {
    double reach = 0., beside = 1e-4;
  };

  /** What two meshes of one surface may differ by where nothing but values at
   * points crosses, or where the place that is met is put right. */
  constexpr MeetingLimits limits_of_meshes{.05, .02};

  /** A source face with the target faces of the numbers @p near, segment by
   * segment. */
  SourceIntegrals integrals_of_segments(const FaceBasis                &basis,
                                        const SurfaceFace              &source,
                                        const std::vector<TargetFace>  &targets,
                                        const std::vector<std::size_t> &near,
                                        const MeetingLimits &limits = {});

  /** Every source face with the target faces of this rank, segment by segment;
   * masses and covered shares over all ranks. */
  std::vector<SourceIntegrals> integrals_of_all_faces(
    const FaceBasis               &basis,
    const std::vector<SourceFace> &sources,
    const std::vector<TargetFace> &targets,
    const MeetingLimits           &limits,
    const MPI_Comm                 communicator);

  /** The masses alone. */
  std::vector<SourceIntegrals> integrals_of_whole_faces(
    const FaceBasis               &basis,
    const std::vector<SourceFace> &sources);

  /** Throws InputError, its text beginning with @p where, where part of a
   * source face has no target opposite. */
  void check_covered(const std::vector<SourceFace>      &sources,
                     const std::vector<SourceIntegrals> &integrals,
                     const std::string                  &where,
                     const MeetingLimits                &limits = {});

  /** From products with the shape functions phi of a source face to those with
   * its dual functions psi = D_e M_e^-1 phi. */
  class DualMap
  {
  public:
    explicit DualMap(const SourceIntegrals &face);

    /** int psi_a phi_b, m^2. */
    Eigen::MatrixXd operator()(const SharedIntegrals &shared) const;
    /** int psi_a = int phi_a, m^2. */
    const Eigen::VectorXd &weights() const;

  private:
    Eigen::VectorXd              areas;
    Eigen::LDLT<Eigen::MatrixXd> factor;
  };

  /** Numbers of the nodes of all source faces, appending each node and its rows
   * once. */
  std::vector<std::vector<unsigned int>> number_nodes(
    const std::vector<SourceFace>            &sources,
    std::vector<dealii::Point<3>>            &nodes,
    std::vector<std::array<unsigned int, 3>> &rows);
} // namespace squeal

#endif
