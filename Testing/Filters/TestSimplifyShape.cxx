// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include "vtkBoundarySamples.h"
#include "vtkSimplifyShape.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <sstream>
#include <string>
#include <utility>

namespace
{
using filterTest::boxPipeline;
using filterTest::cloud;
using filterTest::isEmpty;
using filterTest::onlyError;
using filterTest::same;
using filterTest::smallBox;

/// Notes the progress of a filter, and stops it where it is told to.
struct Watch
{
  explicit Watch(vtkAlgorithm* filter, double stopAt = 2)
    : StopAt(stopAt)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject* sender, unsigned long, void* self, void*) {
      auto* algorithm = static_cast<vtkAlgorithm*>(sender);
      auto* watch = static_cast<Watch*>(self);
      watch->Reports.push_back(algorithm->GetProgress());
      algorithm->SetAbortExecute(algorithm->GetProgress() >= watch->StopAt);
    });
    filter->AddObserver(vtkCommand::ProgressEvent, command);
  }

  double StopAt;
  std::vector<double> Reports;
};

TEST(SimplifyShape, GivesWhatTheFiveFiltersGive)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  simplify->Update();
  filterTest::Pipeline& pipeline = boxPipeline();
  vtkNew<vtkMedialPartDecomposition> parts;
  parts->SetInputConnection(pipeline.prune->GetOutputPort());
  parts->Update();
  EXPECT_TRUE(same(simplify->GetOutputDataObject(0), pipeline.crust->GetOutput()));
  EXPECT_TRUE(same(simplify->GetOutputDataObject(1), parts->GetOutput()));
  EXPECT_TRUE(same(simplify->GetOutputDataObject(2), parts->GetOutputDataObject(1)));
  EXPECT_TRUE(same(simplify->GetOutputDataObject(3), pipeline.prune->GetOutputDataObject(1)));
}

TEST(SimplifyShape, FollowsTheScheduleWithTheSameAxis)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  simplify->Update();
  const vtkMTimeType made = simplify->GetMedialAxis()->GetOutput()->GetMTime();
  simplify->ClearIterations();
  simplify->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 1);
  simplify->Update();
  EXPECT_EQ(simplify->GetMedialAxis()->GetOutput()->GetMTime(), made);
  EXPECT_EQ(simplify->GetOutputDataObject(3)->GetNumberOfElements(vtkDataObject::ROW), 1);
  simplify->GetPowerCrust()->SetRuleToInnerOnly();
  const vtkMTimeType before = simplify->GetOutputDataObject(0)->GetMTime();
  simplify->Update();
  EXPECT_GT(simplify->GetOutputDataObject(0)->GetMTime(), before);
}

TEST(SimplifyShape, PassesItsPropertiesOn)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  simplify->Update();
  simplify->AutomaticOn();
  EXPECT_TRUE(simplify->GetAutomatic());
  simplify->Update();
  vtkNew<vtkMedialPrune> prune;
  prune->SetInputConnection(boxPipeline().parts->GetOutputPort());
  prune->AutomaticOn();
  prune->Update();
  EXPECT_TRUE(same(simplify->GetOutputDataObject(3), prune->GetOutputDataObject(1)));
  simplify->SplitAtNecksOn();
  simplify->SetNeckRatio(1);
  EXPECT_TRUE(simplify->GetSplitAtNecks());
  EXPECT_EQ(simplify->GetNeckRatio(), 1);
  simplify->Update();
  prune->SplitAtNecksOn();
  prune->SetNeckRatio(1);
  vtkNew<vtkMedialPartDecomposition> parts;
  parts->SetInputConnection(prune->GetOutputPort());
  parts->SplitAtNecksOn();
  parts->SetNeckRatio(1);
  parts->Update();
  EXPECT_TRUE(same(simplify->GetOutputDataObject(1), parts->GetOutput()));
  EXPECT_TRUE(same(simplify->GetOutputDataObject(2), parts->GetOutputDataObject(1)));
}

