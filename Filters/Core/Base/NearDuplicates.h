// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_NearDuplicates_h
#define medial_NearDuplicates_h

#include "Base/Types.h"

#include <vector>

namespace medial
{
/// For each point the one that it is a copy of, or None.
///
/// A point and those within the tolerance of it are copies of one place if they stand apart from all
/// others: none lies within ten times the tolerance. So points that are sampled more densely than that
/// stay as they are, and no chain of points becomes one. All points are never copies of one.
/// @param points     different ones; of copies the first one stays
/// @param tolerance  in their unit; 0: there are no copies
std::vector<Index> nearDuplicates(const std::vector<Point>& points, double tolerance);

/// The same for copies that differ by more than a known rounding, as those that went through other units or
/// through a motion: the points themselves tell.
///
/// A point and those nearest to it are copies of one place if the next one is at least 200 times as far
/// away as the farthest of them. Fifty points or more are never one place: they may be an object of its
/// own. All points are never copies of one.
/// @param points  different ones; of copies the first one stays
std::vector<Index> clusteredDuplicates(const std::vector<Point>& points);

/// The tolerance for points of which nothing else is known: two of its units for coordinates that were
/// rounded, as then two copies of a place differ by at most one unit in each coordinate; and at least
/// 1e-7 of the diagonal of their bounding box, a little less than floats of that size resolve.
/// @param unit  to which the coordinates were rounded, or 0; doubles are rounded anyway
double defaultTolerance(const std::vector<Point>& points, double unit);
}

#endif
