// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Base/Errors.h"
#include "Base/Tetrahedra.h"
#include "Base/Triangulations.h"

#include <algorithm>
#include <map>
#include <set>

using medial::Edge;
using medial::Index;
using medial::None;
using medial::Tetrahedron;
using medial::Triangle;

namespace
{
bool hasCorner(const Tetrahedron& cell, Index corner)
{
  return std::find(cell.begin(), cell.end(), corner) != cell.end();
}

/// For each edge of a triangulation its cells.
std::map<Edge, std::set<Index>> cellsOfEdges(const std::vector<Tetrahedron>& cells)
{
  std::map<Edge, std::set<Index>> result;
  for (Index c = 0; c < medial::count(cells); ++c)
  {
    for (const auto& ends : medial::cellEdges)
    {
      const Index a = cells[c][ends[0]], b = cells[c][ends[1]];
      result[{ std::min(a, b), std::max(a, b) }].insert(c);
    }
  }
  return result;
}

/// Has the edge a facet on the hull?
bool isOnHull(const medial::Tetrahedra& mesh, const Edge& edge, const std::set<Index>& cells)
{
  return std::any_of(cells.begin(), cells.end(), [&](Index c) {
    for (int i = 0; i < 4; ++i)
    {
      const Index corner = mesh.cells[c][i];
      if (mesh.neighbors[c][i] == None && corner != edge[0] && corner != edge[1])
      {
        return true;
      }
    }
    return false;
  });
}

/// Those of a walk; none where it comes to the hull.
std::vector<Index> cellsAround(
  const medial::Tetrahedra& mesh, const medial::Edge& edge, Index start, int leave)
{
  std::vector<Index> ring;
  const bool isAround = medial::forCellsAround(
    mesh, edge, start, leave, [&ring](Index cell, int) { ring.push_back(cell); });
  return isAround ? ring : std::vector<Index>();
}

/// Triangles with the lowest corner first, in order.
std::vector<Triangle> inOrder(std::vector<Triangle> triangles)
{
  for (Triangle& triangle : triangles)
  {
    std::rotate(
      triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}
}

TEST(Tetrahedra, CellsAroundAnEdgeAreAllInOrder)
{
  const medial::Tetrahedra mesh = medial::delaunay(shapes::cloud(60, 3));
  int inside = 0, onHull = 0;
  for (const auto& [edge, cells] : cellsOfEdges(mesh.cells))
  {
    const Index start = *cells.begin();
    std::vector<std::vector<Index>> walks;
    for (int leave = 0; leave < 4; ++leave)
    {
      if (mesh.cells[start][leave] != edge[0] && mesh.cells[start][leave] != edge[1])
      {
        walks.push_back(cellsAround(mesh, edge, start, leave));
        if (!walks.back().empty())
        {
          EXPECT_EQ(walks.back()[0], start);
          EXPECT_EQ(walks.back()[1], mesh.neighbors[start][leave]);
          EXPECT_FALSE(hasCorner(mesh.cells[walks.back()[1]], mesh.cells[start][leave]));
        }
      }
    }
    ASSERT_EQ(walks.size(), 2u);
    if (isOnHull(mesh, edge, cells))
    {
      EXPECT_TRUE(walks[0].empty() && walks[1].empty());
      ++onHull;
      continue;
    }
    ++inside;
    EXPECT_EQ(std::set<Index>(walks[0].begin(), walks[0].end()), cells);
    EXPECT_EQ(walks[0].size(), cells.size());
    std::reverse(walks[1].begin() + 1, walks[1].end());
    EXPECT_EQ(walks[0], walks[1]);
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(onHull, 20);
}

TEST(Tetrahedra, HullIsWhatHasNoNeighbor)
{
  medial::Tetrahedra mesh = medial::delaunay(shapes::cloud(60, 3));
  mesh.cells.erase(mesh.cells.begin() + 5); // a cavity is hull, too
  mesh = medial::orientedWithNeighbors(mesh.cells);
  std::vector<Triangle> expected;
  for (Index c = 0; c < medial::count(mesh.cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (mesh.neighbors[c][i] == None)
      {
        expected.push_back(medial::facet(mesh.cells[c], i));
      }
    }
  }
  const auto hull = medial::hullOf(mesh.cells);
  ASSERT_TRUE(hull);
  EXPECT_GT(expected.size(), 20u);
  EXPECT_EQ(inOrder(*hull), inOrder(expected));
  EXPECT_TRUE(medial::hullOf({})->empty());
}

TEST(Tetrahedra, WithoutNeighborsHaveNoHullEither)
{
  const std::vector<Tetrahedron> cells = medial::delaunay(shapes::cloud(60, 3)).cells;
  for (const Tetrahedron& cell : cells)
  {
    std::vector<Tetrahedron> twice = cells;
    twice.push_back(cell);
    EXPECT_FALSE(medial::hullOf(twice));
    EXPECT_THROW(medial::orientedWithNeighbors(twice), medial::InvalidInput);
    // Two that are turned: each triangle is there as often on one side as on the other.
    const Tetrahedron turned{ cell[1], cell[0], cell[2], cell[3] };
    twice.push_back(turned);
    twice.push_back(turned);
    EXPECT_FALSE(medial::hullOf(twice));
    std::vector<Tetrahedron> oneTurned = cells;
    std::replace(oneTurned.begin(), oneTurned.end(), cell, turned);
    EXPECT_FALSE(medial::hullOf(oneTurned));
    EXPECT_THROW(medial::orientedWithNeighbors(oneTurned), medial::InvalidInput);
  }
}
