// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_TopologyGraph_h
#define medial_TopologyGraph_h

#include "Axis/MedialAxis.h"
#include "Base/Lists.h"
#include "Base/Types.h"
#include "Parts/MedialParts.h"

#include <vector>

namespace medial
{
/// Which parts hang together where (paper 4.3, Figures 7 to 9). Its nodes are groups of contacts
/// connected through shared points. Its edges are the parts; each joins the nodes that it touches,
/// which may be none, one, two or more.
struct TopologyGraph
{
  std::vector<Index> nodeOfContact; ///< None where fewer than two parts are left
  IndexLists partsOfNode;           ///< ascending
  IndexLists nodesOfPart;           ///< ascending

  /// On a closed walk that uses no node and no part twice?
  std::vector<char> nodeOnLoop, partOnLoop;

  std::vector<Point> nodeCentroids; ///< the mean of the points of each node's contacts
};

TopologyGraph topologyGraph(const MedialAxis& axis, const MedialParts& parts);

/// The same without centroids, and without the parts that are gone.
/// @param contacts  MedialParts::contacts
/// @param gone      for each part: leave it out?
TopologyGraph topologyGraph(
  const std::vector<ContactCurve>& contacts, const std::vector<char>& gone);
}

#endif
