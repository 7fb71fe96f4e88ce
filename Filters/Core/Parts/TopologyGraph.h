// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_TopologyGraph_h
#define medial_TopologyGraph_h

#include "Base/Lists.h"
#include "Base/Types.h"
#include "Parts/ContactCurves.h"

#include <vector>

namespace medial
{
/// Which parts are connected, and where (paper 4.3, Figures 7 to 9). Its nodes are groups of contact
/// curves that share points. Its edges are the parts; each joins the nodes that it touches, which may be
/// none, one, two or more.
struct TopologyGraph
{
  std::vector<Index> nodeOfContact; ///< None where fewer than two parts are left
  IndexLists partsOfNode;           ///< ascending
  IndexLists nodesOfPart;           ///< ascending

  /// On a closed walk that uses no node and no part twice?
  std::vector<char> nodeOnLoop, partOnLoop;

  std::vector<Point> nodeCentroids; ///< the mean of the points of each node's contacts
};

/// The graph without the parts that are gone; without centroids.
/// @param contacts  of the parts
/// @param gone      for each part: leave it out?
TopologyGraph topologyGraph(
  const std::vector<ContactCurve>& contacts, const std::vector<char>& gone);

/// The graph of all parts, with centroids.
/// @param points  of the axis
TopologyGraph topologyGraph(
  const std::vector<ContactCurve>& contacts, Index partCount, const std::vector<Point>& points);
}

#endif
