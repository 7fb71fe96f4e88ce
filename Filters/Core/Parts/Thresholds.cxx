// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/Thresholds.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace medial
{
double suggestedThreshold(std::vector<RankedPart> parts, double volume)
{
  std::sort(parts.begin(), parts.end(), [](const RankedPart& a, const RankedPart& b) {
    return std::tie(a.significance, a.volume) < std::tie(b.significance, b.volume);
  });
  double removed = 0, widest = 1, threshold = 0;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i)
  {
    removed += parts[i].volume;
    const double below = parts[i].significance, above = parts[i + 1].significance;
    const bool isHalf = 2 * (i + 1) >= parts.size();
    if (isHalf && removed <= volume && below > 0 && above / below > widest)
    {
      widest = above / below;
      threshold = below * std::sqrt(widest);
    }
  }
  return threshold;
}
}
