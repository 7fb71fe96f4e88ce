// SPDX-License-Identifier: BSD-3-Clause
#ifndef Floor_h
#define Floor_h

#include "Base/Types.h"

#include <vector>

/// What CGAL takes alone, without any code of ours: the measure of all times.
namespace floors
{
/// @return  how many cells it has
std::size_t delaunay(const std::vector<medial::Point>& points);

/// Weights are squared radii. @return  how many cells it has
std::size_t regular(const std::vector<medial::Ball>& balls);
}

#endif
