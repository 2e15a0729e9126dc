// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_measured_shapes_h
#define squeal_results_measured_shapes_h

#include <array>
#include <complex>
#include <map>
#include <string>
#include <vector>

namespace squeal
{
  struct MeasurementParameters;
  class RunLog;

  /** A shape of a measured mode. */
  struct MeasuredShape
  {
    std::string name;
    double      frequency = 0.; /**< Hz */
    /** Of a complex mode as its file has it, 1/s; else 0. The values below are
     * those of the eigenvalue with the positive imaginary part, conjugate to
     * those of the file where this one's is negative. */
    std::complex<double> eigenvalue = 0.;
    /** Values of a UFF file: x, y, z of numbered nodes. */
    std::map<unsigned int, std::array<std::complex<double>, 3>> nodes;
    /** Values of a CSV file, by the name of the point. */
    std::map<std::string, std::complex<double>> points;
  };

  /**
   * Reads the datasets 55 of a universal file (normal or complex modes of three
   * or six motions a node, real or complex), or a CSV file with the columns
   * shape, frequency_hz, point, real and imag. What begins with "-1" alone in a
   * line is a universal file. Of datasets 55 those count that hold
   * displacements, velocities or accelerations, or do not say what they hold.
   * Both members of a conjugate pair are one shape.
   *
   * Throws InputError "file:line: ..." for a file that is neither, that is cut
   * off, holds no shape, numbers that are none, a node or point that a shape
   * has twice, or two frequencies of one shape.
   */
  std::vector<MeasuredShape> read_measured_shapes(const std::string &path);

  /** Reads "Measurement/Shapes file". @p log gets the datasets 55 that are no
   * motions and a warning of those that do not say it. Throws InputError as
   * above, and for a point by name that is not in "Measurement/Points", with
   * the nearest one. */
  std::vector<MeasuredShape> read_measured_shapes(
    const MeasurementParameters &measurement,
    RunLog                      &log);
} // namespace squeal

#endif
