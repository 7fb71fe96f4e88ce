// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Centrelines_h
#define Conversion_Centrelines_h

#include "Measuring/Centrelines.h"

class vtkPolyData;

namespace medial
{
/// A polyline for each branch, and its nodes as vertices. Point i of the polylines is node i, the others
/// follow.
/// @param axis  its field data is passed on, but not that of its balls
void write(const Centrelines& lines, vtkPolyData* axis, vtkPolyData* output, vtkPolyData* nodes);
}

#endif
