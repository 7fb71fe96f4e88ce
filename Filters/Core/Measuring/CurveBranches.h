// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CurveBranches_h
#define medial_CurveBranches_h

#include "Axis/MedialAxis.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// A line of a graph on the points of an axis, from a node to a node.
struct CurveBranch
{
  std::vector<Index> points; ///< two or more, in order; the first is the last one of a loop
  Edge nodes; ///< the points that stand for its ends; None twice for a loop without a node
};

/// The lines of a graph between its nodes, which are the points with another number of edges than
/// two. By lowest node, then loops without nodes by lowest point.
///
/// A fork, where three lines or more meet, reaches as far as half the width of the sheet there (burn
/// time) + a radius. Forks become one where a line between them stays that near to one of them, so that
/// their balls meet. Those that reach farthest first take in such neighbours; the lines of these go on
/// along the one between. A line to a free end goes if it stays that near. Pieces and loops stay,
/// because only lines between two nodes that were not one are contracted.
///
/// Takes O(n log n).
/// @param times  burnTimes() of the axis
std::vector<CurveBranch> curveBranches(
  const MedialAxis& axis, const std::vector<double>& times, std::vector<Edge> edges);
}

#endif
