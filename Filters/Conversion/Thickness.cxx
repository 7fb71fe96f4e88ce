// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Thickness.h"

#include "Base/Errors.h"
#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Balls.h"
#include "Conversion/Cells.h"
#include "Conversion/Parts.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace medial
{
namespace
{
void addPlaces(const ThicknessReport& report, vtkPointData* data)
{
  add<vtkDoubleArray>(data, names::Thickness, report.inside.diameters);
  add<vtkIdTypeArray>(data, names::ThicknessBall, report.inside.balls);
  if (!report.outside.balls.empty())
  {
    add<vtkDoubleArray>(data, names::Separation, report.outside.diameters);
    add<vtkIdTypeArray>(data, names::SeparationBall, report.outside.balls);
  }
  data->SetActiveScalars(names::Thickness);
}

/// A row for each quantity and each way to weigh: first over the volume, then others.
void addMeans(
  const VolumeThickness& volume, const std::vector<Distribution>& others, vtkTable* table)
{
  std::vector<std::string> quantities{ names::Thickness, names::Separation, names::Thickness,
    names::Separation, names::Thickness };
  std::vector<std::string> weights{ "volume", "volume", "places", "places", "balls" };
  std::vector<Distribution> rows{ volume.thickness, volume.separation };
  rows.insert(rows.end(), others.begin(), others.end());
  quantities.resize(rows.size());
  weights.resize(rows.size());
  vtkFieldData* data = table->GetRowData();
  addTexts(data, names::Quantity, quantities);
  addTexts(data, names::Weight, weights);
  add<vtkDoubleArray>(data, names::Mean, rows, &Distribution::mean);
  add<vtkDoubleArray>(data, names::Deviation, rows, &Distribution::deviation);
  add<vtkDoubleArray>(data, names::Minimum, rows, &Distribution::smallest);
  add<vtkDoubleArray>(data, names::Maximum, rows, &Distribution::largest);
  add<vtkIdTypeArray>(data, names::Number, rows, &Distribution::number);
  data->AddArray(
    tuples<vtkIdTypeArray>(names::Histogram, static_cast<int>(Distribution().histogram.size()),
      rows, [](const Distribution& row) { return row.histogram; }));
  addOne<vtkDoubleArray>(table->GetFieldData(), names::Margin, volume.margin);
  addOne<vtkDoubleArray>(table->GetFieldData(), names::VolumeShare, volume.share);
}

/// The part of each point of an axis: the lowest of its cells; empty where there are no parts.
std::vector<Index> partOfPoints(vtkPolyData* axis)
{
  const std::vector<Index> parts = readParts(axis);
  std::vector<Index> result;
  if (parts.empty())
  {
    return result;
  }
  result.assign(axis->GetNumberOfPoints(), None);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < axis->GetNumberOfCells(); ++cell)
  {
    axis->GetCellPoints(cell, corners);
    for (const vtkIdType point : *corners)
    {
      Index& part = result[point];
      part = part == None ? parts[cell] : std::min(part, parts[cell]);
    }
  }
  return result;
}

void addThinPlaces(const std::vector<ThinPlace>& places, vtkPolyData* axis, vtkTable* table)
{
  vtkFieldData* data = table->GetRowData();
  data->AddArray(tuples<vtkDoubleArray>(names::Place, 3, places, [axis](const ThinPlace& place) {
    std::array<double, 3> at;
    axis->GetPoint(place.point, at.data());
    return at;
  }));
  add<vtkDoubleArray>(data, names::Thickness, places, &ThinPlace::thickness);
  add<vtkDoubleArray>(data, names::Depth, places, &ThinPlace::depth);
  add<vtkIdTypeArray>(data, names::AxisPoint, places, &ThinPlace::point);
  const std::vector<Index> parts = partOfPoints(axis);
  if (!parts.empty())
  {
    add<vtkIdTypeArray>(
      data, names::PartId, places, [&](const ThinPlace& place) { return parts[place.point]; });
  }
}
}

std::vector<Point> readPlaces(vtkDataSet* input)
{
  std::vector<Point> result(input->GetNumberOfPoints());
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    input->GetPoint(static_cast<vtkIdType>(i), result[i].data());
    if (!result[i].allFinite())
    {
      throw InvalidInput("point ", i,
        " of the places to measure at has a coordinate that is not "
        "finite: drop it, or give other places");
    }
  }
  return result;
}

void writeMeans(const VolumeThickness& volume, vtkTable* means)
{
  addMeans(volume, {}, means);
}

void write(const ThicknessReport& report, const PolarBalls& made, vtkUnstructuredGrid* balls,
  vtkDataSet* places, vtkPolyData* axis, vtkDataSet* measured, vtkTable* means,
  vtkTable* thinPlaces)
{
  if (places)
  {
    measured->ShallowCopy(places);
    vtkNew<vtkFieldData> field; // of all inputs; that of the places comes first
    passFieldData(balls, field);
    if (axis)
    {
      field->PassData(axis->GetFieldData());
    }
    field->PassData(places->GetFieldData());
    measured->SetFieldData(field);
  }
  else
  {
    vtkPolyData* samples = vtkPolyData::SafeDownCast(measured);
    samples->SetPoints(points(made.samples));
    samples->SetVerts(vertexForEach(count(made.samples)));
    passFieldData(balls, samples->GetFieldData());
  }
  addPlaces(report, measured->GetPointData());
  addMeans(report.volume,
    { distribution(known(report.inside.diameters)), distribution(known(report.outside.diameters)),
      report.ofBalls },
    means);
  if (axis)
  {
    addThinPlaces(report.thin, axis, thinPlaces);
  }
}
}
