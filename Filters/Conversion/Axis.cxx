// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Axis.h"

#include "Base/Errors.h"
#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/AxisChecks.h"
#include "Conversion/Balls.h"
#include "Conversion/Cells.h"
#include "Conversion/Remedies.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace medial
{
namespace
{
AxisCells readAxisCells(vtkPolyData* input, Index pointCount)
{
  if (input->GetNumberOfStrips() > 0)
  {
    throw InvalidInput("the axis has triangle strips: ", TakeMedialAxis);
  }
  toIndex(input->GetNumberOfCells(), "cells");
  AxisCells result;
  for (const std::array<Index, 1>& vertex :
    readCells<1>(input->GetVerts(), pointCount, TakeMedialAxis))
  {
    result.vertices.push_back(vertex[0]);
  }
  result.edges = readCells<2>(input->GetLines(), pointCount, TakeMedialAxis);
  result.triangles = readCells<3>(input->GetPolys(), pointCount, TakeMedialAxis);
  return result;
}

bool sameNumbers(vtkDataArray* a, vtkDataArray* b)
{
  if (!a || !b || a->GetNumberOfTuples() != b->GetNumberOfTuples() ||
    a->GetNumberOfComponents() != 1 || b->GetNumberOfComponents() != 1)
  {
    return false;
  }
  for (vtkIdType i = 0; a != b && i < a->GetNumberOfTuples(); ++i)
  {
    if (a->GetComponent(i, 0) != b->GetComponent(i, 0))
    {
      return false;
    }
  }
  return true;
}

/// Is each point of the axis that has a ball at the ball's centre? Volumes alone don't tell objects
/// apart that differ by their place only. Neither axis nor balls have been checked: damaged numbers of
/// balls, too many or too few of them, are left to readMedialAxis.
bool pointsAreCenters(vtkPolyData* axis, vtkUnstructuredGrid* balls)
{
  vtkDataArray* ids = axis->GetPointData()->GetArray(names::BallId);
  const vtkIdType idCount = ids ? ids->GetNumberOfTuples() : 0;
  for (vtkIdType i = 0; i < std::min(idCount, axis->GetNumberOfPoints()); ++i)
  {
    const double ball = ids->GetComponent(i, 0);
    if (ball >= 0 && ball < static_cast<double>(balls->GetNumberOfPoints()) &&
      Point(axis->GetPoint(i)) != Point(balls->GetPoint(static_cast<vtkIdType>(ball))))
    {
      return false;
    }
  }
  return true;
}

Index offAxisBalls(const std::vector<Index>& ballOwner)
{
  Index result = 0;
  for (Index ball = 0; ball < count(ballOwner); ++ball)
  {
    result += ballOwner[ball] != None && ballOwner[ball] != ball;
  }
  return result;
}
}

void addTopology(vtkFieldData* field, const MedialAxis& axis)
{
  addBetti(field, names::BettiAxis, axis.betti);
  addOne<vtkUnsignedCharArray>(field, names::Certificate, axis.certificate);
}

void write(const MedialAxis& axis, vtkUnstructuredGrid* balls, vtkPolyData* output)
{
  std::vector<std::array<Index, 1>> vertices;
  for (const Index point : axis.cells.vertices)
  {
    vertices.push_back({ point });
  }
  output->SetPoints(points(axis.points));
  output->SetVerts(cellArray(vertices));
  output->SetLines(cellArray(axis.cells.edges));
  output->SetPolys(cellArray(axis.cells.triangles));
  vtkPointData* pointData = output->GetPointData();
  add<vtkIdTypeArray>(pointData, names::BallId, axis.ballOfPoint);
  add<vtkDoubleArray>(pointData, names::Radius, axis.radii);
  add<vtkDoubleArray>(pointData, names::MaximumInscribedSphereRadius, axis.radii);
  add<vtkDoubleArray>(pointData, names::ErosionThickness, axis.erosion);
  vtkCellData* cells = output->GetCellData();
  add<vtkIdTypeArray>(cells, names::PolygonId, axis.polygonOfCell);
  cells->AddArray(tuples<vtkIdTypeArray>(names::SiteSamples, 2, axis.samplesOfCell));
  add<vtkDoubleArray>(cells, names::ObjectAngle, axis.siteViews, &SiteView::objectAngle);
  add<vtkDoubleArray>(cells, names::Lambda, axis.siteViews, &SiteView::lambda);
  add<vtkDoubleArray>(cells, names::ErosionThickness, axis.cellErosion);
  vtkFieldData* field = output->GetFieldData();
  passFieldData(balls, field);
  add<vtkIdTypeArray>(field, names::BallOwner, axis.ballOwner);
  add<vtkDoubleArray>(field, names::BallVolume, axis.ballVolumes);
  add<vtkDoubleArray>(field, names::BallPoleVolume, axis.poleVolumes);
  addBetti(field, names::BettiPowerShape, axis.powerShapeBetti);
  addTopology(field, axis);
  addBetti(field, names::BettiUnprunedAxis, axis.betti);
  addOne<vtkUnsignedCharArray>(field, names::TopologyKept, 1);
  addOne<vtkUnsignedCharArray>(field, names::Fallback, axis.fallback);
  addOne<vtkDoubleArray>(field, names::Kappa, axis.kappa);
  addOne<vtkIdTypeArray>(field, names::FilledGaps, axis.filledGaps);
  addOne<vtkDoubleArray>(field, names::SampleDiagonal, axis.sampleDiagonal);
  addOne<vtkDoubleArray>(field, names::SampleSpacing, axis.sampleSpacing);
  addOne<vtkIdTypeArray>(field, names::NumberOfOffAxisBalls, offAxisBalls(axis.ballOwner));
}

MedialAxis readMedialAxis(vtkPolyData* input)
{
  const Arrays points(input->GetPointData(), "point", TakeMedialAxis);
  const Arrays cells(input->GetCellData(), "cell", TakeMedialAxis);
  const Arrays field(input->GetFieldData(), "field", TakeMedialAxis);
  const Index pointCount = toIndex(input->GetNumberOfPoints(), "points");
  points.checkLengths(pointCount);
  MedialAxis result;
  const Index ballCount = field.size(names::BallOwner);
  result.ballOwner = field.indices(names::BallOwner, ballCount, None, ballCount);
  result.ballVolumes = field.reals(names::BallVolume, ballCount, 0);
  result.poleVolumes = field.reals(names::BallPoleVolume, ballCount, 0);
  result.points = readFinitePoints(input, TakeMedialAxis);
  result.radii = points.reals(names::Radius, pointCount, 0);
  result.ballOfPoint = points.indices(names::BallId, pointCount, None, ballCount);
  result.erosion = points.reals(names::ErosionThickness, pointCount, 0);
  result.cells = readAxisCells(input, pointCount);
  const Index cellCount = result.cells.size();
  cells.checkLengths(cellCount);
  result.siteViews.reserve(cellCount);
  result.polygonOfCell = cells.indices(names::PolygonId, cellCount, None, Largest);
  result.samplesOfCell = cells.indexTuples<2>(names::SiteSamples, cellCount, None, Largest);
  const std::vector<double> angles = cells.reals(names::ObjectAngle, cellCount, 0);
  const std::vector<double> lambdas = cells.reals(names::Lambda, cellCount, 0);
  for (Index cell = 0; cell < cellCount; ++cell)
  {
    result.siteViews.push_back({ angles[cell], lambdas[cell] });
  }
  result.cellErosion = cells.reals(names::ErosionThickness, cellCount, 0);
  if (field.has(names::SampleDiagonal)) // files of an earlier version lack it
  {
    result.sampleDiagonal = field.reals(names::SampleDiagonal, 1, 0).front();
  }
  result.sampleSpacing = field.reals(names::SampleSpacing, 1, 0).front();
  result.powerShapeBetti = field.betti(names::BettiPowerShape);
  result.betti = field.betti(names::BettiAxis);
  result.certificate = field.flags(names::Certificate, 1).front() != 0;
  result.fallback = field.flags(names::Fallback, 1).front() != 0;
  result.kappa = field.reals(names::Kappa, 1).front();
  result.filledGaps = 0;
  if (field.has(names::FilledGaps)) // files of an earlier version lack it
  {
    result.filledGaps = field.indices(names::FilledGaps, 1, 0, Largest).front();
  }
  checkAxis(result);
  return result;
}

bool isMadeFrom(vtkPolyData* axis, vtkUnstructuredGrid* balls)
{
  return sameNumbers(axis->GetFieldData()->GetArray(names::BallVolume),
           balls->GetPointData()->GetArray(names::Volume)) &&
    pointsAreCenters(axis, balls);
}

void checkSameBalls(vtkPolyData* axis, vtkUnstructuredGrid* balls)
{
  constexpr const char* remedy =
    "take the axis that vtkMedialAxis or vtkMedialPrune made from these";
  const vtkIdType axisBalls =
    axis->GetFieldData()->GetArray(names::BallVolume)->GetNumberOfTuples();
  if (axisBalls != balls->GetNumberOfPoints())
  {
    throw InvalidInput("the axis was made from ", axisBalls, " balls, but there are ",
      balls->GetNumberOfPoints(), ": ", remedy);
  }
  if (!isMadeFrom(axis, balls))
  {
    throw InvalidInput("the axis was made from other balls than these: ", remedy);
  }
}
}
