// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"
#include "vtkSimplifyShape.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

namespace
{
using filterTest::arrays;
using filterTest::boxPipeline;
using filterTest::onlyError;
using medial::Point;

/// What the filter says about the balls of the box after a change.
template <typename Change>
std::string refusal(const Change& change)
{
  const auto balls =
    filterTest::copy<vtkUnstructuredGrid>(boxPipeline().balls->GetOutputDataObject(0));
  change(balls.Get());
  vtkNew<vtkMedialAxis> filter;
  filter->SetInputData(balls);
  return onlyError(filter);
}

TEST(MedialAxis, HasTheArraysOfItsHeader)
{
  vtkPolyData* axis = boxPipeline().axis->GetOutput();
  EXPECT_EQ(arrays(axis->GetPointData()),
    (std::vector<std::string>{ "BallId idtype 1", "ErosionThickness double 1",
      "MaximumInscribedSphereRadius double 1", "Radius double 1" }));
  EXPECT_EQ(arrays(axis->GetCellData()),
    (std::vector<std::string>{ "ErosionThickness double 1", "Lambda double 1",
      "ObjectAngle double 1", "PolygonId idtype 1", "SiteSamples idtype 2" }));
  std::vector<std::string> expected = filterTest::passedOn(boxPipeline().balls->GetOutput());
  for (const char* array :
    { "BallOwner idtype 1", "BallPoleVolume double 1", "BallVolume double 1", "BettiAxis idtype 3",
      "BettiUnprunedAxis idtype 3", "Certificate unsigned char 1", "Fallback unsigned char 1",
      "FilledGaps idtype 1", "Kappa double 1", "NumberOfOffAxisBalls idtype 1",
      "SampleDiagonal double 1", "TopologyKept unsigned char 1" })
  {
    expected.emplace_back(array);
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(arrays(axis->GetFieldData()), expected);
}

TEST(MedialAxis, HasDoublesAsPoints)
{
  EXPECT_EQ(boxPipeline().axis->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
}

TEST(MedialAxis, HasItsPointsInTheirBalls)
{
  vtkUnstructuredGrid* balls = boxPipeline().balls->GetOutput();
  vtkPolyData* axis = boxPipeline().axis->GetOutput();
  vtkDataArray* radii = axis->GetPointData()->GetArray("Radius");
  vtkIdType onBalls = 0;
  for (vtkIdType i = 0; i < axis->GetNumberOfPoints(); ++i)
  {
    const auto ball =
      static_cast<vtkIdType>(axis->GetPointData()->GetArray("BallId")->GetComponent(i, 0));
    if (ball >= 0)
    {
      ++onBalls;
      EXPECT_EQ(balls->GetPointData()->GetArray("Radius")->GetComponent(ball, 0),
        radii->GetComponent(i, 0));
      EXPECT_EQ(Point(balls->GetPoint(ball)), Point(axis->GetPoint(i)));
    }
  }
  EXPECT_GT(onBalls, axis->GetNumberOfPoints() / 4);
}

TEST(MedialAxis, HasItsRadiiUnderBothNames)
{
  vtkPointData* points = boxPipeline().axis->GetOutput()->GetPointData();
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    EXPECT_EQ(points->GetArray("Radius")->GetComponent(i, 0),
      points->GetArray("MaximumInscribedSphereRadius")->GetComponent(i, 0));
  }
}

TEST(MedialAxis, SaysThatItsTopologyWasVerified)
{
  vtkFieldData* field = boxPipeline().axis->GetOutput()->GetFieldData();
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(field->GetArray("BettiAxis")->GetComponent(0, i), i == 0 ? 1 : 0);
    EXPECT_EQ(field->GetArray("BettiPowerShape")->GetComponent(0, i), i == 0 ? 1 : 0);
  }
  EXPECT_EQ(field->GetArray("Certificate")->GetComponent(0, 0), 1);
}

TEST(MedialAxis, CountsBallsThatOthersOwn)
{
  vtkFieldData* field = boxPipeline().axis->GetOutput()->GetFieldData();
  vtkDataArray* owners = field->GetArray("BallOwner");
  vtkIdType owned = 0;
  for (vtkIdType ball = 0; ball < owners->GetNumberOfTuples(); ++ball)
  {
    const auto owner = static_cast<vtkIdType>(owners->GetComponent(ball, 0));
    owned += owner >= 0 && owner != ball;
    EXPECT_TRUE(owner < 0 || owners->GetComponent(owner, 0) == owner);
  }
  EXPECT_EQ(field->GetArray("NumberOfOffAxisBalls")->GetComponent(0, 0), owned);
}

TEST(MedialAxis, RunsAgainWhenTheFallbackChanges)
{
  vtkNew<vtkMedialAxis> filter;
  EXPECT_EQ(filter->GetFallback(), vtkMedialAxis::COLLAPSE);
  const vtkMTimeType before = filter->GetMTime();
  filter->SetFallbackToCollapse();
  EXPECT_EQ(filter->GetMTime(), before);
  filter->SetFallbackToNearest();
  EXPECT_GT(filter->GetMTime(), before);
  filter->SetFallback(77);
  EXPECT_EQ(filter->GetFallback(), vtkMedialAxis::NEAREST);
}

TEST(MedialAxis, IsTrimmedOnRequest)
{
  vtkNew<vtkMedialAxis> filter;
  EXPECT_EQ(filter->GetTrim(), 0);
  filter->SetTrim(-1);
  EXPECT_EQ(filter->GetTrim(), 0);
  filter->SetInputConnection(boxPipeline().balls->GetOutputPort());
  filter->Update();
  const vtkIdType whole = filter->GetOutput()->GetNumberOfCells();
  filter->SetTrim(1);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_LT(filter->GetOutput()->GetNumberOfCells(), whole);
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("Certificate")->GetTuple1(0), 1);
}

