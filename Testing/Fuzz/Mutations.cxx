// SPDX-License-Identifier: BSD-3-Clause
#include "Mutations.h"

#include "CellMutations.h"

#include <vtkAbstractArray.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fuzz
{
namespace
{
/// An array of a data set, and where it belongs.
struct Chosen
{
  vtkFieldData* data;
  vtkDataArray* array;
  int kind; ///< point, cell, field
};

Chosen chosenArray(vtkPointSet* data, Random& random)
{
  std::vector<Chosen> all;
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::FIELD })
  {
    vtkFieldData* attributes = data->GetAttributesAsFieldData(kind);
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      if (attributes->GetArray(i) && attributes->GetArray(i)->GetName())
      {
        all.push_back({ attributes, attributes->GetArray(i), kind });
      }
    }
  }
  return all.empty() ? Chosen{ nullptr, nullptr, 0 } : random.oneOf(all);
}

/// A value that an array might have: special, of another thing, or near its own.
double otherValue(vtkDataArray* array, vtkIdType place, int component, Random& random)
{
  const double own = array->GetComponent(place, component);
  const auto entries = static_cast<double>(array->GetNumberOfTuples());
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> values = { -1, 0, 1, 2, -2, 255, entries, entries - 1, entries + 1,
    own + 1, own - 1, own * (1 + 1e-9), own * 1.01, 0.5 * own, 2 * own, -own, 1e-300, 1e10, 1e60,
    1e150, 1e300, -1e300, 2147483647., 2147483648., 9e18, std::nan(""), infinity, -infinity,
    array->GetComponent(random.below(array->GetNumberOfTuples()), component) };
  return random.oneOf(values);
}

/// Whether a double can be stored in an array of this type, where C++ defines it.
bool fits(double value, vtkDataArray* array)
{
  return array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT ||
    (value >= array->GetDataTypeMin() && value <= array->GetDataTypeMax() &&
      std::abs(value) < 9.2e18);
}

std::string changeValues(const Chosen& chosen, Random& random)
{
  vtkDataArray* array = chosen.array;
  const vtkIdType count = array->GetNumberOfTuples();
  const bool isOne = !random.isTime(8);
  const int component = static_cast<int>(random.below(array->GetNumberOfComponents()));
  const vtkIdType place = random.below(count);
  if (count == 0)
  {
    return "nothing";
  }
  const double value = otherValue(array, place, component, random);
  if (!fits(value, array))
  {
    return "nothing";
  }
  if (isOne)
  {
    array->SetComponent(place, component, value);
    return "value " + std::to_string(place) + " becomes " + std::to_string(value);
  }
  array->FillComponent(component, value);
  return "all values become " + std::to_string(value);
}

std::string moveValues(const Chosen& chosen, Random& random)
{
  vtkDataArray* array = chosen.array;
  const vtkIdType count = array->GetNumberOfTuples();
  if (count == 0)
  {
    return "nothing";
  }
  const auto swap = [array](vtkIdType a, vtkIdType b) {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const double kept = array->GetComponent(a, c);
      array->SetComponent(a, c, array->GetComponent(b, c));
      array->SetComponent(b, c, kept);
    }
  };
  const bool isAll = random.isTime(3);
  for (vtkIdType i = 0; i < (isAll ? count : 1); ++i)
  {
    swap(isAll ? i : random.below(count), random.below(count));
  }
  return isAll ? "values are shuffled" : "two values are swapped";
}

std::string changeLength(const Chosen& chosen, Random& random)
{
  const vtkIdType count = chosen.array->GetNumberOfTuples();
  const vtkIdType shorter = std::max<vtkIdType>(count - 1, 0);
  const vtkIdType lengths[] = { 0, 1, shorter, count + 1, count / 2, 2 * count };
  const vtkIdType length = lengths[random.below(6)];
  chosen.array->Resize(length);
  chosen.array->SetNumberOfTuples(length);
  for (vtkIdType i = count * chosen.array->GetNumberOfComponents();
       i < chosen.array->GetNumberOfValues(); ++i)
  {
    chosen.array->SetVariantValue(i, 0); // memory that nobody has written could be anything
  }
  return "length becomes " + std::to_string(length);
}

