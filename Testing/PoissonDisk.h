// SPDX-License-Identifier: BSD-3-Clause
#ifndef PoissonDisk_h
#define PoissonDisk_h

#include "Numbers.h"
#include "Shapes.h"

#include <functional>
#include <vector>

/// Samples of a surface that are evenly spread.
namespace shapes
{
/// A random point of a surface.
using Draw = std::function<Point(Random&)>;

/// Poisson-disk samples: dart throwing until many throws in a row found no room. `fixed` are samples
/// to begin with.
std::vector<Point> poissonDisk(
  const Draw& draw, double spacing, unsigned seed, const std::vector<Point>& fixed = {});
}

#endif
