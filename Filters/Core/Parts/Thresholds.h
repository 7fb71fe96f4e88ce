// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Thresholds_h
#define medial_Thresholds_h

#include <vector>

namespace medial
{
/// What suggested thresholds remove at most, of the solid's volume.
constexpr double removableVolume = 0.1;

/// What a suggested threshold depends on: one part.
struct RankedPart
{
  double significance; ///< under any measure
  double volume;       ///< relative to the solid's
};

/// The threshold at which significant parts stand out (paper 7 asks for one).
///
/// The parts are sorted by significance. Between two parts that follow each other there is a gap, as
/// the ratio of their significances. The threshold is in the middle of the widest gap, on a logarithmic
/// scale, of those that a threshold may be in: below it are at least half of the parts, but not all,
/// and together at most the given volume. Example: values 1, 2, 2, 3, 40, 50 give 11, between 3 and 40.
///
/// Only ratios count, so the unit doesn't matter. Cost: n log n.
/// @param parts  that can be removed, those of level 1, in any order
/// @return  0 where no cut qualifies: the significances don't tell
double suggestedThreshold(std::vector<RankedPart> parts, double volume = removableVolume);
}

#endif
