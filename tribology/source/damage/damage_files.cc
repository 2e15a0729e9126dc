// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/files.h>
#include <squeal/results/hdf5_file.h>
#include <squeal/results/vtk_xml.h>
#include <squeal/tribology/damage/damage_files.h>

#include <ostream>

namespace squeal::tribology
{
  void
  write_damage_hdf5(const std::string   &path,
                    const Table         &table,
                    const HistoryDamage &damage)
  {
    AtomicFile target(path);
    Hdf5File   file(target.temporary(), Hdf5File::Mode::create);
    file.write_attribute("format", "squeal damage map");
    file.write_attribute("format_version", 1.);
    file.write_attribute("duration_s", damage.duration);
    const std::uint64_t n = table.n_rows();
    for (const Table::Column &column : table.columns())
      file.write("nodes/" + column.name, {n}, table.reals(column.name));
    const std::uint64_t m = damage.matrices[0].n_classes();
    std::vector<double> ranges, means, counts;
    for (std::uint64_t i = 0; i < m; ++i)
      {
        ranges.push_back(damage.matrices[0].range(i));
        means.push_back(damage.matrices[0].mean(i));
      }
    for (const RangeMeanMatrix &matrix : damage.matrices)
      counts.insert(
        counts.end(), matrix.values().begin(), matrix.values().end());
    file.write("range_mean/range_pa", {m}, ranges);
    file.write("range_mean/mean_pa", {m}, means);
    file.write("range_mean/cycles", {n, m, m}, counts);
    file.close();
    target.commit();
  }



  void
  write_damage_vtu(const std::string &path,
                   const Table       &table,
                   const ContactGrid &grid)
  {
    vtk::UnstructuredGrid vtu;
    std::vector<double>   places;
    for (std::size_t k = 0; k < grid.n_nodes(); ++k)
      places.insert(places.end(), {grid.place(k)[0], grid.place(k)[1], 0.});
    std::vector<int> connectivity, offsets;
    std::size_t      n_cells = 0;
    if (grid.is_grid())
      for (std::size_t j = 0; j + 1 < grid.n_y(); ++j)
        for (std::size_t i = 0; i + 1 < grid.n_x(); ++i)
          {
            const std::size_t first = i + grid.n_x() * j;
            for (const std::size_t corner :
                 {first, first + 1, first + 1 + grid.n_x(), first + grid.n_x()})
              connectivity.push_back(static_cast<int>(grid.order()[corner]));
            offsets.push_back(static_cast<int>(connectivity.size()));
            ++n_cells;
          }
    else
      for (; n_cells < grid.n_nodes(); ++n_cells)
        {
          connectivity.push_back(static_cast<int>(n_cells));
          offsets.push_back(static_cast<int>(n_cells + 1));
        }
    // VTK_QUAD or VTK_VERTEX
    const std::vector<std::uint8_t> types(n_cells, grid.is_grid() ? 9 : 1);
    vtu.n_points = static_cast<unsigned int>(grid.n_nodes());
    vtu.n_cells  = static_cast<unsigned int>(n_cells);
    vtu.points   = vtk::data_array("points", 3, places);
    vtu.cells    = vtk::data_array("connectivity", 1, connectivity) +
                vtk::data_array("offsets", 1, offsets) +
                vtk::data_array("types", 1, types);
    for (const Table::Column &column : table.columns())
      if (column.type == Table::Type::real)
        vtu.point_data +=
          vtk::data_array(column.name, 1, table.reals(column.name));
    write_atomically(path,
                     [&](std::ostream &out) { vtk::write_vtu(out, vtu); });
  }
} // namespace squeal::tribology
