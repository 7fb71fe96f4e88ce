// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <limits>
#include <sstream>

namespace
{
using filterTest::arrays;
using filterTest::boxPipeline;
using filterTest::onlyError;
using filterTest::same;

/// The filter on the parts of the box, without a schedule.
vtkSmartPointer<vtkMedialPrune> pruneBox()
{
  auto filter = vtkSmartPointer<vtkMedialPrune>::New();
  filter->SetInputData(boxPipeline().parts->GetOutput());
  filter->ClearIterations();
  return filter;
}

vtkTable* history(vtkMedialPrune* filter)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
}

vtkPolyData* removed(vtkMedialPrune* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(2));
}

double field(vtkDataObject* data, const char* name, int component = 0)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, component);
}

TEST(MedialPrune, HasTheArraysOfItsHeader)
{
  vtkPolyData *parts = boxPipeline().parts->GetOutput(), *pruned = boxPipeline().prune->GetOutput();
  EXPECT_EQ(arrays(pruned->GetPointData()), arrays(parts->GetPointData()));
  EXPECT_EQ(arrays(pruned->GetFieldData()), arrays(parts->GetFieldData()));
  EXPECT_EQ(arrays(pruned->GetCellData()),
    (std::vector<std::string>{ "ErosionThickness double 1", "KeepReason unsigned char 1",
      "Lambda double 1", "ObjectAngle double 1", "PartId idtype 1", "PartLevel int 1",
      "PolygonId idtype 1", "RelativeVolume double 1", "SiteSamples idtype 2",
      "TriangleCount idtype 1" }));
}

TEST(MedialPrune, HasTheColumnsOfItsHeader)
{
  EXPECT_EQ(arrays(history(boxPipeline().prune)->GetRowData()),
    (std::vector<std::string>{ "Betti idtype 3", "ByHand unsigned char 1", "Candidates idtype 1",
      "Iteration idtype 1", "Measure int 1", "PartsAfter idtype 1", "PartsBefore idtype 1",
      "Passes int 1", "Refused idtype 1", "Removed idtype 1", "Threshold double 1",
      "VolumeRemoved double 1" }));
}

TEST(MedialPrune, HasTheArraysOfItsHeaderOnWhatItRemoved)
{
  vtkPolyData* cells = removed(boxPipeline().prune);
  EXPECT_EQ(arrays(cells->GetCellData()),
    (std::vector<std::string>{ "ErosionThickness double 1", "Iteration idtype 1", "Lambda double 1",
      "ObjectAngle double 1", "PartId idtype 1", "PartLevel int 1", "PolygonId idtype 1",
      "RelativeVolume double 1", "SiteSamples idtype 2", "TriangleCount idtype 1" }));
  EXPECT_GT(cells->GetNumberOfCells(), 0);
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
  ASSERT_EQ(filter->GetNumberOfIterations(), 3);
  const int measures[] = { vtkMedialPrune::TRIANGLE_COUNT, vtkMedialPrune::TRIANGLE_COUNT,
    vtkMedialPrune::RELATIVE_VOLUME };
  const double thresholds[] = { 5, 5, 0.01 };
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(filter->GetIterationMeasure(i), measures[i]);
    EXPECT_EQ(filter->GetIterationThreshold(i), thresholds[i]);
    EXPECT_EQ(filter->GetIterationPasses(i), 0);
  }
  EXPECT_EQ(filter->GetIterationThreshold(3), 0);
  EXPECT_EQ(filter->GetIterationThreshold(-1), 0);
}

