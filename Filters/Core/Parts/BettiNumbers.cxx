// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/BettiNumbers.h"

#include "Axis/ClosedChains.h"
#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <array>
#include <utility>
#include <vector>

namespace medial
{
namespace
{
/// The number of voids. The parts are the groups of triangles that a closed chain holds as a whole.
Index voids(const LivingCells& living, const Partition& partition)
{
  std::vector<char> excluded; // parts of lower cells, or with an edge of one triangle
  excluded.reserve(partition.level.size());
  for (Index part = 0; part < count(partition.level); ++part)
  {
    excluded.push_back(partition.dimension[part] < 2 || partition.level[part] == 1);
  }
  IndexLists partsAtEdges;
  for (Index e = 0; e < living.edges.triangles.size(); ++e)
  {
    if (!living.isContact(e))
    {
      continue;
    }
    for (const Index t : living.edges.triangles[e])
    {
      const Index part = partition.partOfCell[living.cells.firstTriangle() + t];
      if (part != None)
      {
        partsAtEdges.items.push_back(part);
      }
    }
    partsAtEdges.close();
  }
  return closedChains(partsAtEdges, std::move(excluded));
}

/// The number of connected pieces: groups of parts that share points.
Index pieces(const LivingCells& living, const Partition& partition)
{
  DisjointSets groups(count(partition.dimension));
  Index result = count(partition.dimension);
  forTouchingParts(living, partition, [&](Index a, Index b) { result -= groups.unite(a, b); });
  return result;
}
}

Betti bettiNumbers(
  const LivingCells& living, const Partition& partition, const Execution& execution)
{
  std::array<Index, 2> found{};
  execution.forEach(2, [&](Index task) {
    found[task] = task == 0 ? pieces(living, partition) : voids(living, partition);
  });
  const auto [b0, b2] = found;
  return { b0, b0 + b2 - living.eulerCharacteristic(), b2 };
}
}
