// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Arrays.h"

#include "Base/Errors.h"
#include "Base/Lists.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{
/// Calls body(value) for the components of all tuples one after another.
template <typename Body>
void forValues(vtkDataArray* array, const Body& body)
{
  const auto walk = [&body](auto* values) {
    for (const auto value : vtk::DataArrayValueRange(values))
    {
      body(static_cast<double>(value));
    }
  };
  if (!vtkArrayDispatch::Dispatch::Execute(array, walk))
  {
    walk(array);
  }
}
}

Index toIndex(vtkIdType number, const char* things)
{
  if (number < 0 || number >= Largest)
  {
    throw InvalidInput(number, " ", things, ": at most ", Largest - 1, " can be used");
  }
  return static_cast<Index>(number);
}

void addTexts(vtkFieldData* data, const char* name, const std::vector<std::string>& texts)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  data->AddArray(array);
}

void addBetti(vtkFieldData* data, const char* name, const Betti& betti)
{
  data->AddArray(tuples<vtkIdTypeArray>(name, 3, std::array<Betti, 1>{ betti }));
}

template <typename... Pieces>
void Arrays::refuseValue(
  const char* name, vtkIdType place, double value, const Pieces&... allowed) const
{
  throw InvalidInput("the ", this->Kind, " array '", name, "' has the value ", value, " at ", place,
    "; only ", allowed..., " can be there: ", this->Remedy);
}

bool Arrays::has(const char* name) const
{
  return this->Data->GetAbstractArray(name) != nullptr;
}

void Arrays::checkCount(const char* name, vtkAbstractArray* array, vtkIdType count) const
{
  if (count != AnyCount && array->GetNumberOfTuples() != count)
  {
    throw InvalidInput("the ", this->Kind, " array '", name, "' has ", array->GetNumberOfTuples(),
      " entries instead of ", count, ": ", this->Remedy);
  }
}

void Arrays::checkLengths(vtkIdType count) const
{
  for (int i = 0; i < this->Data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = this->Data->GetAbstractArray(i);
    this->checkCount(array->GetName() ? array->GetName() : "", array, count);
  }
}

vtkDataArray* Arrays::find(const char* name, vtkIdType count, int components) const
{
  vtkAbstractArray* found = this->Data->GetAbstractArray(name);
  vtkDataArray* array = vtkDataArray::SafeDownCast(found);
  if (!array)
  {
    throw InvalidInput(found ? "no numbers in the " : "there is no ", this->Kind, " array '", name,
      "': ", this->Remedy);
  }
  if (array->GetNumberOfComponents() != components)
  {
    throw InvalidInput("the ", this->Kind, " array '", name, "' has ",
      array->GetNumberOfComponents(), " components instead of ", components, ": ", this->Remedy);
  }
  this->checkCount(name, array, count);
  return array;
}

Index Arrays::size(const char* name) const
{
  return toIndex(this->find(name, AnyCount, 1)->GetNumberOfTuples(), "entries");
}

std::vector<double> Arrays::reals(
  const char* name, vtkIdType count, double lowest, int components) const
{
  vtkDataArray* array = this->find(name, count, components);
  std::vector<double> result;
  result.reserve(array->GetNumberOfValues());
  forValues(array, [&](double value) {
    if (!std::isfinite(value) || value < lowest)
    {
      const auto place = static_cast<vtkIdType>(result.size()) / components;
      this->refuseValue(name, place, value, "finite numbers, not below ", lowest);
    }
    result.push_back(value);
  });
  return result;
}

void Arrays::checkWhole(const char* name, vtkDataArray* array) const
{
  if (array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT)
  {
    throw InvalidInput("the ", this->Kind, " array '", name, "' is of type ",
      array->GetDataTypeAsString(), " but must hold whole numbers: ", this->Remedy);
  }
}

std::vector<Index> Arrays::indices(
  const char* name, vtkIdType count, Index lowest, Index end, int components) const
{
  vtkDataArray* array = this->find(name, count, components);
  this->checkWhole(name, array);
  std::vector<Index> result;
  result.reserve(array->GetNumberOfValues());
  forValues(array, [&](double value) {
    if (value < lowest || value >= end)
    {
      const auto place = static_cast<vtkIdType>(result.size()) / components;
      this->refuseValue(name, place, value, "numbers ", lowest, " ... ", end - 1);
    }
    result.push_back(static_cast<Index>(value));
  });
  return result;
}

std::vector<char> Arrays::flags(const char* name, vtkIdType count) const
{
  const std::vector<Index> numbers = this->indices(name, count, 0, 2);
  return std::vector<char>(numbers.begin(), numbers.end());
}

Betti Arrays::betti(const char* name) const
{
  return this->indexTuples<3>(name, 1, 0, Largest).front();
}

std::vector<std::string> Arrays::texts(const char* name, vtkIdType count) const
{
  vtkAbstractArray* found = this->Data->GetAbstractArray(name);
  vtkStringArray* array = vtkStringArray::SafeDownCast(found);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw InvalidInput(found ? "no texts in the " : "there is no ", this->Kind, " array '", name,
      "': ", this->Remedy);
  }
  this->checkCount(name, array, count);
  std::vector<std::string> result;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    result.push_back(array->GetValue(i));
    if (result.back().empty())
    {
      throw InvalidInput(
        "the ", this->Kind, " array '", name, "' has no text at ", i, ": ", this->Remedy);
    }
  }
  return result;
}

void Arrays::checkAscending(const char* items, Index number, IndexLists::View list) const
{
  if (std::adjacent_find(list.begin(), list.end(), std::greater_equal<Index>()) != list.end())
  {
    throw InvalidInput("list ", number, " in the ", this->Kind, " array '", items,
      "' does not ascend: ", this->Remedy);
  }
}

IndexLists Arrays::lists(const char* offsets, const char* items, vtkIdType count, Index end) const
{
  IndexLists result;
  result.items = this->indices(items, AnyCount, 0, end);
  const Index size = toIndex(static_cast<vtkIdType>(result.items.size()), "list entries");
  result.offsets = this->indices(offsets, count + 1, 0, size + 1);
  if (result.offsets.front() != 0 || result.offsets.back() != size ||
    !std::is_sorted(result.offsets.begin(), result.offsets.end()))
  {
    throw InvalidInput("the ", this->Kind, " array '", offsets, "' does not ascend from 0 to ",
      size, ", the length of '", items, "': ", this->Remedy);
  }
  for (Index list = 0; list < result.size(); ++list)
  {
    this->checkAscending(items, list, result[list]);
  }
  return result;
}
}
