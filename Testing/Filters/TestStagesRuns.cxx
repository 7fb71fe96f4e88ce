// SPDX-License-Identifier: BSD-3-Clause
// How every filter runs: it reports progress, stops, and gives everything in the first piece.
#include "StageTest.h"

#include <vtkCallbackCommand.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPassThrough.h>
#include <vtkTable.h>
#include <vtkVersion.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using filterTest::Alone;
using filterTest::boxPipeline;
using filterTest::ErrorLog;
using filterTest::isEmpty;
using filterTest::same;
using filterTest::Stages;

TEST_P(Stages, ReportProgressThatGrows)
{
  Alone alone(this->GetParam());
  std::vector<double> reports;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&reports);
  listener->SetCallback([](vtkObject*, unsigned long, void* list, void* done) {
    static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(done));
  });
  alone.filter()->AddObserver(vtkCommand::ProgressEvent, listener);
  alone.filter()->Update();
  EXPECT_GE(reports.size(), 4u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_GE(reports.front(), 0);
  EXPECT_EQ(reports.back(), 1);
}

/// Stops a filter at its second report of progress that is neither start nor end.
vtkSmartPointer<vtkCallbackCommand> stopper()
{
  auto result = vtkSmartPointer<vtkCallbackCommand>::New();
  result->SetCallback([](vtkObject* filter, unsigned long, void*, void* done) {
    const double progress = *static_cast<double*>(done);
    if (progress > 0 && progress < 1)
    {
      static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
    }
  });
  return result;
}

TEST_P(Stages, StopWithoutAnErrorAndRunAgain)
{
  Alone alone(this->GetParam());
  const ErrorLog log(alone.filter());
  const unsigned long tag = alone.filter()->AddObserver(vtkCommand::ProgressEvent, stopper());
  alone.filter()->Update();
  EXPECT_TRUE(log.messages().empty()) << testing::PrintToString(log.messages());
  EXPECT_EQ(alone.filter()->GetErrorCode(), 0u);
  for (int port = 0; port < alone.filter()->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_TRUE(isEmpty(alone.filter()->GetOutputDataObject(port)));
  }
  alone.filter()->RemoveObserver(tag);
  alone.filter()->Update();
  vtkAlgorithm* model = this->GetParam().of(boxPipeline());
  EXPECT_TRUE(same(alone.filter()->GetOutputDataObject(0), model->GetOutputDataObject(0)));
}

void expectStopped(vtkAlgorithm* filter)
{
  const ErrorLog log(filter);
  filter->Update();
  EXPECT_TRUE(log.messages().empty()) << testing::PrintToString(log.messages());
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_TRUE(isEmpty(filter->GetOutputDataObject(port)));
  }
}

TEST_P(Stages, StopARunThatHasNotBegun)
{
  Alone alone(this->GetParam());
  vtkAlgorithm* model = this->GetParam().of(boxPipeline());
  for (int time = 0; time < 2; ++time)
  {
    alone.filter()->SetAbortExecute(1);
    expectStopped(alone.filter());
  }
  alone.filter()->Update();
  EXPECT_TRUE(same(alone.filter()->GetOutputDataObject(0), model->GetOutputDataObject(0)));
  alone.filter()->SetAbortExecute(1); // what is there goes
  expectStopped(alone.filter());
  alone.filter()->SetAbortExecute(1);
  alone.filter()->SetAbortExecute(0);
  alone.filter()->Update();
  EXPECT_TRUE(same(alone.filter()->GetOutputDataObject(0), model->GetOutputDataObject(0)));
}

TEST_P(Stages, StopInAllBlocksOfACollection)
{
  Alone alone(this->GetParam());
  vtkSmartPointer<vtkDataObject> copied;
  copied.TakeReference(alone.input()->NewInstance());
  copied->DeepCopy(alone.input());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, alone.input());
  blocks->SetBlock(1, copied);
  if (this->GetParam().port > 0)
  {
    return; // of one object
  }
  alone.filter()->SetInputDataObject(0, blocks);
  const unsigned long tag = alone.filter()->AddObserver(vtkCommand::ProgressEvent, stopper());
  alone.filter()->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(alone.filter()->GetOutputDataObject(0));
  ASSERT_TRUE(output);
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 20220101)
  EXPECT_EQ(output->GetNumberOfBlocks(), 2U); // since then the output of a stopped run has none
