// SPDX-License-Identifier: BSD-3-Clause
#include "MedialPruneTest.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using filterTest::arrays;
using filterTest::boxPipeline;
using filterTest::onlyError;
using filterTest::same;
using medialPruneTest::history;
using medialPruneTest::pruneBox;
using medialPruneTest::removed;

double field(vtkDataObject* data, const char* name, int component = 0)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, component);
}

TEST(MedialPrune, HasTheArraysOfItsHeader)
{
  vtkPolyData *parts = boxPipeline().parts->GetOutput(), *pruned = boxPipeline().prune->GetOutput();
  EXPECT_EQ(arrays(pruned->GetPointData()), arrays(parts->GetPointData()));
  EXPECT_EQ(arrays(pruned->GetFieldData()), arrays(parts->GetFieldData()));
  std::vector<std::string> expected = arrays(parts->GetCellData());
  expected.emplace_back("KeepReason unsigned char 1");
  expected.emplace_back("InputCell idtype 1");
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(arrays(pruned->GetCellData()), expected);
}

TEST(MedialPrune, HasTheColumnsOfItsHeader)
{
  EXPECT_EQ(arrays(history(boxPipeline().prune)->GetRowData()),
    (std::vector<std::string>{ "Betti idtype 3", "ByHand unsigned char 1", "Candidates idtype 1",
      "Iteration idtype 1", "Measure int 1", "PartsAfter idtype 1", "PartsBefore idtype 1",
      "Passes int 1", "Refused idtype 1", "RefusedByTopology idtype 1", "RefusedIsolated idtype 1",
      "RefusedProtected idtype 1", "Removed idtype 1", "Threshold double 1",
      "TopologyChanges idtype 1", "VolumeRemoved double 1", "Word string 1" }));
}

TEST(MedialPrune, HasTheArraysOfItsHeaderOnWhatItRemoved)
{
  vtkPolyData* cells = removed(boxPipeline().prune);
  std::vector<std::string> expected = arrays(boxPipeline().parts->GetOutput()->GetCellData());
  expected.emplace_back("InputCell idtype 1");
  expected.emplace_back("Iteration idtype 1");
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(arrays(cells->GetCellData()), expected);
  EXPECT_GT(cells->GetNumberOfCells(), 0);
}

/// Does `InputCell` of each cell lead to the input's cell with the same corners?
void expectInputCells(vtkPolyData* output, vtkPolyData* input)
{
  vtkDataArray* cells = output->GetCellData()->GetArray("InputCell");
  ASSERT_TRUE(cells);
  vtkNew<vtkIdList> here, there;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    output->GetCellPoints(cell, here);
    input->GetCellPoints(static_cast<vtkIdType>(cells->GetComponent(cell, 0)), there);
    ASSERT_EQ(here->GetNumberOfIds(), there->GetNumberOfIds());
    EXPECT_TRUE(std::equal(here->begin(), here->end(), there->begin()));
  }
}

TEST(MedialPrune, LeadsFromEachCellToThatOfTheInput)
{
  vtkMedialPrune* first = boxPipeline().prune;
  expectInputCells(first->GetOutput(), boxPipeline().parts->GetOutput());
  expectInputCells(removed(first), boxPipeline().parts->GetOutput());
  vtkNew<vtkMedialPrune> second; // its input has such an array of its own
  second->SetInputConnection(first->GetOutputPort());
  second->SetSchedule("v30%");
  second->Update();
  ASSERT_GT(removed(second)->GetNumberOfCells(), 0);
  expectInputCells(second->GetOutput(), first->GetOutput());
  expectInputCells(removed(second), first->GetOutput());
}

TEST(MedialPrune, NeverRenumbersPoints)
{
  vtkPoints* points = boxPipeline().axis->GetOutput()->GetPoints();
  EXPECT_EQ(boxPipeline().prune->GetOutput()->GetPoints(), points);
  EXPECT_EQ(removed(boxPipeline().prune)->GetPoints(), points);
}

TEST(MedialPrune, PutsEveryCellInOneOutput)
{
  EXPECT_EQ(boxPipeline().prune->GetOutput()->GetNumberOfCells() +
      removed(boxPipeline().prune)->GetNumberOfCells(),
    boxPipeline().parts->GetOutput()->GetNumberOfCells());
}

TEST(MedialPrune, KeepsTheArraysOfACellWithIt)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  const auto input = filterTest::copy<vtkPolyData>(boxPipeline().parts->GetOutputDataObject(0));
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(i);
  }
  input->GetCellData()->AddArray(numbers);
  filter->SetInputData(input);
  filter->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 5);
  filter->Update();
  for (vtkPolyData* output : { filter->GetOutput(), removed(filter) })
  {
    vtkDataArray* number = output->GetCellData()->GetArray("Number");
    for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
    {
      vtkNew<vtkIdList> here, there;
      output->GetCellPoints(i, here);
      input->GetCellPoints(static_cast<vtkIdType>(number->GetComponent(i, 0)), there);
      ASSERT_EQ(here->GetNumberOfIds(), there->GetNumberOfIds());
      EXPECT_TRUE(std::equal(here->begin(), here->end(), there->begin()));
    }
  }
}

