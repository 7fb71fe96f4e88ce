// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/PieceRepair.h"

#include "Axis/AxisBetti.h"
#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <algorithm>

// A piece of the axis belongs to the piece of the power shape in which its poles are. Pieces don't touch, so
// the Betti numbers of the whole are the sums of those of the pieces. Each step takes time linear in cells
// and balls but for the union-find.

namespace medial
{
namespace
{
/// The cells of an axis by the piece of the power shape that they are in.
struct PieceCells
{
  IndexLists cells;          ///< for each ball that is the lowest of a piece: the cells there
  std::vector<char> isMixed; ///< for each such ball: is it joined to another piece?
};

PieceCells pieceCells(const AxisComplex& axis, const std::vector<Index>& pieceOfBall)
{
  PieceCells result;
  result.isMixed.assign(pieceOfBall.size(), 0);
  DisjointSets groups(count(axis.points));
  std::vector<Index> firstPoint(axis.cells.size(), None);
  for (Index cell = 0; cell < axis.cells.size(); ++cell)
  {
    forPoints(axis.cells, cell, [&](Index p) {
      Index& first = firstPoint[cell];
      first = first == None ? p : first;
      groups.unite(first, p);
    });
  }
  std::vector<Index> pieceOfGroup(axis.points.size(), None);
  for (Index p = 0; p < count(axis.points); ++p)
  {
    const Index ball = axis.ballOfPoint[p];
    Index& piece = pieceOfGroup[groups.find(p)];
    if (ball != None && piece != None && piece != pieceOfBall[ball])
    {
      result.isMixed[piece] = result.isMixed[pieceOfBall[ball]] = 1;
    }
    piece = ball == None ? piece : pieceOfBall[ball];
  }
  result.cells = listsByKey(count(pieceOfBall), [&](const auto& add) {
    for (Index cell = 0; cell < axis.cells.size(); ++cell)
    {
      const Index piece = pieceOfGroup[groups.find(firstPoint[cell])];
      if (piece != None)
      {
        add(piece, cell);
      }
    }
  });
  return result;
}

/// Numbers for the points of some cells, in the order in which they are asked for.
class PointNumbers
{
public:
  /// @param nextNumber  of the next new point; counts up
  PointNumbers(Index pointCount, Index& nextNumber)
    : next(nextNumber)
    , numbers(pointCount, None)
  {
  }

  Index operator()(Index point)
  {
    Index& number = this->numbers[point];
    return number = number == None ? this->next++ : number;
  }

