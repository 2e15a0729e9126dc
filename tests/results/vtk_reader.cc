// SPDX-License-Identifier: LGPL-2.1-or-later

// vtk_reader DIRECTORY [FIELD...]
//
// VTK itself, which ParaView reads files with, opens every .pvd and .vtu below
// a directory without a complaint and finds the named point vectors and the
// cell data "body" in them. Fails when there is no file.

#include <vtkCallbackCommand.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUtilities.h>

#include "check.h"

#include <filesystem>
#include <map>
#include <set>
#include <vector>

using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  void
  complain(vtkObject *, unsigned long, void *file, void *text)
  {
    check(false,
          *static_cast<std::string *>(file) + ": " +
            (text ? static_cast<const char *>(text) : "error"));
  }

  void
  check_values(vtkDataArray *array, const int n_tuples, const std::string &what)
  {
    check(array->GetNumberOfTuples() == n_tuples, what + ": a value for each");
    for (int i = 0; i < n_tuples; ++i)
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        if (!std::isfinite(array->GetComponent(i, c)))
          check(false, what + ": finite values");
  }

  /** Number of points of the grid. */
  int
  check_vtu(const fs::path &path, const std::vector<std::string> &fields)
  {
    std::string                          name = path.string();
    vtkNew<vtkCallbackCommand>           observer;
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    observer->SetCallback(complain);
    observer->SetClientData(&name);
    for (const auto event : {vtkCommand::ErrorEvent, vtkCommand::WarningEvent})
      reader->AddObserver(event, observer);
    reader->SetParserErrorObserver(observer);
    reader->SetReaderErrorObserver(observer);
    check(reader->CanReadFile(name.c_str()), name + " is a VTU");
    reader->SetFileName(name.c_str());
    reader->Update();
    vtkUnstructuredGrid *grid     = reader->GetOutput();
    const int            n_points = grid->GetNumberOfPoints();
    const int            n_cells  = grid->GetNumberOfCells();
    check(n_points > 0 && n_cells > 0, name + ": points and cells");
    for (int i = 0; i < n_cells; ++i)
      {
        vtkCell *cell = grid->GetCell(i);
        for (int v = 0; v < cell->GetNumberOfPoints(); ++v)
          if (cell->GetPointId(v) < 0 || cell->GetPointId(v) >= n_points)
            check(false, name + ": corners are points");
        if (!(cell->GetLength2() > 0.))
          check(false, name + ": cells have a size");
      }
    for (const auto &field : fields)
      {
        vtkDataArray *array = grid->GetPointData()->GetArray(field.c_str());
        if (array == nullptr)
          check(false, name + ": point data " + field);
        check(array->GetNumberOfComponents() == 3,
              name + ": " + field + " is a vector");
        check_values(array, n_points, name + ": " + field);
      }
    if (!fields.empty())
      {
        vtkDataArray *vectors = grid->GetPointData()->GetVectors();
        check(vectors != nullptr && fields[0] == vectors->GetName(),
              name + ": the warp takes " + fields[0]);
      }
    vtkDataArray *body = grid->GetCellData()->GetArray("body");
    check(body != nullptr, name + ": cell data body");
    check_values(body, n_cells, name + ": body");
    return n_points;
  }

  /** Files that a collection lists, in order of ascending time. */
  std::vector<fs::path>
  files_of_collection(const fs::path &path)
  {
    const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
      vtkXMLUtilities::ReadElementFromFile(path.c_str()));
    check(root != nullptr && std::string(root->GetName()) == "VTKFile" &&
            std::string(root->GetAttribute("type")) == "Collection",
          path.string() + " is a collection");
    vtkXMLDataElement *list = root->FindNestedElementWithName("Collection");
    check(list != nullptr && list->GetNumberOfNestedElements() > 0,
          path.string() + " lists files");
    std::vector<fs::path> files;
    double                last = -1.;
    for (int i = 0; i < list->GetNumberOfNestedElements(); ++i)
      {
        vtkXMLDataElement *entry = list->GetNestedElement(i);
        double             time  = -1.;
        check(entry->GetScalarAttribute("timestep", time) && time > last,
              path.string() + ": times ascend");
        last = time;
        files.push_back(path.parent_path() / entry->GetAttribute("file"));
        check(fs::exists(files.back()), files.back().string() + " exists");
      }
    return files;
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc >= 2, "a directory is given");
  const std::vector<std::string> fields(argv + 2, argv + argc);
  std::map<fs::path, int>        n_points;
  std::vector<fs::path>          collections;
  for (const auto &entry : fs::recursive_directory_iterator(argv[1]))
    if (entry.path().extension() == ".vtu")
      n_points[entry.path().lexically_normal()] =
        check_vtu(entry.path(), fields);
    else if (entry.path().extension() == ".pvd")
      collections.push_back(entry.path());
  check(!n_points.empty(), "there are files to open");
  for (const auto &path : collections)
    {
      std::set<int> numbers;
      for (const auto &file : files_of_collection(path))
        numbers.insert(n_points.at(file.lexically_normal()));
      check(numbers.size() == 1, path.string() + ": frames of one grid");
    }
}
