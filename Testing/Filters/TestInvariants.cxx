// SPDX-License-Identifier: BSD-3-Clause
// What the stages rely on, beside lengths and ranges of single arrays: a stage refuses data that break it.
#include "FilterTest.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace
{
using filterTest::boxPipeline;

/// How to break an invariant, and what the message says.
template <typename Data>
struct Breach
{
  const char* name;
  std::function<void(Data*)> damage;
  std::vector<std::string> says;
};

using BallBreach = Breach<vtkUnstructuredGrid>;
using AxisBreach = Breach<vtkPolyData>;

template <typename Data>
void PrintTo(const Breach<Data>& breach, std::ostream* stream)
{
  *stream << breach.name;
}

template <typename Data>
std::string nameOf(const testing::TestParamInfo<Breach<Data>>& info)
{
  return info.param.name;
}

vtkDataArray* pointArray(vtkDataSet* data, const char* name)
{
  return data->GetPointData()->GetArray(name);
}

vtkDataArray* fieldArray(vtkDataObject* data, const char* name)
{
  return data->GetFieldData()->GetArray(name);
}

/// The first place where an array has this value.
vtkIdType firstWith(vtkDataArray* array, double value)
{
  vtkIdType place = 0;
  while (array->GetComponent(place, 0) != value)
  {
    ++place;
  }
  return place;
}

void setFirst(vtkDataArray* array, double value, double other)
{
  array->SetComponent(firstWith(array, value), 0, other);
}

/// Leaves out the first cell all of whose corners have this value.
void dropCell(vtkUnstructuredGrid* balls, double side)
{
  vtkDataArray* sides = pointArray(balls, "Side");
  vtkNew<vtkCellArray> rest;
  bool isDropped = false;
  for (vtkIdType cell = 0; cell < balls->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> corners;
    balls->GetCells()->GetCellAtId(cell, corners);
    bool isDrop = !isDropped;
    for (const vtkIdType corner : *corners)
    {
      isDrop = isDrop && sides->GetComponent(corner, 0) == side;
    }
    isDropped = isDropped || isDrop;
    if (!isDrop)
    {
      rest->InsertNextCell(corners);
    }
  }
  balls->SetCells(VTK_TETRA, rest);
}

const BallBreach ballBreaches[] = {
  { "BallNotThroughItsSample",
    [](vtkUnstructuredGrid* balls) { pointArray(balls, "Radius")->SetComponent(9, 0, 5); },
    { "on ball 9 of radius 5", "'BallSamples'" } },
  { "BallWithoutRadius",
    [](vtkUnstructuredGrid* balls) { pointArray(balls, "Radius")->SetComponent(9, 0, 0); },
    { "'Radius' has the value 0 at 9" } },
  { "BallsMovedAlone",
    [](vtkUnstructuredGrid* balls) {
      for (vtkIdType i = 0; i < balls->GetNumberOfPoints(); ++i)
      {
        balls->GetPoints()->SetPoint(i, 1e80 + 1e70 * static_cast<double>(i), 0, 0);
      }
    },
    { "ball 0 is more than 1e+75 times as far away" } },
  { "BallWithoutSamples",
    [](vtkUnstructuredGrid* balls) {
      vtkDataArray* offsets = fieldArray(balls, "BallSampleOffsets");
      vtkDataArray* items = fieldArray(balls, "BallSamples");
      const double gone = offsets->GetComponent(1, 0);
      for (vtkIdType ball = 1; ball < offsets->GetNumberOfTuples(); ++ball)
      {
        offsets->SetComponent(ball, 0, offsets->GetComponent(ball, 0) - gone);
      }
      for (double i = 0; i < gone; ++i)
      {
        items->RemoveTuple(0);
      }
    },
    { "ball 0 has no sample", "'BallSamples'" } },
  { "VolumeOfAnOuterBall",
    [](vtkUnstructuredGrid* balls) {
      pointArray(balls, "Volume")->SetComponent(firstWith(pointArray(balls, "Side"), 0), 0, 0.5);
    },
    { "'Volume' has the value 0.5 at ", "0 where the ball isn't inside" } },
  { "VolumeBelowThePoleVolume",
    [](vtkUnstructuredGrid* balls) {
      pointArray(balls, "PoleVolume")
        ->SetComponent(firstWith(pointArray(balls, "Side"), 1), 0, 1e9);
    },
    { "'Volume' has the value ", "'PoleVolume', 1e+09" } },
  { "VolumesWithoutASum",
    [](vtkUnstructuredGrid* balls) {
      vtkDataArray* volumes = pointArray(balls, "Volume");
      for (vtkIdType i = 0; i < volumes->GetNumberOfTuples(); ++i)
      {
        volumes->SetComponent(i, 0, pointArray(balls, "Side")->GetComponent(i, 0) == 1 ? 1e308 : 0);
      }
    },
    { "the sum of the point array 'Volume'" } },
  { "InnerBallThatTouchesTheGuard",
    [](vtkUnstructuredGrid* balls) {
      pointArray(balls, "TouchesGuard")
        ->SetComponent(firstWith(pointArray(balls, "Side"), 1), 0, 1);
    },
    { "'Side'", "'TouchesGuard' says that it is outside" } },
  { "InnerBallOfASampleOutside",
    [](vtkUnstructuredGrid* balls) {
      fieldArray(balls, "SampleInnerBall")
        ->SetComponent(4, 0, static_cast<double>(firstWith(pointArray(balls, "Side"), 0)));
    },
    { "'SampleInnerBall' has the ball ", " at 4", "'Side'" } },
  { "OuterBallOfASampleInside",
    [](vtkUnstructuredGrid* balls) {
      fieldArray(balls, "SampleOuterBall")
        ->SetComponent(4, 0, static_cast<double>(firstWith(pointArray(balls, "Side"), 1)));
    },
    { "'SampleOuterBall' has the ball ", " at 4", "'Side'" } },
  { "SpacingAboveTheDiagonal",
    [](vtkUnstructuredGrid* balls) { fieldArray(balls, "SampleSpacing")->Fill(100); },
    { "'SampleSpacing' has the value 100", "diagonal" } },
  { "SpacingOfNothing",
    [](vtkUnstructuredGrid* balls) { fieldArray(balls, "SampleSpacing")->Fill(1e-300); },
    { "'SampleSpacing' has the value 1e-300", "only numbers from " } },
  { "SamplesInOnePlace", [](vtkUnstructuredGrid* balls) { fieldArray(balls, "Samples")->Fill(1); },
    { "all samples are in the same place" } },
  { "TurnedTetrahedron",
    [](vtkUnstructuredGrid* balls) {
      vtkDataArray* corners = balls->GetCells()->GetConnectivityArray();
      for (vtkIdType cell = 0; cell < balls->GetNumberOfCells(); ++cell)
      {
        const double first = corners->GetComponent(4 * cell, 0);
        corners->SetComponent(4 * cell, 0, corners->GetComponent(4 * cell + 1, 0));
        corners->SetComponent(4 * cell + 1, 0, first);
      }
    },
    { "the corners of tetrahedron ", "wrong order" } },
  { "TetrahedronTwice",
    [](vtkUnstructuredGrid* balls) {
      vtkNew<vtkIdList> corners;
      balls->GetCells()->GetCellAtId(0, corners);
      vtkNew<vtkCellArray> cells;
      cells->DeepCopy(balls->GetCells());
      cells->InsertNextCell(corners);
      balls->SetCells(VTK_TETRA, cells);
    },
    { "a triangle has more than two of them" } },
  { "MissingInnerTetrahedron", [](vtkUnstructuredGrid* balls) { dropCell(balls, 1); },
    { " is inside the solid, but beside tetrahedron " } },
  { "MissingOuterTetrahedron", [](vtkUnstructuredGrid* balls) { dropCell(balls, 0); },
    { "have holes between them" } },
  { "TypesForHalfOfTheCells",
    [](vtkUnstructuredGrid* balls) {
      balls->GetCellTypesArray()->Resize(balls->GetNumberOfCells() / 2);
    },
    { " cells, but types for " } },
  { "PointsWithFourCoordinates",
    [](vtkUnstructuredGrid* balls) {
      const vtkIdType count = balls->GetNumberOfPoints();
      balls->GetPoints()->GetData()->SetNumberOfComponents(4);
      balls->GetPoints()->GetData()->SetNumberOfTuples(count);
      balls->GetPoints()->GetData()->Fill(0);
    },
    { "the points have 4 coordinates each instead of 3" } },
};

/// A ball that isn't on the axis and has an owner.
vtkIdType ownedBall(vtkPolyData* axis)
{
  vtkDataArray* owners = fieldArray(axis, "BallOwner");
  vtkIdType ball = 0;
  while (owners->GetComponent(ball, 0) < 0 || owners->GetComponent(ball, 0) == ball)
  {
    ++ball;
  }
  return ball;
}

/// Adds a cell of these points; the cells' arrays get one more entry, like that of the last cell.
void addCell(vtkPolyData* axis, vtkCellArray* cells, const std::vector<vtkIdType>& corners)
{
  cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  for (int i = 0; i < axis->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = axis->GetCellData()->GetAbstractArray(i);
    array->InsertNextTuple(array->GetNumberOfTuples() - 1, array);
  }
}

std::vector<vtkIdType> firstTriangle(vtkPolyData* axis)
{
  vtkNew<vtkIdList> corners;
  axis->GetPolys()->GetCellAtId(0, corners);
  return { corners->begin(), corners->end() };
}

const AxisBreach axisBreaches[] = {
  { "OwnerThatOwnsNothing",
    [](vtkPolyData* axis) {
      const auto owned = static_cast<double>(ownedBall(axis));
      setFirst(fieldArray(axis, "BallOwner"), -1, owned);
    },
    { "'BallOwner' has the value ", "doesn't own itself" } },
  { "BallOnTheAxisOwnedByAnother",
    [](vtkPolyData* axis) {
      const auto ball = static_cast<vtkIdType>(pointArray(axis, "BallId")->GetComponent(0, 0));
      fieldArray(axis, "BallOwner")->SetComponent(ball, 0, -1);
    },
    { "'BallOwner' is -1", "owns itself where it is on the axis" } },
  { "OwnerThatIsNotOnTheAxis",
    [](vtkPolyData* axis) {
      const vtkIdType ball = ownedBall(axis);
      fieldArray(axis, "BallOwner")->SetComponent(ball, 0, static_cast<double>(ball));
    },
    { "isn't in the point array 'BallId'" } },
  { "PoleVolumeAboveTheVolume",
    [](vtkPolyData* axis) { fieldArray(axis, "BallPoleVolume")->SetComponent(3, 0, 1e9); },
    { "'BallPoleVolume' has the value 1e+09 at 3", "'BallVolume'" } },
  { "VolumesWithoutASum", [](vtkPolyData* axis) { fieldArray(axis, "BallVolume")->Fill(1e308); },
    { "the sum of the field array 'BallVolume'" } },
  { "TriangleTwice",
    [](vtkPolyData* axis) { addCell(axis, axis->GetPolys(), firstTriangle(axis)); },
    { "the axis has a triangle with the points ", " twice" } },
  { "LineThatIsASideOfATriangle",
    [](vtkPolyData* axis) {
      std::vector<vtkIdType> corners = firstTriangle(axis);
      corners.pop_back();
      addCell(axis, axis->GetLines(), corners);
    },
    { " of the axis is there twice or is a side of a triangle" } },
  { "VertexThatIsInATriangle",
    [](vtkPolyData* axis) {
      vtkNew<vtkCellArray> vertices;
      axis->SetVerts(vertices);
      addCell(axis, vertices, { firstTriangle(axis)[0] });
    },
    { "of the axis is there twice or is in a higher cell" } },
  { "OtherTopology",
    [](vtkPolyData* axis) { fieldArray(axis, "BettiAxis")->SetComponent(0, 1, 7); },
    { "'BettiAxis' doesn't tell the topology" } },
  { "FalseCertificate", [](vtkPolyData* axis) { fieldArray(axis, "Certificate")->Fill(0); },
    { "'Certificate' doesn't say whether" } },
  { "PointTooFarAway", [](vtkPolyData* axis) { axis->GetPoints()->SetPoint(5, 0, 1e80, 0); },
    { "point 5 of the axis has a coordinate above 1e+70" } },
  { "RadiusTooLarge",
    [](vtkPolyData* axis) { pointArray(axis, "Radius")->SetComponent(5, 0, 1e80); },
    { "'Radius' of the axis has the value 1e+80 at 5" } },
  { "AngleAboveHalfATurn",
    [](
      vtkPolyData* axis) { axis->GetCellData()->GetArray("ObjectAngle")->SetComponent(2, 0, 200); },
    { "cell 2 of the axis sees its sites at an angle of 200 degrees" } },
  { "PartBeyondTheNumberOfParts",
    [](vtkPolyData* axis) { fieldArray(axis, "NumberOfParts")->Fill(1); },
    { "cell array 'PartId' has the value " } },
};

void expectSays(const std::string& error, const std::vector<std::string>& words)
{
  for (const std::string& word : words)
  {
    EXPECT_NE(error.find(word), std::string::npos) << error;
  }
}

/// The only error of a filter, without VTK's file, line and object.
std::string onlyWords(vtkAlgorithm* filter)
{
  const std::string error = filterTest::onlyError(filter), object = "): ";
  return error.substr(error.find(object) + object.size());
}

class BallInvariants : public testing::TestWithParam<BallBreach>
{
};

TEST_P(BallInvariants, AreCheckedByEveryStageThatReadsBalls)
{
  const auto balls = filterTest::copy<vtkUnstructuredGrid>(boxPipeline().balls->GetOutput());
  this->GetParam().damage(balls);
  vtkNew<vtkMedialAxis> axis;
  axis->SetInputData(balls);
  const std::string words = onlyWords(axis);
  expectSays(words, this->GetParam().says);
  vtkNew<vtkPowerCrust> crust;
  crust->SetInputData(balls);
  EXPECT_EQ(onlyWords(crust), words);
  vtkNew<vtkLocalThickness> thickness; // reads them without neighbours
  thickness->SetInputData(balls);
  EXPECT_EQ(onlyWords(thickness), words);
}

INSTANTIATE_TEST_SUITE_P(
  All, BallInvariants, testing::ValuesIn(ballBreaches), nameOf<vtkUnstructuredGrid>);

class AxisInvariants : public testing::TestWithParam<AxisBreach>
{
};

TEST_P(AxisInvariants, AreCheckedByEveryStageThatReadsAnAxis)
{
  const auto axis = filterTest::copy<vtkPolyData>(boxPipeline().parts->GetOutput());
  this->GetParam().damage(axis);
  const bool isOfParts = this->GetParam().says[0].find("PartId") != std::string::npos;
  vtkNew<vtkMedialPartDecomposition> parts;
  parts->SetInputData(axis);
  vtkNew<vtkMedialPrune> prune;
  prune->SetInputData(axis);
  if (!isOfParts) // those make the parts anew
  {
    expectSays(filterTest::onlyError(parts), this->GetParam().says);
    expectSays(filterTest::onlyError(prune), this->GetParam().says);
  }
  vtkNew<vtkPowerCrust> crust;
  crust->SetInputData(boxPipeline().balls->GetOutput());
  crust->SetAxisData(axis);
  expectSays(filterTest::onlyError(crust), this->GetParam().says);
}

INSTANTIATE_TEST_SUITE_P(All, AxisInvariants, testing::ValuesIn(axisBreaches), nameOf<vtkPolyData>);
}