  /// The number of a point, or None.
  Index known(Index point) const { return this->numbers[point]; }
  void forget(Index point) { this->numbers[point] = None; }
  /// Counts from 0 again.
  void restart() { this->next = 0; }

private:
  Index& next;
  std::vector<Index> numbers;
};

void append(const AxisCells& from, Index cell, PointNumbers& number, AxisCells& to)
{
  if (cell < from.firstEdge())
  {
    to.vertices.push_back(number(from.vertices[cell]));
  }
  else if (cell < from.firstTriangle())
  {
    const Edge& edge = from.edges[cell - from.firstEdge()];
    const Index a = number(edge[0]), b = number(edge[1]);
    to.edges.push_back({ a, b });
  }
  else
  {
    const Triangle& triangle = from.triangles[cell - from.firstTriangle()];
    const Index a = number(triangle[0]), b = number(triangle[1]), c = number(triangle[2]);
    to.triangles.push_back({ a, b, c });
  }
}

/// The Betti numbers of each piece, by its lowest ball; zeros where there are no cells.
std::vector<Betti> bettiOfPieces(const AxisComplex& axis, const IndexLists& cells)
{
  std::vector<Betti> result(cells.size(), Betti{ 0, 0, 0 });
  Index next = 0;
  PointNumbers numbers(
    count(axis.points), next); // few for each piece, so that its arrays are short
  for (Index piece = 0; piece < cells.size(); ++piece)
  {
    AxisCells own;
    for (const Index cell : cells[piece])
    {
      append(axis.cells, cell, numbers, own);
    }
    result[piece] = bettiNumbers(own);
    for (const Index cell : cells[piece])
    {
      forPoints(axis.cells, cell, [&numbers](Index p) { numbers.forget(p); });
    }
    numbers.restart();
  }
  return result;
}

/// Cells of an axis, ascending.
struct Chosen
{
  const AxisComplex& axis;
  std::vector<Index> cells;
};

/// Appends those of the chosen cells that are numbered begin ... end - 1.
void append(const Chosen& chosen, Index begin, Index end, Index firstPolygon, PointNumbers& numbers,
  AxisComplex& to)
{
  const auto first = std::lower_bound(chosen.cells.begin(), chosen.cells.end(), begin);
  const auto last = std::lower_bound(first, chosen.cells.end(), end);
  std::for_each(first, last, [&](Index cell) {
    append(chosen.axis.cells, cell, numbers, to.cells);
    appendCellData(chosen.axis, cell, to);
    Index& polygon = to.polygonOfCell.back();
    polygon = polygon == None ? None : firstPolygon + polygon;
  });
}

void takePoints(const AxisComplex& from, const PointNumbers& numbers, AxisComplex& to)
{
  for (Index p = 0; p < count(from.points); ++p)
  {
    const Index number = numbers.known(p);
    if (number != None)
    {
      to.points[number] = from.points[p];
      to.radii[number] = from.radii[p];
      to.ballOfPoint[number] = from.ballOfPoint[p];
    }
  }
}

/// The chosen cells of two axes as one.
AxisComplex joined(const Chosen& a, const Chosen& b)
{
  AxisComplex result;
  Index pointCount = 0;
  PointNumbers ofA(count(a.axis.points), pointCount), ofB(count(b.axis.points), pointCount);
  const std::vector<Index>& polygons = a.axis.polygonOfCell;
  const Index polygonCount =
    polygons.empty() ? 0 : 1 + *std::max_element(polygons.begin(), polygons.end());
  const auto appendBoth = [&](const auto& begin, const auto& end) {
    append(a, begin(a.axis.cells), end(a.axis.cells), 0, ofA, result);
    append(b, begin(b.axis.cells), end(b.axis.cells), polygonCount, ofB, result);
  };
  const auto zero = [](const AxisCells&) { return Index(0); };
  const auto firstEdge = [](const AxisCells& cells) { return cells.firstEdge(); };
  const auto firstTriangle = [](const AxisCells& cells) { return cells.firstTriangle(); };
  const auto size = [](const AxisCells& cells) { return cells.size(); };
  appendBoth(zero, firstEdge);
  appendBoth(firstEdge, firstTriangle);
  appendBoth(firstTriangle, size);
  result.points.resize(pointCount);
  result.radii.resize(pointCount);
  result.ballOfPoint.resize(pointCount);
  takePoints(a.axis, ofA, result);
  takePoints(b.axis, ofB, result);
  return result;
}
}

std::vector<Index> piecesOfBalls(const PolarBalls& polarBalls)
{
  const std::vector<Side>& sides = polarBalls.sides;
  DisjointSets pieces(count(sides));
  const auto isInner = [&sides](Index ball) { return sides[ball] == Side::Inner; };
  for (const Tetrahedron& cell : polarBalls.triangulation.cells)
  {
    for (const auto& edge : cellEdges)
    {
      const Index a = cell[edge[0]], b = cell[edge[1]];
      if (isInner(a) && isInner(b))
      {
        pieces.unite(a, b);
      }
    }
  }
  std::vector<Index> result(sides.size(), None);
  for (Index ball = 0; ball < count(sides); ++ball)
  {
    result[ball] = isInner(ball) ? pieces.find(ball) : None;
  }
  return result;
}

AxisComplex repairedPieces(
  const AxisComplex& axis, const AxisComplex& exact, const std::vector<Index>& pieceOfBall)
{
  const PieceCells own = pieceCells(axis, pieceOfBall), right = pieceCells(exact, pieceOfBall);
  const std::vector<Betti> ownBetti = bettiOfPieces(axis, own.cells);
  const std::vector<Betti> rightBetti = bettiOfPieces(exact, right.cells);
  Chosen fromAxis{ axis, {} }, fromExact{ exact, {} };
  for (Index piece = 0; piece < count(pieceOfBall); ++piece)
  {
    const bool isRight = !own.isMixed[piece] && ownBetti[piece] == rightBetti[piece];
    const IndexLists::View cells = isRight ? own.cells[piece] : right.cells[piece];
    std::vector<Index>& to = isRight ? fromAxis.cells : fromExact.cells;
    to.insert(to.end(), cells.begin(), cells.end());
  }
  std::sort(fromAxis.cells.begin(), fromAxis.cells.end());
  std::sort(fromExact.cells.begin(), fromExact.cells.end());
  return joined(fromAxis, fromExact);
}
}
