// SPDX-License-Identifier: BSD-3-Clause
#ifndef Tables_h
#define Tables_h

#include <string>

class vtkDataObject;
class vtkTable;

/// The columns of numbers as comma-separated values, names first. Column "A" with several components
/// becomes "A:0", "A:1" ...; numbers are written so that they are read back exactly.
std::string csv(vtkTable* table);

/// One number of an output's field data.
/// @throw InputError  there is no such array
double fieldValue(vtkDataObject* output, const char* array, int component = 0);

#endif
