// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/TopologyGraph.h"

#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <algorithm>
#include <array>
#include <utility>

namespace medial
{
namespace
{
using Pair = std::array<Index, 2>;

/// Joins contacts with a common point; numbers the groups by their first contact.
Index numberNodes(const std::vector<ContactCurve>& contacts, const std::vector<char>& isThere,
  std::vector<Index>& nodeOfContact)
{
  std::vector<Pair> uses; // point, contact
  for (Index c = 0; c < count(contacts); ++c)
  {
    for (const Index p : contacts[c].points)
    {
      if (isThere[c])
      {
        uses.push_back({ p, c });
      }
    }
  }
  std::sort(uses.begin(), uses.end());
  DisjointSets groups(count(contacts));
  for (std::size_t i = 1; i < uses.size(); ++i)
  {
    if (uses[i][0] == uses[i - 1][0])
    {
      groups.unite(uses[i][1], uses[i - 1][1]);
    }
  }
  Index nodes = 0;
  nodeOfContact.assign(contacts.size(), None);
  for (Index c = 0; c < count(contacts); ++c)
  {
    const Index first = groups.find(c);
    if (isThere[c])
    {
      nodeOfContact[c] = first == c ? nodes++ : nodeOfContact[first];
    }
  }
  return nodes;
}

/// The second of each pair in lists by the first, ascending, without repeats.
IndexLists listed(std::vector<Pair> pairs, Index size)
{
  sortUnique(pairs);
  return listsByKey(size, [&pairs](const auto& add) {
    for (const auto& [first, second] : pairs)
    {
      add(first, second);
    }
  });
}

/// Nodes and parts of a graph as the vertices of one, in the order of a walk by increasing distance
/// from the first of each piece.
struct Walk
{
  std::vector<Index> order;  ///< nodes, then parts numbered on
  std::vector<Index> place;  ///< of each in the order
  std::vector<Index> parent; ///< places; itself for the first
};

template <typename Neighbors>
Walk breadthFirst(Index size, const Neighbors& neighbors)
{
  Walk walk;
  walk.place.assign(size, None);
  for (Index start = 0; start < size; ++start)
  {
    if (walk.place[start] != None)
    {
      continue;
    }
    walk.place[start] = count(walk.order);
    walk.parent.push_back(walk.place[start]);
    walk.order.push_back(start);
    for (Index i = walk.place[start]; i < count(walk.order); ++i)
    {
      neighbors(walk.order[i], [&](Index next) {
        if (walk.place[next] == None)
        {
          walk.place[next] = count(walk.order);
          walk.parent.push_back(i);
          walk.order.push_back(next);
        }
      });
    }
  }
  return walk;
}

/// Which nodes and parts are on a loop. An edge that is not in the breadth-first tree closes a loop:
/// from its two ends up the tree to where the two ways meet. What has been marked once is climbed over
/// with union-find, so that the cost is about linear in the size of the graph.
std::vector<char> onLoop(const IndexLists& partsOfNode, const IndexLists& nodesOfPart)
{
  const Index nodes = partsOfNode.size();
  const auto neighbors = [&](Index vertex, const auto& body) {
    const bool isNode = vertex < nodes;
    for (const Index other : isNode ? partsOfNode[vertex] : nodesOfPart[vertex - nodes])
    {
      body(isNode ? nodes + other : other);
    }
  };
  const Index size = nodes + nodesOfPart.size();
  const Walk walk = breadthFirst(size, neighbors);
  std::vector<char> result(size, 0);
  DisjointSets climbed(size); // of places: a set is known by its uppermost
  for (Index node = 0; node < nodes; ++node)
  {
    neighbors(node, [&](Index part) {
      const Index a = walk.place[node], b = walk.place[part];
      if (walk.parent[a] == b || walk.parent[b] == a)
      {
        return;
      }
      Index low = climbed.find(a), high = climbed.find(b);
      while (low != high)
      {
        if (low < high)
        {
          std::swap(low, high);
        }
        result[walk.order[low]] = result[walk.order[walk.parent[low]]] = 1;
        climbed.unite(low, walk.parent[low]);
        low = climbed.find(low);
      }
    });
  }
  return result;
}
}

TopologyGraph topologyGraph(
  const std::vector<ContactCurve>& contacts, const std::vector<char>& gone)
{
  const auto lives = [&gone](Index part) { return !gone[part]; };
  std::vector<char> isThere;
  isThere.reserve(contacts.size());
  for (const ContactCurve& contact : contacts)
  {
    isThere.push_back(std::count_if(contact.parts.begin(), contact.parts.end(), lives) > 1);
  }
  TopologyGraph graph;
  const Index nodes = numberNodes(contacts, isThere, graph.nodeOfContact);
  std::vector<Pair> byNode, byPart;
  for (Index c = 0; c < count(contacts); ++c)
  {
    for (const Index part : contacts[c].parts)
    {
      if (isThere[c] && lives(part))
      {
        byNode.push_back({ graph.nodeOfContact[c], part });
        byPart.push_back({ part, graph.nodeOfContact[c] });
      }
    }
  }
  graph.partsOfNode = listed(std::move(byNode), nodes);
  graph.nodesOfPart = listed(std::move(byPart), count(gone));
  const std::vector<char> loops = onLoop(graph.partsOfNode, graph.nodesOfPart);
  graph.nodeOnLoop.assign(loops.begin(), loops.begin() + nodes);
  graph.partOnLoop.assign(loops.begin() + nodes, loops.end());
  return graph;
}

TopologyGraph topologyGraph(
  const std::vector<ContactCurve>& contacts, Index partCount, const std::vector<Point>& points)
{
  TopologyGraph graph = topologyGraph(contacts, std::vector<char>(partCount, 0));
  std::vector<Pair> pairs; // node, point
  for (Index c = 0; c < count(contacts); ++c)
  {
    for (const Index p : contacts[c].points)
    {
      if (graph.nodeOfContact[c] != None)
      {
        pairs.push_back({ graph.nodeOfContact[c], p });
      }
    }
  }
  const IndexLists pointsOfNode = listed(std::move(pairs), graph.partsOfNode.size());
  for (Index node = 0; node < pointsOfNode.size(); ++node)
  {
    Point sum = Point::Zero();
    for (const Index p : pointsOfNode[node])
    {
      sum += points[p];
    }
    graph.nodeCentroids.push_back(sum / pointsOfNode[node].size());
  }
  return graph;
}
}
