// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Thresholds_h
#define medial_Thresholds_h

#include <vector>

namespace medial
{
/// What suggested thresholds remove at most, of the solid's volume.
constexpr double removableVolume = 0.1;

/// What decides whether a part is below a suggested threshold.
struct RankedPart
{
  double significance; ///< under any measure
  double volume;       ///< relative to the solid's
};

/// The threshold at which significant parts stand out (paper 7 asks for one): in the middle of the
/// largest gap in log-significance, among the cuts that remove at least half of the parts, but not
/// all, and together at most the given volume.
///
/// Depends on the ratios of the significances alone, so not on units.
/// @param parts  that can be removed, those of level 1, in any order
/// @return  0 where no cut qualifies: the significances don't tell
double suggestedThreshold(std::vector<RankedPart> parts, double volume = removableVolume);
}

#endif
