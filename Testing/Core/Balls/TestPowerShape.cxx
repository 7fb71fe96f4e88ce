// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Balls/MarkedBetti.h"
#include "Balls/PowerShape.h"
#include "Base/Tetrahedra.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

using medial::Index;
using medial::None;
using medial::Side;
using medial::Tetrahedron;
using medial::Triangle;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
/// All simplices of a triangulation with marked corners only.
validators::Complex markedSimplices(
  const std::vector<Tetrahedron>& cells, const std::vector<char>& marked)
{
  validators::Complex complex;
  for (const Tetrahedron& cell : cells)
  {
    std::vector<Index> inner;
    std::copy_if(cell.begin(), cell.end(), std::back_inserter(inner),
      [&](Index corner) { return marked[corner] != 0; });
    switch (inner.size())
    {
      case 1:
        complex.vertices.push_back(inner[0]);
        break;
      case 2:
        complex.edges.push_back({ inner[0], inner[1] });
        break;
      case 3:
        complex.triangles.push_back({ inner[0], inner[1], inner[2] });
        break;
      case 4:
        complex.tetrahedra.push_back(cell);
        break;
      default:
        break;
    }
  }
  return complex;
}

validators::Complex innerSimplices(const medial::PolarBalls& balls)
{
  std::vector<char> inner;
  for (const Side side : balls.sides)
  {
    inner.push_back(side == Side::Inner ? 1 : 0);
  }
  return markedSimplices(balls.triangulation.cells, inner);
}

Triangle sorted(Triangle triangle)
{
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

/// Two tetrahedra that share a triangle, positively oriented with their corners placed as in a
/// right-handed frame.
const std::vector<Tetrahedron> twoCells{ { 0, 1, 2, 3 }, { 1, 2, 3, 4 } };
}

TEST(PowerShape, HasTheTopologyOfTheSolid)
{
  forEachShape([](Pipeline& p) { EXPECT_EQ(p.powerShape().betti, p.shape.betti); });
}

TEST(PowerShape, HasTheBettiNumbersThatTheRanksGive)
{
  forEachShape([](Pipeline& p) {
    EXPECT_EQ(p.powerShape().betti, validators::bettiNumbers(innerSimplices(p.balls())));
  });
}

TEST(PowerShape, HasTheBettiNumbersThatTheRanksGiveOnRandomPoints)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const medial::PolarBalls balls = medial::polarBalls(shapes::cloud(60 + 10 * seed, seed));
    EXPECT_EQ(medial::powerShape(balls).betti, validators::bettiNumbers(innerSimplices(balls)));
  }
}

TEST(PowerShape, BettiNumbersOfMarkedCornersAreThoseOfTheRanks)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const medial::PolarBalls balls = medial::polarBalls(shapes::cloud(80, seed));
    const medial::Tetrahedra& mesh = balls.triangulation;
    std::mt19937 random(seed);
    std::vector<char> marked;
    for (std::size_t b = 0; b < balls.balls.size(); ++b)
    {
      // Hidden balls are no corners, and a marked guard-side ball would touch the hull.
      const bool may = balls.sides[b] != Side::Hidden && !balls.touchesGuard[b];
      marked.push_back(may && random() % 3 != 0 ? 1 : 0);
    }
    EXPECT_EQ(medial::markedBetti(mesh, marked),
      validators::bettiNumbers(markedSimplices(balls.triangulation.cells, marked)));
  }
}

TEST(PowerShape, ContainsTheCellsOfInnerBalls)
{
  forEachShape([](Pipeline& p) {
    const medial::PowerShape& shape = p.powerShape();
    ASSERT_EQ(shape.contains.size(), p.balls().triangulation.cells.size());
    for (Index c = 0; c < medial::count(shape.contains); ++c)
    {
      const Tetrahedron& cell = p.balls().triangulation.cells[c];
      const bool inner = std::all_of(
        cell.begin(), cell.end(), [&](Index b) { return p.balls().sides[b] == Side::Inner; });
      ASSERT_EQ(shape.contains[c] != 0, inner) << "cell " << c;
    }
  });
}

TEST(PowerShape, TrianglesAreThoseNotBetweenTwoOfItsCells)
{
  forEachShape([](Pipeline& p) {
    const medial::PowerShape& shape = p.powerShape();
    std::map<Triangle, std::multiset<Index>> cellsOf;
    for (Index c = 0; c < medial::count(p.balls().triangulation.cells); ++c)
    {
      for (int i = 0; i < 4; ++i)
      {
        cellsOf[sorted(medial::facet(p.balls().triangulation.cells[c], i))].insert(c);
      }
    }
    std::set<Triangle> expected;
    for (const auto& [triangle, cells] : cellsOf)
    {
      const bool inner = std::all_of(triangle.begin(), triangle.end(),
        [&](Index b) { return p.balls().sides[b] == Side::Inner; });
      const bool between = cells.size() == 2 &&
        std::all_of(cells.begin(), cells.end(), [&](Index c) { return shape.contains[c] != 0; });
      if (inner && !between)
      {
        expected.insert(triangle);
      }
    }
    std::set<Triangle> found;
    for (const medial::ShapeTriangle& triangle : shape.triangles)
    {
      std::multiset<Index> cells(triangle.cells.begin(), triangle.cells.end());
      cells.erase(None);
      EXPECT_EQ(cells, cellsOf[triangle.balls]);
      EXPECT_TRUE(found.insert(triangle.balls).second) << "twice";
    }
    EXPECT_EQ(found, expected);
  });
}

