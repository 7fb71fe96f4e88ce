// SPDX-License-Identifier: BSD-3-Clause
#ifndef Tables_h
#define Tables_h

#include <string>

class vtkDataObject;
class vtkTable;

/// The columns of numbers as comma-separated values, names first. Column "A" with several components
/// becomes "A:0", "A:1" ...; numbers are written so that they are read back exactly, and what is
/// not a number is an empty cell.
std::string csv(vtkTable* table);

/// A text as a cell of such a file: in quotes where it has commas, quotes or line ends.
std::string csvCell(const std::string& text);

/// One number of an output's field data.
/// @throw InputError  there is no such array
double fieldValue(vtkDataObject* output, const char* array, int component = 0);

#endif