TEST(MedialPrune, HasTheDefaultScheduleOfItsHeader)
{
  vtkNew<vtkMedialPrune> filter;
  ASSERT_EQ(filter->GetNumberOfIterations(), 4);
  const int measures[] = { vtkMedialPrune::TRIANGLE_COUNT, vtkMedialPrune::TRIANGLE_COUNT,
    vtkMedialPrune::HAUSDORFF_DISTANCE, vtkMedialPrune::AREA };
  const double thresholds[] = { 5, 5, 0.5, 2 };
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(filter->GetIterationMeasure(i), measures[i]);
    EXPECT_EQ(filter->GetIterationThreshold(i), thresholds[i]);
    EXPECT_EQ(filter->GetIterationPasses(i), 0);
  }
  EXPECT_EQ(filter->GetIterationThreshold(4), 0);
  EXPECT_EQ(filter->GetIterationThreshold(-1), 0);
}

TEST(MedialPrune, TellsItsScheduleInTheHistory)
{
  vtkTable* rows = history(boxPipeline().prune);
  ASSERT_EQ(rows->GetNumberOfRows(), 4);
  const double spacing = field(boxPipeline().axis->GetOutput(), "SampleSpacing");
  EXPECT_EQ(rows->GetValueByName(0, "Measure").ToInt(), vtkMedialPrune::TRIANGLE_COUNT);
  EXPECT_EQ(rows->GetValueByName(0, "Threshold").ToDouble(), 5);
  EXPECT_EQ(rows->GetValueByName(2, "Measure").ToInt(), vtkMedialPrune::HAUSDORFF_DISTANCE);
  EXPECT_EQ(rows->GetValueByName(2, "Threshold").ToDouble(), 0.5 * spacing);
  EXPECT_EQ(rows->GetValueByName(3, "Measure").ToInt(), vtkMedialPrune::AREA);
  EXPECT_EQ(rows->GetValueByName(3, "Threshold").ToDouble(), 2 * (spacing * spacing));
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(rows->GetValueByName(i, "Iteration").ToInt(), i);
    EXPECT_EQ(rows->GetValueByName(i, "ByHand").ToInt(), 0);
    EXPECT_LE(rows->GetValueByName(i, "PartsAfter").ToInt(),
      rows->GetValueByName(i, "PartsBefore").ToInt());
  }
}

TEST(MedialPrune, LeavesTheMiddleSheetOfABoxAtLevelTwo)
{
  filterTest::Pipeline pipeline(filterTest::cloud(shapes::box().samples));
  pipeline.prune->ClearIterations();
  pipeline.prune->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 5);
  pipeline.prune->Update();
  vtkPolyData* output = pipeline.prune->GetOutput();
  EXPECT_EQ(output->GetCellData()->GetArray("PartLevel")->GetRange()[1], 2);
}

TEST(MedialPrune, RemovesNothingWithoutASchedule)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  filter->Update();
  EXPECT_EQ(removed(filter)->GetNumberOfCells(), 0);
  EXPECT_EQ(history(filter)->GetNumberOfRows(), 0);
  filter->GetOutput()->GetCellData()->RemoveArray("KeepReason");
  filter->GetOutput()->GetCellData()->RemoveArray("InputCell");
  EXPECT_TRUE(same(filter->GetOutput(), boxPipeline().parts->GetOutput()));
}

TEST(MedialPrune, NeedsNoParts)
{
  vtkNew<vtkMedialPrune> filter;
  filter->SetInputData(boxPipeline().axis->GetOutput());
  filter->Update();
  EXPECT_TRUE(same(filter->GetOutput(), boxPipeline().prune->GetOutput()));
}

TEST(MedialPrune, GoesOnWhereItStopped)
{
  vtkSmartPointer<vtkMedialPrune> first = pruneBox();
  first->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 5);
  first->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 5);
  vtkNew<vtkMedialPrune> second;
  second->SetInputConnection(first->GetOutputPort());
  second->SetSchedule("h0.5s a2s"); // what the default ends with
  second->Update();
  const auto resumed = filterTest::copy<vtkPolyData>(second->GetOutput());
  const auto begun = first->GetOutput()->GetCellData()->GetArray("InputCell");
  const auto cells = resumed->GetCellData()->GetArray("InputCell");
  for (vtkIdType i = 0; i < cells->GetNumberOfTuples(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(cells->GetComponent(i, 0));
    cells->SetComponent(i, 0, begun->GetComponent(cell, 0)); // of the input of the first
  }
  EXPECT_TRUE(same(resumed, boxPipeline().prune->GetOutput()));
}

TEST(MedialPrune, AutomaticallyLeavesTheScheduleAlone)
{
  vtkNew<vtkMedialPrune> filter;
  filter->SetInputData(boxPipeline().parts->GetOutput());
  filter->ClearIterations();
  filter->AddIteration(vtkMedialPrune::RELATIVE_VOLUME, 1);
  filter->AutomaticOn();
  filter->Update();
  vtkTable* history = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(history->GetValueByName(0, "Measure").ToInt(), vtkMedialPrune::TRIANGLE_COUNT);
  EXPECT_EQ(history->GetValueByName(0, "Threshold").ToDouble(), 5);
  EXPECT_EQ(filter->GetNumberOfIterations(), 1);
}

