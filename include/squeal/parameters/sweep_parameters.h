// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_sweep_parameters_h
#define squeal_parameters_sweep_parameters_h

#include <string>
#include <vector>

namespace squeal
{
  /**
   * One direction of a sweep, section "Sweep/Axis <name>": one number of the
   * scene, or several that move together.
   */
  struct SweepAxisParameters
  {
    enum class Scale
    {
      logarithmic, /**< From to To in equal ratios */
      linear,      /**< From to To in equal steps */
      list         /**< the Values, one after the other */
    };
    std::string name;
    /** Entries such as "Scene/Body pad/Young modulus"; all of them move
     * together. */
    std::vector<std::string> entries;
    Scale                    scale = Scale::linear;
    /** One number for all entries or one for each. */
    std::vector<double> from, to;
    unsigned int        number = 11;
    /** Values of `list`, the same for all entries unless these have some of
     * their own. */
    std::vector<double> values;
    /** What the entries are at those values: all of the first entry, then all
     * of the second; empty: the values themselves. */
    std::vector<double> entry_values;
    /** How the axis scatters in production, between its lowest and highest
     * value. */
    enum class Distribution
    {
      uniform, /**< in the coordinate: in the logarithm on a logarithmic axis */
      normal   /**< cut off at the ends */
    };
    Distribution distribution = Distribution::uniform;
    /** Of `normal`, in the coordinate (decades on a logarithmic axis); a
     * deviation of 0 stands for a sixth of the range about its middle. */
    double mean = 0., deviation = 0.;
    /** What tables and charts of a campaign show of a value. */
    enum class ShownAs
    {
      value,            /**< in the unit of the entry */
      common_logarithm, /**< of the value in that unit */
      milli,            /**< in a thousandth of the unit */
      kilo,             /**< in a thousand of it */
      mega,
      giga
    };
    ShownAs shown_as = ShownAs::value;
  };

  /** Parameter sweep on a certified basis, section "Sweep". */
  struct SweepParameters
  {
    std::vector<SweepAxisParameters> axes;
    double       frequency_tolerance = 1e-6; /**< relative */
    double       sigma_tolerance     = 0.5;  /**< 1/s */
    unsigned int maximum_basis       = 2000;
    /** HDF5 file of the basis in the output directory; empty: basis.h5. */
    std::string basis_file;
    bool        reuse_basis    = true;
    double      edge_tolerance = 1e-5; /**< decades, or share of the range */
    bool        exceptional_points = true;
    /** Stated tolerance of the boundary of a two-parameter map, in shares of
     * either range; 0: no map. */
    double       boundary_tolerance = 0.;
    unsigned int direct_checks      = 0;
    bool         compare            = false;
    /** Entries whose influence on unstable pairs is reported; empty: none. */
    std::vector<std::string> sensitivities;
    /** Unstable ranges, those of the largest sigma first, for which a change
     * that stops the squeal is sought and checked directly; 0: none. */
    unsigned int suggestions = 0;
    /** Share by which such a change may raise or lower a number. */
    double largest_change = 0.5;
    /** Samples of the squeal probability; 0: none. */
    unsigned int scatter_samples = 0;
    unsigned int scatter_seed    = 1;
  };
} // namespace squeal

#endif
