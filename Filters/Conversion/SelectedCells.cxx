// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/SelectedCells.h"

#include "Base/Errors.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkExtractSelection.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>

namespace medial
{
namespace
{
constexpr const char* ByIndices =
  "select cells or points by their indices instead; in ParaView, convert the selection to "
  "'Indices' in the panel of ExtractSelection or pick the parts in the view";

/// How many components the list of a selection has; 0: there is no such selection here.
int componentsOf(int contentType)
{
  switch (contentType)
  {
    case vtkSelectionNode::GLOBALIDS:
    case vtkSelectionNode::PEDIGREEIDS:
    case vtkSelectionNode::VALUES:
    case vtkSelectionNode::INDICES:
      return 1;
    case vtkSelectionNode::THRESHOLDS:
      return 2;
    case vtkSelectionNode::LOCATIONS:
      return 3;
    case vtkSelectionNode::FRUSTUM:
      return 4;
  }
  return 0;
}

/// Is there what the ids or values of the selection are compared with?
void requireArray(vtkSelectionNode* node, vtkDataArray* list, vtkDataSetAttributes* attributes)
{
  const int type = node->GetContentType();
  const bool byName = type == vtkSelectionNode::VALUES || type == vtkSelectionNode::THRESHOLDS;
  if (byName && (!list->GetName() || !attributes->HasArray(list->GetName())))
  {
    throw InvalidInput("the selection asks for values of the array '",
      list->GetName() ? list->GetName() : "", "', which the axis doesn't have: ", ByIndices);
  }
  if ((type == vtkSelectionNode::GLOBALIDS && !attributes->GetGlobalIds()) ||
    (type == vtkSelectionNode::PEDIGREEIDS && !attributes->GetPedigreeIds()))
  {
    throw InvalidInput("the selection asks for ids that the axis doesn't have: ", ByIndices);
  }
}

void requireUsable(vtkSelectionNode* node, vtkPolyData* axis)
{
  const int type = node->GetContentType(), components = componentsOf(type);
  if (components == 0)
  {
    const bool isKnown = type >= 0 && type < vtkSelectionNode::NUM_CONTENT_TYPES;
    throw InvalidInput("a selection of the type ",
      isKnown ? vtkSelectionNode::GetContentTypeAsString(type) : "unknown",
      " can't be used: ", ByIndices);
  }
  const int field = node->GetFieldType();
  if (field != vtkSelectionNode::CELL && field != vtkSelectionNode::POINT)
  {
    throw InvalidInput(
      "the selection is neither of cells nor of points: select cells or points of the axis");
  }
  auto* list = vtkDataArray::SafeDownCast(node->GetSelectionList());
  if (!list || list->GetNumberOfComponents() != components ||
    (type == vtkSelectionNode::FRUSTUM && list->GetNumberOfTuples() != 8))
  {
    throw InvalidInput("the list of the selection is missing or has another shape than its type ",
      vtkSelectionNode::GetContentTypeAsString(type), " needs: ", ByIndices);
  }
  requireArray(node, list,
    field == vtkSelectionNode::CELL ? static_cast<vtkDataSetAttributes*>(axis->GetCellData())
                                    : axis->GetPointData());
}

bool isOfAnotherBlock(vtkInformation* properties, vtkIdType block)
{
  vtkInformationIntegerKey* key = vtkSelectionNode::COMPOSITE_INDEX();
  return block != Alone && properties->Has(key) && properties->Get(key) != block;
}

/// The axis is one piece of its own; a point stands for its cells.
void adapt(vtkInformation* properties, bool isOfPoints)
{
  for (vtkInformationIntegerKey* key :
    { vtkSelectionNode::COMPOSITE_INDEX(), vtkSelectionNode::HIERARCHICAL_LEVEL(),
      vtkSelectionNode::HIERARCHICAL_INDEX(), vtkSelectionNode::PROCESS_ID() })
  {
    properties->Remove(key);
  }
  if (isOfPoints)
  {
    properties->Set(vtkSelectionNode::CONTAINING_CELLS(), 1);
  }
}
}

std::vector<vtkIdType> selectedCells(vtkSelection* selection, vtkPolyData* axis, vtkIdType block)
{
  if (!selection || selection->GetNumberOfNodes() == 0)
  {
    return {};
  }
  vtkNew<vtkSelection> adapted;
  adapted->DeepCopy(selection);
  for (unsigned int i = 0; i < adapted->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = adapted->GetNode(i);
    requireUsable(node, axis);
    if (isOfAnotherBlock(node->GetProperties(), block))
    {
      node->GetSelectionList()->Reset(); // it is part of the expression
    }
    adapt(node->GetProperties(), node->GetFieldType() == vtkSelectionNode::POINT);
  }
  vtkNew<vtkPolyData> cells;
  cells->ShallowCopy(axis);
  vtkNew<vtkExtractSelection> extraction;
  extraction->PreserveTopologyOn();
  extraction->SetInputData(0, cells);
  extraction->SetInputData(1, adapted);
  const bool isEvaluated = extraction->GetExecutive()->Update() != 0;
  auto* output = vtkPolyData::SafeDownCast(extraction->GetOutputDataObject(0));
  if (isEvaluated && output && output->GetNumberOfCells() == 0)
  {
    return {}; // how VTK since 9.3 says that no cell is selected
  }
  vtkDataArray* inside = output ? output->GetCellData()->GetArray("vtkInsidedness") : nullptr;
  if (!inside)
  {
    throw InvalidInput("the expression '", selection->GetExpression(),
      "' of the selection can't be evaluated: ", ByIndices);
  }
  std::vector<vtkIdType> result;
  for (vtkIdType cell = 0; cell < inside->GetNumberOfTuples(); ++cell)
  {
    if (inside->GetComponent(cell, 0) != 0)
    {
      result.push_back(cell);
    }
  }
  return result;
}

vtkIdType blockOf(vtkPolyData* axis, vtkCompositeDataSet* collection)
{
  if (!collection)
  {
    return Alone;
  }
  vtkSmartPointer<vtkCompositeDataIterator> blocks;
  blocks.TakeReference(collection->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
  {
    if (blocks->GetCurrentDataObject() == axis)
    {
      return blocks->GetCurrentFlatIndex();
    }
  }
  return Alone;
}
}
