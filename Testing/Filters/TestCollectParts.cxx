// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include "vtkCollectParts.h"
#include "vtkSimplifyShape.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using filterTest::cloud;
using filterTest::same;
using filterTest::smallBox;

/// A box, nothing, a sphere, and the same box again; all their parts.
struct Collection
{
  explicit Collection(bool unique)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, cloud(smallBox().samples));
    blocks->SetBlock(2, cloud(shapes::sphere(0.4).samples));
    blocks->SetBlock(3, cloud(smallBox().samples));
    this->Simplify->SetInputDataObject(blocks);
    this->Simplify->ClearIterations();
    this->Collect->SetInputConnection(this->Simplify->GetOutputPort(2));
    this->Collect->SetPartsConnection(this->Simplify->GetOutputPort(1));
    this->Collect->SetUniquePartIds(unique);
    this->Collect->Update();
  }

  vtkDataObject* Before(int port, int block)
  {
    return vtkMultiBlockDataSet::SafeDownCast(this->Simplify->GetOutputDataObject(port))
      ->GetBlock(block);
  }
  vtkDataObject* Parts(int block)
  {
    return vtkMultiBlockDataSet::SafeDownCast(this->Collect->GetOutputDataObject(1))
      ->GetBlock(block);
  }
  vtkTable* Table() { return vtkTable::SafeDownCast(this->Collect->GetOutputDataObject(0)); }

  vtkNew<vtkSimplifyShape> Simplify;
  vtkNew<vtkCollectParts> Collect;
};

std::vector<vtkIdType> values(vtkDataObject* data, int kind, const char* name)
{
  auto* array = vtkIdTypeArray::SafeDownCast(data->GetAttributes(kind)->GetArray(name));
  return { array->Begin(), array->End() };
}

std::vector<double> tuple(vtkTable* table, int column, vtkIdType row)
{
  vtkDataArray* array = table->GetRowData()->GetArray(column);
  std::vector<double> result(array->GetNumberOfComponents());
  array->GetTuple(row, result.data());
  return result;
}

TEST(CollectParts, PutsAllTablesIntoOne)
{
  Collection all(false);
  vtkTable* table = all.Table();
  EXPECT_STREQ(table->GetColumnName(0), "ObjectId");
  vtkIdType row = 0;
  for (const int block : { 0, 2, 3 })
  {
    auto* before = vtkTable::SafeDownCast(all.Before(2, block));
    ASSERT_EQ(table->GetNumberOfColumns(), before->GetNumberOfColumns() + 1);
    for (vtkIdType i = 0; i < before->GetNumberOfRows(); ++i, ++row)
    {
      EXPECT_EQ(table->GetValueByName(row, "ObjectId"), vtkVariant(block));
      for (int column = 0; column < before->GetNumberOfColumns(); ++column)
      {
        EXPECT_EQ(tuple(table, column + 1, row), tuple(before, column, i));
      }
    }
    EXPECT_TRUE(same(all.Parts(block), all.Before(1, block)));
  }
  EXPECT_EQ(table->GetNumberOfRows(), row);
  EXPECT_FALSE(all.Parts(1));
}

TEST(CollectParts, NumbersPartsFromBlockToBlock)
{
  Collection all(true);
  const std::vector<vtkIdType> rows = values(all.Table(), vtkDataObject::ROW, "PartId");
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    EXPECT_EQ(rows[i], static_cast<vtkIdType>(i));
  }
  vtkIdType first = 0;
  for (const int block : { 0, 2, 3 })
  {
    std::vector<vtkIdType> expected = values(all.Before(1, block), vtkDataObject::CELL, "PartId");
    std::set<vtkIdType> parts(expected.begin(), expected.end());
    for (vtkIdType& part : expected)
    {
      part += first;
    }
    EXPECT_EQ(values(all.Parts(block), vtkDataObject::CELL, "PartId"), expected);
    first += static_cast<vtkIdType>(parts.size());
  }
  EXPECT_EQ(first, static_cast<vtkIdType>(rows.size()));
}

TEST(CollectParts, NeedsNoParts)
{
  Collection all(false);
  const auto table = filterTest::copy<vtkTable>(all.Table());
  all.Collect->SetPartsConnection(nullptr);
  all.Collect->Update();
  EXPECT_TRUE(same(all.Table(), table));
}

TEST(CollectParts, RefusesWhatIsNoTableOrHasOtherColumns)
{
  Collection all(false);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, all.Before(1, 0));
  vtkNew<vtkCollectParts> collect;
  collect->SetInputData(blocks);
  EXPECT_NE(filterTest::onlyError(collect).find("block 1 isn't a table"), std::string::npos);
  vtkNew<vtkIdTypeArray> column;
  column->SetName("Other");
  column->SetNumberOfValues(1);
  column->FillValue(0);
  vtkNew<vtkTable> other;
  other->AddColumn(column);
  blocks->SetBlock(1, all.Before(2, 0));
  blocks->SetBlock(2, other);
  blocks->Modified();
  EXPECT_NE(filterTest::onlyError(collect).find("different columns"), std::string::npos);
  all.Collect->SetInputConnection(nullptr);
  blocks->SetNumberOfBlocks(2);
  blocks->Modified();
  all.Collect->SetInputData(blocks);
  EXPECT_NE(filterTest::onlyError(all.Collect).find("more blocks"), std::string::npos);
}

TEST(CollectParts, RefusesTablesWithFractionsForPartsOrAShortColumn)
{
  Collection all(false);
  const auto table = filterTest::copy<vtkTable>(all.Before(2, 0));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, table);
  vtkNew<vtkCollectParts> collect;
  collect->SetInputData(blocks);
  vtkNew<vtkDoubleArray> fractions;
  fractions->DeepCopy(table->GetColumnByName("PartId"));
  fractions->SetComponent(0, 0, std::nan(""));
  table->GetRowData()->AddArray(fractions);
  blocks->Modified();
  std::string error = filterTest::onlyError(collect);
  EXPECT_NE(error.find("block 0 isn't a table of parts"), std::string::npos) << error;
  table->ShallowCopy(filterTest::copy<vtkTable>(all.Before(2, 0)));
  table->GetColumnByName("Level")->SetNumberOfTuples(1);
  blocks->Modified();
  error = filterTest::onlyError(collect);
  EXPECT_NE(error.find("block 0 isn't a table of parts"), std::string::npos) << error;
}

TEST(CollectParts, RefusesPartsWithFractions)
{
  Collection all(false);
  const auto parts = filterTest::copy<vtkPolyData>(all.Before(1, 0));
  vtkNew<vtkDoubleArray> fractions;
  fractions->DeepCopy(parts->GetCellData()->GetArray("PartId"));
  fractions->SetComponent(0, 0, std::nan(""));
  parts->GetCellData()->AddArray(fractions);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, parts);
  all.Collect->SetPartsConnection(nullptr);
  all.Collect->SetInputData(1, blocks);
  const std::string error = filterTest::onlyError(all.Collect);
  EXPECT_NE(error.find("'PartId' must hold whole numbers"), std::string::npos) << error;
}

TEST(CollectParts, PrintsItself)
{
  std::ostringstream text;
  vtkNew<vtkCollectParts> collect;
  collect->UniquePartIdsOn();
  collect->Print(text);
  EXPECT_NE(text.str().find("\n  UniquePartIds: on\n"), std::string::npos);
}
}
