// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceBytes.h"

#include "Errors.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

namespace
{
/// Polygons one after another.
struct Corners
{
  std::vector<vtkIdType> ends; ///< of each polygon
  std::vector<vtkIdType> points;

  template <typename Iterator>
  void add(Iterator begin, Iterator end)
  {
    if (end - begin >= 3)
    {
      this->points.insert(this->points.end(), begin, end);
      this->ends.push_back(static_cast<vtkIdType>(this->points.size()));
    }
  }
};

/// VTK's readers take offsets as they are in the file.
void checkOffsets(vtkCellArray* cells)
{
  vtkDataArray* offsets = cells->GetOffsetsArray();
  double last = 0;
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    const double offset = offsets->GetComponent(i, 0);
    if (offset < last || (i == 0 && offset != 0))
    {
      throw InputError("the offsets of its cells don't ascend; correct them");
    }
    last = offset;
  }
  const vtkIdType corners = cells->GetConnectivityArray()->GetNumberOfValues();
  if (last != static_cast<double>(corners))
  {
    throw InputError("the offsets of its cells end at " + std::to_string(vtkIdType(last)) +
      ", but they have " + std::to_string(corners) + " corners; correct them");
  }
}

void addStrip(vtkIdList* strip, Corners& corners)
{
  for (vtkIdType i = 2; i < strip->GetNumberOfIds(); ++i)
  {
    const vtkIdType a = strip->GetId(i - 2), b = strip->GetId(i - 1);
    const bool isTurned = i % 2 != 0; // every other triangle
    const std::array<vtkIdType, 3> triangle = { isTurned ? b : a, isTurned ? a : b,
      strip->GetId(i) };
    corners.add(triangle.begin(), triangle.end());
  }
}

void addCell(int type, vtkIdList* cell, Corners& corners)
{
  switch (type)
  {
    case VTK_TRIANGLE_STRIP:
      addStrip(cell, corners);
      break;
    case VTK_PIXEL:
      if (cell->GetNumberOfIds() == 4)
      {
        std::swap(*cell->GetPointer(2), *cell->GetPointer(3)); // so that they go around
      }
      corners.add(cell->begin(), cell->end());
      break;
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_POLYGON:
      corners.add(cell->begin(), cell->end());
      break;
    default:
      break;
  }
}

template <typename TypeOf>
void addCells(vtkCellArray* cells, const TypeOf& typeOf, Corners& corners)
{
  checkOffsets(cells);
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, cell);
    addCell(typeOf(i), cell, corners);
  }
}

Corners cornersOf(vtkPointSet* data)
{
  Corners result;
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    addCells(
      surface->GetPolys(), [](vtkIdType) { return VTK_POLYGON; }, result);
    addCells(
      surface->GetStrips(), [](vtkIdType) { return VTK_TRIANGLE_STRIP; }, result);
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (grid && grid->GetCells())
  {
    vtkUnsignedCharArray* types = grid->GetCellTypesArray();
    const vtkIdType count = types ? types->GetNumberOfValues() : 0;
    if (count != grid->GetCells()->GetNumberOfCells())
    {
      throw InputError("it has " + std::to_string(grid->GetCells()->GetNumberOfCells()) +
        " cells, but types for " + std::to_string(count));
    }
    addCells(
      grid->GetCells(), [types](vtkIdType i) { return types->GetValue(i); }, result);
  }
  return result;
}

/// What the bytes begin with. The coordinates follow, the normals, where the corners of each polygon end, and the
/// corners.
struct Header
{
  int type; ///< of coordinates
  int hasNormals;
  vtkIdType points, polygons, corners;

  std::size_t coordinateSize() const
  {
    return 3 * (this->type == VTK_FLOAT ? sizeof(float) : sizeof(double));
  }

  std::size_t normalsSize() const { return this->hasNormals * 3 * sizeof(double) * this->points; }
};

void append(std::string& bytes, const void* values, std::size_t size)
{
  bytes.append(static_cast<const char*>(values), size);
}

/// Copies the next bytes, and goes on behind them.
void take(const char*& from, void* values, std::size_t size)
{
  std::memcpy(values, from, size);
  from += size;
}

/// The normals of points as doubles; none where there is no such array.
vtkSmartPointer<vtkDoubleArray> normalsOf(vtkPointSet* data)
{
  auto result = vtkSmartPointer<vtkDoubleArray>::New();
  vtkDataArray* given = data ? data->GetPointData()->GetArray("Normals") : nullptr;
  if (given)
  {
    result->DeepCopy(given);
    if (given->GetNumberOfComponents() != 3 ||
      given->GetNumberOfTuples() != data->GetNumberOfPoints())
    {
      throw InputError("its array 'Normals' has not three numbers for each point; correct it");
    }
  }
  return result;
}

void checkCorners(const std::string& file, const Corners& corners, vtkIdType points)
{
  const auto missing = std::find_if(corners.points.begin(), corners.points.end(),
    [points](vtkIdType p) { return p < 0 || p >= points; });
  if (missing != corners.points.end())
  {
    throw InputError(file + ": a cell names point " + std::to_string(*missing) +
      ", but there are " + std::to_string(points) + ", numbered from 0; correct it");
  }
}
}

std::string bytesOf(vtkPointSet* data)
{
  vtkNew<vtkPoints> points; // in plain order, and not of integers
  vtkPoints* given = data ? data->GetPoints() : nullptr;
  points->SetDataType(given && given->GetDataType() == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
  if (given)
  {
    points->DeepCopy(given);
  }
  const Corners corners = cornersOf(data);
  const vtkSmartPointer<vtkDoubleArray> normals = normalsOf(data);
  const Header header = { points->GetDataType(), normals->GetNumberOfValues() > 0,
    points->GetNumberOfPoints(), static_cast<vtkIdType>(corners.ends.size()),
    static_cast<vtkIdType>(corners.points.size()) };
  std::string bytes;
  append(bytes, &header, sizeof header);
  append(bytes, points->GetVoidPointer(0), header.coordinateSize() * header.points);
  append(bytes, normals->GetVoidPointer(0), header.normalsSize());
  append(bytes, corners.ends.data(), sizeof(vtkIdType) * corners.ends.size());
  append(bytes, corners.points.data(), sizeof(vtkIdType) * corners.points.size());
  return bytes;
}

vtkSmartPointer<vtkPolyData> surfaceOf(const std::string& file, const std::string& bytes)
{
  Header header;
  const char* from = bytes.data();
  take(from, &header, sizeof header);
  vtkNew<vtkPoints> points;
  points->SetDataType(header.type);
  points->SetNumberOfPoints(header.points);
  take(from, points->GetVoidPointer(0), header.coordinateSize() * header.points);
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(header.points);
  take(from, normals->GetVoidPointer(0), header.normalsSize());
  Corners corners;
  corners.ends.resize(header.polygons);
  take(from, corners.ends.data(), sizeof(vtkIdType) * corners.ends.size());
  corners.points.resize(header.corners);
  take(from, corners.points.data(), sizeof(vtkIdType) * corners.points.size());
  checkCorners(file, corners, header.points);
  vtkNew<vtkCellArray> polygons;
  vtkIdType begin = 0;
  for (const vtkIdType end : corners.ends)
  {
    polygons->InsertNextCell(end - begin, &corners.points[begin]);
    begin = end;
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(polygons);
  result->GetPointData()->SetNormals(header.hasNormals ? normals.Get() : nullptr);
  return result;
}