#endif
  for (unsigned int block = 0; block < output->GetNumberOfBlocks(); ++block)
  {
    EXPECT_TRUE(isEmpty(output->GetBlock(block)));
  }
  alone.filter()->RemoveObserver(tag);
  alone.filter()->Update();
  output = vtkMultiBlockDataSet::SafeDownCast(alone.filter()->GetOutputDataObject(0));
  vtkAlgorithm* model = this->GetParam().of(boxPipeline());
  EXPECT_TRUE(same(output->GetBlock(0), model->GetOutputDataObject(0)));
  EXPECT_TRUE(same(output->GetBlock(1), model->GetOutputDataObject(0)));
}

TEST_P(Stages, RefuseABlockOfAnotherType)
{
  Alone alone(this->GetParam());
  vtkNew<vtkTable> table;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, table);
  if (this->GetParam().port > 0)
  {
    return; // of one object
  }
  alone.filter()->SetInputDataObject(0, blocks);
  EXPECT_NE(filterTest::onlyError(alone.filter()).find("vtkTable"), std::string::npos);
}

TEST_P(Stages, GiveEverythingInTheFirstPiece)
{
  Alone alone(this->GetParam());
  vtkAlgorithm* model = this->GetParam().of(boxPipeline());
  for (int port = 0; port < model->GetNumberOfOutputPorts(); ++port)
  {
    SCOPED_TRACE(port);
    alone.filter()->UpdatePiece(0, 2, 0);
    EXPECT_TRUE(same(alone.filter()->GetOutputDataObject(port), model->GetOutputDataObject(port)));
    alone.filter()->UpdatePiece(1, 2, 0);
    EXPECT_TRUE(isEmpty(alone.filter()->GetOutputDataObject(port)));
  }
}

TEST_P(Stages, DescribeThemselves)
{
  std::ostringstream text;
  this->GetParam().of(boxPipeline())->Print(text);
  EXPECT_NE(text.str().find("AbortExecute"), std::string::npos);
}

TEST(StoppedPipeline, IsEmptyToItsEndWithoutAnError)
{
  filterTest::Pipeline pipeline(filterTest::cloud(filterTest::smallBox().samples));
  const ErrorLog ofBalls(pipeline.balls), ofAxis(pipeline.axis), ofCrust(pipeline.crust);
  vtkNew<vtkPassThrough> foreign; // knows nothing of stopping
  foreign->SetInputConnection(pipeline.crust->GetOutputPort());
  const unsigned long tag = pipeline.balls->AddObserver(vtkCommand::ProgressEvent, stopper());
  foreign->Update();
  EXPECT_TRUE(ofBalls.messages().empty());
  EXPECT_TRUE(ofAxis.messages().empty()) << testing::PrintToString(ofAxis.messages());
  EXPECT_TRUE(ofCrust.messages().empty()) << testing::PrintToString(ofCrust.messages());
  EXPECT_TRUE(isEmpty(pipeline.crust->GetOutput()));
  EXPECT_TRUE(isEmpty(foreign->GetOutputDataObject(0)));
  pipeline.balls->RemoveObserver(tag);
  foreign->Update();
  EXPECT_TRUE(same(foreign->GetOutputDataObject(0), boxPipeline().crust->GetOutput()));
}

TEST(StoppedPipeline, FollowsAStopOfAFilterThatHasNotBegun)
{
  filterTest::Pipeline pipeline(filterTest::cloud(filterTest::smallBox().samples));
  vtkNew<vtkCallbackCommand> stopsCrust; // while the axis is made
  stopsCrust->SetClientData(pipeline.crust.Get());
  stopsCrust->SetCallback([](vtkObject*, unsigned long, void* crust, void*) {
    static_cast<vtkAlgorithm*>(crust)->SetAbortExecute(1);
  });
  const unsigned long tag = pipeline.axis->AddObserver(vtkCommand::StartEvent, stopsCrust);
  pipeline.crust->Update();
  EXPECT_FALSE(isEmpty(pipeline.axis->GetOutput()));
  EXPECT_TRUE(isEmpty(pipeline.crust->GetOutput()));
  pipeline.axis->RemoveObserver(tag);
  pipeline.crust->Update();
  EXPECT_TRUE(same(pipeline.crust->GetOutput(), boxPipeline().crust->GetOutput()));
}
}
