// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include <vtkAbstractArray.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkMassProperties.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>

#include <functional>
#include <limits>
#include <map>
#include <sstream>

namespace
{
using filterTest::arrays;
using filterTest::boxPipeline;
using filterTest::ErrorLog;
using filterTest::onlyError;
using filterTest::same;
using filterTest::smallBox;
using medial::Point;

/// The filter on the balls of the box, without an axis.
vtkSmartPointer<vtkPowerCrust> boxCrust()
{
  auto filter = vtkSmartPointer<vtkPowerCrust>::New();
  filter->SetInputData(boxPipeline().balls->GetOutput());
  return filter;
}

double field(vtkDataObject* data, const char* name, int component = 0)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, component);
}

TEST(PowerCrust, HasTheArraysOfItsHeader)
{
  vtkPolyData* crust = boxPipeline().crust->GetOutput();
  EXPECT_EQ(arrays(crust->GetPointData()), (std::vector<std::string>{ "SampleId idtype 1" }));
  EXPECT_EQ(arrays(crust->GetCellData()),
    (std::vector<std::string>{
      "InnerBall idtype 1", "OuterBall idtype 1", "PartId idtype 1", "PartRank idtype 1" }));
  std::vector<std::string> expected = filterTest::passedOn(boxPipeline().balls->GetOutput());
  for (const char* array : { "BettiCrust idtype 3", "Closed unsigned char 1",
         "InsertedBalls idtype 1", "Manifold unsigned char 1", "MaximumClearance double 1",
         "MovedAtMost double 1", "MovedBy double 1", "PutBackBalls idtype 1",
         "RefusedBalls idtype 1", "Rounds idtype 1", "Verdict string 1", "Volume double 1" })
  {
    expected.emplace_back(array);
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(arrays(crust->GetFieldData()), expected);
}

TEST(PowerCrust, ClosesTheBox)
{
  vtkSmartPointer<vtkPowerCrust> filter = boxCrust();
  filter->Update();
  vtkPolyData* crust = filter->GetOutput();
  EXPECT_EQ(field(crust, "Closed"), 1);
  EXPECT_EQ(field(crust, "Manifold"), 1);
  EXPECT_EQ(field(crust, "BettiCrust", 0), 1);
  EXPECT_EQ(field(crust, "BettiCrust", 1), 0);
  EXPECT_EQ(field(crust, "BettiCrust", 2), 0);
  EXPECT_NEAR(field(crust, "Volume"), smallBox().volume, 0.1 * smallBox().volume);
}

TEST(PowerCrust, LooksOutwards)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(boxPipeline().crust->GetOutput());
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(triangles->GetOutputPort());
  mass->Update();
  EXPECT_NEAR(mass->GetVolume(), field(boxPipeline().crust->GetOutput(), "Volume"), 1e-6);
}

TEST(PowerCrust, GoesThroughItsSamples)
{
  vtkPolyData* crust = boxPipeline().crust->GetOutput();
  vtkIdType samples = 0;
  for (vtkIdType i = 0; i < crust->GetNumberOfPoints(); ++i)
  {
    const double sample = crust->GetPointData()->GetArray("SampleId")->GetComponent(i, 0);
    if (sample >= 0)
    {
      ++samples;
      EXPECT_EQ(Point(crust->GetPoint(i)), smallBox().samples[static_cast<std::size_t>(sample)]);
    }
  }
  EXPECT_GT(samples, static_cast<vtkIdType>(smallBox().samples.size() / 2));
}

TEST(PowerCrust, LiesBetweenInnerAndOuterBalls)
{
  vtkDataArray* sides = boxPipeline().balls->GetOutput()->GetPointData()->GetArray("Side");
  vtkCellData* faces = boxPipeline().crust->GetOutput()->GetCellData();
  for (vtkIdType i = 0; i < faces->GetNumberOfTuples(); ++i)
  {
    const auto inner = static_cast<vtkIdType>(faces->GetArray("InnerBall")->GetComponent(i, 0));
    const auto outer = static_cast<vtkIdType>(faces->GetArray("OuterBall")->GetComponent(i, 0));
    EXPECT_EQ(sides->GetComponent(inner, 0), 1);
    EXPECT_TRUE(outer < 0 || sides->GetComponent(outer, 0) == 0);
  }
}

