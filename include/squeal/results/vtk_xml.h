// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_vtk_xml_h
#define squeal_results_vtk_xml_h

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /** Pieces of VTK's XML files (.vtu, .pvd). */
  namespace vtk
  {
    /** How hard zlib tries: 1 fast .. 9 small. */
    constexpr int default_compression = 6;

    /**
     * A `<DataArray>` of float, double, int32_t or uint8_t, compressed by zlib
     * and written as base64, so that the file is plain XML. The components of
     * one point or cell follow each other.
     */
    template <typename T>
    std::string data_array(const std::string    &name,
                           const unsigned int    n_components,
                           const std::vector<T> &values,
                           const int compression = default_compression);

    /** One number of a `<FieldData>` block. */
    std::string number(const std::string &name, const double value);

    /** Texts of a `<FieldData>` block. */
    std::string texts(const std::string              &name,
                      const std::vector<std::string> &values);

    /** A `.vtu` file of one piece; the sections hold arrays as made above. */
    struct UnstructuredGrid
    {
      unsigned int n_points = 0, n_cells = 0;
      std::string  field_data, point_data, cell_data, points, cells;
      std::string  vectors; /**< name of the active vectors of the points */
      std::string  scalars; /**< name of the active scalars of the cells */
    };
    void write_vtu(std::ostream &out, const UnstructuredGrid &grid);

    /** A `.pvd` file: times and the files that show them, relative to it. */
    std::string collection(
      const std::vector<std::pair<double, std::string>> &steps);
  } // namespace vtk
} // namespace squeal

#endif
