// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/TinyPieces.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"

#include <vector>

namespace medial
{
namespace
{
/// Connected groups of balls of one side: pieces of the solid, voids, and the space around.
DisjointSets groups(const SampleEvidence& evidence)
{
  DisjointSets result(count(evidence.balls));
  for (const auto& [a, b] : evidence.edges)
  {
    if (evidence.sides[a] == evidence.sides[b])
    {
      result.unite(a, b);
    }
  }
  return result;
}

/// Marks, for each group by its representative, what is part of the space around.
std::vector<char> spaceAround(const SampleEvidence& evidence, DisjointSets& groups)
{
  std::vector<char> result(evidence.balls.size(), 0);
  for (Index c = 0; c < count(evidence.mesh.cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (evidence.mesh.neighbors[c][i] == None)
      {
        for (const Index b : facet(evidence.mesh.cells[c], i))
        {
          result[groups.find(b)] = 1;
        }
      }
    }
  }
  return result;
}
}

Warnings tinyPieces(const SampleEvidence& evidence)
{
  // An icosahedron's corners are the fewest samples of a ball that anybody would call so.
  constexpr Index dozen = 12;
  DisjointSets sets = groups(evidence);
  const std::vector<char> around = spaceAround(evidence, sets);
  std::vector<Index> samples(evidence.balls.size(), 0);
  for (const auto& poles : evidence.ballsOfSample)
  {
    for (const Index ball : poles)
    {
      if (ball != None)
      {
        ++samples[sets.find(ball)];
      }
    }
  }
  Warning warning;
  for (Index b = 0; b < count(evidence.balls); ++b)
  {
    if (evidence.sides[b] != Side::Hidden && sets.find(b) == b && !around[b] && samples[b] < dozen)
    {
      ++warning.count;
      warning.place =
        warning.place ? warning.place : evidence.frame.toWorld(evidence.balls[b].center);
    }
  }
  if (warning.count == 0)
  {
    return {};
  }
  warning.code = "tiny_pieces";
  warning.text = text(warning.count,
    warning.count == 1 ? " piece or void has" : " pieces or voids have", " less than ", dozen,
    " samples. Remove stray samples; sample small pieces and voids more densely.");
  warning.doubtsSolid = true;
  return { warning };
}
}
