// SPDX-License-Identifier: BSD-3-Clause
#include "MedialPruneTest.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkMultiBlockDataSet.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace
{
using filterTest::boxPipeline;
using filterTest::onlyError;
using filterTest::same;
using medialPruneTest::pruneBox;
using medialPruneTest::removed;

TEST(MedialPrune, RunsAloneWhenAThresholdChanges)
{
  filterTest::Pipeline pipeline(filterTest::cloud(filterTest::smallBox().samples));
  pipeline.prune->Update();
  const vtkMTimeType before = pipeline.axis->GetOutput()->GetMTime();
  pipeline.prune->ClearIterations();
  pipeline.prune->AddIteration(vtkMedialPrune::RELATIVE_VOLUME, 0.02);
  pipeline.prune->Update();
  EXPECT_EQ(pipeline.axis->GetOutput()->GetMTime(), before);
}

/// Does the filter give what one gives that has not run before?
testing::AssertionResult prunesAfresh(vtkMedialPrune* filter, vtkDataObject* input)
{
  vtkNew<vtkMedialPrune> fresh;
  fresh->SetInputData(input);
  fresh->SetSchedule(filter->GetScheduleWords().c_str());
  fresh->SetSplitAtNecks(filter->GetSplitAtNecks());
  fresh->Update();
  filter->Update();
  for (int port = 0; port < 3; ++port)
  {
    auto result = same(filter->GetOutputDataObject(port), fresh->GetOutputDataObject(port));
    if (!result)
    {
      return result << " at output " << port;
    }
  }
  return testing::AssertionSuccess();
}

TEST(MedialPrune, GivesTheSameWhateverItDidBefore)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  vtkDataObject* box = boxPipeline().parts->GetOutput();
  for (const double threshold : { 5, 1000000, 0, 20 })
  {
    filter->ClearIterations();
    filter->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, threshold);
    EXPECT_TRUE(prunesAfresh(filter, box)) << threshold;
  }
  filter->SplitAtNecksOn();
  EXPECT_TRUE(prunesAfresh(filter, box));
  filter->SplitAtNecksOff();
  EXPECT_TRUE(prunesAfresh(filter, box));
}

/// The ranks of the cells of an axis.
vtkDataArray* ranks(vtkPolyData* axis)
{
  return axis->GetCellData()->GetArray("PartRank");
}

double component(vtkPolyData* axis, const char* array, vtkIdType cell)
{
  return axis->GetCellData()->GetArray(array)->GetComponent(cell, 0);
}

TEST(MedialPrune, KeepsTheRanksOfParts)
{
  const auto before = filterTest::copy<vtkPolyData>(boxPipeline().parts->GetOutput());
  for (vtkIdType cell = 0; cell < before->GetNumberOfCells(); ++cell)
  {
    ranks(before)->SetComponent(cell, 0, 100000 - component(before, "PartId", cell));
  }
  vtkNew<vtkMedialPrune> filter;
  filter->SetInputData(before);
  filter->Update();
  vtkPolyData* after = filter->GetOutput();
  std::map<double, double> lowest; // for each part the lowest rank that its cells had
  for (vtkIdType cell = 0; cell < after->GetNumberOfCells(); ++cell)
  {
    const auto input = static_cast<vtkIdType>(component(after, "InputCell", cell));
    const double rank = component(before, "PartRank", input);
    const double part = component(after, "PartId", cell);
    lowest[part] = std::min(rank, lowest.emplace(part, rank).first->second);
  }
  EXPECT_GT(lowest.size(), 1u);
  for (vtkIdType cell = 0; cell < after->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(component(after, "PartRank", cell), lowest[component(after, "PartId", cell)]);
  }
  for (vtkIdType cell = 0; cell < removed(filter)->GetNumberOfCells(); ++cell)
  {
    const auto input = static_cast<vtkIdType>(component(removed(filter), "InputCell", cell));
    EXPECT_EQ(component(removed(filter), "PartRank", cell), component(before, "PartRank", input));
  }
}

