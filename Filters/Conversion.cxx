// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion.h"

#include "ArrayNames.h"
#include "Arrays.h"
#include "Refuse.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <ostream>
#include <set>
#include <sstream>

namespace medial
{
namespace
{
void addBetti(vtkFieldData* data, const char* name, const Betti& betti)
{
  data->AddArray(tuples<vtkIdTypeArray>(name, 3, std::vector<Betti>{ betti }));
}

template <typename Values, typename Field = Itself>
vtkSmartPointer<vtkPoints> points(const Values& values, Field field = {})
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetData(tuples<vtkDoubleArray>("Points", 3, values, field));
  return result;
}

/// `cells` is a range of arrays or lists of points.
template <typename Cells>
vtkSmartPointer<vtkCellArray> cellArray(const Cells& cells)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> corners;
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(cells.size()); ++i)
  {
    const auto& cell = cells[static_cast<Index>(i)];
    corners.assign(cell.begin(), cell.end());
    result->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
  return result;
}

constexpr const char* TakePolarBalls =
  "take the output of vtkPolarBalls as it is (files of an earlier version lack arrays: make them "
  "again)";
constexpr const char* TakeMedialAxis =
  "take the output of vtkMedialAxis or a later filter as it is (files of an earlier version lack "
  "arrays: make them again)";
constexpr const char* TakeParts = "take the output of vtkMedialPartDecomposition or vtkMedialPrune";

std::vector<Point> readPoints(vtkPointSet* input)
{
  std::vector<Point> result(toIndex(input->GetNumberOfPoints(), "points"));
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    input->GetPoint(static_cast<vtkIdType>(i), result[i].data());
  }
  return result;
}

std::vector<Point> readFinitePoints(vtkPointSet* input, const char* remedy)
{
  std::vector<Point> result = readPoints(input);
  const auto bad = std::find_if(
    result.begin(), result.end(), [](const Point& point) { return !point.allFinite(); });
  if (bad != result.end())
  {
    refuse("point ", bad - result.begin(), " has a coordinate that is not finite: ", remedy);
  }
  return result;
}

/// The corners of one cell, checked: `Size` different points.
template <std::size_t Size>
std::array<Index, Size> readCell(
  vtkCellArray* cells, vtkIdType number, Index pointCount, const char* remedy)
{
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  cells->GetCellAtId(number, size, corners);
  if (size != static_cast<vtkIdType>(Size))
  {
    refuse("a cell has ", size, " corners instead of ", Size, ": ", remedy);
  }
  std::array<Index, Size> result;
  for (std::size_t i = 0; i < Size; ++i)
  {
    if (corners[i] < 0 || corners[i] >= pointCount)
    {
      refuse(
        "a cell has the corner ", corners[i], " but there are ", pointCount, " points: ", remedy);
    }
    result[i] = static_cast<Index>(corners[i]);
    if (std::find(result.begin(), result.begin() + i, result[i]) != result.begin() + i)
    {
      refuse("a cell has the point ", result[i], " twice: ", remedy);
    }
  }
  return result;
}

template <std::size_t Size>
std::vector<std::array<Index, Size>> readCells(
  vtkCellArray* cells, Index pointCount, const char* remedy)
{
  std::vector<std::array<Index, Size>> result;
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return result;
  }
  if (!cells->IsValid())
  {
    refuse("the offsets of the cells do not fit their corners: ", remedy);
  }
  result.reserve(toIndex(cells->GetNumberOfCells(), "cells"));
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    result.push_back(readCell<Size>(cells, i, pointCount, remedy));
  }
  return result;
}

std::vector<Tetrahedron> readTetrahedra(vtkUnstructuredGrid* input, Index pointCount)
{
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    if (input->GetCellType(i) != VTK_TETRA)
    {
      refuse("cell ", i, " is no tetrahedron: ", TakePolarBalls);
    }
  }
  return readCells<4>(input->GetCells(), pointCount, TakePolarBalls);
}