TEST(SimplifyShape, PassesItsScheduleOn)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetSchedule("t5 v1%");
  EXPECT_EQ(simplify->GetScheduleWords(), "t5 v1%");
  simplify->ClearIterations();
  simplify->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 3, 1);
  simplify->AddIterationByName("TriangleCount", 4, 2);
  simplify->AddIterationFromText("TriangleCount", "5", "1");
  EXPECT_EQ(simplify->GetScheduleWords(), "t3x1 t4x2 t5x1");
  simplify->SetMergeTolerance(0.25);
  EXPECT_EQ(simplify->GetMergeTolerance(), 0.25);
  simplify->SetTrim(0.5);
  EXPECT_EQ(simplify->GetTrim(), 0.5);
  EXPECT_EQ(simplify->GetMedialAxis()->GetTrim(), 0.5);
  simplify->WrapOn();
  simplify->SetWrapWidth(0.5);
  EXPECT_TRUE(simplify->GetWrap() && simplify->GetBoundarySamples()->GetWrap());
  EXPECT_EQ(simplify->GetWrapWidth(), simplify->GetBoundarySamples()->GetWrapWidth());
  EXPECT_EQ(simplify->GetWrapWidth(), 0.5);
}

TEST(SimplifyShape, MakesTheUnprunedPartsAndCrustWhenAsked)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  simplify->Update();
  EXPECT_FALSE(simplify->GetMakeUnpruned());
  EXPECT_TRUE(isEmpty(simplify->GetUnprunedPartDecomposition()->GetOutput()));
  EXPECT_TRUE(isEmpty(simplify->GetUnprunedPowerCrust()->GetOutput()));
  std::vector<vtkSmartPointer<vtkDataObject>> before;
  for (int port = 0; port < 4; ++port)
  {
    before.emplace_back(
      vtkSmartPointer<vtkDataObject>::Take(simplify->GetOutputDataObject(port)->NewInstance()));
    before.back()->DeepCopy(simplify->GetOutputDataObject(port));
  }
  simplify->MakeUnprunedOn();
  EXPECT_TRUE(simplify->GetMakeUnpruned());
  simplify->Update();
  for (int port = 0; port < 4; ++port)
  {
    EXPECT_TRUE(same(simplify->GetOutputDataObject(port), before[port])) << port;
  }
  vtkNew<vtkPowerCrust> crust;
  crust->SetInputConnection(boxPipeline().balls->GetOutputPort());
  crust->SetAxisConnection(boxPipeline().parts->GetOutputPort());
  crust->Update();
  vtkMedialPartDecomposition* parts = simplify->GetUnprunedPartDecomposition();
  EXPECT_TRUE(same(parts->GetOutput(), boxPipeline().parts->GetOutput()));
  EXPECT_TRUE(same(parts->GetOutputDataObject(1), boxPipeline().parts->GetOutputDataObject(1)));
  EXPECT_TRUE(same(simplify->GetUnprunedPowerCrust()->GetOutput(), crust->GetOutput()));
}

TEST(SimplifyShape, RemovesUnprunedPartsByTheirNumber)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  simplify->ClearIterations();
  simplify->GetMedialPrune()->SetTopologyToNone();
  simplify->GetMedialPrune()->AddPartToRemove(0);
  EXPECT_NE(onlyError(simplify).find("PartId"), std::string::npos);
  simplify->MakeUnprunedOn();
  simplify->Update();
  EXPECT_STREQ(simplify->GetErrorMessage(), "");
  EXPECT_LT(simplify->GetMedialPrune()->GetOutput()->GetNumberOfCells(),
    simplify->GetUnprunedPartDecomposition()->GetOutput()->GetNumberOfCells());
}

TEST(SimplifyShape, StagesAreConnectedInOrder)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  simplify->Update();
  filterTest::Pipeline& pipeline = boxPipeline();
  EXPECT_TRUE(same(simplify->GetPolarBalls()->GetOutput(), pipeline.balls->GetOutput()));
  EXPECT_TRUE(same(simplify->GetMedialAxis()->GetOutput(), pipeline.axis->GetOutput()));
  EXPECT_TRUE(same(simplify->GetMedialPrune()->GetOutput(), pipeline.prune->GetOutput()));
  EXPECT_TRUE(
    same(simplify->GetMedialPartDecomposition()->GetOutput(), simplify->GetOutputDataObject(1)));
  EXPECT_TRUE(same(simplify->GetPowerCrust()->GetOutput(), simplify->GetOutput()));
}

