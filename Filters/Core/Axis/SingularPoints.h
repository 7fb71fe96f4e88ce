// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SingularPoints_h
#define medial_SingularPoints_h

#include "Balls/PolarBalls.h"
#include "Balls/PowerShape.h"
#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The singular points ("sites"): where three inner polar balls meet on the boundary of their union, as
/// far as that is nearer (in power) to inner than to outer balls, each once (paper 2.1 step 2, 3); and
/// every sample that lies on an inner ball.
struct SingularPoints
{
  std::vector<Point> positions;
  std::vector<Index> samples; ///< the sample that the point is, or None
  IndexLists balls;           ///< the inner balls whose spheres pass through it, ascending
};

/// The singular points of the power shape. A point that is a sample is known by the sample's id, any
/// other by its three balls: identity never comes from coordinates (paper 3, Figure 4).
SingularPoints singularPoints(
  const PolarBalls& polarBalls, const PowerShape& shape, const Execution& execution = {});
}

#endif