TEST(MedialPrune, KeepsTheBettiNumbers)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  filter->AddIteration(vtkMedialPrune::RELATIVE_VOLUME, 1);
  filter->Update();
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(field(filter->GetOutput(), "BettiAxis", i),
      field(boxPipeline().axis->GetOutput(), "BettiAxis", i));
  }
  EXPECT_EQ(field(filter->GetOutput(), "Certificate"), 1);
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(MedialPrune, DescribesItsProperties)
{
  std::ostringstream text;
  boxPipeline().prune->Print(text);
  for (const char* word : { "Schedule: t5 t5 h0.5s a2s", "Topology: COLLAPSE", "RemoveHair: on",
         "RemoveBranches: on", "PartsToRemove: 0", "CellsToRemove: 0", "PartsToProtect: 0",
         "CellsToProtect: 0", "SelectionRole: REMOVE", "VerifyTopology: off" })
  {
    EXPECT_NE(text.str().find(word), std::string::npos) << word;
  }
}

TEST(MedialPrune, KnowsTheDiagonalOfTheSamples)
{
  const auto samples = filterTest::cloud(filterTest::smallBox().samples);
  vtkNew<vtkMedialPrune> prune;
  prune->SetInputConnection(boxPipeline().axis->GetOutputPort());
  prune->SetSchedule("r2%");
  prune->Update();
  EXPECT_NEAR(
    history(prune)->GetValueByName(0, "Threshold").ToDouble(), 0.02 * samples->GetLength(), 1e-12);
  // Files of an earlier version don't tell it.
  const auto earlier = filterTest::copy<vtkPolyData>(boxPipeline().axis->GetOutput());
  earlier->GetFieldData()->RemoveArray("SampleDiagonal");
  prune->SetInputData(earlier);
  EXPECT_NE(filterTest::onlyError(prune).find("'r2%'"), std::string::npos);
  prune->SetSchedule("r0.2");
  prune->Update();
  EXPECT_EQ(history(prune)->GetNumberOfRows(), 1);
}

TEST(MedialPrune, RefusesAWordThatIsNoIteration)
{
  vtkNew<vtkMedialPrune> prune;
  prune->SetInputConnection(boxPipeline().parts->GetOutputPort());
  {
    const filterTest::ErrorLog log(prune);
    prune->SetSchedule("t5 x3");
    ASSERT_EQ(log.messages().size(), 1u);
    EXPECT_NE(log.messages()[0].find("word 2 of the schedule, 'x3'"), std::string::npos);
  }
  EXPECT_NE(filterTest::onlyError(prune).find("'x3'"), std::string::npos);
  EXPECT_TRUE(filterTest::failed(prune));
  prune->SetSchedule("t5");
  prune->Update();
  EXPECT_EQ(history(prune)->GetNumberOfRows(), 1);
}

TEST(MedialPrune, TakesMeasuresByName)
{
  vtkNew<vtkMedialPrune> prune;
  prune->ClearIterations();
  prune->AddIterationByName("Area", 2, 1);
  ASSERT_EQ(prune->GetNumberOfIterations(), 1);
  EXPECT_EQ(prune->GetIterationMeasure(0), vtkMedialPrune::AREA);
  EXPECT_EQ(prune->GetIterationThreshold(0), 2);
  EXPECT_EQ(prune->GetIterationPasses(0), 1);
  const filterTest::ErrorLog log(prune);
  prune->AddIterationByName("Beauty", 2);
  prune->AddIterationByName(nullptr, 2);
  EXPECT_EQ(prune->GetNumberOfIterations(), 1);
  ASSERT_EQ(log.messages().size(), 2u);
  EXPECT_NE(log.messages()[0].find("'Beauty'"), std::string::npos);
  EXPECT_NE(log.messages()[0].find("TriangleCount, RelativeVolume"), std::string::npos);
}

TEST(MedialPrune, DoesNotRunHalfASchedule)
{
  vtkNew<vtkMedialPrune> prune;
  prune->SetInputConnection(boxPipeline().axis->GetOutputPort());
  const filterTest::ErrorLog log(prune);
  prune->ClearIterations();
  prune->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 5);
  prune->AddIterationByName("Beauty", 2);
  prune->Update();
  EXPECT_EQ(prune->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_NE(prune->GetErrorCode(), 0u);
  ASSERT_EQ(log.messages().size(), 2u);
  EXPECT_NE(log.messages()[1].find("'Beauty'"), std::string::npos);

  prune->AutomaticOn(); // doesn't need the schedule
  prune->Update();
  EXPECT_GT(prune->GetOutput()->GetNumberOfCells(), 0);
  prune->AutomaticOff();
  prune->ClearIterations();
  prune->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 5);
  prune->Update();
  EXPECT_GT(prune->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(prune->GetErrorCode(), 0u);
}
}
