// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/TetrahedraChecks.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Base/Frame.h"
#include "Base/Tetrahedra.h"
#include "Conversion/Remedies.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace medial
{
namespace
{
double determinant(const std::array<Point, 4>& corners)
{
  const Point u = corners[1] - corners[0], v = corners[2] - corners[0], w = corners[3] - corners[0];
  return u.cross(v).dot(w);
}

/// So far the determinant may change if each corner is moved by `error` at most.
double change(const std::array<Point, 4>& corners, double error)
{
  const double u = (corners[1] - corners[0]).norm(), v = (corners[2] - corners[0]).norm(),
               w = (corners[3] - corners[0]).norm();
  return (u + 2 * error) * (v + 2 * error) * (w + 2 * error) - u * v * w;
}

/// Cells may be flat: where the axis is a plane, those inside have no volume.
void checkOrientation(const PolarBalls& balls, double moved, double movedFar)
{
  const Eigen::AlignedBox3d box = boundingBox(balls.samples);
  for (Index c = 0; c < count(balls.triangulation.cells); ++c)
  {
    std::array<Point, 4> corners;
    for (int i = 0; i < 4; ++i)
    {
      corners[i] = balls.balls[balls.triangulation.cells[c][i]].center;
    }
    const double volume = determinant(corners);
    if (volume >= 0) // most are, and this is quick
    {
      continue;
    }
    double farthest = 0;
    for (const Point& corner : corners)
    {
      farthest = std::max(farthest, box.exteriorDistance(corner));
    }
    if (!(volume >= -change(corners, moved + movedFar * farthest)))
    {
      throw InvalidInput("the corners of tetrahedron ", c,
        " are in the wrong order for the places of the balls: ", TakePolarBalls);
    }
  }
}

using Corner = std::pair<Edge, Index>; // an edge of a triangle of the hull, the triangle

/// Each edge is there once in each direction, and all triangles hang together.
void checkClosed(const std::vector<Triangle>& hull)
{
  std::vector<Corner> edges;
  for (Index t = 0; t < count(hull); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.push_back({ { hull[t][k], hull[t][(k + 1) % 3] }, t });
    }
  }
  std::sort(edges.begin(), edges.end());
  DisjointSets pieces(count(hull));
  bool isClosed = !hull.empty();
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const Edge& edge = edges[i].first;
    const auto back =
      std::lower_bound(edges.begin(), edges.end(), Corner{ { edge[1], edge[0] }, 0 });
    const bool isThere = back != edges.end() && back->first == Edge{ edge[1], edge[0] };
    isClosed = isClosed && isThere && (i == 0 || edges[i - 1].first != edge);
    if (isThere)
    {
      pieces.unite(edges[i].second, back->second);
    }
  }
  for (Index t = 0; t < count(hull); ++t)
  {
    isClosed = isClosed && pieces.find(t) == pieces.find(0);
  }
  if (!isClosed)
  {
    throw InvalidInput("the tetrahedra of the balls have holes between them: ", TakePolarBalls);
  }
}

/// Finds neighbours, and the hull from them.
std::vector<Triangle> hullWithNeighbors(PolarBalls& balls)
{
  balls.triangulation = orientedWithNeighbors(std::move(balls.triangulation.cells));
  const Tetrahedra& mesh = balls.triangulation;
  std::vector<Triangle> hull;
  for (Index c = 0; c < count(mesh.cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (mesh.neighbors[c][i] != None)
      {
        continue;
      }
      hull.push_back(facet(mesh.cells[c], i));
      for (const Index ball : hull.back())
      {
        if (balls.sides[ball] == Side::Inner)
        {
          throw InvalidInput("ball ", ball, " is inside the solid, but beside tetrahedron ", c,
            " another one is missing: ", TakePolarBalls);
        }
      }
    }
  }
  return hull;
}

bool hasInnerBall(const std::vector<Triangle>& hull, const PolarBalls& balls)
{
  return std::any_of(hull.begin(), hull.end(), [&](const Triangle& triangle) {
    return std::any_of(triangle.begin(), triangle.end(),
      [&](Index ball) { return balls.sides[ball] == Side::Inner; });
  });
}
}

void checkTetrahedra(PolarBalls& balls, double moved, double movedFar, CellNeighbors neighbors)
{
  checkOrientation(balls, moved, movedFar);
  std::optional<std::vector<Triangle>> hull;
  if (neighbors == CellNeighbors::LeftOut)
  {
    hull = hullOf(balls.triangulation.cells);
  }
  if (!hull || hasInnerBall(*hull, balls)) // what is wrong is told by the neighbours
  {
    hull = hullWithNeighbors(balls);
  }
  checkClosed(*hull);
}
}
