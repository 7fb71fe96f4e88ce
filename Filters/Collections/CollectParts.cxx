// SPDX-License-Identifier: BSD-3-Clause
#include "Collections/CollectParts.h"

#include "Base/Errors.h"
#include "Collections/Objects.h"
#include "Conversion/ArrayNames.h"

#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{
/// Are the numbers of parts, where there are any, whole?
bool hasWholeParts(vtkDataSetAttributes* attributes)
{
  vtkAbstractArray* found = attributes->GetAbstractArray(names::PartId);
  vtkDataArray* parts = vtkDataArray::SafeDownCast(found);
  return !found ||
    (parts && parts->GetNumberOfComponents() == 1 && parts->GetDataType() != VTK_DOUBLE &&
      parts->GetDataType() != VTK_FLOAT);
}

/// Nothing, or a table with columns of one length.
bool isTableOfParts(vtkDataObject* data)
{
  auto* table = vtkTable::SafeDownCast(data);
  bool result = !data || (table && hasWholeParts(table->GetRowData()));
  for (vtkIdType i = 0; table && i < table->GetNumberOfColumns(); ++i)
  {
    result = result && table->GetColumn(i)->GetNumberOfTuples() == table->GetNumberOfRows();
  }
  return result;
}

/// For each block its number of rows, -1 where it is no table of parts.
std::vector<vtkIdType> rowCounts(vtkCompositeDataSet* tables)
{
  std::vector<vtkIdType> result;
  for (auto block = firstBlock(tables); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    vtkDataObject* data = block->GetCurrentDataObject();
    result.push_back(!isTableOfParts(data) ? -1
        : data                             ? data->GetNumberOfElements(vtkDataObject::ROW)
                                           : 0);
  }
  return result;
}

std::vector<vtkIdType> overAllRanks(
  const std::vector<vtkIdType>& values, int operation, vtkMultiProcessController* ranks)
{
  std::vector<vtkIdType> result(values);
  if (ranks && ranks->GetNumberOfProcesses() > 1)
  {
    ranks->AllReduce(
      values.data(), result.data(), static_cast<vtkIdType>(values.size()), operation);
  }
  return result;
}

/// PartId with something added; -1 stays.
vtkSmartPointer<vtkIdTypeArray> renumbered(vtkDataArray* parts, vtkIdType first)
{
  auto result = vtkSmartPointer<vtkIdTypeArray>::New();
  result->SetName(names::PartId);
  result->SetNumberOfValues(parts->GetNumberOfTuples());
  for (vtkIdType i = 0; i < parts->GetNumberOfTuples(); ++i)
  {
    const auto part = static_cast<vtkIdType>(parts->GetComponent(i, 0));
    result->SetValue(i, part < 0 ? part : part + first);
  }
  return result;
}

vtkSmartPointer<vtkDataObject> renumberedCopy(vtkDataObject* data, vtkIdType first)
{
  const auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
  copy->ShallowCopy(data);
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW })
  {
    vtkDataSetAttributes* attributes = copy->GetAttributes(kind);
    vtkDataArray* parts = attributes ? attributes->GetArray(names::PartId) : nullptr;
    if (attributes && !hasWholeParts(attributes))
    {
      throw InvalidInput("the array '", names::PartId,
        "' must hold whole numbers: take the parts of vtkMedialPartDecomposition or "
        "vtkMedialPrune");
    }
    if (parts)
    {
      attributes->AddArray(renumbered(parts, first));
    }
  }
  return copy;
}

/// Appends the rows. The first rows decide about the columns.
void append(vtkDataSetAttributes* rows, vtkDataSetAttributes* output)
{
  if (output->GetNumberOfArrays() == 0)
  {
    output->DeepCopy(rows);
    return;
  }
  for (int i = 0; i < output->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* column = output->GetAbstractArray(i);
    vtkAbstractArray* more = rows->GetAbstractArray(column->GetName());
    if (!more || more->GetNumberOfComponents() != column->GetNumberOfComponents() ||
      rows->GetNumberOfArrays() != output->GetNumberOfArrays())
    {
      throw InvalidInput("the tables have different columns (", column->GetName(),
        "): take those that one filter gives for all blocks");
    }
    column->InsertTuples(column->GetNumberOfTuples(), more->GetNumberOfTuples(), 0, more);
  }
}