TEST(PowerCrust, KnowsThePartsOfItsFaces)
{
  vtkDataArray* parts = boxPipeline().crust->GetOutput()->GetCellData()->GetArray("PartId");
  EXPECT_GE(parts->GetRange()[0], 0);
  EXPECT_LT(parts->GetRange()[1], field(boxPipeline().prune->GetOutput(), "NumberOfParts"));
  EXPECT_GT(parts->GetRange()[1], 0);
}

TEST(PowerCrust, KnowsTheRanksOfItsParts)
{
  const auto ranksOfParts = [](vtkPolyData* data) {
    std::map<double, double> result;
    vtkCellData* cells = data->GetCellData();
    for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    {
      result[cells->GetArray("PartId")->GetComponent(i, 0)] =
        cells->GetArray("PartRank")->GetComponent(i, 0);
    }
    return result;
  };
  const std::map<double, double> axis = ranksOfParts(boxPipeline().prune->GetOutput());
  for (const auto& [part, rank] : ranksOfParts(boxPipeline().crust->GetOutput()))
  {
    EXPECT_EQ(rank, axis.at(part));
  }
}

TEST(PowerCrust, HasNoPartsWithoutAnAxisThatHasThem)
{
  vtkSmartPointer<vtkPowerCrust> filter = boxCrust();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("PartId")->GetRange()[1], -1);
  filter->SetAxisData(boxPipeline().axis->GetOutput());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("PartId")->GetRange()[1], -1);
}

TEST(PowerCrust, IsTheSameWithAnAxisThatWasNotPruned)
{
  vtkSmartPointer<vtkPowerCrust> without = boxCrust(), with = boxCrust();
  with->SetAxisData(boxPipeline().axis->GetOutput());
  without->SetRuleToInnerOnly();
  with->SetRuleToInnerOnly();
  const ErrorLog log(without, vtkCommand::WarningEvent);
  without->Update();
  with->Update();
  const auto surface = filterTest::copy<vtkPolyData>(without->GetOutput());
  EXPECT_EQ(log.messages().size(), 1u); // it has no axis, and so another verdict
  surface->GetFieldData()->RemoveArray("VerdictReasons");
  surface->GetFieldData()->AddArray(with->GetOutput()->GetFieldData()->GetAbstractArray("Verdict"));
  EXPECT_TRUE(same(with->GetOutput(), surface));
}

TEST(PowerCrust, ShrinksWhereTheAxisWasPruned)
{
  vtkNew<vtkMedialPrune> prune;
  prune->SetInputData(boxPipeline().parts->GetOutput());
  prune->SetSchedule("v20%");
  vtkSmartPointer<vtkPowerCrust> all = boxCrust(), some = boxCrust();
  some->SetAxisConnection(prune->GetOutputPort());
  all->Update();
  some->Update();
  EXPECT_LT(field(some->GetOutput(), "Volume"), 0.9 * field(all->GetOutput(), "Volume"));
  EXPECT_LE(field(some->GetOutput(), "MaximumClearance"), 1 + 1e-9);
  EXPECT_GT(field(some->GetOutput(), "InsertedBalls"), 0);
  EXPECT_EQ(some->GetOutput()->GetCellData()->GetArray("OuterBall")->GetRange()[0], -1);
  EXPECT_EQ(field(some->GetOutput(), "Closed"), 1);
}

TEST(PowerCrust, RefusesTheAxisOfOtherBalls)
{
  filterTest::Pipeline other(filterTest::cloud(shapes::sphere(0.5).samples));
  vtkSmartPointer<vtkPowerCrust> filter = boxCrust();
  filter->SetAxisConnection(other.prune->GetOutputPort());
  const std::string error = onlyError(filter);
  EXPECT_NE(error.find("the axis was made from "), std::string::npos) << error;
  EXPECT_NE(error.find("vtkMedialPrune made from these"), std::string::npos) << error;
}

