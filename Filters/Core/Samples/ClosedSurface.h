// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ClosedSurface_h
#define medial_ClosedSurface_h

#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/SolidMeasures.h"
#include "Base/Types.h"
#include "Base/Warnings.h"

#include <string>
#include <vector>

namespace medial
{
/// What was done to polygons until they were a closed surface.
struct SurfaceRepairs
{
  Index mergedPoints = 0; ///< points that count as another one at their place
  Index droppedPolygons =
    0; ///< without three different corners, the same as another one, or that enclose
       ///< nothing at a T vertex
  Index filledHoles = 0;
  Index filledTriangles = 0; ///< in those
};

/// The closed surface of a solid, made of triangles.
struct ClosedSurface
{
  std::vector<Point> points;
  std::vector<Triangle> triangles; ///< counter-clockwise seen from outside
  std::vector<Index> polygons; ///< for each triangle the polygon that it is of; None: fills a hole
  SolidMeasures measures;      ///< Betti numbers and volume of the solid
  double area = 0;
  SurfaceRepairs repairs;
  Warnings warnings; ///< holes that were filled, triangles that intersect
};

/// The closed surface that polygons are meant to be: points at the same place are made one, polygons
/// without three different corners and repeated ones are dropped, all are oriented to enclose a
/// volume, borders are stitched, small holes are filled. Where that leaves holes, points that differ by
/// rounding only are made one first, see NearDuplicates.h.
///
/// Triangles may intersect a few others, as in folds of scanned surfaces; a warning tells where.
/// @param polygons  the corners of each in order around it; as they lie in a file
/// @throw InvalidInput  there is no polygon; a hole that is not small remains; triangles of separate
///                      pieces, or more than one in a hundred, intersect: says how many and where
/// @throw Aborted
ClosedSurface closedSurface(
  const std::vector<Point>& points, const IndexLists& polygons, const Execution& execution = {});

/// `not_a_solid`: the polygons of an input are not sampled, only its points are used.
/// @param reason  what closedSurface() said of them
Warning notASolid(const std::string& reason, Index polygonCount);
}

#endif
