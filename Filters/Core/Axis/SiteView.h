// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SiteView_h
#define medial_SiteView_h

#include "Base/Types.h"

#include <vector>

namespace medial
{
/// How a cell of the axis sees its sites, the points of the boundary that it is equally far from: two
/// for a triangle, three for a line.
struct SiteView
{
  double
    objectAngle; ///< largest angle between two of them from the cell's centroid, 0 ... 180 degrees
  double lambda; ///< largest distance of two of them ([CL05]), unit of the samples
};

/// @param from   the cell's centroid
/// @param sites  at least two
SiteView siteView(const Point& from, const std::vector<Point>& sites);

/// The same where the sites aren't known, from the cell's corners: 1, 2 or 3 maximal balls. The sites
/// are then where the spheres of all corners meet: two points for three balls, a circle for two, the
/// whole sphere for one. The two of these that are farthest apart count. 0 where the spheres don't meet.
SiteView siteView(const std::vector<Ball>& corners);
}

#endif