TEST(PowerCrust, RefusesTheAxisOfAsManyOtherBalls)
{
  std::vector<Point> moved = smallBox().samples;
  for (Point& sample : moved)
  {
    sample += Point(1, 2, 4);
  }
  const std::vector<Point> larger = shapes::scaled(smallBox().samples, 2);
  for (const std::vector<Point>& samples : { larger, moved })
  {
    filterTest::Pipeline other(filterTest::cloud(samples));
    other.prune->Update();
    ASSERT_EQ(other.balls->GetOutput()->GetNumberOfPoints(),
      boxPipeline().balls->GetOutput()->GetNumberOfPoints());
    vtkSmartPointer<vtkPowerCrust> filter = boxCrust();
    filter->SetAxisData(other.prune->GetOutput());
    const std::string error = onlyError(filter);
    EXPECT_NE(error.find("the axis was made from other balls than these"), std::string::npos)
      << error;
    EXPECT_NE(error.find("vtkMedialPrune made from these"), std::string::npos) << error;
  }
}

TEST(PowerCrust, RefusesAnAxisAtAnotherPlace)
{
  const auto axis = filterTest::copy<vtkPolyData>(boxPipeline().axis->GetOutputDataObject(0));
  vtkDataArray* coordinates = axis->GetPoints()->GetData();
  for (vtkIdType i = 0; i < axis->GetNumberOfPoints(); ++i)
  {
    coordinates->SetComponent(i, 2, coordinates->GetComponent(i, 2) + 1);
  }
  vtkSmartPointer<vtkPowerCrust> filter = boxCrust();
  filter->SetAxisData(axis);
  const std::string error = onlyError(filter);
  EXPECT_NE(error.find("the axis was made from other balls than these"), std::string::npos)
    << error;
}

/// The first ball that is a corner of a tetrahedron.
vtkIdType cornerOf(vtkUnstructuredGrid* balls)
{
  return balls->GetCell(0)->GetPointId(0);
}

TEST(PowerCrust, RefusesAHiddenBallInATetrahedron)
{
  const auto balls = filterTest::copy<vtkUnstructuredGrid>(boxPipeline().balls->GetOutput());
  const vtkIdType corner = cornerOf(balls);
  balls->GetPointData()->GetArray("Side")->SetComponent(corner, 0, 2);
  vtkNew<vtkPowerCrust> filter;
  filter->SetInputData(balls);
  const std::string error = onlyError(filter);
  EXPECT_NE(error.find("ball " + std::to_string(corner)), std::string::npos) << error;
  EXPECT_NE(error.find("'Side'"), std::string::npos) << error;
  EXPECT_NE(error.find("take the output of vtkPolarBalls"), std::string::npos) << error;
}

TEST(PowerCrust, RefusesAVisibleBallInNoTetrahedron)
{
  const auto balls = filterTest::copy<vtkUnstructuredGrid>(boxPipeline().balls->GetOutput());
  const vtkIdType added = balls->GetNumberOfPoints();
  const auto one = filterTest::copy<vtkUnstructuredGrid>(balls);
  for (vtkIdType cell = 0; cell < one->GetNumberOfCells(); ++cell)
  {
    // All tetrahedra at a ball go: they are replaced by another one.
    vtkIdList* corners = one->GetCell(cell)->GetPointIds();
    if (corners->IsId(cornerOf(balls)) >= 0)
    {
      one->GetCells()->ReplaceCellAtId(
        cell, one->GetCell(one->GetNumberOfCells() - 1)->GetPointIds());
    }
  }
  EXPECT_GT(added, 0);
  vtkNew<vtkPowerCrust> filter;
  filter->SetInputData(one);
  const std::string error = onlyError(filter);
  EXPECT_NE(error.find("ball " + std::to_string(cornerOf(balls))), std::string::npos) << error;
}

