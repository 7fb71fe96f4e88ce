// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_RodLabels_h
#define medial_RodLabels_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Execution.h"

#include <vector>

namespace medial
{
/// A point, and what the points nearest to it belong to.
struct LabelSeed
{
  Index point;
  Index label;
};

/// For each point the label of the seed that is nearest along the edges, of several the lowest label;
/// None where no way leads to one. Takes O(n log n) time.
/// @param open  for each edge: does a way lead along it?
std::vector<Index> nearestLabels(const MedialAxis& axis, const AxisEdges& edges,
  const std::vector<char>& open, const std::vector<LabelSeed>& seeds,
  const Execution& execution = {});
}

#endif
