// SPDX-License-Identifier: BSD-3-Clause
#include "Collections/Objects.h"

#include "Base/Errors.h"
#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Axis.h"
#include "Conversion/Morphometry.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace medial
{
namespace
{
/// For each object its rank.
std::vector<int> ranksOf(const std::vector<vtkIdType>& sizes, int rankCount)
{
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&sizes](std::size_t a, std::size_t b) { return sizes[a] > sizes[b]; });
  std::vector<vtkIdType> loads(rankCount, 0);
  std::vector<int> result(sizes.size());
  for (const std::size_t object : order)
  {
    const auto least = std::min_element(loads.begin(), loads.end());
    result[object] = static_cast<int>(least - loads.begin());
    *least += sizes[object];
  }
  return result;
}
}

vtkSmartPointer<vtkCompositeDataIterator> firstBlock(vtkCompositeDataSet* data)
{
  auto block = vtkSmartPointer<vtkCompositeDataIterator>::Take(data->NewIterator());
  block->SkipEmptyNodesOff();
  block->InitTraversal();
  return block;
}

void shareOut(vtkCompositeDataSet* input, int rank, int rankCount, vtkCompositeDataSet* output)
{
  output->CopyStructure(input);
  std::vector<vtkIdType> sizes;
  for (auto block = firstBlock(input); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    vtkDataObject* data = block->GetCurrentDataObject();
    sizes.push_back(data ? data->GetNumberOfElements(vtkDataObject::POINT) : 0);
  }
  const std::vector<int> ranks = ranksOf(sizes, rankCount);
  vtkIdType object = 0;
  for (auto block = firstBlock(input); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    vtkDataObject* data = block->GetCurrentDataObject();
    if (data && ranks[object] == rank)
    {
      const auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
      copy->ShallowCopy(data);
      addOne<vtkIdTypeArray>(copy->GetFieldData(), names::ObjectId, object);
      output->SetDataSet(block, copy);
    }
    ++object;
  }
}

bool isSharedOut(vtkDataObject* data)
{
  return data && data->GetFieldData() && data->GetFieldData()->HasArray(names::ObjectId);
}

namespace
{
/// The data, or the first of its blocks for which isOwn(block).
/// @throw InvalidInput  there is no such block
template <typename IsOwn>
vtkPolyData* ownBlock(vtkDataObject* data, const IsOwn& isOwn, const char* message)
{
  auto* blocks = vtkCompositeDataSet::SafeDownCast(data);
  if (!blocks)
  {
    return vtkPolyData::SafeDownCast(data);
  }
  for (auto block = firstBlock(blocks); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    auto* candidate = vtkPolyData::SafeDownCast(block->GetCurrentDataObject());
    if (candidate && isOwn(candidate))
    {
      return candidate;
    }
  }
  throw InvalidInput(message);
}
}

vtkPolyData* axisOf(vtkUnstructuredGrid* balls, vtkDataObject* axes)
{
  return ownBlock(
    axes, [balls](vtkPolyData* axis) { return isMadeFrom(axis, balls); },
    "no block of the axis was made from these balls: take the blocks that vtkMedialAxis or "
    "vtkMedialPrune made from them");
}

vtkPolyData* surfaceOf(vtkUnstructuredGrid* balls, vtkDataObject* surfaces)
{
  return ownBlock(
    surfaces, [balls](vtkPolyData* surface) { return isSurfaceOf(balls, surface); },
    "no block of the surface was made from these balls: take the blocks that vtkPowerCrust or "
    "vtkSimplifyShape made from them");
}
}
