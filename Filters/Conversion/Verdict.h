// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Verdict_h
#define Conversion_Verdict_h

#include "Crust/Verdict.h"

class vtkFieldData;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace medial
{
/// What the balls, and the axis that was made from them, tell of themselves and of the stages before. What
/// is to be found out on the cells, of the pruned axis and of the crust, is left open.
/// @param axis  null: there is none
/// @throw InvalidInput  an array is missing or does not fit
Findings readFindings(vtkUnstructuredGrid* balls, vtkPolyData* axis);

void write(const Verdict& verdict, vtkFieldData* field);
}

#endif
