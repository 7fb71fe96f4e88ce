// SPDX-License-Identifier: BSD-3-Clause
// What the filters say about doubtful inputs and results: warnings, and the verdict on all stages.
#include "StageTest.h"

#include "vtkSimplifyShape.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <memory>
#include <string>
#include <vector>

namespace
{
using filterTest::boxPipeline;
using filterTest::cloud;
using filterTest::ErrorLog;
using filterTest::onlyError;
using filterTest::Pipeline;
using filterTest::same;
using filterTest::smallBox;

const char* const warningArrays[] = { "WarningCode", "WarningText", "WarningCount", "WarningPlace",
  "WarningHasPlace", "WarningDoubtsSolid" };

vtkSmartPointer<vtkStringArray> texts(const char* name, const std::vector<std::string>& values)
{
  auto result = vtkSmartPointer<vtkStringArray>::New();
  result->SetName(name);
  for (const std::string& value : values)
  {
    result->InsertNextValue(value);
  }
  return result;
}

std::vector<std::string> texts(vtkDataObject* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  std::vector<std::string> result;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    result.push_back(array->GetValue(i));
  }
  return result;
}

/// Adds one warning, as if a filter before had found it.
void addWarning(vtkDataObject* data, bool doubtsSolid)
{
  vtkNew<vtkIdTypeArray> count;
  vtkNew<vtkDoubleArray> place;
  vtkNew<vtkUnsignedCharArray> hasPlace, doubts;
  count->SetName("WarningCount");
  count->InsertNextValue(7);
  place->SetName("WarningPlace");
  place->SetNumberOfComponents(3);
  place->InsertNextTuple3(1, 2, 3);
  hasPlace->SetName("WarningHasPlace");
  hasPlace->InsertNextValue(1);
  doubts->SetName("WarningDoubtsSolid");
  doubts->InsertNextValue(doubtsSolid);
  vtkFieldData* field = data->GetFieldData();
  field->AddArray(texts("WarningCode", { "made_up" }));
  field->AddArray(texts("WarningText", { "A test has made this up." }));
  field->AddArray(count);
  field->AddArray(place);
  field->AddArray(hasPlace);
  field->AddArray(doubts);
}

/// The small box with a warning about its samples, run to the end.
std::unique_ptr<Pipeline> doubtedBox(bool doubtsSolid)
{
  const vtkSmartPointer<vtkPolyData> samples = cloud(smallBox().samples);
  addWarning(samples, doubtsSolid);
  auto result = std::make_unique<Pipeline>(samples);
  const ErrorLog ofVerdict(result->crust, vtkCommand::WarningEvent);
  result->crust->Update();
  return result;
}

std::vector<vtkAlgorithm*> filtersOf(Pipeline& pipeline)
{
  return { pipeline.balls, pipeline.axis, pipeline.parts, pipeline.prune, pipeline.crust };
}

/// A cube of points on a grid, its sides made of squares. If it isn't whole, a square is missing but none
/// of the points.
vtkSmartPointer<vtkPolyData> gridCube(bool isWhole)
{
  constexpr int n = 12;
  std::vector<medial::Point> points;
  vtkNew<vtkCellArray> squares;
  for (int side = 0; side < 6; ++side)
  {
    const int axis = side / 2;
    const auto first = static_cast<vtkIdType>(points.size());
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; j <= n; ++j)
      {
        medial::Point point;
        point[axis] = side % 2;
        point[(axis + 1) % 3] = double(i) / n;
        point[(axis + 2) % 3] = double(j) / n;
        points.push_back(point);
        if (i < n && j < n && (isWhole || side > 0 || i != 5 || j != 5))
        {
          const vtkIdType at = first + i * (n + 1) + j;
          const vtkIdType corners[] = { at, at + 1, at + n + 2, at + n + 1 };
          squares->InsertNextCell(4, corners);
        }
      }
    }
  }
  vtkSmartPointer<vtkPolyData> result = cloud(points);
  result->SetPolys(squares);
  return result;
}

TEST(Warnings, AreNotThereWhereThereIsNoDoubt)
{
  for (vtkAlgorithm* filter : filtersOf(boxPipeline()))
  {
    vtkFieldData* field = filter->GetOutputDataObject(0)->GetFieldData();
    for (const char* name : warningArrays)
    {
      EXPECT_FALSE(field->HasArray(name)) << filter->GetClassName() << " " << name;
    }
  }
}

TEST(Warnings, GoThroughAllStages)
{
  const std::unique_ptr<Pipeline> pipeline = doubtedBox(false);
  for (vtkAlgorithm* filter : filtersOf(*pipeline))
  {
    vtkDataObject* output = filter->GetOutputDataObject(0);
    SCOPED_TRACE(filter->GetClassName());
    EXPECT_EQ(texts(output, "WarningCode"), std::vector<std::string>{ "made_up" });
    EXPECT_EQ(output->GetFieldData()->GetArray("WarningPlace")->GetComponent(0, 2), 3);
    EXPECT_TRUE(same(filterTest::writtenAndRead(output), output));
  }
  EXPECT_EQ(texts(pipeline->balls->GetOutputDataObject(1), "WarningCode").size(), 1);
}

