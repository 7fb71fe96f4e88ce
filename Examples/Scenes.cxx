// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "Errors.h"
#include "Ramp.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMapper.h>
#include <vtkMath.h>
#include <vtkMedialPartDecomposition.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVertexGlyphFilter.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace
{
vtkSmartPointer<vtkActor> actorOf(vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

/// An actor whose cells have these colours.
vtkSmartPointer<vtkActor> colouredActor(vtkPolyData* data, vtkUnsignedCharArray* ofCells)
{
  vtkNew<vtkPolyData> coloured;
  coloured->CopyStructure(data);
  coloured->GetCellData()->SetScalars(ofCells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(coloured);
  mapper->SetScalarModeToUseCellData();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

/// Sheets are seen from both sides, so much of their light is ambient: it does not depend on the side.
void lookLikeSheets(vtkActor* actor, double scale)
{
  vtkProperty* look = actor->GetProperty();
  look->SetAmbient(0.42);
  look->SetDiffuse(0.68);
  look->SetInterpolationToFlat();
  look->SetLineWidth(static_cast<float>(1.5 * scale));
  look->SetPointSize(static_cast<float>(3 * scale));
}

void colourByPoints(vtkMapper* mapper, const char* array, double lower, double upper)
{
  mapper->ScalarVisibilityOn();
  mapper->SetLookupTable(ramp(lower, upper, false));
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(array);
  mapper->InterpolateScalarsBeforeMappingOn();
}

/// A closed surface without facets.
vtkSmartPointer<vtkActor> smoothActor(vtkPolyData* surface)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->ConsistencyOff(); // the crust is oriented already
  normals->SetFeatureAngle(45);
  return actorOf(normals);
}

/// Dark for the nearest sample, pale for the farthest.
vtkSmartPointer<vtkUnsignedCharArray> depthColors(
  vtkPolyData* samples, const double towardsViewer[3])
{
  const vtkIdType count = samples->GetNumberOfPoints();
  std::vector<double> nearness(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    nearness[i] = vtkMath::Dot(samples->GetPoint(i), towardsViewer);
  }
  const auto [farthest, nearest] = std::minmax_element(nearness.begin(), nearness.end());
  const double range = std::max(*nearest - *farthest, std::numeric_limits<double>::min());
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
  for (double value : nearness)
  {
    const double pale = (*nearest - value) / range;
    colors->InsertNextTuple3(30 + 185 * pale, 50 + 170 * pale, 90 + 140 * pale);
  }
  return colors;
}

/// The library's colour of a part, in bytes.
std::array<unsigned char, 3> partColor(vtkIdType part)
{
  double rgb[3];
  vtkMedialPartDecomposition::GetPartColor(part, rgb);
  return { static_cast<unsigned char>(255 * rgb[0]), static_cast<unsigned char>(255 * rgb[1]),
    static_cast<unsigned char>(255 * rgb[2]) };
}
}

vtkSmartPointer<vtkActor> samplesActor(
  vtkPolyData* samples, const double towardsViewer[3], double scale)
{
  vtkNew<vtkPolyData> shaded;
  shaded->CopyStructure(samples);
  shaded->GetPointData()->SetScalars(depthColors(samples, towardsViewer));
  vtkNew<vtkVertexGlyphFilter> vertices;
  vertices->SetInputData(shaded);
  auto actor = actorOf(vertices);
  actor->GetMapper()->ScalarVisibilityOn();
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetPointSize(static_cast<float>(1.6 * scale));
  return actor;
}

vtkSmartPointer<vtkActor> axisActor(vtkPolyData* axis, double scale)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(axis);
  if (vtkDataArray* radius = axis->GetPointData()->GetArray("Radius"))
  {
    colourByPoints(mapper, "Radius", radius->GetRange()[0], radius->GetRange()[1]);
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  lookLikeSheets(actor, scale);
  return actor;
}

vtkSmartPointer<vtkActor> partsActor(vtkPolyData* parts, double scale)
{
  vtkDataArray* partId = parts->GetCellData()->GetArray("PartId");
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(parts->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < parts->GetNumberOfCells(); ++cell)
  {
    const auto part = static_cast<vtkIdType>(partId->GetTuple1(cell));
    colors->SetTypedTuple(cell, partColor(part).data());
  }
  auto actor = colouredActor(parts, colors);
  lookLikeSheets(actor, scale);
  return actor;
}

vtkSmartPointer<vtkActor> arrayActor(vtkPolyData* axis, const std::string& array, double scale)
{
  vtkDataArray* values = axis->GetCellData()->GetArray(array.c_str());
  if (!values)
  {
    throw InputError("there is no array " + array + " on the cells");
  }
  if (array == "PartId")
  {
    return partsActor(axis, scale);
  }
  const double largest = std::max(values->GetRange()[1], std::numeric_limits<double>::min());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(axis);
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray(array.c_str());
  mapper->SetLookupTable(ramp(std::max(values->GetRange()[0], largest / 1000), largest, true));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  lookLikeSheets(actor, scale);
  return actor;
}

vtkSmartPointer<vtkActor> surfaceActor(vtkPolyData* surface)
{
  auto actor = smoothActor(surface);
  vtkProperty* look = actor->GetProperty();
  look->SetColor(0.97, 0.93, 0.86);
  look->SetAmbient(0.18);
  look->SetDiffuse(0.9);
  look->SetSpecular(0.15);
  look->SetSpecularPower(25);
  return actor;
}

vtkSmartPointer<vtkActor> thickSurfaceActor(vtkPolyData* surface, double top)
{
  auto actor = smoothActor(surface);
  colourByPoints(actor->GetMapper(), "Thickness", 0, top);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.7);
  return actor;
}

vtkSmartPointer<vtkActor> thickAxisActor(vtkPolyData* axis, double top, double scale)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(axis);
  colourByPoints(mapper, "Thickness", 0, top);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  lookLikeSheets(actor, scale);
  return actor;
}