TEST(PowerCrust, RefusesACentreAtTheEndOfTheWorld)
{
  for (const double far : { 1e160, 1e300, -1e300 })
  {
    const auto balls = filterTest::copy<vtkUnstructuredGrid>(boxPipeline().balls->GetOutput());
    balls->GetPoints()->GetData()->SetComponent(cornerOf(balls), 1, far);
    vtkNew<vtkPowerCrust> filter;
    filter->SetInputData(balls);
    const std::string error = onlyError(filter);
    EXPECT_NE(error.find("ball " + std::to_string(cornerOf(balls))), std::string::npos) << error;
  }
}

TEST(PowerCrust, RefusesAnAxisWithoutCells)
{
  const auto axis = filterTest::copy<vtkPolyData>(boxPipeline().axis->GetOutputDataObject(0));
  axis->SetPolys(nullptr);
  axis->SetLines(nullptr);
  axis->SetVerts(nullptr);
  for (int i = 0; i < axis->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = axis->GetCellData()->GetAbstractArray(i);
    const auto none = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
    none->SetName(array->GetName());
    none->SetNumberOfComponents(array->GetNumberOfComponents());
    axis->GetCellData()->AddArray(none);
  }
  axis->GetFieldData()->GetArray("BettiAxis")->Fill(0);
  axis->GetFieldData()->GetArray("Certificate")->Fill(0);
  vtkSmartPointer<vtkPowerCrust> filter = boxCrust();
  filter->SetAxisData(axis);
  const std::string error = onlyError(filter);
  EXPECT_NE(error.find("no inner ball is left"), std::string::npos) << error;
}

TEST(PowerCrust, RefusesPartsThatCanNotBe)
{
  const auto axis = filterTest::copy<vtkPolyData>(boxPipeline().prune->GetOutputDataObject(0));
  axis->GetCellData()->GetArray("PartId")->SetComponent(3, 0, 2e9);
  vtkSmartPointer<vtkPowerCrust> filter = boxCrust();
  filter->SetAxisData(axis);
  const std::string error = onlyError(filter);
  EXPECT_NE(error.find("the cell array 'PartId' has the value 2e+09 at 3"), std::string::npos)
    << error;
}

TEST(PowerCrust, RefusesAClearanceThatIsNotPositive)
{
  for (const double clearance : { 0., -1., std::numeric_limits<double>::quiet_NaN() })
  {
    vtkSmartPointer<vtkPowerCrust> filter = boxCrust();
    filter->SetClearance(clearance);
    const std::string error = onlyError(filter);
    EXPECT_NE(error.find("clearance"), std::string::npos) << error;
  }
}

TEST(PowerCrust, RunsAgainWhenAPropertyChanges)
{
  vtkSmartPointer<vtkPowerCrust> filter = boxCrust();
  EXPECT_EQ(filter->GetRule(), vtkPowerCrust::CLEARANCE);
  EXPECT_EQ(filter->GetClearance(), 1);
  EXPECT_EQ(filter->GetMaximumRounds(), 10);
  const std::vector<std::function<void()>> changes = {
    [&] { filter->SetRuleToInnerOnly(); },
    [&] { filter->SetRuleToInnerAndOuter(); },
    [&] { filter->SetRuleToClearance(); },
    [&] { filter->SetClearance(0.5); },
    [&] { filter->SetMaximumRounds(3); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const vtkMTimeType before = filter->GetMTime();
    changes[i]();
    EXPECT_GT(filter->GetMTime(), before) << "change " << i;
  }
}

TEST(PowerCrust, DescribesItsProperties)
{
  std::ostringstream text;
  boxPipeline().crust->Print(text);
  for (const char* word : { "Rule: 0", "Clearance: 1", "MaximumRounds: 10" })
  {
    EXPECT_NE(text.str().find(word), std::string::npos) << word;
  }
}
}
