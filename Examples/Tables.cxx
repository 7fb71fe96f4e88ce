// SPDX-License-Identifier: BSD-3-Clause
#include "Tables.h"

#include "Errors.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkTable.h>

#include <limits>
#include <sstream>
#include <vector>

namespace
{
std::vector<vtkDataArray*> numberColumns(vtkTable* table)
{
  std::vector<vtkDataArray*> columns;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    if (auto* column = vtkDataArray::SafeDownCast(table->GetColumn(i)))
    {
      columns.push_back(column);
    }
  }
  return columns;
}

void writeHeader(std::ostream& out, const std::vector<vtkDataArray*>& columns)
{
  const char* separator = "";
  for (vtkDataArray* column : columns)
  {
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

void writeRow(std::ostream& out, const std::vector<vtkDataArray*>& columns, vtkIdType row)
{
  const char* separator = "";
  for (vtkDataArray* column : columns)
  {
    for (int k = 0; k < column->GetNumberOfComponents(); ++k)
    {
      out << separator << column->GetComponent(row, k);
      separator = ",";
    }
  }
  out << '\n';
}
}

std::string csv(vtkTable* table)
{
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  const std::vector<vtkDataArray*> columns = numberColumns(table);
  writeHeader(out, columns);
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    writeRow(out, columns, row);
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
