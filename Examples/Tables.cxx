// SPDX-License-Identifier: BSD-3-Clause
#include "Tables.h"

#include "Errors.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkTable.h>

#include <limits>
#include <sstream>

namespace
{
void writeHeader(std::ostream& out, vtkTable* table)
{
  const char* separator = "";
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = table->GetColumn(i);
    const int components = column->GetNumberOfComponents();
    for (int k = 0; k < components; ++k)
    {
      out << separator << column->GetName();
      if (components > 1)
      {
        out << ':' << k;
      }
      separator = ",";
    }
  }
  out << '\n';
}

/// Texts are words of schedules, without commas and quotes.
void writeRow(std::ostream& out, vtkTable* table, vtkIdType row)
{
  const char* separator = "";
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = table->GetColumn(i);
    auto* numbers = vtkDataArray::SafeDownCast(column);
    for (int k = 0; k < column->GetNumberOfComponents(); ++k)
    {
      out << separator;
      separator = ",";
      if (numbers)
      {
        out << numbers->GetComponent(row, k);
      }
      else
      {
        out << column->GetVariantValue(row).ToString();
      }
    }
  }
  out << '\n';
}
}

std::string csv(vtkTable* table)
{
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  writeHeader(out, table);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    writeRow(out, table, row);
  }
  return out.str();
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
