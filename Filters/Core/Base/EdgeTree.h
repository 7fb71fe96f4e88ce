// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_EdgeTree_h
#define medial_EdgeTree_h

#include "Base/Types.h"

#include <memory>
#include <vector>

namespace medial
{
/// Tells how far places are from edges. Built in O(n log n); a search takes about O(log n). Threads may
/// search at the same time.
class EdgeTree
{
public:
  /// @param edges  each between two of the points
  EdgeTree(const std::vector<Point>& points, const std::vector<Edge>& edges);
  ~EdgeTree();

  /// Distance to the nearest edge; infinity if there are no edges.
  double distance(const Point& place) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};
}

#endif
