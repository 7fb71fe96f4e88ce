// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Axis_h
#define Conversion_Axis_h

#include "Axis/MedialAxis.h"

#include <vector>

class vtkFieldData;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace medial
{
/// @param balls  what the axis is made from; see passFieldData
void write(const MedialAxis& axis, vtkUnstructuredGrid* balls, vtkPolyData* output);
MedialAxis readMedialAxis(vtkPolyData* input);

/// Adds the field data that changes with the cells of the axis.
void addTopology(vtkFieldData* field, const MedialAxis& axis);

/// Was the axis made from these balls? Then it has a copy of their volumes, and its points are centres
/// of balls.
bool isMadeFrom(vtkPolyData* axis, vtkUnstructuredGrid* balls);

/// @throw InvalidInput  `axis` was made from other balls
void checkSameBalls(vtkPolyData* axis, vtkUnstructuredGrid* balls);
}

#endif
