// SPDX-License-Identifier: BSD-3-Clause
// vtkSimplifyShape without the axis before pruning.
#include "FilterTest.h"

#include "vtkSimplifyShape.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <sstream>

namespace
{
using filterTest::boxPipeline;
using filterTest::cloud;
using filterTest::same;
using filterTest::smallBox;

vtkSmartPointer<vtkSimplifyShape> simplifyBox(bool keep, bool makeUnpruned)
{
  auto result = vtkSmartPointer<vtkSimplifyShape>::New();
  result->SetInputData(cloud(smallBox().samples));
  result->SetKeepAxis(keep);
  result->SetMakeUnpruned(makeUnpruned);
  return result;
}

void expectSameOutputs(vtkSimplifyShape* a, vtkSimplifyShape* b)
{
  for (int port = 0; port < 4; ++port)
  {
    EXPECT_TRUE(same(a->GetOutputDataObject(port), b->GetOutputDataObject(port))) << port;
  }
}

/// Has the output its field data, but nothing else?
void expectReleased(vtkAlgorithm* stage, const char* fieldArray)
{
  auto* output = vtkPolyData::SafeDownCast(stage->GetOutputDataObject(0));
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
  EXPECT_EQ(output->GetNumberOfCells(), 0);
  EXPECT_TRUE(output->GetFieldData()->HasArray(fieldArray));
}

TEST(KeepAxis, OffGivesTheSame)
{
  for (const bool makeUnpruned : { false, true })
  {
    const auto kept = simplifyBox(true, makeUnpruned), released = simplifyBox(false, makeUnpruned);
    kept->Update();
    released->Update();
    expectSameOutputs(released, kept);
    EXPECT_GT(kept->GetMedialAxis()->GetOutput()->GetNumberOfCells(), 0);
    expectReleased(released->GetMedialAxis(), "BettiAxis");
    for (vtkSimplifyShape* simplify : { kept.Get(), released.Get() })
    {
      simplify->SetSchedule("t1");
      simplify->GetPowerCrust()->SetRuleToInnerOnly();
      simplify->Update();
    }
    expectSameOutputs(released, kept);
  }
}

/// Then it comes before the parts.
TEST(KeepAxis, OffGivesTheSameWhereTheCrustReadsAnotherAxis)
{
  const auto kept = simplifyBox(true, false), released = simplifyBox(false, true);
  released->GetPowerCrust()->SetAxisConnection(released->GetMedialPrune()->GetOutputPort());
  kept->Update();
  released->Update();
  expectSameOutputs(released, kept);
}

TEST(KeepAxis, OffLeavesFieldDataAndTablesOfWhatWasNotPruned)
{
  const auto kept = simplifyBox(true, true), released = simplifyBox(false, true);
  kept->Update();
  released->Update();
  expectReleased(released->GetUnprunedPartDecomposition(), "NumberOfParts");
  expectReleased(released->GetUnprunedPowerCrust(), "Volume");
  EXPECT_TRUE(same(released->GetUnprunedPartDecomposition()->GetOutputDataObject(1),
    kept->GetUnprunedPartDecomposition()->GetOutputDataObject(1)));
}

TEST(KeepAxis, OffStillShowsTheAxisWhenItIsMade)
{
  const auto simplify = simplifyBox(false, false);
  vtkNew<vtkPolyData> axis;
  vtkNew<vtkCallbackCommand> copy;
  copy->SetClientData(axis);
  copy->SetCallback([](vtkObject* stage, unsigned long, void* target, void*) {
    static_cast<vtkPolyData*>(target)->DeepCopy(
      static_cast<vtkAlgorithm*>(stage)->GetOutputDataObject(0));
  });
  simplify->GetMedialAxis()->AddObserver(vtkCommand::EndEvent, copy);
  simplify->Update();
  EXPECT_TRUE(same(axis, boxPipeline().axis->GetOutput()));
}

TEST(KeepAxis, OffMakesTheAxisAgainOnlyWhenSomethingHasChanged)
{
  const auto simplify = simplifyBox(false, true);
  EXPECT_FALSE(simplify->GetKeepAxis());
  int axes = 0, balls = 0;
  filterTest::countEvents(simplify->GetMedialAxis(), vtkCommand::StartEvent, axes);
  filterTest::countEvents(simplify->GetPolarBalls(), vtkCommand::StartEvent, balls);
  simplify->Update();
  simplify->Update();
  EXPECT_EQ(axes, 1);
  simplify->SetSchedule("t1");
  simplify->Update();
  EXPECT_EQ(axes, 2);
  EXPECT_EQ(balls, 1);
  simplify->KeepAxisOn();
  simplify->Update();
  EXPECT_EQ(axes, 3);
  EXPECT_GT(simplify->GetMedialAxis()->GetOutput()->GetNumberOfCells(), 0);
  std::ostringstream text;
  simplify->Print(text);
  EXPECT_NE(text.str().find("\n  KeepAxis: on\n"), std::string::npos);
}
}