/// Of a mesh they come from vtkBoundarySamples, of points from vtkPolarBalls; also one after the other.
TEST(SimplifyShape, GivesTheBallsAndSamplesOfItsInput)
{
  vtkNew<vtkSimplifyShape> simplify;
  EXPECT_EQ(simplify->GetBalls()->GetNumberOfPoints(), 0);
  EXPECT_EQ(simplify->GetSamples()->GetNumberOfPoints(), 0);
  simplify->GetBoundarySamples()->SetSpacing(0.3);
  for (int turn = 0; turn < 2; ++turn)
  {
    simplify->SetInputData(filterTest::dataOf(meshes::torus()));
    simplify->Update();
    vtkBoundarySamples* boundary = simplify->GetBoundarySamples();
    EXPECT_EQ(simplify->GetBalls(), boundary->GetOutputDataObject(2));
    EXPECT_EQ(simplify->GetSamples(), boundary->GetOutputDataObject(3));
    EXPECT_TRUE(simplify->GetBalls()->GetFieldData()->HasArray("BettiSolid"));
    EXPECT_GT(simplify->GetOutput()->GetNumberOfCells(), 1000);

    simplify->SetInputData(cloud(smallBox().samples));
    simplify->Update();
    EXPECT_TRUE(same(simplify->GetBalls(), boxPipeline().balls->GetOutput()));
    EXPECT_TRUE(same(simplify->GetSamples(), boxPipeline().balls->GetOutputDataObject(1)));
    EXPECT_TRUE(same(simplify->GetOutput(), boxPipeline().crust->GetOutput()));
  }
}

/// The stages, and what their texts are called.
std::vector<std::pair<std::string, vtkAlgorithm*>> stages(vtkSimplifyShape* simplify)
{
  return { { "PolarBalls", simplify->GetPolarBalls() }, { "MedialAxis", simplify->GetMedialAxis() },
    { "MedialPrune", simplify->GetMedialPrune() },
    { "MedialPartDecomposition", simplify->GetMedialPartDecomposition() },
    { "PowerCrust", simplify->GetPowerCrust() },
    { "UnprunedPartDecomposition", simplify->GetUnprunedPartDecomposition() },
    { "UnprunedPowerCrust", simplify->GetUnprunedPowerCrust() } };
}

TEST(SimplifyShape, ChangesWithEachStageAndProperty)
{
  vtkNew<vtkSimplifyShape> simplify;
  vtkMTimeType before = simplify->GetMTime();
  for (const auto& [name, stage] : stages(simplify))
  {
    stage->Modified();
    EXPECT_GT(simplify->GetMTime(), before) << name;
    before = simplify->GetMTime();
  }
  simplify->MakeUnprunedOff();
  EXPECT_EQ(simplify->GetMTime(), before);
  simplify->MakeUnprunedOn();
  EXPECT_GT(simplify->GetMTime(), before);
}

TEST(SimplifyShape, IsNotChangedByItsOwnWork)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  simplify->MakeUnprunedOn();
  const vtkMTimeType before = simplify->GetMTime();
  simplify->Update();
  EXPECT_EQ(simplify->GetMTime(), before);
}

TEST(SimplifyShape, PrintsAllStages)
{
  vtkNew<vtkSimplifyShape> simplify;
  std::ostringstream text;
  simplify->Print(text);
  EXPECT_NE(text.str().find("\n  MakeUnpruned: off\n"), std::string::npos);
  for (const auto& [name, stage] : stages(simplify))
  {
    EXPECT_NE(text.str().find("\n  " + name + ":\n    Debug: "), std::string::npos) << name;
  }
}

TEST(SimplifyShape, TellsThePlainMessageOfAnError)
{
  vtkNew<vtkSimplifyShape> simplify;
  EXPECT_STREQ(simplify->GetErrorMessage(), "");
  simplify->SetInputData(cloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  const std::string told = onlyError(simplify);
  const std::string message = simplify->GetErrorMessage();
  EXPECT_EQ(message.find("ERROR"), std::string::npos);
  EXPECT_NE(told.find("): " + message + "\n"), std::string::npos) << told;
  simplify->SetInputData(cloud(smallBox().samples));
  simplify->Update();
  EXPECT_STREQ(simplify->GetErrorMessage(), "");
}

TEST(SimplifyShape, TellsOfAMeasureThatItRefuses)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  {
    const filterTest::ErrorLog log(simplify->GetMedialPrune());
    simplify->AddIterationByName("Beauty", 1);
    EXPECT_EQ(log.messages().size(), 1u);
  }
  const std::string refused = simplify->GetErrorMessage();
  EXPECT_EQ(refused.find("there is no measure 'Beauty'"), 0u) << refused;
  onlyError(simplify);
  EXPECT_EQ(simplify->GetErrorMessage(), refused);
  simplify->ClearIterations();
  simplify->Update();
  EXPECT_STREQ(simplify->GetErrorMessage(), "");
}

