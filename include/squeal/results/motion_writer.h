// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_motion_writer_h
#define squeal_results_motion_writer_h

#include <squeal/base/output_directory.h>

#include <squeal/results/drawn_bodies.h>

#include <string>
#include <vector>

namespace squeal
{
  /** How far the mesh of a body is turned about an axis along z. */
  struct TurnedBody
  {
    unsigned int        body = 0;       /**< its number in the scene */
    double              x = 0., y = 0.; /**< of the axis, m */
    std::vector<double> angles; /**< of each frame, rad, counterclockwise */
  };

  /** Largest values of a motion that has been written. */
  struct WrittenMotion
  {
    double largest_displacement = 0.; /**< m */
    double largest_deviation    = 0.; /**< from the mean of the frames, m */
    /** Factor by which ParaView's "Warp By Vector" shows the deviation. */
    double display_factor = 0.;
  };

  /**
   * Writes a motion in time for ParaView: `<name>.pvd` with times in s, which
   * lists `frames/<name>_0000.vtu`, ... Every VTU holds the undeformed bodies
   * and the point vectors `displacement` and `deviation`, m: the motion and
   * what it differs by from its mean over all frames, which is the vibration
   * without the deformation by the loads. Both have the numbers' single
   * precision. Field data beside that of DrawnBodies: `time_s` and
   * `display_factor`, by which a warp along `deviation` is drawn with @p
   * display_scale times the size of the scene.
   *
   * @param motion  free unknowns (owned rows), one column for each of @p times
   * @param turned  bodies whose unknowns are displacements along axes that turn
   *                with their mesh: they are drawn turned, points and vectors,
   *                their deviation being the one in their own axes
   *
   * Collective; rank 0 writes. Throws ComputationError where the motion is not
   * finite.
   */
  WrittenMotion write_motion(const Discretization          &discretization,
                             OutputDirectory               &output,
                             const std::string             &name,
                             const std::vector<double>     &times,
                             const Block                   &motion,
                             const unsigned int             n_subdivisions,
                             const double                   display_scale,
                             const std::vector<TurnedBody> &turned = {});

  /** `frames/<name>_0007.vtu`. */
  std::string frame_file(const std::string &name, const std::size_t k);
} // namespace squeal

#endif
