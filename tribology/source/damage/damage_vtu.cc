// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/tribology/damage/damage_files.h>

#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>

namespace squeal::tribology
{
  namespace
  {
    /** Quadrilaterals between the nodes of a grid, else a vertex for each
     * node. */
    void
    add_cells(vtkUnstructuredGrid &vtu, const ContactGrid &grid)
    {
      if (!grid.is_grid())
        {
          for (std::size_t k = 0; k < grid.n_nodes(); ++k)
            {
              const vtkIdType id = vtkIdType(k);
              vtu.InsertNextCell(VTK_VERTEX, 1, &id);
            }
          return;
        }
      for (std::size_t j = 0; j + 1 < grid.n_y(); ++j)
        for (std::size_t i = 0; i + 1 < grid.n_x(); ++i)
          {
            const std::size_t first      = i + grid.n_x() * j;
            const std::size_t corners[4] = {
              first, first + 1, first + 1 + grid.n_x(), first + grid.n_x()};
            std::array<vtkIdType, 4> ids;
            for (int c = 0; c < 4; ++c)
              ids[c] = vtkIdType(grid.order()[corners[c]]);
            vtu.InsertNextCell(VTK_QUAD, 4, ids.data());
          }
    }
  } // namespace



  void
  write_damage_vtu(const std::string &path,
                   const Table       &table,
                   const ContactGrid &grid)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (std::size_t k = 0; k < grid.n_nodes(); ++k)
      points->InsertNextPoint(grid.place(k)[0], grid.place(k)[1], 0.);
    vtkNew<vtkUnstructuredGrid> vtu;
    vtu->SetPoints(points);
    add_cells(*vtu, grid);
    for (const Table::Column &column : table.columns())
      if (column.type == Table::Type::real)
        {
          vtkNew<vtkDoubleArray> values;
          values->SetName(column.name.c_str());
          for (const double value : table.reals(column.name))
            values->InsertNextValue(value);
          vtu->GetPointData()->AddArray(values);
        }
    AtomicFile                           target(path);
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetFileName(target.temporary().c_str());
    writer->SetInputData(vtu);
    if (writer->Write() == 0)
      throw InputError("'" + path +
                       "' could not be written: is the disk full?");
    target.commit();
  }
} // namespace squeal::tribology
