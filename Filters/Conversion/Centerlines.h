// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Centerlines_h
#define Conversion_Centerlines_h

#include "Measuring/Centerlines.h"

class vtkPolyData;

namespace medial
{
/// A polyline for each branch, and its nodes as vertices. Point i of the polylines is node i, the others
/// follow.
/// @param axis  its field data is passed on, but not that of its balls
void write(const Centerlines& lines, vtkPolyData* axis, vtkPolyData* output, vtkPolyData* nodes);
}

#endif
