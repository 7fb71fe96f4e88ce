// SPDX-License-Identifier: BSD-3-Clause
#ifndef PruningTest_h
#define PruningTest_h

#include "Pipelines.h"

#include "Pruning/Pruning.h"

#include <set>
#include <utility>
#include <vector>

/// What the tests of the pruning share.
namespace pruningTest
{
using medial::Betti;
using medial::Edge;
using medial::Index;
using medial::Measure;
using medial::MedialAxis;
using medial::None;
using medial::Pruned;
using medial::PruneOptions;
using medial::PruneRow;
using medial::Triangle;

inline PruneOptions once(Measure measure, double threshold, int passes = 0)
{
  PruneOptions options;
  options.schedule.push_back({ measure, threshold, passes });
  return options;
}

inline PruneOptions byHand(std::vector<Index> cells)
{
  PruneOptions options;
  options.cellsToRemove = std::move(cells);
  return options;
}

/// The corners of all cells of an axis in their order.
inline std::vector<std::vector<Index>> corners(const MedialAxis& axis)
{
  std::vector<std::vector<Index>> result;
  for (const Index vertex : axis.cells.vertices)
  {
    result.push_back({ vertex });
  }
  for (const Edge& edge : axis.cells.edges)
  {
    result.emplace_back(edge.begin(), edge.end());
  }
  for (const Triangle& triangle : axis.cells.triangles)
  {
    result.emplace_back(triangle.begin(), triangle.end());
  }
  return result;
}

/// What is left, what went and what is said about it fit together.
inline void expectConsistent(const MedialAxis& input, const Pruned& pruned)
{
  const Index rows = medial::count(pruned.history);
  const auto before = corners(input), after = corners(pruned.axis);
  ASSERT_EQ(pruned.inputCell.size(), after.size());
  ASSERT_EQ(pruned.removedInIteration.size(), before.size());
  ASSERT_EQ(pruned.removedPart.size(), before.size());
  ASSERT_EQ(pruned.keepReason.size(), pruned.parts.parts.size());
  std::set<Index> living;
  for (std::size_t cell = 0; cell < after.size(); ++cell)
  {
    const Index from = pruned.inputCell[cell];
    ASSERT_TRUE(living.insert(from).second);
    ASSERT_EQ(after[cell], before.at(static_cast<std::size_t>(from)));
    ASSERT_EQ(pruned.axis.samplesOfCell[cell], input.samplesOfCell[from]);
    ASSERT_EQ(pruned.axis.polygonOfCell[cell], input.polygonOfCell[from]);
  }
  for (Index cell = 0; cell < medial::count(before); ++cell)
  {
    const Index row = pruned.removedInIteration[cell];
    ASSERT_EQ(row == None, living.count(cell) == 1) << "cell " << cell;
    ASSERT_EQ(row == None, pruned.removedPart[cell] == None) << "cell " << cell;
    ASSERT_TRUE(row >= None && row < rows);
  }
  EXPECT_EQ(pruned.axis.points, input.points);
  EXPECT_EQ(pruned.axis.radii, input.radii);
  EXPECT_EQ(pruned.axis.ballOfPoint, input.ballOfPoint);
}

inline void expectBetti(const Pruned& pruned, const Betti& betti)
{
  EXPECT_EQ(pruned.axis.betti, betti);
  EXPECT_EQ(pipelines::independentBetti(pruned.axis), betti);
  for (const PruneRow& row : pruned.history)
  {
    EXPECT_EQ(row.betti, betti);
  }
}

inline std::set<Index> removedTriangles(const MedialAxis& axis, const Pruned& pruned)
{
  std::set<Index> removed;
  for (Index cell = axis.cells.firstTriangle(); cell < axis.cells.size(); ++cell)
  {
    if (pruned.removedInIteration[cell] != None)
    {
      removed.insert(cell);
    }
  }
  return removed;
}

inline Index firstTriangleOf(const MedialAxis& axis, const medial::MedialParts& parts, Index part)
{
  Index cell = axis.cells.firstTriangle();
  while (parts.partOfCell.at(static_cast<std::size_t>(cell)) != part)
  {
    ++cell;
  }
  return cell;
}
}

#endif