TEST(MedialPrune, FindsTheRanksThatItsInputDoesNotHave)
{
  vtkMedialPrune* filter = boxPipeline().prune;
  vtkPolyData* after = filter->GetOutput();
  vtkNew<vtkMedialPrune> alone;
  alone->SetInputData(boxPipeline().axis->GetOutput());
  alone->SetSchedule(filter->GetScheduleWords().c_str());
  vtkNew<vtkMedialPartDecomposition> later;
  later->SetInputConnection(alone->GetOutputPort());
  later->Update();
  vtkDataArray* found = ranks(later->GetOutput());
  ASSERT_EQ(found->GetNumberOfTuples(), after->GetNumberOfCells());
  for (vtkIdType cell = 0; cell < after->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(found->GetComponent(cell, 0), ranks(after)->GetComponent(cell, 0));
  }
}

TEST(MedialPrune, SeesThatItsInputHasChanged)
{
  const auto input = filterTest::copy<vtkPolyData>(boxPipeline().axis->GetOutput());
  const auto other = filterTest::copy<vtkPolyData>(boxPipeline().prune->GetOutput());
  vtkNew<vtkMedialPrune> filter;
  filter->SetSchedule("t5 t5 v1%");
  filter->SetInputData(input);
  EXPECT_TRUE(prunesAfresh(filter, input));
  vtkDataArray* volumes = input->GetFieldData()->GetArray("BallVolume");
  for (vtkIdType ball = 0; ball < volumes->GetNumberOfTuples(); ball += 2)
  {
    volumes->SetComponent(ball, 0, 3 * volumes->GetComponent(ball, 0));
  }
  volumes->Modified();
  const auto before = filterTest::copy<vtkPolyData>(filter->GetOutput());
  EXPECT_TRUE(prunesAfresh(filter, input));
  EXPECT_FALSE(same(before, filter->GetOutput()));
  filter->SetInputData(other);
  EXPECT_TRUE(prunesAfresh(filter, other));
  filter->SetInputData(input);
  EXPECT_TRUE(prunesAfresh(filter, input));
}

TEST(MedialPrune, SeesThatItsInputHasBecomeUseless)
{
  const auto input = filterTest::copy<vtkPolyData>(boxPipeline().axis->GetOutput());
  vtkNew<vtkMedialPrune> filter;
  filter->SetInputData(input);
  filter->Update();
  const auto owners = vtkSmartPointer<vtkDataArray>(input->GetFieldData()->GetArray("BallOwner"));
  input->GetFieldData()->RemoveArray("BallOwner");
  EXPECT_NE(onlyError(filter).find("BallOwner"), std::string::npos);
  input->GetFieldData()->AddArray(owners);
  EXPECT_TRUE(prunesAfresh(filter, input));
}

TEST(MedialPrune, GivesTheSameForEachBlockWhateverItDidBefore)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, boxPipeline().axis->GetOutput());
  blocks->SetBlock(1, boxPipeline().prune->GetOutput());
  vtkNew<vtkMedialPrune> filter;
  filter->SetInputData(blocks);
  for (const double threshold : { 5, 1000000 })
  {
    filter->ClearIterations();
    filter->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, threshold);
    filter->Update();
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    for (unsigned int block = 0; block < 2; ++block)
    {
      vtkSmartPointer<vtkMedialPrune> alone = pruneBox();
      alone->SetInputData(blocks->GetBlock(block));
      alone->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, threshold);
      alone->Update();
      EXPECT_TRUE(same(output->GetBlock(block), alone->GetOutput())) << threshold << " " << block;
    }
  }
}

TEST(MedialPrune, RunsAgainWhenAPropertyChanges)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  const std::vector<std::function<void()>> changes = {
    [&] { filter->ClearIterations(); },
    [&] { filter->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 5, 1); },
    [&] { filter->SetTopologyToNone(); },
    [&] { filter->RemoveHairOff(); },
    [&] { filter->RemoveBranchesOff(); },
    [&] { filter->AddPartToRemove(1); },
    [&] { filter->ClearPartsToRemove(); },
    [&] { filter->AddCellToRemove(1); },
    [&] { filter->ClearCellsToRemove(); },
    [&] { filter->AddPartToProtect(1); },
    [&] { filter->ClearPartsToProtect(); },
    [&] { filter->AddCellToProtect(1); },
    [&] { filter->ClearCellsToProtect(); },
    [&] { filter->SetTopologyToPaperGraph(); },
    [&] { filter->VerifyTopologyOn(); },
    [&] { filter->SetSelectionRoleToProtect(); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const vtkMTimeType before = filter->GetMTime();
    changes[i]();
    EXPECT_GT(filter->GetMTime(), before) << "change " << i;
  }
  EXPECT_EQ(filter->GetIterationPasses(0), 1);
}
}
