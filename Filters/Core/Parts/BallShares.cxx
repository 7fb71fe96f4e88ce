// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/BallShares.h"

#include "Parts/Partition.h"

#include <algorithm>

namespace medial
{
namespace
{
/// For each ball: is it or its owner at a point that is used?
std::vector<char> ballsAtPoints(const MedialAxis& axis, const std::vector<char>& isUsed)
{
  std::vector<char> isThere(axis.ballOwner.size(), 0), result(isThere);
  for (std::size_t p = 0; p < isUsed.size(); ++p)
  {
    if (isUsed[p] && axis.ballOfPoint[p] != None)
    {
      isThere[axis.ballOfPoint[p]] = 1;
    }
  }
  for (std::size_t b = 0; b < result.size(); ++b)
  {
    result[b] = axis.ballOwner[b] != None && isThere[axis.ballOwner[b]];
  }
  return result;
}

/// The points of each polar ball that cells of the axis may use.
IndexLists pointsOfBalls(const MedialAxis& axis, Index pointCount)
{
  return listsByKey(count(axis.ballOwner), [&](const auto& add) {
    for (Index p = 0; p < pointCount; ++p)
    {
      if (axis.ballOfPoint[p] != None)
      {
        add(axis.ballOfPoint[p], p);
      }
    }
  });
}

/// Appends parts, ascending, each once, with shares in proportion to their sizes. Where none has a size, all
/// are alike.
void appendShares(
  const std::vector<Index>& parts, const std::vector<double>& sizeOfPart, Lists<BallShare>& result)
{
  double total = 0;
  for (const Index part : parts)
  {
    total += sizeOfPart[part];
  }
  for (const Index part : parts)
  {
    const double share =
      total > 0 ? sizeOfPart[part] / total : 1 / static_cast<double>(parts.size());
    result.items.push_back({ part, share });
  }
  result.close();
}
}

Lists<BallShare> ballShares(const MedialAxis& axis, const std::vector<Index>& partOfCell,
  const std::vector<double>& sizeOfPart, const IndexLists& cellsOfPoint)
{
  const IndexLists pointsOfBall = pointsOfBalls(axis, cellsOfPoint.size());
  Lists<BallShare> result;
  std::vector<Index> parts, all;
  for (Index ball = 0; ball < pointsOfBall.size(); ++ball)
  {
    all.clear();
    for (const Index p : pointsOfBall[ball])
    {
      distinctPartsOf(cellsOfPoint[p], partOfCell, parts);
      all.insert(all.end(), parts.begin(), parts.end());
    }
    if (pointsOfBall[ball].size() > 1)
    {
      sortUnique(all);
    }
    appendShares(all, sizeOfPart, result);
  }
  return result;
}

std::vector<Index> partOfBall(const MedialAxis& axis, const std::vector<Index>& partOfCell)
{
  const IndexLists cellsOfPoint = cellsOfPoints(axis.cells);
  std::vector<Index> part(axis.ballOwner.size(), None), most(axis.ballOwner.size(), 0);
  std::vector<Index> parts;
  for (Index p = 0; p < cellsOfPoint.size(); ++p)
  {
    const Index ball = axis.ballOfPoint[p];
    if (ball == None)
    {
      continue;
    }
    partsOf(cellsOfPoint[p], partOfCell, parts);
    for (auto i = parts.begin(); i != parts.end();)
    {
      const auto end = std::upper_bound(i, parts.end(), *i);
      if (end - i > most[ball])
      {
        most[ball] = static_cast<Index>(end - i);
        part[ball] = *i;
      }
      i = end;
    }
  }
  std::vector<Index> result(axis.ballOwner.size(), None);
  for (Index b = 0; b < count(result); ++b)
  {
    result[b] = axis.ballOwner[b] == None ? None : part[axis.ballOwner[b]];
  }
  return result;
}

std::vector<char> keptBalls(const MedialAxis& axis)
{
  std::vector<char> isUsed(axis.points.size(), 0);
  for (Index c = 0; c < axis.cells.size(); ++c)
  {
    forPoints(axis.cells, c, [&isUsed](Index p) { isUsed[p] = 1; });
  }
  return ballsAtPoints(axis, isUsed);
}

std::vector<char> keptBalls(const MedialAxis& axis, const LivingCells& living)
{
  std::vector<char> isUsed(axis.points.size(), 0);
  for (Index p = 0; p < living.cellsOfPoint().size(); ++p)
  {
    isUsed[p] = living.cellsAtPoint(p) > 0;
  }
  return ballsAtPoints(axis, isUsed);
}
}
