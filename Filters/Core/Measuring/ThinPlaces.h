// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ThinPlaces_h
#define medial_ThinPlaces_h

#include "Axis/AxisComplex.h"
#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/Types.h"
#include "Measuring/SampleWalls.h"

#include <vector>

namespace medial
{
/// A place where a wall or a strut is thinner than around it.
struct ThinPlace
{
  Index point;      ///< of the axis
  double thickness; ///< there, unit of the samples
  double
    depth; ///< by what share of it the thickness rises on each way to a thinner place; infinite where there is none
};

/// How thick a solid is at the points of its axis.
struct AxisThickness
{
  std::vector<double> ofPoint; ///< twice the wall distance of its ball

  /// Is the point between walls that hold its ball from opposite sides, and are there enough samples to tell? Of two walls
  /// the normals differ by 150 degrees and more; and the thickness is at least 2.5 local spacings, mean distances from the six nearest
  /// samples. At an edge, where every solid is as thin as one likes, neither is true.
  std::vector<char> isWall;
};

/// @param walls      sampleWalls() of the balls that the axis was made from
/// @param distances  wallDistances() of the balls
AxisThickness axisThickness(const AxisComplex& axis, const PolarBalls& balls,
  const std::vector<SampleWall>& walls, const std::vector<double>& distances,
  const Execution& execution = {});

/// Where walls and struts are thinnest: the minima of thickness on the axis that persist [ELZ02], the thinnest first; of
/// equal ones the point of the lowest number. Takes O(n log n).
///
/// Points count from which the way down ends at a wall, or that are at one: so those between an edge and a wall don't.
/// @param depth  the least that counts: less is noise of the samples; 0 or more
/// @throw InvalidInput  a negative depth
std::vector<ThinPlace> thinPlaces(
  const AxisComplex& axis, const AxisThickness& thickness, double depth = 0.1);
}

#endif
