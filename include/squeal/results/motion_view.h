// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_motion_view_h
#define squeal_results_motion_view_h

#include <squeal/results/surface_quads.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * Surfaces that move in a page: turned with the mouse, played and stopped,
   * coloured by a component of the displacement over its largest size.
   * Everything is in the markup, three.js (MIT) in the script; no network is
   * needed.
   *
   * Numbers are kept with 16 bits: positions to 2^-15 of the scene,
   * displacements to 2^-15 of the largest one of their motion.
   */
  class MotionView
  {
  public:
    /**
     * @param quads  the surfaces, undeformed
     * @param bodies their names
     * @param drawn_largest how far the largest displacement is drawn, m
     */
    MotionView(const std::vector<SurfaceQuad> &quads,
               const std::vector<std::string> &bodies,
               const double                    drawn_largest);

    /** Adds Re((real + i imaginary) e^(i phase)), phase from 0 to 2 pi, of the
     * surfaces of the constructor in the same order. */
    void add_harmonic(const std::string              &name,
                      const std::vector<SurfaceQuad> &real,
                      const std::vector<SurfaceQuad> &imaginary);

    /** Adds the moments of a motion, evenly spaced in time. */
    void add_frames(const std::string                           &name,
                    const std::vector<std::vector<SurfaceQuad>> &frames);

    std::size_t n_motions() const;
    std::size_t n_points() const;

    /** A figure; @p still: markup that is shown until the view runs, and where
     * the browser has no WebGL. */
    std::string markup(const std::string &caption,
                       const std::string &still) const;

    /** What the page needs once, with three.js; empty where that is not
     * installed, and then markup() shows nothing but the still picture. */
    static std::string script();

  private:
    struct Motion
    {
      std::string              name;
      bool                     harmonic;
      std::vector<std::string> frames; /**< base64, 16-bit vectors of points */
    };

    /** Displacements of the points, x, y, z of each, m. */
    std::vector<double> at_points(const std::vector<SurfaceQuad> &quads) const;

    static std::string packed(const std::vector<double> &values,
                              const double               largest);

    std::vector<std::string>                body_names;
    std::vector<double>                     points; /**< m, from the middle */
    double                                  reach = 0., drawn = 0.;
    std::vector<std::vector<std::uint32_t>> quads_of; /**< of each body */
    /** Quad and corner of each point, and how many quads there are. */
    std::vector<std::pair<std::size_t, unsigned int>> source;
    std::size_t                                       n_quads;
    std::vector<Motion>                               motions;
  };
} // namespace squeal

#endif
