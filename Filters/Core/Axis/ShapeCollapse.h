// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ShapeCollapse_h
#define medial_ShapeCollapse_h

#include "Axis/AxisComplex.h"
#include "Balls/PolarBalls.h"
#include "Base/Execution.h"

namespace medial
{
/// The power shape collapsed to sheets and curves (GuidedCollapse.h), without slivers (Trimming.h). The
/// topology is the power shape's, by construction. All points are poles, and nearly all poles are points.
AxisComplex collapsedShape(const PolarBalls& polarBalls, const Execution& execution = {});
}

#endif