AxisCells readAxisCells(vtkPolyData* input, Index pointCount)
{
  if (input->GetNumberOfStrips() > 0)
  {
    refuse("the axis has triangle strips: ", TakeMedialAxis);
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
  add<vtkIdTypeArray>(field, names::DuplicateOf, balls.duplicateOf);
  add<vtkIdTypeArray>(field, names::SampleInnerBall, balls.innerBall);
  add<vtkIdTypeArray>(field, names::SampleOuterBall, balls.outerBall);
  add<vtkDoubleArray>(field, names::SamplingQuality, balls.samplingQuality);
  add<vtkIdTypeArray>(field, names::BallSampleOffsets, balls.ballSamples.offsets);
  add<vtkIdTypeArray>(field, names::BallSamples, balls.ballSamples.items);
}

void addCounts(vtkFieldData* field, const PolarBalls& balls)
{
  const std::vector<Index>& duplicates = balls.duplicateOf;
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

/// Field data that changes with the cells of the axis.
void addTopology(vtkFieldData* field, const MedialAxis& axis)
{
  addBetti(field, names::BettiAxis, axis.betti);
  addOne<vtkUnsignedCharArray>(field, names::Certificate, axis.certificate);
}

void addParts(vtkCellData* cells, vtkFieldData* field, const MedialParts& parts)
{
  const auto ofPart = [&](auto member) {
    return [&parts, member](Index part) { return parts.parts[part].*member; };
  };
  const std::vector<Index>& partOfCell = parts.partOfCell;
  add<vtkIdTypeArray>(cells, names::PartId, partOfCell);
  cells->SetActiveScalars(names::PartId);
  add<vtkIntArray>(cells, names::PartLevel, partOfCell, ofPart(&MedialPart::level));
  add<vtkIdTypeArray>(cells, names::TriangleCount, partOfCell, ofPart(&MedialPart::triangles));
  const auto addMeasure = [&](const char* name, double MedialPart::*member) {
    add<vtkDoubleArray>(cells, name, partOfCell, ofPart(member));
  };
  addMeasure(names::RelativeVolume, &MedialPart::relativeVolume);
  addMeasure(names::PartPoleVolume, &MedialPart::poleVolume);
  addMeasure(names::PartArea, &MedialPart::area);
  addMeasure(names::PartMeanRadius, &MedialPart::meanRadius);
  addMeasure(names::PartMaximumRadius, &MedialPart::maximumRadius);
  addMeasure(names::PartObjectAngle, &MedialPart::objectAngle);
  addMeasure(names::PartLambda, &MedialPart::lambda);
  addMeasure(names::PartErosionThickness, &MedialPart::erosionThickness);
  addMeasure(names::PartHausdorffDistance, &MedialPart::hausdorffDistance);
  addOne<vtkIdTypeArray>(field, names::NumberOfParts, count(parts.parts));
  const auto suggested = tuples<vtkDoubleArray>(names::SuggestedThreshold,
    static_cast<int>(allMeasures().size()), std::array{ parts.suggestedThresholds });
  for (const MeasureTraits& traits : allMeasures())
  {
    suggested->SetComponentName(static_cast<int>(traits.measure), traits.name);
  }
  field->AddArray(suggested);
}

void addPartTable(vtkFieldData* rows, const std::vector<MedialPart>& parts)
{
  std::vector<Index> numbers(parts.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  add<vtkIdTypeArray>(rows, names::PartId, numbers);
  add<vtkIntArray>(rows, names::Dimension, parts, &MedialPart::dimension);
  add<vtkIntArray>(rows, names::Level, parts, &MedialPart::level);
  add<vtkIdTypeArray>(rows, names::Triangles, parts, &MedialPart::triangles);
  add<vtkDoubleArray>(rows, names::Area, parts, &MedialPart::area);
  add<vtkDoubleArray>(rows, names::Volume, parts, &MedialPart::volume);
  add<vtkDoubleArray>(rows, names::RelativeVolume, parts, &MedialPart::relativeVolume);
  add<vtkDoubleArray>(rows, names::MeanRadius, parts, &MedialPart::meanRadius);
  add<vtkDoubleArray>(rows, names::MinimumRadius, parts, &MedialPart::minimumRadius);
  add<vtkDoubleArray>(rows, names::MaximumRadius, parts, &MedialPart::maximumRadius);
  add<vtkDoubleArray>(rows, names::PoleVolume, parts, &MedialPart::poleVolume);
  add<vtkDoubleArray>(rows, names::ObjectAngle, parts, &MedialPart::objectAngle);
  add<vtkDoubleArray>(rows, names::Lambda, parts, &MedialPart::lambda);
  add<vtkDoubleArray>(rows, names::ErosionThickness, parts, &MedialPart::erosionThickness);
  add<vtkDoubleArray>(rows, names::HausdorffDistance, parts, &MedialPart::hausdorffDistance);
  add<vtkIdTypeArray>(rows, names::Contacts, parts, &MedialPart::contacts);
  add<vtkIdTypeArray>(rows, names::Neighbors, parts, &MedialPart::neighbors);
  add<vtkDoubleArray>(rows, names::NeckRatio, parts, &MedialPart::neckRatio);
  add<vtkUnsignedCharArray>(rows, names::OnLoop, parts, &MedialPart::onLoop);
  rows->AddArray(tuples<vtkDoubleArray>(names::Bounds, 6, parts, [](const MedialPart& part) {
    const Point &from = part.lower, &to = part.upper;
    return std::array{ from.x(), to.x(), from.y(), to.y(), from.z(), to.z() };
  }));
  rows->AddArray(tuples<vtkDoubleArray>(
    names::Centroid, 3, parts, [](const MedialPart& part) { return part.centroid; }));
  rows->AddArray(tuples<vtkDoubleArray>(names::PrincipalLengths, 3, parts,
    [](const MedialPart& part) { return part.principalLengths; }));
}

/// A vertex for each contact of one point, a polyline for each other, with its number.
void addContacts(const std::vector<ContactCurve>& contacts, vtkPolyData* output)
{
  std::vector<std::vector<Index>> vertices, lines;
  std::vector<Index> numbers, lineNumbers;
  IndexLists parts;
  for (Index i = 0; i < count(contacts); ++i)
  {
    const ContactCurve& curve = contacts[i];
    const bool isPoint = curve.points.size() == 1;
    (isPoint ? vertices : lines).push_back(curve.points);
    (isPoint ? numbers : lineNumbers).push_back(i);
    parts.items.insert(parts.items.end(), curve.parts.begin(), curve.parts.end());
    parts.close();
  }
  numbers.insert(numbers.end(), lineNumbers.begin(), lineNumbers.end());
  output->SetVerts(cellArray(vertices));
  output->SetLines(cellArray(lines));
  add<vtkIdTypeArray>(output->GetCellData(), names::ContactId, numbers);
  add<vtkIdTypeArray>(output->GetFieldData(), names::ContactPartOffsets, parts.offsets);
  add<vtkIdTypeArray>(output->GetFieldData(), names::ContactParts, parts.items);
}

/// Those of `cells`, numbered from `first`, that are among `chosen`, ascending.
vtkSmartPointer<vtkCellArray> chosenCells(
  vtkCellArray* cells, vtkIdType first, const std::vector<Index>& chosen)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  const auto begin = std::lower_bound(chosen.begin(), chosen.end(), first);
  const auto end = std::lower_bound(begin, chosen.end(), first + cells->GetNumberOfCells());
  result->AllocateEstimate(end - begin, cells->GetMaxCellSize());
  for (auto cell = begin; cell != end; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(*cell - first, size, corners);
    result->InsertNextCell(size, corners);
  }
  return result;
}

/// All points of an axis and the `chosen` cells, ascending, with their arrays; for those that
/// `replaced` has too, these.
void copyCells(
  vtkPolyData* axis, const std::vector<Index>& chosen, vtkCellData* replaced, vtkPolyData* output)
{
  output->SetPoints(axis->GetPoints());
  output->GetPointData()->PassData(axis->GetPointData());
  const vtkIdType firstLine = axis->GetNumberOfVerts();
  const vtkIdType firstPoly = firstLine + axis->GetNumberOfLines();
  output->SetVerts(chosenCells(axis->GetVerts(), 0, chosen));
  output->SetLines(chosenCells(axis->GetLines(), firstLine, chosen));
  output->SetPolys(chosenCells(axis->GetPolys(), firstPoly, chosen));
  vtkNew<vtkCellData> others;
  others->ShallowCopy(axis->GetCellData());
  for (int i = 0; i < replaced->GetNumberOfArrays(); ++i)
  {
    others->RemoveArray(replaced->GetArrayName(i));
  }
  vtkCellData* cells = output->GetCellData();
  cells->CopyAllOn();
  cells->CopyAllocate(others, static_cast<vtkIdType>(chosen.size()));
  vtkNew<vtkIdList> from, to;
  from->SetNumberOfIds(static_cast<vtkIdType>(chosen.size()));
  to->SetNumberOfIds(static_cast<vtkIdType>(chosen.size()));
  std::copy(chosen.begin(), chosen.end(), from->begin());
  std::iota(to->begin(), to->end(), 0);
  cells->CopyData(others, from, to);
  cells->PassData(replaced);
}

void addHistory(vtkFieldData* rows, const std::vector<PruneRow>& history)
{
  std::vector<Index> numbers(history.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  add<vtkIdTypeArray>(rows, names::Iteration, numbers);
  add<vtkUnsignedCharArray>(rows, names::ByHand, history, &PruneRow::byHand);
  add<vtkIntArray>(rows, names::Measure, history, &PruneRow::measure);
  add<vtkDoubleArray>(rows, names::Threshold, history, &PruneRow::threshold);
  add<vtkIntArray>(rows, names::Passes, history, &PruneRow::passes);
  add<vtkIdTypeArray>(rows, names::PartsBefore, history, &PruneRow::partsBefore);
  add<vtkIdTypeArray>(rows, names::PartsAfter, history, &PruneRow::partsAfter);
  add<vtkIdTypeArray>(rows, names::Candidates, history, &PruneRow::candidates);
  add<vtkIdTypeArray>(rows, names::Removed, history, &PruneRow::removed);
  add<vtkIdTypeArray>(rows, names::Refused, history, &PruneRow::refused);
  add<vtkIdTypeArray>(rows, names::RefusedByTopology, history, &PruneRow::refusedByTopology);
  add<vtkIdTypeArray>(rows, names::RefusedIsolated, history, &PruneRow::refusedIsolated);
  add<vtkIdTypeArray>(rows, names::RefusedProtected, history, &PruneRow::refusedProtected);
  add<vtkIdTypeArray>(rows, names::TopologyChanges, history, &PruneRow::topologyChanges);
  rows->AddArray(tuples<vtkIdTypeArray>(
    names::Betti, 3, history, [](const PruneRow& row) { return row.betti; }));
  add<vtkDoubleArray>(rows, names::VolumeRemoved, history, &PruneRow::volumeRemoved);
}
}

std::vector<Point> readSamples(vtkPointSet* input)
{
  return readPoints(input);
}

void write(
  const PolarBalls& balls, const Betti& powerShape, vtkPointSet* input, vtkUnstructuredGrid* output)
{
  output->SetPoints(points(balls.balls, [](const Ball& ball) { return ball.center; }));
  output->SetCells(VTK_TETRA, cellArray(balls.cells));
  vtkPointData* ballData = output->GetPointData();
  add<vtkDoubleArray>(ballData, names::Radius, balls.balls, &Ball::radius);
  addInnerRadii(ballData, balls);
  add<vtkUnsignedCharArray>(ballData, names::Side, balls.sides);
  ballData->SetActiveScalars(names::InnerRadius);
  add<vtkUnsignedCharArray>(ballData, names::TouchesGuard, balls.touchesGuard);
  add<vtkDoubleArray>(ballData, names::Volume, balls.volumes);
  add<vtkDoubleArray>(ballData, names::PoleVolume, balls.poleVolumes);
  vtkFieldData* field = output->GetFieldData();
  field->PassData(input->GetFieldData());
  addSamples(field, balls);
  addCounts(field, balls);
  addBetti(field, names::BettiPowerShape, powerShape);
}

PolarBalls readPolarBalls(vtkUnstructuredGrid* input)
{
  const Arrays points(input->GetPointData(), "point", TakePolarBalls);
  const Arrays field(input->GetFieldData(), "field", TakePolarBalls);
  const Index ballCount = toIndex(input->GetNumberOfPoints(), "balls");
  PolarBalls result;
  const std::vector<double> radii = points.reals(names::Radius, ballCount, 0);
  for (const Point& center : readFinitePoints(input, TakePolarBalls))
  {
    result.balls.push_back({ center, radii[result.balls.size()] });
  }
  for (const Index side : points.indices(names::Side, ballCount, 0, 3))
  {
    result.sides.push_back(static_cast<Side>(side));
  }
  result.touchesGuard = points.flags(names::TouchesGuard, ballCount);
  result.volumes = points.reals(names::Volume, ballCount, 0);
  result.poleVolumes = points.reals(names::PoleVolume, ballCount, 0);

  const std::vector<double> samples =
    field.reals(names::Samples, AnyCount, std::numeric_limits<double>::lowest(), 3);
  for (std::size_t i = 0; i < samples.size(); i += 3)
  {
    result.samples.emplace_back(samples[i], samples[i + 1], samples[i + 2]);
  }
  const Index sampleCount = toIndex(static_cast<vtkIdType>(result.samples.size()), "samples");
  result.duplicateOf = field.indices(names::DuplicateOf, sampleCount, None, sampleCount);
  result.innerBall = field.indices(names::SampleInnerBall, sampleCount, None, ballCount);
  result.outerBall = field.indices(names::SampleOuterBall, sampleCount, None, ballCount);
  result.samplingQuality = field.reals(names::SamplingQuality, sampleCount);
  result.ballSamples =
    field.lists(names::BallSampleOffsets, names::BallSamples, ballCount, sampleCount);
  result.spacing = field.reals(names::SampleSpacing, 1, std::numeric_limits<double>::min()).front();
  result.cells = readTetrahedra(input, ballCount);
  return result;
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
  field->PassData(balls->GetFieldData());
  add<vtkIdTypeArray>(field, names::BallOwner, axis.ballOwner);
  add<vtkDoubleArray>(field, names::BallVolume, axis.ballVolumes);
  add<vtkDoubleArray>(field, names::BallPoleVolume, axis.poleVolumes);
  addBetti(field, names::BettiPowerShape, axis.powerShapeBetti);
  addTopology(field, axis);
  addOne<vtkUnsignedCharArray>(field, names::Fallback, axis.fallback);
  addOne<vtkDoubleArray>(field, names::Kappa, axis.kappa);
  addOne<vtkIdTypeArray>(field, names::NumberOfOffAxisBalls, offAxisBalls(axis.ballOwner));
}

MedialAxis readMedialAxis(vtkPolyData* input)
{
  const Arrays points(input->GetPointData(), "point", TakeMedialAxis);
  const Arrays cells(input->GetCellData(), "cell", TakeMedialAxis);
  const Arrays field(input->GetFieldData(), "field", TakeMedialAxis);
  const Index pointCount = toIndex(input->GetNumberOfPoints(), "points");
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
  result.powerShapeBetti = field.betti(names::BettiPowerShape);
  result.betti = field.betti(names::BettiAxis);
  result.certificate = field.flags(names::Certificate, 1).front() != 0;
  result.fallback = field.flags(names::Fallback, 1).front() != 0;
  result.kappa = field.reals(names::Kappa, 1).front();
  return result;
}

void write(const MedialParts& parts, vtkPolyData* axis, vtkPolyData* output, vtkTable* table,
  vtkPolyData* contacts)
{
  output->ShallowCopy(axis);
  addParts(output->GetCellData(), output->GetFieldData(), parts);
  addPartTable(table->GetRowData(), parts.parts);
  contacts->SetPoints(axis->GetPoints());
  contacts->GetPointData()->PassData(axis->GetPointData());
  addContacts(parts.contacts, contacts);
}

void write(const TopologyGraph& graph, const MedialParts& parts, vtkPolyData* output)
{
  const Index nodeCount = graph.partsOfNode.size(), partCount = graph.nodesOfPart.size();
  std::vector<Point> places = graph.nodeCentroids;
  std::vector<Index> node, part, degree;
  std::vector<std::array<Index, 1>> vertices;
  std::vector<Edge> lines;
  for (Index i = 0; i < nodeCount; ++i)
  {
    node.push_back(i);
    part.push_back(None);
    degree.push_back(graph.partsOfNode[i].size());
    vertices.push_back({ i });
  }
  for (Index i = 0; i < partCount; ++i)
  {
    places.push_back(parts.parts[i].centroid);
    node.push_back(None);
    part.push_back(i);
    degree.push_back(graph.nodesOfPart[i].size());
    vertices.push_back({ nodeCount + i });
    for (const Index other : graph.nodesOfPart[i])
    {
      lines.push_back({ nodeCount + i, other });
    }
  }
  output->SetPoints(points(places));
  output->SetVerts(cellArray(vertices));
  output->SetLines(cellArray(lines));
  std::vector<char> onLoop = graph.nodeOnLoop;
  onLoop.insert(onLoop.end(), graph.partOnLoop.begin(), graph.partOnLoop.end());
  add<vtkIdTypeArray>(output->GetPointData(), names::NodeId, node);
  add<vtkIdTypeArray>(output->GetPointData(), names::PartId, part);
  add<vtkIdTypeArray>(output->GetPointData(), names::Degree, degree);
  add<vtkUnsignedCharArray>(output->GetPointData(), names::OnLoop, onLoop);
  for (const Edge& line : lines)
  {
    node.push_back(line[1]);
    part.push_back(line[0] - nodeCount);
  }
  add<vtkIdTypeArray>(output->GetCellData(), names::NodeId, node);
  add<vtkIdTypeArray>(output->GetCellData(), names::PartId, part);
}

std::vector<Index> readParts(vtkPolyData* axis)
{
  const Arrays cells(axis->GetCellData(), "cell", TakeParts);
  const Index cellCount = toIndex(axis->GetNumberOfCells(), "cells");
  return cells.has(names::PartId) ? cells.indices(names::PartId, cellCount, 0, cellCount)
                                  : std::vector<Index>();
}

std::vector<Index> readCells(vtkPolyData* axis, const std::vector<vtkIdType>& parts,
  const std::vector<vtkIdType>& cells, const char* done)
{
  const vtkIdType cellCount = axis->GetNumberOfCells();
  std::vector<Index> result;
  for (const vtkIdType cell : cells)
  {
    if (cell < 0 || cell >= cellCount)
    {
      refuse("cell ", cell, " can't be ", done, ": the input has the cells 0 ... ", cellCount - 1);
    }
    result.push_back(static_cast<Index>(cell));
  }
  if (parts.empty())
  {
    return result;
  }
  const std::vector<Index> partOfCell = readParts(axis);
  if (partOfCell.empty())
  {
    refuse("parts can't be ", done, " without the cell array '", names::PartId, "': ", TakeParts);
  }
  std::set<vtkIdType> missing(parts.begin(), parts.end());
  const std::set<vtkIdType> chosen = missing;
  for (Index cell = 0; cell < count(partOfCell); ++cell)
  {
    if (chosen.count(partOfCell[cell]))
    {
      missing.erase(partOfCell[cell]);
      result.push_back(cell);
    }
  }
  if (!missing.empty())
  {
    refuse("part ", *missing.begin(), " can't be ", done, ": the cell array '", names::PartId,
      "' of the input has no such part");
  }
  return result;
}

std::string refusals(
  const Pruned& pruned, const std::vector<Index>& cellsToRemove, vtkPolyData* axis)
{
  const std::vector<Index> partOfCell = readParts(axis);
  std::map<CellFate, std::set<Index>> kept;
  for (std::size_t i = 0; i < pruned.fates.size(); ++i)
  {
    const Index cell = cellsToRemove[i];
    kept[pruned.fates[i]].insert(partOfCell.empty() ? cell : partOfCell[cell]);
  }
  const auto listed = [&](CellFate fate, const char* reason) {
    std::ostringstream text;
    for (const Index number : kept[fate])
    {
      text << (text.str().empty() ? "" : ", ") << number;
    }
    const char* what = partOfCell.empty() ? "cells " : "parts ";
    return kept[fate].empty() ? std::string() : "; " + (what + text.str()) + ": " + reason;
  };
  const std::string text = listed(CellFate::Topology, "needed for the topology") +
    listed(CellFate::Isolated, "a whole piece of the axis") +
    listed(CellFate::Protected, "protected") +
    listed(CellFate::AlreadyGone, "already gone with the schedule");
  return text.empty() ? text : "not removed by hand" + text;
}

void write(const Pruned& pruned, vtkPolyData* axis, vtkPolyData* output, vtkTable* history,
  vtkPolyData* removed)
{
  output->GetFieldData()->PassData(axis->GetFieldData());
  vtkNew<vtkCellData> own;
  addParts(own, output->GetFieldData(), pruned.parts);
  addTopology(output->GetFieldData(), pruned.axis);
  add<vtkUnsignedCharArray>(own, names::KeepReason, pruned.parts.partOfCell,
    [&](Index part) { return pruned.keepReason[part]; });
  copyCells(axis, pruned.inputCell, own, output);
  addHistory(history->GetRowData(), pruned.history);

  std::vector<Index> cells;
  for (Index cell = 0; cell < count(pruned.removedInIteration); ++cell)
  {
    if (pruned.removedInIteration[cell] != None)
    {
      cells.push_back(cell);
    }
  }
  vtkNew<vtkCellData> when;
  add<vtkIdTypeArray>(
    when, names::Iteration, cells, [&](Index cell) { return pruned.removedInIteration[cell]; });
  add<vtkIdTypeArray>(
    when, names::PartId, cells, [&](Index cell) { return pruned.removedPart[cell]; });
  when->SetActiveScalars(names::PartId);
  copyCells(axis, cells, when, removed);
}

void checkSameBalls(const MedialAxis& axis, const PolarBalls& balls)
{
  if (axis.ballOwner.size() != balls.balls.size())
  {
    refuse("the axis was made from ", axis.ballOwner.size(), " balls, but there are ",
      balls.balls.size(), ": take the axis that vtkMedialAxis or vtkMedialPrune made from these");
  }
}

void write(const Crust& crust, const std::vector<Index>& partOfBall, vtkUnstructuredGrid* balls,
  vtkPolyData* output)
{
  output->SetPoints(points(crust.points));
  output->SetPolys(cellArray(crust.faces));
  add<vtkIdTypeArray>(output->GetPointData(), names::SampleId, crust.sampleOfPoint);
  vtkCellData* cells = output->GetCellData();
  add<vtkIdTypeArray>(cells, names::InnerBall, crust.innerBall);
  add<vtkIdTypeArray>(cells, names::OuterBall, crust.outerBall);
  add<vtkIdTypeArray>(cells, names::PartId, crust.innerBall,
    [&](Index ball) { return partOfBall.empty() ? None : partOfBall[ball]; });
  vtkFieldData* field = output->GetFieldData();
  field->PassData(balls->GetFieldData());
  addBetti(field, names::BettiCrust, crust.betti);
  addOne<vtkUnsignedCharArray>(field, names::Closed, crust.closed);
  addOne<vtkUnsignedCharArray>(field, names::Manifold, crust.manifold);
  addOne<vtkDoubleArray>(field, names::Volume, crust.volume);
  addOne<vtkIdTypeArray>(field, names::InsertedBalls, crust.insertedBalls);
  addOne<vtkIdTypeArray>(field, names::RefusedBalls, crust.refusedBalls);
  addOne<vtkIdTypeArray>(field, names::Rounds, crust.rounds);
  addOne<vtkDoubleArray>(field, names::MaximumClearance, crust.maximumClearance);
}

void print(std::ostream& stream, vtkIndent indent, const std::vector<PruneIteration>& schedule)
{
  for (const PruneIteration& iteration : schedule)
  {
    stream << indent << findMeasure(static_cast<int>(iteration.measure))->name
           << " <= " << iteration.threshold << ", passes: " << iteration.passes << "\n";
  }
}
}
