// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_DistinctSamples_h
#define medial_DistinctSamples_h

#include "Base/Frame.h"
#include "Base/Types.h"
#include "Base/Warnings.h"

#include <array>
#include <vector>

namespace medial
{
/// Which samples count as one.
struct MergeOptions
{
  /// Samples within this distance of each other that stand apart from all others are one, see
  /// NearDuplicates.h; in the unit of the samples. 0: only those at the very same place. Negative:
  /// defaultTolerance, and clusters that are far smaller than their distance to all others.
  double tolerance = -1;
  double unit = 0; ///< to which the samples' coordinates were rounded; 0: not known
  bool clusters =
    true; ///< false: clusters stay, as of samples of a known surface, which may be those of a grain
};

/// The samples without repeats, in the frame that all stages compute in. They are in lexicographic
/// order, so that results do not depend on the order of the input.
struct DistinctSamples
{
  Frame frame;
  std::vector<Point> points;      ///< in the frame
  std::vector<Index> ids;         ///< for each point the lowest sample of the input at its place
  std::vector<Index> duplicateOf; ///< for each sample of the input: the one in `ids` that it counts
                                  ///< as, or None where it is this one
  Index nearDuplicates = 0; ///< how many samples are not at the place of the one they count as
  double precision = 0;     ///< how far samples may be from where they were meant to be, because
                            ///< of rounding; in their unit; at most the tolerance
  double tolerance =
    0; ///< that was used, in the unit of the samples; or the distance of the farthest
       ///< of them, if it is more
};

/// @throw InvalidInput  no samples, a coordinate that is not finite, all in one place; a tolerance or a
///                      unit that is not a finite number
DistinctSamples distinctSamples(
  const std::vector<Point>& samples, const MergeOptions& options = {});

/// The warning "merged_duplicates" where more than one in a hundred samples counts as another one that is
/// near. Samples at the very same place are no reason: triangles without shared corners have them.
Warnings mergeWarnings(const std::vector<Point>& samples, const DistinctSamples& distinct);

/// @param samples   those that the distinct ones were made of
/// @throw InvalidInput  there are fewer than four distinct samples, or all are on a line or in a
///                      plane, up to the rounding of their coordinates; the message tells where it is so
///                      only because near duplicates count as one
void requireVolume(const std::vector<Point>& samples, const DistinctSamples& distinct);

/// The guards: the corners of a cube about the points, in their unit. Half a side is 2.5 times the
/// diagonal of their bounding box.
///
/// The Voronoi cell of a sample on the convex hull is unbounded. The guards bound it, so that every
/// sample has an outer pole.
std::array<Point, 8> guards(const std::vector<Point>& points);
}

#endif
