// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_PlatesAndRods_h
#define Conversion_PlatesAndRods_h

#include "Measuring/PlatesAndRods.h"

class vtkPolyData;
class vtkTable;

namespace medial
{
/// The axis with widths and elements, and the table of elements.
void write(const PlatesAndRods& found, vtkPolyData* axis, vtkPolyData* output, vtkTable* table);

/// The surface, each triangle with the element of the point of the axis that its inner ball follows.
/// @throw InvalidInput  the surface's inner balls are missing, or not those of the axis
void write(
  const PlatesAndRods& found, const MedialAxis& axis, vtkPolyData* surface, vtkPolyData* output);
}

#endif
