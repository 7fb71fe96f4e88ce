// SPDX-License-Identifier: BSD-3-Clause
#ifndef Tables_h
#define Tables_h

#include <string>

class vtkTable;

/// A table of numbers as comma separated values with a header line. Columns of several components
/// are named as VTK does, Bounds:0, Bounds:1, ...; numbers are written so that they read back alike.
std::string csv(vtkTable* table);

#endif
