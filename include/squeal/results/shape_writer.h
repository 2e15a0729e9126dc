// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_shape_writer_h
#define squeal_results_shape_writer_h

#include <squeal/base/output_directory.h>

#include <squeal/results/drawn_bodies.h>

#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /** How shapes are drawn. */
  struct ShapeOptions
  {
    /** Straight pieces that each cell is cut into along each edge. */
    unsigned int n_subdivisions = 2;
    /** Largest drawn displacement over the size of the scene. */
    double display_scale = 0.05;
    /** Write the surface of the bodies (quads) instead of their volume:
     * smaller files that cannot be sliced. */
    bool surface_only = false;
    /** Start the animation where the shape is largest. An eigenvector has no
     * phase of its own; a measured or computed deflection has one. */
    bool align_phase = true;
  };

  /**
   * Writes complex shapes u as one period of motion for ParaView:
   * `<name>.pvd`, which lists `shapes/<name>_00.vtu`, ... (times in periods,
   * 0 <= t < 1; a growth rate is left out).
   *
   * Every VTU holds the undeformed geometry and the point vectors
   * `displacement` = Re(s u e^(i phase)), `displacement_real` and
   * `displacement_imag` of s u, so that "Warp By Vector" with factor 1 shows
   * the shape. s is a complex factor: its modulus makes the largest
   * displacement in the period display_scale x size of the scene, its argument
   * aligns the phase. Cell data: `body` (its number in the scene) and, on
   * several ranks, `subdomain`. Field data: `name`, `body_names`,
   * `frequency_hz`, `phase_rad`, `display_factor` |s| (m per unit of u),
   * `phase_offset_rad` arg(s) and what the caller adds.
   *
   * Numbers are single precision; displacements are rounded to
   * 2^-13 of the largest and positions to 2^-20 of the scene's size, far below
   * what a screen shows, which halves the files.
   *
   * All functions are collective; rank 0 writes. An InputError (the file cannot
   * be written) is thrown on every rank. Make a new writer after refine().
   */
  class ShapeWriter
  {
  public:
    using Metadata = std::vector<std::pair<std::string, double>>;

    ShapeWriter(const Discretization &discretization,
                OutputDirectory      &output,
                const ShapeOptions   &options = ShapeOptions());

    /** Writes a shape given by one column of free unknowns (owned rows) each;
     * @p imaginary may have no columns. @p frequency in Hz. Where @p frames is
     * 0 one picture holds real and imaginary part. Throws ComputationError
     * where the shape is not finite. */
    void write_shape(const std::string &name,
                     const Block       &real,
                     const Block       &imaginary,
                     const double       frequency,
                     const unsigned int frames,
                     const Metadata    &metadata = {});

  private:
    void write_files(const std::string     &name,
                     const Eigen::MatrixXd &displacements,
                     const double           phase_offset,
                     const unsigned int     frames,
                     const std::string     &field_data);

    const Discretization        &discretization;
    OutputDirectory             &output;
    const ShapeOptions           options;
    const DisplayMesh            mesh;
    std::unique_ptr<DrawnBodies> bodies; /**< what all shapes share */
  };

  /** `mode_017_5004Hz`, and `_unstable` where it is so: names sort by number.
   * @p frequency in Hz. */
  std::string shape_name(const unsigned int index,
                         const double       frequency,
                         const bool         unstable);
} // namespace squeal

#endif
