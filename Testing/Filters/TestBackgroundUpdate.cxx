// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include "vtkBackgroundUpdate.h"
#include "vtkSimplifyShape.h"

#include <vtkPolyData.h>

#include <chrono>
#include <sstream>
#include <thread>

namespace
{
using filterTest::boxPipeline;
using filterTest::cloud;
using filterTest::isEmpty;
using filterTest::same;
using filterTest::smallBox;

void wait(vtkBackgroundUpdate* update)
{
  while (update->IsRunning())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(BackgroundUpdate, GivesWhatAnUpdateGives)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  vtkNew<vtkBackgroundUpdate> update;
  EXPECT_FALSE(update->IsRunning());
  EXPECT_EQ(update->GetProgress(), 0);
  update->Stop();
  update->Start(simplify);
  wait(update);
  EXPECT_EQ(update->GetProgress(), 1);
  EXPECT_TRUE(same(simplify->GetOutput(), boxPipeline().crust->GetOutput()));
}

TEST(BackgroundUpdate, StopsAndBeginsAgain)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  vtkNew<vtkBackgroundUpdate> update;
  update->Start(simplify);
  update->Stop();
  wait(update);
  EXPECT_LT(update->GetProgress(), 1);
  EXPECT_TRUE(isEmpty(simplify->GetOutput()));
  update->Start(simplify);
  wait(update);
  EXPECT_TRUE(same(simplify->GetOutput(), boxPipeline().crust->GetOutput()));
}

TEST(BackgroundUpdate, StopsWhereItEnds)
{
  vtkNew<vtkSimplifyShape> simplify;
  simplify->SetInputData(cloud(smallBox().samples));
  {
    vtkNew<vtkBackgroundUpdate> update;
    update->Start(simplify);
  }
  EXPECT_TRUE(isEmpty(simplify->GetOutput()));
}

TEST(BackgroundUpdate, RefusesASecondUpdateAtATime)
{
  vtkNew<vtkSimplifyShape> simplify, other;
  simplify->SetInputData(cloud(smallBox().samples));
  vtkNew<vtkBackgroundUpdate> update;
  int errors = 0;
  filterTest::countEvents(update, vtkCommand::ErrorEvent, errors);
  update->Start(simplify);
  update->Start(other);
  update->Start(nullptr);
  EXPECT_EQ(errors, 2);
  wait(update);
  EXPECT_FALSE(isEmpty(simplify->GetOutput()));
  std::ostringstream text;
  update->Print(text);
  EXPECT_NE(text.str().find("Running: no"), std::string::npos);
}
}
