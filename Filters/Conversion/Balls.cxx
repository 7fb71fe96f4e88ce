// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Balls.h"

#include "Base/Errors.h"
#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/BallChecks.h"
#include "Conversion/Cells.h"
#include "Conversion/Remedies.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace medial
{
namespace
{
std::vector<Tetrahedron> readTetrahedra(vtkUnstructuredGrid* input, Index pointCount)
{
  vtkUnsignedCharArray* types = input->GetCellTypesArray();
  const vtkIdType typeCount = types ? types->GetNumberOfTuples() : 0;
  if (typeCount != input->GetNumberOfCells())
  {
    throw InvalidInput("there are ", input->GetNumberOfCells(), " cells, but types for ", typeCount,
      ": ", TakePolarBalls);
  }
  for (vtkIdType i = 0; i < typeCount; ++i)
  {
    if (types->GetValue(i) != VTK_TETRA)
    {
      throw InvalidInput("cell ", i, " is no tetrahedron: ", TakePolarBalls);
    }
  }
  return readCells<4>(input->GetCells(), pointCount, TakePolarBalls);
}

std::vector<Point> readVectors(const Arrays& arrays, const char* name, vtkIdType size)
{
  const std::vector<double> flat =
    arrays.reals(name, size, std::numeric_limits<double>::lowest(), 3);
  std::vector<Point> result;
  result.reserve(flat.size() / 3);
  for (std::size_t i = 0; i < flat.size(); i += 3)
  {
    result.emplace_back(flat[i], flat[i + 1], flat[i + 2]);
  }
  return result;
}

void addInnerRadii(vtkFieldData* data, const PolarBalls& balls)
{
  std::vector<double> radii;
  for (const Ball& ball : balls.balls)
  {
    radii.push_back(balls.sides[radii.size()] == Side::Inner ? ball.radius : 0);
  }
  add<vtkDoubleArray>(data, names::InnerRadius, radii);
}

void addSamples(vtkFieldData* field, const PolarBalls& balls)
{
  field->AddArray(tuples<vtkDoubleArray>(names::Samples, 3, balls.samples));
  add<vtkIdTypeArray>(field, names::SampleInnerBall, balls.innerBall);
  add<vtkIdTypeArray>(field, names::SampleOuterBall, balls.outerBall);
  if (!balls.normals.empty())
  {
    field->AddArray(tuples<vtkDoubleArray>(names::SampleNormals, 3, balls.normals));
  }
  add<vtkIdTypeArray>(field, names::BallSampleOffsets, balls.ballSamples.offsets);
  add<vtkIdTypeArray>(field, names::BallSamples, balls.ballSamples.items);
}

void addCounts(vtkFieldData* field, const PolarBallsAndSamples& made)
{
  const PolarBalls& balls = made.balls;
  const std::vector<Index>& duplicates = made.samples.duplicateOf;
  const auto unique = std::count(duplicates.begin(), duplicates.end(), None);
  const auto ballsOn = [&](Side side) {
    return std::count(balls.sides.begin(), balls.sides.end(), side);
  };
  addOne<vtkIdTypeArray>(field, names::NumberOfSamples, count(balls.samples));
  addOne<vtkIdTypeArray>(field, names::NumberOfDuplicates, count(duplicates) - unique);
  addOne<vtkIdTypeArray>(field, names::NumberOfInnerBalls, ballsOn(Side::Inner));
  addOne<vtkIdTypeArray>(field, names::NumberOfOuterBalls, ballsOn(Side::Outer));
  addOne<vtkIdTypeArray>(field, names::NumberOfHiddenBalls, ballsOn(Side::Hidden));
  addOne<vtkDoubleArray>(field, names::SampleSpacing, balls.spacing);
  addOne<vtkDoubleArray>(field, names::MergeTolerance, made.samples.mergeTolerance);
}

void writeBalls(const PolarBalls& balls, vtkUnstructuredGrid* output)
{
  output->SetPoints(points(balls.balls, [](const Ball& ball) { return ball.center; }));
  output->SetCells(VTK_TETRA, cellArray(balls.triangulation.cells));
  vtkPointData* ballData = output->GetPointData();
  add<vtkDoubleArray>(ballData, names::Radius, balls.balls, &Ball::radius);
  addInnerRadii(ballData, balls);
  add<vtkUnsignedCharArray>(ballData, names::Side, balls.sides);
  ballData->SetActiveScalars(names::InnerRadius);
  add<vtkUnsignedCharArray>(ballData, names::TouchesGuard, balls.touchesGuard);
  add<vtkDoubleArray>(ballData, names::Volume, balls.volumes);
  add<vtkDoubleArray>(ballData, names::PoleVolume, balls.poleVolumes);
}

/// The unit of the samples is not that of what is made from them.
void passInputOfSamples(vtkPointSet* input, vtkFieldData* output)
{
  passInput(input, output);
  output->RemoveArray(names::SampleResolution);
}

/// A vertex for each sample, so that they can be drawn and picked.
void writeSamples(const PolarBallsAndSamples& made, vtkPolyData* output)
{
  output->SetPoints(points(made.balls.samples));
  output->SetVerts(vertexForEach(count(made.balls.samples)));
  vtkPointData* sampleData = output->GetPointData();
  add<vtkDoubleArray>(sampleData, names::SamplingQuality, made.samples.quality);
  sampleData->SetActiveScalars(names::SamplingQuality);
  add<vtkIdTypeArray>(sampleData, names::InnerBall, made.balls.innerBall);
  add<vtkIdTypeArray>(sampleData, names::OuterBall, made.balls.outerBall);
  add<vtkIdTypeArray>(sampleData, names::DuplicateOf, made.samples.duplicateOf);
}

/// Adds the polygons of a cell.
void addPolygons(
  int cellType, std::vector<vtkIdType> corners, vtkIdType pointCount, IndexLists& polygons)
{
  const auto isMissing = [pointCount](vtkIdType p) { return p < 0 || p >= pointCount; };
  if (std::any_of(corners.begin(), corners.end(), isMissing))
  {
    return;
  }
  if (cellType == VTK_TRIANGLE_STRIP)
  {
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      polygons.append(std::array{ corners[i - 2], corners[i - 1], corners[i] });
    }
    return;
  }
  if (cellType == VTK_PIXEL && corners.size() == 4)
  {
    std::swap(corners[2], corners[3]); // a pixel's points are not in order around it
  }
  polygons.append(corners);
}
}

