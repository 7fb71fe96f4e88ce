// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ShapeCollapse_h
#define medial_ShapeCollapse_h

#include "Axis/AxisComplex.h"
#include "Balls/PolarBalls.h"
#include "Balls/PowerShape.h"

namespace medial
{
/// The power shape with every tetrahedron collapsed through a free triangle. The topology is
/// the power shape's, by construction. The sheets are rougher than the Voronoi faces.
AxisComplex collapsedShape(const PolarBalls& polarBalls, const PowerShape& shape);
}

#endif
