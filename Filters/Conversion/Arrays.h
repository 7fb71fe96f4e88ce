// SPDX-License-Identifier: BSD-3-Clause
#ifndef Arrays_h
#define Arrays_h

#include "Base/Lists.h"
#include "Base/Types.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

/// VTK arrays from values, and values from VTK arrays that nobody can trust.
namespace medial
{
/// No Index is so large.
constexpr Index Largest = std::numeric_limits<Index>::max();

/// For an array of any length.
constexpr vtkIdType AnyCount = -1;

/// @throw InvalidInput  a negative or too large number of `things`
Index toIndex(vtkIdType number, const char* things);

struct Itself
{
  template <typename Value>
  const Value& operator()(const Value& value) const
  {
    return value;
  }
};

/// An array of tuples; field(value) is what becomes one and can be indexed by component.
template <typename Array, typename Values, typename Field = Itself>
vtkSmartPointer<Array> tuples(
  const char* name, int components, const Values& values, Field field = {})
{
  using Number = typename Array::ValueType;
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  vtkIdType next = 0;
  for (const auto& value : values)
  {
    const auto& tuple = field(value);
    for (int component = 0; component < components; ++component)
    {
      array->SetValue(next++, static_cast<Number>(tuple[component]));
    }
  }
  return array;
}

/// Adds an array with one number, field(value), for each value.
template <typename Array, typename Values, typename Field = Itself>
void add(vtkFieldData* data, const char* name, const Values& values, Field field = {})
{
  const auto number = [&](const auto& value) { return std::array{ std::invoke(field, value) }; };
  data->AddArray(tuples<Array>(name, 1, values, number));
}

template <typename Array, typename Value>
void addOne(vtkFieldData* data, const char* name, Value value)
{
  add<Array>(data, name, std::array{ value });
}

void addTexts(vtkFieldData* data, const char* name, const std::vector<std::string>& texts);
void addBetti(vtkFieldData* data, const char* name, const Betti& betti);

/// The arrays of one kind of an input, read with every value checked: InvalidInput tells array,
/// fault and remedy.
class Arrays
{
public:
  /// @param kind    point, cell or field
  /// @param remedy  what to do where an array does not fit
  Arrays(vtkFieldData* data, const char* kind, const char* remedy)
    : Data(data)
    , Kind(kind)
    , Remedy(remedy)
  {
  }

  bool has(const char* name) const;

  /// @throw InvalidInput  an array, needed or not, has another number of entries: VTK relies on it when
  ///                      arrays are passed on
  void checkLengths(vtkIdType count) const;

  /// How many numbers an array has.
  Index size(const char* name) const;

  /// Finite numbers >= lowest, the components of all tuples one after another.
  std::vector<double> reals(const char* name, vtkIdType count,
    double lowest = std::numeric_limits<double>::lowest(), int components = 1) const;

  /// Whole numbers lowest ... end - 1, the components of all tuples one after another.
  std::vector<Index> indices(
    const char* name, vtkIdType count, Index lowest, Index end, int components = 1) const;

  /// The same, a tuple to an entry.
  template <std::size_t Size>
  std::vector<std::array<Index, Size>> indexTuples(
    const char* name, vtkIdType count, Index lowest, Index end) const
  {
    const std::vector<Index> flat = this->indices(name, count, lowest, end, static_cast<int>(Size));
    std::vector<std::array<Index, Size>> result(flat.size() / Size);
    for (std::size_t i = 0; i < flat.size(); ++i)
    {
      result[i / Size][i % Size] = flat[i];
    }
    return result;
  }

  /// Numbers 0 or 1.
  std::vector<char> flags(const char* name, vtkIdType count) const;

  bool flag(const char* name) const { return this->flags(name, 1).front() != 0; }

  Betti betti(const char* name) const;

  /// Texts that are not empty.
  std::vector<std::string> texts(const char* name, vtkIdType count) const;

  /// Lists of strictly ascending numbers 0 ... end - 1.
  IndexLists lists(const char* offsets, const char* items, vtkIdType count, Index end) const;

private:
  void checkCount(const char* name, vtkAbstractArray* array, vtkIdType count) const;
  vtkDataArray* find(const char* name, vtkIdType count, int components) const;
  void checkWhole(const char* name, vtkDataArray* array) const;
  void checkAscending(const char* items, Index number, IndexLists::View list) const;
  template <typename... Pieces>
  [[noreturn]] void refuseValue(
    const char* name, vtkIdType place, double value, const Pieces&... allowed) const;

  vtkFieldData* Data;
  const char* Kind;
  const char* Remedy;
};
}

#endif