std::vector<Point> readSamples(vtkPointSet* input)
{
  return readPoints(input);
}

std::vector<Point> readNormals(vtkPointSet* input)
{
  vtkPointData* data = input->GetPointData();
  vtkDataArray* active = data->GetNormals();
  vtkDataArray* normals = active ? active : data->GetArray(names::Normals);
  if (!normals)
  {
    return {};
  }
  if (normals->GetNumberOfComponents() != 3 ||
    normals->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    throw InvalidInput("the point array '", normals->GetName() ? normals->GetName() : "", "' has ",
      normals->GetNumberOfTuples(), " normals of ", normals->GetNumberOfComponents(),
      " components for ", input->GetNumberOfPoints(),
      " points; give one of 3 components for each, or none");
  }
  std::vector<Point> result(normals->GetNumberOfTuples());
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    normals->GetTuple(static_cast<vtkIdType>(i), result[i].data());
  }
  return result;
}

IndexLists readPolygons(vtkPointSet* input)
{
  IndexLists result;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    const int type = input->GetCellType(cell);
    if (type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_POLYGON || type == VTK_PIXEL ||
      type == VTK_TRIANGLE_STRIP)
    {
      input->GetCellPoints(cell, corners);
      addPolygons(type, { corners->begin(), corners->end() }, input->GetNumberOfPoints(), result);
    }
  }
  return result;
}