std::string changeType(const Chosen& chosen, Random& random)
{
  const std::string name = chosen.array->GetName();
  const int types[] = { VTK_DOUBLE, VTK_FLOAT, VTK_INT, VTK_ID_TYPE, VTK_UNSIGNED_CHAR, VTK_SHORT,
    VTK_UNSIGNED_LONG, VTK_BIT, VTK_STRING };
  const int type = types[random.below(9)];
  vtkSmartPointer<vtkAbstractArray> made;
  made.TakeReference(vtkAbstractArray::CreateArray(type));
  made->SetName(name.c_str());
  made->SetNumberOfComponents(chosen.array->GetNumberOfComponents());
  made->SetNumberOfTuples(chosen.array->GetNumberOfTuples());
  auto* numbers = vtkDataArray::SafeDownCast(made);
  for (vtkIdType i = 0; numbers && i < chosen.array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < chosen.array->GetNumberOfComponents(); ++c)
    {
      const double value = chosen.array->GetComponent(i, c);
      numbers->SetComponent(i, c, fits(value, numbers) ? value : 0);
    }
  }
  chosen.data->AddArray(made);
  return "type becomes " + std::to_string(type);
}

std::string changeComponents(const Chosen& chosen, Random& random)
{
  const vtkIdType values = chosen.array->GetNumberOfValues();
  const int components = 1 + static_cast<int>(random.below(4));
  chosen.array->SetNumberOfComponents(components);
  chosen.array->SetNumberOfTuples(values / components);
  return "components become " + std::to_string(components);
}

std::string takeArray(const Chosen& chosen, vtkPointSet* other, Random& random)
{
  const std::string name = chosen.array->GetName();
  vtkSmartPointer<vtkAbstractArray> taken;
  const bool isOfOther = random.isTime(2);
  vtkAbstractArray* source = isOfOther
    ? other->GetAttributesAsFieldData(chosen.kind)->GetAbstractArray(name.c_str())
    : chosen.data->GetAbstractArray(
        static_cast<int>(random.below(chosen.data->GetNumberOfArrays())));
  if (!source)
  {
    return "nothing";
  }
  const std::string from = isOfOther ? "another object" : source->GetName();
  taken.TakeReference(source->NewInstance());
  taken->DeepCopy(source);
  taken->SetName(name.c_str());
  chosen.data->AddArray(taken);
  return "is taken from " + from;
}

std::string mutateArray(vtkPointSet* data, vtkPointSet* other, Random& random)
{
  const Chosen chosen = chosenArray(data, random);
  if (!chosen.array)
  {
    return "nothing";
  }
  const std::string name = std::string(chosen.array->GetName()) + ": ";
  switch (random.below(16))
  {
    case 0:
      chosen.data->RemoveArray(chosen.array->GetName());
      return name + "is removed";
    case 1:
      return name + changeLength(chosen, random);
    case 2:
      return name + changeType(chosen, random);
    case 3:
      return name + changeComponents(chosen, random);
    case 4:
    case 5:
      return name + takeArray(chosen, other, random);
    case 6:
    case 7:
      return name + moveValues(chosen, random);
  }
  return name + changeValues(chosen, random);
}

std::string mutatePoints(vtkPointSet* data, vtkPointSet* other, Random& random)
{
  vtkPoints* points = data->GetPoints();
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return "nothing";
  }
  const Chosen chosen{ data->GetPointData(), points->GetData(), vtkDataObject::POINT };
  switch (random.below(8))
  {
    case 0:
      return "points: " + moveValues(chosen, random);
    case 1:
      return "points: " + changeLength(chosen, random);
    case 2:
      data->SetPoints(random.isTime(2) ? nullptr : other->GetPoints());
      return "points are others";
    case 3:
    {
      vtkSmartPointer<vtkPoints> floats = vtkSmartPointer<vtkPoints>::New();
      floats->SetDataTypeToFloat();
      floats->DeepCopy(points);
      data->SetPoints(floats);
      return "points are rounded to floats";
    }
    case 4:
    {
      const std::vector<double> factors = { -1, 0, 2, 1e-30, 1e30, 1e80, 1e150 };
      const double factor = random.oneOf(factors);
      for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
      {
        double p[3];
        points->GetPoint(i, p);
        points->SetPoint(i, factor * p[0], factor * p[1], factor * p[2]);
      }
      return "points are scaled by " + std::to_string(factor);
    }
  }
  return "points: " + changeValues(chosen, random);
}
}

std::string mutate(vtkPointSet* data, vtkPointSet* other, Random& random)
{
  const long long what = random.below(10);
  const std::string result = what < 6 ? mutateArray(data, other, random)
    : what < 8                        ? mutatePoints(data, other, random)
                                      : mutateCells(data, random);
  data->Modified();
  return result;
}
}