TEST(SimplifyShape, PassesTheErrorOfAStageOn)
{
  vtkNew<vtkPolarBalls> balls;
  vtkNew<vtkSimplifyShape> simplify;
  const auto points = cloud({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  balls->SetInputData(points);
  simplify->SetInputData(points);
  const std::string expected = onlyError(balls), told = onlyError(simplify);
  EXPECT_EQ(told.substr(told.find("): ")), expected.substr(expected.find("): ")));
  EXPECT_NE(told.find("vtkSimplifyShape"), std::string::npos);
  simplify->SetInputData(cloud(smallBox().samples));
  simplify->AddIteration(vtkMedialPrune::RELATIVE_VOLUME, -1);
  EXPECT_NE(onlyError(simplify).find("threshold"), std::string::npos);
  simplify->ClearIterations();
  simplify->Update();
  EXPECT_FALSE(isEmpty(simplify->GetOutput()));
}

TEST(SimplifyShape, ReportsProgressOfAllStagesUpwards)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  const Watch watch(simplify);
  simplify->Update();
  ASSERT_GT(watch.Reports.size(), 20u);
  EXPECT_TRUE(std::is_sorted(watch.Reports.begin(), watch.Reports.end()));
  EXPECT_EQ(watch.Reports.back(), 1);
}

TEST(SimplifyShape, StopsInEveryStageAndStartsAgain)
{
  for (const double stopAt : { 0.1, 0.5, 0.72, 0.82, 0.9 })
  {
    SCOPED_TRACE(stopAt);
    vtkNew<vtkSimplifyShape> simplify;
    simplify->SetInputData(cloud(smallBox().samples));
    Watch watch(simplify, stopAt);
    simplify->Update();
    for (int port = 0; port < 4; ++port)
    {
      EXPECT_TRUE(isEmpty(simplify->GetOutputDataObject(port)));
    }
    EXPECT_EQ(simplify->GetErrorCode(), 0u);
    watch.StopAt = 2;
    simplify->Update();
    EXPECT_TRUE(same(simplify->GetOutput(), boxPipeline().crust->GetOutput()));
    simplify->SetAbortExecute(1);
    simplify->Update();
    EXPECT_TRUE(isEmpty(simplify->GetOutput()));
    simplify->Update();
    EXPECT_TRUE(same(simplify->GetOutput(), boxPipeline().crust->GetOutput()));
  }
}

TEST(SimplifyShape, MakesAllOutputsOfARankTogether)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud(smallBox().samples));
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputDataObject(blocks);
  int runs = 0;
  filterTest::countEvents(simplify, vtkCommand::EndEvent, runs);
  int runsForOne = 0;
  for (int port = 0; port < 4; ++port)
  {
    vtkNew<vtkInformation> rank;
    rank->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    rank->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 2);
    rank->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 1);
    vtkNew<vtkInformationVector> requests;
    requests->SetNumberOfInformationObjects(4);
    requests->SetInformationObject(port, rank);
    simplify->Update(port, requests);
    runsForOne = port == 0 ? runs : runsForOne;
  }
  EXPECT_GT(runsForOne, 0);
  EXPECT_EQ(runs, runsForOne);
}

TEST(SimplifyShape, TakesBlocksOneByOne)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud(smallBox().samples));
  blocks->SetBlock(1, cloud(shapes::sphere(0.4).samples));
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputDataObject(blocks);
  simplify->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(simplify->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  EXPECT_TRUE(same(output->GetBlock(0), boxPipeline().crust->GetOutput()));
  EXPECT_GT(output->GetBlock(1)->GetNumberOfElements(vtkDataObject::CELL), 0);
}
}