TEST(MedialPrune, TellsItsScheduleInTheHistory)
{
  vtkTable* rows = history(boxPipeline().prune);
  ASSERT_EQ(rows->GetNumberOfRows(), 3);
  EXPECT_EQ(rows->GetValueByName(0, "Measure").ToInt(), vtkMedialPrune::TRIANGLE_COUNT);
  EXPECT_EQ(rows->GetValueByName(0, "Threshold").ToDouble(), 5);
  EXPECT_EQ(rows->GetValueByName(2, "Measure").ToInt(), vtkMedialPrune::RELATIVE_VOLUME);
  EXPECT_EQ(rows->GetValueByName(2, "Threshold").ToDouble(), 0.01);
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
  second->ClearIterations();
  second->AddIteration(vtkMedialPrune::RELATIVE_VOLUME, 0.01);
  second->Update();
  EXPECT_TRUE(same(second->GetOutput(), boxPipeline().prune->GetOutput()));
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

TEST(MedialPrune, RemovesPartsByTheirNumberInTheInput)
{
  vtkDataArray* parts = boxPipeline().parts->GetOutput()->GetCellData()->GetArray("PartId");
  const auto part = static_cast<vtkIdType>(parts->GetComponent(0, 0));
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  filter->SetTopologyToNone();
  filter->AddPartToRemove(part);
  EXPECT_EQ(filter->GetNumberOfPartsToRemove(), 1);
  filter->Update();
  ASSERT_EQ(history(filter)->GetNumberOfRows(), 1);
  EXPECT_EQ(history(filter)->GetValueByName(0, "ByHand").ToInt(), 1);
  vtkIdType cells = 0;
  for (vtkIdType i = 0; i < parts->GetNumberOfTuples(); ++i)
  {
    cells += parts->GetComponent(i, 0) == part;
  }
  EXPECT_EQ(removed(filter)->GetNumberOfCells(), cells);
}

TEST(MedialPrune, RemovesThePartOfACell)
{
  vtkSmartPointer<vtkMedialPrune> byPart = pruneBox(), byCell = pruneBox();
  byPart->AddPartToRemove(0);
  byCell->AddCellToRemove(boxPipeline().parts->GetOutput()->GetNumberOfVerts() +
    boxPipeline().parts->GetOutput()->GetNumberOfLines()); // parts begin with the first triangle's
  byPart->Update();
  byCell->Update();
  EXPECT_TRUE(same(byPart->GetOutput(), byCell->GetOutput()));
}

TEST(MedialPrune, RefusesToRemovePartsOfAnAxisWithoutParts)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  filter->SetInputData(boxPipeline().axis->GetOutput());
  filter->AddPartToRemove(0);
  const std::string error = onlyError(filter);
  EXPECT_NE(error.find("without the cell array 'PartId': take the output of "
                       "vtkMedialPartDecomposition"),
    std::string::npos)
    << error;
  filter->ClearPartsToRemove();
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
}

TEST(MedialPrune, RefusesToRemoveAPartThatIsNotThere)
{
  for (const vtkIdType part : { vtkIdType(-1), vtkIdType(123456), vtkIdType(1) << 40 })
  {
    vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
    filter->AddPartToRemove(0);
    filter->AddPartToRemove(part);
    const std::string error = onlyError(filter);
    EXPECT_NE(error.find("part " + std::to_string(part) + " can't be removed"), std::string::npos)
      << error;
  }
}

TEST(MedialPrune, RefusesToRemoveACellThatIsNotThere)
{
  for (const vtkIdType cell : { vtkIdType(-1), vtkIdType(12345678), vtkIdType(1) << 40 })
  {
    vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
    filter->AddCellToRemove(cell);
    const std::string error = onlyError(filter);
    EXPECT_NE(error.find("cell " + std::to_string(cell) + " can't be removed"), std::string::npos)
      << error;
  }
}

TEST(MedialPrune, RefusesThresholdsThatAreNegativeOrNoNumbers)
{
  for (const double threshold : { -1., std::numeric_limits<double>::quiet_NaN() })
  {
    vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
    filter->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, threshold);
    const std::string error = onlyError(filter);
    EXPECT_NE(error.find("threshold"), std::string::npos) << error;
  }
}

TEST(MedialPrune, RefusesAMeasureThatItDoesNotKnow)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  const filterTest::ErrorLog log(filter);
  filter->AddIteration(77, 5);
  ASSERT_EQ(log.messages().size(), 1u);
  EXPECT_NE(log.messages()[0].find("there is no measure 77"), std::string::npos);
  EXPECT_EQ(filter->GetNumberOfIterations(), 0);
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
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const vtkMTimeType before = filter->GetMTime();
    changes[i]();
    EXPECT_GT(filter->GetMTime(), before) << "change " << i;
  }
  EXPECT_EQ(filter->GetIterationPasses(0), 1);
}

TEST(MedialPrune, DescribesItsProperties)
{
  std::ostringstream text;
  boxPipeline().prune->Print(text);
  for (const char* word : { "TriangleCount <= 5", "RelativeVolume <= 0.01", "Topology: COLLAPSE",
         "RemoveHair: on", "RemoveBranches: on", "PartsToRemove: 0", "CellsToRemove: 0" })
  {
    EXPECT_NE(text.str().find(word), std::string::npos) << word;
  }
}
}
