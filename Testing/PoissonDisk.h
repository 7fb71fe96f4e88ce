// SPDX-License-Identifier: BSD-3-Clause
#ifndef PoissonDisk_h
#define PoissonDisk_h

#include "Shapes.h"

#include <functional>
#include <random>
#include <vector>

/// Random points, and samples of a surface that are evenly spread.
namespace shapes
{
using Random = std::mt19937;

/// A random point of a surface.
using Draw = std::function<Point(Random&)>;

double uniform(Random& random, double from, double to);

/// In the box about the origin with this corner.
Point uniformInBox(Random& random, const Point& corner);

/// Of length 1.
Point direction(Random& random);

/// Poisson-disk samples: dart throwing until many throws in a row found no room. `fixed` are samples
/// to begin with.
std::vector<Point> poissonDisk(
  const Draw& draw, double spacing, unsigned seed, const std::vector<Point>& fixed = {});
}

#endif
