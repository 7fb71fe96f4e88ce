// SPDX-License-Identifier: BSD-3-Clause
// How every filter runs: it reports progress, stops, and gives everything in the first piece.
#include "StageTest.h"

#include <vtkCallbackCommand.h>

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
  alone.filter()->Modified();
  alone.filter()->Update();
  vtkAlgorithm* model = this->GetParam().of(boxPipeline());
  EXPECT_TRUE(same(alone.filter()->GetOutputDataObject(0), model->GetOutputDataObject(0)));
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
  pipeline.balls->AddObserver(vtkCommand::ProgressEvent, stopper());
  pipeline.crust->Update();
  EXPECT_TRUE(ofBalls.messages().empty());
  EXPECT_TRUE(ofAxis.messages().empty()) << testing::PrintToString(ofAxis.messages());
  EXPECT_TRUE(ofCrust.messages().empty()) << testing::PrintToString(ofCrust.messages());
  EXPECT_TRUE(isEmpty(pipeline.crust->GetOutput()));
}
}
