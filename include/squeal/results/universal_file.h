// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_universal_file_h
#define squeal_results_universal_file_h

#include <array>
#include <complex>
#include <iosfwd>
#include <string>
#include <vector>

namespace squeal
{
  /** Characters of a line of text, of which the rest is cut. */
  constexpr std::size_t universal_title_length = 80;

  /** A point and direction as universal files name them. */
  struct UniversalPoint
  {
    std::string  name; /**< at most ten characters are written */
    unsigned int node      = 1;
    int          direction = 3; /**< +-1, +-2, +-3: +-x, +-y, +-z; 0: another */
  };

  /** The direction code of a vector: 0 where it is along no axis. */
  int universal_direction(const std::array<double, 3> &direction);

  /** One frequency response function. */
  struct UniversalFunction
  {
    enum class Quantity
    {
      displacement = 8,
      velocity     = 11,
      acceleration = 12
    };
    UniversalPoint                    response, reference;
    Quantity                          quantity = Quantity::displacement;
    std::array<std::string, 2>        titles; /**< at most 80 characters each */
    std::vector<double>               frequencies;   /**< Hz */
    bool                              evenly = true; /**< spaced */
    std::vector<std::complex<double>> values;
  };

  /** One complex mode at nodes, its eigenvalue in 1/s. */
  struct UniversalShape
  {
    std::string                                      title;
    unsigned int                                     number = 1;
    std::complex<double>                             eigenvalue;
    std::vector<unsigned int>                        nodes;
    std::vector<std::array<std::complex<double>, 3>> values; /**< x, y, z */
  };

  /** @name Datasets of the Universal File Format (SDRC), ASCII, fixed columns;
   * numbers of dataset 58 in double precision. SI units. */
  //@{
  /** Dataset 164: units. */
  void write_universal_units(std::ostream &out);
  /** Dataset 15: places of the nodes, m. */
  void write_universal_nodes(std::ostream                             &out,
                             const std::vector<unsigned int>          &nodes,
                             const std::vector<std::array<double, 3>> &places);
  /** Dataset 58: a function over frequency. */
  void write_universal_function(std::ostream            &out,
                                const UniversalFunction &function);
  /** Dataset 55: displacements of a complex mode. */
  void write_universal_shape(std::ostream &out, const UniversalShape &shape);
  //@}
} // namespace squeal

#endif
