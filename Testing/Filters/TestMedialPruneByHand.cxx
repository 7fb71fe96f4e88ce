// SPDX-License-Identifier: BSD-3-Clause
#include "MedialPruneTest.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkSelection.h>
#include <vtkSelectionNode.h>

#include <functional>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
using filterTest::boxPipeline;
using filterTest::onlyError;
using filterTest::same;
using medialPruneTest::history;
using medialPruneTest::pruneBox;
using medialPruneTest::removed;

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

TEST(MedialPrune, RemovesInACollectionOnlyWhatIsSelectedInTheBlock)
{
  vtkPolyData* parts = boxPipeline().parts->GetOutput();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, filterTest::copy<vtkPolyData>(parts));
  blocks->SetBlock(1, filterTest::copy<vtkPolyData>(parts));
  using Node = vtkSelectionNode;
  const auto first = selectionNode(Node::INDICES, Node::CELL, { 0 });
  const auto second = selectionNode(Node::INDICES, Node::CELL, { 100 });
  first->GetProperties()->Set(Node::COMPOSITE_INDEX(), 1);
  second->GetProperties()->Set(Node::COMPOSITE_INDEX(), 2);
  const double a = partOf(0), b = partOf(100);
  ASSERT_NE(a, b);
  vtkSmartPointer<vtkMedialPrune> filter = pruneBox();
  filter->SetTopologyToNone();
  filter->SetInputDataObject(0, blocks);
  filter->SetInputData(1, selectionOf({ first, second }, "n0 | n1"));
  for (int run = 0; run < 2; ++run)
  {
    filter->Modified();
    filter->Update();
    auto* gone = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(2));
    ASSERT_TRUE(gone);
    EXPECT_EQ(gone->GetBlock(0)->GetNumberOfElements(vtkDataObject::CELL),
      cellsOfParts([=](double part) { return part == a; }));
    EXPECT_EQ(gone->GetBlock(1)->GetNumberOfElements(vtkDataObject::CELL),
      cellsOfParts([=](double part) { return part == b; }));
  }
}

TEST(MedialPrune, RemovesNothingWithAnEmptySelection)
{
  using Node = vtkSelectionNode;
  EXPECT_EQ(removedWith(selectionOf({})), 0);
  EXPECT_EQ(removedWith(selectionOf({ selectionNode(Node::INDICES, Node::CELL, {}) })), 0);
}

TEST(MedialPrune, RemovesWhatIsNotInAnEmptySelection)
{
  using Node = vtkSelectionNode;
  auto nothing = selectionNode(Node::INDICES, Node::CELL, {});
  nothing->GetProperties()->Set(Node::INVERSE(), 1);
  const vtkIdType all = removedWith(selectionOf({ nothing }));
  EXPECT_GT(all, 0);
  std::vector<double> cells(
    static_cast<std::size_t>(boxPipeline().parts->GetOutput()->GetNumberOfCells()));
  std::iota(cells.begin(), cells.end(), 0);
  EXPECT_EQ(removedWith(selectionOf({ selectionNode(Node::INDICES, Node::CELL, cells) })), all);
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
}
