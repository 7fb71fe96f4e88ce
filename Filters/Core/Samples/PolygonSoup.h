// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PolygonSoup_h
#define medial_PolygonSoup_h

#include "Base/Lists.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Distinct points and distinct triangles, not oriented.
struct PolygonSoup
{
  std::vector<Point> points;
  std::vector<Triangle> triangles; ///< with three different corners
  std::vector<Index> polygons;     ///< for each triangle the polygon that it is of
  Index mergedPoints = 0;          ///< points of the input that count as another one
  Index droppedPolygons = 0;       ///< polygons and triangles that are left out
};

/// Which points are one.
enum class Weld
{
  SamePlace, ///< those at the very same place
  Rounding   ///< those, too, that differ by rounding only, see NearDuplicates.h
};

/// The triangles of polygons. Polygons without three different corners and repeated triangles are dropped.
/// @param polygons  the corners of each in order around it; they need be neither flat nor convex
PolygonSoup polygonSoup(
  const std::vector<Point>& points, const IndexLists& polygons, Weld weld = Weld::SamePlace);

/// Drops triangles that enclose nothing: patches with a free border that hang on edges of two others.
/// Those of a T vertex are flat, and so are hardly seen.
void dropHangingPatches(PolygonSoup& soup);
}

#endif
