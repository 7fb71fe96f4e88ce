// SPDX-License-Identifier: BSD-3-Clause
#include "Tables.h"

#include "Errors.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkTable.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
void addHeader(std::string& text, vtkTable* table)
{
  const char* separator = "";
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = table->GetColumn(i);
    const int components = column->GetNumberOfComponents();
    for (int k = 0; k < components; ++k)
    {
      text += separator;
      text += column->GetName();
      if (components > 1)
      {
        text += ':' + std::to_string(k);
      }
      separator = ",";
    }
  }
  text += '\n';
}

void addNumber(std::string& text, double value)
{
  if (std::isnan(value))
  {
    return;
  }
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.begin(), digits.end(), value,
    std::chars_format::general, std::numeric_limits<double>::max_digits10);
  text.append(digits.begin(), end);
}

void addRow(std::string& text, const std::vector<vtkAbstractArray*>& columns, vtkIdType row)
{
  const char* separator = "";
  for (vtkAbstractArray* column : columns)
  {
    auto* numbers = vtkDataArray::SafeDownCast(column);
    for (int k = 0; k < column->GetNumberOfComponents(); ++k)
    {
      text += separator;
      separator = ",";
      if (numbers)
      {
        addNumber(text, numbers->GetComponent(row, k));
      }
      else
      {
        text += csvCell(column->GetVariantValue(row).ToString());
      }
    }
  }
  text += '\n';
}
}

std::string csv(vtkTable* table)
{
  std::string text;
  addHeader(text, table);
  std::vector<vtkAbstractArray*> columns;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    columns.push_back(table->GetColumn(i));
  }
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    addRow(text, columns, row);
  }
  return text;
}

std::string csvCell(const std::string& text)
{
  if (text.find_first_of(",\"\n\r") == std::string::npos)
  {
    return text;
  }
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' ? "\"\"" : std::string{ c };
  }
  return result + '"';
}

double fieldValue(vtkDataObject* output, const char* array, int component)
{
  vtkDataArray* values = output->GetFieldData()->GetArray(array);
  if (!values || values->GetNumberOfTuples() == 0)
  {
    throw InputError(std::string("a stage gave no array ") + array);
  }
  return values->GetComponent(0, component);
}
