// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_AxisWarnings_h
#define medial_AxisWarnings_h

#include "Axis/MedialAxis.h"
#include "Base/Warnings.h"

namespace medial
{
/// What a user must know of an axis: `fallback`, if it is the collapsed power shape.
Warnings axisWarnings(const MedialAxis& axis);
}

#endif
