// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Crust_h
#define Conversion_Crust_h

#include "Crust/PowerCrust.h"

#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace medial
{
/// @param partOfBall  empty: no ball has a part
/// @param ranks       of the parts
/// @param balls       what the crust is made from; see passFieldData
void write(const Crust& crust, const std::vector<Index>& partOfBall,
  const std::vector<Index>& ranks, vtkUnstructuredGrid* balls, vtkPolyData* output);
}

#endif