TEST(Warnings, ThatAreDamagedAreRefusedByName)
{
  for (const char* name : warningArrays)
  {
    const vtkSmartPointer<vtkPolyData> samples = gridCube(false);
    addWarning(samples, false);
    samples->GetFieldData()->RemoveArray(name);
    vtkNew<vtkPolarBalls> filter;
    filter->SetInputData(samples);
    const std::string error = onlyError(filter);
    EXPECT_NE(error.find("there is no field array '" + std::string(name)), error.npos) << error;
    samples->GetFieldData()->AddArray(texts(name, { "", "x" }));
    samples->Modified();
    EXPECT_NE(onlyError(filter).find("field array '" + std::string(name)), error.npos);
  }
}

TEST(Warnings, AreToldOnceByTheFilterThatFindsThem)
{
  Pipeline pipeline(gridCube(false));
  const ErrorLog ofBalls(pipeline.balls, vtkCommand::WarningEvent);
  const ErrorLog ofAxis(pipeline.axis, vtkCommand::WarningEvent);
  const ErrorLog ofParts(pipeline.parts, vtkCommand::WarningEvent);
  const ErrorLog ofPrune(pipeline.prune, vtkCommand::WarningEvent);
  pipeline.crust->Update();
  ASSERT_EQ(ofBalls.messages().size(), 1u) << testing::PrintToString(ofBalls.messages());
  EXPECT_NE(ofBalls.messages()[0].find("The surface is open: 4 edges"), std::string::npos)
    << ofBalls.messages()[0];
  EXPECT_TRUE(ofAxis.messages().empty());
  EXPECT_TRUE(ofParts.messages().empty());
  EXPECT_TRUE(ofPrune.messages().empty());
  EXPECT_EQ(
    texts(pipeline.crust->GetOutput(), "WarningCode"), std::vector<std::string>{ "open_surface" });
}

TEST(Warnings, OfStagesAreWarningsOfTheWholeFilter)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(gridCube(false));
  simplify->MakeUnprunedOn();
  const ErrorLog log(simplify, vtkCommand::WarningEvent);
  simplify->Update();
  ASSERT_EQ(log.messages().size(), 2u) << testing::PrintToString(log.messages());
  EXPECT_NE(log.messages()[0].find("don't bound a solid"), std::string::npos);
  EXPECT_NE(log.messages()[1].find("The surface is open"), std::string::npos);
  EXPECT_EQ(texts(simplify->GetOutput(), "WarningCode"),
    (std::vector<std::string>{ "not_a_solid", "open_surface" }));
  EXPECT_EQ(texts(simplify->GetOutput(), "Verdict"), std::vector<std::string>{ "certified" });
}

TEST(OpenSurface, IsOneWithASquareMissing)
{
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(gridCube(true)); // its sides don't share their points
  const ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  EXPECT_TRUE(log.messages().empty()) << testing::PrintToString(log.messages());
  filter->SetInputData(gridCube(false));
  filter->Update();
  EXPECT_EQ(log.messages().size(), 1u);
}

TEST(OpenSurface, MayBeOfAnyKindOfCells)
{
  vtkSmartPointer<vtkPolyData> cube = gridCube(false);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(cube->GetPoints());
  grid->SetCells(VTK_QUAD, cube->GetPolys());
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(grid);
  const ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  EXPECT_EQ(log.messages().size(), 1u);
  vtkSmartPointer<vtkPolyData> strips = cloud(smallBox().samples);
  vtkNew<vtkCellArray> strip;
  const vtkIdType corners[] = { 0, 1, 2, 3 };
  strip->InsertNextCell(4, corners);
  strips->SetStrips(strip);
  filter->SetInputData(strips);
  filter->Update();
  ASSERT_EQ(log.messages().size(), 2u);
  EXPECT_NE(log.messages()[1].find("open: 4 edges"), std::string::npos) << log.messages()[1];
}

TEST(OpenSurface, IsNoneOfPixelsAllAround)
{
  // The points of a pixel are in the order of a grid, not around it.
  vtkSmartPointer<vtkPolyData> cube = gridCube(true);
  vtkNew<vtkCellArray> pixels;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < cube->GetNumberOfCells(); ++cell)
  {
    cube->GetCellPoints(cell, corners);
    const vtkIdType pixel[] = { corners->GetId(0), corners->GetId(1), corners->GetId(3),
      corners->GetId(2) };
    pixels->InsertNextCell(4, pixel);
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(cube->GetPoints());
  grid->SetCells(VTK_PIXEL, pixels);
  vtkNew<vtkPolarBalls> filter;
  filter->SetInputData(grid);
  const ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  EXPECT_TRUE(log.messages().empty()) << testing::PrintToString(log.messages());
}

TEST(Verdict, IsCertifiedForTheBox)
{
  EXPECT_EQ(
    texts(boxPipeline().crust->GetOutput(), "Verdict"), std::vector<std::string>{ "certified" });
  EXPECT_FALSE(boxPipeline().crust->GetOutput()->GetFieldData()->HasArray("VerdictReasons"));
}

