// SPDX-License-Identifier: BSD-3-Clause
#ifndef AxisChecks_h
#define AxisChecks_h

#include "Axis/MedialAxis.h"

namespace medial
{
/// What the stages after vtkMedialAxis rely on, beside lengths and ranges of arrays: the list is in
/// README.md. Takes time linear in the number of cells and balls.
/// @throw InvalidInput  it isn't so; the message names array, element and remedy
void checkAxis(const MedialAxis& axis);
}

#endif
