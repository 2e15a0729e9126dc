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
    /** Quadrilaterals between the nodes, or a vertex for each where none are
     * known. */
    void
    add_cells(vtkUnstructuredGrid &vtu, const ContactGrid &grid)
    {
      for (const auto &quad : grid.quads())
        {
          const std::array<vtkIdType, 4> ids = {
            {quad[0], quad[1], quad[2], quad[3]}};
          vtu.InsertNextCell(VTK_QUAD, 4, ids.data());
        }
      if (grid.quads().empty())
        for (std::size_t k = 0; k < grid.n_nodes(); ++k)
          {
            const vtkIdType id = vtkIdType(k);
            vtu.InsertNextCell(VTK_VERTEX, 1, &id);
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