double sampleResolution(vtkPointSet* input)
{
  double result = 0;
  if (input->GetPoints() && input->GetPoints()->GetDataType() == VTK_FLOAT)
  {
    double bounds[6];
    input->GetPoints()->GetBounds(bounds);
    float largest = 0;
    for (const double bound : bounds)
    {
      largest = std::max(largest, static_cast<float>(std::abs(bound)));
    }
    const float next = std::nextafter(largest, std::numeric_limits<float>::infinity());
    result = std::isfinite(next) ? static_cast<double>(next) - static_cast<double>(largest) : 0;
  }
  if (vtkDataArray* array = input->GetFieldData()->GetArray(names::SampleResolution))
  {
    const double value = array->GetNumberOfValues() == 1 ? array->GetComponent(0, 0) : -1;
    if (!(value >= 0) || !std::isfinite(value))
    {
      throw InvalidInput("the field array '", names::SampleResolution,
        "' must hold one length: the unit to which coordinates were rounded, or 0");
    }
    result = std::max(result, value);
  }
  return result;
}

void write(const PolarBallsAndSamples& made, vtkPointSet* input, vtkUnstructuredGrid* balls,
  vtkPolyData* samples)
{
  writeBalls(made.balls, balls);
  vtkFieldData* field = balls->GetFieldData();
  passInputOfSamples(input, field);
  addSamples(field, made.balls);
  addCounts(field, made);
  addBetti(field, names::BettiPowerShape, made.powerShape);
  writeSamples(made, samples);
  passInputOfSamples(input, samples->GetFieldData());
}

void passInput(vtkDataObject* input, vtkFieldData* output)
{
  output->PassData(input->GetFieldData());
  output->RemoveArray(names::Verdict);
  output->RemoveArray(names::VerdictReasons);
}

PolarBalls readPolarBalls(vtkUnstructuredGrid* input, CellNeighbors neighbors)
{
  const Arrays points(input->GetPointData(), "point", TakePolarBalls);
  const Arrays field(input->GetFieldData(), "field", TakePolarBalls);
  const Index ballCount = toIndex(input->GetNumberOfPoints(), "balls");
  points.checkLengths(ballCount);
  PolarBalls result;
  const std::vector<double> radii = points.reals(names::Radius, ballCount, 0);
  result.balls.reserve(ballCount);
  for (const Point& center : readFinitePoints(input, TakePolarBalls))
  {
    result.balls.push_back({ center, radii[result.balls.size()] });
  }
  result.sides.reserve(ballCount);
  for (const Index side : points.indices(names::Side, ballCount, 0, 3))
  {
    result.sides.push_back(static_cast<Side>(side));
  }
  result.touchesGuard = points.flags(names::TouchesGuard, ballCount);
  result.volumes = points.reals(names::Volume, ballCount, 0);
  result.poleVolumes = points.reals(names::PoleVolume, ballCount, 0);

  result.samples = readVectors(field, names::Samples, AnyCount);
  const Index sampleCount = toIndex(static_cast<vtkIdType>(result.samples.size()), "samples");
  if (field.has(names::SampleNormals))
  {
    result.normals = readVectors(field, names::SampleNormals, sampleCount);
  }
  result.innerBall = field.indices(names::SampleInnerBall, sampleCount, None, ballCount);
  result.outerBall = field.indices(names::SampleOuterBall, sampleCount, None, ballCount);
  result.ballSamples =
    field.lists(names::BallSampleOffsets, names::BallSamples, ballCount, sampleCount);
  result.spacing = field.reals(names::SampleSpacing, 1, std::numeric_limits<double>::min()).front();
  result.triangulation.cells = readTetrahedra(input, ballCount);
  Arrays(input->GetCellData(), "cell", TakePolarBalls)
    .checkLengths(count(result.triangulation.cells));
  checkBalls(result, neighbors);
  return result;
}

void passFieldData(vtkUnstructuredGrid* balls, vtkFieldData* output)
{
  output->PassData(balls->GetFieldData());
  for (const char* list : { names::Samples, names::SampleInnerBall, names::SampleOuterBall,
         names::SampleNormals, names::BallSampleOffsets, names::BallSamples })
  {
    output->RemoveArray(list);
  }
}
}
