// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_DistinctSamples_h
#define medial_DistinctSamples_h

#include "Base/Frame.h"
#include "Base/Types.h"

#include <array>
#include <vector>

namespace medial
{
/// The samples without repeats, in the frame that all stages compute in. They are in lexicographic
/// order, so that results do not depend on the order of the input.
struct DistinctSamples
{
  Frame frame;
  std::vector<Point> points;      ///< in the frame
  std::vector<Index> ids;         ///< for each point the lowest sample of the input that it is
  std::vector<Index> duplicateOf; ///< for each sample of the input: the lowest one at the very same
                                  ///< place, or None where it is this one
};

DistinctSamples distinctSamples(const std::vector<Point>& samples);

/// @throw InvalidInput  there are fewer than four distinct samples, or all are on a line or in a
///                      plane, up to the rounding of their coordinates
void requireVolume(const DistinctSamples& distinct);

/// The guards: the corners of a cube about the points, in their unit. Half a side is 2.5 times the
/// diagonal of their bounding box.
///
/// The Voronoi cell of a sample on the convex hull is unbounded. The guards bound it, so that every
/// sample has an outer pole.
std::array<Point, 8> guards(const std::vector<Point>& points);
}

#endif