TEST(PowerShape, OfASphereIsAPoint)
{
  EXPECT_TRUE(pipelines::of("sphere").powerShape().triangles.empty());
  EXPECT_EQ(pipelines::of("sphere").powerShape().betti, (medial::Betti{ 1, 0, 0 }));
}

TEST(PowerShape, IsTheSameOnManyThreads)
{
  Pipeline& p = pipelines::of("knot");
  const medial::PowerShape shape = medial::powerShape(p.balls(), pipelines::threaded());
  EXPECT_EQ(shape.contains, p.powerShape().contains);
  ASSERT_EQ(shape.triangles.size(), p.powerShape().triangles.size());
  for (std::size_t i = 0; i < shape.triangles.size(); ++i)
  {
    EXPECT_EQ(shape.triangles[i].balls, p.powerShape().triangles[i].balls);
    EXPECT_EQ(shape.triangles[i].cells, p.powerShape().triangles[i].cells);
  }
}

TEST(Tetrahedra, AreRefusedIfATriangleHasThree)
{
  std::vector<medial::Tetrahedron> cells = pipelines::of("capsule").balls().triangulation.cells;
  cells.insert(cells.end(), 2, cells[0]);
  EXPECT_THROW(medial::withNeighbors(cells), medial::InvalidInput);
}

TEST(Tetrahedra, FindTheNeighborsThatATriangulationKnows)
{
  const medial::Tetrahedra& known = pipelines::of("capsule").balls().triangulation;
  EXPECT_EQ(medial::withNeighbors(known.cells).neighbors, known.neighbors);
}

TEST(Tetrahedra, FacetsLookAtTheOppositeCorner)
{
  const std::array<medial::Point, 4> at{ medial::Point(0, 0, 0), medial::Point(1, 0, 0),
    medial::Point(0, 1, 0), medial::Point(0, 0, 1) };
  ASSERT_GT(validators::orientation(at[0], at[1], at[2], at[3]), 0);
  for (int i = 0; i < 4; ++i)
  {
    const Triangle f = medial::facet({ 0, 1, 2, 3 }, i);
    EXPECT_EQ(std::count(f.begin(), f.end(), i), 0);
    // Counter-clockwise seen from corner i: the corner is on the side the normal points to.
    EXPECT_GT(validators::orientation(at[f[0]], at[f[1]], at[f[2]], at[i]), 0);
  }
}

TEST(Tetrahedra, NeighborsAreOppositeToTheCorner)
{
  const medial::Tetrahedra both = medial::withNeighbors(twoCells);
  EXPECT_EQ(both.cells, twoCells);
  EXPECT_EQ(both.neighbors[0], (Tetrahedron{ 1, None, None, None }));
  EXPECT_EQ(both.neighbors[1], (Tetrahedron{ None, None, None, 0 }));
}

TEST(Tetrahedra, RefuseAThirdCellAtATriangle)
{
  std::vector<Tetrahedron> cells = twoCells;
  cells.push_back({ 3, 2, 1, 5 });
  EXPECT_THROW(medial::withNeighbors(cells), medial::InvalidInput);
}

TEST(Tetrahedra, RefuseTwoCellsOnOneSideOfATriangle)
{
  EXPECT_EQ(
    medial::orientedWithNeighbors(twoCells).neighbors, medial::withNeighbors(twoCells).neighbors);
  for (const std::size_t turned : { 0, 1 })
  {
    std::vector<Tetrahedron> cells = twoCells;
    std::swap(cells[turned][1], cells[turned][2]);
    EXPECT_NO_THROW(medial::withNeighbors(cells));
    EXPECT_THROW(medial::orientedWithNeighbors(cells), medial::InvalidInput);
  }
}

TEST(Tetrahedra, FindNeighborsWithoutOrientation)
{
  std::vector<Tetrahedron> cells = pipelines::of("capsule").balls().triangulation.cells;
  medial::sortCells(cells);
  const medial::Tetrahedra mesh = medial::withNeighbors(cells);
  for (Index c = 0; c < medial::count(cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      const Index n = mesh.neighbors[c][i];
      if (n != None)
      {
        Index shared = 0;
        for (const Index corner : cells[c])
        {
          shared += std::count(cells[n].begin(), cells[n].end(), corner);
        }
        ASSERT_EQ(shared, 3);
        ASSERT_EQ(std::count(cells[n].begin(), cells[n].end(), cells[c][i]), 0);
      }
    }
  }
}

TEST(Tetrahedra, TakeLinearTimeWhereVeryManyShareAnEdge)
{
  constexpr Index leaves = 300000; // a loop over all pairs of them would take minutes
  std::vector<Tetrahedron> cells;
  for (Index i = 0; i < leaves; ++i)
  {
    cells.push_back({ 0, 1, 2 + i, 2 + (i + 1) % leaves });
  }
  const medial::Tetrahedra mesh = medial::orientedWithNeighbors(cells);
  EXPECT_EQ(mesh.neighbors[5], (Tetrahedron{ None, None, 6, 4 }));
}

TEST(Tetrahedra, EdgesAreNumberedOnce)
{
  const medial::EdgeNumbers numbers = medial::edgeNumbers(twoCells, 5);
  EXPECT_EQ(numbers.edges.size(), 9u);
  for (std::size_t c = 0; c < twoCells.size(); ++c)
  {
    for (int k = 0; k < 6; ++k)
    {
      medial::Edge edge{ twoCells[c][medial::cellEdges[k][0]],
        twoCells[c][medial::cellEdges[k][1]] };
      std::sort(edge.begin(), edge.end());
      EXPECT_EQ(numbers.edges.at(static_cast<std::size_t>(numbers.ofCell[c][k])), edge);
    }
  }
}
