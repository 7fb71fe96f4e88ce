// SPDX-License-Identifier: BSD-3-Clause
#include "ReadPoints.h"

#include "Errors.h"
#include "ImageNames.h"
#include "ReadImage.h"
#include "ReadObj.h"
#include "ReadPly.h"
#include "ReadStl.h"
#include "ReadText.h"
#include "ReadXml.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

namespace
{
std::string lowerCaseExtension(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// @throw InputError  there is no such file, or it may not be read
void checkReadable(const std::string& file)
{
  if (!std::ifstream(file))
  {
    throw InputError(file + ": " + std::strerror(errno));
  }
}

vtkSmartPointer<vtkPolyData> read(const std::string& file, const std::string& extension)
{
  using Read = vtkSmartPointer<vtkPolyData> (*)(const std::string&);
  static const std::pair<const char*, Read> readers[] = {
    { ".ply", readPly },
    { ".stl", readStl },
    { ".obj", readObj },
    { ".vtp", readVtp },
    { ".vtu", readVtu },
    { ".off", readOff },
    { ".xyz", readXyz },
    { ".csv", readXyz },
  };
  for (const auto& [name, reader] : readers)
  {
    if (extension == name)
    {
      return reader(file);
    }
  }
  throw InputError(file + ": can't read '" + extension +
    "' files; convert it to .ply .stl .obj .vtp .vtu .off .xyz or .csv, an image to .vti .mha "
    ".nrrd "
    ".nii.gz or .dcm");
}

bool isFinite(vtkPoints* points, vtkIdType i)
{
  std::array<double, 3> point;
  points->GetPoint(i, point.data());
  return std::all_of(point.begin(), point.end(), [](double value) { return std::isfinite(value); });
}

/// The cells with new numbers for their points, without those that have a point without one (-1).
vtkSmartPointer<vtkCellArray> renumbered(vtkCellArray* cells, const std::vector<vtkIdType>& numbers)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, points);
    std::transform(points->begin(), points->end(), points->begin(),
      [&numbers](vtkIdType point) { return numbers[point]; });
    if (std::find(points->begin(), points->end(), -1) == points->end())
    {
      result->InsertNextCell(points);
    }
  }
  return result;
}

/// Only the finite points, and the polygons of them alone.
vtkSmartPointer<vtkPolyData> finitePart(vtkPolyData* data)
{
  vtkPoints* points = data->GetPoints();
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  vtkNew<vtkPoints> finite;
  finite->SetDataType(points->GetDataType());
  vtkNew<vtkDoubleArray> finiteNormals;
  finiteNormals->SetName("Normals");
  finiteNormals->SetNumberOfComponents(3);
  std::vector<vtkIdType> numbers(points->GetNumberOfPoints(), -1); // of the finite ones
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    if (isFinite(points, i))
    {
      numbers[i] = finite->InsertNextPoint(points->GetPoint(i));
      if (normals)
      {
        finiteNormals->InsertNextTuple(i, normals);
      }
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(finite);
  result->SetPolys(renumbered(data->GetPolys(), numbers));
  result->GetPointData()->SetNormals(normals ? finiteNormals.Get() : nullptr);
  result->GetFieldData()->PassData(data->GetFieldData());
  return result;
}
}

Input readInput(const std::string& file, int series, bool dropInvalid)
{
  checkReadable(file);
  if (imageKind(file) != ImageKind::None)
  {
    return { nullptr, readImage({ file, series }) };
  }
  const auto data = read(file, lowerCaseExtension(file));
  if (!data || !data->GetPoints() || data->GetNumberOfPoints() == 0)
  {
    throw InputError(file + ": there are no points in it");
  }
  vtkPoints* points = data->GetPoints();
  const vtkIdType count = points->GetNumberOfPoints();
  vtkIdType first = count, invalid = 0;
  for (vtkIdType i = count - 1; i >= 0; --i)
  {
    if (!isFinite(points, i))
    {
      first = i;
      ++invalid;
    }
  }
  if (invalid > 0 && !dropInvalid)
  {
    throw InputError(file + ": " + std::to_string(invalid) + " of " + std::to_string(count) +
      " points have a coordinate that is NaN or infinite, the first is point " +
      std::to_string(first) + " (counted from 0); --drop-invalid leaves them out");
  }
  if (invalid == 0)
  {
    return { data, nullptr };
  }
  const auto finite = finitePart(data);
  return { finite, nullptr, invalid, data->GetNumberOfPolys() - finite->GetNumberOfPolys() };
}
