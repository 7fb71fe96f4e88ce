// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>
#include <vtkTable.h>

#include <functional>
#include <limits>
#include <set>
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
  std::vector<std::string> expected = arrays(parts->GetCellData());
  expected.emplace_back("KeepReason unsigned char 1");
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
  expected.emplace_back("Iteration idtype 1");
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(arrays(cells->GetCellData()), expected);
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

/// A selection of cells or points by a list of numbers.
vtkSmartPointer<vtkSelectionNode> selectionNode(
  int content, int field, const std::vector<double>& values, const char* array = "")
{
  vtkNew<vtkDoubleArray> list;
  list->SetName(array);
  list->SetNumberOfComponents(content == vtkSelectionNode::THRESHOLDS ? 2
      : content == vtkSelectionNode::LOCATIONS                        ? 3
                                                                      : 1);
  for (const double value : values)
  {
    list->InsertNextValue(value);
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->DeepCopy(list);
  auto node = vtkSmartPointer<vtkSelectionNode>::New();
  node->SetContentType(content);
  node->SetFieldType(field);
  const bool isIds = content == vtkSelectionNode::INDICES || content == vtkSelectionNode::VALUES;
  node->SetSelectionList(isIds ? static_cast<vtkDataArray*>(ids) : list);
  return node;
}

vtkSmartPointer<vtkSelection> selectionOf(
  const std::vector<vtkSmartPointer<vtkSelectionNode>>& nodes, const char* expression = "")
{
  auto selection = vtkSmartPointer<vtkSelection>::New();
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    selection->SetNode("n" + std::to_string(i), nodes[i]);
  }
  selection->SetExpression(expression);
  return selection;
}

/// How many cells of the input the filter removes with a selection.
vtkIdType removedWith(vtkSelection* selection)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  filter->SetTopologyToNone();
  filter->SetInputData(1, selection);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  return removed(filter)->GetNumberOfCells();
}

vtkIdType cellsOfParts(const std::function<bool(double)>& chosen)
{
  vtkDataArray* parts = boxPipeline().parts->GetOutput()->GetCellData()->GetArray("PartId");
  vtkIdType cells = 0;
  for (vtkIdType i = 0; i < parts->GetNumberOfTuples(); ++i)
  {
    cells += chosen(parts->GetComponent(i, 0));
  }
  return cells;
}

double partOf(vtkIdType cell)
{
  return boxPipeline().parts->GetOutput()->GetCellData()->GetArray("PartId")->GetComponent(cell, 0);
}

TEST(MedialPrune, RemovesThePartsOfSelectedCells)
{
  const double a = partOf(0), b = partOf(100);
  ASSERT_NE(a, b);
  const vtkIdType expected = cellsOfParts([=](double part) { return part == a || part == b; });
  using Node = vtkSelectionNode;
  const auto both = selectionNode(Node::INDICES, Node::CELL, { 0, 100 });
  const auto onlyB = selectionNode(Node::VALUES, Node::CELL, { b }, "PartId");
  EXPECT_EQ(removedWith(selectionOf({ both })), expected);
  EXPECT_EQ(
    removedWith(selectionOf({ selectionNode(Node::INDICES, Node::CELL, { 0 }), onlyB })), expected);
  EXPECT_EQ(removedWith(selectionOf({ both, onlyB }, "n0 & !n1")),
    cellsOfParts([=](double part) { return part == a; }));
  EXPECT_EQ(
    removedWith(selectionOf({ selectionNode(Node::THRESHOLDS, Node::CELL, { 2, 4 }, "PartId") })),
    cellsOfParts([](double part) { return part >= 2 && part <= 4; }));
}

TEST(MedialPrune, RemovesThePartsAtSelectedPoints)
{
  vtkPolyData* parts = boxPipeline().parts->GetOutput();
  vtkNew<vtkIdList> corners;
  parts->GetCellPoints(100, corners);
  const vtkIdType point = corners->GetId(0);
  std::set<double> there;
  for (vtkIdType cell = 0; cell < parts->GetNumberOfCells(); ++cell)
  {
    parts->GetCellPoints(cell, corners);
    if (corners->IsId(point) >= 0)
    {
      there.insert(partOf(cell));
    }
  }
  const vtkIdType expected = cellsOfParts([&](double part) { return there.count(part) > 0; });
  using Node = vtkSelectionNode;
  const auto byIndex = selectionNode(Node::INDICES, Node::POINT, { static_cast<double>(point) });
  byIndex->GetProperties()->Set(Node::PROCESS_ID(), 3);
  byIndex->GetProperties()->Set(Node::COMPOSITE_INDEX(), 7);
  EXPECT_EQ(removedWith(selectionOf({ byIndex })), expected);
  double place[3];
  parts->GetPoint(point, place);
  const auto byPlace =
    selectionNode(Node::LOCATIONS, Node::POINT, { place[0], place[1], place[2] });
  byPlace->GetProperties()->Set(Node::EPSILON(), 1e-9);
  EXPECT_EQ(removedWith(selectionOf({ byPlace })), expected);
}