TEST(Verdict, IsNotCertifiedForADoubtedSolid)
{
  const std::unique_ptr<Pipeline> pipeline = doubtedBox(true);
  vtkPolyData* crust = pipeline->crust->GetOutput();
  EXPECT_EQ(texts(crust, "Verdict"), std::vector<std::string>{ "not certified" });
  ASSERT_EQ(texts(crust, "VerdictReasons").size(), 1);
  EXPECT_NE(texts(crust, "VerdictReasons")[0].find("'made_up'"), std::string::npos);
  EXPECT_TRUE(same(filterTest::writtenAndRead(crust), crust));
}

/// The doubt is in the axis alone: its balls are those of the box without one.
TEST(Verdict, KnowsTheWarningsOfTheAxis)
{
  const auto axis = filterTest::copy<vtkPolyData>(boxPipeline().prune->GetOutputDataObject(0));
  addWarning(axis, true);
  vtkNew<vtkPowerCrust> filter;
  filter->SetInputData(boxPipeline().balls->GetOutput());
  filter->SetAxisData(axis);
  const ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  EXPECT_EQ(texts(filter->GetOutput(), "Verdict"), std::vector<std::string>{ "not certified" });
  EXPECT_EQ(texts(filter->GetOutput(), "WarningCode"), std::vector<std::string>{ "made_up" });
  EXPECT_EQ(log.messages().size(), 1u);
}

TEST(Verdict, IsNotCertifiedWithoutAnAxis)
{
  vtkNew<vtkPowerCrust> filter;
  filter->SetInputData(boxPipeline().balls->GetOutput());
  const ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  ASSERT_EQ(log.messages().size(), 1u);
  EXPECT_NE(log.messages()[0].find("without an axis"), std::string::npos) << log.messages()[0];
  EXPECT_EQ(texts(filter->GetOutput(), "Verdict"), std::vector<std::string>{ "not certified" });
}

TEST(Verdict, ComparesEachStageThatTellsItsTopology)
{
  for (const char* name : { "BettiPowerShape", "BettiUnprunedAxis" })
  {
    const auto balls = filterTest::copy<vtkUnstructuredGrid>(boxPipeline().balls->GetOutput());
    const auto axis = filterTest::copy<vtkPolyData>(boxPipeline().prune->GetOutputDataObject(0));
    vtkDataArray* ofBalls = balls->GetFieldData()->GetArray(name);
    (ofBalls ? ofBalls : axis->GetFieldData()->GetArray(name))->SetComponent(0, 1, 5);
    vtkNew<vtkPowerCrust> filter;
    filter->SetInputData(balls);
    filter->SetAxisData(axis);
    const ErrorLog log(filter, vtkCommand::WarningEvent);
    filter->Update();
    ASSERT_EQ(texts(filter->GetOutput(), "Verdict").size(), 1) << name;
    EXPECT_EQ(texts(filter->GetOutput(), "Verdict")[0], "not certified") << name;
    EXPECT_NE(log.messages().at(0).find("5 tunnels"), std::string::npos) << log.messages()[0];
  }
}

TEST(Verdict, AllowsWhatPruningWasAllowedTo)
{
  const vtkSmartPointer<vtkPolyData> torus = cloud(shapes::torus().samples);
  Pipeline pipeline(torus);
  pipeline.prune->SetTopologyToNone();
  pipeline.prune->SetSchedule("t100000");
  vtkNew<vtkMedialPrune> again; // keeps the topology, but that of an axis which has lost its own
  again->SetInputConnection(pipeline.prune->GetOutputPort());
  again->SetSchedule("t1");
  pipeline.crust->SetAxisConnection(again->GetOutputPort());
  pipeline.crust->Update();
  vtkPolyData* crust = pipeline.crust->GetOutput();
  vtkFieldData* field = again->GetOutput()->GetFieldData();
  EXPECT_EQ(field->GetArray("TopologyKept")->GetComponent(0, 0), 0);
  ASSERT_EQ(field->GetArray("BettiAxis")->GetComponent(0, 1), 0);
  EXPECT_EQ(field->GetArray("BettiUnprunedAxis")->GetComponent(0, 1), 1);
  ASSERT_EQ(texts(crust, "VerdictReasons").size(), 1)
    << testing::PrintToString(texts(crust, "VerdictReasons"));
  EXPECT_NE(texts(crust, "VerdictReasons")[0].find("allowed to change"), std::string::npos);
}

TEST(Verdict, IsNotPassedOnByASurfaceThatBecomesSamples)
{
  const std::unique_ptr<Pipeline> pipeline = doubtedBox(true);
  vtkNew<vtkPolarBalls> balls;
  balls->SetInputData(pipeline->crust->GetOutput());
  balls->Update();
  for (int port = 0; port < 2; ++port)
  {
    vtkDataObject* output = balls->GetOutputDataObject(port);
    EXPECT_TRUE(texts(output, "Verdict").empty());
    EXPECT_TRUE(texts(output, "VerdictReasons").empty());
    EXPECT_EQ(texts(output, "WarningCode").at(0), "made_up");
  }
}
}