/// The rows with the block's number in front.
vtkSmartPointer<vtkTable> numberedRows(vtkTable* table, vtkIdType object, vtkIdType firstPart)
{
  const auto copy = renumberedCopy(table, firstPart);
  vtkDataSetAttributes* columns = vtkTable::SafeDownCast(copy)->GetRowData();
  vtkNew<vtkIdTypeArray> objects;
  objects->SetName(names::ObjectId);
  objects->SetNumberOfValues(table->GetNumberOfRows());
  objects->FillValue(object);
  auto result = vtkSmartPointer<vtkTable>::New();
  result->AddColumn(objects);
  for (int i = 0; i < columns->GetNumberOfArrays(); ++i)
  {
    result->AddColumn(columns->GetAbstractArray(i));
  }
  return result;
}
}

std::vector<vtkIdType> firstParts(
  vtkCompositeDataSet* tables, bool unique, vtkMultiProcessController* ranks)
{
  std::vector<vtkIdType> counts = rowCounts(tables);
  const vtkIdType blocks = static_cast<vtkIdType>(counts.size());
  counts.resize(overAllRanks({ blocks }, vtkCommunicator::MAX_OP, ranks)[0], 0);
  const std::vector<vtkIdType> least = overAllRanks(counts, vtkCommunicator::MIN_OP, ranks);
  const auto wrong = std::find(least.begin(), least.end(), -1);
  if (wrong != least.end())
  {
    throw InvalidInput("block ", wrong - least.begin(),
      " isn't a table of parts, with columns of one length and whole numbers in '", names::PartId,
      "': take the tables of vtkMedialPartDecomposition or vtkSimplifyShape");
  }
  const std::vector<vtkIdType> all = overAllRanks(counts, vtkCommunicator::SUM_OP, ranks);
  std::vector<vtkIdType> result(all.size(), 0);
  if (unique)
  {
    std::exclusive_scan(all.begin(), all.end(), result.begin(), vtkIdType(0));
  }
  return result;
}

void collectTables(vtkCompositeDataSet* tables, const std::vector<vtkIdType>& firstParts,
  vtkMultiProcessController* ranks, vtkTable* output)
{
  vtkNew<vtkMultiBlockDataSet> mine;
  unsigned int object = 0;
  for (auto block = firstBlock(tables); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    auto* table = vtkTable::SafeDownCast(block->GetCurrentDataObject());
    if (table && table->GetNumberOfRows() > 0)
    {
      mine->SetBlock(object, numberedRows(table, object, firstParts[object]));
    }
    ++object;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> ofRanks{ mine.Get() };
  if (ranks && ranks->GetNumberOfProcesses() > 1)
  {
    ofRanks.clear();
    ranks->Gather(mine, ofRanks, 0);
  }
  for (object = 0; object < firstParts.size(); ++object)
  {
    for (const auto& ofRank : ofRanks)
    {
      auto* rows =
        vtkTable::SafeDownCast(vtkMultiBlockDataSet::SafeDownCast(ofRank)->GetBlock(object));
      if (rows)
      {
        append(rows->GetRowData(), output->GetRowData());
      }
    }
  }
}

void renumberParts(
  vtkCompositeDataSet* parts, const std::vector<vtkIdType>& firstParts, vtkCompositeDataSet* output)
{
  if (!parts)
  {
    return;
  }
  output->CopyStructure(parts);
  std::size_t object = 0;
  for (auto block = firstBlock(parts); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    if (object == firstParts.size())
    {
      throw InvalidInput("there are more blocks of parts than tables: take both from one filter");
    }
    if (block->GetCurrentDataObject())
    {
      output->SetDataSet(block, renumberedCopy(block->GetCurrentDataObject(), firstParts[object]));
    }
    ++object;
  }
}
}