/// Balls of what was trimmed share the fate of others.
TEST(MedialAxis, LeavesTheSurfaceWhereItIsTrimmed)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(filterTest::cloud(filterTest::smallBox().samples));
  simplify->SetSchedule("");
  simplify->Update();
  vtkNew<vtkPolyData> whole;
  whole->DeepCopy(simplify->GetOutput());
  const vtkIdType cells =
    vtkPolyData::SafeDownCast(simplify->GetOutputDataObject(1))->GetNumberOfCells();
  simplify->SetTrim(0.5);
  simplify->Update();
  vtkPolyData* axis = vtkPolyData::SafeDownCast(simplify->GetOutputDataObject(1));
  EXPECT_LT(axis->GetNumberOfCells(), cells);
  ASSERT_EQ(simplify->GetOutput()->GetNumberOfPoints(), whole->GetNumberOfPoints());
  for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(medial::Point(simplify->GetOutput()->GetPoint(i)), medial::Point(whole->GetPoint(i)));
  }
}

TEST(MedialAxis, RefusesBallsThatAreAllOutside)
{
  const std::string error = refusal([](vtkUnstructuredGrid* balls) {
    for (const char* name : { "Side", "Volume", "PoleVolume" })
    {
      balls->GetPointData()->GetArray(name)->Fill(0);
    }
    balls->GetFieldData()->GetArray("SampleInnerBall")->Fill(-1);
  });
  EXPECT_NE(error.find("no ball is inside the solid"), std::string::npos) << error;
}

TEST(MedialAxis, RefusesCellsThatAreNoTetrahedra)
{
  const std::string error = refusal([](vtkUnstructuredGrid* balls) {
    const vtkIdType corners[] = { 0, 1, 2 };
    balls->InsertNextCell(VTK_TRIANGLE, 3, corners);
  });
  EXPECT_NE(error.find("is no tetrahedron: take the output of vtkPolarBalls"), std::string::npos)
    << error;
}

TEST(MedialAxis, RefusesCellsWithACornerThatIsNotThere)
{
  for (const vtkIdType corner : { vtkIdType(-1), vtkIdType(1) << 40 })
  {
    const std::string error = refusal([corner](vtkUnstructuredGrid* balls) {
      balls->GetCells()->GetConnectivityArray()->SetComponent(5, 0, static_cast<double>(corner));
    });
    EXPECT_NE(error.find("a cell has the corner " + std::to_string(corner)), std::string::npos)
      << error;
  }
}

TEST(MedialAxis, RefusesCellsWithACornerTwice)
{
  const std::string error = refusal([](vtkUnstructuredGrid* balls) {
    vtkDataArray* corners = balls->GetCells()->GetConnectivityArray();
    corners->SetComponent(5, 0, corners->GetComponent(4, 0));
  });
  EXPECT_NE(error.find("twice"), std::string::npos) << error;
}

TEST(MedialAxis, RefusesATetrahedronTwice)
{
  const std::string error = refusal([](vtkUnstructuredGrid* balls) {
    vtkDataArray* corners = balls->GetCells()->GetConnectivityArray();
    for (vtkIdType i = 0; i < 4; ++i)
    {
      corners->SetComponent(4 + i, 0, corners->GetComponent(i, 0));
      corners->SetComponent(8 + i, 0, corners->GetComponent(i, 0));
    }
  });
  EXPECT_NE(error.find("no triangulation"), std::string::npos) << error;
}

TEST(MedialAxis, RefusesBallsAtNoPlace)
{
  const std::string error = refusal(
    [](vtkUnstructuredGrid* balls) { balls->GetPoints()->SetPoint(3, 0, std::nan(""), 0); });
  EXPECT_NE(error.find("point 3 has a coordinate that is not finite"), std::string::npos) << error;
}

TEST(MedialAxis, RefusesBallsOfNegativeRadius)
{
  const std::string error = refusal([](vtkUnstructuredGrid* balls) {
    balls->GetPointData()->GetArray("Radius")->SetComponent(9, 0, -1);
  });
  EXPECT_NE(error.find("'Radius' has the value -1 at 9"), std::string::npos) << error;
}

TEST(MedialAxis, RefusesListsThatDontAscend)
{
  const std::string offsets = refusal([](vtkUnstructuredGrid* balls) {
    vtkDataArray* array = balls->GetFieldData()->GetArray("BallSampleOffsets");
    array->SetComponent(2, 0, array->GetComponent(4, 0));
    array->SetComponent(3, 0, array->GetComponent(1, 0));
  });
  EXPECT_NE(offsets.find("'BallSampleOffsets' does not ascend"), std::string::npos) << offsets;
  const std::string items = refusal([](vtkUnstructuredGrid* balls) {
    vtkDataArray* array = balls->GetFieldData()->GetArray("BallSamples");
    array->SetComponent(1, 0, array->GetComponent(0, 0));
  });
  EXPECT_NE(
    items.find("list 0 in the field array 'BallSamples' does not ascend"), std::string::npos)
    << items;
}

TEST(MedialAxis, RefusesAnEmptyGrid)
{
  vtkNew<vtkUnstructuredGrid> nothing;
  vtkNew<vtkMedialAxis> filter;
  filter->SetInputData(nothing);
  EXPECT_NE(onlyError(filter).find("take the output of vtkPolarBalls"), std::string::npos);
}
}
