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

/// The singular points of the power shape. If three balls share a sample where their spheres meet, that
/// sample is the point. Any other point is known by its three balls. So two points are the same if their
/// ids are, never because their coordinates are near (paper 3, Figure 4).
SingularPoints singularPoints(
  const PolarBalls& polarBalls, const PowerShape& shape, const Execution& execution = {});
}

#endif