TEST(MedialPrune, RemovesThePartsInASelectedFrustum)
{
  // The half space z > 0.1, as a box whose corners begin near, left, below.
  vtkPolyData* parts = boxPipeline().parts->GetOutput();
  const double far = 100, near = 0.1;
  vtkNew<vtkDoubleArray> list;
  list->SetNumberOfComponents(4);
  for (const double x : { -far, far })
  {
    for (const double y : { -far, far })
    {
      for (const double z : { far, near })
      {
        list->InsertNextTuple4(x, y, z, 1);
      }
    }
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::FRUSTUM);
  node->SetFieldType(vtkSelectionNode::CELL);
  node->SetSelectionList(list);
  std::set<double> touched;
  for (vtkIdType cell = 0; cell < parts->GetNumberOfCells(); ++cell)
  {
    if (parts->GetCell(cell)->GetBounds()[5] > near)
    {
      touched.insert(partOf(cell));
    }
  }
  const vtkIdType expected = cellsOfParts([&](double part) { return touched.count(part) > 0; });
  ASSERT_GT(expected, 0);
  ASSERT_LT(expected, parts->GetNumberOfCells());
  EXPECT_EQ(removedWith(selectionOf({ node.Get() })), expected);
}

TEST(MedialPrune, RemovesNothingWithAnEmptySelection)
{
  using Node = vtkSelectionNode;
  EXPECT_EQ(removedWith(selectionOf({})), 0);
  EXPECT_EQ(removedWith(selectionOf({ selectionNode(Node::INDICES, Node::CELL, {}) })), 0);
}

TEST(MedialPrune, ProtectsThePartsOfASelection)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  filter->SetTopologyToNone();
  filter->AddIteration(vtkMedialPrune::RELATIVE_VOLUME, 1);
  filter->SetInputData(
    1, selectionOf({ selectionNode(vtkSelectionNode::INDICES, vtkSelectionNode::CELL, { 0 }) }));
  filter->SetSelectionRoleToProtect();
  filter->Update();
  const double part = partOf(0);
  EXPECT_GE(
    filter->GetOutput()->GetNumberOfCells(), cellsOfParts([=](double p) { return p == part; }));
  EXPECT_EQ(filter->GetOutput()->GetCellData()->GetArray("KeepReason")->GetRange()[1], 4);
  EXPECT_GT(history(filter)->GetValueByName(0, "RefusedProtected").ToInt(), 0);
}

TEST(MedialPrune, RefusesSelectionsThatItCantEvaluate)
{
  using Node = vtkSelectionNode;
  const auto errorWith = [](vtkSelection* selection) {
    vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
    filter->SetInputData(1, selection);
    return onlyError(filter);
  };
  const auto good = selectionNode(Node::INDICES, Node::CELL, { 0 });
  for (const int content : { Node::QUERY, Node::USER, Node::BLOCKS, Node::BLOCK_SELECTORS })
  {
    const auto bad = selectionNode(Node::INDICES, Node::CELL, { 0 });
    bad->SetContentType(content);
    const std::string error = errorWith(selectionOf({ good, bad }, "n0 | (n0 & !n1)"));
    EXPECT_NE(error.find(std::string("of the type ") + Node::GetContentTypeAsString(content)),
      std::string::npos)
      << error;
    EXPECT_NE(error.find("by their indices instead"), std::string::npos) << error;
  }
  const std::vector<std::pair<vtkSmartPointer<vtkSelectionNode>, const char*>> others = {
    { selectionNode(Node::INDICES, Node::ROW, { 0 }), "neither of cells nor of points" },
    { selectionNode(Node::VALUES, Node::CELL, { 0 }, "Nothing"), "array 'Nothing'" },
    { selectionNode(Node::GLOBALIDS, Node::CELL, { 0 }), "ids that the axis doesn't have" },
    { selectionNode(Node::FRUSTUM, Node::CELL, { 0 }), "another shape" },
  };
  for (const auto& [node, words] : others)
  {
    const std::string error = errorWith(selectionOf({ node }));
    EXPECT_NE(error.find(words), std::string::npos) << error;
  }
}

