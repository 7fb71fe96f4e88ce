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
/// Nodes where three lines or more meet become one where they are so near to each other that there is
/// no rod between: those with the largest balls first take in each such neighbour to which a line runs
/// within their ball, and this line goes. Pieces and loops stay, because a line goes only between two
/// nodes that were not one.
///
/// Takes O(n log n).
std::vector<CurveBranch> curveBranches(const MedialAxis& axis, const std::vector<Edge>& edges);
}

#endif
