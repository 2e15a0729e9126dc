// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_response_parameters_h
#define squeal_parameters_response_parameters_h

#include <squeal/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace squeal
{
  /** One point and direction where a structure is excited or observed, section
   * "Measurement/Point <name>". */
  struct MeasuredPointParameters
  {
    std::string  name;
    std::string  body;
    Vector3      position{{0., 0., 0.}};  /**< m */
    Vector3      direction{{0., 0., 1.}}; /**< of any length but 0 */
    unsigned int node =
      0; /**< number in exchange files; 0: place in the list */
  };

  /** What was measured and where, section "Measurement". */
  struct MeasurementParameters
  {
    std::vector<MeasuredPointParameters> points;
    std::string shapes_file; /**< UFF with datasets 55, or CSV; empty: none */
    std::string frequencies_file; /**< CSV; empty: none */

    /** Number of a point in exchange files. */
    unsigned int
    node(const unsigned int point) const
    {
      return points[point].node ? points[point].node : point + 1;
    }

    /** Place of a point in the list, or -1. */
    int
    find(const std::string &name) const
    {
      for (unsigned int i = 0; i < points.size(); ++i)
        if (points[i].name == name)
          return i;
      return -1;
    }
  };

  /** "Analysis = frequency response", section "Frequency response". The
   * frequencies are those of the band in section "Eigenvalues". */
  struct FrequencyResponseParameters
  {
    enum class Quantity
    {
      receptance, /**< displacement over force, m/N */
      mobility,   /**< velocity over force, m/(N s) */
      accelerance /**< acceleration over force, m/(N s^2) */
    };
    enum class Residual
    {
      none,
      flexibility,            /**< exact at 0 Hz */
      flexibility_and_inertia /**< exact there and at the top of the band */
    };
    enum class Scale
    {
      linear,
      logarithmic
    };
    Quantity                 quantity = Quantity::receptance;
    std::vector<std::string> excitations, responses; /**< empty: all points */
    /** Contact states of all pairs, one run each; empty: as in the scene. */
    std::vector<ContactParameters::State> states;
    unsigned int                          number = 1001; /**< frequencies */
    Scale                                 scale  = Scale::linear;
    double       margin          = 1.5; /**< modes up to this times the top */
    Residual     residual        = Residual::flexibility_and_inertia;
    unsigned int checks          = 3; /**< frequencies solved directly */
    double       check_tolerance = 1e-3;
  };

  /** One number that is fitted, section "Updating/Parameter <name>". */
  struct UpdatedNumberParameters
  {
    std::string name;
    /** Entries of the scene; all are multiplied by the same factor. */
    std::vector<std::string> entries;
    double                   lower = 0., upper = 0.; /**< of the first entry */
  };

  /** "Analysis = updating", section "Updating". */
  struct UpdatingParameters
  {
    enum class Pairing
    {
      name, /**< by the names of the modes at the start, then by shape */
      shape /**< by MAC with the measured shapes */
    };
    std::vector<UpdatedNumberParameters> numbers;
    Pairing                              pairing             = Pairing::name;
    double                               minimum_mac         = 0.5;
    double                               tolerance           = 1e-5;
    unsigned int                         maximum_evaluations = 60;
    double                               confidence_percent  = 95.;
  };
} // namespace squeal

#endif