TEST(MedialPrune, WarnsOnceOfWhatItDidNotRemove)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  filter->AddIteration(vtkMedialPrune::TRIANGLE_COUNT, 5, 1);
  filter->RemoveHairOff();
  filter->Update();
  const auto gone =
    static_cast<vtkIdType>(removed(filter)->GetCellData()->GetArray("PartId")->GetComponent(0, 0));
  vtkIdType kept = 0;
  const vtkIdType tail = boxPipeline().parts->GetOutput()->GetNumberOfCells() - 1;
  kept = static_cast<vtkIdType>(partOf(tail));
  ASSERT_NE(kept, gone);
  filter->AddPartToRemove(gone);
  filter->AddPartToRemove(kept);
  filter->AddPartToProtect(kept);
  const filterTest::ErrorLog log(filter, vtkCommand::WarningEvent);
  filter->Update();
  ASSERT_EQ(log.messages().size(), 1u);
  const std::string text = log.messages()[0];
  EXPECT_NE(text.find("parts " + std::to_string(gone) + ": already gone"), std::string::npos)
    << text;
  EXPECT_NE(text.find("parts " + std::to_string(kept) + ": protected"), std::string::npos) << text;
  EXPECT_EQ(filter->GetErrorCode(), 0u);
}

TEST(MedialPrune, RefusesToProtectWhatIsNotThere)
{
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  filter->AddPartToProtect(123456);
  const std::string error = onlyError(filter);
  EXPECT_NE(error.find("part 123456 can't be protected"), std::string::npos) << error;
  filter->ClearPartsToProtect();
  filter->AddCellToProtect(-1);
  const std::string cell = onlyError(filter);
  EXPECT_NE(cell.find("cell -1 can't be protected"), std::string::npos) << cell;
}

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
  fresh->ClearIterations();
  for (int i = 0; i < filter->GetNumberOfIterations(); ++i)
  {
    fresh->AddIteration(filter->GetIterationMeasure(i), filter->GetIterationThreshold(i));
  }
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

TEST(MedialPrune, SeesThatItsInputHasChanged)
{
  const auto input = filterTest::copy<vtkPolyData>(boxPipeline().axis->GetOutput());
  const auto other = filterTest::copy<vtkPolyData>(boxPipeline().prune->GetOutput());
  vtkNew<vtkMedialPrune> filter;
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

TEST(MedialPrune, DescribesItsProperties)
{
  std::ostringstream text;
  boxPipeline().prune->Print(text);
  for (const char* word : { "Schedule: t5 t5 v1%", "Topology: COLLAPSE", "RemoveHair: on",
         "RemoveBranches: on", "PartsToRemove: 0", "CellsToRemove: 0", "PartsToProtect: 0",
         "CellsToProtect: 0", "SelectionRole: REMOVE", "VerifyTopology: off" })
  {
    EXPECT_NE(text.str().find(word), std::string::npos) << word;
  }
}

TEST(MedialPrune, TakesAScheduleInWords)
{
  vtkNew<vtkMedialPrune> prune;
  EXPECT_EQ(prune->GetScheduleWords(), "t5 t5 v1%");
  const vtkMTimeType before = prune->GetMTime();
  prune->SetSchedule("t5, t5 v1%");
  EXPECT_EQ(prune->GetMTime(), before);
  prune->SetSchedule("a0.5x2 r3%");
  EXPECT_GT(prune->GetMTime(), before);
  ASSERT_EQ(prune->GetNumberOfIterations(), 2);
  EXPECT_EQ(prune->GetIterationMeasure(0), vtkMedialPrune::AREA);
  EXPECT_EQ(prune->GetIterationThreshold(0), 0.5);
  EXPECT_EQ(prune->GetIterationPasses(0), 2);
  EXPECT_EQ(prune->GetScheduleWords(), "a0.5x2 r3%");
  prune->SetSchedule(nullptr);
  EXPECT_EQ(prune->GetNumberOfIterations(), 0);
}

TEST(MedialPrune, TellsTheWordsInItsHistory)
{
  vtkNew<vtkMedialPrune> prune;
  prune->SetInputConnection(boxPipeline().parts->GetOutputPort());
  prune->SetSchedule("t5 v0.01%x1");
  prune->AddCellToRemove(0);
  prune->Update();
  vtkTable* rows = history(prune);
  ASSERT_EQ(rows->GetNumberOfRows(), 3);
  EXPECT_EQ(rows->GetValueByName(0, "Word").ToString(), "t5");
  EXPECT_EQ(rows->GetValueByName(1, "Word").ToString(), "v0.01%");
  EXPECT_EQ(rows->GetValueByName(2, "Word").ToString(), "by hand");
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
